"""Ever smaller cells of a grid that still may have room, in any dimension (Ebeida et al. 2012).

Active cells are int64 rows of coordinates at a level: those of the grid's cells, each halved along every
axis ``level`` times. cells : `Cells`, which hold one point at most.
"""

import numpy as np

from tilewright.kernels.chance import draw_unit
from tilewright.kernels.compiled import kernel
from tilewright.kernels.darts import is_free, place


@kernel(inline=True)
def find_base(active, i, level, counts, home):
    """The grid's cell that holds an active one, into ``home``; its number in C order."""
    cell = np.int64(0)
    for a in range(counts.size):
        home[a] = active[i, a] >> level
        cell = cell * counts[a] + home[a]
    return cell


@kernel()
def throw_at_cells(key, first, darts, placed, active, level, distance, cells):
    """Throw darts at active cells, each as likely; the number of points there are then.

    first : number of the key to begin with; every dart draws 1 + d. The cells are filled on.
    """
    d, counts, extent = cells.extent.size, cells.counts, cells.extent
    dart, home = np.empty(d), np.empty(d, np.int64)
    for k in range(darts):
        if placed == cells.points.shape[0]:
            break
        counter = first + k * (d + 1)
        i = np.int64(draw_unit(key, counter) * active.shape[0])
        cell = find_base(active, i, level, counts, home)
        if cells.heads[cell] >= 0:
            continue
        for a in range(d):
            at = (active[i, a] + draw_unit(key, counter + 1 + a)) / np.float64(counts[a] << level)
            dart[a] = min(at * extent[a], np.nextafter(extent[a], 0.0))
        if is_free(dart, home, cells, distance * distance):
            place(dart, cell, placed, cells)
            placed += 1
    return placed


@kernel(inline=True)
def is_covered(middle, half, home, cells, least):
    """Whether one disk covers a box of sizes 2 ``half``, in the grid's cell ``home``, whole."""
    for k in range(cells.offsets.shape[0]):
        cell = np.int64(0)
        outside = False
        for a in range(cells.extent.size):
            at = home[a] + cells.offsets[k, a]
            if at < 0 or at >= cells.counts[a]:
                outside = not cells.torus
                at %= cells.counts[a]
            cell = cell * cells.counts[a] + at
            if outside:
                break
        if outside or cells.heads[cell] < 0:
            continue
        farthest = 0.0
        for a in range(cells.extent.size):
            gap = abs(cells.points[cells.heads[cell], a] - middle[a])
            if cells.torus:
                gap = min(gap, cells.extent[a] - gap)
            farthest += (gap + half[a]) * (gap + half[a])
        if farthest <= least:
            return True
    return False


@kernel()
def split_cells(active, level, distance, cells, out):
    """Halve active cells along every axis and keep the parts not covered by any one disk; their number.

    out : int64 (2^d n, d), filled with cells of the next level.
    """
    d = cells.extent.size
    home, middle, half = np.empty(d, np.int64), np.empty(d), np.empty(d)
    for a in range(d):
        half[a] = 0.5 * cells.extent[a] / np.float64(cells.counts[a] << (level + 1))
    left = 0
    for i in range(active.shape[0]):
        if cells.heads[find_base(active, i, level, cells.counts, home)] >= 0:
            continue
        for part in range(1 << d):
            for a in range(d):
                out[left, a] = 2 * active[i, a] + ((part >> a) & 1)
                middle[a] = (2 * out[left, a] + 1) * half[a]
            if not is_covered(middle, half, home, cells, distance * distance):
                left += 1
    return left
