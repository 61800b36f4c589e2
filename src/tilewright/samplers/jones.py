"""Darts that never miss: thrown into what the Voronoi cells of the points leave free (Jones 2006)."""

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count
from tilewright.samplers.filling import fill
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

_BATCH = 2**14
_BYTES_EACH = 600


def jones_darts(
    count: int,
    rho: float | None = None,
    *,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Throw darts that never miss: each point is uniform in the room that the ones before leave.

    That is the distribution of dart throwing, at any radius. No two points are closer than 2 rho r_max. Every
    Voronoi cell knows the area its point's disk leaves free; a cell is chosen by area from a tree, and a
    place in it by area.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1: exact with ``rho``, about as many without.
    rho : float, optional
        Relative radius, more than 0, up to 1. By default points are placed until there is no room for
        another, at a radius for which that happens at about ``count`` points: rho is about 0.776, and of
        16,384 come up to 70 more or fewer.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain, a plane one; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        ``figures["maximal"]`` says whether there is no room for another point.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        There was no room for ``count`` points at ``rho``, the box is not a plane, or a number is out of
        range.

    Notes
    -----
    Jones 2006; Lagae 2007, section 6.12. Departs from the paper in keeping polygons, which a new point cuts
    one by one, instead of a triangulation.
    """
    domain = check_box(box, plane="the method of Jones")
    n = check_count(count, _BYTES_EACH)
    from tilewright.kernels.gaps import Diagram, fill_gaps

    key, extent = make_key(seed), np.array(domain.extent)

    def run(distance: float, most: int, first: int) -> tuple[NDArray[np.float64], bool]:
        points, rows = np.empty((most, 2)), np.empty((9 * n + 64, 3))
        tree = np.zeros(2 << (most - 1).bit_length())
        starts, corners, room = np.zeros((3, most), np.int64)
        diagram = Diagram(points, extent, domain.torus, starts, corners, room, tree)
        placed = used = 0
        while placed == 0 or (placed < most and tree[1] > 0):
            if progress is not None:
                progress(min(placed, n), n, "filling gaps")
            last = min(most, placed + _BATCH)
            placed, rows, used = fill_gaps(key, first, placed, last, distance, diagram, rows, used)
        return points[:placed].copy(), bool(tree[1] == 0)

    return fill("jones", n, rho, domain, _BYTES_EACH, run)
