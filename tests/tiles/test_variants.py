"""Variants of tiles: thresholds exact, shares as weighted, refusals."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, strategies as st

import tilewright as tw
from tilewright.errors import TilewrightTypeError, TilewrightValueError

TILES = tw.corner_tiles(2)
ALL = 2**24


@given(st.integers(1, 5000), st.integers(0, ALL - 1))
def test_even_variants_are_the_number_times_their_count(count, number):
    variants = tw.Variants.uniform(tw.corner_tiles(1), count)
    expected = number * count >> 24
    assert variants.rows(np.zeros(1, int), np.array([number])) == [expected]
    first = int(variants.thresholds[expected])
    assert first <= number
    assert first * count >> 24 == expected
    assert first == 0 or (first - 1) * count >> 24 == expected - 1


WEIGHTS = st.lists(st.lists(st.floats(0, 1e6), min_size=1, max_size=5).filter(any), min_size=1, max_size=6)


@given(WEIGHTS, st.integers(0, ALL - 1))
def test_weighted_variants_against_a_walk_through_exact_shares(weights, number):
    variants = tw.Variants.weighted(weights)
    for tile, row in enumerate(weights):
        # Variant v is drawn while number / 2^24 is not yet the share of those up to v.
        total, passed, chosen = sum(map(Fraction, row)), Fraction(0), 0
        for chosen, weight in enumerate(row):  # noqa: B007
            passed += Fraction(weight)
            if Fraction(number, ALL) < passed / total:
                break
        assert variants.rows(np.array([tile]), np.array([number])) == [variants.row(tile, chosen)]


@given(WEIGHTS)
def test_shares_make_the_same_variants_again(weights):
    variants = tw.Variants.weighted(weights)
    shares = np.split(variants.shares, variants.starts[1:-1])
    assert [int(s.sum()) for s in shares] == [ALL] * len(weights)
    assert tw.Variants.weighted(shares) == variants
    assert not np.concatenate(shares)[np.concatenate(weights) == 0].any()


def test_equal_weights_are_even_variants():
    even = tw.Variants.uniform(TILES, 7)
    assert tw.Variants.weighted([[0.1] * 7] * 16) == even
    assert hash(even) == hash(tw.Variants.uniform(TILES, 7))
    assert (even.even, len(even), even.tiles[13], even.row(3, 2)) == (7, 112, 1, 23)
    uneven = tw.Variants.weighted([[1, 2]] * 16)
    assert uneven.even == 0
    assert uneven != tw.Variants.uniform(TILES, 2)
    assert repr(even) == "<Variants: 7 of each of 16 tiles>"
    assert repr(tw.Variants.weighted([[1], [1, 1]])) == "<Variants: 3 of 2 tiles, weighted>"


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: tw.Variants.uniform(TILES, 0), "count is 0"),
        (lambda: tw.Variants.uniform(TILES, 2**28), "count is 268435456"),
        (lambda: tw.Variants.uniform(3), "tiles"),
        (lambda: tw.Variants.weighted([]), "weights is empty"),
        (lambda: tw.Variants.weighted([[1], []]), "weights of tile 1"),
        (lambda: tw.Variants.weighted([[1], [0, 0]]), "weights of tile 1"),
        (lambda: tw.Variants.weighted([[1, -1]]), "weights of tile 0"),
        (lambda: tw.Variants.weighted([[1, np.inf]]), "weights of tile 0"),
        (lambda: tw.Variants.weighted([["a"]]), "weights of tile 0 must be numbers"),
        (lambda: tw.Variants(np.array([0, 1, 1]), np.array([0])), "starts must rise"),
        (lambda: tw.Variants(np.array([0, 2]), np.array([0])), "starts ends at 2"),
        (lambda: tw.Variants(np.array([0, 2]), np.array([1, 5])), "at row 0"),
        (lambda: tw.Variants(np.array([0, 1, 3]), np.array([0, 0, ALL + 1])), "at row 2"),
        (lambda: tw.Variants.uniform(TILES).row(16), "tile is 16"),
        (lambda: tw.Variants.uniform(TILES).row(0, 1), "variant is 1"),
    ],
)
def test_what_makes_no_sense_is_refused(make, says):
    with pytest.raises((TilewrightValueError, TilewrightTypeError), match=says):
        make()
