"""Points over a tile set whose neighbors are known only to be among those that fit.

points : float64 (P, 2) or (T, room, 2), 0 <= x, y < 1 in the tile. Directions are numbered from 0 to 7;
offsets : int64 (8, 2), the cell there, x first. starts : int64 (8, T + 1), members : int32; the tiles that
can be in direction d of tile t are members[starts[d, t] : starts[d, t + 1]].
"""

import numpy as np

from tilewright.kernels.chance import draw_unit
from tilewright.kernels.compiled import kernel
from tilewright.kernels.polygons import (
    copy_rows,
    cut_cell,
    enlarge,
    find_centroid,
    find_reach,
    is_cut,
    start_cell,
)


@kernel(inline=True)
def find_gap(x, y, ox, oy):
    """Squared distance from a point of a tile to the tile at an offset of one cell."""
    dx = 1.0 - x if ox > 0 else (x if ox < 0 else 0.0)
    dy = 1.0 - y if oy > 0 else (y if oy < 0 else 0.0)
    return dx * dx + dy * dy


@kernel()
def is_clear(x, y, tile, points, counts, offsets, starts, members, least):
    """Whether a point of a tile is no closer than the root of ``least`` to any point that can be near."""
    for i in range(counts[tile]):
        dx, dy = points[tile, i, 0] - x, points[tile, i, 1] - y
        if dx * dx + dy * dy < least:
            return False
    for d in range(8):
        ox, oy = offsets[d, 0], offsets[d, 1]
        if find_gap(x, y, ox, oy) >= least:
            continue
        for m in range(starts[d, tile], starts[d, tile + 1]):
            other = members[m]
            for i in range(counts[other]):
                dx, dy = points[other, i, 0] + ox - x, points[other, i, 1] + oy - y
                if dx * dx + dy * dy < least:
                    return False
    return True


@kernel()
def throw_tile_darts(
    key, darts, thrown, missed, patience, distance, offsets, starts, members, points, counts
):
    """Throw up to ``darts`` more darts at the tiles of a set; return how many were thrown and how many missed
    in a row, at most ``patience``.

    A dart stays if no point that can be near it is closer than ``distance``. Its coordinates are of single
    precision. counts : int64 (T,), points in each tile.
    """
    least = distance * distance
    last = thrown + darts
    while thrown < last and missed < patience:
        tile = np.int64(draw_unit(key, 3 * thrown) * counts.size)
        x = np.float64(np.float32(draw_unit(key, 3 * thrown + 1)))
        y = np.float64(np.float32(draw_unit(key, 3 * thrown + 2)))
        thrown += 1
        missed += 1
        if x < 1.0 and y < 1.0 and is_clear(x, y, tile, points, counts, offsets, starts, members, least):
            points[tile, counts[tile], 0], points[tile, counts[tile], 1] = x, y
            counts[tile] += 1
            missed = 0
    return thrown, missed


@kernel(parallel=True)
def average_moves(first, last, points, offsets, neighborhoods, moves):
    """The way of each point to the centroid of its Voronoi cell, mean over neighborhoods of its tile.

    points : float64 (T, n, 2). neighborhoods : int32 (T, K, 8), tiles in the directions of ``offsets``.
    moves : float64 (T, n, 2), filled.
    """
    n = points.shape[1]
    for p in range(first, last):
        tile, i = p // n, p % n
        own, cell, spare = np.empty((32, 3)), np.empty((32, 3)), np.empty((32, 3))
        x, y = points[tile, i, 0], points[tile, i, 1]
        # What the points of its own tile leave is the same in all neighborhoods.
        extent = np.full(2, 3.0)
        corners = start_cell(x + 1.0, y + 1.0, extent, False, np.zeros(4), own)
        corners, own, spare = cut_by_tile(own, corners, spare, x, y, points[tile], i, 0, 0)
        mx = my = 0.0
        for k in range(neighborhoods.shape[1]):
            cell = enlarge(cell, corners)
            copy_rows(own, corners, cell)
            left = corners
            for d in range(8):
                ox, oy = offsets[d, 0], offsets[d, 1]
                if find_gap(x, y, ox, oy) < 4.0 * find_reach(cell, left):
                    left, cell, spare = cut_by_tile(
                        cell, left, spare, x, y, points[neighborhoods[tile, k, d]], -1, ox, oy
                    )
            _, cx, cy = find_centroid(cell, left)
            mx += cx
            my += cy
        moves[tile, i, 0] = mx / neighborhoods.shape[1]
        moves[tile, i, 1] = my / neighborhoods.shape[1]


@kernel()
def cut_by_tile(cell, corners, spare, x, y, others, skip, ox, oy):
    """Cut a cell around (x, y) by the points of a tile at an offset, but for number ``skip``.

    Returns its corners and both scratches, which may have grown.
    """
    reach = find_reach(cell, corners)
    for j in range(others.shape[0]):
        dx, dy = others[j, 0] + ox - x, others[j, 1] + oy - y
        square = dx * dx + dy * dy
        if j != skip and square < 4.0 * reach and is_cut(cell, corners, dx, dy):
            spare = enlarge(spare, corners + 1)
            corners = cut_cell(cell, corners, dx, dy, 0.0, spare)
            cell, spare = spare, cell
            reach = find_reach(cell, corners)
    return corners, cell, spare
