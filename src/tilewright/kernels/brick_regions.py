"""Brick walls in a region with a given boundary: decide, settle, and shuffle.

Cells are nodes, edges between them that are not given are links. What an edge may carry is a word with a
bit for each position.
"""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.lattice import mix

NORTH, EAST, SOUTH, WEST, ROOT = range(5)
"""Where a cell's parent is."""


@kernel()
def order_cells(mask, east, south, order, parent, part):
    """Number the parts of a region, and put their cells in an order in which parents come first.

    mask, east, south : bool (h, w): the cells; those with a link to the next cell east, and south.
    order : int64 (cells,), filled with cells y w + x. parent : uint8 (h, w). part : int32 (h, w), -1 at
    first. Returns the number of parts.
    """
    height, width = mask.shape
    parts, done, end = 0, 0, 0
    for first in range(height * width):
        y, x = first // width, first % width
        if not mask[y, x] or part[y, x] >= 0:
            continue
        order[end], parent[y, x], part[y, x] = first, ROOT, parts
        end += 1
        while done < end:
            y, x = order[done] // width, order[done] % width
            done += 1
            for side in range(4):
                if side == NORTH:
                    linked, v, u = y > 0 and south[y - 1, x], y - 1, x
                elif side == EAST:
                    linked, v, u = east[y, x], y, x + 1
                elif side == SOUTH:
                    linked, v, u = south[y, x], y + 1, x
                else:
                    linked, v, u = x > 0 and east[y, x - 1], y, x - 1
                if linked and part[v, u] < 0:
                    order[end], parent[v, u], part[v, u] = v * width + u, (side + 2) % 4, parts
                    end += 1
        parts += 1
    return parts


@kernel(inline=True)
def is_single(choices):
    """Whether one bit is set."""
    return choices & (choices - np.uint32(1)) == 0


@kernel(inline=True)
def can_differ(a, b):
    """Whether two edges can carry different colors; neither is without choice."""
    return not (is_single(a) and a == b)


@kernel(inline=True)
def pass_on(opposite, a, b, full):
    """What an edge may carry, from the choices of the edge opposite and of the two others of a cell."""
    equal = opposite if can_differ(a, b) else np.uint32(0)
    others = full & ~opposite if is_single(opposite) else full
    return equal | (others if a & b else np.uint32(0))


@kernel()
def gather_choices(order, parent, part, across, upright, full, failed):
    """From the leaves to the roots: what the edge to each parent may carry.

    order, parent, part : as in `order_cells`. across : uint32 (h + 1, w), upright : uint32 (h, w + 1): the
    choices of each edge; those of the links to parents are replaced. failed : bool (parts,), filled.
    """
    width = parent.shape[1]
    for k in range(order.size - 1, -1, -1):
        y, x = order[k] // width, order[k] % width
        n, s, w, e = across[y, x], across[y + 1, x], upright[y, x], upright[y, x + 1]
        side = parent[y, x]
        if side == NORTH:
            across[y, x] = pass_on(s, e, w, full)
        elif side == SOUTH:
            across[y + 1, x] = pass_on(n, e, w, full)
        elif side == WEST:
            upright[y, x] = pass_on(e, n, s, full)
        elif side == EAST:
            upright[y, x + 1] = pass_on(w, n, s, full)
        else:
            straight = e & w != 0 and can_differ(n, s)
            failed[part[y, x]] = not (straight or (n & s != 0 and can_differ(e, w)))


@kernel()
def count_bits(choices):
    count = 0
    while choices:
        choices &= choices - np.uint32(1)
        count += 1
    return count


@kernel()
def pick_choice(choices, word):
    """One of the bits that are set."""
    skip = (np.uint64(word) * np.uint64(count_bits(choices))) >> np.uint64(32)
    for _ in range(skip):
        choices &= choices - np.uint32(1)
    return choices & (~choices + np.uint32(1))


@kernel()
def pick_pair(a, b, word):
    """Different bits, one of each word."""
    if is_single(b):
        return pick_choice(a & ~b, word), b
    one = pick_choice(a, word)
    return one, pick_choice(b & ~one, mix(word))


@kernel()
def settle_cells(order, across, upright, words):
    """From the roots to the leaves: one color for each edge; words : uint32 (h, w), random numbers."""
    width = words.shape[1]
    for k in range(order.size):
        y, x = order[k] // width, order[k] % width
        n, s, w, e = across[y, x], across[y + 1, x], upright[y, x], upright[y, x + 1]
        word = words[y, x]
        along = e & w != 0 and can_differ(n, s)
        down = n & s != 0 and can_differ(e, w)
        if along and (not down or word & np.uint32(1)):
            e = w = pick_choice(e & w, mix(word))
            n, s = pick_pair(n, s, mix(word + np.uint32(1)))
        else:
            n = s = pick_choice(n & s, mix(word))
            e, w = pick_pair(e, w, mix(word + np.uint32(1)))
        across[y, x], across[y + 1, x], upright[y, x], upright[y, x + 1] = n, s, w, e


@kernel()
def count_run(mask, across, upright, y, x, dy, dx, most):
    """Tiles from cell (y, x) on that are traversed in the direction of (dy, dx), at most ``most``."""
    count = 0
    while count < most and 0 <= y < mask.shape[0] and 0 <= x < mask.shape[1] and mask[y, x]:
        if (across[y, x] == across[y + 1, x]) != (dy != 0):
            break
        y, x, count = y + dy, x + dx, count + 1
    return count


@kernel(inline=True)
def excess(here, there, before, behind, limit):
    """By how much the runs through two neighbors are too long; here, there: whether they are traversed."""
    if here and there:
        return max(before + behind + 2 - limit, 0)
    return (max(before + 1 - limit, 0) if here else 0) + (max(behind + 1 - limit, 0) if there else 0)


@kernel(inline=True)
def fits_between(a, b, to_a, to_b, n):
    """Whether an edge can equal the edges opposite in its two cells as asked, and differ else."""
    if to_a or to_b:
        return (a == b) == (to_a and to_b)
    return a == b or n > 2


@kernel()
def pick_between(a, b, to_a, to_b, n, word):
    """A color of such an edge."""
    if to_a or to_b:
        return a if to_a else b
    low, high = min(a, b), max(a, b)
    count = n - 1 if a == b else n - 2
    c = np.int64((np.uint64(word) * np.uint64(count)) >> np.uint64(32))
    c += c >= low
    return c + (high != low and c >= high)


@kernel()
def shuffle_bricks(mask, free, across, upright, n, along, down, words):
    """Lay the four edges around each free lattice point anew, without longer runs than need be.

    mask : bool (h, w). free : bool (h, w), the points at the NW corners of cells around which four cells
    meet at four links. across, upright : int8, colors. along, down : the longest runs wished for.
    words : uint32 (h, w), random numbers.
    """
    most = 4 * max(along, down)
    for y in range(1, mask.shape[0]):
        for x in range(1, mask.shape[1]):
            if not free[y, x]:
                continue
            # Step 1: the edges opposite to the four, and the runs that end beside the four cells.
            a_nw, a_ne = across[y - 1, x - 1], across[y - 1, x]
            a_sw, a_se = across[y + 1, x - 1], across[y + 1, x]
            u_nw, u_ne = upright[y - 1, x - 1], upright[y - 1, x + 1]
            u_sw, u_se = upright[y, x - 1], upright[y, x + 1]
            w_n = count_run(mask, across, upright, y - 1, x - 2, 0, -1, most)
            w_s = count_run(mask, across, upright, y, x - 2, 0, -1, most)
            e_n = count_run(mask, across, upright, y - 1, x + 1, 0, 1, most)
            e_s = count_run(mask, across, upright, y, x + 1, 0, 1, most)
            n_w = count_run(mask, across, upright, y - 2, x - 1, -1, 0, most)
            n_e = count_run(mask, across, upright, y - 2, x, -1, 0, most)
            s_w = count_run(mask, across, upright, y + 1, x - 1, 1, 0, most)
            s_e = count_run(mask, across, upright, y + 1, x, 1, 0, most)
            # Step 2: of the ways to traverse the four cells, a random one of those with the least excess.
            word = words[y, x]
            best, chosen = np.int64(1) << 40, 0
            for k in range(16):
                way = (word + k * (word >> np.uint32(4) | np.uint32(1))) & np.uint32(15)
                nw, ne, sw, se = way & 1 != 0, way & 2 != 0, way & 4 != 0, way & 8 != 0
                if not (
                    fits_between(u_nw, u_ne, nw, ne, n)
                    and fits_between(u_sw, u_se, sw, se, n)
                    and fits_between(a_nw, a_sw, not nw, not sw, n)
                    and fits_between(a_ne, a_se, not ne, not se, n)
                ):
                    continue
                cost = excess(nw, ne, w_n, e_n, along) + excess(sw, se, w_s, e_s, along)
                cost += excess(not nw, not sw, n_w, s_w, down) + excess(not ne, not se, n_e, s_e, down)
                if cost < best:
                    best, chosen = cost, way
                if cost == 0:
                    break
            # Step 3: its colors.
            nw, ne, sw, se = chosen & 1 != 0, chosen & 2 != 0, chosen & 4 != 0, chosen & 8 != 0
            upright[y - 1, x] = pick_between(u_nw, u_ne, nw, ne, n, mix(word))
            upright[y, x] = pick_between(u_sw, u_se, sw, se, n, mix(word + np.uint32(1)))
            across[y, x - 1] = pick_between(a_nw, a_sw, not nw, not sw, n, mix(word + np.uint32(2)))
            across[y, x] = pick_between(a_ne, a_se, not ne, not se, n, mix(word + np.uint32(3)))
