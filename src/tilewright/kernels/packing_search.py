"""Searches for packings: colors set one by one with backtracking, and lines of colors redrawn by chance."""

import numpy as np

from tilewright.kernels.chance import draw_unit, draw_word
from tilewright.kernels.compiled import kernel


@kernel()
def search_packings(
    windows, places, closing, starts, choices, numbers, tried, colors, used, progress, found, budget
):
    """Set the colors of a torus one by one so that no tile occurs twice; go back where none is left.

    The state of the search is in ``tried``, ``colors``, ``used`` and ``progress``: called again, it goes on.

    Parameters
    ----------
    windows : int64 (tiles, slots), which color each slot of each cell is. places : int64 (slots,), what a
        color counts in the index of a tile.
    closing : int64 (tiles,), cells by the last of their colors; starts : int64 (V + 1,), where the cells
        of color v begin in ``closing``.
    choices : int64 (V, C), what each color may be, in the order it is tried; numbers : int64 (V,), how many.
    tried : int64 (V,), how many of them were tried. colors : int64 (V,), -1 where there is none yet.
    used : bool (T,), tiles that occur. progress : int64 (3,): colors set, trials, solutions.
    found : int64 (n, V), filled with solutions. budget : how many trials, after which the search stops.

    Returns
    -------
    Solutions written into ``found``; the search also stops where it is full. After the last solution
    ``progress[0]`` is -1.
    """
    depth, trials, solutions = progress[0], 0, 0
    while trials < budget and depth >= 0 and solutions < len(found):
        if depth == len(numbers):
            found[solutions] = colors
            solutions += 1
            depth -= 1
            continue
        if colors[depth] >= 0:
            mark_tiles(windows, places, closing[starts[depth] : starts[depth + 1]], colors, used, False)
            colors[depth] = -1
        if tried[depth] == numbers[depth]:
            tried[depth] = 0
            depth -= 1
            continue
        colors[depth] = choices[depth, tried[depth]]
        tried[depth] += 1
        trials += 1
        closed = closing[starts[depth] : starts[depth + 1]]
        fitting = mark_tiles(windows, places, closed, colors, used, True)
        if fitting == len(closed):
            depth += 1
        else:
            mark_tiles(windows, places, closed[:fitting], colors, used, False)
            colors[depth] = -1
    progress[0] = depth
    progress[1] += trials
    progress[2] += solutions
    return solutions


@kernel(inline=True)
def mark_tiles(windows, places, cells, colors, used, mark):
    """Mark the tiles at ``cells`` as used or unused; stop at one that is marked so already.

    Returns the number of cells gone through.
    """
    for n in range(len(cells)):
        tile = 0
        for slot in range(windows.shape[1]):
            tile += places[slot] * colors[windows[cells[n], slot]]
        if used[tile] == mark:
            return n
        used[tile] = mark
    return len(cells)


@kernel()
def redraw_lines(colors, given, cells, count, strength, steps, longest, key, used, state):
    """Redraw pieces of rows and columns, each as a whole, by chance, so that fewer tiles are missing.

    In a long run a coloring with m missing corner tiles turns up with probability proportional to
    exp(-strength m): a heat bath, exact up to tiles that a line holds twice, which a Metropolis step mends.

    Parameters
    ----------
    colors : int64 (n, n), colors of the lattice points of a torus, changed. given : bool (n, n), those that
        must stay. cells : int64 (m,), the others, y n + x. count : number of colors.
    strength : float. steps : how many lines; it ends early where no tile is missing.
    longest : colors in a line, up to n - 1. key : uint64, of the chance.
    used : int64 (count^4,), how often each tile occurs, changed. state : int64 (2,), tiles missing and
        numbers drawn so far, changed.
    """
    n = colors.shape[0]
    gain = np.exp(strength * np.arange(3.0))
    base = np.empty((longest + 2, 2), np.int64)
    chance = np.empty((longest + 1, count, count))
    ahead = np.empty((2, count))
    old = np.empty(longest + 2, np.int64)
    new = np.empty(longest + 2, np.int64)
    for _ in range(steps):
        if state[0] == 0:
            return
        word = draw_word(key, state[1])
        state[1] += 1
        down = np.int64(word & np.uint64(1))
        cell = cells[np.int64((word >> np.uint64(16)) % np.uint64(len(cells)))]
        wanted = 1 + np.int64((word >> np.uint64(1)) % np.uint64(longest))
        y, x = cell // n, cell % n
        length = 1
        while length < wanted and not given[(y + length * down) % n, (x + length * (1 - down)) % n]:
            length += 1
        # Tiles along a line: their index is a base plus a factor times each of two colors of the line.
        square, cube = count * count, count * count * count
        factor = ((square, 1), (cube, count)) if down else ((count, 1), (cube, square))
        find_bases(colors, y, x, down, length, count, base, old)
        before = count_tiles(base, factor, old, length, used, -1)
        weigh_line(base, factor, old, length, used, gain, ahead, chance)
        changed = draw_line(chance, length, old, new, key, state[1])
        state[1] += length
        if not changed:
            count_tiles(base, factor, old, length, used, 1)
            continue
        promised = 0
        for k in range(length + 1):
            for s in range(2):
                promised += used[base[k, s] + factor[s][0] * new[k] + factor[s][1] * new[k + 1]] == 0
                promised -= used[base[k, s] + factor[s][0] * old[k] + factor[s][1] * old[k + 1]] == 0
        after = count_tiles(base, factor, new, length, used, 1)
        kept = after - before - promised
        state[1] += 1
        if kept < 0 and draw_unit(key, state[1] - 1) >= np.exp(strength * kept):
            count_tiles(base, factor, new, length, used, -1)
            count_tiles(base, factor, old, length, used, 1)
            continue
        state[0] += before - after
        for k in range(length):
            colors[(y + k * down) % n, (x + k * (1 - down)) % n] = new[k + 1]


@kernel()
def find_bases(colors, y, x, down, length, count, base, line):
    """Colors of a line and of one at either end; what their neighbors count in the tiles along it.

    Tiles are numbered as NW, NE, SW, SE in base ``count``.
    """
    n = colors.shape[0]
    here = (y if down else x) - 1
    row = x if down else y
    above, below = (row - 1) % n, (row + 1) % n
    for k in range(length + 2):
        here = here % n
        if down:
            line[k] = colors[here, row]
            base[k, 0], base[k, 1] = colors[here, above], colors[here, below]
        else:
            line[k] = colors[row, here]
            base[k, 0], base[k, 1] = colors[above, here], colors[below, here]
        here += 1
    first, second, near = (count**3, count, count**2) if down else (count**3, count**2, count)
    for k in range(length + 1):
        base[k, 0] = base[k, 0] * first + base[k + 1, 0] * second
        base[k, 1] = base[k, 1] * near + base[k + 1, 1]


@kernel()
def count_tiles(base, factor, line, length, used, change):
    """Take the tiles along a line in (``change`` 1) or out (-1); how many are there only because of it."""
    alone = 0
    for k in range(length + 1):
        for s in range(2):
            tile = base[k, s] + factor[s][0] * line[k] + factor[s][1] * line[k + 1]
            if change > 0:
                alone += used[tile] == 0
                used[tile] += 1
            else:
                used[tile] -= 1
                alone += used[tile] == 0
    return alone


@kernel()
def weigh_line(base, factor, line, length, used, gain, ahead, chance):
    """How likely each color is after each color before it, from the far end of a line to its near one.

    ``chance[k, a, b]``, up to a factor: color a at place k is followed by b, and whatever comes then.
    """
    count = chance.shape[1]
    (near_0, far_0), (near_1, far_1) = factor
    ahead[0] = 0.0
    ahead[0, line[length + 1]] = 1.0
    for k in range(length, -1, -1):
        ahead[1] = ahead[0]
        base_0, base_1 = base[k, 0], base[k, 1]
        highest = 0.0
        for a in range(count):
            total = 0.0
            for b in range(count):
                first = used[base_0 + near_0 * a + far_0 * b] == 0
                second = used[base_1 + near_1 * a + far_1 * b] == 0
                likely = gain[int(first) + int(second)] * ahead[1, b]
                chance[k, a, b] = likely
                total += likely
            ahead[0, a] = total
            highest = max(highest, total)
        for a in range(count):
            ahead[0, a] /= highest


@kernel()
def draw_line(chance, length, old, new, key, drawn):
    """Draw the colors of a line, the near end first; whether any of them changed."""
    count = chance.shape[1]
    new[0], new[length + 1] = old[0], old[length + 1]
    changed = False
    for k in range(length):
        before = new[k]
        total = 0.0
        for b in range(count):
            total += chance[k, before, b]
        rest = draw_unit(key, drawn + k) * total
        b = 0
        while b < count - 1 and rest >= chance[k, before, b]:
            rest -= chance[k, before, b]
            b += 1
        new[k + 1] = b
        changed |= b != old[k + 1]
    return changed
