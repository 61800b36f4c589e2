"""Ranks: the order in which points of a set may be left out so that the rest stays evenly spread.

Weighted sample elimination (Yuksel 2015) over a whole set: a *class* is a point of the set, wherever it
occurs; taking it away takes it out of all tiles that share it. A class's load is the mean over its
occurrences of how much other points disturb it, those of neighboring tiles being averaged over neighbors by
chance. The class with the largest load goes first. Each time half of the points are gone, distances count
on a scale that goes with the points left.
"""

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius
from tilewright.seeds import derive_key
from tilewright.tiles import CORNER, TileSet

_NEIGHBORHOODS = 8192
_FEWEST, _MOST = 2, 12
"""Neighborhoods in all, and for each tile."""
_LONGEST = 1.0
"""Farthest that points count, in tile lengths: neighborhoods are three tiles wide."""


def rank_points(
    tiles: TileSet,
    variants: int,
    points: NDArray[np.float64],
    starts: NDArray[np.int64],
    classes: NDArray[np.int64],
    key: np.uint64,
) -> NDArray[np.float64]:
    """The rank of every class, from 0 up to 1: the share of points that is left when it has gone.

    points : shape (P, 2), those of each tile and variant one after another; starts : shape (T V + 1,).
    classes : shape (P,), numbers from 0 on without gaps.
    """
    from tilewright.kernels.ranking import eliminate_classes

    rows = len(starts) - 1
    weights = np.bincount(classes) / len(classes)
    contexts = _neighborhoods(tiles, variants, rows, key)
    alive = np.ones(len(weights), bool)
    ranks = np.zeros(len(weights))
    left, density = 1.0, len(points) / rows
    while alive.any():
        reach = 2 * max_radius(1, Box()) / sqrt(density * left / 2)
        last = reach >= _LONGEST
        firsts, entries, shares, load = _loads(points, starts, classes, alive, contexts, min(reach, _LONGEST))
        left = eliminate_classes(
            firsts, entries, shares, weights, load, alive, left, -1.0 if last else left / 2, ranks
        )
    return ranks


def _neighborhoods(tiles: TileSet, variants: int, rows: int, key: np.uint64) -> NDArray[np.int32]:
    """Rows that may lie around each row, shape (rows, k, 8), -1 where the set has no such tile."""
    k = int(np.clip(_NEIGHBORHOODS // rows, _FEWEST, _MOST))
    rng = np.random.Generator(np.random.PCG64(int(derive_key(key, 99))))
    slots = tiles.slots[np.arange(rows) // variants].astype(np.int64)[:, np.newaxis]
    around = _around_corners if tiles.shape is CORNER else _around_crossings
    found = tiles.find(around(tiles, slots, k, rng))
    picked = rng.integers(0, variants, found.shape)
    return np.where(found < 0, -1, found * variants + picked).astype(np.int32)


def _around_corners(
    tiles: TileSet, slots: NDArray[np.int64], k: int, rng: np.random.Generator
) -> NDArray[np.int64]:
    """Slots of the eight tiles around, with colors by chance on the outer lattice points."""
    grid = rng.integers(0, max(tiles.colors), (len(slots), k, 4, 4))
    ne, se, sw, nw = np.moveaxis(slots, -1, 0)
    grid[..., 1, 1], grid[..., 1, 2], grid[..., 2, 2], grid[..., 2, 1] = nw, ne, se, sw
    cells = [(i, j) for i in range(3) for j in range(3) if (i, j) != (1, 1)]
    corners = [(0, 1), (1, 1), (1, 0), (0, 0)]
    return np.stack(
        [np.stack([grid[..., i + a, j + b] for a, b in corners], axis=-1) for i, j in cells], axis=2
    )


def _around_crossings(
    tiles: TileSet, slots: NDArray[np.int64], k: int, rng: np.random.Generator
) -> NDArray[np.int64]:
    """The same for `crossed_wang_tiles`: edges by chance but those that the tile knows."""
    c = max(tiles.colors[:4])
    shape = (len(slots), k)
    # Row edges r[i, j] on line i of 0..3 east of column j of 0..4; column edges d[i, j] below line i - 1.
    r = rng.integers(0, c, (*shape, 4, 5))
    d = rng.integers(0, c, (*shape, 5, 4))
    for slot, (i, j) in {4: (1, 2), 5: (2, 2), 6: (2, 1), 7: (1, 1)}.items():
        code = slots[..., slot]
        d[..., i, j], r[..., i, j + 1] = code // c**3, code // c**2 % c
        d[..., i + 1, j], r[..., i, j] = code // c % c, code % c
    codes = ((d[..., :4, :] * c + r[..., :, 1:]) * c + d[..., 1:, :]) * c + r[..., :, :4]
    rows = []
    for i in range(3):
        for j in range(3):
            if (i, j) != (1, 1):
                edges = [r[..., i, j + 1], d[..., i + 1, j + 1], r[..., i + 1, j + 1], d[..., i + 1, j]]
                corners = [codes[..., i + a, j + b] for a, b in ((0, 1), (1, 1), (1, 0), (0, 0))]
                rows.append(np.stack(edges + corners, axis=-1))
    return np.stack(rows, axis=2)


def _loads(
    points: NDArray[np.float64],
    starts: NDArray[np.int64],
    classes: NDArray[np.int64],
    alive: NDArray[np.bool_],
    contexts: NDArray[np.int32],
    reach: float,
) -> tuple[NDArray[np.int64], NDArray[np.int32], NDArray[np.float64], NDArray[np.float64]]:
    """The load of every class, and for each class where it adds to: first entry, classes, shares."""
    from tilewright.kernels.ranking import list_pairs

    rows = len(starts) - 1
    counts, none = np.zeros(rows, np.int64), np.zeros(rows, np.int64)
    pairs, shares = np.zeros((0, 2), np.int32), np.zeros(0, np.float32)
    given = (rows, points, starts, classes, alive, contexts, reach, counts)
    list_pairs(*given, none, False, pairs, shares)
    offsets = np.cumsum(counts) - counts
    pairs, shares = np.zeros((int(counts.sum()), 2), np.int32), np.zeros(int(counts.sum()), np.float32)
    list_pairs(*given, offsets, True, pairs, shares)
    mean = shares / np.bincount(classes, minlength=len(alive))[pairs[:, 0]]
    load = np.bincount(pairs[:, 0], mean, len(alive))
    order = np.argsort(pairs[:, 1], kind="stable")
    firsts = np.searchsorted(pairs[order, 1], np.arange(len(alive) + 1)).astype(np.int64)
    return firsts, pairs[order, 0], mean[order], load.astype(np.float64)
