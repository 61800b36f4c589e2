"""Any tiling made dappled: the sweep where it can promise success, a solver for what is left."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_array, check_flag, shape_error
from tilewright.errors import TilewrightTypeError
from tilewright.seeds import check_seed
from tilewright.tilings.dappled.completing import mend
from tilewright.tilings.dappled.conditions import Cells, Conditions, Most
from tilewright.tilings.dappled.surgery import as_problem, rectify, refusal


def dapple(
    start: ArrayLike,
    limits: Mapping[str, Most] | Conditions,
    *,
    cyclic: bool = False,
    tiles: int | None = None,
    fixed: ArrayLike | None = None,
    seed: int = 0,
) -> Cells:
    """Make a tiling dappled that follows a given one; one that is dappled already comes back as it is.

    This is algorithm 1 of the paper where it applies (`rectify`). What it does not promise is left to a SAT
    solver that opens only the cells around runs that are still too long: rows and columns that close to
    rings, subsets of tiles, limits of 0 and 1, cells that must stay. For the fewest changes see
    `closest_dapple`.

    Parameters
    ----------
    start : array-like of int, shape (height, width)
        The tiling to begin with, tiles 0 to 255; sides up to 65,536 cells. `random_start` and
        `start_from_image` make some.
    limits : mapping of str to longest run, or Conditions
        Such as ``{"H0": 2, "V1": 2}``; see `Conditions`. Limits of 0 and 1 and subsets of tiles are allowed
        too.
    cyclic : bool, optional
        Whether rows and columns close to rings, so that the tiling can be repeated; default False.
    tiles : int, optional
        Number of tiles, 2 to 256; by default as many as ``limits`` and ``start`` hold.
    fixed : array-like of bool, shape (height, width), optional
        Cells that must keep their tile; by default none.
    seed : int, optional
        What the solver tries first where it is free, 0 to 2^64 - 1; default 0.

    Returns
    -------
    uint8 array, shape (height, width)
        The dappled tiling; ``array_tiling(free_tiles(n), cells, torus=cyclic)`` makes a `Tiling` of it, for
        signals of n tiles.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A tile or a number is out of range, or an array has another shape.
    Impossible
        No tiling meets the conditions (and has the fixed cells); this is proven.

    Notes
    -----
    Kaji et al. 2016, section 3, algorithm 1; rings with limits of 2 are of section 6 (1), subsets of (2).

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.dapple([[0, 0, 0, 0], [0, 0, 0, 0]], {"H0": 2, "V1": 2}).tolist()
    [[0, 0, 1, 0], [0, 0, 1, 0]]
    """
    check_flag("cyclic", cyclic)
    conditions, cells = as_problem(start, limits, tiles)
    seed = check_seed(seed)
    kept = as_fixed(fixed, cells)
    sweeps = not kept.any() and refusal(conditions, (cells.shape[0], cells.shape[1]), cyclic=False) is None
    if sweeps:
        cells = rectify(cells, conditions)
        if not cyclic:
            return cells
    return mend(cells, conditions, cyclic=cyclic, fixed=kept, seed=seed)


def as_fixed(fixed: ArrayLike | None, cells: Cells) -> NDArray[np.bool_]:
    """Cells that must stay, as a mask."""
    if fixed is None:
        return np.zeros(cells.shape, bool)
    kept = as_array("fixed", fixed)
    if kept.dtype != bool:
        raise TilewrightTypeError(
            f"must hold bools, not {kept.dtype}", argument="fixed", value=kept.dtype, allowed="bools"
        )
    if kept.shape != cells.shape:
        raise shape_error("fixed", kept.shape, cells.shape)
    return kept
