"""Dappled tilings by the paper's algorithms, anywhere on the plane, and how many there are."""

import itertools
from math import inf

import numpy as np
import pytest

from tilewright.errors import TilewrightError, TilewrightTypeError, TilewrightValueError
from tilewright.kernels import dappling
from tilewright.tilings.dappled import (
    Conditions,
    count_dappled,
    counting,
    dapple,
    endless_dappled_tiling,
    find_violations,
    random_start,
    rectify,
    start_from_image,
    surgery,
)

PAPER = {"H0": 2, "V1": 2}
ALL_TWO = {"H0": 2, "H1": 2, "V0": 2, "V1": 2}
ALL_THREE = {"H0": 3, "H1": 3, "V0": 3, "V1": 3}


def is_dappled(tiling, limits, cyclic=False):
    return not any(bad.any() for bad in find_violations(tiling, limits, cyclic=cyclic).values())


def too_long(cells, x, y, across, down):
    """Whether the run that ends at a cell is too long, straight from definition 1.1."""
    tile = cells[y, x]
    p, q = across[tile], down[tile]
    return (x >= p and all(cells[y, x - k] == tile for k in range(int(p) + 1))) or (
        y >= q and all(cells[y - k, x] == tile for k in range(int(q) + 1))
    )


def algorithm_1(start, across, down):
    """Algorithm 1 as printed; across, down: limits of each tile, or a function of a cell that gives them."""
    g = np.array(start)
    height, width = g.shape

    def violates(x, y):
        here = (across(x, y), down(x, y)) if callable(across) else (across, down)
        return too_long(g, x, y, *here)

    for weight in range(width + height - 1):
        for y in range(height):
            x = weight - y
            if 0 <= x < width and violates(x, y):
                g[y, x] = 1 - g[y, x]
                if violates(x, y):
                    g[y, x] = g[y - 1, x - 1]
                    g[y, x - 1] = g[y - 1, x] = 1 - g[y, x]
    return g


@pytest.mark.parametrize("block", [1, 7, 64])
def test_algorithm_1_gives_what_the_paper_prints(block, monkeypatch):
    monkeypatch.setattr(dappling, "BLOCK", block)
    monkeypatch.setattr(surgery, "_SMALL", 0)
    rng = np.random.default_rng(block)
    for _ in range(20):
        start = (rng.random(rng.integers(1, 20, 2)) < rng.random()).astype(np.uint8)
        p, q = (np.where(rng.random(2) < 0.3, np.inf, rng.integers(2, 5, 2)) for _ in range(2))
        limits = {"H0": p[0], "H1": p[1], "V0": q[0], "V1": q[1]}
        expected = algorithm_1(start, np.minimum(p, 99), np.minimum(q, 99))
        assert np.array_equal(rectify(start, limits), expected)
        assert is_dappled(expected, limits)


def test_limits_vary_over_cells_as_in_example_3_1():
    width, height = 40, 30
    start = random_start(width, height, seed=3)

    def near(x, y):
        return (x + 1 + 4) // 5 + 1

    def far(x, y):
        return (width - x + 4) // 5 + 1

    limits = {"H0": near, "V1": near, "H1": far, "V0": far}
    twin = algorithm_1(start, lambda x, y: (near(x, y), far(x, y)), lambda x, y: (far(x, y), near(x, y)))
    made = rectify(start, limits)
    assert np.array_equal(made, twin)
    assert is_dappled(made, limits)
    as_arrays = {name: f(*np.meshgrid(np.arange(width), np.arange(height))) for name, f in limits.items()}
    assert np.array_equal(rectify(start, as_arrays), made)
    # White runs across are short in the west, long ones come in the east.
    runs = [
        sum(find_violations(made[:, half], {"H0": 2})["H0"].ravel()) for half in (slice(8), slice(-8, None))
    ]
    assert runs[0] < runs[1]


def test_all_small_tilings_become_dappled_and_dappled_ones_stay():
    for bits in itertools.product((0, 1), repeat=9):
        start = np.array(bits, np.uint8).reshape(3, 3)
        made = rectify(start, PAPER)
        assert is_dappled(made, PAPER)
        assert is_dappled(start, PAPER) == np.array_equal(start, made)


@pytest.mark.parametrize("tiles", [3, 4, 7])
def test_more_tiles_take_limits_of_1(tiles):
    limits = {f"{axis}{tile}": 1 + tile % 2 for tile in range(tiles) for axis in "HV"}
    start = random_start(70, 50, (1,) * tiles, seed=tiles)
    made = rectify(start, limits)
    assert is_dappled(made, limits)
    assert not is_dappled(start, limits)
    assert np.array_equal(rectify(made, limits), made)


@pytest.mark.parametrize("cyclic", [False, True])
def test_the_check_agrees_with_looking_at_every_strip(cyclic):
    rng = np.random.default_rng(5)
    given = {"H0": 2, "V1": 1, "H0+2": 3, "V2": 0, "H1": 9}
    limits = Conditions(given)
    for _ in range(200):
        cells = rng.integers(0, 3, rng.integers(1, 7, 2))
        found = find_violations(cells, limits, cyclic=cyclic)
        for name in ("H0", "V1", "H0+2", "V2", "H1"):
            axis, members = int(name[0] == "H"), {int(tile) for tile in name[1:].split("+")}
            most = given[name]
            lines = cells if axis == 1 else cells.T
            bad = np.zeros(lines.shape, bool)
            for y, line in enumerate(lines):
                for x in range(len(line)):
                    strip = range(x - most, x + 1) if cyclic or x >= most else ()
                    bad[y, x] = len(strip) > 0 and all(line[k % len(line)] in members for k in strip)
            assert np.array_equal(found[name], bad if axis == 1 else bad.T), name


def test_algorithm_2_closes_rows_and_columns():
    rng = np.random.default_rng(2)
    for _ in range(150):
        start = (rng.random(rng.integers(4, 20, 2)) < rng.random()).astype(np.uint8)
        limits = {name: int(rng.integers(3, 7)) for name in ALL_THREE}
        assert is_dappled(rectify(start, limits, cyclic=True), limits, cyclic=True)


@pytest.mark.parametrize("a", [0, 1])
def test_remark_3_4_holds_for_every_input(a):
    rng = np.random.default_rng(a)
    for trial in range(400):
        shape = rng.integers(4, 26, 2) if trial % 2 else (24, 24)
        start = (rng.random(shape) < rng.random()).astype(np.uint8)
        limits = {f"H{a}": int(rng.integers(2, 4)), f"V{1 - a}": int(rng.integers(2, 4))}
        assert is_dappled(rectify(start, limits, cyclic=True), limits, cyclic=True), (shape, limits)


@pytest.mark.parametrize(
    ("limits", "cyclic", "what"),
    [
        ({"H0": 1, "H1": 2, "V1": 2}, False, "remark 2.2"),
        ({"H0": 0}, False, "go down to 0"),
        ({"H0+1": 3}, False, "single tiles"),
        (ALL_TWO, True, "remark 3.4"),
        ({"H0": 2, "V0": 2}, True, "remark 3.4"),
        ({"H0": np.full((8, 8), 3)}, True, "vary"),
    ],
)
def test_what_the_sweep_cannot_promise_is_refused(limits, cyclic, what):
    with pytest.raises(TilewrightValueError, match=what):
        rectify(np.zeros((8, 8), int), limits, cyclic=cyclic)


def test_remark_2_2_is_a_case_the_sweep_would_fail_and_dapple_solves():
    limits = {"H0": 1, "H1": 2, "V1": 2}
    start = random_start(30, 30, seed=1)
    assert not is_dappled(algorithm_1(start, (1, 2), (99, 2)), limits)
    assert is_dappled(dapple(start, limits), limits)


@pytest.mark.parametrize(
    "limits", [PAPER, {"H1": 2, "V0": 5}, ALL_THREE, {"H0": 3, "V1": 4, "H1": 7, "V0": inf}]
)
@pytest.mark.parametrize("start", [0.5, 0.05, lambda x, y: (x // 40 + y // 40) % 2])
def test_endless_tilings_are_dappled_and_the_same_in_every_window(limits, start):
    endless = endless_dappled_tiling(limits, start=start, seed=2**64 - 1)
    whole = endless.cells(-150, -200, 330, 300)
    assert is_dappled(whole, limits)
    assert np.array_equal(endless.cells(-71, -69, 97, 130), whole[131:261, 79:176])
    assert is_dappled(endless.cells(2**61 - 300, -(2**61), 300, 270), limits)


def test_endless_tilings_follow_their_start_and_seed():
    light = endless_dappled_tiling(ALL_THREE, start=0.9).cells(0, 0, 256, 256)
    dark = endless_dappled_tiling(ALL_THREE, start=0.1).cells(0, 0, 256, 256)
    assert light.mean() > 0.6
    assert dark.mean() < 0.4
    assert (light != endless_dappled_tiling(ALL_THREE, start=0.9, seed=1).cells(0, 0, 256, 256)).mean() > 0.2


@pytest.mark.parametrize(
    "limits", [ALL_TWO, {"H0": 1}, {"H0+1": 3}, {"H0": 3, "H2": 3}, {"H0": np.full((2, 2), 3)}]
)
def test_endless_tilings_refuse_other_limits(limits):
    with pytest.raises(TilewrightValueError, match="limits"):
        endless_dappled_tiling(limits)


def test_counts_are_those_of_the_encyclopedia():
    """OEIS A206994 and its column 3, A206989 (remark 1.4)."""
    table = [
        [2, 4, 7, 13, 24],
        [4, 16, 49, 169, 576],
        [7, 49, 174, 840, 3858],
        [13, 169, 840, 6510, 46878],
        [24, 576, 3858, 46878, 516724],
    ]
    assert [[count_dappled(k, n, PAPER) for k in range(1, 6)] for n in range(1, 6)] == table
    column = [7, 49, 174, 840, 3858, 17460, 80070, 365784, 1670838, 7636416]
    assert [count_dappled(3, n, PAPER) for n in range(1, 11)] == column


@pytest.mark.parametrize(
    "limits", [PAPER, ALL_TWO, {"H0+1": 1, "V1+2": 2, "H2": 0}, {"V0": 1, "H2": 1}, {"H0": inf, "V1": 1}]
)
@pytest.mark.parametrize("cyclic", [False, True])
def test_counts_are_those_of_trying_all(limits, cyclic):
    conditions = Conditions(limits)
    for width, height in ((2, 1), (3, 2), (2, 3), (3, 3))[: 5 - conditions.tiles + 1]:
        tried = np.array(list(itertools.product(range(conditions.tiles), repeat=width * height)), np.uint8)
        fits = [is_dappled(t.reshape(height, width), conditions, cyclic) for t in tried]
        assert count_dappled(width, height, conditions, cyclic=cyclic) == sum(fits)
        ones = (tried == 1).sum(axis=1) == 2
        asked = count_dappled(width, height, conditions, cyclic=cyclic, totals={1: 2})
        assert asked == (np.array(fits) & ones).sum()


def test_cyclic_tilings_of_4_by_4_have_equally_many_of_both_tiles():
    """The reason given for example 6.2."""
    assert (
        count_dappled(4, 4, PAPER, cyclic=True)
        == count_dappled(4, 4, PAPER, cyclic=True, totals={1: 8})
        == 90
    )
    assert count_dappled(3, 3, PAPER, cyclic=True) == 174


def test_counting_says_where_it_stops(monkeypatch):
    monkeypatch.setattr(counting, "_MOST_STATES", 2000)
    with pytest.raises(TilewrightValueError, match="states"):
        count_dappled(30, 30, ALL_THREE)


def test_starts_follow_shares_and_pictures():
    drawn = random_start(200, 150, (1, 2, 1), seed=4)
    assert np.allclose(np.bincount(drawn.ravel()) / drawn.size, (0.25, 0.5, 0.25), atol=0.01)
    assert np.array_equal(random_start(90, 40, (1, 2, 1), seed=4), drawn[:40, :90])
    ramp = np.tile(np.linspace(0, 255, 240).astype(np.uint8), (60, 1))
    hard = start_from_image(ramp, 60, 15, 3)
    assert (np.diff(hard, axis=1) >= 0).all()
    assert set(hard.ravel()) == {0, 1, 2}
    for tiles in (2, 3, 5):
        soft = start_from_image(np.dstack([ramp] * 4), 60, 30, tiles, dither=True)
        assert abs(soft[:, 20:40].mean() / (tiles - 1) - 0.5) < 0.05
        assert tiles > 2 or set(soft[:, 30]) == {0, 1}


@pytest.mark.parametrize(
    ("call", "what"),
    [
        (lambda: rectify([[0, 1], [1]], PAPER), "equally long"),
        (lambda: rectify(np.zeros((0, 3), int), PAPER), "shape"),
        (lambda: rectify([[0.5]], PAPER), "integers"),
        (lambda: rectify([[0, 300]], PAPER), "300"),
        (lambda: rectify([[0, -1]], PAPER), "-1"),
        (lambda: rectify([[0, 2]], PAPER, tiles=2), "0 to 1"),
        (lambda: rectify([[0]], {"X0": 2}), "'X0'"),
        (lambda: rectify([[0]], {"H0": -1}), "-1"),
        (lambda: rectify([[0]], {"H0": 2.5}), "2.5"),
        (lambda: rectify([[0]], {"H0": float("nan")}), "nan"),
        (lambda: rectify([[0]], {"H0": "two"}), "integer"),
        (lambda: rectify([[0]], {"H0": np.ones((2, 2), int)}), r"\(2, 2\)"),
        (lambda: rectify([[0]], ["H0"]), "mapping"),
        (lambda: rectify([[0]], {"H7": 2}, tiles=3), "tile 7"),
        (lambda: random_start(0, 5), "width"),
        (lambda: random_start(5, 5, (1,)), "at least two"),
        (lambda: start_from_image(np.full((4, 4), np.nan), 2, 2), "NaN"),
        (lambda: start_from_image(np.zeros((4, 4), bool), 2, 2), "numbers"),
        (lambda: endless_dappled_tiling(PAPER, start=2), "start"),
        (lambda: endless_dappled_tiling(PAPER).cells(0, 0, 0, 5), "width"),
        (lambda: endless_dappled_tiling(PAPER, start=lambda x, y: x * 0 + 2).cells(0, 0, 5, 5), "0 to 1"),
        (lambda: count_dappled(3, 3, {"H0": np.array([[1, 2]])}), "varies"),
    ],
)
def test_bad_input_gets_one_line(call, what):
    with pytest.raises((TilewrightValueError, TilewrightTypeError), match=what) as caught:
        call()
    assert isinstance(caught.value, TilewrightError)
    assert "\n" not in str(caught.value)
