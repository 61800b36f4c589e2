"""How close points of neighboring tiles come, over all pairs of tiles that may meet."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel(parallel=True)
def find_closest(first, last, points, starts, others, other_starts, keys, other_keys, meets, dx, dy, closest):
    """For every row the least squared distance to a point of a tile that may lie (dx, dy) tiles away.

    points : float64 (P, 2) and starts : int64 (rows + 1,), of each row the points near the neighbor; others
    and other_starts : those near a neighbor that lies the other way. keys, other_keys : int64 (rows,).
    meets : bool (most key + 1, most other key + 1). closest : float64 (rows,), filled.
    """
    for a in range(first, last):
        least = np.inf
        for b in range(len(other_keys)):
            if not meets[keys[a], other_keys[b]]:
                continue
            for i in range(starts[a], starts[a + 1]):
                for j in range(other_starts[b], other_starts[b + 1]):
                    x = others[j, 0] + dx - points[i, 0]
                    y = others[j, 1] + dy - points[i, 1]
                    least = min(least, x * x + y * y)
        closest[a] = least


@kernel(parallel=True)
def find_closest_within(first, last, points, starts, closest):
    """For every row the least squared distance of two of its own points."""
    for a in range(first, last):
        least = np.inf
        for i in range(starts[a], starts[a + 1]):
            for j in range(starts[a], i):
                x, y = points[j, 0] - points[i, 0], points[j, 1] - points[i, 1]
                least = min(least, x * x + y * y)
        closest[a] = least
