"""Choosing by weight: among many things whose weights change all the time, and along a growing area.

tree : float64 (2 m,), m a power of two; leaf i is tree[m + i], every other entry the sum of its two
children, so that no rounding errors gather and tree[1] is the whole weight.
"""

import numpy as np

from tilewright.kernels.compiled import kernel

STEPS, CLOSE = 40, 1e-9
"""Steps at most along a growing area, and the part of the interval that is near enough."""


@kernel()
def set_weight(tree, i, weight):
    """Give leaf i a weight."""
    node = tree.size // 2 + i
    tree[node] = weight
    while node > 1:
        node //= 2
        tree[node] = tree[2 * node] + tree[2 * node + 1]


@kernel()
def choose_leaf(tree, amount):
    """The leaf, of positive weight, in which ``amount`` of the whole weight falls; what is left there."""
    node = np.int64(1)
    while node < tree.size // 2:
        node *= 2
        if (amount >= tree[node] and tree[node + 1] > 0) or tree[node] <= 0:
            amount -= tree[node]
            node += 1
    return node - tree.size // 2, min(max(amount, 0.0), tree[node])


@kernel()
def step_inside(at, low, high, missing, slope):
    """A step toward where an increasing function has grown by ``missing``: Newton's, or half the interval
    where that leaves it. Returns the next place and the interval that is left."""
    if missing > 0:
        low = at
    else:
        high = at
    at = at + missing / slope if slope > 0 else high
    if not low < at < high:
        at = 0.5 * (low + high)
    return at, low, high
