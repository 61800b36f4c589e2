"""Dappled tilings: the sweep over anti-diagonals that rectifies long runs (Kaji et al. 2016, section 2)."""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.lattice import finish_word, start_row

BLOCK = 64
"""Side of the blocks, in the sheared coordinates of `dapple_cells`, that threads take in turn."""

PLAIN, RING, BEZEL = 0, 1, 2
"""Lines end, close to rings (Algorithm 2), or lie in a bezel: two cells at both ends that alternate."""


@kernel()
def leading_run(line, tile):
    """How many cells at the start of a line hold ``tile``."""
    n = 0
    while n < line.size and line[n] == tile:
        n += 1
    return n


@kernel(inline=True)
def limit_at(most, tile, x, y):
    """The longest run of ``tile`` allowed to end at a cell; most : int32 (T, h or 1, w or 1)."""
    return most[tile, y if most.shape[1] > 1 else 0, x if most.shape[2] > 1 else 0]


@kernel()
def tighten_limit(limit, tile, at, line, ends):
    """The limit at place ``at`` of a line whose end meets a start (section 3.2, (ii) and (iii))."""
    if ends == BEZEL:
        return limit - leading_run(line[at + 1 :], tile) if at == line.size - 3 else limit
    if at == line.size - 1:
        return limit - leading_run(line, tile)
    return limit - 2 if at == limit - 2 else limit


@kernel()
def ends_long_run(tile, at, line, limit, ends):
    """Whether ``tile`` at place ``at`` of a line would end a run longer than its limit there."""
    if ends != PLAIN:
        limit = tighten_limit(limit, tile, at, line, ends)
    if at < limit:
        return False
    before = at - limit
    while before < at and line[before] == tile:
        before += 1
    return before == at


@kernel()
def is_violated(tile, x, y, most_h, most_v, ends, out):
    """Whether ``tile`` at a cell would end too long a run."""
    if ends_long_run(tile, x, out[y], limit_at(most_h, tile, x, y), ends):
        return True
    return ends_long_run(tile, y, out[:, x], limit_at(most_v, tile, x, y), ends)


@kernel()
def visit_cell(x, y, tiles, most_h, most_v, ends, out):
    """Rectify a cell, where it is violated, by steps (I) and (II) of section 2."""
    if not is_violated(out[y, x], x, y, most_h, most_v, ends, out):
        return
    # Step (I): the next tile that violates nothing. With three tiles and more there always is one.
    for step in range(1, tiles):
        tile = (out[y, x] + step) % tiles
        if not is_violated(tile, x, y, most_h, most_v, ends, out):
            out[y, x] = tile
            return
    # Step (II): the tile to the north-west; the other one to the west and to the north.
    if x and y:
        out[y, x] = out[y - 1, x - 1]
        out[y, x - 1] = out[y - 1, x] = 1 - out[y, x]


@kernel()
def visit_any(weight, top, bottom, tiles, most_h, most_v, ends, out):
    """Visit the cells of one anti-diagonal, rows ``top`` up to ``bottom``."""
    for y in range(top, bottom):
        visit_cell(weight - y, y, tiles, most_h, most_v, ends, out)


@kernel()
def visit_pair(weight, top, bottom, most_h, most_v, run_h, run_v, out):
    """`visit_any` for two tiles and lines that end, without branches where nothing but step (I) is needed."""
    flat_h, flat_v = most_h.ravel(), most_v.ravel()
    size_h, size_v = most_h[0].size, most_v[0].size
    down_h, down_v = most_h.shape[2] * (most_h.shape[1] > 1), most_v.shape[2] * (most_v.shape[1] > 1)
    right_h, right_v = most_h.shape[2] > 1, most_v.shape[2] > 1
    one = np.uintp(1)
    for row in range(top, bottom):
        column = weight - row
        y, x = np.uintp(row), np.uintp(column)
        tile = np.intp(out[y, x])
        other = 1 - tile
        # Runs that would end here with this tile and with the other one.
        west = np.intp(out[y, x - one] == tile) if x else 0
        north = np.intp(out[y - one, x] == tile) if y else 0
        before_h, before_v = np.intp(run_h[y]), np.intp(run_v[x])
        across, down = west * before_h + 1, north * before_v + 1
        other_across, other_down = (1 - west) * before_h + 1, (1 - north) * before_v + 1
        at_h, at_v = row * down_h + column * right_h, row * down_v + column * right_v
        bad = (across > flat_h[np.uintp(tile * size_h + at_h)]) | (
            down > flat_v[np.uintp(tile * size_v + at_v)]
        )
        other_bad = (other_across > flat_h[np.uintp(other * size_h + at_h)]) | (
            other_down > flat_v[np.uintp(other * size_v + at_v)]
        )
        if bad & other_bad:
            # Step (II); the cell east of the northern one has been visited, it is on this anti-diagonal.
            tile = np.intp(out[y - one, x - one])
            out[y, x] = tile
            out[y, x - one] = out[y - one, x] = 1 - tile
            run_h[y] = run_v[x] = run_v[x - one] = 1
            if column + 1 < out.shape[1]:
                run_h[y - one] = 2 if out[y - one, x + one] == 1 - tile else 1
        else:
            out[y, x] = other if bad else tile
            run_h[y] = other_across if bad else across
            run_v[x] = other_down if bad else down


@kernel()
def visit_block(block, first, start, tiles, most_h, most_v, run_h, run_v, ends, out):
    """Visit cells with weight x + y from ``first`` on and weight + y from ``start`` on, a block of each."""
    height, width = out.shape
    for weight in range(first, min(first + block, width + height - 1)):
        top = max(start - weight, weight - width + 1, 0)
        bottom = min(start + block - weight, weight + 1, height)
        if tiles == 2 and ends == PLAIN:
            visit_pair(weight, top, bottom, most_h, most_v, run_h, run_v, out)
        else:
            visit_any(weight, top, bottom, tiles, most_h, most_v, ends, out)


@kernel()
def count_run(line, at):
    """How many equal cells in a row end at place ``at``."""
    n = 1
    while at >= n and line[at - n] == line[at]:
        n += 1
    return n


@kernel()
def dapple_bezel(most_h, most_v, out):
    """Rectify the cells within a bezel of a tiling of two tiles, in place (remark 3.4).

    most_h, most_v : int32 (2, 1, 1). out : uint8 (h + 2, w + 2); its two outer rows and columns stay.
    """
    height, width = out.shape[0] - 2, out.shape[1] - 2
    run_h, run_v = np.zeros(height, np.int32), np.zeros(width, np.int32)
    for weight in range(width + height - 1):
        top, bottom = max(0, weight - width + 1), min(weight + 1, height)
        meets_last_row, meets_last_column = bottom == height, weight - top == width - 1
        visit_pair(
            weight, top + meets_last_column, bottom - meets_last_row, most_h, most_v, run_h, run_v, out
        )
        if meets_last_row and weight - height + 1 > 1:
            x = weight - height + 1
            visit_cell(x, height - 1, 2, most_h, most_v, BEZEL, out)
            run_h[height - 2] = count_run(out[height - 2], x + 1)
        # The last column waits: step (II) beside it may lengthen the run that its cell closes.
        if meets_last_column and top > 1:
            visit_cell(width - 1, top, 2, most_h, most_v, BEZEL, out)
            run_v[width - 2] = count_run(out[:, width - 2], min(top + 1, height - 1))


@kernel()
def dapple_few_cells(block, tiles, most_h, most_v, ends, out):
    """`dapple_cells` without threads; ``block`` does not matter."""
    height, width = out.shape
    run_h, run_v = np.zeros(height, np.int32), np.zeros(width, np.int32)
    visit_block(2 * (height + width), 0, 0, tiles, most_h, most_v, run_h, run_v, ends, out)


@kernel(parallel=True)
def visit_blocks(first, last, low, front, block, tiles, most_h, most_v, run_h, run_v, ends, out):
    """`visit_block` for blocks ``low + first`` to ``low + last`` of an anti-diagonal of blocks."""
    for b in range(low + first, low + last):
        visit_block(block, b * block, (front - b) * block, tiles, most_h, most_v, run_h, run_v, ends, out)


def dapple_cells(block, tiles, most_h, most_v, ends, out):
    """Rectify a tiling in place: cells by weight x + y, those of one weight by y, as the paper visits them.

    most_h, most_v : int32 (T, h or 1, w or 1), longest runs allowed to end at a cell. out : uint8 (h, w).

    A visit reads and writes only cells and runs of visits with weight and weight + y no larger than its own,
    and later visits do not touch what it used: blocks of these two numbers that lie on one anti-diagonal of
    blocks are independent. So the result is that of one thread, whatever their number.
    """
    height, width = out.shape
    run_h, run_v = np.zeros(height, np.int32), np.zeros(width, np.int32)
    last_weight, last_sheared = (width + height - 2) // block, (width + 2 * height - 3) // block
    for front in range(last_weight + last_sheared + 1):
        # Only blocks with cells, so that threads get equal shares.
        low = max(0, front - last_sheared, (front - 2) // 3, (front - 1 - height // block) // 2)
        high = min(front, last_weight, (front + 1) // 2, (front + 2 + width // block) // 3)
        visit_blocks(high - low + 1, low, front, block, tiles, most_h, most_v, run_h, run_v, ends, out)


@kernel()
def fill_start(x, y, seed, stream, threshold, out):
    """A random start: tile 1 where the hash's high 31 bits are below ``threshold``."""
    height, width = out.shape
    for j in range(height):
        low, high = x & np.int64(0xFFFFFFFF), x >> 32
        a, b = start_row(stream, seed, 0, high, y + j)
        for i in range(width):
            if low + i == np.int64(0x100000000):  # the high word of x goes up by one
                low, high = low - np.int64(0x100000000), high + 1
                a, b = start_row(stream, seed, 0, high, y + j)
            word = finish_word(a, b, np.uint32(low + i))
            out[j, i] = np.int64(word >> np.uint32(1)) < threshold


@kernel()
def lay_bezel(across, out):
    """Let 2 x 2 cells at the sides of a block alternate, following the start's north-west cell.

    Those of the last columns at the north and south side start with ``across``: they close no run down. The
    same cells are laid from the blocks on both sides. out : uint8 (side + 2, side + 2).
    """
    size = out.shape[0]
    for j in range(0, size, 2):
        at_side = j == 0 or j == size - 2
        for i in range(0, size, 2 if at_side else size - 2):
            tile = across if at_side and i == size - 4 else out[j, i]
            out[j, i] = out[j + 1, i + 1] = tile
            out[j, i + 1] = out[j + 1, i] = 1 - tile


@kernel(parallel=True)
def fill_blocks(first, last, x, y, side, seed, stream, threshold, given, most_h, most_v, across, out):
    """Cells of a window of an endless dappled tiling, block by block.

    x, y : first cell. threshold : as in `fill_start`. given : uint8, the start of all blocks that the window
    meets and of two cells more, or (0, 0) for chance. out : uint8 (h, w), filled.
    """
    height, width = out.shape
    first_x, first_y = x // side * side, y // side * side
    columns = (x + width - 1 - first_x) // side + 1
    for n in range(first, last):
        left, top = n % columns * side, n // columns * side
        block = np.empty((side + 2, side + 2), np.uint8)
        if given.size:
            for j in range(side + 2):
                for i in range(side + 2):
                    block[j, i] = given[top + j, left + i]
        else:
            fill_start(first_x + left, first_y + top, seed, stream, threshold, block)
        lay_bezel(across, block)
        dapple_bezel(most_h, most_v, block)
        x0, y0 = first_x + left - x, first_y + top - y
        for j in range(max(y0, 0), min(y0 + side, height)):
            for i in range(max(x0, 0), min(x0 + side, width)):
                out[j, i] = block[j - y0, i - x0]
