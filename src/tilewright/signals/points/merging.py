"""Merging two progressive point sets along a seam, as texture tiles are merged (Kopf et al. 2006)."""

import numpy as np
from numpy.typing import NDArray

_HOLE = 0.5
"""What it costs to lose two neighboring points."""
_ROOM = 1.2
"""In mean spacings: how far apart neighboring points cost nothing if both stay; at half of it they cost 1."""
_MOST = 100.0
_SHARES = (1, 1 / 4, 1 / 16, 1 / 64)
"""Densities, of the whole, at which the seam costs alike."""
_FEWEST = 8
"""Points of which neighbors are looked for."""
_UNIT = 10_000
"""Capacity of the flow for a cost of 1."""
_FIXED = 2**30


def merge(
    outer: NDArray[np.float64],
    inner: NDArray[np.float64],
    depth_outer: NDArray[np.float64],
    depth_inner: NDArray[np.float64],
    spacing: float,
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which points of two sets of the same density stay when one goes over into the other.

    Every point of either set is put on the outer or on the inner side, and stays if that is the side of its
    set. The seam between the sides runs through the Delaunay triangulation of all points, and of those of low
    rank; it is the cheapest one, a minimum cut. See `_seam_costs`.

    Parameters
    ----------
    outer, inner : float64 arrays, shape (a, 3) and (b, 3)
        x, y and rank from 0 to 1.
    depth_outer, depth_inner : float64 arrays, shape (a,) and (b,)
        Points of depth 0 and less are on the outer side, of depth 1 and more on the inner side.
    spacing : float
        The square root of the area for each point.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import breadth_first_order, maximum_flow

    points, depth = np.concatenate([outer, inner]), np.concatenate([depth_outer, depth_inner])
    is_inner = np.arange(len(points)) >= len(outer)
    # Step 1: costs between neighbors, and what cannot be cut off from the outer and from the inner side.
    pairs, costs = [], []
    for share in _SHARES:
        early = np.flatnonzero(points[:, 2] < share)
        if np.bincount(is_inner[early], minlength=2).min() >= _FEWEST:
            found, cost = _seam_costs(points[early, :2], is_inner[early], spacing / share**0.5)
            pairs.append(early[found])
            costs.append(cost)
    source, sink = len(points), len(points) + 1
    outermost, innermost = np.flatnonzero(depth <= 0), np.flatnonzero(depth >= 1)
    pairs.append(np.column_stack([np.full(len(outermost), source), outermost]))
    pairs.append(np.column_stack([innermost, np.full(len(innermost), sink)]))
    capacity = np.concatenate(
        [np.concatenate(costs) * _UNIT, np.full(len(outermost) + len(innermost), _FIXED)]
    )
    # Step 2: the flow from the outermost points to the innermost.
    ends = np.concatenate(pairs).T
    graph = csr_array((capacity.astype(np.int32), (ends[0], ends[1])), shape=(sink + 1, sink + 1))
    rest = graph - maximum_flow(graph, source, sink).flow
    # Step 3: the outer side is what can still be reached.
    rest.data[rest.data < 0] = 0
    rest.eliminate_zeros()
    on_outer = np.zeros(sink + 1, bool)
    on_outer[breadth_first_order(rest, source, return_predecessors=False)] = True
    stays = on_outer[:source] != is_inner
    return stays[: len(outer)], stays[len(outer) :]


def _seam_costs(
    points: NDArray[np.float64], is_inner: NDArray[np.bool_], spacing: float
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Pairs of neighbors, shape (n, 2), and what it costs if only the second is on the inner side.

    That is how much they are too close if both stay, a fixed amount if both go, and how far away the set that
    takes over is if one of them goes.
    """
    from scipy.spatial import Delaunay, cKDTree

    corners = Delaunay(points).simplices
    pairs = np.unique(
        np.concatenate([corners[:, [a, b]] for a in range(3) for b in range(3) if a != b]), axis=0
    )
    first, second = pairs.T.astype(np.int64)
    gap = np.hypot(*(points[first] - points[second]).T) / spacing
    away = np.empty(len(points))
    for side in (False, True):
        own = is_inner == side
        away[own] = cKDTree(points[~own]).query(points[own])[0] / spacing
    both_stay, both_go = ~is_inner[first] & is_inner[second], is_inner[first] & ~is_inner[second]
    one_goes = np.where(is_inner[first], away[first], away[second]) ** 2
    close = np.maximum(_ROOM / np.maximum(gap, 1e-6) - 1, 0) ** 2
    cost = np.where(both_stay, close, np.where(both_go, _HOLE, one_goes))
    return np.column_stack([first, second]), np.minimum(cost, _MOST)
