"""Families of sets: told by the tiles alone, in any order, and fast."""

from time import process_time

import numpy as np
import pytest

import tilewright as tw
from tilewright.tiles import ListedTileSet
from tilewright.tiles.recognition import class_step
from tilewright.tilings.algorithms import recognize

LONGEST = 0.05
"""Seconds of processor time; 2 ms were measured at most, 258 ms when candidates were compared."""


def made(c):
    """Sets over c colors: family, parameters, the set, and the name of its direct algorithm."""
    plain = {"colors": c}
    both = {"colors": c, "vertical_colors": c}
    yield "corner", plain, tw.corner_tiles(c), "corners"
    yield "wang", both, tw.wang_tiles(c), "edges"
    yield "wang", {"colors": c, "vertical_colors": 17 - c}, tw.wang_tiles(c, 17 - c), "edges"
    yield "domino", plain, tw.dominoes(c), "ends"
    for d in range(2, c):
        yield "compact-corner", {"colors": c, "choices": d}, tw.corner_tiles(c, d), "diagonals"
        yield "columns", {"colors": c, "choices": d}, tw.column_corner_tiles(c, d), "columns"
    yield "summed", plain, tw.summed_wang_tiles(c), "sums"
    if c > 2:  # over 2 colors these are the summed set
        yield "compact-wang", both, tw.compact_wang_tiles(c), None
    yield "bricks", {"positions": c}, tw.brick_tiles(c), None
    yield (
        "corner-coded",
        {"base": "wang", **both, "marks": 2},
        tw.corner_coded_tiles(tw.wang_tiles(c)),
        "marked-edges",
    )
    summed = tw.corner_coded_tiles(tw.summed_wang_tiles(c))
    yield "corner-coded", {"base": "summed", **plain, "marks": 2}, summed, "marked-sums"
    power_of_two = c & (c - 1) == 0
    if power_of_two:
        yield "shifted", plain, tw.shifted_wang_tiles(c), "bits"
        shifted = tw.corner_coded_tiles(tw.shifted_wang_tiles(c))
        yield "corner-coded", {"base": "shifted", **plain, "marks": 2}, shifted, "marked-bits"
    yield "corner-cube", plain, tw.corner_cubes(c), "corners"
    yield "wang-cube", plain, tw.wang_cubes(c), "edges"
    yield "compact-wang-cube", plain, tw.compact_wang_cubes(c), "bits" if power_of_two else None
    if c > 2:
        yield "compact-corner-cube", {**plain, "choices": 2}, tw.compact_corner_cubes(c), "diagonals"
    yield "free", {"count": c}, tw.free_tiles(c), "free"
    classed = tw.classed_corner_tiles(min(c, 8), c)
    yield "classed", {"colors": min(c, 8), "classes": c, "step": class_step(c)}, classed, "classed"


def name_of(algorithm):
    return algorithm and algorithm.name


@pytest.mark.parametrize("c", [2, 3, 4, 5, 7, 8, 16])
def test_every_family_is_told_at_once_by_its_tiles(c):
    for family, parameters, tiles, algorithm in made(c):
        started = process_time()
        found = recognize(tiles)
        assert process_time() - started < LONGEST, tiles
        assert (tiles.family, tiles.parameters, name_of(found)) == (family, parameters, algorithm)
        if len(tiles) < 2**14:
            shuffled = np.random.default_rng(c).permutation(tiles.slots)
            listed = ListedTileSet(tiles.shape, shuffled, tiles.colors, "from a file")
            assert (listed.family, listed.parameters) == (family, parameters)
            assert recognize(listed) is found


def test_other_families():
    assert tw.crossed_wang_tiles(2).family == "crossed"
    assert name_of(recognize(tw.crossed_wang_tiles(2))) == "crossings"
    assert tw.cohen_tiles(8).family == "summed"
    assert (tw.cohen_tiles(12).family, tw.cohen_tiles(12).parameters["vertical_colors"]) == (
        "compact-wang",
        3,
    )
    assert tw.corner_coded_tiles(scanline_only=True).family == "custom"
    culik = tw.aperiodic_tiles("culik-13")
    assert (culik.family, culik.parameters) == ("aperiodic", {"name": "culik-13"})
    assert tw.aperiodic_tiles("lagae-44").family == "custom"


@pytest.mark.parametrize("c", [3, 4])
def test_a_set_with_one_other_tile_is_of_no_family(c):
    for family, _, tiles, _ in made(c):
        if tiles.is_complete or len(tiles) > 10_000:
            continue
        there = set(tiles.codes.tolist())
        other = next(code for code in range(len(there) + 1) if code not in there)
        slots = np.vstack([tiles.slots[1:], tw.decode(other, tiles.colors)])
        changed = ListedTileSet(tiles.shape, slots, tiles.colors)
        assert changed.family == "custom", family
        assert recognize(changed) is None
        fewer = ListedTileSet(tiles.shape, tiles.slots[1:], tiles.colors)
        assert fewer.family == "custom", family


def test_a_family_stays_when_a_set_is_asked_again():
    tiles = tw.corner_tiles(4, 2)
    tiles.parameters["colors"] = 9
    assert tiles.parameters == {"colors": 4, "choices": 2}


def test_sets_are_tile_sets_whatever_holds_them():
    assert isinstance(tw.tile_set([[0, 0, 0, 0]]), tw.TileSet)
    assert isinstance(tw.corner_cubes(16), tw.TileSet)
    with pytest.raises(TypeError, match="abstract"):
        tw.TileSet()
