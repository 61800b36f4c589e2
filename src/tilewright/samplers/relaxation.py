"""Relaxation dart throwing: darts whose distance shrinks when no room is left.

McCool & Fiume 1992; Lagae 2007, section 6.4.
"""

import numpy as np

from tilewright.checks import check_int, check_real
from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count
from tilewright.samplers.grid import Grid
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

_BATCH = 2**20
_STEP = 0.7
"""The distance may shrink by so much before the grid is made anew."""


def relaxation_darts(
    count: int,
    *,
    factor: float = 0.99,
    failures: int = 1000,
    radius: float | None = None,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Throw darts at a distance that shrinks when no room is left: exactly ``count`` points.

    The order is hierarchical: the first n points are well spread for every n.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1.
    factor : float, optional
        What the distance is multiplied by when no room was found, 0.01 to 0.9999; default 0.99. 16,384 points
        come to a relative radius of 0.57, 0.68 and 0.73 with a factor of 0.9, 0.99 and 0.999 after 100, 1,000
        and 10,000 failures; the last takes twenty times as long as the second.
    failures : int, optional
        Darts missing in a row after which there is no room, 1 to 10^9; default 1000.
    radius : float, optional
        Half the first distance, in the box's units; by default 0.15 of the square root of the area. On a
        torus at most half of its shortest side is used.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        Its ``distance`` is the last one, which every two points keep; ``figures["darts"]`` the number of
        darts.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    McCool & Fiume 1992; Lagae 2007, section 6.4.
    """
    domain = check_box(box)
    n = check_count(count, 8 * domain.dimension + 40)
    shrink = check_real("factor", factor, 0.01, 0.9999)
    patience = check_int("failures", failures, 1, 10**9)
    size = domain.volume ** (1 / domain.dimension)
    distance = 0.3 * size if radius is None else 2 * check_real("radius", radius, 1e-9 * size, 1e9 * size)
    if domain.torus:
        distance = min(distance, *domain.extent)
    from tilewright.kernels.darts import fill_cells, relax_darts

    key, points = make_key(seed), np.empty((n, domain.dimension))
    thrown = placed = missed = 0
    while placed < n:
        # A grid for distances between the present one and a little less.
        floor = distance * _STEP
        cells = Grid.of(domain, n, floor, reach=distance).over(points)
        fill_cells(placed, cells)
        while placed < n and distance >= floor:
            if progress is not None:
                progress(placed, n, "throwing darts")
            thrown, placed, missed, distance = relax_darts(
                key, _BATCH, thrown, placed, missed, distance, floor, shrink, patience, cells
            )
    return PointSet(points, domain, "relaxation", distance, {"darts": thrown})
