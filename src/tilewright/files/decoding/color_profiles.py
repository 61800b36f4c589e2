"""ICC profiles: from the colors a profile describes to sRGB.

8-bit colors are converted by littleCMS, relative colorimetric. It takes no more bits through Pillow, and dark
8-bit gray comes out of it 10 of 255 too dark, so gray, 16-bit and float pixels are converted here, by a
profile's matrix and curves (ICC.1:2022, sections 8.3, 10.6 and 10.18).
"""

import io
import struct
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.files.decoding.rgb_spaces import (
    Curve,
    RgbSpace,
    Values,
    gamma_curve,
    space_of_colorants,
)

_NEAR_SRGB = 2
"""Steps of 8 bit by which profiles that are called sRGB differ from each other."""


class ProfileError(Exception):
    """A profile that cannot be applied; says why."""


@lru_cache(maxsize=8)
def profile_name(profile: bytes) -> str:
    """What a profile calls itself, quoted."""
    from PIL import ImageCms

    try:
        name = ImageCms.getProfileDescription(ImageCms.ImageCmsProfile(io.BytesIO(profile))).strip()
    except (ImageCms.PyCMSError, OSError):
        raise ProfileError("its color profile is damaged") from None
    return repr(" ".join(name.split())[:80] or "without a name")


def convert_profile(pixels: NDArray[Any], profile: bytes) -> tuple[NDArray[Any], str]:
    """Gray or three channels of color as sRGB, floats as linear light; and what was done, empty if nothing.

    Raises
    ------
    ProfileError
        The profile is damaged, or describes other channels than there are, or cannot be applied to this type.
    """
    name = profile_name(profile)
    kind = profile[16:20].decode("latin-1").strip()
    if kind not in ("RGB", "GRAY") or (kind == "GRAY" and pixels.shape[-1] != 1):
        raise ProfileError(f"its color profile {name} is for {kind}, not for its channels")
    if pixels.dtype.kind == "f":
        space = _read_space(profile, name)
        return (pixels, "") if space.is_linear else (space.to_srgb(pixels), f"{name} to linear light of sRGB")
    if _is_srgb(profile, kind):
        return pixels, ""
    if pixels.dtype == np.uint8 and kind == "RGB":
        return _convert_bytes(pixels, profile, kind), f"{name} to sRGB"
    return _read_space(profile, name).to_srgb(pixels), f"{name} to sRGB"


@lru_cache(maxsize=8)
def _is_srgb(profile: bytes, kind: str) -> bool:
    """Whether a profile leaves numbers as they are, near enough: its name does not say so."""
    grays = np.arange(256, dtype=np.uint8)[:, np.newaxis]
    probes = [grays]
    if kind == "RGB":
        steps = np.linspace(0, 255, 9).astype(np.uint8)
        probes = [
            grays.repeat(3, axis=1),
            np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3),
        ]
    return all(
        np.abs(_convert_bytes(p[np.newaxis], profile, kind).astype(int) - p).max() <= _NEAR_SRGB
        for p in probes
    )


def _convert_bytes(pixels: NDArray[np.uint8], profile: bytes, kind: str) -> NDArray[np.uint8]:
    """8-bit gray or color by littleCMS."""
    from PIL import Image

    gray = pixels.shape[-1] == 1
    given = pixels[..., 0] if gray and kind == "GRAY" else np.broadcast_to(pixels, (*pixels.shape[:2], 3))
    shown = Image.fromarray(np.ascontiguousarray(given))
    converted = np.asarray(_transform(profile, shown.mode).apply(shown))
    return converted[..., 1:2] if gray else converted  # of gray all three are alike


@lru_cache(maxsize=8)
def _transform(profile: bytes, mode: str) -> Any:
    """What littleCMS does to pixels of a mode."""
    from PIL import ImageCms

    try:
        return ImageCms.buildTransform(
            ImageCms.ImageCmsProfile(io.BytesIO(profile)),
            ImageCms.createProfile("sRGB"),
            mode,
            "RGB",
            renderingIntent=ImageCms.Intent.RELATIVE_COLORIMETRIC,
        )
    except (ImageCms.PyCMSError, OSError):
        raise ProfileError("its color profile is damaged") from None


def _read_space(profile: bytes, name: str) -> RgbSpace:
    """The matrix and the curves of a profile."""
    try:
        tags = _read_tags(profile)
        if b"kTRC" in tags:
            curve = _read_curve(tags[b"kTRC"])
            return RgbSpace(name, (curve, curve, curve), np.eye(3))
        if any(tag in tags for tag in (b"A2B0", b"A2B1")) or b"rXYZ" not in tags:
            raise ProfileError(f"its color profile {name} holds tables, which are applied to 8 bit alone")
        colorants = np.stack([_read_xyz(tags[tag]) for tag in (b"rXYZ", b"gXYZ", b"bXYZ")], axis=1)
        red, green, blue = (_read_curve(tags[tag]) for tag in (b"rTRC", b"gTRC", b"bTRC"))
        return space_of_colorants(name, colorants, (red, green, blue))
    except (KeyError, struct.error, ValueError, IndexError, ZeroDivisionError):
        raise ProfileError(f"its color profile {name} is damaged") from None


def _read_tags(profile: bytes) -> dict[bytes, bytes]:
    (count,) = struct.unpack_from(">I", profile, 128)
    tags = (struct.unpack_from(">4s2I", profile, 132 + 12 * i) for i in range(min(count, 200)))
    return {tag: profile[start : start + size] for tag, start, size in tags}


def _read_xyz(tag: bytes) -> Values:
    return np.array(struct.unpack_from(">3i", tag, 8), np.float64) / 65536


def _read_curve(tag: bytes) -> Curve:
    (count,) = struct.unpack_from(">I", tag, 8)
    if tag[:4] == b"para":
        return _parametric(tag)
    if count == 0:
        return gamma_curve(1.0)
    if count == 1:
        return gamma_curve(struct.unpack_from(">H", tag, 12)[0] / 256)
    table = np.frombuffer(tag, ">u2", count, 12) / 65535
    return lambda encoded: _look_up(encoded, table)


def _look_up(encoded: Values, table: Values) -> Values:
    """A curve of equal steps; beyond its ends it goes on as it came there."""
    steps = np.linspace(0, 1, len(table))
    before, last = table[1] * (len(table) - 1), (table[-1] - table[-2]) * (len(table) - 1)
    beyond = np.minimum(encoded, 0) * before + np.maximum(encoded - 1, 0) * last
    return np.asarray(np.interp(encoded, steps, table) + beyond)


def _parametric(tag: bytes) -> Curve:
    """A curve by its function (ICC.1:2022, table 68)."""
    (kind,) = struct.unpack_from(">H", tag, 8)
    count = (1, 3, 4, 5, 7)[kind]
    given = np.zeros(7)
    given[:count] = np.array(struct.unpack_from(f">{count}i", tag, 12)) / 65536
    gamma, a, b, c, d, e, f = (float(number) for number in given)
    if kind == 0:
        return gamma_curve(gamma)
    if kind in (1, 2):  # flat, at c, up to where the power begins
        c, d, e, f = 0.0, -b / a, c, c
    return lambda encoded: np.where(
        encoded >= d, np.maximum(a * encoded + b, 0) ** gamma + e, c * encoded + f
    )
