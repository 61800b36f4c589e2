"""Neighbors in space, nearest first, by cells sorted along rows: no memory for empty cells."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel()
def find_first(keys, key):
    """The first of sorted keys that is not below ``key``."""
    low, high = 0, keys.size
    while low < high:
        middle = (low + high) // 2
        if keys[middle] < key:
            low = middle + 1
        else:
            high = middle
    return low


@kernel(parallel=True)
def list_neighbors(first, last, queries, order, cells, sorted_places, reach, itself, lists, counts):
    """The nearest places around each query, sorted by distance and then by number.

    queries : float64 (n, 3); order : int32 (n,), their numbers, best so that those of one cell follow each
    other. cells : low float64 (3,), size float, steps int64 (3,): along each axis. sorted_places : keys int64
    (m,) in order, numbers int32 (m,), places float64 (m, 3) in the order of their cells. reach : float64
    (n,), at most the size of cells; itself : whether places are the queries and none its own neighbor.
    lists : int32 (n, room), counts : int32 (n,): what is farther is not kept.
    """
    low, size, steps = cells
    keys, numbers, places = sorted_places
    room = lists.shape[1]
    squares = np.empty(room)
    begins, ends = np.empty(9, np.int64), np.empty(9, np.int64)
    before = np.int64(-1)
    for q in range(first, last):
        i = order[q]
        x, y, z = queries[i]
        column = np.int64((x - low[0]) / size)
        row, layer = np.int64((y - low[1]) / size), np.int64((z - low[2]) / size)
        home = (layer * steps[1] + row) * steps[0] + column
        if home != before:
            # Step 1: three cells side by side in each of nine rows.
            before = home
            for k in range(9):
                base = home + ((k // 3 - 1) * steps[1] + k % 3 - 1) * steps[0]
                begins[k] = find_first(keys, base - 1)
                ends[k] = begins[k]
                while ends[k] < keys.size and keys[ends[k]] <= base + 1:
                    ends[k] += 1
        # Step 2: of what lies there the nearest, put into their order as they are found.
        found = 0
        square_reach = reach[i] * reach[i]
        for k in range(9):
            for at in range(begins[k], ends[k]):
                dx, dy, dz = places[at, 0] - x, places[at, 1] - y, places[at, 2] - z
                square = dx * dx + dy * dy + dz * dz
                if square > square_reach or (found == room and square > squares[room - 1]):
                    continue
                number = numbers[at]
                if itself and number == i:
                    continue
                slot = found
                while slot > 0 and (
                    squares[slot - 1] > square
                    or (squares[slot - 1] == square and lists[i, slot - 1] > number)
                ):
                    slot -= 1
                if slot == room:
                    continue
                found = min(found + 1, room)
                for m in range(found - 1, slot, -1):
                    squares[m], lists[i, m] = squares[m - 1], lists[i, m - 1]
                squares[slot], lists[i, slot] = square, number
        counts[i] = found
