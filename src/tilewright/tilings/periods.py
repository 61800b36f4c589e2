"""Periodic tilings of any set: the smallest torus it tiles, or a proof that it tiles none up to a size."""

import time

from tilewright.checks import check_int, check_progress, check_real
from tilewright.errors import Progress
from tilewright.seeds import check_seed
from tilewright.tiles import TileSet
from tilewright.tilings.clauses import Clauses, Undecided, need_solver
from tilewright.tilings.filling import add_tiling, check_square, read_tiling
from tilewright.tilings.tiling import ArrayTiling

_LONGEST = 64


def periodic_tiling(
    tiles: TileSet,
    width: int,
    height: int,
    *,
    seed: int = 0,
    seconds: float | None = None,
    progress: Progress | None = None,
) -> ArrayTiling | None:
    """Find the smallest torus that a set tiles, or prove that it tiles none up to a size.

    Parameters
    ----------
    tiles : TileSet
        Wang tiles, corner tiles or corner-coded ones.
    width : int
        Cells along x of the largest torus that is tried, 1 to 64.
    height : int
        Cells along y of the largest torus that is tried, 1 to 64.
    seed : int, optional
        Which of its tilings, where there are several, 0 to 2^64 - 1; default 0.
    seconds : float, optional
        After about this time in all, in seconds, give up, 0 to 10^9; by default never.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    ArrayTiling or None
        Of the torus with the fewest cells, the least wide of several; as a tiling of the plane it has its
        sides as periods. None where it is proven that the set tiles no torus up to that size, which an
        aperiodic set never does.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The tiles are not square, or a number is out of range.
    Undecided
        The time was up; the message says which sizes are left.

    Notes
    -----
    Our own; Lagae 2007, section 2.2, defines periods.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.periodic_tiling(tw.aperiodic_tiles("lagae-44"), 3, 3).domain.periods
    (2, 3)
    """
    check_square(tiles)
    seed = check_seed(seed)
    check_progress(progress)
    check_int("width", width, 1, _LONGEST)
    check_int("height", height, 1, _LONGEST)
    if seconds is not None:
        check_real("seconds", seconds, 0, 1e9)
    need_solver()
    sizes = sorted(((w, h) for w in range(1, width + 1) for h in range(1, height + 1)), key=_size)
    end = None if seconds is None else time.monotonic() + seconds
    for done, (w, h) in enumerate(sizes):
        if progress is not None:
            progress(done, len(sizes), f"torus of {w} x {h}")
        formula = Clauses()
        chosen = add_tiling(formula, tiles, (h, w), torus=True)
        try:
            values = formula.solve(seconds=_left(end), seed=seed)
        except Undecided:
            raise Undecided(
                f"no answer for a torus of {w} x {h} cells after {seconds:.0f} seconds; none smaller is tiled"
            ) from None
        if values is not None:
            return ArrayTiling(tiles, read_tiling(values, chosen), torus=True)
    return None


def _left(end: float | None) -> float | None:
    """Seconds until a time; where that is past, an end of the search."""
    if end is None:
        return None
    left = end - time.monotonic()
    if left < 0:
        raise Undecided
    return left


def _size(size: tuple[int, int]) -> tuple[int, int]:
    return size[0] * size[1], size[0]
