"""What lies in each cell: variants in any window, with a period, by weight, and by every hash."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightTypeError, TilewrightValueError

TILES = tw.corner_tiles(2)
SOME = tw.Variants.weighted([[1], [3, 1], [0, 1, 1, 0], [2, 1]] * 4)
VARIANTS = {"even": tw.Variants.uniform(TILES, 3), "weighted": SOME}
TILINGS = {
    "mixer": lambda: tw.direct(TILES, 5),
    "permutation": lambda: tw.direct(TILES, 5, hash="permutation"),
    "long period": lambda: tw.direct(TILES, 5, hash="long-period"),
    "stored": lambda: tw.array_tiling(TILES, tw.direct(TILES, 1).indices(-20, -20, 64, 64) * 0, torus=True),
}


@pytest.mark.parametrize("variants", VARIANTS)
@pytest.mark.parametrize("name", TILINGS)
def test_a_window_is_a_part_of_a_larger_one_and_rows_are_drawn_by_numbers(name, variants):
    tiling, variants = TILINGS[name](), VARIANTS[variants]
    x, y = -7, 2**32 - 9 if tiling.domain.periods == (None, None) else 3
    large = tiling.rows(x, y, 40, 30, variants=variants)
    np.testing.assert_array_equal(tiling.rows(x + 5, y + 8, 11, 13, variants=variants), large[8:21, 5:16])
    hash = getattr(tiling, "hash", tw.MixerHash(0))
    columns, lines = tiling.domain.wrap(0, x, 40), tiling.domain.wrap(1, y, 30)
    numbers = hash.numbers(6, columns[np.newaxis], lines[:, np.newaxis])
    np.testing.assert_array_equal(large, variants.rows(tiling.indices(x, y, 40, 30), numbers))
    found = tiling.placements(x, y, 40, 30, variants=variants)
    np.testing.assert_array_equal(found.indices, tiling.indices(x, y, 40, 30))
    np.testing.assert_array_equal(variants.starts[found.indices] + found.variants, large)
    assert (found.indices.dtype, found.variants.dtype, found.turns.dtype) == (np.int32, np.int32, np.int8)
    assert not found.turns.any()


@pytest.mark.parametrize("variants", VARIANTS.values())
def test_variants_go_around(variants):
    tiling = tw.direct(TILES, 9, period=(6, 4))
    around = tiling.rows(-13, 2, 18, 12, variants=variants)
    np.testing.assert_array_equal(around, np.tile(around[:4, :6], (3, 3)))
    assert len(np.unique(around)) > len(np.unique(tiling.indices(0, 0, 6, 4)))


def test_variants_come_as_often_as_they_are_weighted():
    tiling = tw.direct(TILES, 2)
    rows = tiling.rows(0, 0, 512, 512, variants=SOME)
    share = np.bincount(rows.ravel(), minlength=len(SOME)) / rows.size
    expected = SOME.shares / 2**24 / 16
    assert np.abs(share - expected).max() < 5 * np.sqrt(expected.max() / rows.size)
    assert (share[expected == 0] == 0).all()
    # A variant tells nothing of the tile beside it, nor of that one's variant.
    found = tiling.placements(0, 0, 512, 512, variants=tw.Variants.uniform(TILES, 2)).variants
    same = (found[:, 1:] == found[:, :-1]).mean()
    assert abs(same - 0.5) < 0.005


@pytest.mark.parametrize("tiles", [tw.dominoes(3), tw.corner_cubes(2)], ids=lambda t: t.name)
def test_lines_and_volumes_have_variants_too(tiles):
    d, variants = tiles.shape.dimension, tw.Variants.uniform(tiles, 4)
    tiling = tw.direct(tiles, 1)
    large = tiling.rows(*(-5,) * d, *(9,) * d, variants=variants)
    inner = tiling.rows(*(-3,) * d, *(4,) * d, variants=variants)
    np.testing.assert_array_equal(inner, large[(slice(2, 6),) * d])
    assert len(np.unique(large % 4)) == 4


def test_without_variants_the_first_lies_everywhere():
    tiling = tw.direct(TILES, 3)
    for variants in (None, tw.Variants.uniform(TILES)):
        found = tiling.placements(1, 2, 5, 4, variants=variants)
        assert found.variants.shape == (4, 5)
        assert not found.variants.any()


def test_variants_of_another_set_are_refused():
    with pytest.raises(TilewrightValueError, match="variants are of 81 tiles; the set has 16"):
        tw.direct(TILES).rows(0, 0, 2, 2, variants=tw.Variants.uniform(tw.corner_tiles(3), 2))
    with pytest.raises(TilewrightTypeError, match="variants must be Variants, not 3"):
        tw.direct(TILES).placements(0, 0, 2, 2, variants=3)
