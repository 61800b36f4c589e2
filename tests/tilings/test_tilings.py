"""Laws of tilings over every set that has one."""

import subprocess
import sys
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tilewright as tw
from cores import cores
from mixer import mixer
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
    "crossed": tw.crossed_wang_tiles(2),
    "dominoes": tw.dominoes(5),
    "coded 512": tw.corner_coded_tiles(tw.shifted_wang_tiles(4)),
    "corner cubes": tw.corner_cubes(3),
    "many corner cubes": tw.corner_cubes(8),
    "wang cubes": tw.wang_cubes(3),
    "compact corner cubes": tw.compact_corner_cubes(3),
    "compact wang cubes": tw.compact_wang_cubes(4),
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


@pytest.mark.parametrize("tiles", [tw.corner_tiles(3), tw.wang_tiles(2, 3)])
@pytest.mark.parametrize("start", [(-70, 5), (2**32 - 40, -(2**31) - 9)])
@pytest.mark.parametrize("period", [None, (30, None), (50, 90)])
def test_the_compiled_pass_agrees_with_numpy(tiles, start, period):
    tiling = tw.direct(tiles, 3, period=period)
    slots = np.stack(tiling.slots(start, (130, 150)), axis=-1)
    assert np.array_equal(tiling.indices(*start, 130, 150), tw.encode(slots, tiles.colors))


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
    if not any(period[:d]):
        return
    tiling = tw.direct(tiles, 3, hash=hash, period=period[:d])
    cells = tiling.indices(*(-3,) * d, *(2 * (p or 6) for p in period[:d]))
    assert first_mismatch(tiles, cells, torus=False) is None
    for axis, p in enumerate(period[:d]):
        if p:
            at = cells.ndim - 1 - axis
            assert np.array_equal(cells.take(range(p), at), cells.take(range(p, 2 * p), at))


@pytest.mark.parametrize("period", list(product((None, 6, 9), repeat=3)))
def test_diagonals_through_cubes_repeat_along_any_axes(period):
    tiles = tw.compact_corner_cubes(3)
    tiling = tw.direct(tiles, 3, period=period)
    here = tiling.indices(-2, -3, -1, 14, 13, 12)
    assert first_mismatch(tiles, here, torus=False) is None
    for axis, p in enumerate(period):
        start = [-2, -3, -1]
        start[axis] += p or 0
        assert np.array_equal(here, tiling.indices(*start, 14, 13, 12))


@pytest.mark.parametrize("c", [*range(3, 9), 11, 16])
def test_chains_close_for_every_number_of_choices(c):
    """Tori whose diagonals are cut into one block, a short one, and blocks of two lengths."""
    for d in range(2, c):
        tiles = tw.corner_tiles(c, choices=d)
        for period in ((7, 5), (1, 39), (13, 15)):
            cells = tw.direct(tiles, 3, period=period).indices(0, 0, *period)
            assert first_mismatch(tiles, cells, torus=True) is None


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


@pytest.mark.parametrize("c", [2, 3, 5, 16])
def test_the_mixer_colors_pairs_of_points_independently(c):
    x = np.arange(1024)
    colors = tw.MixerHash(7).grid(c, 0, x - 500, x).astype(int)
    for dy, dx in ((0, 1), (1, 0), (1, 1), (0, 2), (3, 7), (64, 0)):
        pairs = colors[: 1024 - dy, : 1024 - dx] * c + colors[dy:, dx:]
        counts = np.bincount(pairs.ravel(), minlength=c * c)
        expected = pairs.size / c**2
        degrees = c * c - 1
        assert ((counts - expected) ** 2).sum() / expected < degrees + 5 * np.sqrt(2 * degrees)


@settings(deadline=None, max_examples=30)
@given(
    st.sampled_from(sorted(SETS)),
    st.integers(-FAR, FAR - 100),
    st.integers(-FAR, FAR - 100),
    st.integers(0, 2**64 - 1),
    st.integers(1, 12),
    st.integers(1, 12),
)
def test_any_window_is_part_of_any_other(name, x, y, seed, width, height):
    tiles = SETS[name]
    d = tiles.shape.dimension
    tiling = tw.direct(tiles, seed)
    start, extent = (x, y, -x - 100)[:d], (width, height, 4)[:d]
    whole = tiling.indices(*start, *(n + 25 for n in extent))
    inner = tuple(slice(24, 24 + n) for n in reversed(extent))
    assert np.array_equal(whole[inner], tiling.indices(*(v + 24 for v in start), *extent))


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
    assert first_mismatch(tiles, tiling.cells, torus=False) is None
    assert np.array_equal(tiling.cells, tw.scanline(tiles, 90, 70, 3).cells[:40, :60])
    assert not np.array_equal(tiling.cells, tw.scanline(tiles, 60, 40, 4).cells)
    assert len(np.unique(tw.scanline(tiles, 120, 120, 3).cells)) > 0.9 * min(len(tiles), 5000)
    with pytest.raises(TilewrightError, match="cells x=0 to 60 are outside the tiling, which has 0 to 59"):
        tiling.indices(0, 0, 61, 5)


def scanline_by_hand(tiles, width, height, seed):
    """The rule of scanline tiling, cell by cell."""
    cells = {}
    for y in range(height):
        for x in range(width):
            fits = [
                t
                for t in range(len(tiles))
                if all(
                    tiles.slots[cells[at], far] == tiles.slots[t, near]
                    for at, joint in zip(((x - 1, y), (x, y - 1)), tiles.shape.joints, strict=True)
                    if at in cells
                    for far, near in joint
                )
            ]
            cells[x, y] = fits[(mixer(9, seed, x, y) >> 8) * len(fits) >> 24]
    return np.array([[cells[x, y] for x in range(width)] for y in range(height)])


@pytest.mark.parametrize("name", ["wang 2 3", "cohen 8", "compact corner 4", "coded 128"])
def test_scanline_is_its_rule(name):
    tiles = SETS[name]
    assert np.array_equal(tw.scanline(tiles, 9, 7, 2).cells, scanline_by_hand(tiles, 9, 7, 2))


@pytest.mark.parametrize("tiles", [tw.compact_wang_cubes(2), tw.compact_corner_cubes(3), tw.corner_cubes(2)])
def test_scanline_of_cubes(tiles):
    cells = tw.scanline(tiles, 12, 9, 4, depth=7).cells
    assert cells.shape == (7, 9, 12)
    assert first_mismatch(tiles, cells, torus=False) is None
    assert len(np.unique(tw.scanline(tw.compact_wang_cubes(2), 12, 9, 4, depth=7).cells)) == 16


def test_scanline_of_dominoes():
    train = tw.scanline(tw.dominoes(3), 50)
    assert first_mismatch(train.tiles, train.indices(0, 50), torus=False) is None


def test_scanline_names_the_dead_end():
    with pytest.raises(TilewrightError, match=r"dead end at cell x=\d+, y=\d+: .* no tile with W=\d, N=\d"):
        tw.scanline(tw.tile_set([[0, 0, 1, 0], [1, 0, 0, 1]]), 30, 30)


def test_given_arrays_are_checked():
    tiles = tw.corner_tiles(2)
    good = tw.direct(tiles, 1).indices(0, 0, 8, 8)
    assert np.array_equal(tw.array_tiling(tiles, good).indices(2, 3, 4, 5), good[3:8, 2:6])
    bad = good.copy()
    bad[4, 5] = 15 - bad[4, 5]
    # The tile at (5, 4) is wrong; the one north of it is the first cell that has a wrong neighbor.
    with pytest.raises(
        TilewrightError, match=r"cell x=5, y=3 and its neighbor along y do not match: S[WE] is"
    ):
        tw.array_tiling(tiles, bad)
    tw.array_tiling(tiles, tw.packing(tiles).indices(0, 0, 4, 4), torus=True)
    with pytest.raises(TilewrightError, match="do not match"):
        tw.array_tiling(tiles, good, torus=True)
    with pytest.raises(TilewrightError, match="the set has tiles 0 to 15"):
        tw.array_tiling(tiles, good + 10)


def test_stochastic_is_direct_where_it_can():
    assert tw.stochastic(tw.corner_tiles(2), 1, 1, 5).indices(-9, 2**40, 7, 7).shape == (7, 7)
    laid = tw.stochastic(tw.cohen_tiles(12), 9, 8, 5)
    assert np.array_equal(
        laid.indices(0, 0, 9, 8), tw.scanline(tw.cohen_tiles(12), 9, 8, 5).indices(0, 0, 9, 8)
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
    "period as number": (lambda: tw.direct(tw.corner_tiles(2), period=5), "period must be a tuple of 2"),
    "two hashes": (lambda: tw.direct(tw.corner_tiles(2), wang="two-hashes"), "is for complete Wang sets"),
    "int32": (
        lambda: tw.direct(tw.corner_cubes(16)).indices(0, 0, 0, 1, 1, 1),
        "4294967296 tiles; tile indices are int32",
    ),
    "out": (
        lambda: tw.direct(tw.corner_tiles(2)).indices(0, 0, 1, 1, out=[[0]]),
        "out must be an int32 array, not list",
    ),
    "high dominoes": (lambda: tw.scanline(tw.dominoes(2), 5, 2), "height is 2; allowed are 1 to 1"),
    "no width": (lambda: tw.scanline(tw.cohen_tiles(8), 0, 2), "width is 0; allowed are 1 to 65536"),
    "many tiles": (lambda: tw.scanline(tw.corner_cubes(8), 5, 5), "scanline tiling takes at most 2^20"),
    "ragged": (
        lambda: tw.array_tiling(tw.corner_tiles(2), [[0, 1], [0]]),
        "not a table of equally long rows",
    ),
    "tile of a packing": (
        lambda: tw.packing(tw.corner_tiles(2)).tile(1),
        "tile() takes 2 coordinates, not 1",
    ),
    "place of a packing": (lambda: tw.packing(tw.corner_tiles(2)).place(16), "index holds 16 to 16"),
    "size twice": (lambda: tw.LongPeriodHash(0, (5, 7, 5), 7), "a size given twice"),
    "density of a shape": (
        lambda: tw.density_tiling(tw.corner_tiles(2), lambda x, y: [0.5, 0.5]).indices(0, 0, 5, 5),
        "expected one number for each",
    ),
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
    "density ragged": (lambda: tw.density_tiling(tw.corner_tiles(2), [[0, 1], [1]]), "equally long rows"),
    "density complex": (
        lambda: tw.density_tiling(tw.corner_tiles(2), lambda x, y: x * 1j).indices(0, 0, 5, 5),
        "answered complex128; expected numbers",
    ),
    "density NaN": (lambda: tw.density_tiling(tw.corner_tiles(2), [[np.nan]]), "outside 0 to 1 (or NaN)"),
    "density function": (
        lambda: tw.density_tiling(tw.corner_tiles(2), lambda x, y: x).indices(0, 0, 5, 5),
        "density function is 2.0 at x=2.0, y=0.0; shares are 0 to 1",
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


MADE = (
    "tw.direct(tw.corner_tiles(3), 8).indices(-7, 3, 200, 100)",
    "tw.direct(tw.wang_tiles(2, 3), 8).indices(-7, 3, 200, 100)",
    "tw.direct(tw.corner_tiles(5, choices=2), 8).indices(-7, 3, 60, 50)",
    "tw.direct(tw.corner_tiles(3), 8, hash='permutation').indices(-7, 3, 60, 50)",
    "tw.direct(tw.corner_tiles(3), 8, hash='long-period').indices(-7, 3, 60, 50)",
    "tw.scanline(tw.cohen_tiles(18), 60, 50, 8).cells",
    "tw.density_tiling(tw.corner_tiles(4), [[0.2, 0.9]], 8, cells_per_pixel=9).indices(-7, 3, 60, 50)",
)


def test_threads_and_processes_do_not_matter():
    tiling = tw.direct(tw.corner_tiles(3), 8)
    here = tiling.indices(-7, 3, 200, 100)
    others = {made: eval(made) for made in MADE}
    for count in (1, 3):
        with cores(count):
            assert np.array_equal(here, tiling.indices(-7, 3, 200, 100))
            assert all(np.array_equal(cells, eval(made)) for made, cells in others.items())
    code = "import tilewright as tw\n" + "".join(f"print({made}.tobytes().hex())\n" for made in others)
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert printed.stdout.split() == [cells.tobytes().hex() for cells in others.values()]
