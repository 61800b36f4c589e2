"""Darts around the points that stay (Bridson 2007)."""

import numpy as np

from tilewright.checks import check_int
from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count, most_points
from tilewright.samplers.filling import about_distance
from tilewright.samplers.grid import Grid
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

_BATCH = 2**15


def bridson_darts(
    count: int,
    rho: float | None = None,
    *,
    tries: int = 30,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Grow points outward from the first: about ``count`` of them, none closer than 2 rho r_max.

    Darts are thrown into the ring around a point, from the least distance to twice that, until ``tries`` of
    them in a row have found no room. Few gaps are left where another point would fit.

    Parameters
    ----------
    count : int
        About how many points, 1 to 2^31 - 1.
    rho : float, optional
        Relative radius of ``count`` points, more than 0, up to 1; the box is filled in any case, so with a
        low one there are more points. By default one at which about ``count`` points fill it.
    tries : int, optional
        Darts around each point, 1 to 10^6; default 30. More make the set more nearly full, and a little
        larger.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        In the order in which they were placed.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Bridson 2007.
    """
    domain = check_box(box)
    n = check_count(count, 100)
    patience = check_int("tries", tries, 1, 10**6)
    distance = about_distance("bridson", n, rho, domain)
    from tilewright.kernels.darts import grow_around

    key, most = make_key(seed), most_points(distance, domain, 100)
    points, active = np.empty((most, domain.dimension)), np.empty(most, np.int32)
    cells = Grid.of(domain, most, distance).over(points)
    drawn = placed = waiting = 0
    while placed == 0 or waiting > 0:
        if progress is not None:
            progress(min(placed, n), n, "growing")
        last = min(most, placed + _BATCH)
        drawn, placed, waiting = grow_around(
            key, drawn, placed, last, waiting, active, patience, distance, cells
        )
    return PointSet(points[:placed].copy(), domain, "bridson", distance)
