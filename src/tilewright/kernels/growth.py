"""Growing points in parts of a small torus of tiles: darts of a shrinking radius, then pushing apart.

The torus has W x H tiles; its parts are the corner regions, edge strips and interiors that a radius r
divides tiles into. ``part_at`` numbers them.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.chance import draw_unit, draw_word
from tilewright.kernels.compiled import kernel
from tilewright.kernels.polygons import cut_cell, enlarge, find_centroid, find_reach, is_cut, start_cell

# Kinds of parts: 0 corner region, 1 strip along a row edge (on a line y = integer, east of its lattice
# point), 2 strip along a column edge, 3 interior.
_SHRINK, _FAILURES = 0.99, 300
_HALVINGS = 4
_APART = 1000.0
"""Width and height of a torus so large that nothing meets around it."""


class Torus(NamedTuple):
    """A torus of tiles and its parts."""

    width: int
    """Tiles along x."""
    height: int
    """Tiles along y."""
    r: float
    """Radius of the regions around corners and edges, in tiles."""
    cusp: bool
    """Whether corner regions are small with cusps, or else octagons."""
    open: NDArray[np.bool_]
    """(4 width height,): which parts take new points."""


class Effort(NamedTuple):
    """How points are grown."""

    distance: float
    """The least distance, in tiles."""
    lloyd: int
    """Iterations of Lloyd's method."""
    attempts: int
    """Times to begin anew where points do not come apart."""
    sweeps: int
    """Rounds of pushing points apart in each attempt."""


class Frame(NamedTuple):
    """The points of corner regions and edge strips, and which of these each of T tiles has around it."""

    items: NDArray[np.int32]
    """(T, 8): numbers of a tile's corner regions and edge strips."""
    offsets: NDArray[np.float64]
    """(8, 2): where these lie in the tile."""
    points: NDArray[np.float64]
    """(items, slots, 2), as seen from each item's lattice point."""
    counts: NDArray[np.int32]
    """(items,): points of each."""


@kernel(inline=True)
def kind_at(x, y, r, cusp):
    """Kind of the part that holds a point of the tile lattice."""
    s = r * 1.4142135623730951
    ax, ay = abs(x - np.floor(x + 0.5)), abs(y - np.floor(y + 0.5))
    if cusp:
        corner = (ay <= r and ax <= s + ay) or (ax <= r and ay <= s + ax)
    else:
        corner = ax <= s + r and ay <= s + r and ax + ay <= s + 2.0 * r
    if corner:
        return 0
    if ay <= r:
        return 1
    if ax <= r:
        return 2
    return 3


@kernel(inline=True)
def part_at(x, y, torus):
    """Number of the part: kind + 4 (column + width row) of its tile or lattice point."""
    kind = kind_at(x, y, torus.r, torus.cusp)
    column = np.int64(np.floor(x + 0.5)) if kind == 0 or kind == 2 else np.int64(np.floor(x))
    row = np.int64(np.floor(y + 0.5)) if kind == 0 or kind == 1 else np.int64(np.floor(y))
    return kind + 4 * (column % torus.width + torus.width * (row % torus.height))


@kernel()
def is_crowded(x, y, points, count, skip, width, height, least):
    """Whether one of ``count`` points but number ``skip`` is closer than the square root of ``least``."""
    for j in range(count):
        if j == skip:
            continue
        dx, dy = abs(points[j, 0] - x), abs(points[j, 1] - y)
        if dx > 0.5 * width:
            dx = abs(dx - width * np.round(dx / width))
        if dy > 0.5 * height:
            dy = abs(dy - height * np.round(dy / height))
        if dx * dx + dy * dy < least:
            return True
    return False


@kernel()
def throw_relaxed(key, points, fixed, count, torus, distance):
    """Fill points[fixed:count] by relaxation dart throwing (McCool & Fiume 1992) in the open parts.

    The first darts keep ``distance``, which shrinks by a factor after so many failures.
    """
    width, height = torus.width, torus.height
    failures, thrown = 0, 0
    placed = fixed
    while placed < count:
        x, y = draw_unit(key, thrown) * width, draw_unit(key, thrown + 1) * height
        thrown += 2
        if torus.open[part_at(x, y, torus)]:
            if not is_crowded(x, y, points, placed, -1, width, height, distance * distance):
                points[placed, 0], points[placed, 1] = x, y
                placed += 1
                failures = 0
                continue
            failures += 1
            if failures == _FAILURES:
                distance *= _SHRINK
                failures = 0


@kernel()
def push_apart(points, fixed, count, torus, distance, sweeps):
    """Move points[fixed:count] until no two points are closer than ``distance``; whether that came about.

    Each sweep moves every point away from those too close, by a little more than half of what is missing,
    or all of it where the other one is fixed. A move out of the open parts is shortened.
    """
    width, height = torus.width, torus.height
    for _ in range(sweeps):
        crowded = False
        for i in range(fixed, count):
            x, y = points[i, 0], points[i, 1]
            mx = my = 0.0
            for j in range(count):
                dx, dy = x - points[j, 0], y - points[j, 1]
                if abs(dx) > 0.5 * width:
                    dx -= width * np.round(dx / width)
                if abs(dy) > 0.5 * height:
                    dy -= height * np.round(dy / height)
                square = dx * dx + dy * dy
                if j != i and square < distance * distance:
                    crowded = True
                    apart = np.sqrt(square)
                    share = (1.0 if j < fixed else 0.55) * (distance * 1.0005 - apart)
                    if apart > 1e-9:
                        mx += dx / apart * share
                        my += dy / apart * share
                    else:
                        mx += share
            if mx != 0.0 or my != 0.0:
                slide(points, i, mx, my, torus)
        if not crowded:
            return True
    return False


@kernel()
def slide(points, i, mx, my, torus):
    """Move point i, by less where the whole way leads out of the open parts: along an axis, or shorter."""
    x, y = points[i, 0], points[i, 1]
    for step in range(_HALVINGS):
        scale = 0.5**step
        for way in range(3):
            nx = x + (mx * scale if way != 2 else 0.0)
            ny = y + (my * scale if way != 1 else 0.0)
            if torus.open[part_at(nx, ny, torus)]:
                points[i, 0], points[i, 1] = nx, ny
                return


@kernel()
def relax_cells(points, fixed, count, torus, iterations):
    """Move points[fixed:count] to the centroids of their Voronoi cells, again and again (Lloyd 1982).

    A move out of the open parts is shortened (Lagae 2007, section 4.3).
    """
    width, height = torus.width, torus.height
    extent, walls = np.array([np.float64(width), np.float64(height)]), np.zeros(4)
    moves = np.empty((count, 2))
    polygon, spare = np.empty((64, 3)), np.empty((64, 3))
    for _ in range(iterations):
        for i in range(fixed, count):
            corners = start_cell(0.0, 0.0, extent, True, walls, polygon)
            reach = find_reach(polygon, corners)
            for j in range(count):
                dx, dy = points[j, 0] - points[i, 0], points[j, 1] - points[i, 1]
                dx, dy = dx - width * np.round(dx / width), dy - height * np.round(dy / height)
                if j != i and dx * dx + dy * dy < 4 * reach and is_cut(polygon, corners, dx, dy):
                    spare = enlarge(spare, corners + 1)
                    corners = cut_cell(polygon, corners, dx, dy, 0.0, spare)
                    polygon, spare = spare, polygon
                    reach = find_reach(polygon, corners)
            _, moves[i, 0], moves[i, 1] = find_centroid(polygon, corners)
        for i in range(fixed, count):
            slide(points, i, moves[i, 0], moves[i, 1], torus)


@kernel()
def grow(key, points, fixed, count, torus, effort):
    """Fill points[fixed:count] so that no two are closer than ``effort.distance``; whether it succeeded.

    Relaxation dart throwing, Lloyd's method, and pushing apart what is still too
    close; all over again where that does not come to an end.
    """
    for attempt in range(effort.attempts):
        throw_relaxed(draw_word(key, attempt), points, fixed, count, torus, 1.2 * effort.distance)
        relax_cells(points, fixed, count, torus, effort.lloyd)
        if push_apart(points, fixed, count, torus, effort.distance, effort.sweeps):
            return True
    return False


@kernel(parallel=True)
def grow_parts(first, last, keys, fixed, fixed_counts, count, torus, effort, kind, out, out_counts):
    """Fill tori around fixed points and cut a part out of each: that of ``kind`` at lattice point (0, 0).

    keys : uint64 (m,). fixed : float64 (m, most, 2), fixed_counts : int32 (m,). count : points of a torus.
    out : float64 (m, slots, 2), the part's points as seen from the lattice point. out_counts : int32 (m,),
    or -1 where the torus could not be filled.
    """
    for m in range(first, last):
        n = np.int64(fixed_counts[m])
        out_counts[m] = grow_part(keys[m], fixed[m], n, count, torus, effort, kind, out[m])


@kernel()
def grow_part(key, fixed, fixed_count, count, torus, effort, kind, out):
    """Fill one torus and write its part; how many points that are, or -1."""
    points = np.empty((max(count, fixed.shape[0]), 2))
    for i in range(fixed_count):
        points[i, 0], points[i, 1] = fixed[i, 0], fixed[i, 1]
    if fixed_count > count or not grow(key, points, fixed_count, count, torus, effort):
        return -1
    n = 0
    for i in range(fixed_count, count):
        x, y = points[i, 0], points[i, 1]
        if part_at(x, y, torus) != kind:
            continue
        # An edge reaches from its lattice point to the next one, a corner region around it.
        x -= torus.width * (np.round(x / torus.width) if kind != 1 else np.floor(x / torus.width))
        y -= torus.height * (np.round(y / torus.height) if kind != 2 else np.floor(y / torus.height))
        out[n, 0], out[n, 1] = x, y
        n += 1
    return n


@kernel()
def assemble(tile, frame, out):
    """Write the frame points around a tile, in the tile's coordinates; how many there are."""
    n = 0
    for k in range(frame.items.shape[1]):
        item = frame.items[tile, k]
        for s in range(frame.counts[item]):
            out[n, 0] = frame.points[item, s, 0] + frame.offsets[k, 0]
            out[n, 1] = frame.points[item, s, 1] + frame.offsets[k, 1]
            n += 1
    return n


@kernel()
def count_inside(points, count):
    """How many of the points lie in the tile [0, 1) x [0, 1)."""
    n = 0
    for i in range(count):
        x, y = points[i, 0], points[i, 1]
        if 0.0 <= x < 1.0 and 0.0 <= y < 1.0:
            n += 1
    return n


@kernel(parallel=True)
def grow_interiors(first, last, keys, frame, wanted, r, cusp, effort, inner, inner_counts):
    """Fill the interior of every tile so that the whole tile holds ``wanted`` points.

    keys : uint64 (m,), one for each interior, variants of a tile one after another.
    inner : float64 (m, slots, 2), filled. inner_counts : int32 (m,), points written, or -1 for a tile whose
    interior could not be filled.
    """
    per_tile = len(keys) // len(frame.items)
    for m in range(first, last):
        inner_counts[m] = grow_interior(keys[m], m // per_tile, frame, wanted, r, cusp, effort, inner[m])


@kernel()
def grow_interior(key, tile, frame, wanted, r, cusp, effort, inner):
    """Fill the interior of one tile; how many points that takes, or -1."""
    points = np.empty((frame.points.shape[1] * 8 + inner.shape[0], 2))
    fixed = assemble(tile, frame, points)
    n = wanted - count_inside(points, fixed)
    torus = open_interior(r, cusp)
    if not 0 <= n <= inner.shape[0] or not grow(key, points, fixed, fixed + n, torus, effort):
        return -1
    for s in range(n):
        inner[s, 0], inner[s, 1] = points[fixed + s, 0], points[fixed + s, 1]
    return n


@kernel()
def open_interior(r, cusp):
    """A torus of 2 x 2 tiles of which the interior of the first takes points."""
    open = np.zeros(16, np.bool_)
    open[3] = True
    return Torus(2, 2, r, cusp, open)


@kernel(parallel=True)
def move_interiors(first, last, frame, r, cusp, distance, moves, sweeps, inner, inner_counts, settled):
    """Move interior points by ``moves`` and push them apart; say which interiors keep the distance.

    moves : float64 (m, slots, 2). settled : bool (m,), filled.
    """
    per_tile = len(inner) // len(frame.items)
    for m in range(first, last):
        points = np.empty((frame.points.shape[1] * 8 + inner.shape[1], 2))
        fixed = assemble(m // per_tile, frame, points)
        torus = open_interior(r, cusp)
        n = inner_counts[m]
        for s in range(n):
            points[fixed + s, 0], points[fixed + s, 1] = inner[m, s, 0], inner[m, s, 1]
            slide(points, fixed + s, moves[m, s, 0], moves[m, s, 1], torus)
        settled[m] = push_apart(points, fixed, fixed + n, torus, distance, sweeps)
        for s in range(n):
            inner[m, s, 0], inner[m, s, 1] = points[fixed + s, 0], points[fixed + s, 1]


@kernel()
def move_frame(moves, kinds, meets, meet_offsets, meet_counts, r, cusp, distance, frame, frame_counts):
    """Move frame points one after another, by less where they would leave their part, cross the border of
    their tile or come too close to a point that can be near them.

    moves : float64 (items, slots, 2). kinds : int8 (items,). meets : int32 (items, n), the items that can
    be near; meet_offsets : float64 (items, n, 2), where these lie, seen from the item; meet_counts.
    """
    least = distance * distance
    for item in range(len(frame)):
        for s in range(frame_counts[item]):
            x, y = frame[item, s, 0], frame[item, s, 1]
            for step in range(_HALVINGS + 1):
                nx, ny = x + moves[item, s, 0] * 0.5**step, y + moves[item, s, 1] * 0.5**step
                if kind_at(nx, ny, r, cusp) != kinds[item] or crosses(x, y, nx, ny, kinds[item]):
                    continue
                if is_crowded(nx, ny, frame[item], frame_counts[item], s, _APART, _APART, least):
                    continue
                free = True
                for k in range(meet_counts[item]):
                    other = meets[item, k]
                    ox, oy = nx - meet_offsets[item, k, 0], ny - meet_offsets[item, k, 1]
                    if is_crowded(ox, oy, frame[other], frame_counts[other], -1, _APART, _APART, least):
                        free = False
                        break
                if free:
                    frame[item, s, 0], frame[item, s, 1] = nx, ny
                    break


@kernel(inline=True)
def crosses(x, y, nx, ny, kind):
    """Whether the way from (x, y) leads into another tile, seen from the item's lattice point."""
    across_x = (kind == 0 or kind == 2) and (x < 0) != (nx < 0)
    across_y = (kind == 0 or kind == 1) and (y < 0) != (ny < 0)
    return across_x or across_y


@kernel()
def mark_kind(r, cusp, kind, out):
    """Write 1 where the middle of a pixel of a tile lies in a part of ``kind``, else 0: out [x, y]."""
    n = out.shape[0]
    for i in range(n):
        for j in range(n):
            out[i, j] = 1.0 if kind_at((i + 0.5) / n, (j + 0.5) / n, r, cusp) == kind else 0.0
