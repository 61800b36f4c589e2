"""Packings by search: counts of the thesis, classes, resumption, nesting; the heat bath and its chances."""

from itertools import product
from math import exp, factorial

import numpy as np
import pytest

import tilewright as tw
from tilewright.cli.main import run
from tilewright.kernels.packing_search import redraw_lines
from tilewright.tilings.clauses import Undecided
from tilewright.tilings.packings.recursion import extend_packing, recursive_packing
from tilewright.tilings.packings.search import PackingSearch, count_packings, random_packing
from tilewright.tilings.packings.symmetries import classify_packings


def everything(packed):
    """The cells of a packing, after a check that every tile is there and neighbors match."""
    cells = packed.indices(0, 0, *packed.domain.periods)
    assert np.array_equal(np.sort(cells.ravel()), np.arange(len(packed.tiles)))
    return tw.array_tiling(packed.tiles, cells, torus=True).cells


def test_counts_of_the_thesis():
    assert count_packings(tw.corner_tiles(2)) == 32
    assert count_packings(tw.wang_tiles(2)) == 203_520


@pytest.mark.parametrize("c", [1, 2, 3, 4])
def test_wang_tiles_over_c_and_1_colors_are_counted_as_eulerian_circuits(c):
    # A circuit through all pairs of c colors: (c!)^c / c^2 cycles, by the BEST theorem, at c^2 places each.
    assert count_packings(tw.wang_tiles(c, 1)) == count_packings(tw.wang_tiles(1, c)) == factorial(c) ** c


def test_the_corner_packings_are_those_among_all_colorings():
    colors = (np.arange(2**16)[:, None] >> np.arange(16) & 1).reshape(-1, 4, 4)
    ne, sw = np.roll(colors, -1, 2), np.roll(colors, -1, 1)
    tiles = ((ne * 2 + np.roll(ne, -1, 1)) * 2 + sw) * 2 + colors
    good = tiles[(np.sort(tiles.reshape(-1, 16), axis=1) == np.arange(16)).all(axis=1)]
    found = PackingSearch(tw.corner_tiles(2), seed=3).find(None)
    moved = [np.roll(cells, (y, x), (0, 1)) for cells in found for y in range(4) for x in range(4)]
    assert {c.tobytes() for c in good.astype(np.int32)} == {c.tobytes() for c in moved}


def test_every_wang_packing_is_one_and_comes_once():
    tiles = tw.wang_tiles(2)
    found = PackingSearch(tiles, seed=1).find(None)
    assert (np.sort(found.reshape(-1, 16), axis=1) == np.arange(16)).all()
    n, e, s, w = np.moveaxis(tiles.slots[found], -1, 0)
    assert (e == np.roll(w, -1, 2)).all()
    assert (s == np.roll(n, -1, 1)).all()
    assert len(np.unique(found, axis=0)) == len(found) == 12_720
    assert (found[:, 0, 0] == 0).all()


def test_classes_up_to_symmetry():
    for tiles, count in ((tw.corner_tiles(2), 1), (tw.wang_tiles(2), 538)):
        found = PackingSearch(tiles).find(None)
        classes, members = classify_packings(tiles, found)
        assert len(classes) == count
        # With 16 translations, 8 turns and reflections and the swaps of colors, a class is an orbit.
        assert (32 % np.bincount(members) == 0).all()
        assert np.array_equal(classify_packings(tiles, classes)[0], classes)


@pytest.mark.parametrize("kind", ["wang", "corner"])
def test_a_packing_stays_in_its_class_when_turned_mirrored_moved_and_recolored(kind):
    tiles = tw.wang_tiles(3) if kind == "wang" else tw.corner_tiles(3)
    cells = random_packing(tiles, seed=11).cells
    slots = tiles.slots[cells]
    turned = np.rot90(slots, -1)[..., [3, 0, 1, 2]]  # clockwise, for edges and corners alike
    mirrored = slots[:, ::-1][..., [0, 3, 2, 1] if kind == "wang" else [3, 2, 1, 0]]
    recolored = np.array([2, 0, 1])[slots]
    images = [tiles.find(s) for s in (turned, mirrored, recolored, np.roll(slots, (2, 5), (0, 1)))]
    other = random_packing(tiles, seed=9).cells
    classes, members = classify_packings(tiles, [cells, *images, other])
    assert len(classes) == 2
    assert len(set(members[:5])) == 1


@pytest.mark.parametrize("tiles", [tw.corner_tiles(3), tw.wang_tiles(3), tw.wang_tiles(3, 2)], ids=repr)
def test_searches_for_three_colors_find_a_packing_for_every_seed(tiles):
    found = [everything(random_packing(tiles, seed=seed)) for seed in (9, 11, 9)]
    assert np.array_equal(found[0], found[2])
    assert not np.array_equal(found[0], found[1])


def test_a_search_is_resumed_where_it_was_stopped(tmp_path):
    tiles = tw.wang_tiles(2)
    whole = PackingSearch(tiles, seed=4).find(None)
    search = PackingSearch(tiles, seed=4)
    first = search.find(1000)
    behind = search.explored
    assert 0 < behind < 1
    np.savez(tmp_path / "search.npz", **search.checkpoint())
    with np.load(tmp_path / "search.npz") as saved:
        again = PackingSearch(tiles, seed=4, checkpoint=saved)
    assert again.explored == behind
    assert np.array_equal(np.concatenate([first, again.find(None)]), whole)
    assert (again.explored, again.is_over, len(again.find())) == (1, True, 0)
    with pytest.raises(tw.TilewrightError, match="checkpoint is of another search"):
        PackingSearch(tiles, seed=5, checkpoint=search.checkpoint())
    nested = PackingSearch(tw.wang_tiles(3), nest=tw.packing(tiles))
    with pytest.raises(tw.TilewrightError, match="checkpoint is of another search"):
        PackingSearch(tw.wang_tiles(3), checkpoint=nested.checkpoint())


def test_a_search_stops_when_its_callback_says_so_and_goes_on():
    def stop(done, total, what):
        seen.append(done)
        raise tw.Cancelled("enough")

    seen = []
    search = PackingSearch(tw.corner_tiles(3), seed=4)
    with pytest.raises(tw.Cancelled):
        search.find(1, stop)
    assert len(seen) == 1
    assert search.trials == 2_000_000
    assert [len(p.cells) for p, _ in zip(search, range(2), strict=False)] == [9, 9]


@pytest.mark.parametrize("make", [tw.corner_tiles, tw.wang_tiles])
def test_recursive_packings_hold_those_over_fewer_colors(make):
    small = everything(recursive_packing(make(1)))
    for c in range(2, 5):
        big = everything(recursive_packing(make(c)))
        m = (c - 1) ** 2
        assert np.array_equal(make(c).slots[big[:m, :m]], make(c - 1).slots[small])
        small = big


@pytest.mark.parametrize("seed", range(3))
def test_packings_are_extended_by_a_color(seed):
    one = tw.packing(tw.corner_tiles(1))
    two = extend_packing(one, seed=seed)
    three = extend_packing(two, seed=seed)
    for small, big in ((one, two), (two, three)):
        m = small.domain.periods[0]
        inner = small.tiles.slots_of(small.indices(0, 0, m, m))
        assert np.array_equal(big.tiles.slots[everything(big)[:m, :m]], inner)


def test_the_search_nests_too():
    for make in (tw.corner_tiles, tw.wang_tiles):
        small = tw.packing(make(2))
        big = random_packing(make(3), seed=11, nest=small)
        inner = small.tiles.slots[small.indices(0, 0, 4, 4)]
        assert np.array_equal(big.tiles.slots[everything(big)[:4, :4]], inner)


def test_extending_gives_up_in_time():
    with pytest.raises(Undecided, match="tiles of 256 are missing"):
        extend_packing(tw.packing(tw.corner_tiles(3)), seconds=0)


@pytest.mark.parametrize("kept", [0, 3])
def test_the_heat_bath_draws_colorings_as_likely_as_it_promises(kept):
    # Two colors on a torus of 3 x 3, all of them listed: chances in proportion to exp(-strength missing).
    given = (np.arange(9) < kept).reshape(3, 3)
    colors = np.array([[0, 1, 1], [0, 0, 0], [0, 0, 0]])
    number = np.zeros(10)
    weight = np.zeros(10)
    for drawn in product((0, 1), repeat=9 - kept):
        every = colors.copy()
        every[~given] = drawn
        missing = (tile_counts(every) == 0).sum()
        weight[missing - 7] += exp(-0.8 * missing)
    used = tile_counts(colors)
    state = np.array([(used == 0).sum(), 0])
    before = colors[given].copy()
    for _ in range(40_000):
        redraw_lines(colors, given, np.flatnonzero(~given), 2, 0.8, 3, 2, np.uint64(7), used, state)
        number[state[0] - 7] += 1
    assert np.array_equal(used, tile_counts(colors))
    assert state[0] == (used == 0).sum()
    assert np.array_equal(colors[given], before)
    assert abs(number / number.sum() - weight / weight.sum()).max() < 0.012


def tile_counts(colors):
    south = np.roll(colors, -1, 0)
    tiles = colors * 8 + np.roll(colors, -1, 1) * 4 + south * 2 + np.roll(south, -1, 1)
    return np.bincount(tiles.ravel(), minlength=16)


REFUSED = {
    "kind": (lambda: PackingSearch(tw.dominoes(2)), "not for the complete set of 4 domino tiles"),
    "incomplete": (lambda: count_packings(tw.corner_tiles(3, choices=2)), "searched for complete sets"),
    "no set": (lambda: random_packing(5), "tiles must be a TileSet"),
    "seed": (lambda: random_packing(tw.corner_tiles(2), seed=-1), "seed is -1"),
    "seed type": (lambda: PackingSearch(tw.corner_tiles(2), seed=0.5), "seed must be an integer"),
    "most": (lambda: PackingSearch(tw.corner_tiles(2)).find(0), "most is 0"),
    "too many to count": (lambda: count_packings(tw.corner_tiles(3)), "81 tiles; packings are counted"),
    "too many to find": (lambda: random_packing(tw.corner_tiles(4)), "4 colors; packings are found"),
    "nest": (lambda: random_packing(tw.corner_tiles(2), nest=4), "nest must be a packing, not int"),
    "nest of others": (
        lambda: random_packing(tw.corner_tiles(3), nest=tw.packing(tw.wang_tiles(2))),
        "nest must be a packing of corner tiles",
    ),
    "nest no packing": (
        lambda: random_packing(
            tw.corner_tiles(3), nest=tw.array_tiling(tw.corner_tiles(2), [[0]], torus=True)
        ),
        "nest must be a packing of corner tiles",
    ),
    "classes": (lambda: classify_packings(tw.corner_tiles(2), np.zeros((1, 4, 4), int)), "hold each of 16"),
    "classes, shape": (lambda: classify_packings(tw.corner_tiles(2), []), r"shape \(packings, 4, 4\)"),
    "recursive": (lambda: recursive_packing(tw.corner_tiles(5)), "known for up to 4"),
    "recursive kind": (lambda: recursive_packing(tw.dominoes(2)), "not for the complete set of 4 domino"),
    "extend": (lambda: extend_packing("four"), "smaller must be a packing, not str"),
    "extend wang": (lambda: extend_packing(tw.packing(tw.wang_tiles(2))), "corner tiles are extended"),
    "seconds": (
        lambda: extend_packing(tw.packing(tw.corner_tiles(2)), seconds=float("nan")),
        "seconds is nan",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_bad_input_is_refused_in_one_line(case):
    ask, message = REFUSED[case]
    with pytest.raises(tw.TilewrightError, match=message) as refusal:
        ask()
    assert "\n" not in str(refusal.value)


def test_the_command(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def call(*arguments):
        with pytest.raises(SystemExit) as ended:
            run([*map(str, arguments)])
        return ended.value.code, capsys.readouterr()

    file = tmp_path / "p.npy"
    code, said = call("pack", "--tiles", "wang", "--count", "--json")
    assert (code, said.out) == (0, '{"tiles": 16, "packings": 203520}\n')
    assert call("pack", "--colors", 3, "--method", "search", "--seed", 11, "-o", file)[0] == 0
    assert np.array_equal(np.load(file), random_packing(tw.corner_tiles(3), seed=11).cells)
    assert call("pack", "--colors", 4, "--method", "recursive", "-o", file, "--force")[0] == 0
    assert np.array_equal(np.load(file), recursive_packing(tw.corner_tiles(4)).cells)
    assert call("pack")[0] == 0
    assert tw.read_image("corner-2-packing.png").shape[2] == 3
    for arguments, message in (
        (("--colors", 3, "--count"), "packings are counted for up to 16"),
        (("--method", "luck", "-o", tmp_path / "q.npy"), "allowed are closed, search, recursive"),
        (("-o", tmp_path / "p.gif"), "allowed are .npy, .svg, .pdf, .dxf, .png"),
        (("--picture", "a.png", "-o", tmp_path / "q.npy"), "give it with a FILE.svg"),
    ):
        code, said = call("pack", *arguments)
        assert code == 2
        assert message in said.err
