"""Filling with a solver and periodic tilings: laws, brute force over tiny sets, refusals."""

from itertools import product

import numpy as np
import pytest

from tilewright.errors import TilewrightError, TilewrightTypeError, TilewrightValueError
from tilewright.tiles import WANG, ListedTileSet, corner_coded_tiles, corner_tiles, dominoes, wang_tiles
from tilewright.tiles.aperiodic import aperiodic_tiles
from tilewright.tilings import first_mismatch
from tilewright.tilings.clauses import Undecided
from tilewright.tilings.filling import filled_tiling
from tilewright.tilings.periods import periodic_tiling


def tiny_sets(count):
    """Sets of one to four Wang tiles over two colors."""
    draw = np.random.default_rng(5)
    for _ in range(count):
        codes = draw.choice(16, draw.integers(1, 5), replace=False)
        yield ListedTileSet(WANG, (codes[:, None] >> np.arange(4)) & 1, (2,) * 4)


def can_tile(tiles, width, height, torus):
    """Whether any of all the arrays of tiles is a tiling."""
    every = product(range(len(tiles)), repeat=width * height)
    return any(first_mismatch(tiles, np.reshape(a, (height, width)), torus=torus) is None for a in every)


@pytest.mark.parametrize("torus", [False, True])
@pytest.mark.parametrize(
    "tiles",
    [
        wang_tiles(2),
        wang_tiles(2, 3),
        corner_tiles(3),
        corner_coded_tiles(),
        aperiodic_tiles("jeandel-rao-31"),
    ],
    ids=lambda tiles: tiles.name,
)
def test_a_filling_matches_and_follows_its_seed(tiles, torus):
    torus &= tiles.name != "jeandel-rao-31"
    for width, height in [(1, 1), (9, 4), (12, 12)]:
        made = filled_tiling(tiles, width, height, torus=torus, seed=1)  # it checks every neighbor
        assert made.cells.shape == (height, width)
        assert made.domain.kind == ("torus" if torus else "rectangle")
    assert np.array_equal(made.cells, filled_tiling(tiles, 12, 12, torus=torus, seed=1).cells)
    assert not np.array_equal(made.cells, filled_tiling(tiles, 12, 12, torus=torus, seed=2).cells)
    assert len(np.unique(made.cells)) > min(len(tiles), 24) / 2


def test_it_fills_what_brute_force_can_and_nothing_else():
    answers = set()
    for tiles in tiny_sets(25):
        for width, height, torus in product((1, 2, 3), (1, 2), (False, True)):
            possible = can_tile(tiles, width, height, torus)
            answers.add(possible)
            if possible:
                filled_tiling(tiles, width, height, torus=torus)
            else:
                with pytest.raises(TilewrightValueError, match="this is proven"):
                    filled_tiling(tiles, width, height, torus=torus)
    assert answers == {False, True}


def test_fixed_tiles_stay_and_a_contradiction_is_proven():
    tiles = aperiodic_tiles("jeandel-rao-11-5")
    whole = filled_tiling(tiles, 12, 10, seed=3).cells
    fixed = np.where(np.arange(12) % 5 == 0, whole, -1)
    made = filled_tiling(tiles, 12, 10, fixed=fixed, seed=9).cells
    assert np.array_equal(made[:, ::5], whole[:, ::5])
    fixed[0, 1] = np.flatnonzero(tiles.slots[:, 3] != tiles.slots[fixed[0, 0], 1])[0]
    with pytest.raises(
        TilewrightValueError, match=r"12 x 10 cells that keeps the 31 fixed tiles; this is proven"
    ):
        filled_tiling(tiles, 12, 10, fixed=fixed)


def test_aperiodic_sets_fill_rectangles_that_scanlines_cannot():
    for name in ("ammann-16", "kari-14", "culik-13", "jeandel-rao-36", "lagae-44"):
        assert filled_tiling(aperiodic_tiles(name), 16, 16).cells.shape == (16, 16)


def test_the_smallest_torus_is_that_of_brute_force():
    found = set()
    for tiles in tiny_sets(25):
        sizes = sorted(product((1, 2, 3), (1, 2)), key=lambda s: (s[0] * s[1], s[0]))
        smallest = next((s for s in sizes if can_tile(tiles, *s, True)), None)
        made = periodic_tiling(tiles, 3, 2)
        assert (made and made.domain.periods) == smallest
        found.add(smallest)
    assert len(found) > 3
    # Three tiles in a ring east, and two in a ring south.
    rings = [[0, 1, 0, 0], [0, 2, 0, 1], [0, 0, 0, 2], [1, 3, 2, 3], [2, 3, 1, 3]]
    assert periodic_tiling(ListedTileSet(WANG, rings), 3, 3).domain.periods == (1, 2)


def test_the_published_set_of_44_has_a_period_and_aperiodic_ones_have_none():
    tiles = aperiodic_tiles("lagae-44")
    made = periodic_tiling(tiles, 7, 7)
    assert made.domain.periods == (2, 3)
    rows = tiles.slots[made.cells][..., 3]  # the NW corners; facts give 4 0 / 2 1 / 3 0
    turned = {np.roll(rows, (y, x), (0, 1)).tobytes() for y in range(3) for x in range(2)}
    assert np.array([[4, 0], [2, 1], [3, 0]], np.uint8).tobytes() in turned
    for name in ("jeandel-rao-11-5", "jeandel-rao-31", "ammann-16"):
        assert periodic_tiling(aperiodic_tiles(name), 7, 7) is None


def test_the_clock_stops_both():
    tiles = aperiodic_tiles("kari-14")
    with pytest.raises(Undecided, match="no answer after"):
        filled_tiling(tiles, 14, 9, torus=True, seconds=0)
    with pytest.raises(Undecided, match=r"torus of \d+ x \d+ cells after 0 seconds; none smaller is tiled"):
        periodic_tiling(tiles, 24, 24, seconds=0)


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        ((wang_tiles(2), 0, 5), {}, "width is 0; allowed are 1 to 4096"),
        ((wang_tiles(2), 5, 2.5), {}, "height must be an integer"),
        ((wang_tiles(2), 4000, 4000), {}, "4000 x 4000 cells with 16 tiles are too many"),
        ((dominoes(2), 5, 1), {}, "tiles must be square, not domino tiles"),
        (("jeandel-rao", 5, 5), {}, "tiles must be a TileSet"),
        ((wang_tiles(2), 3, 2), {"fixed": [[-1, 0], [1, 2]]}, r"fixed has shape \(2, 2\)"),
        ((wang_tiles(2), 2, 2), {"fixed": [[-1, 0], [1, 16]]}, "fixed runs from -1 to 16; allowed are"),
        ((wang_tiles(2), 2, 1), {"fixed": [[0.5, 0]]}, "fixed must hold integers"),
        ((wang_tiles(2), 2, 2), {"seed": -1}, "seed is -1"),
        ((wang_tiles(2), 2, 2), {"seconds": float("nan")}, "seconds is nan"),
    ],
)  # fmt: skip
def test_bad_fillings(arguments, options, message):
    with pytest.raises(TilewrightError, match=message):
        filled_tiling(*arguments, **options)


def test_bad_searches():
    with pytest.raises(TilewrightValueError, match="width is 65; allowed are 1 to 64"):
        periodic_tiling(wang_tiles(2), 65, 1)
    with pytest.raises(TilewrightValueError, match="square"):
        periodic_tiling(dominoes(2), 2, 2)
    with pytest.raises(TilewrightTypeError, match="seconds must be a number"):
        periodic_tiling(wang_tiles(2), 2, 2, seconds="3")
