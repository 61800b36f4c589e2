"""Darts that stay where no point is near, looked up on a grid, in any dimension.

home : int64 (d,), the cell of a point along each axis, scratch.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.chance import draw_unit, draw_word
from tilewright.kernels.compiled import kernel
from tilewright.kernels.polygons import put_inside


class Cells(NamedTuple):
    """A box or torus cut into cells, and the points that lie in each."""

    points: NDArray[np.float64]
    """(n, d), of which kernels fill row after row."""
    heads: NDArray[np.int32]
    """(prod(counts),), in C order: a point of each cell, or -1."""
    after: NDArray[np.int32]
    """(n,): for each point the next of its cell, or -1."""
    counts: NDArray[np.int64]
    """(d,): cells along each axis."""
    offsets: NDArray[np.int64]
    """(m, d): cells to look at around a cell, nearest first."""
    extent: NDArray[np.float64]
    """(d,): size of the box."""
    torus: bool
    """Whether opposite sides meet."""


@kernel(inline=True)
def find_home(point, counts, extent, home):
    """The cell of a point, into ``home``; its number in C order."""
    cell = np.int64(0)
    for a in range(extent.size):
        home[a] = min(np.int64(point[a] * counts[a] / extent[a]), counts[a] - 1)
        cell = cell * counts[a] + home[a]
    return cell


@kernel(inline=True)
def find_cell(home, offsets, k, counts, torus):
    """Number of the cell at offset k from ``home``, or -1 outside a plain box."""
    cell = np.int64(0)
    for a in range(home.size):
        at = home[a] + offsets[k, a]
        if at < 0 or at >= counts[a]:
            if not torus:
                return np.int64(-1)
            at %= counts[a]
        cell = cell * counts[a] + at
    return cell


@kernel(inline=True)
def find_square(point, points, i, extent, torus):
    """Squared distance to point i, or to the nearest of its images on a torus."""
    square = 0.0
    for a in range(extent.size):
        gap = abs(points[i, a] - point[a])
        if torus:
            gap = min(gap, extent[a] - gap)
        square += gap * gap
    return square


@kernel(inline=True)
def is_free(point, home, cells, least):
    """Whether no point is closer to ``point``, in cell ``home``, than the square root of ``least``."""
    for k in range(cells.offsets.shape[0]):
        cell = find_cell(home, cells.offsets, k, cells.counts, cells.torus)
        if cell < 0:
            continue
        i = cells.heads[cell]
        while i >= 0:
            if find_square(point, cells.points, i, cells.extent, cells.torus) < least:
                return False
            i = cells.after[i]
    return True


@kernel(inline=True)
def place(point, cell, i, cells):
    """Make ``point`` the point i, in its cell."""
    for a in range(point.size):
        cells.points[i, a] = point[a]
    cells.after[i] = cells.heads[cell]
    cells.heads[cell] = i


@kernel()
def fill_cells(placed, cells):
    """Put the first ``placed`` points into the cells, which are empty."""
    home = np.empty(cells.extent.size, np.int64)
    for i in range(placed):
        cell = find_home(cells.points[i], cells.counts, cells.extent, home)
        cells.after[i] = cells.heads[cell]
        cells.heads[cell] = i


@kernel()
def throw_darts(key, darts, thrown, placed, distance, cells):
    """Throw up to ``darts`` more darts; return how many were thrown and how many points there are.

    A dart stays if no point is closer than ``distance`` (Cook 1986). thrown, placed : what earlier calls
    came to. The cells are filled on.
    """
    d = cells.extent.size
    dart, home = np.empty(d), np.empty(d, np.int64)
    least = distance * distance
    last = thrown + darts
    while thrown < last and placed < cells.points.shape[0]:
        for a in range(d):
            dart[a] = draw_unit(key, thrown * d + a) * cells.extent[a]
        thrown += 1
        cell = find_home(dart, cells.counts, cells.extent, home)
        if is_free(dart, home, cells, least):
            place(dart, cell, placed, cells)
            placed += 1
    return thrown, placed


@kernel()
def relax_darts(key, darts, thrown, placed, missed, distance, floor, factor, patience, cells):
    """Darts as in `throw_darts` whose distance shrinks by ``factor`` after ``patience`` misses in a row
    (McCool & Fiume 1992); return darts thrown, points placed, misses in a row and the distance.

    Stops once the distance is below ``floor``, for which the cells are made.
    """
    d = cells.extent.size
    dart, home = np.empty(d), np.empty(d, np.int64)
    last = thrown + darts
    while thrown < last and placed < cells.points.shape[0] and distance >= floor:
        for a in range(d):
            dart[a] = draw_unit(key, thrown * d + a) * cells.extent[a]
        thrown += 1
        cell = find_home(dart, cells.counts, cells.extent, home)
        if is_free(dart, home, cells, distance * distance):
            place(dart, cell, placed, cells)
            placed += 1
            missed = 0
        else:
            missed += 1
            if missed == patience:
                distance *= factor
                missed = 0
    return thrown, placed, missed, distance


@kernel()
def draw_around(key, drawn, center, distance, extent, torus, dart):
    """A dart at one to two times ``distance`` from ``center``, uniform; whether it is in the box, and how
    many numbers were drawn."""
    d = extent.size
    while True:
        square = 0.0
        for a in range(d):
            dart[a] = 4.0 * draw_unit(key, drawn + a) - 2.0
            square += dart[a] * dart[a]
        drawn += d
        if 1.0 <= square < 4.0:
            break
    inside = True
    for a in range(d):
        at = center[a] + dart[a] * distance
        inside = inside and (torus or 0 <= at < extent[a])
        dart[a] = put_inside(at, extent[a], torus)
    return inside, drawn


@kernel()
def grow_around(key, drawn, placed, last, waiting, active, tries, distance, cells):
    """Throw darts around points until none waits or there are ``last``.

    A point waits until ``tries`` darts in a row have found no room around it. active : int32 (n,), the points
    that wait. The cells are filled on. Returns how many numbers were drawn, the points placed and how many
    wait.
    """
    d, extent = cells.extent.size, cells.extent
    dart, home = np.empty(d), np.empty(d, np.int64)
    if placed == 0:
        for a in range(d):
            dart[a] = draw_unit(key, a) * extent[a]
        place(dart, find_home(dart, cells.counts, extent, home), 0, cells)
        active[0] = 0
        drawn, placed, waiting = d, 1, 1
    while waiting > 0 and placed < last:
        at = np.int64(draw_word(key, drawn) % np.uint64(waiting))
        drawn += 1
        found = False
        for _ in range(tries):
            center = cells.points[active[at]]
            inside, drawn = draw_around(key, drawn, center, distance, extent, cells.torus, dart)
            if not inside:
                continue
            cell = find_home(dart, cells.counts, extent, home)
            if is_free(dart, home, cells, distance * distance):
                place(dart, cell, placed, cells)
                active[waiting] = placed
                placed, waiting, found = placed + 1, waiting + 1, True
                break
        if not found:
            waiting -= 1
            active[at] = active[waiting]
    return drawn, placed, waiting
