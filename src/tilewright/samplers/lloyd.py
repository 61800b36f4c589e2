"""Lloyd's relaxation: every point moves to the middle of its Voronoi cell, again and again.

Lloyd 1982; McCool & Fiume 1992; Lagae 2007, section 6.5.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_int
from tilewright.errors import Progress, TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count, check_distance
from tilewright.samplers.grid import Bins
from tilewright.samplers.point_set import PointSet
from tilewright.samplers.relaxation import relaxation_darts
from tilewright.seeds import Seed


def lloyd_relaxation(
    count: int | None = None,
    rho: float | None = None,
    *,
    iterations: int | None = None,
    start: PointSet | ArrayLike | None = None,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Move points to the middle of their Voronoi cells, again and again, until they are far enough apart.

    Parameters
    ----------
    count : int, optional
        Number of points, 1 to 2^31 - 1; may be left out where ``start`` is given.
    rho : float, optional
        Relative radius at which to stop, 0 up to 1. A thousand points come to about 0.74 in 16 iterations,
        0.78 in 32 and 0.80 in 128; 16,384 points to 0.71, 0.74 and 0.77. By default all iterations are
        made, and nothing is promised about distances.
    iterations : int, optional
        The most iterations, 0 to 10^6; by default 32, or 256 where ``rho`` is given.
    start : PointSet or array-like of float, shape (count, 2), optional
        Points to begin with, no two at the same place; by default those of `relaxation_darts`.
    seed : int or numpy.random.Generator, optional
        Where the chance of the points to begin with begins: 0 to 2^64 - 1, or a generator; default 0.
    box : Box, optional
        The domain, a plane one; by default that of ``start``, or the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        In the order of ``start``. ``figures["iterations"]`` is the number of iterations; ``figures["rho"]``
        the relative radius before each of them, and last the one reached.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        ``rho`` was not reached, and the message says how far it came; or the box is not a plane, or a number
        is out of range.

    Notes
    -----
    Lloyd 1982; McCool & Fiume 1992; Lagae 2007, section 6.5.
    """
    if box is None and isinstance(start, PointSet):
        box = start.box
    domain = check_box(box, plane="Lloyd's method")
    points = _start(count, start, seed, domain, progress)
    n = len(points)
    wanted = 0.0 if rho is None else check_distance(rho, n, domain)
    if iterations is None:
        iterations = 32 if rho is None else 256
    most = check_int("iterations", iterations, 0, 10**6)
    reached: list[float] = []
    while True:
        if progress is not None:
            progress(len(reached), most, "relaxing")
        moved, _, nearest = centroids(points, domain)
        reached.append(float(nearest.min()) / 2 / PointSet(points, domain).max_radius)
        if len(reached) > most or (rho is not None and nearest.min() >= wanted):
            break
        points = moved
    if nearest.min() < wanted:
        raise TilewrightValueError(
            f"is {rho}; {most} iterations came to {max(reached):.3f}",
            argument="rho",
            value=rho,
            advice="allow more iterations or less rho",
        )
    figures = {"iterations": len(reached) - 1, "rho": reached}
    return PointSet(points, domain, "lloyd", wanted, figures)


def centroids(
    points: NDArray[np.float64], box: Box
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """For each point of a plane the centroid of its Voronoi cell, the cell's area and the nearest distance.

    points : float64 array, shape (n, 2), inside the box, no two at the same place. On a torus the nearest
    distance is to any other point or to its own images.
    """
    from tilewright.kernels.polygons import move_to_centroids

    n = len(points)
    bins = Bins.of(points, box, 0.0, 0.5)
    moved, areas, nearest = np.empty((n, 2)), np.empty(n), np.empty(n)
    held = (points[bins.order], bins.starts, bins.counts)
    move_to_centroids(n, *held, np.array(box.extent), box.torus, moved, areas, nearest)
    results = []
    for made in (moved, areas, nearest):
        results.append(np.empty_like(made))
        results[-1][bins.order] = made
    return results[0], results[1], results[2]


def _start(
    count: int | None,
    start: PointSet | ArrayLike | None,
    seed: Seed,
    box: Box,
    progress: Progress | None,
) -> NDArray[np.float64]:
    """The points to begin with."""
    if start is None:
        n = check_count(count, 200)
        return relaxation_darts(n, seed=seed, box=box, progress=progress).points
    points = box.check_points(start.points if isinstance(start, PointSet) else start)
    if not len(points):
        raise TilewrightValueError("has no points", argument="start", advice="give at least one")
    if count is not None and check_count(count, 200) != len(points):
        raise TilewrightValueError(
            f"is {count} but start has {len(points)} points",
            argument="count",
            value=count,
            advice="leave out count",
        )
    _, inverse = np.unique(points, axis=0, return_inverse=True)
    if inverse.max() + 1 < len(points):
        same = int(np.flatnonzero(np.bincount(inverse) > 1)[0])
        first, second = np.flatnonzero(inverse == same)[:2].tolist()
        raise TilewrightValueError(
            f"points {first} and {second} of start are at the same place", advice="move one"
        )
    return points
