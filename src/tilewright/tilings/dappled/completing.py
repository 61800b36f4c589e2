"""Dappled tilings by a solver: any conditions, any boundary; a solution, or the proof that there is none."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_flag, check_int, check_progress, shape_error, type_error
from tilewright.errors import Progress, TilewrightValueError
from tilewright.seeds import check_seed
from tilewright.tilings.clauses import Clauses, need_solver
from tilewright.tilings.dappled.conditions import (
    Cells,
    Conditions,
    Most,
    as_cells,
)
from tilewright.tilings.dappled.rules import write_formula

_SHOWN = 8
_MOST_WRITTEN = 2**23
_NEAR = 4
"""How far around a run that is too long cells are opened at first, beyond the run itself."""


class Impossible(TilewrightValueError):
    """It is proven that no tiling meets the conditions."""


def complete_dapple(
    partial: ArrayLike,
    limits: Mapping[str, Most] | Conditions,
    *,
    cyclic: bool = False,
    tiles: int | None = None,
    seed: int = 0,
    seconds: float | None = None,
    progress: Progress | None = None,
) -> Cells:
    """Extend a partial tiling to a dappled one, or prove that it has none.

    Parameters
    ----------
    partial : array-like of int, shape (height, width)
        The tiles of pinned cells, -1 where any may be.
    limits : mapping of str to longest run, or Conditions
        Such as ``{"H0": 2, "V1": 2}``; see `Conditions`. Limits of 0 and 1 and subsets of tiles are allowed
        too.
    cyclic : bool, optional
        Whether rows and columns close to rings, so that the tiling can be repeated; default False.
    tiles : int, optional
        Number of tiles, 2 to 256; by default one more than the largest that is named.
    seed : int, optional
        0 to 2^64 - 1; default 0. Different seeds find different tilings.
    seconds : float, optional
        After about this time, in seconds, give up, 0 to 10^9; by default never.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    uint8 array, shape (height, width)
        A dappled tiling that has the pinned tiles.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number out of range, or an array of another shape.
    Impossible
        There is none; the message names pins that contradict each other, none of them superfluous.
    Undecided
        The time was up.

    Notes
    -----
    Kaji et al. 2016, section 6 (7), by a SAT solver.

    Examples
    --------
    >>> import tilewright as tw
    >>> partial = [[0, -1, -1], [-1, 1, -1]]
    >>> full = tw.complete_dapple(partial, {"H0": 2, "V1": 2})
    >>> full.shape, int(full[0, 0]), int(full[1, 1])
    ((2, 3), 0, 1)
    """
    check_flag("cyclic", cyclic)
    conditions = Conditions(limits, tiles)
    seed = check_seed(seed)
    check_progress(progress)
    cells = as_cells("partial", partial, conditions.tiles if tiles is not None else 256, free=True)
    conditions = Conditions(conditions, max(conditions.tiles, int(cells.max()) + 1))
    need_solver()
    formula = write_formula(cells, cells < 0, conditions, cyclic=cyclic)
    values = formula.clauses.solve(seed=seed, seconds=seconds, progress=progress)
    if values is None:
        raise Impossible(_explain(cells, conditions, cyclic))
    cells[cells < 0] = formula.tiles_of(values)
    return cells.astype(np.uint8)


def _explain(cells: NDArray[Any], conditions: Conditions, cyclic: bool) -> str:
    """Which pins cannot hold together."""
    everywhere = np.ones(cells.shape, bool)
    formula = write_formula(cells, everywhere, conditions, cyclic=cyclic)
    pinned = np.argwhere(cells >= 0)
    literals = formula.variables[(cells >= 0).ravel(), cells[cells >= 0]]
    core = set(formula.clauses.conflict(literals) or [])
    kind = "cyclic tiling" if cyclic else "tiling"
    size = f"{cells.shape[1]} x {cells.shape[0]}"
    if not core:
        whatever = ", whatever is pinned" if len(pinned) else ""
        return f"no {kind} of {size} cells meets the conditions{whatever}; this is proven"
    guilty = [at for at, literal in zip(pinned, literals.tolist(), strict=True) if literal in core]
    shown = ", ".join(f"(x={x}, y={y}) = {cells[y, x]}" for y, x in guilty[:_SHOWN])
    more = f" and {len(guilty) - _SHOWN} more" if len(guilty) > _SHOWN else ""
    return f"no {kind} of {size} cells has these pins together: {shown}{more}; this is proven"


def mend(
    start: Cells,
    conditions: Conditions,
    *,
    cyclic: bool,
    fixed: NDArray[np.bool_],
    seed: int,
) -> Cells:
    """Make a tiling dappled by opening cells around what is violated, and more of them where that fails.

    A tiling that is dappled comes back as it is. Whatever the conditions, the end is a dappled tiling or the
    proof that there is none.
    """
    cells, near = start.copy(), _NEAR
    bad = _too_long(cells, conditions, cyclic)
    while bad.any():
        open_ = _grow(bad, near, cyclic) & ~fixed
        formula = write_formula(cells, open_, conditions, cyclic=cyclic)
        values = formula.clauses.solve(prefer=formula.literals(cells), seed=seed)
        if values is not None:
            cells[open_] = formula.tiles_of(values)
            return cells
        if near > max(cells.shape):
            raise Impossible(_explain(np.where(fixed, cells, np.int16(-1)), conditions, cyclic))
        near *= 2
    return cells


def _too_long(cells: Cells, conditions: Conditions, cyclic: bool) -> NDArray[np.bool_]:
    """Every cell of every strip that is too long."""
    bad = np.zeros(cells.size, bool)
    flat = cells.ravel()
    for limit, strips in conditions.windows((cells.shape[0], cells.shape[1]), cyclic=cyclic):
        bad[strips[np.isin(flat, limit.tiles)[strips].all(axis=1)]] = True
    return bad.reshape(cells.shape)


def _grow(bad: NDArray[np.bool_], near: int, cyclic: bool) -> NDArray[np.bool_]:
    """Cells within ``near`` of the marked ones along both axes."""
    from scipy.ndimage import maximum_filter

    return maximum_filter(bad, size=2 * near + 1, mode="wrap" if cyclic else "constant")


def dapple_formula(
    shape: tuple[int, int],
    limits: Mapping[str, Most] | Conditions,
    *,
    cyclic: bool = False,
    partial: ArrayLike | None = None,
    tiles: int | None = None,
) -> Clauses:
    """Write the conditions as a formula for a SAT solver; ``.dimacs()`` of the result is its file.

    With two tiles, variable 1 + y w + x says that cell (x, y) holds tile 1; with T tiles, variable
    1 + (y w + x) T + t says that it holds tile t, and more variables follow. Pins are clauses of one literal.

    Parameters
    ----------
    shape : tuple of (int, int)
        Height and width, 1 to 65,536; height, width and the number of tiles multiply to 2^23 at most.
    limits : mapping of str to longest run, or Conditions
        Such as ``{"H0": 2, "V1": 2}``; see `Conditions`. Limits of 0 and 1 and subsets of tiles are allowed
        too.
    cyclic : bool, optional
        Whether rows and columns close to rings, so that the tiling can be repeated; default False.
    partial : array-like of int, shape (height, width), optional
        The tiles of pinned cells, -1 where any may be; by default any may be anywhere.
    tiles : int, optional
        Number of tiles, 2 to 256; by default one more than the largest that is named.

    Returns
    -------
    Clauses
        The formula in conjunctive normal form.

    Raises
    ------
    TilewrightTypeError
        The shape is not a pair, or another argument is of a wrong type.
    TilewrightValueError
        The shape is out of range, or the pins are of another shape.

    Notes
    -----
    Kaji et al. 2016, section 6 (8).
    """
    conditions = Conditions(limits, tiles)
    if not isinstance(shape, (tuple, list)) or len(shape) != 2:
        raise type_error("shape", shape, "(height, width)")
    shape = (check_int("height", shape[0], 1, 65536), check_int("width", shape[1], 1, 65536))
    if shape[0] * shape[1] * conditions.tiles > _MOST_WRITTEN:
        raise TilewrightValueError(
            f"{shape[1]} x {shape[0]} cells with {conditions.tiles} tiles are too many for a formula; "
            "allowed are 2^23 choices of a tile for a cell"
        )
    cells = np.full(shape, -1, np.int16)
    made = write_formula(cells, np.ones(shape, bool), conditions, cyclic=cyclic)
    if partial is not None:
        pins = as_cells("partial", partial, conditions.tiles, free=True)
        if pins.shape != shape:
            raise shape_error("partial", pins.shape, shape)
        made.clauses.add(made.variables[(pins >= 0).ravel(), pins[pins >= 0]][:, None])
    return made.clauses
