"""Dual tiles are counted as in table I of Li et al. 2010, and turned to the least of their turns."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tiles.dual import canonical_slots, count_dual_tiles, list_dual_tiles

# Li et al. 2010, table I: 3, 4 and 5 corners of 1, 2 and 3 colors.
TABLE = {1: (24, 70, 208), 2: (176, 1044, 6560), 3: (584, 5226, 49776)}


@pytest.mark.parametrize("colors", TABLE)
def test_tiles_are_counted_as_in_the_paper(colors):
    assert tuple(count_dual_tiles(n, colors) for n in (3, 4, 5)) == TABLE[colors]
    # Edges are tiles of two corners, and a corner of n slots has as many turns as it has colors.
    assert count_dual_tiles(2, colors) == 8 * colors**2 + 2 * colors
    assert count_dual_tiles(1, colors) == 4 * colors


@pytest.mark.parametrize(
    ("corners", "colors"),
    [(2, 1), (3, 1), (4, 1), (5, 1), (6, 1), (8, 1), (2, 2), (3, 2), (4, 2), (2, 3), (3, 3)],
)
def test_as_many_are_listed_as_an_enumeration_finds(corners, colors):
    slots = 4 * colors
    words = np.stack(np.unravel_index(np.arange(slots**corners), (slots,) * corners), axis=1)
    turns = np.stack([np.roll(words, -t, axis=1) @ slots ** np.arange(corners)[::-1] for t in range(corners)])
    least = np.unique(turns.min(axis=0))
    listed = list_dual_tiles(corners, colors)
    assert np.array_equal(listed @ slots ** np.arange(corners)[::-1], least)
    assert len(listed) == count_dual_tiles(corners, colors)


def test_words_are_the_least_turns():
    rng = np.random.default_rng(1)
    for n in (1, 2, 3, 7, 64):
        slots = rng.integers(0, 3, (200, n))
        words, turns = canonical_slots(slots)
        for row, word, turn in zip(slots.tolist(), words.tolist(), turns.tolist(), strict=True):
            all_turns = [row[t:] + row[:t] for t in range(n)]
            assert word == min(all_turns) == all_turns[turn]
            assert turn == all_turns.index(word)


def test_what_cannot_be_counted_is_refused():
    with pytest.raises(TilewrightValueError, match="corners is 0"):
        count_dual_tiles(0, 1)
    with pytest.raises(TilewrightTypeError):
        count_dual_tiles(3, 1.5)
    with pytest.raises(TilewrightValueError, match="2,097,684 tiles"):
        list_dual_tiles(8, 2)
    with pytest.raises(TilewrightValueError, match=r"\(m, n\)"):
        canonical_slots([1, 2])
    assert tw.count_dual_tiles is count_dual_tiles
