"""Tiles that are made of smaller tiles of their own set, and points at every density from them."""

from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_real, check_type, shape_error
from tilewright.errors import TilewrightValueError
from tilewright.signals.points.point_tiles import PointTiles
from tilewright.tiles import TileSet

_RULES = 5000
"""Random rules for edges that are tried before giving up."""
_MOST_POINTS = 2**28


def find_children(tiles: TileSet, n: int, rng: np.random.Generator) -> NDArray[np.int32]:
    """For each Wang tile an arrangement of n x n tiles of the set, so that subdivided tilings are tilings.

    Each color of an edge becomes a sequence of n colors, by chance, the same on both sides of the edge (Kopf
    et al. 2006). Within this frame, each tile gets one of all admissible arrangements by chance.

    Returns
    -------
    int32 array, shape (T, n, n), y first.
    """
    horizontal, vertical = tiles.colors[:2]
    for _ in range(_RULES):
        rows, columns = (
            rng.integers(horizontal, size=(horizontal, n)),
            rng.integers(vertical, size=(vertical, n)),
        )
        found = []
        for north, east, south, west in tiles.slots.tolist():
            frame = (rows[north], columns[east], rows[south], columns[west])
            made = _arrange(tiles, tuple(tuple(side.tolist()) for side in frame), rng)
            if made is None:
                break
            found.append(made)
        else:
            return np.array(found)
    raise TilewrightValueError(
        f"is {n}; no rule was found by which each of {len(tiles)} tiles divides into {n} x {n}",
        argument="subdivision",
        value=n,
        advice="ask for a larger one or for fewer colors",
    )


Frame = tuple[tuple[int, ...], ...]
"""Colors of the edges N, E, S, W of an arrangement, from west to east and from north to south."""


def _arrange(tiles: TileSet, frame: Frame, rng: np.random.Generator) -> NDArray[np.int32] | None:
    """A random one of all arrangements in a frame; None if there is none."""
    north, east, south, west = frame
    n = len(north)
    slots = tiles.slots.tolist()
    fitting: dict[tuple[int, int], list[int]] = {}
    for tile, (at_north, _, _, at_west) in enumerate(slots):
        fitting.setdefault((at_north, at_west), []).append(tile)

    def next_state(tile: int, cell: int, above: tuple[int, ...]) -> tuple[tuple[int, ...], int] | None:
        """The colors below and beside the cells laid so far and one more; None if the frame forbids it."""
        y, x = divmod(cell, n)
        _, at_east, at_south, _ = slots[tile]
        if (x == n - 1 and at_east != east[y]) or (y == n - 1 and at_south != south[x]):
            return None
        return (*above[:x], at_south, *above[x + 1 :]), at_east

    @cache
    def count(cell: int, above: tuple[int, ...], beside: int) -> int:
        """How many ways there are to lay the cells from one on."""
        if cell == n * n:
            return 1
        y, x = divmod(cell, n)
        total = 0
        for tile in fitting.get((above[x], beside if x else west[y]), []):
            state = next_state(tile, cell, above)
            total += count(cell + 1, *state) if state else 0
        return total

    left = count(0, north, 0)
    if not left:
        return None
    # Lay the arrangement with a random number among all that there are.
    left = int(rng.integers(left))
    laid, above, beside = [], north, 0
    for cell in range(n * n):
        y, x = divmod(cell, n)
        for tile in fitting[above[x], beside if x else west[y]]:
            state = next_state(tile, cell, above)
            ways = count(cell + 1, *state) if state else 0
            if state and left < ways:
                break
            left -= ways
        assert state is not None
        laid.append(tile)
        above, beside = state
    return np.array(laid, np.int32).reshape(n, n)


def children_of(tiles: PointTiles) -> NDArray[np.int32]:
    """The arrangement of smaller tiles that each tile is made of, int32, shape (T, n, n)."""
    check_type("tiles", tiles, PointTiles, "PointTiles")
    if "children" not in tiles.figures:
        raise TilewrightValueError(
            f"were made by {tiles.method!r} and do not subdivide", argument="tiles", advice="kopf_tiles() do"
        )
    return np.array(tiles.figures["children"], np.int32)


def subdivide(children: NDArray[np.int32], cells: NDArray[np.int32]) -> NDArray[np.int32]:
    """Replace every cell of a tiling, shape (h, w), by its n x n smaller ones: shape (n h, n w)."""
    height, width = cells.shape
    n = children.shape[1]
    return children[cells].transpose(0, 2, 1, 3).reshape(n * height, n * width)


def recursive_points(tiles: PointTiles, cells: ArrayLike, density: float) -> NDArray[np.float64]:
    """Give points of any density over a tiling (Kopf, Cohen-Or, Deussen & Lischinski 2006).

    Cells are subdivided until their points suffice, and then give those of low rank. Raising the density only
    adds points; tiles of the same index hold the same points.

    Parameters
    ----------
    tiles : PointTiles
        Tiles that subdivide into tiles of their own set: ``make_point_tiles("kopf")``.
    cells : array-like of int, shape (height, width)
        Tile indices, as from ``direct(...).indices(...)``.
    density : float
        Points per cell, from 0 on; at most 2^28 points in all.

    Returns
    -------
    float64 array, shape (P, 2)
        Points in cells, x first: 0 <= x < width, 0 <= y < height.

    Raises
    ------
    TilewrightTypeError
        Something else than point tiles and numbers.
    TilewrightValueError
        Tiles that do not subdivide, indices that are not there, or a density out of range.
    """
    children = children_of(tiles)
    at = as_integers("cells", cells).astype(np.int32)
    if at.ndim != 2 or not at.size or at.min() < 0 or at.max() >= len(children):
        raise shape_error("cells", at.shape, f"tile indices 0 to {len(children) - 1} in rows and columns")
    wanted = check_real("density", density, 0, _MOST_POINTS / at.size)
    n = children.shape[1]
    scale = 1
    while wanted > tiles.density * scale**2:
        scale *= n
        at = subdivide(children, at)
    # How many points each tile gives: those whose rank is low enough.
    kept = tiles.ranks < wanted / (tiles.density * scale**2)
    before = np.concatenate([[0], np.cumsum(kept)])[tiles.starts]
    points = tiles.points[kept].astype(np.float64)
    flat = at.ravel()
    numbers = np.diff(before)[flat]
    # Numbers of the points, cell after cell.
    own = np.arange(numbers.sum()) - np.repeat(np.cumsum(numbers) - numbers, numbers)
    corners = np.stack(np.divmod(np.arange(at.size), at.shape[1])[::-1], axis=1)
    return (points[np.repeat(before[flat], numbers) + own] + np.repeat(corners, numbers, axis=0)) / scale
