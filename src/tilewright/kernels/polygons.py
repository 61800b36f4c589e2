"""Voronoi cells: convex polygons around a point, cut by the bisectors with other points.

polygon : float64 (room, 3), corners counterclockwise where y is up: x and y, with the point at the origin,
and a number for the edge to the next corner.
"""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel()
def start_cell(x, y, extent, torus, walls, polygon):
    """Make the cell of a point alone: the box, or on a torus what is nearer to it than its own images.

    walls : float64 (4,), numbers of the edges south (least y), east, north and west.
    """
    if torus:
        west, east, south, north = -extent[0] / 2, extent[0] / 2, -extent[1] / 2, extent[1] / 2
    else:
        west, east, south, north = -x, extent[0] - x, -y, extent[1] - y
    polygon[0, 0], polygon[0, 1], polygon[0, 2] = west, south, walls[0]
    polygon[1, 0], polygon[1, 1], polygon[1, 2] = east, south, walls[1]
    polygon[2, 0], polygon[2, 1], polygon[2, 2] = east, north, walls[2]
    polygon[3, 0], polygon[3, 1], polygon[3, 2] = west, north, walls[3]
    return 4


@kernel()
def is_cut(polygon, corners, x, y):
    """Whether a point at (x, y) takes anything from a cell."""
    half = 0.5 * (x * x + y * y)
    farthest = 0.0
    for i in range(corners):
        farthest = max(farthest, polygon[i, 0] * x + polygon[i, 1] * y)
    return farthest > half


@kernel()
def cut_cell(polygon, corners, x, y, number, out):
    """Cut a cell by the bisector with a point at (x, y) into ``out``; the number of corners left.

    The new edge gets ``number``; ``out`` has room for one corner more than there are.
    """
    half = 0.5 * (x * x + y * y)
    left = 0
    here = polygon[0, 0] * x + polygon[0, 1] * y - half
    for i in range(corners):
        j = i + 1 if i + 1 < corners else 0
        there = polygon[j, 0] * x + polygon[j, 1] * y - half
        if here <= 0:
            for a in range(3):
                out[left, a] = polygon[i, a]
            left += 1
        if (here <= 0) != (there <= 0) and (here < 0 or there < 0):
            t = here / (here - there)
            out[left, 0] = polygon[i, 0] + t * (polygon[j, 0] - polygon[i, 0])
            out[left, 1] = polygon[i, 1] + t * (polygon[j, 1] - polygon[i, 1])
            out[left, 2] = number if here < 0 else polygon[i, 2]
            left += 1
        here = there
    return left


@kernel()
def find_reach(polygon, corners):
    """Squared distance to the farthest corner."""
    reach = 0.0
    for i in range(corners):
        reach = max(reach, polygon[i, 0] * polygon[i, 0] + polygon[i, 1] * polygon[i, 1])
    return reach


@kernel()
def copy_rows(rows, count, out):
    """Copy the first ``count`` rows."""
    for i in range(count):
        for j in range(rows.shape[1]):
            out[i, j] = rows[i, j]


@kernel()
def enlarge(rows, needed):
    """``rows`` or, if it has fewer than ``needed``, a copy with at least twice as many."""
    if needed <= rows.shape[0]:
        return rows
    larger = np.empty((max(needed, 2 * rows.shape[0]), rows.shape[1]))
    copy_rows(rows, rows.shape[0], larger)
    return larger


@kernel()
def find_bound(x, k, cell, count, side, torus):
    """Least distance along an axis from x, in ``cell``, to a cell k steps away; infinity if there is none."""
    bound = np.inf
    if k <= (count if torus else count - 1 - cell):
        bound = (cell + k) * side - x
    if k <= (count if torus else cell):
        bound = min(bound, x - (cell - k + 1) * side)
    return bound


@kernel()
def find_voronoi_cell(p, points, starts, counts, extent, torus, polygon, spare):
    """The Voronoi cell of point p; its corners, the square of the distance to the nearest point, and both
    scratches, which may have grown.

    points : float64 (n, 2), sorted by cell of a grid; starts : int64, where each cell begins. The cell is
    cut by the points of ever wider rings of cells until these are too far to cut any more. Each way at
    most once around a torus is enough: farther images lie behind nearer ones.
    """
    x, y = points[p, 0], points[p, 1]
    nx, ny = counts[0], counts[1]
    cx, cy = min(np.int64(x * (nx / extent[0])), nx - 1), min(np.int64(y * (ny / extent[1])), ny - 1)
    corners = start_cell(x, y, extent, torus, np.zeros(4), polygon)
    reach, nearest = find_reach(polygon, corners), np.inf
    if torus:
        nearest = min(extent[0], extent[1]) ** 2
    for k in range(max(nx, ny) + 1):
        if k > 0:
            bound = min(
                find_bound(x, k, cx, nx, extent[0] / nx, torus),
                find_bound(y, k, cy, ny, extent[1] / ny, torus),
            )
            if bound == np.inf or (bound > 0 and bound * bound >= 4 * reach):
                break
        for i in range(-k, k + 1):
            column = cx + i
            lap_x = column // nx
            if (not torus and lap_x != 0) or lap_x < -1 or lap_x > 1:
                continue
            step = 1 if abs(i) == k else 2 * k
            for j in range(-k, k + 1, step):
                row = cy + j
                lap_y = row // ny
                if (not torus and lap_y != 0) or lap_y < -1 or lap_y > 1:
                    continue
                cell = (column - lap_x * nx) * ny + row - lap_y * ny
                for q in range(starts[cell], starts[cell + 1]):
                    if q == p:
                        continue
                    ax = points[q, 0] + lap_x * extent[0] - x
                    ay = points[q, 1] + lap_y * extent[1] - y
                    square = ax * ax + ay * ay
                    nearest = min(nearest, square)
                    if square < 4 * reach and is_cut(polygon, corners, ax, ay):
                        spare = enlarge(spare, corners + 1)
                        corners = cut_cell(polygon, corners, ax, ay, 0.0, spare)
                        polygon, spare = spare, polygon
                        reach = find_reach(polygon, corners)
    return corners, nearest, polygon, spare


@kernel()
def find_centroid(polygon, corners):
    """Area of a polygon and its centroid."""
    area = mx = my = 0.0
    for i in range(corners):
        j = i + 1 if i + 1 < corners else 0
        cross = polygon[i, 0] * polygon[j, 1] - polygon[j, 0] * polygon[i, 1]
        area += cross / 2
        mx += (polygon[i, 0] + polygon[j, 0]) * cross / 6
        my += (polygon[i, 1] + polygon[j, 1]) * cross / 6
    if area <= 0:
        return 0.0, 0.0, 0.0
    return area, mx / area, my / area


@kernel()
def put_inside(x, extent, torus):
    """A coordinate of 0 <= x < extent: around the torus, or the nearest one of the box."""
    if torus:
        x -= np.floor(x / extent) * extent
        return x if x < extent else 0.0
    return min(max(x, 0.0), np.nextafter(extent, 0.0))


@kernel(parallel=True)
def move_to_centroids(first, last, points, starts, counts, extent, torus, moved, areas, nearest):
    """The centroid of each point's Voronoi cell, the cell's area and how far the nearest point is.

    points, starts, counts : as in `find_voronoi_cell`. moved : float64 (n, 2), areas and nearest : float64
    (n,), filled; nearest is measured before the move.
    """
    polygon, spare = np.empty((32, 3)), np.empty((32, 3))
    for p in range(first, last):
        corners, square, polygon, spare = find_voronoi_cell(
            p, points, starts, counts, extent, torus, polygon, spare
        )
        areas[p], x, y = find_centroid(polygon, corners)
        moved[p, 0] = put_inside(points[p, 0] + x, extent[0], torus)
        moved[p, 1] = put_inside(points[p, 1] + y, extent[1], torus)
        nearest[p] = np.sqrt(square)
