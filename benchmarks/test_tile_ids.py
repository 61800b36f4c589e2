"""Tile ids of complete sets and of the rarer tilings, beside NumPy and beside filling memory; packings."""

import numpy as np
import pytest

import tilewright as tw
from timing import best

SIDE = 4096
RARER = {
    "classed": lambda: tw.direct(tw.classed_corner_tiles(2), 5),
    "sums": lambda: tw.direct(tw.summed_wang_tiles(3), 5),
    "bits": lambda: tw.direct(tw.shifted_wang_tiles(4), 5),
    "diagonals": lambda: tw.direct(tw.corner_tiles(4, choices=2), 5),
    "columns": lambda: tw.direct(tw.column_corner_tiles(4), 5),
    "corner-coded": lambda: tw.direct(tw.corner_coded_tiles(), 5),
    "permutation": lambda: tw.direct(tw.corner_tiles(3), 5, hash="permutation"),
}


def mix(h, added=None):
    """The mixer's round in NumPy, in place."""
    h ^= h >> np.uint32(16)
    h *= np.uint32(0x21F0AAAD)
    if added is not None:
        h += added
    h ^= h >> np.uint32(15)
    h *= np.uint32(0xD35A2D97)
    h ^= h >> np.uint32(15)
    return h


def numpy_colors(seed, x, y):
    """Two colors of a grid at small coordinates, the whole grid at once."""
    a, b = np.full(len(y), 0x243F6A88, np.uint32), np.full(len(y), 0x85A308D3, np.uint32)
    zero = np.zeros_like(y)
    for word in (zero, zero + np.uint32(seed), zero, zero, zero, zero, zero, y):
        a = mix(a ^ word)
        b = mix((b ^ a) + word)
    h = mix(x[None] ^ a[:, None], b[:, None])
    return ((h >> np.uint32(8)) * np.uint32(2)) >> np.uint32(24)


def numpy_corner_ids(seed, out):
    """The corner tile ids of a window at (0, 0) in vectorized NumPy."""
    points = np.arange(SIDE + 1, dtype=np.uint32)
    c = numpy_colors(seed, points, points)
    np.copyto(out, ((c[:-1, 1:] * 2 + c[1:, 1:]) * 2 + c[1:, :-1]) * 2 + c[:-1, :-1], casting="unsafe")


def numpy_wang_ids(seed, out):
    """The Wang tile ids of a window at (0, 0) in vectorized NumPy: one hash at the edges."""
    lines, between = 2 * np.arange(SIDE + 1, dtype=np.uint32), 2 * np.arange(SIDE, dtype=np.uint32) + 1
    h, v = numpy_colors(seed, between, lines), numpy_colors(seed, lines, between)
    np.copyto(out, ((h[:-1] * 2 + v[:, 1:]) * 2 + h[1:]) * 2 + v[:, :-1], casting="unsafe")


@pytest.mark.parametrize(
    ("tiles", "peer"), [(tw.corner_tiles(2), numpy_corner_ids), (tw.wang_tiles(2), numpy_wang_ids)], ids=repr
)
def test_tile_ids_against_numpy(benchmark, record_ratio, tiles, peer):
    tiling = tw.direct(tiles, 5)
    ours, theirs = np.empty((SIDE, SIDE), np.int32), np.empty((SIDE, SIDE), np.int32)
    tiling.indices(0, 0, SIDE, SIDE, out=ours)
    fill = best(lambda: theirs.fill(0))
    took_peer = best(lambda: peer(5, theirs), 3)
    assert np.array_equal(ours, theirs)
    benchmark.pedantic(lambda: tiling.indices(0, 0, SIDE, SIDE, out=ours), rounds=10)
    took = benchmark.stats.stats.median
    record_ratio(f"{tiles.shape.name} ids: times NumPy", took_peer, benchmark.stats.stats.min)
    record_ratio(f"{tiles.shape.name} ids: of a fill", fill, benchmark.stats.stats.min)
    print(
        f"\n{tiles.shape.name} ids: {SIDE**2 / took / 1e6:.0f} M/s, {took_peer / took:.1f}x NumPy, "
        f"{fill / took:.2f} of a fill"
    )
    assert took_peer / took >= 10
    assert SIDE**2 / took >= 200e6


@pytest.mark.parametrize("name", RARER)
def test_rarer_tilings(benchmark, record_ratio, name):
    tiling = RARER[name]()
    out = np.empty((1024, 1024), np.int32)
    benchmark.pedantic(lambda: tiling.indices(0, 0, 1024, 1024, out=out), rounds=5, warmup_rounds=1)
    took = benchmark.stats.stats.median
    record_ratio(f"{name}: of a fill", best(lambda: out.fill(0)), benchmark.stats.stats.min)
    print(f"\n{name}: {1024**2 / took / 1e6:.0f} M/s")
    assert 1024**2 / took >= 10e6


def test_scanline(benchmark, record_ratio):
    tiles = tw.cohen_tiles(8)
    benchmark.pedantic(lambda: tw.scanline(tiles, 1024, 1024, 5), rounds=5, warmup_rounds=1)
    took = benchmark.stats.stats.median
    out = np.empty((1024, 1024), np.int32)
    record_ratio("scanline: of a fill", best(lambda: out.fill(0)), benchmark.stats.stats.min)
    print(f"\nscanline: {1024**2 / took / 1e6:.1f} M/s")
    assert 1024**2 / took >= 3e6


@pytest.mark.parametrize(("colors", "most"), [(4, 0.005), (16, 0.05)])
def test_packing(benchmark, colors, most):
    n = colors**2
    tiles = tw.corner_tiles(colors)
    benchmark.pedantic(lambda: tw.packing(tiles).indices(0, 0, n, n), rounds=10, warmup_rounds=1)
    assert benchmark.stats.stats.median <= most
