"""Points of a window of tiles: copied from their tiles, with the place of the cell added."""

from typing import NamedTuple

import numpy as np

from tilewright.kernels.compiled import kernel


class Sides(NamedTuple):
    """A window, seen from its first cell: left and top are inside, right and bottom are not."""

    left: float
    top: float
    right: float
    bottom: float


@kernel(parallel=True)
def lay_whole_tiles(first, last, cells, points, count, x0, y0, out):
    """All points of every cell of a window, ``count`` of each tile, cell by cell.

    cells : int32 (h, w), rows of the set. points : float32 (rows count 2,), flat. x0, y0 : place of the
    first cell. out : float32 or float64 (h w count 2,), flat, filled.
    """
    width = cells.shape[1]
    size = 2 * count
    for i in range(first, last):
        y = out.dtype.type(y0 + i)
        for j in range(width):
            x = out.dtype.type(x0 + j)
            # Slices count from 0, which lets the loop be vectorized.
            source = points[cells[i, j] * size : (cells[i, j] + 1) * size]
            target = out[(i * width + j) * size : (i * width + j + 1) * size]
            for k in range(count):
                target[2 * k] = x + source[2 * k]
                target[2 * k + 1] = y + source[2 * k + 1]


@kernel(inline=True)
def is_wanted(p, rank, i, j, left, top, right, bottom, points, ranks):
    """Whether point p of the cell in row i and column j lies in a window and below a rank."""
    u, v = j + np.float64(points[p, 0]), i + np.float64(points[p, 1])
    return ranks[p] < rank and left <= u < right and top <= v < bottom


@kernel(parallel=True)
def count_points(first, last, cells, starts, points, ranks, rank, left, top, right, bottom, counts):
    """How many points of each row of cells lie in a window, seen from the first cell, and below a rank.

    starts : int64 (rows + 1,), points : float32 (P, 2), ranks : float32 (P,), of one tile in rising order.
    counts : int64 (h,), filled.
    """
    for i in range(first, last):
        n = np.int64(0)
        for j in range(cells.shape[1]):
            row = cells[i, j]
            if rank >= 1.0 and i >= top and i + 1 <= bottom and j >= left and j + 1 <= right:
                n += starts[row + 1] - starts[row]
                continue
            for p in range(starts[row], starts[row + 1]):
                if is_wanted(p, rank, i, j, left, top, right, bottom, points, ranks):
                    n += 1
        counts[i] = n


@kernel(parallel=True)
def lay_points(first, last, cells, starts, points, ranks, rank, sides, firsts, x0, y0, out, named, names):
    """The points that `count_points` counts, in the order of cells and ranks.

    sides : `Sides`. firsts : int64 (h,), where each row of cells begins in ``out``, float32 or float64
    (n, 2), filled.
    names : int64 (n, 3), filled if ``named``: row and column of the cell, and the number in the tile.
    """
    left, top, right, bottom = sides
    for i in range(first, last):
        n = firsts[i]
        for j in range(cells.shape[1]):
            row = cells[i, j]
            for p in range(starts[row], starts[row + 1]):
                if is_wanted(p, rank, i, j, left, top, right, bottom, points, ranks):
                    out[n, 0] = out.dtype.type(x0 + j) + points[p, 0]
                    out[n, 1] = out.dtype.type(y0 + i) + points[p, 1]
                    if named:
                        names[n, 0], names[n, 1], names[n, 2] = i, j, p - starts[row]
                    n += 1


@kernel(parallel=True)
def find_nearest(first, last, x, y, cells, starts, points, reach, names, squares):
    """The nearest point to each position, among the cells around it.

    x, y : float64 (n,), positions within their own cell. cells : int32 (n, 2 reach + 1, 2 reach + 1), rows
    of the set around it. names : int64 (n, 3), row and column of the cell, from the position's own, and
    the number in the tile. squares : float64 (n,), squared distances; infinity where there is no point.
    """
    for q in range(first, last):
        squares[q] = np.inf
        for i in range(cells.shape[1]):
            for j in range(cells.shape[2]):
                row = cells[q, i, j]
                for p in range(starts[row], starts[row + 1]):
                    dx = (j - reach) + np.float64(points[p, 0]) - x[q]
                    dy = (i - reach) + np.float64(points[p, 1]) - y[q]
                    square = dx * dx + dy * dy
                    if square < squares[q]:
                        squares[q] = square
                        names[q, 0], names[q, 1], names[q, 2] = i - reach, j - reach, p - starts[row]


@kernel(parallel=True)
def lay_first_points(first, last, cells, quotas, firsts, starts, points, x0, y0, out):
    """The first points by rank of each cell.

    quotas : int32 (h, w), how many of each cell. firsts : int64 (h,), where each row of cells begins in
    ``out``, float64 (n, 2), filled.
    """
    for i in range(first, last):
        n = firsts[i]
        for j in range(cells.shape[1]):
            start = starts[cells[i, j]]
            for p in range(start, start + quotas[i, j]):
                out[n, 0], out[n, 1] = x0 + j + np.float64(points[p, 0]), y0 + i + np.float64(points[p, 1])
                n += 1
