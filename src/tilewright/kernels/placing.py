"""Placing tiles one after another among those that fit: the loop of scanline tiling."""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.lattice import finish_word, start_row


@kernel()
def pick_fitting(key, word, keys, runs, order):
    """One of the tiles ``order[runs[k] : runs[k + 1]]`` that fit ``key == keys[k]``, or -1 if none does.

    keys : int64 (K,), sorted. runs : int64 (K + 1,). word : uint32, the random word that decides.
    """
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
def place_row(
    beside, east, west_count, first_keys, first_runs, first_order, keys, runs, order, y, z, stream, seed, out
):
    """Lay a row of tiles from west to east; returns how many were laid before a dead end.

    beside : int64 (w,), what the tiles already laid north of (and above) the row ask for.
    east : int64 (T,), what a tile asks of the next one, below ``west_count``.
    first_keys, first_runs, first_order : of `pick_fitting`, for the first tile of the row, which is asked
    for ``beside``; keys, runs, order : for the others, which are asked for ``beside * west_count + east`` of
    the tile before. y, z, stream, seed : of the lattice hash that decides. out : int32 (w,), filled.
    """
    a, b = start_row(stream, seed, z, 0, y)
    tile = pick_fitting(beside[0], finish_word(a, b, np.uint32(0)), first_keys, first_runs, first_order)
    for x in range(out.size):
        if tile < 0:
            return x
        out[x] = tile
        if x + 1 < out.size:
            key = beside[x + 1] * west_count + east[tile]
            tile = pick_fitting(key, finish_word(a, b, np.uint32(x + 1)), keys, runs, order)
    return out.size
