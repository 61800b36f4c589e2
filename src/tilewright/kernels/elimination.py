"""Taking the most crowded points away, one by one (Yuksel 2015), in any dimension."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.compiled import kernel
from tilewright.kernels.darts import find_cell, find_home, find_square


class Sorted(NamedTuple):
    """Points of a box or torus, sorted by the cell in which they lie."""

    points: NDArray[np.float64]
    """(n, d)"""
    starts: NDArray[np.int64]
    """(prod(counts) + 1,): where each cell begins."""
    counts: NDArray[np.int64]
    """(d,): cells along each axis."""
    offsets: NDArray[np.int64]
    """(m, d): cells to look at around a cell."""
    extent: NDArray[np.float64]
    """(d,): size of the box."""
    torus: bool
    """Whether opposite sides meet."""


class Crowding(NamedTuple):
    """How much two points crowd each other (Yuksel 2015)."""

    reach: float
    """Distance from which on they do not: 2 r_max."""
    least: float
    """Distance below which nearer does not count for more: 2 r_min."""
    power: float
    """Alpha: how steeply the weight falls with the distance."""


@kernel()
def weigh_pair(square, crowding):
    """How much two points crowd each other: 1 for touching ones down to 0 at the reach."""
    return (1.0 - max(np.sqrt(square), crowding.least) / crowding.reach) ** crowding.power


@kernel()
def sink(heap, places, weights, at, size):
    """Move an entry down until the heap has the greatest weight on top again."""
    entry = heap[at]
    while 2 * at + 1 < size:
        child = 2 * at + 1
        if child + 1 < size and weights[heap[child + 1]] > weights[heap[child]]:
            child += 1
        if weights[heap[child]] <= weights[entry]:
            break
        heap[at] = heap[child]
        places[heap[at]] = at
        at = child
    heap[at] = entry
    places[entry] = at


@kernel()
def weigh_points(there, crowding, weights):
    """The weight of every point: that of its pairs with all points within reach."""
    points, starts, counts, offsets, extent, torus = there
    home = np.empty(extent.size, np.int64)
    for i in range(points.shape[0]):
        find_home(points[i], counts, extent, home)
        weights[i] = 0.0
        for k in range(offsets.shape[0]):
            cell = find_cell(home, offsets, k, counts, torus)
            if cell < 0:
                continue
            for j in range(starts[cell], starts[cell + 1]):
                square = find_square(points[i], points, j, extent, torus)
                if j != i and square < crowding.reach * crowding.reach:
                    weights[i] += weigh_pair(square, crowding)


@kernel()
def start_heap(weights, heap, places):
    """Put all points into a heap, the heaviest on top."""
    n = weights.size
    for i in range(n):
        heap[i] = places[i] = i
    for at in range(n // 2 - 1, -1, -1):
        sink(heap, places, weights, at, n)


@kernel()
def eliminate(there, crowding, weights, heap, places, size, last):
    """Take the heaviest points away until ``last`` are left of ``size``; those around them get lighter.

    weights : float64 (n,); heap, places : int32 (n,), as made by `start_heap`. What is taken away is left in
    heap[last:size], the first one at the end.
    """
    points, starts, counts, offsets, extent, torus = there
    home = np.empty(extent.size, np.int64)
    while size > last:
        i = heap[0]
        size -= 1
        heap[0] = heap[size]
        places[heap[0]] = 0
        sink(heap, places, weights, 0, size)
        heap[size], places[i] = i, -1
        find_home(points[i], counts, extent, home)
        for k in range(offsets.shape[0]):
            cell = find_cell(home, offsets, k, counts, torus)
            if cell < 0:
                continue
            for j in range(starts[cell], starts[cell + 1]):
                if places[j] < 0:
                    continue
                square = find_square(points[i], points, j, extent, torus)
                if square < crowding.reach * crowding.reach:
                    weights[j] -= weigh_pair(square, crowding)
                    sink(heap, places, weights, places[j], size)
