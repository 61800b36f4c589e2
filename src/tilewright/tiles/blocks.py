"""Blocks of tiles that can occur in tilings of the plane, found by what cannot.

A block in a tiling of the plane goes on in every direction, in blocks that do so as well. Blocks that do not
are taken out until none is left to take; what remains holds all that occur, and maybe more. So what holds of
every block that remains holds of every tiling.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.tileset import TileSet, check_tiles
from tilewright.tiles.translations import count_pairs, join

LARGEST_BLOCK = 32
_MOST_BLOCKS = 2_000_000

Blocks = NDArray[np.int32]


def possible_blocks(tiles: TileSet, size: int, margin: int = 0) -> Blocks:
    """List blocks of tiles among which are all that occur in any tiling of the plane.

    Parameters
    ----------
    tiles : TileSet
        Square tiles of any shape.
    size : int
        Rows and columns of a block, 1 to 32.
    margin : int, optional
        The blocks listed are the middles of blocks with this number of further tiles on every side, 0 to 32;
        default 0. A wider margin leaves fewer blocks that do not occur, and takes longer.

    Returns
    -------
    int32 array, shape (B, size, size)
        Tile indices, in ascending order. There are none where the set cannot tile the plane and blocks of
        this size show it.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set, or a number that is not an integer.
    TilewrightValueError
        The tiles are not square, a number is out of range, or more than 2 million blocks are met on the way.

    Notes
    -----
    Blocks that do not go on in every direction are taken out until none is left to take, so what remains
    holds all that occur in tilings, and maybe more. Our own method.
    """
    if check_tiles("tiles", tiles).shape.dimension != 2:
        raise TilewrightValueError(
            f"must be square tiles, not {tiles.shape.name} ones",
            argument="tiles",
            value=tiles.shape.name,
            allowed="square tiles",
        )
    check_int("size", size, 1, LARGEST_BLOCK)
    check_int("margin", margin, 0, LARGEST_BLOCK)
    found: Blocks = np.arange(len(tiles), dtype=np.int32).reshape(-1, 1, 1)
    for grown in range(1, size + 2 * margin + 1):
        found = _prune(tiles, found)
        if grown < size + 2 * margin:
            found = _grow(tiles, found)[0]
    inside = slice(margin, margin + size)
    return np.unique(found[:, inside, inside], axis=0)


def drop_idle(tiles: TileSet, margin: int = 1, name: str | None = None) -> TileSet:
    """Take out of a set the tiles that occur in no tiling of the plane, as far as blocks show.

    The result has the same tilings, so it is aperiodic if ``tiles`` is.

    Parameters
    ----------
    tiles : TileSet
        Square tiles.
    margin : int, optional
        A tile stays if it is the middle of a possible block of 2 ``margin`` + 1 rows and columns; 0 to 32,
        default 1.
    name : str, optional
        What messages and files call the result; by default the name of ``tiles``.

    Returns
    -------
    TileSet
        The tiles that stay, in their order.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set, or a margin that is not an integer.
    TilewrightValueError
        No tile remains: the set does not tile the plane. Or the tiles are not square, or the margin is out of
        range.
    """
    kept = possible_blocks(tiles, 1, margin).ravel()
    if not len(kept):
        raise TilewrightValueError(f"no tile of the {tiles.name} set remains: it does not tile the plane")
    return ListedTileSet(tiles.shape, tiles.slots[kept], tiles.colors, tiles.name if name is None else name)


def match_along(tiles: TileSet, axis: int, before: NDArray[Any], after: NDArray[Any]) -> NDArray[np.bool_]:
    """Whether tiles may follow others along an axis."""
    far, near = _sides(tiles, axis)
    return (tiles.slots[before][:, far] == tiles.slots[after][:, near]).all(axis=1)


def _prune(tiles: TileSet, blocks: Blocks) -> Blocks:
    """Take out blocks that do not go on in all four diagonal directions, until all do."""
    while True:
        parts = _grow(tiles, blocks)[1]
        goes_on = np.all([np.isin(np.arange(len(blocks)), part) for part in parts], axis=0)
        if goes_on.all():
            return blocks
        blocks = blocks[goes_on]


def _grow(tiles: TileSet, blocks: Blocks) -> tuple[Blocks, list[NDArray[np.int64]]]:
    """Blocks of one tile more either way whose four parts are among ``blocks``, and which parts those are."""
    west, east = _following(tiles, 0, blocks.swapaxes(1, 2))
    strips = np.concatenate([blocks[west], blocks[east, :, -1:]], axis=2)
    north, south = _following(tiles, 1, strips)
    grown = np.concatenate([strips[north], strips[south, -1:]], axis=1)
    return grown, [west[north], east[north], west[south], east[south]]


def _following(tiles: TileSet, axis: int, blocks: Blocks) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Pairs of blocks that agree when one is moved by a tile along the blocks' first axis."""
    count = len(blocks)
    if blocks.shape[1] == 1:  # they do not overlap, but meet
        far, near = _sides(tiles, axis)
        slots = tiles.slots[blocks[:, 0]]
        sides = [np.concatenate([slots[..., k] for k in side], axis=1) for side in (far, near)]
    else:
        width = blocks.shape[2] * (blocks.shape[1] - 1)
        sides = [part.reshape(count, width) for part in (blocks[:, 1:], blocks[:, :-1])]
    numbers = np.unique(np.concatenate(sides), axis=0, return_inverse=True)[1].ravel()
    first, second = numbers[:count], numbers[count:]
    pairs = count_pairs(first, second)
    if pairs > _MOST_BLOCKS:
        raise TilewrightValueError(
            f"the {tiles.name} set has {pairs} blocks that may occur, more than {_MOST_BLOCKS}",
            advice="ask for smaller ones, or a smaller margin",
        )
    return join(first, second)


def _sides(tiles: TileSet, axis: int) -> tuple[list[int], list[int]]:
    """The slots of a tile that meet its next neighbor's along an axis, and those of the neighbor."""
    joint = tiles.shape.across(axis)
    return [far for far, _ in joint], [near for _, near in joint]
