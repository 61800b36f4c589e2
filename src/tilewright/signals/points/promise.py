"""The promise of a set: how far apart points are in every tiling there can be.

Points less than a tile apart lie in one tile, in two that share an edge or in two that share a corner, so
it is enough to look at all such pairs of tiles: 2 C^6 and 2 C^7 combinations of corner tiles.
"""

from dataclasses import dataclass
from math import inf, sqrt

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_real, check_type
from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius
from tilewright.signals.points.point_tiles import PointTiles
from tilewright.tiles import TileSet


@dataclass(frozen=True)
class Closeness:
    """The least distances over all admissible neighborhoods, in tile lengths.

    Attributes
    ----------
    within : float
        The least distance of two points of one tile.
    across_edges : float
        The least distance of points of two tiles that share an edge; infinity where all are a tile apart.
    across_corners : float
        The least distance of points of two tiles that share a corner only.
    density : float
        Points per tile, on average over the set.
    """

    within: float
    across_edges: float
    across_corners: float
    density: float

    @property
    def across(self) -> float:
        """The least distance of points of two tiles, across edges or corners."""
        return min(self.across_edges, self.across_corners)

    @property
    def distance(self) -> float:
        """The least distance of all; at most 1, since farther tiles are not looked at."""
        return min(self.within, self.across, 1.0)

    @property
    def rho(self) -> float:
        """The relative radius of every tiling is at least this, for the mean number of points per tile."""
        return self.distance / 2 / self._max_radius if self.density else inf

    @property
    def intra_rho(self) -> float:
        """The relative radius of points of one tile only (Lagae 2007, section 6.7)."""
        return self.within / 2 / self._max_radius if self.density else inf

    @property
    def _max_radius(self) -> float:
        return max_radius(1, Box()) / sqrt(self.density)


def find_closeness(tiles: PointTiles, reach: float = 1.0) -> Closeness:
    """Find the least distances over every pair of tiles that may be neighbors.

    Parameters
    ----------
    tiles : PointTiles
        Point tiles over square tiles of any kind.
    reach : float, optional
        Points farther than this from an edge or corner, in tile lengths, are not looked at beyond it; more
        than 0, default 1. Distances that are found to be less than ``reach`` are right.

    Returns
    -------
    Closeness
        The least distances within tiles, across edges and across corners.

    Raises
    ------
    TilewrightTypeError
        Something else than point tiles, or a reach that is no number.
    TilewrightValueError
        Tiles that are not square, or a reach of 0 or less.

    Notes
    -----
    The union of disks that Lagae 2007, section 4.2.3, measures is never built: points less than a tile apart
    lie in one tile, in two that share an edge or in two that share a corner; all such pairs are looked at.

    Examples
    --------
    >>> import tilewright as tw
    >>> close = tw.find_closeness(tw.ready_tiles())
    >>> round(close.rho, 3), round(close.distance, 4)
    (0.75, 0.1425)
    """
    check_type("tiles", tiles, PointTiles, "PointTiles")
    if tiles.tiles.shape.dimension != 2:
        raise TilewrightValueError(f"the {tiles.tiles.name} set has no square tiles")
    if not check_real("reach", reach, 0.0, inf) > 0:
        raise TilewrightValueError(f"is {reach}; more than 0 is needed", argument="reach", value=reach)
    from tilewright.kernels.closeness import find_closest_within

    points = tiles.points.astype(np.float64)
    closest = np.full(len(tiles.starts) - 1, inf)
    find_closest_within(len(closest), points, tiles.starts, closest)
    meeting = _Meeting.of(tiles.tiles)
    edges = (_across(tiles, points, reach, step, meeting) for step in ((1, 0), (0, 1)))
    corners = (_across(tiles, points, reach, step, meeting) for step in ((1, 1), (-1, 1)))
    return Closeness(sqrt(closest.min(initial=inf)), min(edges), min(corners), tiles.density)


@dataclass(frozen=True, eq=False)
class _Meeting:
    """Keys of the sides of tiles: tiles may be neighbors where the keys of the sides that meet agree."""

    east: NDArray[np.int64]
    west: NDArray[np.int64]
    south: NDArray[np.int64]
    north: NDArray[np.int64]

    @classmethod
    def of(cls, tiles: TileSet) -> "_Meeting":
        sides = []
        for joint in (tiles.shape.across(axis) for axis in (0, 1)):
            far, near = (tiles.slots[:, [pair[end] for pair in joint]] for end in (0, 1))
            _, keys = np.unique(np.concatenate([far, near]), axis=0, return_inverse=True)
            sides += [keys.reshape(2, -1)[0], keys.reshape(2, -1)[1]]
        return cls(*(s.astype(np.int64) for s in sides))

    def table(self, step: tuple[int, int]) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.bool_]]:
        """Keys of tiles, keys of tiles a step away, and which of these go together in some tiling."""
        if step == (1, 0):
            return self.east, self.west, np.eye(int(max(self.east.max(), self.west.max())) + 1, dtype=bool)
        if step == (0, 1):
            return (
                self.south,
                self.north,
                np.eye(int(max(self.south.max(), self.north.max())) + 1, dtype=bool),
            )
        # Across a corner: a tile must fit between the two on either side. Sides are told by two keys.
        out, back = (self.east, self.west) if step[0] > 0 else (self.west, self.east)
        rows, columns = int(max(out.max(), back.max())) + 1, int(max(self.south.max(), self.north.max())) + 1
        beside, below = np.zeros((rows, columns), bool), np.zeros((columns, rows), bool)
        beside[back, self.south] = True
        below[self.north, out] = True
        # (out, south) of the one, (north, back) of the other.
        ones, keys = np.unique(out * columns + self.south, return_inverse=True)
        others, other_keys = np.unique(self.north * rows + back, return_inverse=True)
        first = beside[ones // columns][:, others // rows]
        second = below[ones % columns][:, others % rows]
        return keys.astype(np.int64), other_keys.astype(np.int64), first & second


def _across(
    tiles: PointTiles,
    points: NDArray[np.float64],
    reach: float,
    step: tuple[int, int],
    meeting: _Meeting,
) -> float:
    """The least distance of points of tiles that lie a step apart."""
    from tilewright.kernels.closeness import find_closest

    keys, other_keys, meets = meeting.table(step)
    near, near_starts = _near(tiles, points, reach, step)
    far, far_starts = _near(tiles, points, reach, (-step[0], -step[1]))
    closest = np.full(len(tiles.starts) - 1, inf)
    find_closest(
        len(closest),
        near,
        near_starts,
        far,
        far_starts,
        np.repeat(keys, tiles.variants.counts),
        np.repeat(other_keys, tiles.variants.counts),
        meets,
        float(step[0]),
        float(step[1]),
        closest,
    )
    return sqrt(closest.min(initial=inf))


def _near(
    tiles: PointTiles, points: NDArray[np.float64], reach: float, step: tuple[int, int]
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """The points of each row within reach of the edge or corner that a step leads across."""
    keep = np.ones(len(points), bool)
    for axis, way in enumerate(step):
        if way > 0:
            keep &= points[:, axis] >= 1 - reach
        elif way < 0:
            keep &= points[:, axis] <= reach
    counts = np.concatenate([[0], np.cumsum(keep)])[tiles.starts]
    return points[keep], counts.astype(np.int64)
