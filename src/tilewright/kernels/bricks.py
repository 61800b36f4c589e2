"""Endless brick walls: the positions of edges along rows and columns, and the tiles between them.

An edge keeps its color across an H tile along the row, and across a V tile along the column; across the
others it changes. A row falls into blocks of 64 cells, a column into blocks of 32, each with at least two
changes. The color behind the first change of a block is hashed, the next are other than the one before, and
the last is also other than the one with which the next block begins. So no color depends on what is farther
off than the block before.
"""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.flips import ODD_CELLS
from tilewright.kernels.lattice import finish_word, start_row

_EDGES = 13
"""Stream BRICK_EDGES of `tilewright.tilings.streams`, in these layers: steps at cells, colors that rows and
columns of blocks begin with, and for two positions one bit for each column and each row of points."""
_STEPS, _ALONG, _DOWN, _COLUMNS, _ROWS = range(5)
BLOCK = 32
"""Rows of a block of a column."""
_LOW = np.int64(0xFFFFFFFF)
_ONE, _TOP = np.uint64(1), np.uint64(63)
_PAIRS = np.uint64(0xCCCCCCCCCCCCCCCC)
"""Bits at the cells where x modulo 4 is 2 or 3."""


@kernel()
def color_points(first, y, layer, seed, n, out):
    """Colors of ``n`` at the points ``first`` and following of row y; out uint8."""
    a, b = np.uint32(0), np.uint32(0)
    high = np.int64(0)
    for k in range(out.size):
        x = first + k
        if k == 0 or x >> 32 != high:
            high = x >> 32
            a, b = start_row(_EDGES, seed, layer, high, y)
        h = finish_word(a, b, np.uint32(x & _LOW))
        out[k] = np.uint32(np.uint32((h >> np.uint32(8)) * np.uint32(n)) >> np.uint32(24))


@kernel()
def find_top(word):
    """The position of the highest bit of a word that is not 0."""
    place = np.int64(0)
    for half in (32, 16, 8, 4, 2, 1):
        high = word >> np.uint64(half)
        if high:
            word, place = high, place + half
    return place


@kernel()
def number_bits(fours, twos, ones, out):
    """Numbers of 64 cells from the bits of three words; out int32 (64,), filled."""
    for j in range(64):
        shift = np.uint64(j)
        high = (fours >> shift & _ONE) << np.uint64(2) | (twos >> shift & _ONE) << _ONE
        out[j] = np.int32(high | ones >> shift & _ONE)


@kernel()
def mark_ends(cells, firsts, lasts):
    """The first and the last H cell of each column of a block; cells, firsts, lasts : uint64 (32, words)."""
    for k in range(cells.shape[1]):
        seen = np.uint64(0)
        for i in range(BLOCK):
            firsts[i, k] = ~cells[i, k] & ~seen
            seen |= ~cells[i, k]
        seen = np.uint64(0)
        for i in range(BLOCK - 1, -1, -1):
            lasts[i, k] = ~cells[i, k] & ~seen
            seen |= ~cells[i, k]


@kernel(inline=True)
def scale_word(word, count):
    """A number below ``count`` from the high half of a word."""
    return np.int32(np.uint32((word >> np.uint32(16)) * np.uint32(count)) >> np.uint32(16))


@kernel(inline=True)
def step_color(c, n, word, following, last):
    """A color other than c; where ``last`` is 1, also other than ``following``."""
    away = following - c
    if away < 0:
        away += n
    bound = np.int32(last and away != 0)
    step = 1 + scale_word(word, n - 1 - bound)
    step += bound & np.int32(step >= away)
    c += step
    return c - n if c >= n else c


@kernel()
def walk_row(cells, flags, words, n, start, following, sums, wests):
    """Colors of the vertical edges of 64 cells, from that in wests[0] on.

    cells : word of classes. flags : int32 (64,), 4 is set at V cells. words : uint32 (64,), hashed.
    start, following : the colors behind the first V cell here and in the next word. sums, wests : int32
    (65,), the first written over, the second filled.
    """
    first, last = find_top(cells & (~cells + _ONE)), find_top(cells)
    # Step 1: all steps but the first and the last, added up and taken modulo n.
    for j in range(64):
        sums[j + 1] = (1 + scale_word(words[j], n - 1)) * (flags[j] >> 2)
    sums[0] = sums[first + 1] = 0
    total = start
    for j in range(65):
        total += sums[j]
        sums[j] = total
    inverse, before = 65536 // n + 1, wests[0]
    for j in range(65):
        c = sums[j] - (sums[j] * inverse >> 16) * n
        wests[j] = c if j > first else before
    # Step 2: the last step.
    end = step_color(wests[last], n, words[last], following, 1)
    for j in range(last + 1, 65):
        wests[j] = end


@kernel()
def walk_columns(flags, words, n, starts, norths, souths):
    """Colors of the edges to the south of 64 cells.

    flags : 4 is set at V cells, 2 and 1 at the first and the last H cell of a column's block. starts :
    int32 (64,), the color behind the first, and 256 times that of the next block.
    """
    for j in range(64):
        new = step_color(norths[j], n, words[j], starts[j] >> 8, flags[j] & 1)
        new = starts[j] & 255 if flags[j] & 2 else new
        souths[j] = norths[j] if flags[j] & 4 else new


@kernel()
def number_tiles(flags, n, norths, souths, wests, out):
    """Tiles of 64 cells from their edges, numbered as in `tilewright.tiles.bricks`."""
    for j in range(64):
        north, south, west, east = norths[j], souths[j], wests[j], wests[j + 1]
        vertical = north + west - np.int32(west > east)
        horizontal = south + (n - 2) * np.int32(south > north)
        out[j] = (north * n + east) * (2 * n - 2) + (vertical if flags[j] & 4 else horizontal)


@kernel()
def lay_row(cells, firsts, lasts, word, y, n, seed, starts, norths, out):
    """Tiles of one row of a chunk.

    cells, firsts, lasts : uint64 (words,) of this row. starts : int32 (64 words,), as in `walk_columns`.
    norths : int32 (64 words,), colors to the north, replaced by those to the south. out : int32, filled.
    """
    flags, souths = np.empty(64, np.int32), np.empty(64, np.int32)
    sums, wests = np.empty(65, np.int32), np.zeros(65, np.int32)
    words, along = np.empty(64, np.uint32), np.empty(cells.size + 1, np.uint8)
    color_points(word, y, _ALONG, seed, n, along)
    a, b = np.uint32(0), np.uint32(0)
    high = np.int64(0)
    for k in range(cells.size):
        x = (word + k) << 6
        if k == 0 or x >> 32 != high:
            high = x >> 32
            a, b = start_row(_EDGES, seed, _STEPS, high, y)
        low = np.uint32(x & _LOW)
        for j in range(64):
            words[j] = finish_word(a, b, np.uint32(low + np.uint32(j)))
        number_bits(cells[k], firsts[k], lasts[k], flags)
        here = slice(64 * k, 64 * k + 64)
        wests[0] = wests[64]
        walk_row(cells[k], flags, words, n, np.int32(along[k]), np.int32(along[k + 1]), sums, wests)
        walk_columns(flags, words, n, starts[here], norths[here], souths)
        number_tiles(flags, n, norths[here], souths, wests, out[here])
        for j in range(64):
            norths[64 * k + j] = souths[j]


@kernel()
def lay_chunk(classes, margin, side, word, top, first, skip, n, seed, out):
    """Tiles of a part of the wall, for three positions and more.

    classes : uint64, with ``margin`` rows and ``side`` words to leave out all around. What remains starts at
    word ``word`` and at row ``top``, with which a block begins; that word, and the rows north of row
    ``first``, at least a block, only lead to the others. skip : cells west of out. out : int32 (h, w),
    filled, from row ``first`` on.
    """
    cells = classes[margin : classes.shape[0] - margin, side : classes.shape[1] - side]
    rows, words = cells.shape
    firsts, lasts = np.empty((BLOCK, words), np.uint64), np.empty((BLOCK, words), np.uint64)
    colors, starts = np.empty(64 * words, np.uint8), np.empty(64 * words, np.int32)
    norths, line = np.zeros(64 * words, np.int32), np.empty(64 * words, np.int32)
    n = np.int32(n)
    for start in range(0, rows, BLOCK):
        block = cells[start : start + BLOCK]
        mark_ends(block, firsts, lasts)
        number = (top + start) // BLOCK
        color_points(word << 6, number + 1, _DOWN, seed, n, colors)
        for j in range(colors.size):
            starts[j] = np.int32(colors[j]) << 8
        color_points(word << 6, number, _DOWN, seed, n, colors)
        for j in range(colors.size):
            starts[j] += colors[j]
        for i in range(BLOCK):
            y = top + start + i
            if y >= first + out.shape[0]:
                break
            lay_row(block[i], firsts[i], lasts[i], word, y, n, seed, starts, norths, line)
            if y >= first:
                for j in range(out.shape[1]):
                    out[y - first, j] = line[skip + j]


@kernel()
def add_base(heights, word, row, seed):
    """Make flips since the draughtboard into heights; heights uint64 (h, words), in place.

    xy + x(x - 1)y/2 + xy(y - 1)/2 has the second difference 1 + x + y along x and y, which is the
    draughtboard; a random bit for each column and each row of points changes no second difference.
    """
    height, words = heights.shape
    columns, rows = np.empty(64 * words, np.uint8), np.empty(height, np.uint8)
    color_points(word << 6, 0, _COLUMNS, seed, 2, columns)
    color_points(row, 0, _ROWS, seed, 2, rows)
    for k in range(words):
        line = np.uint64(0)
        for j in range(64):
            line |= np.uint64(columns[64 * k + j]) << np.uint64(j)
        for i in range(height):
            base = ODD_CELLS ^ _PAIRS if (row + i) & 1 else np.uint64(0)
            base ^= ODD_CELLS if (row + i) & 2 else np.uint64(0)
            heights[i, k] ^= line ^ (~base if rows[i] else base)


@kernel()
def lay_heights(flips, margin, side, word, row, skip, seed, out):
    """Tiles of a part of the wall for two positions, from heights h.

    N is h(x, y) + h(x + 1, y) and W is x + h(x, y) + h(x, y + 1). flips : uint64, replaced by heights, with
    ``margin`` rows and ``side`` words to leave out; what remains starts at ``word`` and ``row``, and has one
    row and one word more than needed. skip : cells west of out. out : int32 (h, w), filled.
    """
    heights = flips[margin : flips.shape[0] - margin, side : flips.shape[1] - side]
    add_base(heights, word, row, seed)
    words = heights.shape[1]
    line = np.empty(64 * words, np.int32)
    for i in range(out.shape[0]):
        north, south = heights[i], heights[i + 1]
        for k in range(words - 1):
            next_north = north[k] >> _ONE | north[k + 1] << _TOP
            next_south = south[k] >> _ONE | south[k + 1] << _TOP
            east = next_north ^ next_south ^ ~ODD_CELLS
            number_bits(north[k] ^ next_north, east, south[k] ^ next_south, line[64 * k : 64 * k + 64])
        for j in range(out.shape[1]):
            out[i, j] = line[skip + j]
