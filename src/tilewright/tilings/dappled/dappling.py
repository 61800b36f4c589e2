"""Any tiling made dappled: the sweep where it can promise success, a solver for what is left."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.errors import TilewrightTypeError, TilewrightValueError
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
    """A dappled tiling that follows a given one; one that is dappled already comes back as it is.

    Algorithm 1 of Kaji et al. 2016 where it applies (`rectify`). What it does not promise is left to a SAT
    solver that opens only the cells around runs that are still too long: rows and columns that close to
    rings, with limits of 2 as well (the paper's section 6 (1)); subsets of tiles (2); limits of 0 and 1;
    cells that must stay. For the fewest changes see `closest_dapple`.

    Parameters
    ----------
    start : array-like of int, shape (height, width)
        `random_start` and `start_from_image` make some.
    limits : mapping or Conditions
        Longest runs, such as ``{"H0": 2, "V1": 2}``; see `Conditions`.
    cyclic : bool
        Whether rows and columns close to rings, so that the tiling can be repeated.
    tiles : int, optional
        Number of tiles; by default as many as ``limits`` and ``start`` hold.
    fixed : array-like of bool, shape (height, width), optional
        Cells that must keep their tile.
    seed : int
        0 to 2^64 - 1: what the solver tries first where it is free.

    Returns
    -------
    uint8 array, shape (height, width)
        ``array_tiling(free_tiles(n), cells, torus=cyclic)`` makes a tiling of it, for signals of n tiles.

    Raises
    ------
    Impossible
        No tiling meets the conditions (and has the fixed cells); this is proven.
    """
    conditions, cells = as_problem(start, limits, tiles)
    check_seed(seed)
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
    try:
        kept = np.asarray(fixed)
    except ValueError:
        raise TilewrightValueError("fixed is not a table of equally long rows") from None
    if kept.dtype != bool:
        raise TilewrightTypeError(f"fixed must hold bools, not {kept.dtype}")
    if kept.shape != cells.shape:
        raise TilewrightValueError(f"fixed has shape {kept.shape}; expected {cells.shape}")
    return kept
