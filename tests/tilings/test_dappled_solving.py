"""Dappled tilings by solvers: closest ones, partial ones, the formula."""

import itertools

import numpy as np
import pytest

from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tilings import clauses as clauses_module
from tilewright.tilings.clauses import Clauses, Undecided
from tilewright.tilings.dappled import (
    Conditions,
    Impossible,
    closest as closest_module,
    closest_dapple,
    complete_dapple,
    count_dappled,
    dapple,
    dapple_formula,
    find_violations,
    random_start,
    rectify,
)

PAPER = {"H0": 2, "V1": 2}
ALL_TWO = {"H0": 2, "H1": 2, "V0": 2, "V1": 2}
SUBSETS = {"H0+1": 2, "V1+2": 3, "H2": 1}
FREE = -1
EXAMPLE_6_2 = [[1, FREE, FREE, FREE], [FREE, 0, FREE, FREE], [FREE, 0, 1, 1], [FREE, 0, FREE, FREE]]


def is_dappled(tiling, limits, cyclic=False):
    return not any(bad.any() for bad in find_violations(tiling, limits, cyclic=cyclic).values())


def all_dappled(width, height, limits, cyclic=False):
    tiles = Conditions(limits).tiles
    tried = np.array(list(itertools.product(range(tiles), repeat=width * height)), np.uint8)
    return np.array([t for t in tried if is_dappled(t.reshape(height, width), limits, cyclic)])


@pytest.mark.parametrize("cyclic", [False, True])
def test_the_closest_is_that_of_trying_all_for_3_by_3_inputs(cyclic):
    solutions = all_dappled(3, 3, PAPER, cyclic)
    assert len(solutions) == 174
    for bits in itertools.islice(itertools.product((0, 1), repeat=9), 0, None, 7 if cyclic else 3):
        start = np.array(bits, np.uint8)
        best = (solutions != start).sum(axis=1).min()
        found = closest_dapple(start.reshape(3, 3), PAPER, cyclic=cyclic)
        assert found.distance == found.bound == best
        assert (found.tiling.ravel() != start).sum() == best
        assert is_dappled(found.tiling, PAPER, cyclic)


def test_algorithm_1_misses_the_closest_for_86_of_512():
    """Section 6 (3) says it of one."""
    solutions = all_dappled(3, 3, PAPER, cyclic=False)
    beaten = 0
    for bits in itertools.product((0, 1), repeat=9):
        start = np.array(bits, np.uint8)
        best = (solutions != start).sum(axis=1).min()
        beaten += (rectify(start.reshape(3, 3), PAPER).ravel() != start).sum() > best
    assert beaten == 86


def test_example_6_1_is_closer_than_algorithm_1():
    """The closest tiling the paper prints belongs to exactly two inputs that the algorithm misses."""
    printed = np.array([[0, 1, 0], [1, 0, 1], [0, 0, 1]])
    for first_row, missed in (([0, 1, 1], 2), ([0, 0, 0], 3)):
        start = np.array([first_row, [1, 0, 1], [0, 0, 1]])
        assert closest_dapple(start, PAPER).distance == (start != printed).sum() == 1
        assert (rectify(start, PAPER) != start).sum() == missed


@pytest.mark.parametrize(("size", "seed"), [(16, 1), (32, 2)])
@pytest.mark.parametrize("cyclic", [False, True])
def test_random_tilings_are_brought_to_the_closest(size, seed, cyclic):
    start = random_start(size, size, seed=seed)
    found = closest_dapple(start, PAPER, cyclic=cyclic)
    assert found.gap == 0
    assert is_dappled(found.tiling, PAPER, cyclic)
    assert found.distance < (dapple(start, PAPER, cyclic=cyclic) != start).sum()
    again = closest_dapple(found.tiling, PAPER, cyclic=cyclic)
    assert again.distance == 0


def test_subsets_and_more_tiles():
    solutions = all_dappled(3, 2, SUBSETS)
    rng = np.random.default_rng(1)
    for _ in range(20):
        start = rng.integers(0, 3, (2, 3))
        best = (solutions != start.ravel()).sum(axis=1).min()
        assert closest_dapple(start, SUBSETS).distance == best
    start = random_start(20, 20, (1, 1, 1), seed=2)
    for made in (closest_dapple(start, SUBSETS, cyclic=True).tiling, dapple(start, SUBSETS, cyclic=True)):
        assert is_dappled(made, SUBSETS, cyclic=True)


def test_totals_and_fixed_cells_are_met():
    start = random_start(24, 24, seed=5)
    fixed = np.zeros(start.shape, bool)
    fixed[10] = True
    fixed[10, ::3] = False
    found = closest_dapple(start, PAPER, fixed=fixed, totals={1: 300})
    assert (found.tiling == 1).sum() == 300
    assert np.array_equal(found.tiling[fixed], start[fixed])
    assert found.distance >= closest_dapple(start, PAPER, fixed=fixed).distance
    few = closest_dapple(start, PAPER, totals={0: (0, 250)})
    assert (few.tiling == 0).sum() <= 250


def test_beyond_the_solvers_size_windows_state_a_gap(monkeypatch):
    monkeypatch.setattr(closest_module, "WHOLE", 1000)
    monkeypatch.setattr(closest_module, "_WINDOW", 24)
    monkeypatch.setattr(closest_module, "_STEP", 16)
    start = random_start(50, 40, seed=6)
    for cyclic in (False, True):
        found = closest_dapple(start, PAPER, cyclic=cyclic)
        assert is_dappled(found.tiling, PAPER, cyclic)
        assert found.distance == (found.tiling != start).sum()
        monkeypatch.setattr(closest_module, "WHOLE", 10_000)
        best = closest_dapple(start, PAPER, cyclic=cyclic)
        monkeypatch.setattr(closest_module, "WHOLE", 1000)
        assert found.bound <= best.distance <= found.distance
        assert found.gap < 0.12 * found.distance
    with pytest.raises(TilewrightValueError, match="totals"):
        closest_dapple(start, PAPER, totals={1: 100})


@pytest.mark.parametrize("limits", [PAPER, ALL_TWO, SUBSETS, {"H0": 1, "V1": 1}])
@pytest.mark.parametrize("size", [1, 2, 3, 7, 32])
def test_cyclic_tilings_need_no_large_limits_and_leave_valid_inputs(limits, size):
    start = random_start(size, size + 1, (1,) * Conditions(limits).tiles, seed=size)
    if size == 1 or limits == {"H0": 1, "V1": 1}:  # count_dappled() gives 0 for them, and see example 6.2
        with pytest.raises(Impossible):
            dapple(start, limits, cyclic=True)
        return
    made = dapple(start, limits, cyclic=True)
    assert is_dappled(made, limits, cyclic=True)
    assert np.array_equal(dapple(made, limits, cyclic=True), made)


def test_dapple_follows_its_start_about_as_well_as_algorithm_1():
    start = random_start(128, 128, seed=3)
    changed = (dapple(start, PAPER, cyclic=True) != start).sum()
    assert changed < 1.06 * (rectify(start, PAPER) != start).sum()


def test_example_6_2_is_impossible_on_the_torus_only():
    with pytest.raises(Impossible, match=r"pins together: .*proven"):
        complete_dapple(EXAMPLE_6_2, PAPER, cyclic=True)
    made = complete_dapple(EXAMPLE_6_2, PAPER)
    assert is_dappled(made, PAPER)
    pins = np.array(EXAMPLE_6_2)
    assert np.array_equal(made[pins >= 0], pins[pins >= 0])


def test_the_pins_named_are_guilty_and_none_of_them_is_superfluous():
    partial = np.full((6, 6), FREE)
    partial[2, 1:4] = 0  # too long by itself
    partial[5, 5] = partial[0, 0] = 1
    with pytest.raises(Impossible) as caught:
        complete_dapple(partial, PAPER)
    assert str(caught.value).count("(x=") == 3
    for x in (1, 2, 3):
        assert f"(x={x}, y=2) = 0" in str(caught.value)
        freed = partial.copy()
        freed[2, x] = FREE
        assert is_dappled(complete_dapple(freed, PAPER), PAPER)


def test_a_whole_boundary_is_extended():
    known = dapple(random_start(48, 32, seed=8), ALL_TWO)
    ring = np.full(known.shape, FREE)
    ring[[0, -1]], ring[:, [0, -1]] = known[[0, -1]], known[:, [0, -1]]
    made = [complete_dapple(ring, ALL_TWO, seed=seed) for seed in (1, 2)]
    for tiling in made:
        assert is_dappled(tiling, ALL_TWO)
        assert np.array_equal(tiling[ring >= 0], ring[ring >= 0])
    assert (made[0] != made[1]).mean() > 0.05


def test_conditions_without_any_tiling_are_proven_so():
    for limits in ({"H0": 0, "V1": 0}, {"H0+1": 2}):
        with pytest.raises(Impossible, match="meets the conditions; this"):
            complete_dapple(np.full((4, 4), FREE), limits)
        with pytest.raises(Impossible):
            closest_dapple(np.zeros((4, 4), int), limits)
        with pytest.raises(Impossible):
            dapple(np.zeros((4, 4), int), limits)


@pytest.mark.parametrize("limits", [PAPER, SUBSETS])
@pytest.mark.parametrize("cyclic", [False, True])
def test_the_formula_has_the_solutions_that_are_counted(limits, cyclic):
    formula = dapple_formula((2, 3), limits, cyclic=cyclic)
    tiles, cells = Conditions(limits).tiles, 6
    header = formula.dimacs(("a 2 x 3 tiling",)).splitlines()[:2]
    assert header == ["c a 2 x 3 tiling", f"p cnf {formula.count} {len(formula)}"]
    fitting = 0
    for drawn in itertools.product(range(tiles), repeat=cells):
        values = np.zeros(formula.count + 1, bool)
        if tiles == 2:
            values[1:] = drawn
        else:
            values[1 + np.arange(cells) * tiles + np.array(drawn)] = True
        holds = formula.violated(values) is None
        assert holds == is_dappled(np.reshape(drawn, (2, 3)), limits, cyclic)
        fitting += holds
    assert fitting == count_dappled(3, 2, limits, cyclic=cyclic)


def test_another_solvers_answer_is_read_and_checked():
    formula = dapple_formula((4, 4), PAPER, cyclic=True)
    values = formula.solve()
    lines = [str(v if values[v] else -v) for v in range(1, formula.count + 1)]
    printed = "c found\ns SATISFIABLE\nv " + " ".join(lines[:9]) + "\nv " + " ".join(lines[9:]) + " 0\n"
    assert np.array_equal(formula.values_of(printed), values)
    assert formula.violated(values) is None
    values[1:] = False
    assert formula.violated(values) is not None
    assert formula.values_of("s UNSATISFIABLE\n") is None
    pinned = dapple_formula((4, 4), PAPER, cyclic=True, partial=EXAMPLE_6_2)
    assert pinned.solve() is None
    for answer, what in (("v 1 x 0", "integers"), ("nothing", "no v lines"), ("v 99 0", "v lines")):
        with pytest.raises(TilewrightValueError, match=what):
            formula.values_of(answer)


def test_at_most_one_holds_for_long_rows():
    clauses = Clauses()
    row = clauses.variables(1, 23)
    clauses.exactly_one(row)
    for wanted in (0, 11, 22):
        values = clauses.solve(prefer=[row[0, wanted]])
        assert values[row].sum() == 1
    assert clauses.conflict([row[0, 3], row[0, 17]]) is not None
    assert clauses.conflict([row[0, 3]]) is None


def test_the_clock_ends_a_search(monkeypatch):
    monkeypatch.setattr(clauses_module, "_CONFLICTS", 100)
    pigeons = Clauses()  # eleven pigeons in ten holes: long for any solver of this kind
    sits = pigeons.variables(11, 10)
    pigeons.add(sits)
    pigeons.at_most_one(sits.T)
    with pytest.raises(Undecided, match="seconds"):
        pigeons.solve(seconds=0)


@pytest.mark.parametrize(
    ("call", "error", "what"),
    [
        (lambda: dapple([[0, 1]], PAPER, fixed=[[1, 0]]), TilewrightTypeError, "bools"),
        (lambda: dapple([[0, 1]], PAPER, fixed=[[True]]), TilewrightValueError, "fixed"),
        (lambda: complete_dapple([[0, -2]], PAPER), TilewrightValueError, "-2"),
        (lambda: closest_dapple([[0, 1]], PAPER, totals={5: 1}), TilewrightValueError, "totals"),
        (lambda: closest_dapple([[0, 1]], PAPER, totals={1: (3, 2)}), TilewrightValueError, "totals"),
        (lambda: closest_dapple([[0, 1]], PAPER, seconds=-1), TilewrightValueError, "seconds"),
        (lambda: dapple_formula((2, 2), PAPER, partial=[[0]]), TilewrightValueError, "partial"),
        (lambda: Clauses().values_of(3), TilewrightTypeError, "str"),
    ],
)
def test_bad_input_gets_one_line(call, error, what):
    with pytest.raises(error, match=what):
        call()
