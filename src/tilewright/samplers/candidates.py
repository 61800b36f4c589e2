"""The best of many candidates: each point as far as can be found from those before (Mitchell 1991)."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count
from tilewright.samplers.grid import Grid, coarsen, look_around
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

if TYPE_CHECKING:
    from tilewright.kernels.candidates import Far
    from tilewright.kernels.darts import Cells

_CELLS_EACH = 64.0
"""Small cells for each point, of which those far from all points are known."""
_STEPS = 4
"""How many cells far a grid looks around; only the widest gaps need more."""
_BATCH = 4096
_MANY, _FEW = 200, 24
"""Candidates in the running for a point, when the far cells are found anew and before that."""


def best_candidate(
    count: int,
    *,
    multiple: int = 1,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Take the best of many candidates for each point: as far as can be from those before.

    The point after the first n is the farthest from them among ``multiple`` n candidates: for 16,384 points
    134 million in all. The first n points are well spread for every n.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1.
    multiple : int, optional
        Candidates for each point before, 1 to 10^6; default 1. More make the distances more even.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        Nothing is promised about distances; the relative radius is about 0.72.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Mitchell 1991. Departs from the paper in drawing only those candidates, a few hundred for each point, that
    fall where they may win, so the time grows little faster than the number of points; the distribution is
    the same.
    """
    domain = check_box(box)
    n = check_count(count, 1200)
    times = check_int("multiple", multiple, 1, 10**6)
    from tilewright.kernels.candidates import add_farthest

    key = make_key(seed)
    points = np.empty((n, domain.dimension))
    drawn = placed = size = 0
    hits = _FEW
    while placed < n:
        if placed == size:  # a new grid whenever there are twice as many points
            size = min(n, max(8, 2 * placed))
            cells, gaps = _sort_points(domain, points, placed, size)
        # If no candidate was in the running, the next point is the best of all of them.
        everywhere = hits == 0
        last = placed + 1 if everywhere else size
        candidates = 0 if everywhere else times * placed
        far = _find_far(domain, cells, gaps, placed, candidates)
        living = len(far.live)
        hits = _FEW
        while placed < last and hits >= _FEW:
            if progress is not None:
                progress(placed, n, "trying candidates")
            until = min(last, placed + _BATCH)
            drawn, placed, living, hits = add_farthest(
                key, drawn, times, placed, until, _FEW, living, far, cells, gaps
            )
    return PointSet(points, domain, "best-candidate")


def _sort_points(
    box: Box, points: NDArray[np.float64], placed: int, size: int
) -> "tuple[Cells, NDArray[np.float64]]":
    """Cells for up to ``size`` points that hold those placed, and their squared distances from each other."""
    from tilewright.kernels.darts import fill_cells

    side = coarsen(box, 0.0, size)
    grid = Grid.of(box, size, side * box.dimension**0.5, reach=_STEPS * side)
    cells = grid.over(points)
    fill_cells(placed, cells)
    return cells, grid.gaps


def _find_far(box: Box, cells: "Cells", gaps: NDArray[np.float64], placed: int, candidates: int) -> "Far":
    """The small cells that may have places far from all points, far enough for some of the candidates only.

    Where there are few candidates all places count.
    """
    from tilewright.kernels.candidates import Far, measure_cells

    if candidates <= 2 * _MANY:
        none, around = np.empty(0, np.int32), np.empty((0, box.dimension), np.int64)
        return Far(-1.0, 0.0, none, none, np.ones(box.dimension, np.int64), around)
    side = coarsen(box, 0.0, _CELLS_EACH * placed)
    sizes = np.array([max(1, int(e / side)) for e in box.extent])
    spread = float(np.linalg.norm(box.extent / sizes)) / 2
    distances = np.empty(sizes.prod())
    measure_cells(sizes, placed, cells, gaps, distances)
    near = len(distances) - max(1, len(distances) * _MANY // candidates)
    threshold = float(np.partition(distances, near - 1)[near - 1])
    live = np.flatnonzero(distances + spread > threshold).astype(np.int32)
    places = np.full(len(distances), -1, np.int32)
    places[live] = np.arange(len(live))
    around, _ = look_around(box, sizes.tolist(), threshold)
    return Far(threshold, spread, live, places, sizes, around)
