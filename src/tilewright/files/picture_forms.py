"""What a picture file holds of pixels: they themselves, or another form where its format asks for it."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.files.images import check_writable
from tilewright.pixels import has_alpha, white, without_alpha
from tilewright.signals.textures.kinds import to_linear

_LOSSY = (".jpg", ".jpeg", ".webp")
"""Formats for looking at, which lose some of what they are given."""
FORMATS = (".png", ".tif", ".tiff", ".exr", *_LOSSY)

Convert = Callable[[NDArray[Any]], NDArray[Any]]


class PictureForm(NamedTuple):
    """Type and channels of a file's pixels, and how they are made of what is rendered."""

    dtype: np.dtype[Any]
    channels: int
    convert: Convert


def picture_form(path: Path, dtype: np.dtype[Any], channels: int, kind: str) -> PictureForm:
    """How a file of this suffix shows a map.

    EXR holds floats: of colors the linear light that their numbers encode, of other maps shares of the
    largest number. JPEG and WebP hold 8 bits, JPEG no alpha, WebP no gray.

    Raises
    ------
    TilewrightValueError
        Another suffix, floats where a file holds integers, alpha in a JPEG.
    """
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        ends = f"ends in {suffix!r}" if suffix else "has no suffix"
        raise TilewrightValueError(f"{path} {ends}; allowed are {', '.join(FORMATS)}", value=path)
    if suffix == ".exr" and dtype.kind == "u":
        return PictureForm(np.dtype(np.float32), channels, _as_light if kind == "color" else _as_shares)
    if suffix in _LOSSY and dtype.kind == "u":
        if suffix != ".webp" and has_alpha(channels):
            raise TilewrightValueError(
                f"{path}: {suffix} holds no alpha", value=path, advice="use .webp, .png or .tif"
            )
        shown = channels if suffix != ".webp" else 4 if has_alpha(channels) else 3
        return PictureForm(np.dtype(np.uint8), shown, lambda pixels: _widened(_as_bytes(pixels), shown))
    if suffix in _LOSSY:
        raise TilewrightValueError(
            f"{path}: {suffix} cannot hold {dtype} pixels", value=path, advice="use .tif or .exr"
        )
    check_writable(path, dtype)
    return PictureForm(dtype, channels, lambda pixels: pixels)


def _as_shares(pixels: NDArray[Any]) -> NDArray[np.float32]:
    return pixels.astype(np.float32) / np.float32(white(pixels.dtype))


def _as_light(pixels: NDArray[Any]) -> NDArray[np.float32]:
    shares = _as_shares(pixels)
    colors = without_alpha(shares)
    colors[...] = to_linear(colors)
    return shares


def _as_bytes(pixels: NDArray[Any]) -> NDArray[np.uint8]:
    return pixels if pixels.dtype == np.uint8 else np.rint(pixels / 257).astype(np.uint8)


def _widened(pixels: NDArray[np.uint8], channels: int) -> NDArray[np.uint8]:
    """Gray as three equal colors, where so many are asked for."""
    if pixels.shape[2] == channels:
        return pixels
    return np.concatenate([pixels[..., :1].repeat(3, axis=2), pixels[..., 1:]], axis=2)
