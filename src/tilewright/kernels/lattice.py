"""Colors on the integer lattice and the tiles they make: the inner loops of direct tilings."""

import numba
import numpy as np

from tilewright.kernels.compiled import kernel

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


@kernel(parallel=True)
def fill_colors(x_low, runs, x_high, y, z, stream, seed, count, out):
    """Color of ``count`` at every lattice point of the grid ``y`` x ``x``.

    x_low : uint32 (w,); columns runs[k] up to runs[k + 1] have high word x_high[k].
    y : int64 (h,). out : uint8 (h, w), filled.
    """
    for i in numba.prange(y.size):
        for k in range(x_high.size):
            a, b = start_row(stream, seed, z, x_high[k], y[i])
            for j in range(runs[k], runs[k + 1]):
                h = finish_word(a, b, x_low[j])
                out[i, j] = np.uint32(np.uint32((h >> np.uint32(8)) * count) >> np.uint32(24))


@kernel(parallel=True)
def fill_words(x, y, z, stream, seed, out):
    """The hash of lattice points given one by one: x, y, z int64 (n,), out uint32 (n,)."""
    for p in numba.prange(x.size):
        a, b = start_row(stream, seed, z[p], x[p] >> 32, y[p])
        out[p] = finish_word(a, b, np.uint32(x[p] & np.int64(0xFFFFFFFF)))


@kernel(parallel=True)
def fill_corner_ids(corners, colors, out):
    """Index of a complete set's corner tile at each cell (Lagae 2007, eq. 2.5).

    corners : uint8 (h + 1, w + 1), color of each lattice point. out : int32 (h, w), filled.
    """
    height, width = out.shape
    c = np.int32(colors)
    for i in numba.prange(height):
        for j in range(width):
            north = np.int32(corners[i, j + 1]) * c + np.int32(corners[i + 1, j + 1])
            out[i, j] = (north * c + np.int32(corners[i + 1, j])) * c + np.int32(corners[i, j])


@kernel(parallel=True)
def fill_wang_ids(horizontal, vertical, colors_h, colors_v, out):
    """Index of a complete set's Wang tile at each cell (Lagae 2007, eq. 2.2).

    horizontal : uint8 (h + 1, w), colors of the N and S edges; vertical : uint8 (h, w + 1), of the W
    and E edges. out : int32 (h, w), filled.
    """
    height, width = out.shape
    c, d = np.int32(colors_h), np.int32(colors_v)
    for i in numba.prange(height):
        for j in range(width):
            code = np.int32(horizontal[i, j]) * d + np.int32(vertical[i, j + 1])
            out[i, j] = (code * c + np.int32(horizontal[i + 1, j])) * d + np.int32(vertical[i, j])
