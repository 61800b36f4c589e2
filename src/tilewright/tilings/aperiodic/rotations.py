"""Tilings whose rows are rotations: a point goes round a circle; where it stands says which tile is there.

Positions on the circle are integers of 2^-256 turns. Most cells are decided by the upper 64 bits alone, in
arrays; the few that stand too close to a border for that are decided by all of them. So a cell is the same in
every window, however far away.
"""

from abc import abstractmethod
from bisect import bisect_right
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.tiles import TileSet
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import MixerHash
from tilewright.tilings.streams import ROTATIONS
from tilewright.tilings.tiling import Tiling

BITS = 256
TURN = 1 << BITS
_WORD_BITS = 64
_COLUMNS = 2**14
"""Cells in a stretch of a row; rounding grows along it, by up to one unit of 2^-64 turns at each."""


@dataclass(frozen=True)
class Row:
    """One row of a tiling: cell x stands at ``start + x step`` on the circle.

    Attributes
    ----------
    start, step : int
        In units of 2^-256 turns.
    borders : tuple of int
        Where each arc of the circle begins, ascending, the first at 0.
    tiles : tuple of int
        The tile that each arc stands for.
    """

    start: int
    step: int
    borders: tuple[int, ...]
    tiles: tuple[int, ...]

    def tile(self, x: int) -> int:
        """Tile of cell x, decided by all bits."""
        return self.tiles[bisect_right(self.borders, (self.start + x * self.step) % TURN) - 1]


class RotationTiling(Tiling):
    """A tiling of the endless plane by rows of rotations."""

    def __init__(self, tiles: TileSet, seed: int) -> None:
        self.tiles = tiles
        self.domain = Domain()
        self._hash = MixerHash(seed)
        self.index_of: dict[tuple[int, ...], int] = {
            tuple(slots): tile for tile, slots in enumerate(tiles.slots.tolist())
        }
        """Index of the tile with the given colors."""

    def drawn(self, number: int, below: int) -> int:
        """A number of the seed, from 0 up to ``below``, which is at most 2^384; ``number`` says which."""
        words = self._hash.words(ROTATIONS, np.arange(12), number).tolist()
        return sum(word << (32 * digit) for digit, word in enumerate(words)) * below >> 384

    @abstractmethod
    def row(self, y: int) -> Row:
        """Row y, from y alone."""

    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        for y, cells in enumerate(out, start[1]):
            row = self.row(y)
            for first in range(0, len(cells), _COLUMNS):
                _lay_row(row, start[0] + first, cells[first : first + _COLUMNS])


def _lay_row(row: Row, first: int, out: NDArray[np.int32]) -> None:
    shift = BITS - _WORD_BITS
    start, step = ((row.start + first * row.step) % TURN) >> shift, (row.step % TURN) >> shift
    borders = np.array([*(b >> shift for b in row.borders), 2**_WORD_BITS - 1], np.uint64)
    # uint64 arithmetic goes round just as the circle does.
    at = np.uint64(start) + np.arange(len(out), dtype=np.uint64) * np.uint64(step)
    arc = np.searchsorted(borders[:-1], at, side="right") - 1
    out[...] = np.array(row.tiles, np.int32)[arc]
    slack = np.uint64(len(out) + 1)
    near = (at - borders[arc] < slack) | (borders[arc + 1] - at < slack)
    for x in near.nonzero()[0].tolist():
        out[x] = row.tile(first + x)
