"""Color spaces of three primaries and a curve for each, and the way from them to sRGB.

8- and 16-bit pixels become sRGB numbers (IEC 61966-2-1), floats linear light of the same primaries. The way
is the relative colorimetric one: white goes to white, and colors that sRGB does not hold end at its hull, in
integers; floats may be negative there.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.pixels import white

Values = NDArray[np.float64]
Curve = Callable[[Values], Values]
"""From numbers, 0 to 1, to linear light."""

SRGB_PRIMARIES = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
"""x and y of red, green, blue and white (Rec. ITU-R BT.709)."""
_P3 = (0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290)
_BT2020 = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)
_ADOBE = (0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290)
_D50 = np.array([0.9642, 1.0, 0.8249])
"""White of profiles (ICC.1:2022, section 7.2.16)."""
_BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])
_CLOSE = 0.004
"""How far the primaries of files that mean sRGB lie from it."""
_BAND = 1 << 20
"""Pixels converted at a time."""


def srgb_curve(encoded: Values) -> Values:
    """Linear light of sRGB numbers (IEC 61966-2-1), of negative ones mirrored."""
    size = np.abs(encoded)
    return np.sign(encoded) * np.where(size <= 0.04045, size / 12.92, ((size + 0.055) / 1.055) ** 2.4)


def _encode(linear: Values) -> Values:
    return np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055
    )


def gamma_curve(exponent: float) -> Curve:
    """Numbers to a power, of negative ones mirrored."""
    return lambda encoded: np.sign(encoded) * np.abs(encoded) ** exponent


@dataclass(frozen=True, eq=False)
class RgbSpace:
    """What the numbers of red, green and blue mean.

    Attributes
    ----------
    name : str
        What people call it.
    curves : tuple of callable
        From numbers to linear light, of each channel.
    matrix : array, shape (3, 3)
        From linear light of these primaries to that of sRGB's.
    """

    name: str
    curves: tuple[Curve, Curve, Curve]
    matrix: Values

    @property
    def is_srgb(self) -> bool:
        """Whether numbers of 8 bit mean what those of sRGB mean, within 2."""
        lattice = np.stack(np.meshgrid(*[np.linspace(0, 1, 9)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
        grays = np.repeat(np.linspace(0, 1, 256)[:, np.newaxis], 3, axis=1)
        probes = np.concatenate([lattice, grays])
        meant = np.clip(_encode(self.linear(probes)), 0, 1)
        return bool(np.abs(meant - probes).max() * 255 <= 2)

    @property
    def is_linear(self) -> bool:
        """Whether floats are linear light of sRGB's primaries already."""
        probes = np.concatenate([np.eye(3), np.repeat(np.linspace(0, 1, 33)[:, np.newaxis], 3, axis=1)])
        return bool(np.abs(self.linear(probes) - probes).max() < _CLOSE)

    def linear(self, encoded: Values) -> Values:
        """Linear light of sRGB's primaries, shape (..., 3) as given."""
        light = np.stack([curve(encoded[..., c]) for c, curve in enumerate(self.curves)], axis=-1)
        return light @ self.matrix.T

    def to_srgb(self, pixels: NDArray[Any]) -> NDArray[Any]:
        """Gray or three channels in sRGB, the type kept: floats as linear light."""
        most = white(pixels.dtype)
        flat = pixels.reshape(-1, pixels.shape[-1])
        out = np.empty_like(flat)
        for first in range(0, len(flat), _BAND):
            encoded = flat[first : first + _BAND] / np.float64(most)
            light = self.linear(np.broadcast_to(encoded, (len(encoded), 3)))
            light = light if flat.shape[1] == 3 else light[:, 1:2]  # gray is neutral: all three are alike
            if pixels.dtype.kind == "u":
                light = np.rint(np.clip(_encode(light), 0, 1) * most)
            out[first : first + _BAND] = light
        return out.reshape(pixels.shape)


def space_of(name: str, chromaticities: tuple[float, ...], curve: Curve) -> RgbSpace | None:
    """The space of primaries and white, given as x and y of each; None where these make no space."""
    srgb = _to_d50(SRGB_PRIMARIES)
    given = _to_d50(chromaticities)
    if given is None or srgb is None:
        return None
    return RgbSpace(name, (curve, curve, curve), np.linalg.inv(srgb) @ given)


def space_of_colorants(name: str, colorants: Values, curves: tuple[Curve, Curve, Curve]) -> RgbSpace:
    """The space of a profile, whose matrix leads to XYZ under D50."""
    srgb = _to_d50(SRGB_PRIMARIES)
    assert srgb is not None
    return RgbSpace(name, curves, np.linalg.inv(srgb) @ colorants)


def lab_to_srgb(lab: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """8-bit CIE L*a*b* under D50 with signed a* and b* (TIFF 6.0, section 23) as sRGB, shape (..., 3)."""
    srgb = _to_d50(SRGB_PRIMARIES)
    assert srgb is not None
    red_green, yellow_blue = (lab[..., c].view(np.int8) for c in (1, 2))
    lightness = (lab[..., 0] / 2.55 + 16) / 116
    cubes = np.stack([lightness + red_green / 500, lightness, lightness - yellow_blue / 200], axis=-1)
    low = 6 / 29
    xyz = np.where(cubes > low, cubes**3, 3 * low**2 * (cubes - 4 / 29)) * _D50
    light = xyz @ np.linalg.inv(srgb).T
    return np.rint(np.clip(_encode(light), 0, 1) * 255).astype(np.uint8)


def are_srgb(chromaticities: tuple[float, ...]) -> bool:
    """Whether primaries and white are those of sRGB."""
    return bool(np.abs(np.subtract(chromaticities, SRGB_PRIMARIES)).max() < _CLOSE)


def adobe_rgb() -> RgbSpace | None:
    """Adobe RGB (1998), section 4.3."""
    return space_of("Adobe RGB (1998)", _ADOBE, gamma_curve(563 / 256))


def space_of_code_points(primaries: int, transfer: int) -> RgbSpace | None:
    """The space that numbers of ITU-T H.273, tables 2 and 3, name; None of those that are not known here."""
    named = {1: ("BT.709", SRGB_PRIMARIES), 9: ("BT.2020", _BT2020), 12: ("Display P3", _P3)}
    curves = {
        **dict.fromkeys((1, 6, 14, 15), gamma_curve(2.4)),  # shown as Rec. ITU-R BT.1886 says
        **{4: gamma_curve(2.2), 5: gamma_curve(2.8), 8: gamma_curve(1.0), 13: srgb_curve},
    }
    if primaries not in named or transfer not in curves:
        return None
    name, chromaticities = named[primaries]
    return space_of(name, chromaticities, curves[transfer])


def _to_d50(chromaticities: tuple[float, ...]) -> Values | None:
    """From linear light to XYZ under D50, by Bradford's adaptation (ICC.1:2022, annex E)."""
    xy = np.array(chromaticities, np.float64).reshape(4, 2)
    if not np.isfinite(xy).all() or (np.abs(xy[:, 1]) < 1e-6).any():
        return None
    columns = np.stack([xy[:, 0] / xy[:, 1], np.ones(4), (1 - xy.sum(axis=1)) / xy[:, 1]])
    primaries, light = columns[:, :3], columns[:, 3]
    if abs(np.linalg.det(primaries)) < 1e-9:
        return None
    matrix = primaries * np.linalg.solve(primaries, light)
    cones = _BRADFORD @ np.stack([_D50, light], axis=1)
    adapted: Values = np.linalg.inv(_BRADFORD) @ np.diag(cones[:, 0] / cones[:, 1]) @ _BRADFORD @ matrix
    return adapted
