"""Mip levels of texture tiles that show no line where tiles meet.

A texel next to a tile's border is filtered together with one beyond it, which graphics hardware takes from
the layer or the atlas, not from the tile that really lies there. So in every level such texels are made to
depend on what both sides know: next to an edge, on the colors of that edge alone; next to a corner, on the
color of that corner alone. Each becomes its mean over all tiles that share those colors. Where the tiles were
made with a border as wide as a texel, all those are equal already and nothing changes; in the coarsest
levels, where a tile is one texel, what is left is the mean of the set (Lagae & Dutré 2006, section 6.2, asks
for the first; the rest is our own).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import isqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.pixels import white, without_alpha
from tilewright.signals.textures.kinds import Values, from_values, is_normal, to_values
from tilewright.signals.textures.sharing import Rim, Shared, with_gutters
from tilewright.signals.textures.texture_tiles import TextureTiles


@dataclass(frozen=True, eq=False)
class Mipmaps:
    """A full mip chain.

    Attributes
    ----------
    levels : tuple of array, shape (layers, rows, columns, channels)
        Level k has half the rows and columns of the one before, rounded down, to 1 x 1; the type of the map.
    gutter : int
        Pixels of level 0 around the tile in each layer.
    clean : int
        Levels 0 to ``clean`` are plain means of the pixels they cover, everywhere; in coarser ones, texels at
        tile borders are means over the tiles that share those borders.
    """

    levels: tuple[NDArray[Any], ...]
    gutter: int
    clean: int


def layer_mipmaps(material: TextureTiles, map: str | None = None) -> Mipmaps:
    """Mip levels of a map, a layer for each picture in its order, with gutters around the tiles.

    Filter layers with clamped coordinates. Place p in a tile, 0 to 1, is at
    ``(gutter + p * tile_size) / (2 * gutter + tile_size)`` of its layer; take gradients of the position
    before it is split into cell and place.

    Returns
    -------
    Mipmaps
        Level 0 has shape (rows, n + 2 gutter, n + 2 gutter, channels): the pixels of the map, and around them
        those of neighbors that may lie there.

    Raises
    ------
    TilewrightValueError
        There is no such map, or the tiles have no corner colors: what lies at the corners of Wang tiles
        depends on tiles that touch only there.
    """
    name = check_map_name(material, map)
    shared = Shared(material.tiles, material.variants)
    if not shared.corners:
        raise TilewrightValueError(
            f"layers with gutters need tiles with corner colors, and {material.tiles.shape.name} tiles have "
            "none: make the texture over corner_tiles(), or take an atlas"
        )
    gutter = layer_gutter(material.tile_size)

    base = with_gutters(material.maps[name], gutter, shared)
    return _encode(material, name, base, lambda name: _layer_values(material, name, gutter, shared), gutter)


def _layer_values(
    material: TextureTiles, name: str, gutter: int, shared: Shared
) -> Iterator[tuple[Values, bool]]:
    """Values of a map's layers with gutters, level by level, and whether those at borders are plain means."""
    level = to_values(with_gutters(material.maps[name], gutter, shared), material.kinds[name])
    while True:
        yield shared.settle(level, Rim.of_layer(level.shape[1], material.tile_size, gutter))
        if level.shape[1] == 1:
            return
        level = _halve(level)


def _beside(levels: Iterator[tuple[Values, bool]], cells: NDArray[Any]) -> Iterator[tuple[Values, bool]]:
    """Levels of pictures side by side, as long as these halve; then levels of the whole."""
    for level, same in levels:
        picture = _lay(level, cells)
        yield picture, same
        if level.shape[1] % 2:
            break
    while max(picture.shape[1:3]) > 1:
        picture = _halve(picture)
        yield picture, False


def layer_gutter(size: int) -> int:
    """Pixels around a tile of ``size`` pixels in its layer: a power of two, up to a 16th of it, at least 2.

    Texels of as many levels fit between gutter and tile; with those that do not, borders look smoother than
    the rest, so that is left to levels in which a tile is a few texels.
    """
    return max(2, 1 << max(1, size // 16).bit_length() - 1)


def atlas_mipmaps(material: TextureTiles, cells: NDArray[Any], map: str | None = None) -> Mipmaps:
    """Mip levels of many tiles side by side, as one layer.

    Parameters
    ----------
    cells : int array, shape (rows, columns)
        The picture (its row in the maps) in each cell of a torus whose neighbors match, such as a
        `tilewright.packing`. Filter the result with repeated coordinates.

    Returns
    -------
    Mipmaps
        Level 0 has shape (1, rows * n, columns * n, channels). Levels are free of lines where their texels
        divide the tiles, so the tile size n should be a power of two.
    """
    name = check_map_name(material, map)
    cells = np.asarray(cells)
    if cells.ndim != 2 or cells.dtype.kind not in "iu":
        raise TilewrightTypeError(
            f"must be a table of rows, not {cells.dtype} {cells.shape}",
            argument="cells",
            value=cells.dtype,
            allowed="a table of rows",
        )
    shared = Shared(material.tiles, material.variants)

    def values(name: str) -> Iterator[tuple[Values, bool]]:
        tiles = to_values(material.maps[name], material.kinds[name])
        while True:
            yield shared.settle(tiles, Rim(tiles.shape[1], 0, None))
            tiles = _halve(tiles)

    base = _lay(material.maps[name], cells)
    return _encode(material, name, base, lambda name: _beside(values(name), cells), 0)


def grid_mipmaps(material: TextureTiles, map: str | None = None) -> Mipmaps:
    """Mip levels of layers with gutters in the squares of a grid, row by row, as one layer.

    For sets without a packing, where there are no texture arrays: what lies in neighboring squares does not
    belong together, so places must stay within their square.

    Returns
    -------
    Mipmaps
        Level 0 has shape (1, m, m, channels), m = `grid_side` times the side of a layer. Levels are free of
        lines as long as a layer is a whole number of texels.
    """
    name = check_map_name(material, map)
    shared = Shared(material.tiles, material.variants)
    gutter, side = layer_gutter(material.tile_size), grid_side(len(material.variants))
    # What is left of the last row is filled with the first tiles.
    cells = np.arange(side**2).reshape(side, side) % len(material.variants)

    def values(name: str) -> Iterator[tuple[Values, bool]]:
        return _beside(_layer_values(material, name, gutter, shared), cells)

    base = _lay(with_gutters(material.maps[name], gutter, shared), cells)
    return _encode(material, name, base, values, gutter)


def grid_side(pictures: int) -> int:
    """Squares along the side of a grid that holds so many pictures."""
    return isqrt(pictures - 1) + 1


def tone_levels(material: TextureTiles, map: str) -> list[NDArray[np.float16]]:
    """Mip levels of the picture of a map's tone, to one texel; none where it has no tone.

    Returns
    -------
    list of float16 array, shape (rows, columns, 4)
        Red, green, blue and 0, around 0, as a share of white in sRGB.
    """
    tone = None if material.tone is None else material.tone.maps.get(map)
    if tone is None:
        return []
    level = np.zeros((*tone.shape[:2], 4), np.float32)
    level[..., :3] = without_alpha(tone) / np.float32(white(material.maps[map].dtype))
    levels = [level]
    while max(level.shape[:2]) > 1:
        level = _halve(level[np.newaxis])[0]
        levels.append(level)
    return [level.astype(np.float16) for level in levels]


def tone_mean(material: TextureTiles, map: str) -> tuple[float, ...]:
    """Red, green and blue below which a map's tone is a factor, as a share of white in sRGB; 0 for never."""
    if material.tone is None or map not in material.tone.maps:
        return (0.0, 0.0, 0.0)
    mean = without_alpha(material.tone.mean(map)) / white(material.maps[map].dtype)
    return tuple(float(value) for value in np.broadcast_to(mean, 3))


def check_map_name(material: TextureTiles, map: str | None) -> str:
    """A map's name, the main one by default."""
    return material.main if map is None else check_choice("map", map, tuple(material.maps))


def _encode(material: TextureTiles, name: str, base: NDArray[Any], values: Any, gutter: int) -> Mipmaps:
    """Pixels of every level from its values; the first is kept as it is."""
    kind, pixels = material.kinds[name], material.maps[name]
    normals = [n for n, k in material.kinds.items() if is_normal(k) and material.maps[n].shape[-1] > 2]
    bumps = values(normals[0]) if kind == "roughness" and normals else None
    levels: list[NDArray[Any]] = []
    clean, all_same = 0, True
    for k, (level, same) in enumerate(values(name)):
        if bumps is not None:
            level = level.copy()
            rough = without_alpha(level)
            rough += _spread(next(bumps)[0])
        all_same = all_same and same
        clean = k if all_same else clean
        levels.append(from_values(level, kind, pixels) if k else base)
    return Mipmaps(tuple(levels), gutter, clean)


def _spread(normals: Values) -> Values:
    """What normals of different directions add to the squared width of a lobe.

    A mean of unit vectors of length l stands for slopes of variance (1 - l) / l along each axis (Toksvig
    2005), and a lobe of width a^2 takes in twice that (Olano & Baker 2010, section 2).
    """
    length = np.sqrt((normals[..., :3] ** 2).sum(axis=-1, keepdims=True))
    # Rounding of the map's own pixels must not count.
    return np.where(length < 0.999, 2 * (1 - length) / np.maximum(length, 0.05), 0).astype(np.float32)


def _halve(level: Values) -> Values:
    """Means over 2 x 2 texels; by area where rows or columns are odd."""
    for axis in (1, 2):
        count = level.shape[axis]
        if count == 1:
            continue
        if count % 2 == 0:
            even, odd = (level[(slice(None),) * axis + (slice(start, None, 2),)] for start in (0, 1))
            level = (even + odd) * np.float32(0.5)
        else:
            level = np.moveaxis(np.tensordot(_area_weights(count), level, (1, axis)), 0, axis)
    return np.ascontiguousarray(level, np.float32)


def _area_weights(count: int) -> Values:
    """How much each of an odd number of texels counts in half as many, rounded down."""
    half = count // 2
    ratio = count / half
    low = np.arange(half)[:, None] * ratio
    overlap = np.minimum(low + ratio, np.arange(count) + 1) - np.maximum(low, np.arange(count))
    return (np.maximum(overlap, 0) / ratio).astype(np.float32)


def _lay(tiles: NDArray[Any], cells: NDArray[Any]) -> NDArray[Any]:
    """Tiles side by side, one layer."""
    rows, columns = cells.shape
    n = tiles.shape[1]
    picture = tiles[cells].swapaxes(1, 2)
    return np.ascontiguousarray(picture).reshape(1, rows * n, columns * n, -1)
