"""The grid cut against SciPy's maximum flow, and the seam energy against plain loops."""

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import maximum_flow

from tilewright.kernels.mincut import cut_grid
from tilewright.kernels.seams import FORCED_NEW, FORCED_OLD, OPEN
from tilewright.signals.textures.patchwork import _SCALE, Patchwork
from tilewright.signals.textures.sheet import Sheet


def random_grid(rng, height, width, most, share):
    stride = width + 2
    capacity = np.zeros((4, height + 2, stride), np.int32)
    terminal = np.zeros((height + 2, stride), np.int32)
    capacity[:, 1:-1, 1:-1] = rng.integers(0, most + 1, (4, height, width))
    capacity[0, :, width] = capacity[2, :, 1] = capacity[1, height] = capacity[3, 1] = 0
    chosen = rng.random((height, width)) < share
    terminal[1:-1, 1:-1] = rng.integers(-2 * most, 2 * most + 1, (height, width)) * chosen
    return capacity.reshape(4, -1), terminal.ravel(), stride


def flow_value(capacity, terminal, stride):
    n = terminal.size
    tails, heads, values = [], [], []
    for d, step in enumerate((1, stride, -1, -stride)):
        p = capacity[d].nonzero()[0]
        tails.append(p)
        heads.append(p + step)
        values.append(capacity[d, p])
    source, sink = terminal.clip(0).nonzero()[0], (-terminal).clip(0).nonzero()[0]
    tails += [np.full(source.size, n), sink]
    heads += [source, np.full(sink.size, n + 1)]
    values += [terminal[source], -terminal[sink]]
    graph = coo_array(
        (np.concatenate(values), (np.concatenate(tails), np.concatenate(heads))), shape=(n + 2, n + 2)
    ).tocsr()
    return maximum_flow(graph.astype(np.int32), n, n + 1).flow_value


def cut_value(capacity, terminal, stride, in_sink):
    total = terminal[(terminal > 0) & (in_sink == 1)].sum() - terminal[(terminal < 0) & (in_sink == 0)].sum()
    for d, step in enumerate((1, stride, -1, -stride)):
        p = capacity[d].nonzero()[0]
        total += capacity[d, p][(in_sink[p] == 0) & (in_sink[p + step] == 1)].sum()
    return total


@pytest.mark.parametrize("seed", range(12))
def test_cut_costs_what_the_largest_flow_carries(seed):
    rng = np.random.default_rng(seed)
    height, width = rng.integers(1, 50, 2)
    grid = random_grid(rng, height, width, int(rng.choice([1, 5, 1000, 10**6])), rng.choice([0.02, 0.3, 1]))
    capacity, terminal, stride = grid
    in_sink = np.zeros(terminal.size, np.uint8)
    cut_grid(capacity.copy(), terminal.copy(), stride, in_sink)
    assert cut_value(*grid, in_sink) == flow_value(*grid)


def seam(features, p, q, step):
    if (q[0] - p[0], q[1] - p[1]) == step:
        return 0.0
    rows, columns = features.shape[:2]

    def at(y, x):
        return features[min(max(y, 0), rows - 1), min(max(x, 0), columns - 1)].astype(float)

    return ((at(*p) - at(q[0] - step[0], q[1] - step[1])) ** 2).sum() + (
        (at(p[0] + step[0], p[1] + step[1]) - at(*q)) ** 2
    ).sum()


def energy(features, canvas, shift, where, weight, kept):
    height, width = where.shape
    total = kept[~where].sum()

    def origin(i, j):
        if where[i, j]:
            return i + shift[0], j + shift[1]
        return int(canvas.rows[i, j]), int(canvas.columns[i, j])

    for i in range(height):
        for j in range(width):
            for step in ((0, 1), (1, 0)):
                k, l = i + step[0], j + step[1]
                if k < height and l < width:
                    cost = seam(features, origin(i, j), origin(k, l), step)
                    total += cost * (weight[i, j] + weight[k, l]) / 2
    return total


@pytest.mark.parametrize("seed", range(4))
def test_overlay_is_the_best_of_all_ways_to_lay_a_patch(seed):
    """Every labelling of the open pixels of a small canvas with old seams in it is tried."""
    rng = np.random.default_rng(seed)
    features = rng.random((20, 20, 2)).astype(np.float32)
    sheet = Sheet(features, np.ones((20, 20), bool), (0,), ((20, 20),))
    canvas = Patchwork.of_patch(4, 5, (1, 2)).with_patch((9, 3), rng.random((4, 5)) < 0.5)
    state = np.full((4, 5), OPEN, np.uint8)
    state[0], state[3, 1:4] = FORCED_OLD, FORCED_NEW
    weight = rng.uniform(0.2, 1, (4, 5)).astype(np.float32)
    shift = (5, 11)
    keep = rng.uniform(0, 0.3, (4, 5)).astype(np.float32)
    kept = np.where(state == OPEN, keep, 0)
    found, where = canvas.overlay(sheet, shift, state, weight, keep=keep)
    assert found == pytest.approx(energy(features, canvas, shift, where, weight, kept), rel=1e-4)
    open_pixels = np.argwhere(state == OPEN)
    best = np.inf
    for bits in range(2 ** len(open_pixels)):
        trial = state == FORCED_NEW
        trial[tuple(open_pixels[[k for k in range(len(open_pixels)) if bits >> k & 1]].T)] = True
        best = min(best, energy(features, canvas, shift, trial, weight, kept))
    # Costs become integers for the cut, and old seams dearer than any new one are clipped.
    assert found <= best * 1.02 + 60 / _SCALE
