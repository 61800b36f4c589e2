"""Placing tiles one after another among those that fit: the loop of scanline tiling."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.compiled import kernel
from tilewright.kernels.lattice import finish_word, start_row


class Fitting(NamedTuple):
    """Tiles by what they fit: ``order[runs[k] : runs[k + 1]]`` fit ``keys[k]``."""

    keys: NDArray[np.int64]
    """(K,), sorted."""
    runs: NDArray[np.int64]
    """(K + 1,)"""
    order: NDArray[np.int64]
    """(T,)"""


@kernel(inline=True)
def pick_fitting(key, word, fitting):
    """One of the tiles that fit a key, or -1 if none does; word : uint32, the random word that decides."""
    keys, runs, order = fitting
    k, end = 0, keys.size
    while k < end:
        middle = (k + end) // 2
        if keys[middle] < key:
            k = middle + 1
        else:
            end = middle
    if k == keys.size or keys[k] != key:
        return np.int64(-1)
    count = runs[k + 1] - runs[k]
    return order[runs[k] + ((np.int64(word >> np.uint32(8)) * count) >> 24)]


@kernel()
def place_row(beside, east, west_count, first, others, y, z, stream, seed, out):
    """Lay a row of tiles from west to east; returns how many were laid before a dead end.

    beside : int64 (w,), what the tiles already laid north of (and above) the row ask for.
    east : int64 (T,), what a tile asks of the next one, below ``west_count``.
    first, others : `Fitting`, for the first tile of the row, which is asked for ``beside``, and for the
    others, which are asked for ``beside * west_count + east`` of the tile before. y, z, stream, seed : of the
    lattice hash that decides. out : int32 (w,), filled.
    """
    a, b = start_row(stream, seed, z, 0, y)
    tile = pick_fitting(beside[0], finish_word(a, b, np.uint32(0)), first)
    for x in range(out.size):
        if tile < 0:
            return x
        out[x] = tile
        if x + 1 < out.size:
            key = beside[x + 1] * west_count + east[tile]
            tile = pick_fitting(key, finish_word(a, b, np.uint32(x + 1)), others)
    return out.size
