"""Weighted sample elimination: many points by chance, of which the most crowded go (Yuksel 2015)."""

from math import ceil

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_real
from tilewright.errors import Progress, TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count
from tilewright.samplers.grid import Bins, look_around
from tilewright.samplers.point_set import PointSet
from tilewright.samplers.radius import max_radius
from tilewright.samplers.yardsticks import uniform
from tilewright.seeds import Seed

_POWER = 8.0
_LIMIT, _LIMIT_POWER = 0.65, 1.5
"""Beta and gamma of section 3.1: distances below beta (1 - (n / m)^gamma) of the reach weigh alike."""
_BATCH = 2**15


def sample_elimination(
    count: int,
    *,
    oversampling: float = 5.0,
    start: PointSet | ArrayLike | None = None,
    progressive: bool = False,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Choose exactly ``count`` points from more, taking away the most crowded one again and again.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1.
    oversampling : float, optional
        How many times as many random points to begin with, 1 up to 100; default 5. With 5 the relative radius
        is about 0.69, with 10 about 0.73.
    start : PointSet or array-like of float, shape (m, d), optional
        Points to choose from instead of random ones.
    progressive : bool, optional
        Whether the first n points are to be well spread for every n; default False, which leaves them in
        order of chance.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default that of ``start``, or the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        Nothing is promised about distances.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        ``start`` has too few points, or a number is out of range.

    Notes
    -----
    Yuksel 2015.
    """
    if box is None and isinstance(start, PointSet):
        box = start.box
    domain = check_box(box)
    factor = check_real("oversampling", oversampling, 1.0, 100.0)
    n = check_count(count, ceil(factor * (16 * domain.dimension + 40)))
    if start is None:
        points = uniform(ceil(n * factor), seed=seed, box=domain).points
    else:
        points = domain.check_points(start.points if isinstance(start, PointSet) else start)
        if len(points) < n:
            raise TilewrightValueError(
                f"is {n} but start has {len(points)} points to choose from only", argument="count", value=n
            )
    kept = np.arange(len(points))
    kept, _ = _eliminate(points, kept, n, domain, progress)
    if progressive:
        tail = []
        while len(kept) > 1:  # halve what is left; what goes last is the more important
            kept, gone = _eliminate(points, kept, len(kept) // 2, domain, progress)
            tail.append(gone)
        kept = np.concatenate([kept, *reversed(tail)])
    return PointSet(points[kept], domain, "elimination")


def _eliminate(
    points: NDArray[np.float64], kept: NDArray[np.int64], n: int, box: Box, progress: Progress | None
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Of the points ``kept``, the indices of n and of those taken away, the last one first."""
    from tilewright.kernels.elimination import Crowding, Sorted, eliminate, start_heap, weigh_points

    m = len(kept)
    reach = 2 * max_radius(n, box)
    least = reach * _LIMIT * (1 - (n / m) ** _LIMIT_POWER)
    bins = Bins.of(points[kept], box, reach, 1.0)
    offsets, _ = look_around(box, bins.counts.tolist(), reach)
    extent = np.array(box.extent)
    there = Sorted(points[kept][bins.order], bins.starts, bins.counts, offsets, extent, box.torus)
    crowding = Crowding(reach, least, _POWER)
    weights, heap, places = np.empty(m), np.empty(m, np.int32), np.empty(m, np.int32)
    weigh_points(there, crowding, weights)
    start_heap(weights, heap, places)
    for size in range(m, n, -_BATCH):
        if progress is not None:
            progress(m - size, m - n, "eliminating points")
        eliminate(there, crowding, weights, heap, places, size, max(n, size - _BATCH))
    return np.sort(kept[bins.order[heap[:n]]]), kept[bins.order[heap[n:]]]
