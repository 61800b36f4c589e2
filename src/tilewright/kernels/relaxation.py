"""Cuts, bands and relaxation over the pixels of tiles, whose borders meet those of other tiles."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel(parallel=True)
def relax_tiles(first, last, values, wanted, band, beside, push, out):
    """Move every pixel of a band towards the mean of its four neighbors and what is wanted there.

    values, wanted : float32 (T, n, n). band : bool (T, n, n). beside : int64 (4, T), the tile east, west,
    south and north of each. push : float32, how far: 1 is onto the mean, more is beyond it.
    out : float32 (T, n, n), what is moved, where values are of another round. 0 outside the band stays 0.
    """
    n = values.shape[1]
    quarter = np.float32(0.25)
    for t in range(first, last):
        tile, east, west = values[t], values[beside[0, t]], values[beside[1, t]]
        south, north = values[beside[2, t]], values[beside[3, t]]
        for y in range(n):
            row, near, moved = tile[y], band[t, y], out[t, y]
            above = tile[y - 1] if y > 0 else north[n - 1]
            below = tile[y + 1] if y < n - 1 else south[0]
            source = wanted[t, y]
            for x in range(n):
                left = row[x - 1] if x > 0 else west[y, n - 1]
                right = row[x + 1] if x < n - 1 else east[y, 0]
                mean = (source[x] + (right + left + below[x] + above[x])) * quarter
                step = push * (mean - moved[x])
                moved[x] += step if near[x] else np.float32(0)


@kernel(parallel=True)
def grow_tiles(first, last, near, beside, out):
    """Pixels that are near or have a neighbor that is.

    near, out : bool (T, n, n). beside : as in `relax_tiles`.
    """
    n = near.shape[1]
    for t in range(first, last):
        tile, east, west = near[t], near[beside[0, t]], near[beside[1, t]]
        south, north = near[beside[2, t]], near[beside[3, t]]
        for y in range(n):
            row, grown = tile[y], out[t, y]
            above = tile[y - 1] if y > 0 else north[n - 1]
            below = tile[y + 1] if y < n - 1 else south[0]
            for x in range(n):
                left = row[x - 1] if x > 0 else west[y, n - 1]
                right = row[x + 1] if x < n - 1 else east[y, 0]
                grown[x] = row[x] | left | right | above[x] | below[x]


@kernel(parallel=True)
def find_cuts(first, last, origins, beside, sizes, out):
    """Which neighbors a pixel does not continue though both could go on in their sources.

    origins : uint16 (T, n, n, 3), (source, y, x). beside : as in `relax_tiles`. sizes : int64 (sources, 2),
    height and width. out : uint8 (T, n, n), filled: bits 0 to 3 for the neighbors east, west, south, north.
    """
    n = origins.shape[1]
    for t in range(first, last):
        for y in range(n):
            for x in range(n):
                bits = 0
                here = origins[t, y, x]
                for side in range(4):
                    dx, dy = (side == 0) - (side == 1), (side == 2) - (side == 3)
                    row, column, tile = y + dy, x + dx, t
                    if not (0 <= row < n and 0 <= column < n):
                        tile, row, column = beside[side, t], row % n, column % n
                    there = origins[tile, row, column]
                    on_y, on_x = np.int64(here[1]) + dy, np.int64(here[2]) + dx
                    back_y, back_x = np.int64(there[1]) - dy, np.int64(there[2]) - dx
                    if here[0] == there[0] and on_y == there[1] and on_x == there[2]:
                        continue
                    ours, theirs = sizes[here[0]], sizes[there[0]]
                    if not (0 <= on_y < ours[0] and 0 <= on_x < ours[1]):
                        continue
                    if 0 <= back_y < theirs[0] and 0 <= back_x < theirs[1]:
                        bits |= 1 << side
                out[t, y, x] = bits
