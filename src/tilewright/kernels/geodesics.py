"""Shortest ways along a surface of triangles, exact: straight across unfolded triangles, turning at vertices.

A shortest way is straight within a strip of triangles laid out in a plane, and bends at most at vertices with
more than a full turn around them and on the border (Mitchell, Mount & Papadimitriou 1987, "The Discrete
Geodesic Problem", SIAM J. Comput. 16 (4)). So all strips that can be seen from the start are looked at,
then those from such vertices, nearest first.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.compiled import kernel

_DEEP = 8192
"""Most strips that wait to be followed."""
_TURNS = 8192
"""Most vertices around a start to which ways are known."""
_SAME = 1e-9
"""Part of an edge by which ways must differ to be told apart."""
_SLACK = 1e-12
"""How far beside what can be seen a mark may lie, as an angle."""
_NEXT, _WAITING, _SEEN, _LOOKED, _CUT, _GIVEN_UP = range(6)
"""What `Search.tally` holds."""


class Unfolding(NamedTuple):
    """A surface as it is laid out, triangle by triangle.

    Attributes
    ----------
    triangles, twins : int32 arrays, shape (T, 3)
        As those of a Surface.
    lengths : float64 array, shape (T, 3)
        Of edge k, from corner k to corner k + 1.
    apexes : float64 array, shape (3 T, 2)
        Of edge 3 t + k the third corner, where the edge is from (0, 0) to (1, 0).
    turning : bool array, shape (V,)
        Vertices at which a shortest way may turn, start or end.
    fans : int64 array, shape (3 T,)
        The corners 3 t + k of every vertex, one vertex after another.
    fan_starts : int64 array, shape (V + 1,)
        Where those of each vertex start.
    """

    triangles: NDArray[np.int32]
    twins: NDArray[np.int32]
    lengths: NDArray[np.float64]
    apexes: NDArray[np.float64]
    turning: NDArray[np.bool_]
    fans: NDArray[np.int64]
    fan_starts: NDArray[np.int64]


class Marks(NamedTuple):
    """Spots by triangle, and in each triangle by their first weight.

    Attributes
    ----------
    numbers : int64 array, shape (n,)
        Which spot each is.
    weights : float64 array, shape (n, 3)
        Where it lies in its triangle.
    starts : int64 array, shape (T + 1,)
        Where those of each triangle start.
    """

    numbers: NDArray[np.int64]
    weights: NDArray[np.float64]
    starts: NDArray[np.int64]


class Search(NamedTuple):
    """What is known while the ways from one start are looked for.

    Attributes
    ----------
    edges : int64 array, shape (waiting,)
        Of each strip that waits, the edge 3 t + k through which triangle t is entered.
    strips : float64 array, shape (waiting, 8)
        Where that edge starts and ends, and the rays that bound what can be seen through it: right and left.
    distances : float64 array, shape (V,)
        From the start to vertices, as far as ways there are known; infinite for others.
    seen : int64 array
        Vertices to which ways are known.
    expanded : bool array
        Whether the ways from there have been looked at, or need not be.
    shortest : float64 array, shape (2,)
        The length of the shortest way to a mark so far, and the length from which ways are not looked at.
    tally : int64 array, shape (6,)
        The strip that comes next and how many wait, in a ring; vertices seen; strips looked at; whether ways
        were left out as too long, and whether the search was given up.
    """

    edges: NDArray[np.int64]
    strips: NDArray[np.float64]
    distances: NDArray[np.float64]
    seen: NDArray[np.int64]
    expanded: NDArray[np.bool_]
    shortest: NDArray[np.float64]
    tally: NDArray[np.int64]


@kernel(inline=True)
def _length(x, y):
    return np.sqrt(x * x + y * y)


@kernel()
def _arrive(marks, search, face, turn, x, y, rays, own, offset):
    """Look for marks in a triangle whose corner ``turn`` is laid out at (x[0], y[0]), between two rays.

    Marks are in the order of their first weight: only those are looked at that may be near enough.
    """
    low, end = marks.starts[face], marks.starts[face + 1]
    if low == end:
        return
    shortest = search.shortest
    i = (3 - turn) % 3
    j, k = (i + 1) % 3, (i + 2) % 3
    doubled = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
    weight = (x[j] * y[k] - x[k] * y[j]) / doubled
    margin = (1 + _SLACK) * (shortest[1] - offset) * _length(x[k] - x[j], y[k] - y[j]) / doubled
    high = end
    while low < high:
        middle = (low + high) // 2
        if marks.weights[middle, 0] < weight - margin:
            low = middle + 1
        else:
            high = middle
    if low > marks.starts[face]:
        search.tally[_CUT] = 1
    right, left = _SLACK * (abs(rays[0]) + abs(rays[1])), _SLACK * (abs(rays[2]) + abs(rays[3]))
    for m in range(low, end):
        w = marks.weights[m]
        if w[0] > weight + margin:
            search.tally[_CUT] = 1
            break
        across, up = w[0] * x[i] + w[1] * x[j] + w[2] * x[k], w[0] * y[i] + w[1] * y[j] + w[2] * y[k]
        far = -(abs(across) + abs(up))
        seen = (
            rays[0] * up - rays[1] * across >= far * right and across * rays[3] - up * rays[2] >= far * left
        )
        if seen and marks.numbers[m] != own:
            length = offset + _length(across, up)
            shortest[0], shortest[1] = min(shortest[0], length), min(shortest[1], length)


@kernel()
def _reach(unfolding, search, vertex, length):
    """Note a way to a vertex."""
    distances, tally = search.distances, search.tally
    if length >= distances[vertex]:
        return
    if distances[vertex] == np.inf:
        if tally[_SEEN] == search.seen.size:
            tally[_GIVEN_UP] = max(tally[_GIVEN_UP], unfolding.turning[vertex])
            return
        search.seen[tally[_SEEN]], search.expanded[tally[_SEEN]] = vertex, not unfolding.turning[vertex]
        tally[_SEEN] += 1
    distances[vertex] = length


@kernel()
def _enter(search, edge, ends, p, q, right, left, offset):
    """Let the strip wait that goes on through ``edge`` from p, on the right, to q, as far as it can be seen.

    It is left out if all of it is too far, or if all of it is nearer by way of p or q, vertices ``ends`` (Xin
    & Wang 2009, "Improving Chen and Han's Algorithm on the Discrete Geodesic Problem", ACM TOG 28 (4)).
    """
    if edge < 0:
        return
    tally, across = search.tally, (q[0] - p[0], q[1] - p[1])
    squared = across[0] ** 2 + across[1] ** 2
    before, beyond = p[0] * right[1] - p[1] * right[0], p[0] * left[1] - p[1] * left[0]
    by_right, by_left = (
        before - (q[0] * right[1] - q[1] * right[0]),
        beyond - (q[0] * left[1] - q[1] * left[0]),
    )
    low = 0.0 if by_right == 0 else min(1.0, max(0.0, before / by_right))
    high = 1.0 if by_left == 0 else max(low, min(1.0, beyond / by_left))
    foot = min(high, max(low, -(p[0] * across[0] + p[1] * across[1]) / squared))
    if offset + _length(p[0] + foot * across[0], p[1] + foot * across[1]) >= search.shortest[1]:
        tally[_CUT] = 1
        return
    length = np.sqrt(squared)
    first = offset + _length(p[0] + low * across[0], p[1] + low * across[1])
    final = offset + _length(p[0] + high * across[0], p[1] + high * across[1])
    past_p, past_q = search.distances[ends[0]] + high * length, search.distances[ends[1]] + (1 - low) * length
    if past_p < final - _SAME * length or past_q < first - _SAME * length:
        return
    if tally[_WAITING] == search.edges.size:
        tally[_GIVEN_UP] = 1
        return
    place = (tally[_NEXT] + tally[_WAITING]) % search.edges.size
    search.edges[place] = edge
    strip = search.strips[place]
    strip[0], strip[1], strip[2], strip[3] = q[0], q[1], p[0], p[1]
    strip[4], strip[5], strip[6], strip[7] = right[0], right[1], left[0], left[1]
    tally[_WAITING] += 1


@kernel()
def _leave(unfolding, marks, search, edge, weights, own, offset):
    """Look at all of the triangle of ``edge``, from the place there that has these weights, and around it."""
    face, turn = edge // 3, edge % 3
    length = unfolding.lengths[face, turn]
    x, y = np.zeros(3), np.zeros(3)
    x[1], x[2], y[2] = length, length * unfolding.apexes[edge, 0], length * unfolding.apexes[edge, 1]
    x -= weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2]
    y -= weights[0] * y[0] + weights[1] * y[1] + weights[2] * y[2]
    _arrive(marks, search, face, turn, x, y, np.zeros(4), own, offset)
    for k in range(3):
        vertex = unfolding.triangles[face, (turn + k) % 3]
        _reach(unfolding, search, vertex, offset + _length(x[k], y[k]))
    for k in range(3):
        j, side = (k + 1) % 3, (turn + k) % 3
        if weights[k] < 1 and weights[j] < 1:
            ends = (unfolding.triangles[face, side], unfolding.triangles[face, (side + 1) % 3])
            p, q = (x[k], y[k]), (x[j], y[j])
            _enter(search, unfolding.twins[face, side], ends, p, q, p, q, offset)


@kernel()
def _follow(unfolding, marks, search, own, offset, most):
    """Unfold one triangle after another, as far as it can be seen."""
    tally, xs, ys = search.tally, np.empty(3), np.empty(3)
    while tally[_WAITING] > 0 and tally[_LOOKED] < most:
        edge, strip = search.edges[tally[_NEXT]], search.strips[tally[_NEXT]]
        tally[_NEXT] = (tally[_NEXT] + 1) % search.edges.size
        tally[_WAITING] -= 1
        tally[_LOOKED] += 1
        ax, ay, bx, by, rx, ry, lx, ly = strip
        face, turn = edge // 3, edge % 3
        ux, uy, x, y = bx - ax, by - ay, unfolding.apexes[edge, 0], unfolding.apexes[edge, 1]
        cx, cy = ax + ux * x - uy * y, ay + uy * x + ux * y
        xs[0], xs[1], xs[2], ys[0], ys[1], ys[2] = ax, bx, cx, ay, by, cy
        _arrive(marks, search, face, turn, xs, ys, strip[4:], own, offset)
        right, left = _SLACK * (abs(rx) + abs(ry)), _SLACK * (abs(lx) + abs(ly))
        after, before, far = rx * cy - ry * cx, cx * ly - cy * lx, -(abs(cx) + abs(cy))
        corners = unfolding.triangles[face]
        from_a, from_b, apex = corners[turn], corners[(turn + 1) % 3], corners[(turn + 2) % 3]
        if after >= far * right and before >= far * left:
            _reach(unfolding, search, apex, offset + _length(cx, cy))
        c, r, l = (cx, cy), (rx, ry), (lx, ly)
        if after > 0:
            twin = unfolding.twins[face, (turn + 1) % 3]
            _enter(search, twin, (from_b, apex), (bx, by), c, r, c if before > 0 else l, offset)
        if before > 0:
            twin = unfolding.twins[face, (turn + 2) % 3]
            _enter(search, twin, (apex, from_a), c, (ax, ay), c if after > 0 else r, l, offset)
    if tally[_WAITING] > 0:
        tally[_GIVEN_UP] = 1


@kernel()
def _next_turn(search):
    """The nearest vertex from which ways have not been looked at, as its place among those seen; or -1."""
    nearest, least = -1, search.shortest[1]
    for k in range(search.tally[_SEEN]):
        if not search.expanded[k]:
            if search.distances[search.seen[k]] < least:
                nearest, least = k, search.distances[search.seen[k]]
            else:
                search.tally[_CUT] = 1
    return nearest


@kernel(parallel=True)
def find_nearest(first, last, unfolding, marks, edges, weights, own, reach, most, found, certain):
    """The least distance along the surface from each start to a mark other than its own.

    edges : int64 (n,), 3 t of the triangle t of each start; weights : float64 (n, 3). own : int64 (n,), the
    mark not to find, or -1. reach : float64 (n,), above 0, how far to look at first; twice as far where there
    is none. most : strips that are looked at for a start. found : float64 (n,), filled; infinite where there
    is no other mark on this part of the surface. certain : bool (n,), filled; False where the search was
    given up, so that something may be nearer than ``found``.
    """
    search = Search(
        np.empty(_DEEP, np.int64),
        np.empty((_DEEP, 8)),
        np.full(unfolding.turning.size, np.inf),
        np.empty(_TURNS, np.int64),
        np.empty(_TURNS, np.bool_),
        np.empty(2),
        np.zeros(6, np.int64),
    )
    tally, corner = search.tally, np.array([1.0, 0.0, 0.0])
    for s in range(first, last):
        limit = reach[s]
        tally[_LOOKED] = tally[_GIVEN_UP] = 0
        while True:
            tally[_WAITING] = tally[_SEEN] = tally[_CUT] = 0
            search.shortest[0], search.shortest[1] = np.inf, limit
            _leave(unfolding, marks, search, edges[s], weights[s], own[s], 0.0)
            _follow(unfolding, marks, search, own[s], 0.0, most)
            source = _next_turn(search)
            while source >= 0 and tally[_GIVEN_UP] == 0:
                search.expanded[source] = True
                vertex = search.seen[source]
                offset = search.distances[vertex]
                for fan in range(unfolding.fan_starts[vertex], unfolding.fan_starts[vertex + 1]):
                    _leave(unfolding, marks, search, unfolding.fans[fan], corner, own[s], offset)
                    _follow(unfolding, marks, search, own[s], offset, most)
                source = _next_turn(search)
            search.distances[search.seen[: tally[_SEEN]]] = np.inf
            if search.shortest[0] <= limit or tally[_CUT] == 0 or tally[_GIVEN_UP] == 1:
                break
            limit *= 2
        found[s], certain[s] = search.shortest[0], tally[_GIVEN_UP] == 0
