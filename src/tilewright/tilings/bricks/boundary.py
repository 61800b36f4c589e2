"""Brick walls in regions of the plane, with a given boundary."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, range_error
from tilewright.errors import TilewrightValueError
from tilewright.seeds import check_seed
from tilewright.showing import describe_record
from tilewright.tiles import TileSet
from tilewright.tiles.bricks import brick_tiles, number_bricks
from tilewright.tilings.bricks.endless import check_longest
from tilewright.tilings.bricks.from_dappled import as_cells
from tilewright.tilings.bricks.parts import Links, find_links, find_parts, lay_parts
from tilewright.tilings.tiling import ArrayTiling

_MOST_CELLS = 2**31 - 1
_ROUNDS = 4
"""How often a wall is shuffled: after that, lines that are too long are rare."""

Positions = NDArray[np.int8]


@dataclass(frozen=True)
class BrickRegion:
    """A brick wall in a region; made by `brick_region`.

    Attributes
    ----------
    tiles : TileSet
        The set of `brick_tiles`.
    cells : int32 array, shape (h, w)
        Index of the tile of each cell, -1 outside the region.
    horizontal : int8 array, shape (h + 1, w)
        Positions of the edges to the north of each cell and, in the last row, to the south; -1 at edges
        that belong to no cell.
    vertical : int8 array, shape (h, w + 1)
        Positions of the edges to the west of each cell and, in the last column, to the east; -1 as before.
    """

    tiles: TileSet
    cells: NDArray[np.int32]
    horizontal: Positions
    vertical: Positions

    __repr__ = describe_record

    @property
    def longest(self) -> tuple[int, int]:
        """Number of tiles that the longest line along a row traverses, and the longest along a column."""
        inside = self.cells >= 0
        down = inside & (self.horizontal[:-1] == self.horizontal[1:])
        return _longest_run(inside & ~down), _longest_run(down.T)

    def tiling(self) -> ArrayTiling:
        """Give the wall as a tiling, if the region is a whole rectangle.

        Returns
        -------
        ArrayTiling
            The rectangle, from cell (0, 0) on.

        Raises
        ------
        TilewrightValueError
            Some cells of the rectangle are outside the region.
        """
        if (self.cells < 0).any():
            raise TilewrightValueError(
                "the region is not a whole rectangle, which a tiling must be",
                advice="use its cells and edges",
            )
        return ArrayTiling(self.tiles, self.cells)


def brick_region(
    mask: ArrayLike,
    positions: int = 4,
    *,
    horizontal: ArrayLike | None = None,
    vertical: ArrayLike | None = None,
    seed: int = 0,
    longest: tuple[int, int] = (3, 3),
) -> BrickRegion:
    """Lay a random brick wall in any region, holes included, with any boundary; or tell why there is none.

    It takes time in proportion to the number of cells.

    Parameters
    ----------
    mask : array-like of bool, shape (h, w)
        The cells of the region. Parts that do not hang together are solved one by one.
    positions : int, optional
        Number of positions, 2 to 16, see `brick_tiles`; default 4.
    horizontal : array-like of int, shape (h + 1, w), optional
        Positions asked of the edges to the north of each cell and, in the last row, to the south; -1 where an
        edge is free, as all are by default. Edges inside the region may be asked for too, those that touch no
        cell are not looked at.
    vertical : array-like of int, shape (h, w + 1), optional
        Positions asked of the edges to the west of each cell and, in the last column, to the east; -1 where
        an edge is free, as all are by default.
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.
    longest : tuple of (int, int), optional
        The most tiles that a line should traverse, along rows and along columns, 1 to 64 each; default (3,
        3). Lines are kept this short wherever changing single bricks can do it; `BrickRegion.longest` tells
        how long they are.

    Returns
    -------
    BrickRegion
        The tile of each cell, and the positions of all edges.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        There is no such wall: the message names a part of the region and the reason. Or ``mask`` has no
        cells, or an array has a wrong shape or positions out of range.

    Notes
    -----
    Derouet-Jourdan, Kaji & Mizoguchi 2019 (A linear algorithm for Brick Wang tiling) solve the same problem;
    see ``parts.py`` for which boundaries can be met. The tiles are those of Kaji et al. 2016, section 4.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> mask = np.ones((6, 8), bool)
    >>> mask[2:4, 3:5] = False
    >>> wall = tw.brick_region(mask, seed=1)
    >>> wall.cells.shape, int((wall.cells < 0).sum())
    ((6, 8), 4)
    """
    tiles = brick_tiles(positions)
    n = tiles.colors[0]
    limits = check_longest(longest, 1, 64)
    rng = np.random.default_rng(check_seed(seed))
    inside = as_cells("mask", mask, "0 outside and 1 inside the region")
    if not inside.any():
        raise TilewrightValueError(
            "has no cells; expected at least one that is True",
            argument="mask",
            allowed="at least one that is True",
        )
    if inside.size > _MOST_CELLS:
        raise TilewrightValueError(
            f"has {inside.size} cells; allowed are up to 2^31 - 1",
            argument="mask",
            value=inside.size,
            allowed="up to 2^31 - 1",
        )
    h, w = inside.shape
    across = _as_positions("horizontal", horizontal, (h + 1, w), n)
    upright = _as_positions("vertical", vertical, (h, w + 1), n)
    links = find_links(inside, across, upright)
    lay_parts(find_parts(inside, links), links, across, upright, n, rng)
    _shuffle(inside, links, across, upright, n, limits, rng)
    return _as_region(tiles, inside, across, upright)


def _as_positions(name: str, given: ArrayLike | None, shape: tuple[int, int], n: int) -> Positions:
    if given is None:
        return np.full(shape, -1, np.int8)
    edges = as_integers(name, given)
    if edges.shape != shape:
        raise TilewrightValueError(
            f"has shape {edges.shape}; this mask needs {shape}", argument=name, value=edges.shape
        )
    if edges.min() < -1 or edges.max() >= n:
        raise range_error(name, edges, f"0 to {n - 1}, and -1 for free edges")
    return edges.astype(np.int8)


def _shuffle(
    inside: NDArray[np.bool_],
    links: Links,
    across: Positions,
    upright: Positions,
    n: int,
    limits: tuple[int, int],
    rng: np.random.Generator,
) -> None:
    """Lay every brick anew whose four edges are not given, several times; in place."""
    from tilewright.kernels.brick_regions import shuffle_bricks

    free = np.zeros_like(inside)
    free[1:, 1:] = links.east[:-1, :-1] & links.east[1:, :-1] & links.south[:-1, :-1] & links.south[:-1, 1:]
    for _ in range(_ROUNDS):
        words = rng.integers(0, 2**32, inside.shape, np.uint32)
        shuffle_bricks(inside, free, across, upright, n, *limits, words)


def _as_region(
    tiles: TileSet, inside: NDArray[np.bool_], across: Positions, upright: Positions
) -> BrickRegion:
    numbers = number_bricks(tiles.colors[0], across[:-1], upright[:, 1:], across[1:], upright[:, :-1])
    cells = np.where(inside, numbers, -1).astype(np.int32)
    touched = np.pad(inside, 1)
    across[~(touched[:-1, 1:-1] | touched[1:, 1:-1])] = -1
    upright[~(touched[1:-1, :-1] | touched[1:-1, 1:])] = -1
    for array in (cells, across, upright):
        array.setflags(write=False)
    return BrickRegion(tiles, cells, across, upright)


def _longest_run(lines: NDArray[Any]) -> int:
    """Length of the longest run of True along the rows."""
    edges = np.diff(np.pad(lines, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    starts, ends = np.nonzero(edges == 1)[1], np.nonzero(edges == -1)[1]
    return int((ends - starts).max(initial=0))
