"""The points of tiles over a medial domain, placed on the triangles below."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel()
def weigh_corners(u, v, sides):
    """Barycentric coordinates of (u, v) in a triangle of the plane, sides : (3, 2)."""
    ax, ay = sides[1, 0] - sides[0, 0], sides[1, 1] - sides[0, 1]
    bx, by = sides[2, 0] - sides[0, 0], sides[2, 1] - sides[0, 1]
    x, y = u - sides[0, 0], v - sides[0, 1]
    area = ax * by - ay * bx
    second = (x * by - y * bx) / area
    third = (ax * y - ay * x) / area
    return 1.0 - second - third, second, third


@kernel()
def find_triangle(u, v, first, last, sides):
    """The triangle of a face that (u, v) lies in, or lies least outside of."""
    best, most = first, -np.inf
    for t in range(first, last):
        a, b, c = weigh_corners(u, v, sides[t])
        inside = min(a, b, c)
        if inside > most:
            best, most = t, inside
        if inside >= 0.0:
            break
    return best


@kernel(parallel=True)
def find_triangles(first, last, bases, uv, starts, sides, out):
    """The triangle below each place of a face's parameter polygon.

    bases : int64 (n,); uv : float64 (n, 2); starts : int64 (F + 1,); sides : float64 (T, 3, 2).
    """
    for i in range(first, last):
        out[i] = find_triangle(uv[i, 0], uv[i, 1], starts[bases[i]], starts[bases[i] + 1], sides)


@kernel(parallel=True)
def lay_tiles(first, last, tiles, rows, below, sides, most, places, out):
    """The points of each tile whose rank is small enough for the place they come to lie in.

    tiles : starts int64 (t + 1,) of its corners, sectors int64, turns int64 (t,), rows int64 (t,).
    rows : starts int64, sectors uint8, points float32 (P, 2): what the distinct tiles hold.
    below : bases int64 (S,), triangles float64 (S, 3, 2) of the sectors, face starts int64 (F + 1,).
    sides : float64 (T, 3, 2): the triangles of the surface in parameter polygons.
    most : float64 (S,): the share of its points that a sector may need.
    places : int64 (t,): where the points of each tile begin in ``out``.
    out : numbers int32, sectors int64, triangles int32, weights float64 (n, 3), counts int32 (t,); where
    numbers are empty, points are counted only.
    """
    corner_starts, corner_sectors, turns, kinds = tiles
    row_starts, row_sectors, row_points = rows
    bases, triangles, face_starts = below
    numbers, sectors, found, weights, counts = out
    for t in range(first, last):
        corners = corner_starts[t + 1] - corner_starts[t]
        begin, end = row_starts[kinds[t]], row_starts[kinds[t] + 1]
        kept = 0
        for n in range(end - begin):
            p = begin + n
            sector = corner_sectors[corner_starts[t] + (row_sectors[p] + turns[t]) % corners]
            if sector < 0 or n > most[sector] * (end - begin):
                continue
            if numbers.size:
                x, y = row_points[p, 0], row_points[p, 1]
                apex, here, there = 2.0 * y, 1.0 - x - y, x - y
                at = triangles[sector]
                u = apex * at[0, 0] + here * at[1, 0] + there * at[2, 0]
                v = apex * at[0, 1] + here * at[1, 1] + there * at[2, 1]
                base = bases[sector]
                below_it = find_triangle(u, v, face_starts[base], face_starts[base + 1], sides)
                a, b, c = weigh_corners(u, v, sides[below_it])
                a, b, c = max(a, 0.0), max(b, 0.0), max(c, 0.0)
                i = places[t] + kept
                numbers[i], sectors[i], found[i] = n, sector, below_it
                weights[i, 0], weights[i, 1], weights[i, 2] = (
                    a / (a + b + c),
                    b / (a + b + c),
                    c / (a + b + c),
                )
            kept += 1
        counts[t] = kept
