"""The algorithms of Kaji et al. 2016: any tiling becomes dappled by local surgery, in one sweep."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from tilewright.errors import TilewrightValueError
from tilewright.tilings.dappled.conditions import NEVER, Cells, Conditions, Limit, Most, as_cells

_SMALL = 2**15
"""Up to this number of cells, waking threads takes longer than the sweep."""


def rectify(
    start: ArrayLike,
    limits: Mapping[str, Most] | Conditions,
    *,
    cyclic: bool = False,
    tiles: int | None = None,
) -> Cells:
    """Make a tiling dappled by the algorithms of the paper: local surgery, in one sweep.

    Algorithm 1 goes over cells by x + y and mends each that ends too long a run; a tiling that is dappled
    already comes back as it is. Algorithm 2 (``cyclic``) closes rows and columns to rings; it changes tilings
    that are dappled already.

    Parameters
    ----------
    start : array-like of int, shape (height, width)
        The tiling to begin with, tiles 0 to 255; sides up to 65,536 cells.
    limits : mapping of str to longest run, or Conditions
        Such as ``{"H0": 2, "V1": 2}``; see `Conditions`. They must be of single tiles.
    cyclic : bool, optional
        Whether rows and columns close to rings, so that the tiling can be repeated; default False.
    tiles : int, optional
        Number of tiles, 2 to 256; by default as many as ``limits`` and ``start`` hold.

    Returns
    -------
    uint8 array, shape (height, width)
        The dappled tiling, the same for any number of threads.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        Limits that the algorithm cannot meet: 0 or 1 with two tiles (remark 2.2), subsets; for ``cyclic``,
        limits that vary, limits of 2 other than in remark 3.4, fewer than 4 rows or columns.

    Notes
    -----
    Kaji et al. 2016, sections 2 and 3. For the two conditions H_a^p and V_b^q with a limit of 2 it follows
    remark 3.4, made right: the first two rows and columns alternate, f(m-2, 0) = a, and of each anti-diagonal
    the cell of the last column is visited last. (With the paper's order and its f(m-2, 0) = f(0, n-2),
    mending the cell before the last column can lengthen a run that the last column has closed already.)

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.rectify([[1, 1], [1, 1], [1, 1]], {"H0": 2, "V1": 2}).tolist()
    [[1, 1], [1, 1], [0, 0]]
    """
    conditions, cells = as_problem(start, limits, tiles)
    reason = refusal(conditions, (cells.shape[0], cells.shape[1]), cyclic=cyclic)
    if reason:
        raise TilewrightValueError(reason)
    from tilewright.kernels import dappling as d

    most_h, most_v = (conditions.table(axis, cells.shape) for axis in (0, 1))
    if cyclic:
        most_h = np.minimum(most_h, _ring(cells.shape[1], most_h))
        most_v = np.minimum(most_v, _ring(cells.shape[0], most_v))
    if not cyclic or min(most_h.min(), most_v.min()) > 2:
        sweep = d.dapple_cells if cells.size > _SMALL else d.dapple_few_cells
        sweep(d.BLOCK, conditions.tiles, most_h, most_v, d.RING if cyclic else d.PLAIN, cells)
        return cells
    _lay_bezel(cells, across=int(np.argmin(most_h[:, 0, 0])))
    closed = np.pad(cells, ((0, 2), (0, 2)), mode="wrap")
    d.dapple_bezel(most_h, most_v, closed)
    return np.ascontiguousarray(closed[:-2, :-2])


def as_problem(
    start: ArrayLike, limits: Mapping[str, Most] | Conditions, tiles: int | None
) -> tuple[Conditions, Cells]:
    """Conditions, and a tiling of as many tiles as both hold."""
    conditions = Conditions(limits, tiles)
    cells = as_cells("start", start, conditions.tiles if tiles is not None else 256)
    most = max(conditions.tiles, int(cells.max()) + 1)
    return Conditions(conditions, most), cells


def refusal(conditions: Conditions, shape: tuple[int, int], *, cyclic: bool) -> str | None:
    """Why the sweep cannot promise a dappled tiling under these conditions, or None."""
    if not conditions.is_single:
        return "rectify() takes conditions on single tiles; dapple() takes subsets too"
    least = min((int(limit.on(shape).min()) for limit in conditions.limits), default=NEVER)
    if least < (2 if conditions.tiles == 2 else 1):
        allowed = "from 2 on for two tiles (remark 2.2), from 1 on for more"
        return f"limits go down to {least}; rectify() needs limits {allowed}; dapple() takes all"
    if not cyclic:
        return None
    if min(shape) < 4:
        return (
            f"a cyclic tiling of {shape[1]} x {shape[0]} is too small for rectify(); dapple() takes any size"
        )
    if any(limit.on(shape).size > 1 for limit in conditions.limits):
        return "limits vary over cells; rectify() needs constant ones where cyclic; dapple() takes any"
    if least <= 2 and not is_remark(conditions.limits, conditions.tiles, shape):
        return (
            "limits go down to 2; cyclic rectify() needs limits from 3 on, or just one horizontal limit of "
            "one tile and one vertical limit of the other (remark 3.4); dapple() takes any"
        )
    return None


def is_remark(limits: tuple[Limit, ...], tiles: int, shape: tuple[int, int]) -> bool:
    """Whether the conditions are {H_a^p, V_b^q} with a, b the two tiles."""
    finite = [limit for limit in limits if int(limit.on(shape).min()) < NEVER]
    by_axis = {limit.axis: limit.tiles for limit in finite}
    return tiles == 2 and len(finite) == len(by_axis) == 2 and by_axis[0] != by_axis[1]


def _ring(size: int, most: np.ndarray) -> np.ndarray:
    """A ring of one tile is a run without end: a finite limit is at most one less than the ring."""
    return np.where(most < NEVER, size - 1, NEVER).astype(np.int32)


def _lay_bezel(cells: Cells, across: int) -> None:
    """Make the first two rows and columns alternate, following the tiling where they may (remark 3.4)."""
    column, row = cells[:, 0], cells[0]
    before_last = row.size - 2
    _alternate(column, keep=0)
    row[before_last] = across
    _alternate(row, keep=before_last)
    cells[:, 1], cells[1] = 1 - column, 1 - row


def _alternate(line: Cells, keep: int) -> None:
    """Make cells 2k and 2k + 1 differ, and in an odd ring the last from the first; cell ``keep`` stays."""
    for first in range(0, line.size - 1, 2):
        changed = first if first + 1 == keep else first + 1
        line[changed] = 1 - line[2 * first + 1 - changed]
    if line.size % 2:
        line[-1] = 1 - line[0]
