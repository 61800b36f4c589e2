"""What a map holds - light, numbers, roughness or normals - and how pixels of each are averaged."""

import re
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.pixels import LUMINANCE, MAP_WORDS, has_alpha, packed_parts, white, without_alpha

KINDS = ("color", "data", "roughness", "height", "normal-gl", "normal-dx")
"""Light (sRGB where 8 or 16 bit, linear where float); numbers; roughness of a surface; heights of a surface;
normals in tangent space with green up (OpenGL) or down (DirectX)."""

Values = NDArray[np.float32]

_DIRECTX = ("dx", "directx", "d3d")


def guess_kind(name: str) -> str:
    """What a map of this name most likely holds: ``rough_wood_albedo`` is color, ``NormalDX`` normals."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    words = re.findall("[a-z]+", spaced.lower())
    for before, word in reversed([*pairwise(["", *words])]):
        if packed_parts(before + word):  # metalRoughness is not roughness
            return "data"
        for kind, _, known, _ in MAP_WORDS.values():
            # Longer words are also known by their beginning: heightmap, displacementmap.
            if word in known or any(len(k) > 3 and word.startswith(k) for k in known):
                directx = kind == "normal-gl" and any(w in _DIRECTX for w in words)
                return "normal-dx" if directx or word == "normaldx" else kind
    return "color"


def is_normal(kind: str) -> bool:
    """Whether a map of this kind holds vectors."""
    return kind.startswith("normal")


def to_values(pixels: NDArray[Any], kind: str, signed: bool | None = None) -> Values:
    """Numbers whose mean is what a pixel seen from afar shows, shape as given.

    Color becomes linear light multiplied by its alpha (the last of 2 or 4 channels), normals become vectors
    of length 1, roughness r becomes r^4, the square of the width of GGX and Beckmann lobes, which adds up
    like a variance; other numbers stay, integers as a share of their largest. ``signed`` is `is_signed` of
    the whole map, where pixels are only part of it.
    """
    scaled = _scaled(pixels)
    if kind == "color":
        return _premultiplied(to_linear(scaled) if pixels.dtype.kind == "u" else scaled, scaled)
    if kind == "roughness":
        rough = without_alpha(scaled)
        rough[...] = np.maximum(rough, 0) ** 4
        return scaled
    if is_normal(kind):
        if not (is_signed(pixels) if signed is None else signed):
            scaled[..., :3] = 2 * scaled[..., :3] - 1
        scaled[..., :3] = unit(scaled[..., :3])
    return scaled


def from_values(values: Values, kind: str, like: NDArray[Any], signed: bool | None = None) -> NDArray[Any]:
    """Pixels that show the values, in the encoding of the map ``like``; normals get length 1."""
    if kind == "color":
        values = _divided(values)
        shown = to_encoded(values) if like.dtype.kind == "u" else values
        if has_alpha(values.shape[-1]):
            shown[..., -1] = values[..., -1]
    elif kind == "roughness":
        shown = values.copy()
        rough = without_alpha(shown)
        rough[...] = rough**0.25
    elif is_normal(kind):
        shown = values.copy()
        shown[..., :3] = unit(values[..., :3])
        if not (is_signed(like) if signed is None else signed):
            shown[..., :3] = 0.5 * shown[..., :3] + 0.5
    else:
        shown = values
    if like.dtype.kind == "f":
        return shown.astype(like.dtype)
    return np.rint(np.clip(shown, 0, 1) * white(like.dtype)).astype(like.dtype)


def unit(vectors: Values) -> Values:
    """Vectors of length 1 along the last axis; two components stay, as their third one is not stored."""
    if vectors.shape[-1] < 3:
        return vectors
    length = np.sqrt((vectors * vectors).sum(axis=-1, keepdims=True))
    return np.where(length > 1e-6, vectors / np.maximum(length, 1e-6), np.array([0, 0, 1], np.float32))


def is_signed(pixels: NDArray[Any]) -> bool:
    """Whether a map of normals holds -1 to 1, as float maps may, and not 0 to 1."""
    if pixels.dtype.kind != "f":
        return False
    return bool(pixels.min() < 0) or abs(float(pixels[..., :2].mean(dtype=np.float64))) < 0.25


def to_linear(encoded: NDArray[Any]) -> Values:
    """Linear light of sRGB values from 0 to 1 (IEC 61966-2-1)."""
    low, high = encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4
    return np.where(encoded <= 0.04045, low, high).astype(np.float32)


def to_encoded(linear: NDArray[Any]) -> Values:
    """sRGB values of linear light from 0 to 1."""
    low, high = 12.92 * linear, 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055
    return np.where(linear <= 0.0031308, low, high).astype(np.float32)


def _scaled(pixels: NDArray[Any]) -> Values:
    if pixels.dtype.kind == "f":
        return pixels.astype(np.float32)
    return pixels.astype(np.float32) / np.float32(white(pixels.dtype))


def _premultiplied(light: Values, scaled: Values) -> Values:
    if not has_alpha(light.shape[-1]):
        return light
    alpha = scaled[..., -1:]
    return np.concatenate([light[..., :-1] * alpha, alpha], axis=-1)


def _divided(values: Values) -> Values:
    if not has_alpha(values.shape[-1]):
        return values
    alpha = values[..., -1:]
    return np.concatenate([values[..., :-1] / np.maximum(alpha, 1e-6), alpha], axis=-1)


def to_lab(pixels: NDArray[Any], kind: str) -> Values:
    """CIE L*a*b* of color under D65, shape (h, w, 3), and L* alone of gray; other maps from 0 to 100.

    CIE 15:2018, section 8.2.1.
    """
    colors = without_alpha(pixels)
    if kind != "color":
        shown = colors.astype(np.float32)
        low, high = (
            (0.0, float(white(pixels.dtype))) if pixels.dtype.kind == "u" else (shown.min(), shown.max())
        )
        return np.asarray((shown - low) * np.float32(100 / max(float(high - low), 1e-12)))
    light = to_linear(_scaled(colors)) if pixels.dtype.kind == "u" else _scaled(colors)
    if light.shape[-1] == 1:
        return np.asarray(116 * _cube_root(light) - 16)
    x, y, z = (sum(w * light[..., c] for c, w in enumerate(row)) for row in _XYZ)
    x, y, z = (_cube_root(np.asarray(v, np.float32)) for v in (x, y, z))
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


_XYZ = (
    (0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505),
    LUMINANCE,
    (0.0193 / 1.089, 0.1192 / 1.089, 0.9505 / 1.089),
)
"""CIE XYZ over that of white, from linear sRGB (IEC 61966-2-1)."""


def _cube_root(share: Values) -> Values:
    """The function f of CIE L*a*b*: a cube root with a straight foot."""
    foot = (6 / 29) ** 3
    return np.where(
        share > foot, np.cbrt(np.maximum(share, foot)), share / (3 * (6 / 29) ** 2) + np.float32(4 / 29)
    )
