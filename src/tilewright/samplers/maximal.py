"""Darts at what may still be free, cell by ever smaller cell, until nothing is (Ebeida et al. 2012)."""

from math import ceil

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_real
from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.darts import dart_throwing
from tilewright.samplers.feasibility import check_box, check_count
from tilewright.samplers.filling import LEAST_RHO, fill
from tilewright.samplers.grid import Grid
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

_DARTS_EACH = 1.0
"""Darts for each active cell before the cells are split."""
_DEEPEST = 40
"""Splits after which what is left of a gap counts as none: a 10^-12th of a cell."""
_BYTES_EACH = 200
_EASY_RHO = 0.5
"""Below it darts hardly miss and cells would be many for each point."""


def maximal_darts(
    count: int,
    rho: float | None = None,
    *,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Throw darts at what may still be free, cell by ever smaller cell, until no room is left.

    No two points are closer than 2 rho r_max. Darts are thrown at cells of a grid that may have room, each
    equally likely; then those cells are halved along every axis, and parts covered by a disk are dropped. The
    distribution is that of dart throwing.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1: exact with ``rho``, which may come before the room ends; about as
        many without.
    rho : float, optional
        Relative radius, more than 0, up to 1. By default the set is maximal, at a radius for which that
        happens at about ``count`` points: rho is about 0.776 in planes and 0.80 in volumes.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        ``figures["maximal"]`` says whether it is known to be maximal: no place of the box is farther than
        ``distance`` from all points.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        There was no room for ``count`` points at ``rho``, or a number is out of range.

    Notes
    -----
    Ebeida et al. 2012.
    """
    domain = check_box(box)
    n = check_count(count, _BYTES_EACH)
    if rho is not None and check_real("rho", rho, LEAST_RHO, 1.0) < _EASY_RHO:
        easy = dart_throwing(n, rho, seed=seed, box=domain, progress=progress)
        return PointSet(easy.points, domain, "maximal", easy.distance, {"maximal": False})
    from tilewright.kernels.voids import split_cells, throw_at_cells

    key, d = make_key(seed), domain.dimension

    def run(distance: float, most: int, first: int) -> tuple[NDArray[np.float64], bool]:
        points = np.empty((most, d))
        cells = Grid.of(domain, most, distance, fine=True).over(points)
        active = np.stack(np.unravel_index(np.arange(len(cells.heads)), tuple(cells.counts)), axis=1)
        placed, level = 0, 0
        while len(active) and placed < most and level <= _DEEPEST:
            if progress is not None:
                progress(min(placed, n), n, "filling gaps")
            darts = ceil(_DARTS_EACH * len(active))
            placed = throw_at_cells(key, first, darts, placed, active, level, distance, cells)
            first += darts * (d + 1)
            parts = np.empty((len(active) << d, d), np.int64)
            left = split_cells(active, level, distance, cells, parts)
            active, level = parts[:left].copy(), level + 1
        return points[:placed].copy(), len(active) == 0 or level > _DEEPEST

    return fill("maximal", n, rho, domain, _BYTES_EACH, run)
