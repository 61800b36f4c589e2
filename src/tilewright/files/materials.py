"""From photographs to texture tiles: opens what a person brings and synthesizes."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.files.images import read_image
from tilewright.signals.textures import Exemplar, TextureTiles
from tilewright.signals.textures.exemplar import check_map
from tilewright.tiles import TileSet, corner_tiles

Picture = str | Path | NDArray[Any]
Photo = Picture | Mapping[str, Picture]


def open_exemplar(
    photo: Photo,
    *,
    second: Photo | None = None,
    mask: Picture | None = None,
    second_mask: Picture | None = None,
    weights: dict[str, float] | None = None,
) -> Exemplar:
    """An exemplar from files or arrays.

    Parameters
    ----------
    photo : path, array of shape (h, w) or (h, w, channels), or dict of map name to either
        A single picture becomes the map ``"albedo"``.
    second : the same, optional
        The source of the marked corners of an inhomogeneous set.
    mask, second_mask : path or array, optional
        Pixels that may be copied: those at least half as bright as white.
    weights : dict of map name to float, optional
        How much a map counts when patches are matched and cut.
    """
    if second is None and second_mask is not None:
        raise TilewrightValueError("second_mask is for a second photograph; give second too")
    photos = [_open_maps(photo, "photo")] + ([] if second is None else [_open_maps(second, "second")])
    masks = [_open_mask(mask)] + ([] if second is None else [_open_mask(second_mask)])
    return Exemplar(photos, masks, weights)


def texture_tiles(
    photo: Photo,
    tiles: TileSet | None = None,
    *,
    second: Photo | None = None,
    mask: Picture | None = None,
    second_mask: Picture | None = None,
    weights: dict[str, float] | None = None,
    tile_size: int | str = 128,
    seed: int = 0,
    **options: Any,
) -> TextureTiles:
    """Texture tiles from a photograph; see `open_exemplar` for the pictures.

    Parameters
    ----------
    tiles : TileSet, optional
        The complete corner set over 2 colors by default, over 4 with two photographs.
    tile_size : int or "auto"
        Pixels along a tile.
    seed : int
        The same seed gives the same bytes.
    **options
        ``method``, ``pick``, ``reject``, ``threads`` and ``progress``, as in `tilewright.synthesize`.

    Raises
    ------
    TilewrightFileError
        A file is not a whole image.
    TilewrightValueError, TilewrightTypeError
        A picture, size or option that cannot be used; the message names it and what is allowed.
    """
    from tilewright.signals.textures import synthesize

    exemplar = open_exemplar(photo, second=second, mask=mask, second_mask=second_mask, weights=weights)
    if tiles is None:
        tiles = corner_tiles(2 if second is None else 4)
    return synthesize(exemplar, tiles, tile_size=tile_size, seed=seed, **options)


def _open_maps(photo: Photo, what: str) -> dict[str, NDArray[Any]]:
    if isinstance(photo, Mapping):
        if not photo:
            raise TilewrightValueError(f"{what} is an empty dict; at least one map is needed")
        return {name: _open_map(picture, f"map {name!r}") for name, picture in photo.items()}
    return {"albedo": _open_map(photo, what)}


def _open_map(picture: Picture, what: str) -> NDArray[Any]:
    """A map, checked at once, so that what is wrong with a file is said with its name."""
    return check_map(str(picture) if isinstance(picture, (str, Path)) else what, _open(picture, what))


def _open(picture: Picture, what: str) -> NDArray[Any]:
    if isinstance(picture, (str, Path)):
        return read_image(picture)
    if isinstance(picture, np.ndarray):
        return picture
    raise TilewrightTypeError(f"{what} must be a path or an array, not {type(picture).__name__}")


def _open_mask(mask: Picture | None) -> NDArray[np.bool_] | None:
    if mask is None:
        return None
    pixels = _open(mask, "mask")
    if pixels.dtype == bool:
        return pixels
    if pixels.dtype.kind not in "uf" or not np.isfinite(pixels).all():
        raise TilewrightTypeError(
            f"mask holds {pixels.dtype}; allowed are bool, unsigned integers, and floats without NaN"
        )
    white = np.iinfo(pixels.dtype).max if pixels.dtype.kind == "u" else 1
    if pixels.ndim == 3:  # grey or color, either of them with alpha, which does not count
        pixels = pixels[..., : 1 if pixels.shape[2] < 3 else 3].mean(axis=2)
    return pixels >= white / 2
