"""Dart throwing: points by chance, kept where none is near (Cook 1986; Lagae 2007, section 6.3)."""

import numpy as np

from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count, check_distance, too_full
from tilewright.samplers.filling import SMALL
from tilewright.samplers.grid import Grid
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

_BATCH = 2**18
_PATIENCE = 4000
"""Darts for each point asked for, after which a set counts as full."""


def dart_throwing(
    count: int,
    rho: float = 0.7,
    *,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Throw darts: exactly ``count`` points by chance, none closer than 2 rho r_max.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1.
    rho : float, optional
        Relative radius, 0 up to 1; default 0.7. Random darts fill a plane at about 0.77 (disks then cover
        54.7 % of it, the jamming limit of random sequential adsorption); to 0.75 they come in practice.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        In the order in which they were placed; ``figures["darts"]`` is the number of darts thrown.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The darts found no room for all points, or a number is out of range. A small set that leaves no room
        is begun anew first.

    Notes
    -----
    Cook 1986; Lagae 2007, section 6.3.
    """
    domain = check_box(box)
    n = check_count(count, 8 * domain.dimension + 4)
    distance = check_distance(rho, n, domain)
    from tilewright.kernels.darts import throw_darts

    key, points = make_key(seed), np.empty((n, domain.dimension))
    cells = Grid.of(domain, n, distance).over(points)
    thrown = placed = best = full = 0
    while placed < n:
        if progress is not None:
            progress(placed, n, "throwing darts")
        if thrown - full >= _PATIENCE * n:  # no room is left: begin anew, or give up
            best, full, placed = max(best, placed), thrown, 0
            if thrown >= _PATIENCE * max(n, SMALL):
                raise too_full(rho, best, n, domain.dimension, "Lloyd's method goes higher in planes")
            cells.heads.fill(-1)
        thrown, placed = throw_darts(key, min(_BATCH, _PATIENCE * n), thrown, placed, distance, cells)
    return PointSet(points, domain, "dart", distance, {"darts": thrown})
