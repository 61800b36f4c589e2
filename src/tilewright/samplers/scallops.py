"""Points around points, in what is left of the rings around them.

Dunbar & Humphreys 2006; Lagae 2007, section 6.13.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count, most_points
from tilewright.samplers.filling import about_distance
from tilewright.samplers.grid import Grid
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

_BATCH = 2**13


def scallop_log(
    count: int,
    rho: float | None = None,
    *,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Grow points outward, each anywhere in the rings around the ones before, chosen by area.

    No two points are closer than 2 rho r_max. A ring goes from the least distance to twice that; what disks
    leave of all rings is kept as scalloped sectors, of which each point of the plane is in one at most, and
    the next point is uniform in them. The set grows from the first point until no room is left.

    Parameters
    ----------
    count : int
        About how many points, 1 to 2^31 - 1.
    rho : float, optional
        Relative radius of ``count`` points, more than 0, up to 1; the set is full in any case, so with a low
        one there are more points. By default one at which about ``count`` points fill the box.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain, a plane one; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        Maximal: no place is farther than ``distance`` from all points.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The box is not a plane, or a number is out of range.

    Notes
    -----
    Dunbar & Humphreys 2006; Lagae 2007, section 6.13.
    """
    from tilewright.kernels.scallops import Regions, grow_by_area
    from tilewright.kernels.sectors import FIELDS

    grown = _Growth(count, rho, "scallop-log", 1000, seed, box, 4.0)
    rows = np.empty((2 * grown.most + 64, FIELDS))
    tree = np.zeros(2 << (grown.most - 1).bit_length())
    starts, sizes, room = np.zeros((3, grown.most), np.int64)
    regions = Regions(starts, sizes, room, tree)
    placed = used = 0
    while placed == 0 or tree[1] > 0:
        grown.report(progress, placed)
        last = min(grown.most, placed + _BATCH)
        placed, rows, used = grow_by_area(
            grown.key, placed, last, grown.distance, grown.cells, rows, used, regions
        )
    return grown.answer(placed)


def scallop_linear(
    count: int,
    rho: float | None = None,
    *,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Grow points outward as `scallop_log` does, but fill the rings one after the other, in random order.

    Its time is linear in the number of points, and the sets are a little denser.

    Parameters
    ----------
    count : int
        About how many points, 1 to 2^31 - 1.
    rho : float, optional
        Relative radius of ``count`` points, more than 0, up to 1; as of `scallop_log`.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain, a plane one; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        Maximal: no place is farther than ``distance`` from all points.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The box is not a plane, or a number is out of range.

    Notes
    -----
    Dunbar & Humphreys 2006; Lagae 2007, section 6.13.
    """
    from tilewright.kernels.scallops import grow_by_turns

    grown = _Growth(count, rho, "scallop-linear", 100, seed, box, 4.0)
    return _grow_in_turn(grow_by_turns, grown, progress, np.zeros(grown.most, np.bool_))


def scallop_boundary(
    count: int,
    rho: float | None = None,
    *,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
) -> PointSet:
    """Grow points outward as `scallop_linear` does, but each at the least distance from another one.

    Every disk touches another. This is the fastest of the three and the densest, with strong rings in its
    spectrum.

    Parameters
    ----------
    count : int
        About how many points, 1 to 2^31 - 1.
    rho : float, optional
        Relative radius of ``count`` points, more than 0, up to 1; as of `scallop_log`.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain, a plane one; by default the unit torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        Maximal: no place is farther than ``distance`` from all points.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The box is not a plane, or a number is out of range.

    Notes
    -----
    Dunbar & Humphreys 2006; Lagae 2007, section 6.13.
    """
    from tilewright.kernels.scallops import grow_by_touch

    grown = _Growth(count, rho, "scallop-boundary", 100, seed, box, 2.0)
    return _grow_in_turn(grow_by_touch, grown, progress)


class _Growth:
    """What the three have in common: the empty domain in which points grow."""

    def __init__(
        self,
        count: int,
        rho: float | None,
        method: str,
        bytes_each: int,
        seed: Seed,
        box: Box | None,
        reach: float,
    ) -> None:
        self.box = check_box(box, plane="the method of Dunbar & Humphreys")
        self.count, self.method, self.key = check_count(count, bytes_each), method, make_key(seed)
        self.distance = about_distance(method, self.count, rho, self.box)
        self.most = most_points(self.distance, self.box, bytes_each)
        self.points = np.empty((self.most, 2))
        grid = Grid.of(self.box, self.most, self.distance, reach=reach * self.distance, images=True)
        self.cells = grid.over(self.points)

    def report(self, progress: Progress | None, placed: int) -> None:
        if progress is not None:
            progress(min(placed, self.count), self.count, "filling gaps")

    def answer(self, placed: int) -> PointSet:
        return PointSet(self.points[:placed].copy(), self.box, self.method, self.distance, {"maximal": True})


def _grow_in_turn(
    grow: Callable[..., Any], grown: _Growth, progress: Progress | None, *notes: NDArray[np.bool_]
) -> PointSet:
    active: NDArray[np.int32] = np.empty(grown.most, np.int32)
    drawn = placed = waiting = 0
    while placed == 0 or waiting > 0:
        grown.report(progress, placed)
        last = min(grown.most, placed + _BATCH)
        drawn, placed, waiting = grow(
            grown.key, drawn, placed, last, waiting, active, grown.distance, grown.cells, *notes
        )
    return grown.answer(placed)
