"""Colors on the integer lattice and the tiles they make: the inner loops of direct tilings."""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.threads import ParallelKernel

# Xorshift-multiply constants of Wellons' hash prospector ("lowbias32").
_M1 = np.uint32(0x21F0AAAD)
_M2 = np.uint32(0xD35A2D97)


@kernel(inline=True)
def mix(h):
    """A bijection of 32-bit words in which every bit of the result depends on every bit given."""
    h = np.uint32(h ^ (h >> np.uint32(16)))
    h = np.uint32(h * _M1)
    h = np.uint32(h ^ (h >> np.uint32(15)))
    h = np.uint32(h * _M2)
    return np.uint32(h ^ (h >> np.uint32(15)))


@kernel()
def absorb_word(a, b, word):
    """Take one more word into the two words of state."""
    a = mix(np.uint32(a ^ word))
    b = mix(np.uint32(np.uint32(b ^ a) + word))
    return a, b


@kernel()
def start_row(stream, seed, z, x_high, y):
    """State after everything but the low word of x."""
    low = np.int64(0xFFFFFFFF)
    a, b = absorb_word(np.uint32(0x243F6A88), np.uint32(0x85A308D3), np.uint32(stream))
    a, b = absorb_word(a, b, np.uint32(seed & low))
    a, b = absorb_word(a, b, np.uint32((seed >> 32) & low))
    a, b = absorb_word(a, b, np.uint32(z & low))
    a, b = absorb_word(a, b, np.uint32((z >> 32) & low))
    a, b = absorb_word(a, b, np.uint32(x_high & low))
    a, b = absorb_word(a, b, np.uint32((y >> 32) & low))
    return absorb_word(a, b, np.uint32(y & low))


@kernel(inline=True)
def finish_word(a, b, x_low):
    """The hash of a lattice point, from its row's state."""
    h = np.uint32(x_low ^ a)
    h = np.uint32(h ^ (h >> np.uint32(16)))
    h = np.uint32(np.uint32(h * _M1) + b)
    h = np.uint32(h ^ (h >> np.uint32(15)))
    h = np.uint32(h * _M2)
    return np.uint32(h ^ (h >> np.uint32(15)))


@kernel()
def color_row(x_low, runs, x_high, y, z, stream, seed, count, out):
    """Color of ``count`` at every point of a row.

    x_low : uint32 (w,); columns runs[k] up to runs[k + 1] have high word x_high[k].
    y, z : int64. out : uint8 (w,), filled.
    """
    for k in range(x_high.size):
        a, b = start_row(stream, seed, z, x_high[k], y)
        # Slices count from 0, which lets the loop be vectorized.
        low, row = x_low[runs[k] : runs[k + 1]], out[runs[k] : runs[k + 1]]
        for j in range(row.size):
            h = finish_word(a, b, low[j])
            row[j] = np.uint32(np.uint32((h >> np.uint32(8)) * count) >> np.uint32(24))


@kernel(parallel=True)
def fill_colors(first, last, x_low, runs, x_high, y, z, stream, seed, count, out):
    """Color of ``count`` at every lattice point of the grid ``y`` x ``x``.

    x_low, runs, x_high : as in `color_row`. y : int64 (h,). out : uint8 (h, w), filled.
    """
    for i in range(first, last):
        color_row(x_low, runs, x_high, y[i], z, stream, seed, count, out[i])


@kernel(parallel=True)
def fill_words(first, last, x, y, z, stream, seed, out):
    """The hash of lattice points given one by one: x, y, z int64 (n,), out uint32 (n,)."""
    for p in range(first, last):
        a, b = start_row(stream, seed, z[p], x[p] >> 32, y[p])
        out[p] = finish_word(a, b, np.uint32(x[p] & np.int64(0xFFFFFFFF)))


@kernel()
def fill_corner_rows(first, last, x_low, runs, x_high, y, seed, colors, out):
    """Index of a complete set's corner tile at each cell (Lagae 2007, section 3.3.1 and eq. 2.5).

    The thesis lets y grow up, so that the tile at (x, y) has h(x, y) at SW; here y grows south and h(x, y) is
    at NW: c_NE, c_SE, c_SW, c_NW are h(x+1, y), h(x+1, y+1), h(x, y+1), h(x, y).
    x_low, runs, x_high : the w + 1 columns of lattice points, as in `color_row`. y : int64 (h + 1,).
    out : int32 (h, w), filled.
    """
    width = out.shape[1]
    c = np.int32(colors)
    lines = np.empty((2, width + 1), np.uint8)
    color_row(x_low, runs, x_high, y[first], 0, 0, seed, colors, lines[first & 1])
    for i in range(first, last):
        row, north, south = out[i], lines[i & 1], lines[(i + 1) & 1]
        color_row(x_low, runs, x_high, y[i + 1], 0, 0, seed, colors, south)
        for j in range(width):
            east = np.int32(north[j + 1]) * c + np.int32(south[j + 1])
            row[j] = (east * c + np.int32(south[j])) * c + np.int32(north[j])


fill_corner_ids = ParallelKernel(fill_corner_rows)


@kernel(parallel=True)
def fill_classed_ids(
    first, last, x_low, runs, x_high, y, seed, colors, column_classes, row_classes, classes, out
):
    """Index of the tile of a classed corner set at each cell: that of a complete set in the class at NW.

    x_low, runs, x_high : the w + 1 columns of lattice points, as in `color_row`. y : int64 (h + 1,).
    column_classes : int32 (w,), class of NW corners in row 0; row_classes : int32 (h,), what rows add.
    out : int32 (h, w), filled.
    """
    fill_corner_rows(first, last, x_low, runs, x_high, y, seed, colors, out)
    tiles, most = np.int32(colors) ** 4, np.int32(classes)
    for i in range(first, last):
        ahead, row = np.int32(row_classes[i]), out[i]
        for j in range(row.size):
            at = column_classes[j] + ahead
            row[j] += tiles * (at - most if at >= most else at)


@kernel(parallel=True)
def fill_wang_ids(
    first, last, h_low, h_runs, h_high, v_low, v_runs, v_high, h_rows, v_rows, seed, colors_h, colors_v, out
):
    """Index of a complete set's Wang tile at each cell (Lagae 2007, section 3.3.2.3 and eq. 2.2).

    h_low, h_runs, h_high : the w columns of horizontal edges, as in `color_row`; h_rows : int64 (h + 1,).
    v_low, v_runs, v_high : the w + 1 columns of vertical edges; v_rows : int64 (h,).
    out : int32 (h, w), filled.
    """
    width = out.shape[1]
    c, d = np.int32(colors_h), np.int32(colors_v)
    lines, across = np.empty((2, width), np.uint8), np.empty(width + 1, np.uint8)
    color_row(h_low, h_runs, h_high, h_rows[first], 0, 0, seed, colors_h, lines[first & 1])
    for i in range(first, last):
        row, north, south = out[i], lines[i & 1], lines[(i + 1) & 1]
        color_row(h_low, h_runs, h_high, h_rows[i + 1], 0, 0, seed, colors_h, south)
        color_row(v_low, v_runs, v_high, v_rows[i], 0, 0, seed, colors_v, across)
        for j in range(width):
            code = np.int32(north[j]) * d + np.int32(across[j + 1])
            row[j] = (code * c + np.int32(south[j])) * d + np.int32(across[j])
