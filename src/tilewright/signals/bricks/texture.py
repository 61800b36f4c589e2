"""Brick Wang tiles painted as textures: a wall for everything that takes texture tiles."""

from dataclasses import asdict, replace
from functools import partial
from math import isqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, check_type
from tilewright.errors import TilewrightValueError
from tilewright.seeds import check_seed
from tilewright.signals.bricks.edges import check_traversed, find_thinnest, place_positions
from tilewright.signals.bricks.painting import CHANCES, paint
from tilewright.signals.bricks.style import BrickStyle
from tilewright.signals.textures.texture_tiles import TextureTiles
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles

KINDS = {"color": "color", "height": "height", "normal": "normal-gl", "roughness": "roughness"}
"""The maps, and what they hold."""
_ALIKE = np.repeat([[0.0]] + [[0.5]] * (CHANCES - 1), 4, axis=1)
"""What the bricks of a tile are made of: noise goes on from one to the next."""
_LARGEST_SHEET = 65536
_FINE = 8
"""Lattice points along a tile from which on those next to its border are shared too."""


def brick_texture_tiles(
    tiles: TileSet, style: BrickStyle | None = None, *, tile_size: int = 128, seed: int = 0
) -> TextureTiles:
    """Paint a material over a set of brick Wang tiles (Kaji et al. 2016, section 4).

    Parameters
    ----------
    tiles : TileSet
        Wang tiles, each traversed by a line: W and E the same, or N and S; `brick_tiles` makes such a set.
    style : BrickStyle, optional
        How the bricks look; by default ``BrickStyle()``. Its ``variation`` does not count: a brick lies on
        many tiles, which know nothing of each other, so all bricks have one tone, with stains and grain. For
        bricks of different colors see `BrickField`.
    tile_size : int, optional
        Pixels along a tile, 32 to 1,024; default 128. Tiles are square, so bricks are as wide as high on
        average.
    seed : int, optional
        The same seed gives the same bytes; 0 to 2^64 - 1, default 0.

    Returns
    -------
    TextureTiles
        Maps ``color``, ``height``, ``normal`` and ``roughness``. The one source is a sheet of all tiles, and
        every pixel's origin its place there: there is no photograph.

    Raises
    ------
    TilewrightTypeError
        A set, style or number of another type.
    TilewrightValueError
        A tile that no line traverses, or a style with too much mortar for bricks of this size.

    Notes
    -----
    What tiles show where they meet depends on the color of the edge alone: noise is bound to lattices, of
    which points on a border, and of fine ones those next to it, are drawn for the edge and not for the tile.
    So noise goes on smoothly across borders, with its slopes.
    """
    check_traversed(check_tiles("tiles", tiles))
    check_type("style", style, (BrickStyle, type(None)), "a BrickStyle")
    style = replace(style or BrickStyle(), variation=0.0)
    size = check_int("tile_size", tile_size, 32, 1024)
    seed = check_seed(seed)
    places = [place_positions(count, size) for count in tiles.colors[:2]]
    look = style.fit(size, find_thinnest(places, (size, size)))
    painted = []
    for tile, slots in enumerate(tiles.slots):
        sides, index = _lay_bricks(places, slots, size)
        words = partial(_draw_words, tiles, seed, tile)
        painted.append(paint(index, sides, _ALIKE, words, style, look, (size, size), (size - 1, size - 1)))
    maps = {name: np.stack([tile[name] for tile in painted]) for name in KINDS}
    return _as_material(tiles, maps, {"method": "bricks", "seed": seed, "tile_size": size, **asdict(style)})


def _lay_bricks(
    places: list[NDArray[np.int64]], slots: NDArray[np.uint8], size: int
) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
    """The four bricks in which the corners of a tile lie, and which of them each pixel belongs to.

    Both for a picture with one more pixel around the tile; what is not on the tile is far away.
    """
    from tilewright.kernels.brick_drawing import fill_rectangles

    north, east, south, west = (int(places[n % 2][color]) for n, color in enumerate(slots))
    near, far = -size, 2 * size
    sides = 1 + np.array(
        [
            (near, near, north, west),
            (north, near, far, east),
            (near, west, south, far),
            (south, east, far, far),
        ]
    )
    index = np.zeros((size + 2, size + 2), np.int32)
    fill_rectangles(sides, index)
    return sides, index


def _draw_words(
    tiles: TileSet,
    seed: int,
    tile: int,
    octave: int,
    points: tuple[int, int],
    at: tuple[int, int, int, int],
) -> NDArray[np.uint32]:
    """`Words` of a tile: those at corners and edges are the same on all tiles that have them."""

    def draw(*key: int, shape: tuple[int, ...]) -> NDArray[np.uint32]:
        return np.random.default_rng([seed, octave, *key]).integers(2**32, size=shape, dtype=np.uint32)

    # The window begins a pixel before the tile, in the unit before.
    x, y = (at[axis] - points[axis] + np.arange(at[axis + 2]) for axis in (0, 1))
    (from_x, side_x), (from_y, side_y) = _find_sides(x, points[0]), _find_sides(y, points[1])
    north, east, south, west = tiles.slots[tile]
    upright = draw(1, shape=(tiles.colors[3], len(y), 3))[[east, west]]
    level = draw(2, shape=(tiles.colors[0], len(x), 3))[[south, north]]
    words = draw(3, tile, shape=(len(y), len(x)))
    on_x, on_y = np.flatnonzero(side_x), np.flatnonzero(side_y)
    words[:, on_x] = upright[side_x[on_x] - 1, :, from_x[on_x]].T
    words[on_y] = level[side_y[on_y] - 1, :, from_y[on_y]]
    words[np.ix_(on_y, on_x)] = draw(0, shape=(3, 3))[np.ix_(from_y[on_y], from_x[on_x])]
    return words


def _find_sides(at: NDArray[np.int64], points: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Which lattice coordinates are shared across a border, of ``points`` to a tile.

    Returns
    -------
    offset : from the border, -1, 0 or 1, counted from 0 on: 0, 1 or 2
    side : 1 at the far border (east, south), 2 at the near one (west, north), 0 elsewhere
    """
    reach = 1 if points >= _FINE else 0
    near, far = at <= reach, at >= points - reach
    side = np.where(near, 2, np.where(far, 1, 0))
    return np.where(near, at, np.where(far, at - points, 0)) + 1, side


def _as_material(tiles: TileSet, maps: dict[str, NDArray[Any]], recipe: dict[str, Any]) -> TextureTiles:
    """The material, and a sheet of all tiles as its source."""
    count, size = maps["color"].shape[:2]
    rows = max(n for n in range(1, isqrt(count) + 1) if count % n == 0)
    columns = count // rows
    if columns * size > _LARGEST_SHEET:
        raise TilewrightValueError(
            f"is {size}; the sheet of {columns} x {rows} tiles may have {_LARGEST_SHEET} pixels on a "
            f"side, so allowed are up to {_LARGEST_SHEET // columns}",
            argument="tile_size",
            value=size,
            allowed=f"up to {_LARGEST_SHEET // columns}",
        )
    sheet = {
        name: np.ascontiguousarray(pixels.reshape(rows, columns, size, size, -1).swapaxes(1, 2)).reshape(
            rows * size, columns * size, -1
        )
        for name, pixels in maps.items()
    }
    tile, y, x = np.indices((count, size, size))
    origins = np.stack([np.zeros_like(tile), tile // columns * size + y, tile % columns * size + x], axis=-1)
    return TextureTiles(tiles, maps, (sheet,), origins.astype(np.uint16), recipe, kinds=KINDS)
