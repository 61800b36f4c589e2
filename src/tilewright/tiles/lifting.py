"""Whether tilings by a set with merged colors come from tilings by the original: checked by machine."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.tiles.blocks import LARGEST_BLOCK, Blocks, match_along, possible_blocks
from tilewright.tiles.merging import check_mapping
from tilewright.tiles.shape import CORNER
from tilewright.tiles.tileset import TileSet, check_tiles
from tilewright.tiles.translations import join


@dataclass(frozen=True)
class Lifting:
    """What `check_lifting` found; computed, not reviewed.

    Attributes
    ----------
    size : int
        Rows and columns of the blocks, as asked for.
    margin : int
        Their margin, as asked for.
    blocks : int
        Number of possible blocks of ``size`` x ``size`` tiles.
    unique : int
        Number of those that lift, and always with the same tile at the center.
    larger : int
        Number of possible blocks of one row and one column more.
    lifted : int
        Number of those that lift.
    """

    size: int
    margin: int
    blocks: int
    unique: int
    larger: int
    lifted: int

    @property
    def holds(self) -> bool:
        """Whether every tiling lifts: all blocks do, and every center in one way."""
        return self.unique == self.blocks and self.lifted == self.larger


def check_lifting(
    merged: TileSet, original: TileSet, mapping: ArrayLike, size: int = 3, margin: int = 0
) -> Lifting:
    """Find out whether every tiling by a set with merged colors comes from one by the original set.

    A block lifts if it is what merging makes of a block of original tiles. Let every possible block of n x n
    tiles lift with only one tile at its center, and every one of (n + 1) x (n + 1) tiles lift at all. Then
    give each tile of a tiling the center of its block: two neighbors' blocks lie in a larger one, whose lift
    holds both of theirs, so the tiles given match. If the original is aperiodic the merged set then is, too,
    provided that it tiles at all.

    Parameters
    ----------
    merged : TileSet
        Corner tiles, as from `merge_colors`; some may be missing.
    original : TileSet
        Corner tiles.
    mapping : array-like of int, shape (C,)
        The color of ``merged`` that each color of ``original`` has become.
    size : int, optional
        Rows and columns n of a block, odd, 1 to 31; default 3.
    margin : int, optional
        Further tiles around a block, 0 to 32, see `possible_blocks`; default 0.

    Returns
    -------
    Lifting
        How many blocks there are and how many of them lift; ``.holds`` says whether the claim does.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set, or numbers that are not integers.
    TilewrightValueError
        A set of other tiles, a mapping that does not fit, a size that is even or out of range, or too many
        blocks.

    Notes
    -----
    Our own; Lagae 2007, chapter 8, has no such test. What it finds of the sets of `aperiodic_tiles` has not
    been reviewed by others.
    """
    for name, tiles in (("merged", merged), ("original", original)):
        if check_tiles(name, tiles).shape is not CORNER:
            raise TilewrightValueError(
                f"must be a set of corner tiles, not of {tiles.shape.name} ones",
                argument=name,
                value=tiles.shape.name,
                allowed="a set of corner tiles",
            )
    mapping = check_mapping(mapping, original)
    if check_int("size", size, 1, LARGEST_BLOCK - 1) % 2 == 0:
        raise TilewrightValueError(
            f"is {size}; it must be odd, so that a block has a center",
            argument="size",
            value=size,
            allowed="odd, so that a block has a center",
        )
    above = merged.find(mapping[original.slots.astype(np.int64)])
    blocks, larger = (possible_blocks(merged, n, margin) for n in (size, size + 1))
    of, lifts = _lift(original, above, blocks)
    middle = size // 2
    centers = np.unique(np.stack([of, lifts[:, middle, middle]], axis=1), axis=0)
    unique = np.bincount(centers[:, 0], minlength=len(blocks)) == 1
    lifted = np.unique(_lift(original, above, larger)[0])
    return Lifting(size, margin, len(blocks), int(unique.sum()), len(larger), len(lifted))


def _lift(original: TileSet, becomes: NDArray[np.int64], blocks: Blocks) -> tuple[NDArray[np.int64], Blocks]:
    """All lifts of all blocks: the block of each, and its original tiles; cell by cell, row by row."""
    of = np.arange(len(blocks))
    lifts = np.empty(blocks.shape, np.int32)
    for y, x in np.ndindex(blocks.shape[1:]):
        row, tile = join(blocks[of, y, x].astype(np.int64), becomes)
        fits = np.ones(len(row), bool)
        if x:
            fits &= match_along(original, 0, lifts[row, y, x - 1], tile)
        if y:
            fits &= match_along(original, 1, lifts[row, y - 1, x], tile)
        of, lifts = of[row[fits]], lifts[row[fits]]
        lifts[:, y, x] = tile[fits]
    return of, lifts
