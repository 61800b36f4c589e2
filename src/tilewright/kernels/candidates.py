"""The farthest of many candidates (Mitchell 1991), in any dimension.

Of n candidates nearly all are near a point and lose. Where they may be farther from all points than some
distance is kept as a list of small cells; only candidates in those are drawn, as many as would have fallen
there. gaps : float64 (m,), squared distances of the cells at ``cells.offsets``.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.chance import draw_unit
from tilewright.kernels.compiled import kernel
from tilewright.kernels.darts import find_cell, find_home, find_square, place


class Far(NamedTuple):
    """Small cells that may have places far enough from all points to count."""

    threshold: float
    """What the distance of such places is at least, or -1 where all places count."""
    spread: float
    """From the middle of a small cell to a corner."""
    live: NDArray[np.int32]
    """Numbers of these cells, in C order; those that still count come first."""
    places: NDArray[np.int32]
    """(prod(sizes),): where in ``live`` each cell is, or -1."""
    sizes: NDArray[np.int64]
    """(d,): small cells along each axis."""
    around: NDArray[np.int64]
    """(m, d): offsets to the small cells that a new point may take off the list."""


@kernel(inline=True)
def find_nearest(point, home, enough, placed, cells, gaps):
    """Squared distance to the nearest of the points, or any that is no more than ``enough``."""
    nearest = np.inf
    for k in range(cells.offsets.shape[0]):
        if gaps[k] >= nearest:
            return nearest
        cell = find_cell(home, cells.offsets, k, cells.counts, cells.torus)
        if cell < 0:
            continue
        i = cells.heads[cell]
        while i >= 0:
            nearest = min(nearest, find_square(point, cells.points, i, cells.extent, cells.torus))
            if nearest <= enough:
                return nearest
            i = cells.after[i]
    # Farther than the grid looks around: ask them all.
    for i in range(placed):
        nearest = min(nearest, find_square(point, cells.points, i, cells.extent, cells.torus))
    return nearest


@kernel()
def find_corner(cell, sizes, extent, corner):
    """The low corner of a small cell, from its number in C order."""
    for b in range(sizes.size):
        a = sizes.size - 1 - b
        corner[a] = (cell % sizes[a]) * extent[a] / sizes[a]
        cell //= sizes[a]


@kernel()
def measure_cells(sizes, placed, cells, gaps, distances):
    """Distance from the middle of every small cell to the nearest point.

    sizes : int64 (d,), small cells along each axis. distances : float64 (prod(sizes),), filled.
    """
    d, extent = cells.extent.size, cells.extent
    middle, home = np.empty(d), np.empty(d, np.int64)
    for cell in range(distances.size):
        find_corner(cell, sizes, extent, middle)
        for a in range(d):
            middle[a] += 0.5 * extent[a] / sizes[a]
        find_home(middle, cells.counts, extent, home)
        distances[cell] = np.sqrt(find_nearest(middle, home, -1.0, placed, cells, gaps))


@kernel()
def drop_cells(point, far, living, extent, torus):
    """Take the cells off the list that lie within the threshold of a new point; how many are left."""
    threshold, spread, live, places, sizes, around = far
    d = extent.size
    home, corner = np.empty(d, np.int64), np.empty(d)
    find_home(point, sizes, extent, home)
    for k in range(around.shape[0]):
        cell = find_cell(home, around, k, sizes, torus)
        if cell < 0 or places[cell] < 0:
            continue
        find_corner(cell, sizes, extent, corner)
        square = 0.0
        for a in range(d):
            gap = abs(corner[a] + 0.5 * extent[a] / sizes[a] - point[a])
            if torus:
                gap = min(gap, extent[a] - gap)
            square += gap * gap
        if np.sqrt(square) + spread <= threshold:
            living -= 1
            live[places[cell]] = live[living]
            places[live[living]] = places[cell]
            places[cell] = -1
    return living


@kernel()
def draw_candidate(key, drawn, threshold, live, living, sizes, extent, dart):
    """A dart anywhere or, where a threshold is set, in one of the cells that count; numbers drawn then."""
    d = extent.size
    if threshold < 0:
        for a in range(d):
            dart[a] = draw_unit(key, drawn + a) * extent[a]
        return drawn + d
    find_corner(live[np.int64(draw_unit(key, drawn) * living)], sizes, extent, dart)
    for a in range(d):
        dart[a] += draw_unit(key, drawn + 1 + a) * extent[a] / sizes[a]
        dart[a] = min(dart[a], np.nextafter(extent[a], 0.0))
    return drawn + 1 + d


@kernel()
def add_farthest(key, drawn, multiple, placed, last, few, living, far, cells, gaps):
    """Place points up to ``last``, each the farthest from all before of so many candidates as there are
    points before, times ``multiple``.

    living : how many of the cells in ``far.live`` still count; the list is kept up.
    Stops after fewer than ``few`` candidates that count, or before placing one if there was none. Returns
    how many numbers were drawn, the points placed, the cells left and the candidates that counted.
    """
    d, extent, threshold = cells.extent.size, cells.extent, far.threshold
    dart, best, home = np.empty(d), np.empty(d), np.empty(d, np.int64)
    hits = few
    while placed < last and hits >= few:
        candidates = max(multiple * placed, 1)
        rarity = np.log1p(-living / far.places.size) if threshold >= 0 else 0.0
        farthest, hits, c = -1.0, 0, 0
        while True:
            if threshold >= 0:  # candidates that fall elsewhere: so many before the next one
                c += np.int64(min(np.log1p(-draw_unit(key, drawn)) / rarity, 1e15))
                drawn += 1
            if c >= candidates:
                break
            c += 1
            drawn = draw_candidate(key, drawn, threshold, far.live, living, far.sizes, extent, dart)
            find_home(dart, cells.counts, extent, home)
            enough = threshold * threshold if threshold >= 0 else farthest
            square = find_nearest(dart, home, enough, placed, cells, gaps)
            hits += square > enough or threshold < 0
            if square > farthest:
                farthest = square
                for axis in range(d):
                    best[axis] = dart[axis]
        if hits == 0:
            break
        place(best, find_home(best, cells.counts, extent, home), placed, cells)
        placed += 1
        if threshold >= 0:
            living = drop_cells(best, far, living, extent, cells.torus)
    return drawn, placed, living, hits
