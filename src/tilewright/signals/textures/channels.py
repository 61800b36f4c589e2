"""What lies in the channels of pictures people bring: several maps in one, x and y alone, gray for color."""

import warnings
from collections.abc import Collection, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, TilewrightWarning
from tilewright.pixels import Part, as_rgb, has_alpha, packed_parts, white, without_alpha

Maps = dict[str, NDArray[Any]]

_AT = {1: "r", 2: "ra", 3: "rgb", 4: "rgba"}
"""Channels of pictures by their number."""


def unpack_maps(maps: Mapping[str, NDArray[Any]], kept: Collection[str] = ()) -> Maps:
    """Maps in which those that hold several are taken apart, each with a channel of its own.

    A map that is there by itself goes before one from a packed picture. Ambient occlusion of 0 everywhere is
    a channel that was not filled, and is left out; all others are taken, whatever they hold.

    Parameters
    ----------
    maps : dict of str to array, shape (h, w, channels)
        Maps by name; which ones are packed, and how, `tilewright.pixels.PACKED_MAPS` tells.
    kept : collection of str, optional
        Packed maps that stay as they are, numbers in one picture.

    Raises
    ------
    TilewrightValueError
        A packed map has too few channels for what its name says.

    Warns
    -----
    TilewrightWarning
        Something a packed map holds, or should hold, is left out.
    """
    unpacked: Maps = {}
    packed = {name: packed_parts(name) for name in maps if name not in kept}
    alone = {name for name in maps if not packed.get(name)}
    for name, pixels in maps.items():
        if name in alone:
            unpacked[name] = pixels
            continue
        _check_channels(name, pixels, packed[name])
        for part in packed[name]:
            reason = _why_not(part, pixels, alone | unpacked.keys())
            if reason:
                warnings.warn(
                    f"left out {part.map} of map {name!r}: {reason}", TilewrightWarning, stacklevel=5
                )
            else:
                unpacked[part.map] = _take(part, pixels)
    return unpacked


def _check_channels(name: str, pixels: NDArray[Any], parts: tuple[Part, ...]) -> None:
    there = _AT[pixels.shape[-1]]
    missing = [part for part in parts if part.channel not in (*there, "a")]
    if missing:
        held = ", ".join(f"{part.map} in {part.channel}" for part in parts)
        raise TilewrightValueError(
            f"has {len(there)} channels; by its name it holds {held}",
            argument=f"map {name!r}",
            advice="name what it is with its file, or its kind, 'data', to keep it as it is",
        )


def _why_not(part: Part, pixels: NDArray[Any], there: Collection[str]) -> str:
    """Why a part of a packed map is not taken; nothing where it is."""
    if part.channel not in _AT[pixels.shape[-1]]:
        return "its picture has no alpha"
    if part.map in there:
        return "there is another file for it"
    if part.map == "ao" and not _take(part, pixels).any():
        return "it is 0 everywhere"
    return ""


def _take(part: Part, pixels: NDArray[Any]) -> NDArray[Any]:
    at = _AT[pixels.shape[-1]].index(part.channel)
    taken = pixels[..., at : at + 1]
    return np.ascontiguousarray(white(pixels.dtype) - taken if part.inverted else taken).astype(
        pixels.dtype, copy=False
    )


def restore_blue(pixels: NDArray[Any], signed: bool) -> NDArray[Any]:
    """Normals with all three components, where a picture holds but two of them.

    Formats for GPUs store x and y alone and leave z to the shader: unpacked, blue is 0 or white everywhere
    (BC5), or x lies in alpha and red is of one value or that of green (DXT5nm). z is what makes the length 1;
    it points out of the surface.

    Parameters
    ----------
    pixels : array, shape (h, w, channels)
        A map of normals.
    signed : bool
        Whether its numbers go from -1 to 1.

    Returns
    -------
    array, shape (h, w, 3), or ``pixels`` where all components are there
        Of the same type.
    """
    places = _find_slopes(pixels)
    if places is None:
        return pixels
    most = white(pixels.dtype)
    across = pixels[..., list(places)].astype(np.float32)
    if not signed:
        across = across * np.float32(2 / most) - 1
    up = np.sqrt(np.maximum(1 - (across * across).sum(axis=-1, keepdims=True), 0))
    vectors = np.concatenate([across, up], axis=-1)
    if not signed:
        vectors = (vectors + 1) * np.float32(most / 2)
    if pixels.dtype.kind == "u":
        vectors = np.rint(np.clip(vectors, 0, most))
    vectors = vectors.astype(pixels.dtype)
    vectors[..., :2] = pixels[..., list(places)]
    return vectors


def _find_slopes(pixels: NDArray[Any]) -> tuple[int, int] | None:
    """The channels of x and y where z is none; None where it is there."""
    lowest, highest = pixels.min(axis=(0, 1)), pixels.max(axis=(0, 1))
    varies = lowest < highest
    if pixels.shape[-1] < 3 or not varies[1]:
        return None
    # Red is white, or what green is: there is room for x in alpha alone.
    if pixels.shape[-1] == 4 and varies[3] and (not varies[0] or np.array_equal(*pixels[..., :2].T)):
        return 3, 1
    empty = lowest[2] == highest[2] and highest[2] in (0, white(pixels.dtype))
    return (0, 1) if varies[0] and empty else None


def agree_channels(sources: list[Maps]) -> list[Maps]:
    """Maps of several photographs with one type and number of channels each, where nothing is lost by it.

    Gray is repeated for three channels, an alpha that is full everywhere is dropped or made where the other
    photograph's is not, 8 bit becomes 16 beside 16. What cannot agree stays as it is.
    """
    names = [name for name in sources[0] if all(name in source for source in sources)]
    agreed = [dict(source) for source in sources]
    for name in names:
        maps = [source[name] for source in sources]
        if len({(m.dtype, m.shape[2]) for m in maps}) > 1:
            for source, pixels in zip(agreed, _alike(maps), strict=True):
                source[name] = pixels
    return agreed


def _alike(maps: list[NDArray[Any]]) -> list[NDArray[Any]]:
    if {m.dtype for m in maps} == {np.dtype(np.uint8), np.dtype(np.uint16)}:
        maps = [m if m.dtype == np.uint16 else m * _EIGHT_TO_SIXTEEN for m in maps]
    colored = any(m.shape[2] > 2 for m in maps)
    clear = any(has_alpha(m.shape[2]) and (m[..., -1] != white(m.dtype)).any() for m in maps)
    return [_formed(m, colored, clear) for m in maps]


_EIGHT_TO_SIXTEEN = np.uint16(257)
"""65,535 / 255."""


def _formed(pixels: NDArray[Any], colored: bool, clear: bool) -> NDArray[Any]:
    """Gray or color, with alpha or without."""
    shown = as_rgb(pixels) if colored else without_alpha(pixels)
    if not clear:
        return np.ascontiguousarray(shown)
    full = np.full_like(shown[..., :1], white(shown.dtype))
    return np.concatenate([shown, pixels[..., -1:] if has_alpha(pixels.shape[-1]) else full], axis=-1)
