"""The best of many candidates: each point as far as can be found from those before (Mitchell 1991)."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count
from tilewright.samplers.grid import Grid, coarsen, look_around
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

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
            grid = _sort_points(domain, points, placed, size)
        # If no candidate was in the running, the next point is the best of all of them.
        everywhere = hits == 0
        last = placed + 1 if everywhere else size
        candidates = 0 if everywhere else times * placed
        threshold, spread, live, places, living, sizes, around = _find_far(domain, grid, placed, candidates)
        hits = _FEW
        while placed < last and hits >= _FEW:
            if progress is not None:
                progress(placed, n, "trying candidates")
            drawn, placed, living, hits = add_farthest(
                key, drawn, times, placed, min(last, placed + _BATCH), _FEW, threshold, spread, live, places,
                living, sizes, around, *grid,
            )  # fmt: skip
    return PointSet(points, domain, "best-candidate")


def _sort_points(box: Box, points: NDArray[np.float64], placed: int, size: int) -> tuple[Any, ...]:
    """A grid for up to ``size`` points that holds those placed, as the kernels take it."""
    from tilewright.kernels.darts import fill_grid

    side, extent = coarsen(box, 0.0, size), np.array(box.extent)
    grid = Grid.of(box, size, side * box.dimension**0.5, reach=_STEPS * side)
    fill_grid(points, placed, grid.heads, grid.after, grid.counts, extent)
    return points, grid.heads, grid.after, grid.counts, extent, box.torus, grid.offsets, grid.gaps


def _find_far(box: Box, grid: tuple[Any, ...], placed: int, candidates: int) -> tuple[Any, ...]:
    """The small cells that may have places far from all points, far enough for some of the candidates only.

    The answer is what the kernel takes: the least distance that counts, from the middle of a cell to its
    corners, the cells, their places in that list, how many they are, the number of cells along each axis and
    the offsets to those that a point may take off the list. Where there are few candidates all count.
    """
    from tilewright.kernels.candidates import measure_cells

    if candidates <= 2 * _MANY:
        none, around = np.empty(0, np.int32), np.empty((0, box.dimension), np.int64)
        return -1.0, 0.0, none, none, 0, np.ones(box.dimension, np.int64), around
    side = coarsen(box, 0.0, _CELLS_EACH * placed)
    sizes = np.array([max(1, int(e / side)) for e in box.extent])
    spread = float(np.linalg.norm(box.extent / sizes)) / 2
    distances = np.empty(sizes.prod())
    measure_cells(sizes, placed, *grid, distances)
    near = len(distances) - max(1, len(distances) * _MANY // candidates)
    threshold = float(np.partition(distances, near - 1)[near - 1])
    live = np.flatnonzero(distances + spread > threshold).astype(np.int32)
    places = np.full(len(distances), -1, np.int32)
    places[live] = np.arange(len(live))
    around, _ = look_around(box, sizes.tolist(), threshold)
    return threshold, spread, live, places, len(live), sizes, around
