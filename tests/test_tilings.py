"""Laws of tilings over every set that has one, and the hashes behind them."""

import subprocess
import sys

import numba
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import tilewright as tw
from tilewright.errors import TilewrightError
from tilewright.tilings import first_mismatch

SETS = {
    **{f"corner {c}": tw.corner_tiles(c) for c in (1, 2, 3, 8, 16)},
    **{f"wang {c}": tw.wang_tiles(c) for c in (1, 2, 3, 8, 16)},
    "wang 2 3": tw.wang_tiles(2, 3),
    **{f"compact corner {c}": tw.corner_tiles(c, choices=2) for c in (3, 4, 5, 8, 16)},
    "corner 4, 3 choices": tw.corner_tiles(4, choices=3),
    **{f"columns {c}": tw.column_corner_tiles(c) for c in (3, 5, 8)},
    **{f"summed {c}": tw.summed_wang_tiles(c) for c in (2, 3, 5, 16)},
    **{f"shifted {c}": tw.shifted_wang_tiles(c) for c in (2, 4, 8, 16)},
    "cohen 8": tw.cohen_tiles(8),
    "coded 128": tw.corner_coded_tiles(),
    "coded 256": tw.corner_coded_tiles(tw.wang_tiles(2)),
    "dominoes": tw.dominoes(5),
    "corner cubes": tw.corner_cubes(3),
    "wang cubes": tw.wang_cubes(3),
    "compact corner cubes": tw.compact_corner_cubes(3),
}
START, EXTENT = (-5, -7, 4), (21, 13, 6)
FAR = 2**61


def window(tiles, start=START, extent=EXTENT):
    d = tiles.shape.dimension
    return (*start[:d], *extent[:d])


@pytest.mark.parametrize("name", SETS)
def test_direct_tilings_match_everywhere_and_any_window_agrees(name):
    tiles = SETS[name]
    tiling = tw.direct(tiles, 3)
    d = tiles.shape.dimension
    for corner in (
        START,
        (0, 0, 0),
        (-FAR, -FAR, -FAR),
        (FAR - 30, FAR - 30, FAR - 30),
        (2**32 - 4, 2**31 - 5, -(2**32)),
    ):
        whole = tiling.indices(*window(tiles, corner))
        assert first_mismatch(tiles, whole, torus=False) is None
        part = tiling.indices(*(c + 2 for c in corner[:d]), *(e - 3 for e in EXTENT[:d]))
        inner = tuple(slice(2, 2 + e - 3) for e in reversed(EXTENT[:d]))
        assert np.array_equal(whole[inner], part)


@pytest.mark.parametrize("name", SETS)
def test_seeds(name):
    tiles = SETS[name]
    a, again, b = (tw.direct(tiles, s).indices(*window(tiles)) for s in (1, 1, 2))
    assert np.array_equal(a, again)
    assert len(tiles) == 1 or not np.array_equal(a, b)


@pytest.mark.parametrize("name", SETS)
@pytest.mark.parametrize("period", [(6, 9, 4), (6, None, None), (None, 8, None), (35, 21, 3)])
@pytest.mark.parametrize("hash", ["mixer", "permutation", "long-period"])
def test_cylinders_and_tori(name, period, hash):
    tiles = SETS[name]
    d = tiles.shape.dimension
    if name == "compact corner cubes" or not any(period[:d]):
        return
    tiling = tw.direct(tiles, 3, hash=hash, period=period[:d])
    cells = tiling.indices(*(-3,) * d, *(2 * (p or 6) for p in period[:d]))
    assert first_mismatch(tiles, cells, torus=False) is None
    for axis, p in enumerate(period[:d]):
        if p:
            at = cells.ndim - 1 - axis
            assert np.array_equal(cells.take(range(p), at), cells.take(range(p, 2 * p), at))


def test_domain_kinds():
    kinds = {None: "plane", (4, None): "cylinder", (None, 4): "cylinder", (4, 4): "torus"}
    for period, kind in kinds.items():
        assert tw.direct(tw.corner_tiles(2), period=period).domain.kind == kind
    assert tw.scanline(tw.cohen_tiles(8), 3, 3).domain.kind == "rectangle"


@pytest.mark.parametrize(
    "name",
    [
        "corner 3",
        "wang 3",
        "wang 2 3",
        "summed 3",
        "shifted 4",
        "coded 128",
        "compact corner 5",
        "columns 5",
        "corner 4, 3 choices",
    ],
)
def test_tiles_occur_equally_often(name):
    tiles = SETS[name]
    cells = tw.direct(tiles, 11).indices(-300, 77, 600, 600)
    counts = np.bincount(cells.ravel(), minlength=len(tiles))
    expected = cells.size / len(tiles)
    # Neighbors share colors, so counts vary more than independent draws would; the margin is for that.
    assert ((counts - expected) ** 2).sum() / expected < 8 * len(tiles)


@pytest.mark.parametrize("c", [3, 4, 5, 8])
def test_compact_corner_tilings_carry_one_bit_per_tile(c):
    tiles = tw.corner_tiles(c, choices=2)
    slots = tiles.slots[tw.direct(tiles, 5).indices(-200, -300, 700, 700)].astype(int)
    _, se, _, nw = slots.reshape(-1, 4).T
    bit = (se - 2 * nw) % c
    assert set(np.unique(bit)) == {0, 1}
    assert abs(bit.mean() - 0.5) < 0.01
    grid = bit.reshape(700, 700) - 0.5
    for a, b in ((grid[1:], grid[:-1]), (grid[:, 1:], grid[:, :-1]), (grid[1:, 1:], grid[:-1, :-1])):
        assert abs((a * b).mean()) < 0.003


# --- The hash, written out word by word as docs/hashes.md states it -----------------------------------

MASK = 0xFFFFFFFF


def mix(h):
    h ^= h >> 16
    h = h * 0x21F0AAAD & MASK
    h ^= h >> 15
    h = h * 0xD35A2D97 & MASK
    return h ^ h >> 15


def mixer(stream, seed, x, y=0, z=0):
    a, b = 0x243F6A88, 0x85A308D3
    words = (stream, seed, seed >> 32, z, z >> 32, x >> 32, y >> 32, y)
    for word in words:
        a = mix(a ^ word & MASK)
        b = mix((b ^ a) + word & MASK)
    h = x & MASK ^ a
    h ^= h >> 16
    h = (h * 0x21F0AAAD + b) & MASK
    h ^= h >> 15
    h = h * 0xD35A2D97 & MASK
    return h ^ h >> 15


cells = st.integers(-(2**61), 2**61)


@settings(deadline=None)
@given(cells, cells, cells, st.integers(0, 2**64 - 1), st.integers(0, 40))
def test_the_mixer_is_what_its_definition_says(x, y, z, seed, stream):
    assert int(tw.MixerHash(seed).words(stream, x, y, z)) == mixer(stream, seed, x, y, z)


@settings(deadline=None)
@given(cells, cells, st.integers(0, 2**64 - 1), st.integers(1, 16))
def test_the_fast_grid_agrees_with_single_words(x, y, seed, count):
    hash_ = tw.MixerHash(seed)
    columns, rows = x + np.arange(5), y + np.arange(3)
    grid = hash_.grid(count, 1, columns, rows)
    assert int(grid[2, 4]) == (mixer(1, seed, x + 4, y + 2) >> 8) * count >> 24
    assert np.array_equal(grid, hash_.colors(count, 1, columns[None], rows[:, None]))


def test_golden_tiles():
    """Worlds must not change: these tiles are fixed for ever."""
    tiles = tw.direct(tw.corner_tiles(3), 42).indices(-2, 5, 6, 2)
    corner = [[(mixer(0, 42, x, y) >> 8) * 3 >> 24 for x in range(-2, 5)] for y in range(5, 8)]
    for j in range(2):
        for i in range(6):
            ne, se, sw, nw = corner[j][i + 1], corner[j + 1][i + 1], corner[j + 1][i], corner[j][i]
            assert tiles[j, i] == ((ne * 3 + se) * 3 + sw) * 3 + nw
    wang = tw.direct(tw.wang_tiles(2, 3), 42).indices(7, -1, 1, 1)[0, 0]

    def edge(x, y, c):
        return (mixer(0, 42, x, y) >> 8) * c >> 24

    n, e, s, w = edge(15, -2, 2), edge(16, -1, 3), edge(15, 0, 2), edge(14, -1, 3)
    assert wang == ((n * 3 + e) * 2 + s) * 3 + w


def test_permutation_hash_has_the_period_of_its_table():
    table = tw.PermutationHash(3, size=13)
    x = np.arange(13 * 4)
    assert table.period == 13
    assert sorted(table.table(0)) == list(range(13))
    for words in (table.words(0, x), table.words(0, 5, x), table.words(0, 5, 6, x)):
        assert np.array_equal(words[:13], words[13:26])
        assert sorted(words[:13]) == list(range(13))
    p = table.table(0)
    assert table.words(0, 30, -4, 17) == p[(p[(p[30 % 13] - 4) % 13] + 17) % 13]  # eq. 3.4


@pytest.mark.parametrize(
    ("made", "period"),
    [(tw.LongPeriodHash.for_tilings(1), 5_930_659_848), (tw.LongPeriodHash.for_noise(1), 739_024)],
)
def test_long_period_hashes_have_the_periods_of_the_thesis(made, period):
    assert made.period == period
    x = np.arange(-500, 500)
    here = made.words(0, x, 3)
    assert np.array_equal(here, made.words(0, x + period, 3))
    assert np.array_equal(here, made.words(0, x, 3 - period))
    for prime in {p for part in made.parts for p in (2, 3, part.size) if period % p == 0}:
        assert not np.array_equal(here, made.words(0, x + period // prime, 3))
    counts = np.bincount(made.words(0, np.arange(24_000), 1), minlength=made.range)
    assert counts.min() > 0.8 * counts.mean()


# --- Other tilings ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "tiles",
    [tw.cohen_tiles(n) for n in (8, 12, 18)]
    + [tw.compact_wang_tiles(c) for c in (2, 5, 16)]
    + [tw.corner_tiles(3), tw.corner_tiles(5, choices=2), tw.wang_tiles(2, 3)]
    + [tw.corner_coded_tiles(), tw.corner_coded_tiles(scanline_only=True)],
    ids=repr,
)
def test_scanline(tiles):
    tiling = tw.scanline(tiles, 60, 40, 3)
    assert np.array_equal(tiling.cells, tw.scanline(tiles, 60, 40, 3).cells)
    assert len(np.unique(tw.scanline(tiles, 120, 120, 3).cells)) > 0.9 * min(len(tiles), 5000)
    with pytest.raises(TilewrightError, match="cells x=0 to 60 are outside the tiling, which has 0 to 59"):
        tiling.indices(0, 0, 61, 5)


def test_scanline_names_the_dead_end():
    with pytest.raises(TilewrightError, match=r"dead end at cell x=\d+, y=\d+: .* no tile with W=\d, N=\d"):
        tw.scanline(tw.tile_set([[0, 0, 1, 0], [1, 0, 0, 1]]), 30, 30)


def test_given_arrays_are_checked():
    tiles = tw.corner_tiles(2)
    good = tw.direct(tiles, 1).indices(0, 0, 8, 8)
    assert np.array_equal(tw.array_tiling(tiles, good).indices(2, 3, 4, 5), good[3:8, 2:6])
    bad = good.copy()
    bad[4, 5] = 15 - bad[4, 5]
    with pytest.raises(TilewrightError, match=r"cell x=\d, y=\d and its neighbor along [xy] do not match"):
        tw.array_tiling(tiles, bad)
    with pytest.raises(TilewrightError, match="the set has tiles 0 to 15"):
        tw.array_tiling(tiles, good + 10)


@pytest.mark.parametrize("c", range(1, 17))
def test_packings_hold_every_tile_once_and_are_inverted(c):
    for tiles in (tw.corner_tiles(c), tw.wang_tiles(c), tw.dominoes(c)):
        packed = tw.packing(tiles)
        cells = packed.indices(*(0,) * len(packed.size), *packed.size)
        assert np.array_equal(np.sort(cells.ravel()), np.arange(len(tiles)))
        assert first_mismatch(tiles, cells, torus=True) is None
        place = packed.place(np.arange(len(tiles)))
        assert np.array_equal(cells[tuple(reversed(place))], np.arange(len(tiles)))


@pytest.mark.parametrize("c", [1, 2, 3, 4])
def test_cube_packings(c):
    packed = tw.packing(tw.corner_cubes(c))
    cells = packed.indices(0, 0, 0, *packed.size)
    assert np.array_equal(np.sort(cells.ravel()), np.arange(c**8))
    assert first_mismatch(packed.tiles, cells, torus=True) is None
    x, y, z = packed.place(np.arange(c**8))
    assert np.array_equal(cells[z, y, x], np.arange(c**8))


@pytest.mark.parametrize("c", range(2, 9))
def test_the_wang_packing_nests_the_one_over_a_color_less(c):
    big, small = tw.packing(tw.wang_tiles(c)), tw.packing(tw.wang_tiles(c - 1))
    n = (c - 1) ** 2
    assert np.array_equal(
        big.tiles.slots[big.indices(0, 0, n, n)], small.tiles.slots[small.indices(0, 0, n, n)]
    )


def test_density():
    tiles = tw.corner_tiles(4)
    ramp = tw.density_tiling(tiles, lambda x, y: np.clip(x / 100, 0, 1), 3)
    cells = ramp.indices(-20, -500, 140, 1000)
    assert first_mismatch(tiles, cells, torus=False) is None
    marked = (tiles.slots[cells][..., 3] >= 2).mean(axis=0)
    assert np.abs(marked - np.clip(np.arange(-20, 120) / 100, 0, 1)).max() < 0.08
    assert np.array_equal(cells[5:50, 6:40], ramp.indices(-14, -495, 34, 45))
    coded = tw.density_tiling(tw.corner_coded_tiles(), np.array([[0, 255]], np.uint8), cells_per_pixel=10)
    slots = coded.tiles.slots[coded.indices(-50, 0, 120, 9)]
    assert first_mismatch(coded.tiles, coded.indices(-50, 0, 120, 9), torus=False) is None
    assert slots[:, :50, 4:].max() == 0
    assert slots[:, 70:, 4:].min() == 1


BAD = {
    "no direct": (lambda: tw.direct(tw.cohen_tiles(18)), "scanline() tiles a rectangle"),
    "hash": (lambda: tw.direct(tw.corner_tiles(2), hash="md5"), "hash is 'md5'"),
    "seed": (lambda: tw.direct(tw.corner_tiles(2), 2**64), "seed is 18446744073709551616"),
    "seed as float": (lambda: tw.direct(tw.corner_tiles(2), 1.5), "seed must be an integer"),
    "period 0": (lambda: tw.direct(tw.corner_tiles(2), period=(0, 1)), "period is 0"),
    "one period": (lambda: tw.direct(tw.corner_tiles(2), period=(4,)), "expected 2, x first"),
    "short chains": (lambda: tw.direct(tw.corner_tiles(16, choices=2), period=(1, 2)), "too few to return"),
    "empty window": (lambda: tw.direct(tw.corner_tiles(2)).indices(0, 0, 0, 5), "width is 0"),
    "far cell": (lambda: tw.direct(tw.corner_tiles(2)).indices(2**61, 0, 5, 5), "x is 2305843009213693952"),
    "huge window": (lambda: tw.direct(tw.corner_tiles(2)).indices(0, 0, 2**20, 2**20), "at most 2^31"),
    "three numbers": (lambda: tw.direct(tw.corner_tiles(2)).indices(0, 0, 5), "takes 4 numbers"),
    "packing": (lambda: tw.packing(tw.cohen_tiles(8)), "complete sets"),
    "density set": (lambda: tw.density_tiling(tw.wang_tiles(2), 0.5), "complete corner set"),
    "density NaN": (lambda: tw.density_tiling(tw.corner_tiles(2), [[np.nan]]), "outside 0 to 1 (or NaN)"),
    "density function": (
        lambda: tw.density_tiling(tw.corner_tiles(2), lambda x, y: x).indices(0, 0, 5, 5),
        "outside 0 to 1",
    ),
    "sizes": (lambda: tw.LongPeriodHash(0, (5, 7), 6), "one of the sizes"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_tilings_get_one_clear_line(case):
    make, message = BAD[case]
    with pytest.raises(TilewrightError) as error:
        make()
    assert message in str(error.value)
    assert "\n" not in str(error.value)


def test_out_is_filled_or_refused():
    tiling = tw.direct(tw.corner_tiles(2), 1)
    out = np.empty((4, 6), np.int32)
    assert tiling.indices(0, 0, 6, 4, out=out) is out
    with pytest.raises(TilewrightError, match="expected int32"):
        tiling.indices(0, 0, 6, 4, out=np.empty((6, 4), np.int32))


def test_threads_and_processes_do_not_matter():
    tiling = tw.direct(tw.corner_tiles(3), 8)
    here = tiling.indices(-7, 3, 200, 100)
    before = numba.get_num_threads()
    try:
        numba.set_num_threads(1)
        assert np.array_equal(here, tiling.indices(-7, 3, 200, 100))
    finally:
        numba.set_num_threads(before)
    cells = "tw.direct(tw.corner_tiles(3), 8).indices(-7, 3, 200, 100)"
    code = f"import tilewright as tw; print({cells}.tobytes().hex())"
    other = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert other.stdout.strip() == here.tobytes().hex()
