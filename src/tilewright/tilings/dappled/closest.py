"""The dappled tiling closest to a given one, by integer programming (Kaji et al. 2016, section 6 (3))."""

import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_int, check_progress, check_real
from tilewright.errors import Progress, TilewrightValueError
from tilewright.showing import describe_record
from tilewright.tilings.clauses import Undecided
from tilewright.tilings.dappled.completing import Impossible
from tilewright.tilings.dappled.conditions import NEVER, Cells, Conditions, Limit, Most, as_mapping
from tilewright.tilings.dappled.dappling import as_fixed, dapple
from tilewright.tilings.dappled.rules import open_strips
from tilewright.tilings.dappled.surgery import as_problem

WHOLE = 128 * 128
"""The most cells that are given to the solver at once."""
_WINDOW, _STEP = 96, 64

Totals = Mapping[int, int | tuple[int, int]]


@dataclass(frozen=True, eq=False)
class Closest:
    """A dappled tiling near a given one; made by `closest_dapple`.

    Attributes
    ----------
    tiling : uint8 array, shape (height, width)
        The tile of each cell.
    distance : int
        Number of cells that differ from the given tiling (Hamming distance).
    bound : int
        No dappled tiling differs in fewer cells; proven.
    """

    tiling: Cells
    distance: int
    bound: int

    __repr__ = describe_record

    @property
    def gap(self) -> int:
        """Number of cells between the distance and the bound; 0 where the tiling is proven closest."""
        return self.distance - self.bound


def closest_dapple(
    start: ArrayLike,
    limits: Mapping[str, Most] | Conditions,
    *,
    cyclic: bool = False,
    tiles: int | None = None,
    fixed: ArrayLike | None = None,
    totals: Totals | None = None,
    seconds: float | None = None,
    progress: Progress | None = None,
) -> Closest:
    """Find the dappled tiling that differs from a tiling in the fewest cells.

    Up to 128 x 128 cells the solver (HiGHS) sees all at once and proves that nothing is closer. Beyond, it
    improves the tiling of `dapple` window by window, and the bound is the sum of what disjoint windows need
    by themselves.

    Parameters
    ----------
    start : array-like of int, shape (height, width)
        The tiling to begin with, tiles 0 to 255; sides up to 65,536 cells.
    limits : mapping of str to longest run, or Conditions
        Such as ``{"H0": 2, "V1": 2}``; see `Conditions`. Limits of 0 and 1 and subsets of tiles are allowed
        too.
    cyclic : bool, optional
        Whether rows and columns close to rings, so that the tiling can be repeated; default False.
    tiles : int, optional
        Number of tiles, 2 to 256; by default one more than the largest that is named.
    fixed : array-like of bool, shape (height, width), optional
        Cells that must keep their tile; by default none.
    totals : mapping of int to int or (int, int), optional
        The number of cells, or the least and the most, that must hold a tile; for tilings of up to 128 x 128
        cells. By default any numbers may.
    seconds : float, optional
        After about this time, in seconds, stop, 0 to 10^9; by default never. The best tiling found until then
        comes with a gap, where there is one.
    progress : callable, optional
        Called as ``progress(done, total, what)`` from window to window; raise `Cancelled` from it to stop.

    Returns
    -------
    Closest
        The tiling, its distance, and a proven bound.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number out of range, an array of another shape, or totals for too many cells.
    Impossible
        No tiling meets the conditions; this is proven.
    Undecided
        The time was up before any was found.

    Notes
    -----
    Kaji et al. 2016, section 6 (3), and (6) for the totals. The paper names integer programming; the
    windows are ours.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> found = tw.closest_dapple(np.zeros((4, 6), int), {"H0": 2, "V1": 2})
    >>> found.distance, found.gap
    (8, 0)
    """
    conditions, cells = as_problem(start, limits, tiles)
    check_progress(progress)
    if seconds is not None:
        check_real("seconds", seconds, 0, 1e9)
    end = np.inf if seconds is None else time.monotonic() + seconds
    kept, wanted = as_fixed(fixed, cells), _as_totals(totals, conditions)
    if cells.size <= WHOLE or wanted:
        if cells.size > WHOLE:
            raise TilewrightValueError(
                f"were given for {cells.size} cells; they are for tilings of up to {WHOLE} cells",
                argument="totals",
            )
        problem = _Program(cells, ~kept, conditions, cyclic=cyclic, totals=wanted)
        tiling, bound = problem.solve(cells, end)
        return Closest(tiling, int((tiling != cells).sum()), bound)
    return _by_windows(cells, kept, conditions, cyclic, end, progress)


class _Program:
    """The integer program of the open cells of a tiling."""

    def __init__(
        self,
        tiling: Cells,
        open_: NDArray[np.bool_],
        conditions: Conditions,
        *,
        cyclic: bool,
        totals: dict[int, tuple[int, int]] | None = None,
    ) -> None:
        from scipy.sparse import coo_array

        self.tiling, self.open, self.tiles = tiling, open_, conditions.tiles
        self.count = int(open_.sum())
        place = np.full(tiling.size, -1)
        place[open_.ravel()] = np.arange(self.count)
        self.rows: list[NDArray[Any]] = []
        self.columns: list[NDArray[Any]] = []
        self.signs: list[NDArray[Any]] = []
        self.least: list[NDArray[Any]] = []
        self.most: list[NDArray[Any]] = []
        # Every strip holds at least one tile outside those of its condition.
        for inside, strips in open_strips(tiling, open_, conditions, cyclic=cyclic):
            self._add(place[strips], [t for t in range(self.tiles) if t not in inside], 1, np.inf)
        if self.tiles > 2:
            self._add(np.arange(self.count)[:, None], list(range(self.tiles)), 1, 1)
        for tile, (least, most) in (totals or {}).items():
            there = int((tiling[~open_] == tile).sum())
            self._add(np.arange(self.count)[None], [tile], least - there, most - there)
        if self.count and self.least:
            entries = (np.concatenate(self.signs), (np.concatenate(self.rows), np.concatenate(self.columns)))
            shape = (sum(map(len, self.least)), self.variables)
            self.matrix = coo_array(entries, shape=shape).tocsr()
            # HiGHS in SciPy 1.13 takes indices of 32 bits only.
            self.matrix.indices = self.matrix.indices.astype(np.int32)
            self.matrix.indptr = self.matrix.indptr.astype(np.int32)

    @property
    def variables(self) -> int:
        """One for each cell with two tiles (it holds tile 1), one for each cell and tile with more."""
        return self.count if self.tiles == 2 else self.count * self.tiles

    def _add(self, cells: NDArray[Any], tiles: list[int], least: float, most: float) -> None:
        """Rows: of the open cells in each row, how many hold one of the tiles."""
        first, count = sum(map(len, self.least)), len(cells)
        constant = 0.0
        if self.tiles == 2:
            columns, sign = cells, 1.0 if tiles == [1] else -1.0
            if tiles == [0]:
                constant = float(cells.shape[1])
            elif len(tiles) != 1:
                columns, constant = cells[:, :0], 0.0
        else:
            columns, sign = (cells[:, :, None] * self.tiles + np.array(tiles, int)).reshape(count, -1), 1.0
        self.rows.append(np.repeat(np.arange(first, first + count), columns.shape[1]))
        self.columns.append(columns.ravel())
        self.signs.append(np.full(columns.size, sign))
        self.least.append(np.full(count, least - constant))
        self.most.append(np.full(count, most - constant))

    def solve(self, wanted: Cells, end: float) -> tuple[Cells, int]:
        """The tiling closest to ``wanted`` in the open cells, and how many of them must differ at least."""
        from scipy.optimize import Bounds, LinearConstraint, milp

        if not self.count or not self.least:
            return self._solve_freely(wanted)
        given = wanted[self.open].astype(np.int64)
        if self.tiles == 2:
            cost, constant = 1.0 - 2.0 * given, float(given.sum())
        else:
            cost, constant = np.ones((self.count, self.tiles)), 0.0
            cost[np.arange(self.count), given] = 0
        options = {"mip_rel_gap": 0.0}
        if np.isfinite(end):
            options["time_limit"] = max(end - time.monotonic(), 0.01)
        rows = LinearConstraint(self.matrix, np.concatenate(self.least), np.concatenate(self.most))
        result = milp(
            cost.ravel(),
            constraints=rows,
            integrality=np.ones(self.variables),
            bounds=Bounds(0, 1),
            options=options,
        )
        if result.status == 2:
            raise Impossible("no tiling meets the conditions; this is proven")
        if result.x is None:
            raise Undecided("no tiling was found in the time given", advice="allow more seconds")
        values = np.rint(result.x).astype(np.int64)
        tiling = self.tiling.copy()
        tiling[self.open] = values if self.tiles == 2 else values.reshape(-1, self.tiles).argmax(axis=1)
        # Distances are whole numbers; the solver's bound is good to 1e-6.
        return tiling, max(0, int(np.ceil(result.mip_dual_bound + constant - 1e-4)))

    def _solve_freely(self, wanted: Cells) -> tuple[Cells, int]:
        """The same where no cell is open, or no rule is left: there is nothing to search."""
        if any(
            (least > 0).any() or (most < 0).any() for least, most in zip(self.least, self.most, strict=True)
        ):
            raise Impossible("no tiling meets the conditions; this is proven")
        tiling = self.tiling.copy()
        tiling[self.open] = wanted[self.open]
        return tiling, 0


def _by_windows(
    wanted: Cells,
    kept: NDArray[np.bool_],
    conditions: Conditions,
    cyclic: bool,
    end: float,
    progress: Progress | None,
) -> Closest:
    """Windows that overlap improve the tiling; windows that do not give the bound."""
    tiling = dapple(wanted, conditions, cyclic=cyclic, fixed=kept)
    height, width = wanted.shape
    steps = [(y, x) for y in range(0, height, _STEP) for x in range(0, width, _STEP)]
    parts = [(y, x) for y in range(0, height, _WINDOW) for x in range(0, width, _WINDOW)]
    bound = 0
    for done, (y, x) in enumerate(steps + parts):
        if progress is not None:
            progress(done, len(steps) + len(parts), "searching windows")
        if time.monotonic() > end:
            break
        window = np.ix_(range(y, min(y + _WINDOW, height)), range(x, min(x + _WINDOW, width)))
        if done < len(steps):
            open_ = np.zeros(wanted.shape, bool)
            open_[window] = ~kept[window]
            tiling = _improve(tiling, wanted, open_, conditions, cyclic, end)
        else:
            alone = _Program(
                wanted[window], ~kept[window], _inside(conditions, window, wanted.shape), cyclic=False
            )
            bound += alone.solve(wanted[window], end)[1]
    return Closest(tiling, int((tiling != wanted).sum()), bound)


def _improve(
    tiling: Cells, wanted: Cells, open_: NDArray[np.bool_], conditions: Conditions, cyclic: bool, end: float
) -> Cells:
    try:
        better, _ = _Program(tiling, open_, conditions, cyclic=cyclic).solve(wanted, end)
    except Undecided:
        return tiling
    return better if (better != wanted).sum() < (tiling != wanted).sum() else tiling


def _inside(conditions: Conditions, window: Any, shape: tuple[int, ...]) -> Conditions:
    """The conditions on a window by itself."""
    part = Conditions({}, conditions.tiles)
    part.limits = tuple(
        Limit(limit.axis, limit.tiles, np.broadcast_to(limit.on((shape[0], shape[1])), shape)[window])
        for limit in conditions.limits
    )
    return part


def _as_totals(totals: Totals | None, conditions: Conditions) -> dict[int, tuple[int, int]]:
    found = {}
    for tile, given in as_mapping("totals", totals).items():
        tile = check_int("a tile of totals", tile, 0, conditions.tiles - 1)
        least, most = given if isinstance(given, tuple) and len(given) == 2 else (given, given)
        least = check_int("least of totals", least, 0, NEVER)
        found[tile] = (least, check_int("most of totals", most, least, NEVER))
    return found
