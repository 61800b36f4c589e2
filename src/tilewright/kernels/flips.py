"""The classes of an endless brick wall, any part of them by itself: 64 cells to a word.

Bit i of word k of a row is cell 64 k + i: 0 for H, traversed along the row, 1 for V, traversed along the
column. A wall starts as blocks of 2 x 2 cells, HV/VH or VH/HV by hash, in which no run is longer than two.
It is then gone over a number of times: each cell (or each 2 x 2 cells around a lattice point) is flipped if
its hashed bit says so and no run becomes too long. That is done in turns. What has its turn together lies
so far apart that no run can hold two of it, so every turn leaves runs that are short enough, and a cell
depends on the cells near it alone.
"""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.lattice import finish_word, start_row

ODD_CELLS = np.uint64(0xAAAAAAAAAAAAAAAA)
"""Bits at the cells of odd x."""
_ONE = np.uint64(1)
_CLASSES = 12
"""Stream BRICK_CLASSES of `tilewright.tilings.streams`: layer 0 for the blocks, the others for going over."""


@kernel()
def fill_bits(word, row, layer, seed, out):
    """64 hashed bits for each word of a chunk that starts at ``word`` and ``row``; out uint64 (h, words)."""
    a, b = np.uint32(0), np.uint32(0)
    for i in range(out.shape[0]):
        high = np.int64(0)
        for k in range(out.shape[1]):
            x = 2 * (word + k)
            if k == 0 or x >> 32 != high:
                high = x >> 32
                a, b = start_row(_CLASSES, seed, layer, high, row + i)
            low = np.uint32(x & np.int64(0xFFFFFFFF))
            bits = np.uint64(finish_word(a, b, low)) << np.uint64(32)
            out[i, k] = bits | np.uint64(finish_word(a, b, low + np.uint32(1)))


@kernel()
def spread_points(points, i, size, out):
    """Row i of the cells to be flipped, from the points at their corners; out uint64 (words,).

    A single cell is named by its NW corner, a square by the point in its middle.
    """
    words = out.size
    for k in range(words):
        out[k] = points[i, k]
    if size == 1:
        return
    south = min(i + 1, points.shape[0] - 1)
    for k in range(words):
        out[k] |= points[south, k]
    for k in range(words - 1):
        out[k] |= out[k] >> _ONE | (points[i, k + 1] | points[south, k + 1]) << np.uint64(63)
    out[words - 1] |= out[words - 1] >> _ONE


@kernel()
def gather_faults(faults, i, size, out):
    """Row i of the points whose cells hold a fault; the reverse of `spread_points`."""
    words = out.size
    for k in range(words):
        out[k] = faults[i, k]
    if size == 1:
        return
    north = max(i - 1, 0)
    for k in range(words):
        out[k] |= faults[north, k]
    for k in range(words - 1, 0, -1):
        out[k] |= out[k] << _ONE | (faults[i, k - 1] | faults[north, k - 1]) >> np.uint64(63)
    out[0] |= out[0] << _ONE


@kernel()
def mark_row_runs(cells, limit, run, out):
    """Set the bits of ``out`` at the H cells of a row that are in runs of more than ``limit``.

    cells, run, out : uint64 (words,); run is written over.
    """
    words = cells.size
    for k in range(words):
        run[k] = ~cells[k]
    for n in range(1, limit + 1):
        by, rest = np.uint64(n), np.uint64(64 - n)
        for k in range(words - 1):
            run[k] &= ~(cells[k] >> by | cells[k + 1] << rest)
        run[words - 1] &= ~cells[words - 1] >> by
    for k in range(words):
        out[k] = run[k]
    for n in range(1, limit + 1):
        by, rest = np.uint64(n), np.uint64(64 - n)
        out[0] |= run[0] << by
        for k in range(1, words):
            out[k] |= run[k] << by | run[k - 1] >> rest


@kernel()
def mark_column_runs(cells, limit, run, out):
    """The same for the V cells of columns, in addition: cells, out uint64 (h, words)."""
    words = cells.shape[1]
    for i in range(cells.shape[0] - limit):
        for k in range(words):
            run[k] = cells[i, k]
        for n in range(1, limit + 1):
            for k in range(words):
                run[k] &= cells[i + n, k]
        for n in range(limit + 1):
            for k in range(words):
                out[i + n, k] |= run[k]


@kernel()
def pick_turn(bits, word, row, turn, turns, slope, out):
    """The bits at the points that have their turn, x + slope y = turn modulo ``turns``."""
    masks = np.zeros(turns, np.uint64)
    for x in range(64):
        masks[x % turns] |= _ONE << np.uint64(x)
    step = 64 % turns
    for i in range(bits.shape[0]):
        # Bit x of word k is at 64 k + x.
        place = (turn - slope * ((row + i) % turns) - step * (word % turns)) % turns
        for k in range(bits.shape[1]):
            out[i, k] = bits[i, k] & masks[place]
            place -= step
            if place < 0:
                place += turns


@kernel()
def flip_turn(cells, size, along, down, points, trial, faults, line):
    """Flip what ``points`` says wherever that makes no run too long, and clear the other points.

    cells, points, trial, faults : uint64 (h, words), the last two written over; line : uint64 (words,) too.
    """
    height, words = cells.shape
    # Step 1: flip them all on trial, and look for runs that are too long.
    for i in range(height):
        spread_points(points, i, size, line)
        for k in range(words):
            trial[i, k] = cells[i, k] ^ line[k]
        mark_row_runs(trial[i], along, line, faults[i])
    mark_column_runs(trial, down, line, faults)
    # Step 2: flip those without a fault.
    for i in range(height):
        gather_faults(faults, i, size, line)
        for k in range(words):
            points[i, k] &= ~line[k]
    for i in range(height):
        spread_points(points, i, size, line)
        for k in range(words):
            cells[i, k] ^= line[k]


@kernel()
def grow_chunk(word, row, size, along, down, rounds, turns, slope, seed, cells, flips):
    """Classes of a chunk of the wall that starts at ``word`` and ``row``, but for its margins.

    size : 1, single cells are flipped, or 2, squares of four. along, down : the longest runs of H along
    rows and of V along columns. rounds : how often the wall is gone over, and in how many ``turns``: a
    lattice point has turn x + slope y, or x - slope y, modulo their number, and those of one turn must not
    share a run. cells : uint64 (h, words), filled. flips : the same if size is 2, filled with the points
    whose squares have been flipped an odd number of times since the wall was a draughtboard with V where
    x + y is odd.

    What is not right at the margins grows each turn by ``along`` + size - 1 cells and ``down`` + size - 1
    rows, after one cell and one row for the blocks.
    """
    height, words = cells.shape
    bits, points = np.empty((height, words), np.uint64), np.empty((height, words), np.uint64)
    trial, faults = np.empty((height, words), np.uint64), np.empty((height, words), np.uint64)
    line = np.empty(words, np.uint64)
    # Step 1: a draughtboard, and its blocks flipped by hash; their middles are the points of odd x and y.
    fill_bits(word, row, 0, seed, bits)
    for i in range(height):
        odd = (row + i) & 1
        for k in range(words):
            points[i, k] = bits[i, k] & ODD_CELLS if odd else np.uint64(0)
    for i in range(height):
        spread_points(points, i, 2, line)
        for k in range(words):
            cells[i, k] = line[k] ^ (~ODD_CELLS if (row + i) & 1 else ODD_CELLS)
            if size == 2:
                flips[i, k] = points[i, k]
    # Step 2: over and over, in turns along slopes to either side.
    for n in range(rounds):
        fill_bits(word, row, n + 1, seed, bits)
        for turn in range(turns):
            pick_turn(bits, word, row, turn, turns, slope if n & 1 else turns - slope, points)
            flip_turn(cells, size, along, down, points, trial, faults, line)
            if size == 2:
                for i in range(height):
                    for k in range(words):
                        flips[i, k] ^= points[i, k]
