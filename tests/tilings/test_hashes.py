"""Lattice hashes against their definitions, written out."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tilewright as tw
from mixer import mixer

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
    x, y, z = np.meshgrid(np.arange(-20, 20), np.arange(-15, 30, 4), [-4, 17])
    assert np.array_equal(table.words(0, x), p[x % 13])  # eq. 3.1
    assert np.array_equal(table.words(0, x, y), p[(p[x % 13] + y) % 13])  # eq. 3.3
    assert np.array_equal(table.words(0, x, y, z), p[(p[(p[x % 13] + y) % 13] + z) % 13])  # eq. 3.4
    summed = tw.PermutationHash(3, size=13, nested=False)
    p, q = summed.table(0, 0), summed.table(0, 1)
    assert sorted(q) == list(range(13))
    assert not np.array_equal(p, q)
    assert np.array_equal(summed.words(0, x, y), (p[x % 13] + q[y % 13]) % 13)  # eq. 3.2


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


def test_hashes_repeat_the_tiling():
    """An edge hash lies on a lattice twice as dense, so an even period is halved."""
    corner = tw.direct(tw.corner_tiles(4), hash=tw.PermutationHash(5, size=12))
    wang = tw.direct(tw.wang_tiles(4), hash=tw.PermutationHash(5, size=12))
    for tiling, period in ((corner, 12), (wang, 6)):
        cells = tiling.indices(0, 0, 20, 20)
        assert np.array_equal(cells, tiling.indices(period, -period, 20, 20))
        assert all(not np.array_equal(cells, tiling.indices(p, 0, 20, 20)) for p in range(1, period))


@pytest.mark.parametrize("name", ["mixer", "permutation", "long-period"])
@pytest.mark.parametrize("count", [2, 3, 5, 7, 16])
def test_colors_are_even_for_any_number_of_them(name, count):
    hash_ = {"mixer": tw.MixerHash, "permutation": tw.PermutationHash, "long-period": tw.LongPeriodHash}[
        name
    ](4)
    colors = hash_.grid(count, 0, np.arange(256), np.arange(0, 1000 * 2**20, 2**20))
    counts = np.bincount(colors.ravel(), minlength=count)
    assert len(counts) == count
    assert counts.min() > 0.97 * counts.mean()


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        (lambda h: h.words(0, 1.5), "x must hold integers"),
        (lambda h: h.words(0, 1, 2**63), "y holds 9223372036854775808"),
        (lambda h: h.words(-1, 1), "stream is -1"),
        (lambda h: h.words(2**32, 1), "stream is 4294967296"),
        (lambda h: h.colors(0, 0, 1), "count is 0"),
        (lambda h: h.colors(2**15 + 1, 0, 1), "count is 32769"),
    ],
)
@pytest.mark.parametrize("made", [tw.MixerHash, tw.PermutationHash, tw.LongPeriodHash])
def test_bad_points_get_one_clear_line(made, ask, message):
    with pytest.raises(tw.TilewrightError, match=message):
        ask(made(1))


def test_more_colors_than_a_byte_holds_are_even_too():
    axes = np.arange(500), np.arange(-300, 300)
    for count, kind in ((320, np.uint16), (2**15, np.uint16), (256, np.uint8)):
        colors = tw.MixerHash(4).grid(count, 0, *axes)
        assert colors.dtype == kind
        assert np.array_equal(colors, tw.MixerHash(4).colors(count, 0, axes[0], axes[1][:, None]))
        halves = np.bincount(colors.ravel() * np.uint32(16) // count, minlength=16)
        assert np.ptp(halves) < 0.04 * halves.mean()
