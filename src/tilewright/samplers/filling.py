"""What samplers share that place points one by one, by chance, until there are enough or no room is left."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_distance, full_distance, most_points, too_full
from tilewright.samplers.point_set import PointSet

Run = Callable[[float, int, int], tuple[NDArray[np.float64], bool]]
"""``run(distance, most, first)``: up to ``most`` points, and whether no room is left for another.

``first`` is the first number of the key to be drawn.
"""

SMALL = 4096
"""Sets of fewer points are begun anew when full, until about this number of points was placed in all."""
LEAST_RHO = 1e-6

_FULL = {
    "jones": ((0.7766, 0.66),),
    "maximal": ((0.7766, 0.66), (0.8035, 0.65)),
    "scallop-log": ((0.775, 0.72),),
    "scallop-linear": ((0.7975, 0.64),),
    "scallop-boundary": ((0.8625, 0.6),),
    "bridson": ((0.7295, 0.48), (0.741, 0.41)),
}
"""For each method, in two and three dimensions: relative radius at which it leaves no room on a torus, and
how far, in distances, a plain box counts beyond its border. Measured; darts cover 54.7 % of a plane and 38.4
% of space with disks and spheres (the jamming limits of random sequential adsorption)."""
_DRAWS = 2**40
"""Numbers set aside for one try."""


def fill(name: str, count: int, rho: float | None, box: Box, bytes_each: int, run: Run) -> PointSet:
    """Exactly ``count`` points at ``rho``, or without it about ``count``: all there is room for.

    A small set may close up before it has ``count`` points although others would not: it is begun anew.
    bytes_each : memory that ``run`` takes for each point it may place.
    """
    if rho is None:
        distance = about_distance(name, count, None, box)
        points, full = run(distance, most_points(distance, box, bytes_each), 0)
        return PointSet(points, box, name, distance, {"maximal": full})
    distance = check_distance(rho, count, box, LEAST_RHO)
    best = 0
    for attempt in range(max(1, SMALL // count)):
        points, full = run(distance, count, attempt * _DRAWS)
        if len(points) == count:
            return PointSet(points, box, name, distance, {"maximal": full})
        best = max(best, len(points))
    raise too_full(rho, best, count, box.dimension, "Lloyd's method goes higher in planes")


def about_distance(name: str, count: int, rho: float | None, box: Box) -> float:
    """The least distance 2 rho r_max, or without rho one at which the method makes about ``count`` points."""
    if rho is None:
        return full_distance(count, box, *_FULL[name][box.dimension - 2])
    return check_distance(rho, count, box, LEAST_RHO)
