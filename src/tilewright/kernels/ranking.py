"""Orders of points in which every beginning is evenly spread, over all tiles of a set at once."""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.elimination import sink


@kernel(inline=True)
def weigh(square, reach):
    """How much two points disturb each other (Yuksel 2015, section 3): (1 - d / reach)^8."""
    w = 1.0 - np.sqrt(square) / reach
    w *= w
    w *= w
    return w * w


@kernel(parallel=True)
def list_pairs(
    first, last, points, starts, classes, alive, contexts, reach, counts, offsets, fill, partners, shares
):
    """Pairs of points that are within reach, seen from the points of every row.

    contexts : int32 (rows, k, 8), the rows around each row, row by row from the north-west, or -1.
    alive : bool (classes,). counts : int64 (rows,), pairs of each row, written if not ``fill``. offsets :
    int64 (rows,), where a row's pairs are written if ``fill``: partners int32 (pairs, 2), the class of the
    one and of the other, and shares float32 (pairs,).
    """
    k = contexts.shape[1]
    for m in range(first, last):
        n = np.int64(0)
        for i in range(starts[m], starts[m + 1]):
            if not alive[classes[i]]:
                continue
            for c in range(k):
                for place in range(9):
                    own = place == 4
                    if own and c > 0:
                        continue
                    other = np.int64(m) if own else np.int64(contexts[m, c, place - (1 if place > 4 else 0)])
                    if other < 0:
                        continue
                    dx, dy = place % 3 - 1, place // 3 - 1
                    for j in range(starts[other], starts[other + 1]):
                        if not alive[classes[j]] or (own and i == j):
                            continue
                        x, y = points[j, 0] + dx - points[i, 0], points[j, 1] + dy - points[i, 1]
                        square = x * x + y * y
                        if square >= reach * reach:
                            continue
                        if fill:
                            partners[offsets[m] + n, 0] = classes[i]
                            partners[offsets[m] + n, 1] = classes[j]
                            shares[offsets[m] + n] = weigh(square, reach) / (1.0 if own else k)
                        n += 1
        if not fill:
            counts[m] = n


@kernel()
def eliminate_classes(firsts, entries, shares, weights, load, alive, left, target, ranks):
    """Take away the class with the largest load until ``left``, the weight of all, is ``target``.

    firsts : int64 (classes + 1,); entries : int32, shares : float64, for each class whose load it is part
    of. load : float64 (classes,), kept up. ranks : float64 (classes,), gets what is left after each.
    """
    heap = np.flatnonzero(alive).astype(np.int32)
    place = np.full(len(alive), -1, np.int32)
    size = len(heap)
    for at in range(size):
        place[heap[at]] = at
    for at in range(size // 2 - 1, -1, -1):
        sink(heap, place, load, at, size)
    while size > 0 and left > target:
        top = heap[0]
        size -= 1
        heap[0] = heap[size]
        place[heap[0]] = 0
        if size > 0:
            sink(heap, place, load, 0, size)
        alive[top] = False
        left -= weights[top]
        ranks[top] = max(left, 0.0)
        for e in range(firsts[top], firsts[top + 1]):
            other = entries[e]
            if alive[other]:
                load[other] -= shares[e]
                sink(heap, place, load, place[other], size)
    return left
