"""A brick wall from a dappled tiling (Kaji et al. 2016, section 4, steps 1 and 2)."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_array, as_integers, range_error, shape_error
from tilewright.errors import TilewrightValueError
from tilewright.tiles.bricks import brick_tiles, number_bricks
from tilewright.tilings.hashes import MixerHash
from tilewright.tilings.streams import BRICK_EDGES
from tilewright.tilings.tiling import ArrayTiling

_STEPS, _FIRST, _WIDE, _NARROW = 8, (9, 10), (11, 12), (13, 14)
"""Layers of the stream: steps at cells; and for rows and columns each the first colors, and steps before the
last around a torus, of n - 1 and of n - 2."""

Integers = NDArray[np.int32]


def brick_tiling(
    classes: ArrayLike, positions: int = 4, seed: int = 0, *, torus: bool = False
) -> ArrayTiling:
    """Lay a brick wall whose tiles have given classes; edges are random otherwise, also at the boundary.

    An edge is carried on across an H tile along the row and across a V tile along the column, and followed
    by a random other one across the rest.

    Parameters
    ----------
    classes : array-like of int, shape (height, width)
        0 for H tiles, traversed along the row, 1 for V tiles, traversed along the column. A dappled tiling
        with the conditions H_0^p and V_1^q gives a wall whose lines traverse at most p tiles along rows and
        q along columns.
    positions : int, optional
        Number of positions, 2 to 16, see `brick_tiles`; default 4.
    seed : int, optional
        0 to 2^64 - 1; default 0. Without ``torus``, an array that continues another to the east and south
        gives a wall that does, too.
    torus : bool, optional
        Whether the wall goes on periodically; default False. Around a torus, the edges of a row change at its
        V tiles and must return to where they began. That is possible unless there is one V tile, or with 2
        positions an odd number of them; and the same holds for the H tiles of a column.

    Returns
    -------
    ArrayTiling
        The wall, from cell (0, 0) on, or the torus.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        ``classes`` is empty, not two-dimensional or holds something but 0 and 1, or no wall closes around
        the torus; the message names the row or column.

    Notes
    -----
    Kaji et al. 2016, section 4, steps 1 and 2.

    Examples
    --------
    >>> import tilewright as tw
    >>> classes = tw.dapple(tw.random_start(8, 6, seed=1), {"H0": 2, "V1": 2})
    >>> tw.brick_tiling(classes, seed=1).tiles
    <TileSet bricks-4: 96 wang tiles, colors (4, 4, 4, 4)>
    """
    tiles = brick_tiles(positions)
    n = tiles.colors[0]
    hash = MixerHash(seed)
    vertical_tiles = as_cells("classes", classes, "0 for H tiles and 1 for V tiles")
    x, y = (np.arange(size, dtype=np.int64) for size in reversed(vertical_tiles.shape))
    # A step is added to an edge where it changes; at each tile one does.
    steps = 1 + hash.grid(n - 1, BRICK_EDGES, x, y, np.array([_STEPS]))[0].astype(np.int32)
    rows, columns = np.where(vertical_tiles, steps, 0), np.where(vertical_tiles, 0, steps).T
    if torus:
        _close(rows, n, hash, 0)
        _close(columns, n, hash, 1)
    vertical = _walk(_draw(hash, n, len(y), _FIRST[0]), rows, n)
    horizontal = _walk(_draw(hash, n, len(x), _FIRST[1]), columns, n).T
    cells = number_bricks(n, horizontal[:-1], vertical[:, 1:], horizontal[1:], vertical[:, :-1])
    return ArrayTiling(tiles, cells, torus=torus)


def as_cells(name: str, given: ArrayLike, meaning: str) -> NDArray[np.bool_]:
    """A rectangle of cells, each 0 or 1."""
    cells = as_array(name, given)
    if cells.dtype != bool:
        cells = as_integers(name, given)
    if cells.ndim != 2 or not cells.size:
        raise shape_error(name, cells.shape, "(height, width), not empty")
    if cells.min() < 0 or cells.max() > 1:
        raise range_error(name, cells, meaning)
    return cells.astype(bool)


def _draw(hash: MixerHash, count: int, size: int, layer: int) -> Integers:
    """A random number below ``count`` for each of ``size`` lines."""
    grid = hash.grid(
        count, BRICK_EDGES, np.arange(size, dtype=np.int64), np.zeros(1, np.int64), np.array([layer])
    )
    return grid[0, 0].astype(np.int32)


def _walk(first: Integers, steps: Integers, n: int) -> Integers:
    """Colors of the edges along lines, shape (lines, cells + 1)."""
    return np.cumsum(np.column_stack([first, steps]), axis=1, dtype=np.int32) % n


def _close(steps: Integers, n: int, hash: MixerHash, axis: int) -> None:
    """Choose the last two steps of each line so that all add up to 0 modulo n; in place."""
    counts = (steps > 0).sum(axis=1)
    _check_counts(counts, n, axis)
    lines = np.flatnonzero(counts)
    last, before = _take_last(steps, lines), _take_last(steps, lines)
    # Step 1: the step before the last, which must leave a step to go.
    left = -steps[lines].sum(axis=1) % n
    step = 1 + _draw(hash, n - 1, len(steps), _WIDE[axis])[lines]
    if n > 2:
        narrow = 1 + _draw(hash, n - 2, len(steps), _NARROW[axis])[lines]
        step = np.where(left, narrow + (narrow >= left), step)
    # Step 2: the last.
    steps[lines, before] = step
    steps[lines, last] = (left - step) % n


def _take_last(steps: Integers, lines: NDArray[np.int64]) -> NDArray[np.int64]:
    """Where the last step of each line is; it is set to 0."""
    last = steps.shape[1] - 1 - np.argmax(steps[lines, ::-1] > 0, axis=1)
    steps[lines, last] = 0
    return last


def _check_counts(counts: NDArray[np.int64], n: int, axis: int) -> None:
    wrong = (counts == 1) | ((counts % 2 == 1) if n == 2 else False)
    if not wrong.any():
        return
    line = int(np.argmax(wrong))
    where, tile = (("row", "V"), ("column", "H"))[axis]
    if counts[line] == 1:
        raise TilewrightValueError(
            f"{where} {line} of classes has one {tile} tile, where its edges change and nowhere change back; "
            "a torus needs none of them or several"
        )
    raise TilewrightValueError(
        f"{where} {line} of classes has {counts[line]} {tile} tiles; around a torus 2 positions need an "
        f"even number of them in every {where}",
        advice="take 3 positions or more",
    )
