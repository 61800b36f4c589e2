"""What disks leave free in the Voronoi cells of their centers, and darts that always hit it (Jones 2006).

A cell is nearer to its own point than to any other, so only the disk of that point covers any of it. Corners
of cells are rows of float64 (any, 3), x and y as seen from the point and the edge that follows, numbered
9 neighbor + 3 (lap_x + 1) + lap_y + 1 for the image of the neighbor that many times around a torus, or -1 at
a wall. The table grows, so it goes in and comes back beside the diagram.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.chance import draw_unit
from tilewright.kernels.compiled import kernel
from tilewright.kernels.polygons import cut_cell, enlarge, is_cut, put_inside, start_cell
from tilewright.kernels.weights import CLOSE, STEPS, choose_leaf, set_weight, step_inside

_NOTHING = 1e-12
"""Free area, in squares of the distance, that counts as none: rounding errors make as much."""


class Diagram(NamedTuple):
    """Points of a box or torus, and where the corners of their Voronoi cells are."""

    points: NDArray[np.float64]
    """(n, 2), filled row after row."""
    extent: NDArray[np.float64]
    """(2,): width and height of the box."""
    torus: bool
    """Whether opposite sides meet."""
    starts: NDArray[np.int64]
    """(n,): the row of each cell's first corner."""
    corners: NDArray[np.int64]
    """(n,): how many it has."""
    room: NDArray[np.int64]
    """(n,): rows set aside for it; zero at first."""
    tree: NDArray[np.float64]
    """Free area of each cell, see `weights`."""


@kernel()
def number_edge(i, lap_x, lap_y):
    """The number of an edge with the image of point i."""
    return np.float64(9 * i + 3 * (lap_x + 1) + lap_y + 1)


@kernel()
def measure_piece(h, s, t, square):
    """Area between a circle of the squared radius around the origin and a line at distance h, from s to t
    along it, where the line is outside."""
    return 0.5 * (h * (t - s) - square * np.arctan2(h * (t - s), h * h + s * t))


@kernel()
def find_pieces(ax, ay, bx, by, square):
    """Where the edge from a to b is outside the circle: the line's distance h, its direction, the first
    piece s0 to t0, the second s1 to t1 (from the foot of the perpendicular on; empty where s >= t)."""
    ux, uy = bx - ax, by - ay
    length = np.sqrt(ux * ux + uy * uy)
    if length == 0 or (ax * ax + ay * ay <= square and bx * bx + by * by <= square):
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    ux, uy = ux / length, uy / length
    h = ax * uy - ay * ux
    s, t = ax * ux + ay * uy, bx * ux + by * uy
    if h <= 0:
        return 0.0, ux, uy, 0.0, 0.0, 0.0, 0.0
    if h * h >= square:
        return h, ux, uy, s, t, 0.0, 0.0
    inside = np.sqrt(square - h * h)
    return h, ux, uy, s, min(t, -inside), max(s, inside), t


@kernel()
def measure_free(rows, start, corners, square):
    """Area of a cell outside the disk of its point."""
    area = 0.0
    for i in range(corners):
        j = start + (i + 1 if i + 1 < corners else 0)
        h, _, _, s0, t0, s1, t1 = find_pieces(
            rows[start + i, 0], rows[start + i, 1], rows[j, 0], rows[j, 1], square
        )
        if s0 < t0:
            area += measure_piece(h, s0, t0, square)
        if s1 < t1:
            area += measure_piece(h, s1, t1, square)
    return area if area > _NOTHING * square else 0.0


@kernel()
def find_on_piece(h, s, t, square, amount):
    """Where along the line from s to t the area of `measure_piece` has grown to ``amount``."""
    low, high = s, t
    at = 0.5 * (s + t)
    for _ in range(STEPS):
        before = at
        missing = amount - measure_piece(h, s, at, square)
        at, low, high = step_inside(at, low, high, missing, 0.5 * h * (1.0 - square / (h * h + at * at)))
        if abs(at - before) <= CLOSE * (t - s):
            break
    return at


@kernel()
def draw_free(rows, start, corners, square, amount, chance):
    """A point of the free area of a cell: the one up to which there is ``amount`` of it, edge by edge.

    chance : of [0, 1), says how far out.
    """
    x = y = 0.0
    for i in range(corners):
        j = start + (i + 1 if i + 1 < corners else 0)
        h, ux, uy, s0, t0, s1, t1 = find_pieces(
            rows[start + i, 0], rows[start + i, 1], rows[j, 0], rows[j, 1], square
        )
        for s, t in ((s0, t0), (s1, t1)):
            if s >= t:
                continue
            area = measure_piece(h, s, t, square)
            if area <= 0:
                continue
            along = find_on_piece(h, s, t, square, min(amount, area))
            # Out along the ray, uniform in the square of the distance.
            far = h * h + along * along
            out = np.sqrt((square + chance * max(far - square, 0.0)) / far)
            x, y = out * (h * uy + along * ux), out * (along * uy - h * ux)
            if amount < area:
                return x, y
            amount -= area
    return x, y


@kernel()
def find_cut_cells(owner, x, y, diagram, rows, found):
    """The cells and their images that a new point cuts, from neighbor to neighbor, beginning at ``owner``.

    x, y : the new point, as seen from the owner. found : float64 (room, 5), filled with index, laps around
    the torus in x and y, and the new point as seen from there; returned with their number, it may have grown.
    """
    found[0, 0], found[0, 1], found[0, 2], found[0, 3], found[0, 4] = owner, 0, 0, x, y
    count, at = 1, 0
    while at < count:
        i = np.int64(found[at, 0])
        for k in range(diagram.starts[i], diagram.starts[i] + diagram.corners[i]):
            number = np.int64(rows[k, 2])
            if number < 0:
                continue
            j = number // 9
            lap_x = np.int64(found[at, 1]) + number % 9 // 3 - 1
            lap_y = np.int64(found[at, 2]) + number % 3 - 1
            known = False
            for m in range(count):
                known = known or (found[m, 0] == j and found[m, 1] == lap_x and found[m, 2] == lap_y)
            dx = diagram.points[owner, 0] + x - diagram.points[j, 0] - lap_x * diagram.extent[0]
            dy = diagram.points[owner, 1] + y - diagram.points[j, 1] - lap_y * diagram.extent[1]
            # An image farther away than once around lies behind a nearer one.
            if known or abs(dx) > diagram.extent[0] or abs(dy) > diagram.extent[1]:
                continue
            if is_cut(rows[diagram.starts[j] :], diagram.corners[j], dx, dy):
                found = enlarge(found, count + 1)
                found[count, 0], found[count, 1], found[count, 2] = j, lap_x, lap_y
                found[count, 3], found[count, 4] = dx, dy
                count += 1
        at += 1
    return count, found


@kernel()
def store_cell(i, cell, count, rows, used, starts, corners, room):
    """Write a cell of ``count`` corners as that of point i, at the end if it has outgrown its place."""
    if count > room[i]:
        room[i] = max(8, count + count // 2)
        starts[i] = used
        used += room[i]
        rows = enlarge(rows, used)
    for k in range(count):
        for a in range(3):
            rows[starts[i] + k, a] = cell[k, a]
    corners[i] = count
    return rows, used


@kernel()
def add_first(x, y, square, diagram, rows):
    """Make the cell of the first point."""
    diagram.points[0, 0], diagram.points[0, 1] = x, y
    walls = np.full(4, -1.0)
    if diagram.torus:
        walls[0], walls[1] = number_edge(0, 0, -1), number_edge(0, 1, 0)
        walls[2], walls[3] = number_edge(0, 0, 1), number_edge(0, -1, 0)
    cell = np.empty((4, 3))
    start_cell(x, y, diagram.extent, diagram.torus, walls, cell)
    rows, used = store_cell(0, cell, 4, rows, 0, diagram.starts, diagram.corners, diagram.room)
    set_weight(diagram.tree, 0, measure_free(rows, diagram.starts[0], 4, square))
    return rows, used


@kernel()
def add_point(n, owner, x, y, square, diagram, rows, used, found, cell, spare):
    """Make the n-th point, at (x, y) as seen from ``owner``, in whose cell it lies; cut the cells around it.

    Returns rows, how many are used, and the scratches found, cell and spare, all of which may have grown.
    """
    points, extent, torus, starts, corners, room, tree = diagram
    points[n, 0] = put_inside(points[owner, 0] + x, extent[0], torus)
    points[n, 1] = put_inside(points[owner, 1] + y, extent[1], torus)
    count, found = find_cut_cells(owner, x, y, diagram, rows, found)
    # Laps between where the point was found and where it is stored.
    home_x = np.int64(np.rint((points[owner, 0] + x - points[n, 0]) / extent[0]))
    home_y = np.int64(np.rint((points[owner, 1] + y - points[n, 1]) / extent[1]))
    walls = np.full(4, -1.0)
    if torus:
        walls[0], walls[1] = number_edge(n, 0, -1), number_edge(n, 1, 0)
        walls[2], walls[3] = number_edge(n, 0, 1), number_edge(n, -1, 0)
    own = start_cell(points[n, 0], points[n, 1], extent, torus, walls, cell)
    for m in range(count):
        i = np.int64(found[m, 0])
        lap_x, lap_y = np.int64(found[m, 1]) - home_x, np.int64(found[m, 2]) - home_y
        # The cell of i loses what is nearer to the new point.
        spare = enlarge(spare, corners[i] + 1)
        cut = cut_cell(
            rows[starts[i] :],
            corners[i],
            found[m, 3],
            found[m, 4],
            number_edge(n, -lap_x, -lap_y),
            spare,
        )
        rows, used = store_cell(i, spare, cut, rows, used, starts, corners, room)
        # The new cell loses what is nearer to i.
        spare = enlarge(spare, own + 1)
        own = cut_cell(cell, own, -found[m, 3], -found[m, 4], number_edge(i, lap_x, lap_y), spare)
        cell, spare = spare, cell
    rows, used = store_cell(n, cell, own, rows, used, starts, corners, room)
    for m in range(count):
        i = np.int64(found[m, 0])
        set_weight(tree, i, measure_free(rows, starts[i], corners[i], square))
    set_weight(tree, n, measure_free(rows, starts[n], own, square))
    return rows, used, found, cell, spare


@kernel()
def fill_gaps(key, first, placed, last, distance, diagram, rows, used):
    """Throw darts into the free area until there are ``last`` points or none is left.

    first : numbers of the key drawn before. diagram : `Diagram`, filled on. rows : of which ``used`` are
    taken. Returns the points placed, rows, which may have grown, and how many of them are used.
    """
    square = distance * distance
    extent, tree = diagram.extent, diagram.tree
    found, cell, spare = np.empty((64, 5)), np.empty((64, 3)), np.empty((64, 3))
    if placed == 0:
        x, y = draw_unit(key, first) * extent[0], draw_unit(key, first + 1) * extent[1]
        rows, used = add_first(x, y, square, diagram, rows)
        placed = 1
    while placed < last and tree[1] > 0:
        counter = first + 2 * placed
        i, amount = choose_leaf(tree, draw_unit(key, counter) * tree[1])
        start, corners, chance = diagram.starts[i], diagram.corners[i], draw_unit(key, counter + 1)
        x, y = draw_free(rows, start, corners, square, amount, chance)
        rows, used, found, cell, spare = add_point(
            placed, i, x, y, square, diagram, rows, used, found, cell, spare
        )
        placed += 1
    return placed, rows, used
