"""Endless brick walls, evaluated anywhere, without long lines.

Derouet-Jourdan, Salvati & Jonchier 2019 (Generating Stochastic Wall Patterns On-the-fly with Wang Tiles)
bound the lines of such walls too; the method here is another. A hashed draughtboard of blocks is changed
at random, a bounded number of times and never so that a line becomes too long; see ``kernels/flips.py``.
Positions of edges are hashed block by block, see ``kernels/bricks.py``, except where there are two: then
all tilings come from a bit h at every lattice point. N is h(x, y) + h(x + 1, y) and W is
x + h(x, y) + h(x, y + 1), modulo 2, so that N and S, and E and W, differ by the sum of the bits around the
tile and by one more than that. A change of h at a point flips the classes of the four tiles around it.
"""

import os
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, type_error
from tilewright.errors import TilewrightValueError
from tilewright.tiles.bricks import brick_tiles
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import MixerHash
from tilewright.tilings.tiling import Tiling

_LONGEST = 8
"""Longer runs are rarer than one cell in 500 anyway; the kernels could hold 15."""
_ROUNDS, _ROUNDS_OF_TWO = {4: 8, 5: 4, 6: 3}, {4: 12, 5: 8, 6: 4, 7: 3}
"""How often to go over a wall, by the sum of the two limits: until cells of even and odd x or y can hardly
be told apart. Tight limits leave little freedom, and two positions less. For larger sums it is twice."""
_CHUNK_WORDS, _CHUNK_ROWS = 64, 512
"""What one thread fills in turn: words of 64 cells, and rows."""

Tiles = NDArray[np.int32]


class EndlessBrickTiling(Tiling):
    """An endless wall; made by `endless_brick_tiling`.

    Parameters
    ----------
    positions : int
        Number of positions, 2 to 16.
    seed : int
        Where chance begins, 0 to 2^64 - 1.
    longest : tuple of (int, int)
        No more tiles than that are traversed by one line along a row, and along a column, 2 to 8 each.

    Attributes
    ----------
    tiles : TileSet
        The set of `brick_tiles`.
    domain : Domain
        The plane.
    longest : tuple of (int, int)
        As given.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.
    """

    def __init__(self, positions: int, seed: int, longest: tuple[int, int]) -> None:
        self.tiles = brick_tiles(positions)
        self.longest = check_longest(longest, 2, _LONGEST)
        self.domain = Domain.plane(None)
        self._seed = MixerHash(seed).seed
        rounds = _ROUNDS_OF_TWO if positions == 2 else _ROUNDS
        self._rounds = rounds.get(sum(self.longest), 2)

    def _fill(self, start: tuple[int, ...], out: Tiles) -> None:
        (x, y), (height, width) = start, out.shape
        first, last = x >> 6, (x + width - 1) >> 6
        words, rows = range(first, last + 1, _CHUNK_WORDS), range(y, y + height, _CHUNK_ROWS)

        def lay(chunk: tuple[int, int]) -> None:
            row, word = chunk
            west, east = max(64 * word, x), min(64 * (word + _CHUNK_WORDS), x + width)
            south = min(row + _CHUNK_ROWS, y + height)
            out[row - y : south - y, west - x : east - x] = self._lay(west, row, east - west, south - row)

        with ThreadPoolExecutor(min(os.cpu_count() or 1, len(words) * len(rows))) as pool:
            list(pool.map(lay, product(rows, words)))

    def _lay(self, x: int, y: int, width: int, height: int) -> Tiles:
        """Tiles of a window, by one thread."""
        from tilewright.kernels.bricks import BLOCK, lay_chunk, lay_heights
        from tilewright.kernels.flips import grow_chunk

        out = np.empty((height, width), np.int32)
        n = self.tiles.colors[0]
        # Step 1: the words and rows that must be right, with those that lead to the window and an end more.
        first, words = (x >> 6) - 1, ((x + width - 1) >> 6) - (x >> 6) + 3
        top, bottom = y, y + height + 1
        if n > 2:
            top, bottom = (y // BLOCK - 1) * BLOCK, -(-(y + height) // BLOCK) * BLOCK
        # Step 2: classes, with margins on all sides.
        size, turns, slope = self._turns()
        steps = self._rounds * turns
        side, margin = (steps * (length + size - 1) + 1 for length in self.longest)
        side = -(-side // 64)
        classes, flips = np.empty((2, bottom - top + 2 * margin, words + 2 * side), np.uint64)
        start, flipping = (first - side, top - margin), (self._rounds, turns, slope)
        grow_chunk(*start, size, *self.longest, *flipping, self._seed, classes, flips)
        # Step 3: tiles.
        skip = x - 64 * first
        if n > 2:
            lay_chunk(classes, margin, side, first, top, y, skip, n, self._seed, out)
        else:
            lay_heights(flips, margin, side, first, top, skip, self._seed, out)
        return out

    def _turns(self) -> tuple[int, int, int]:
        """The side of the squares to be flipped, the number of turns, and the slope of points of one turn.

        Points have turn x + s y modulo the number of turns. Let r be the longer of the two limits. For
        single cells s = 1, and points of one turn in a row or column are r + 1 apart: no run holds both. If
        squares of 2 x 2 cells are flipped, those in rows and columns beside theirs count too. With s = r + 2
        and 2 r + 6 turns, points whose y (or x) differs by less than 2 have an x (or y) r + 2 apart.
        """
        longest = max(self.longest)
        return (2, 2 * longest + 6, longest + 2) if self.tiles.colors[0] == 2 else (1, longest + 1, 1)


def endless_brick_tiling(
    positions: int = 4, seed: int = 0, *, longest: tuple[int, int] = (3, 3)
) -> EndlessBrickTiling:
    """Make a random brick wall without end, any window of which is evaluated by itself.

    Parameters
    ----------
    positions : int, optional
        Number of positions, 2 to 16, where lines can cross the edges of tiles, see `brick_tiles`; default 4.
        With 2 positions and limits of 2 the wall keeps a trace of the draughtboard it is made from.
    seed : int, optional
        0 to 2^64 - 1; default 0. The tile of a cell depends on the cell and the seed only.
    longest : tuple of (int, int), optional
        The most tiles in a row that one horizontal line traverses, and the most in a column that one vertical
        line traverses, 2 to 8 each; default (3, 3). With equal limits half of the tiles are of either class;
        other limits favor the class with the wider one.

    Returns
    -------
    EndlessBrickTiling
        A tiling of the plane.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    The limits are the conditions H and V of Kaji et al. 2016, section 4. Derouet-Jourdan, Salvati & Jonchier
    2019 (Generating Stochastic Wall Patterns On-the-fly with Wang Tiles) make such walls too; the method here
    is another.

    Examples
    --------
    >>> import tilewright as tw
    >>> wall = tw.endless_brick_tiling(seed=4)
    >>> wall.indices(10**9, -7, 5, 3).shape
    (3, 5)
    """
    return EndlessBrickTiling(positions, seed, longest)


def check_longest(given: Any, low: int, high: int) -> tuple[int, int]:
    """The longest runs of tiles along rows and along columns."""
    if not isinstance(given, (tuple, list)):
        raise type_error("longest", given, "two numbers of tiles, along rows and along columns")
    if len(given) != 2:
        raise TilewrightValueError(
            f"has {len(given)} entries; expected 2, along rows and columns",
            argument="longest",
            value=len(given),
            allowed="2, along rows and columns",
        )
    along, down = (check_int("longest", length, low, high) for length in given)
    return along, down
