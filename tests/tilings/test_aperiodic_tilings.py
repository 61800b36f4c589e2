"""Endless tilings by aperiodic sets: neighbors match everywhere, windows agree, rows obey their theory."""

import warnings
from itertools import pairwise

import numpy as np
import pytest

from handmade import handmade
from tilewright.errors import TilewrightError, TilewrightTypeError, TilewrightValueError
from tilewright.fields import TextureField
from tilewright.tiles import ListedTileSet, corner_tiles, wang_tiles
from tilewright.tiles.aperiodic import APERIODIC_SETS, aperiodic_tiles
from tilewright.tiles.translations import CONSTRUCTIONS, as_corner_tiles
from tilewright.tilings import array_tiling, direct, first_mismatch
from tilewright.tilings.aperiodic import aperiodic_tiling, translated_tiling
from tilewright.tilings.aperiodic.golden import ONE, PHI, _polygon_edges
from tilewright.tilings.aperiodic.rotations import TURN, RotationTiling, Row

WANG_SETS = ("culik-13", "kari-14", "ammann-16", "jeandel-rao-11-4", "jeandel-rao-11-5")
REACH = 2**61
FAR = ((0, 0), (-25, -31), (REACH - 50, -REACH), (-REACH, REACH - 40), (2**40 + 1, 3**25), (-(7**20), 12))


def made(name, construction):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return as_corner_tiles(aperiodic_tiles(name), construction)


def check(tiling, at, width, height):
    """Every neighbor in a window matches, and parts of it are equal to it."""
    cells = tiling.indices(*at, width, height)
    assert cells.min() >= 0
    assert first_mismatch(tiling.tiles, cells, torus=False) is None
    part = tiling.indices(at[0] + 7, at[1] + 11, width - 9, height - 20)
    assert np.array_equal(part, cells[11:-9, 7:-2])
    return cells


@pytest.mark.parametrize("name", APERIODIC_SETS)
def test_named_sets_tile_the_plane_without_a_mismatch(name):
    tiling = aperiodic_tiling(aperiodic_tiles(name), seed=2)
    cells = check(tiling, (-1000, 999), 200, 200)
    unused = {"jeandel-rao-36": 2, "lagae-44": 14}  # tiles that no tiling has
    assert len(np.unique(cells)) == len(tiling.tiles) - unused.get(name, 0)
    for seed, at in enumerate(FAR):
        check(aperiodic_tiling(aperiodic_tiles(name), seed), at, 50, 40)
    check(aperiodic_tiling(aperiodic_tiles(name), 2**64 - 1), (5, 5), 50, 40)


@pytest.mark.parametrize("name", WANG_SETS)
def test_corner_sets_made_of_wang_sets_are_known_too(name):
    failing = {"culik-13": "hv", "kari-14": "h", "ammann-16": ""}.get(name, "hv")
    for construction in CONSTRUCTIONS:
        if construction[0] in failing:
            continue
        tiling = aperiodic_tiling(made(name, construction), seed=1)
        for at in FAR[:4]:
            check(tiling, at, 40, 35)


@pytest.mark.parametrize("name", APERIODIC_SETS)
def test_seeds_differ_and_the_order_of_tiles_does_not_matter(name):
    tiles = aperiodic_tiles(name)
    cells = aperiodic_tiling(tiles, 5).indices(3, 4, 30, 20)
    assert np.array_equal(cells, aperiodic_tiling(tiles, 5).indices(3, 4, 30, 20))
    assert not np.array_equal(cells, aperiodic_tiling(tiles, 6).indices(3, 4, 30, 20))
    shuffled = ListedTileSet(tiles.shape, np.random.default_rng(0).permutation(tiles.slots), tiles.colors)
    other = aperiodic_tiling(shuffled, 5).indices(3, 4, 30, 20)
    assert np.array_equal(shuffled.slots[other], tiles.slots[cells])


def test_a_seed_goes_on_giving_the_tiling_it_gave():
    for name, cells in GIVEN.items():
        assert aperiodic_tiling(aperiodic_tiles(name)).indices(0, 0, 6, 2).tolist() == cells


GIVEN = {
    "culik-13": [[2, 6, 2, 6, 2, 6], [5, 5, 5, 5, 5, 5]],
    "kari-14": [[12, 6, 11, 10, 5, 10], [2, 0, 0, 0, 1, 3]],
    "ammann-16": [[2, 4, 3, 4, 1, 3], [10, 12, 11, 8, 12, 11]],
    "jeandel-rao-11-4": [[0, 0, 0, 1, 1, 1], [7, 4, 5, 6, 6, 6]],
    "jeandel-rao-11-5": [[0, 0, 0, 1, 1, 1], [7, 4, 5, 6, 6, 6]],
}


@pytest.mark.parametrize("name", APERIODIC_SETS)
def test_no_shift_leaves_a_window_as_it_is(name):
    cells = aperiodic_tiling(aperiodic_tiles(name), 1).indices(0, 0, 90, 90)
    for dy in range(25):
        for dx in range(-24, 25):
            if (dx, dy) > (0, 0) or dy > 0:
                moved = cells[dy : 65 + dy, 24 + dx : 65 + dx]
                assert not np.array_equal(moved, cells[:65, 24:65])


# --- Rotations ----------------------------------------------------------------------------------------


PART = TURN // 7


class Cuts(RotationTiling):
    """Rows whose points come closer to borders than 64 bits tell, at every cell."""

    def row(self, y):
        return Row(3 * PART, PART * (2 * y + 1) % TURN, tuple(k * PART for k in range(7)), tuple(range(7)))


def test_cells_close_to_a_border_are_decided_by_all_bits():
    for first in (-9000, 0):
        cells = Cuts(wang_tiles(2), 0).indices(first, -1, 9000, 2)
        for x, y in ((x, y) for y in (0, 1) for x in range(9000)):
            place = PART * (3 + (first + x) * (2 * y - 1)) % TURN
            assert cells[y, x] == min(place // PART, 6)


@pytest.mark.parametrize("name", WANG_SETS)
def test_arrays_of_cells_are_those_of_exact_numbers(name):
    tiling = aperiodic_tiling(aperiodic_tiles(name), 8)
    for x, y in ((0, 0), (REACH - 20000, -REACH), (-REACH, 77)):
        cells = tiling.indices(x, y, 20000, 1)[0]
        row = tiling.row(y)
        for column in range(0, 20000, 97):
            assert cells[column] == row.tile(x + column)


def test_the_parts_of_the_torus_fill_it_once():
    """Labbé's partition for Jeandel and Rao: areas sum to phi (phi + 3), and every level is cut into arcs."""
    for level in np.linspace(0.01, 0.99, 37):
        height = int(level * (1 << 60)) * (PHI + 3 * ONE) >> 60
        ends = []
        for _, edges in _polygon_edges():
            cut = [
                x + ((height - y) * slope >> 384) for low, high, x, y, slope in edges if low <= height < high
            ]
            assert len(cut) in (0, 2)
            ends += [tuple(sorted(cut))] if cut else []
        ends.sort()
        assert abs(ends[0][0]) < 2**50
        assert abs(ends[-1][1] - PHI) < 2**50
        assert all(abs(a[1] - b[0]) < 2**50 for a, b in pairwise(ends))


# --- What rows of Kari's and Culik's tilings mean -----------------------------------------------------


def averages(cells, slots):
    """Mean of the numbers on the N and on the S edges of each row."""
    return slots[cells].mean(axis=1)


def test_rows_of_kari_multiply_by_2_and_two_thirds():
    tiles = aperiodic_tiles("kari-14")
    width = 5000
    mean = averages(aperiodic_tiling(tiles, 4).indices(10, -20, width, 40), tiles.slots[:, [0, 2]])
    factor = mean[:, 1] / mean[:, 0]
    expected = np.where(mean[:, 0] < 1, 2, 2 / 3)
    assert np.abs(factor - expected).max() < 4 / width
    assert np.array_equal(mean[1:, 0], mean[:-1, 1])
    assert mean.min() > 2 / 3 - 2 / width
    assert mean.max() < 2
    assert set(np.round(factor, 1)) == {2.0, 0.7}


def test_rows_of_culik_multiply_by_3_and_one_half():
    tiles = aperiodic_tiles("culik-13")
    width, value = 5000, np.array([0, 0, 0, 1, 2])
    numbers = value[tiles.slots[:, [2, 0]]]
    mean = averages(aperiodic_tiling(tiles, 4).indices(10, -20, width, 40), numbers)
    expected = np.where(mean[:, 0] < 2 / 3, 3, 1 / 2)
    assert np.abs(mean[:, 1] / mean[:, 0] - expected).max() < 12 / width
    assert np.array_equal(mean[:-1, 0], mean[1:, 1])
    assert mean.min() > 1 / 3 - 2 / width


# --- Translations -------------------------------------------------------------------------------------


def test_a_rotated_tiling_shows_wang_tiles_on_white_cells():
    wang = aperiodic_tiling(aperiodic_tiles("kari-14"), 3)
    tiling = translated_tiling(wang, "rotation")
    x, y = np.meshgrid(np.arange(-6, 6), np.arange(-4, 8))
    white = (x + y) % 2 == 0
    colors = tiling.tiles.slots[tiling.indices(-6, -4, 12, 12)].astype(int) - np.array([0, 3, 0, 3])
    around = wang.tiles.slots[wang.indices(-20, -20, 40, 40)]
    assert np.array_equal(colors[white], around[20 + (y - x)[white] // 2, 20 + (x + y)[white] // 2])


def test_a_subdivided_tiling_shows_a_wang_tile_in_four():
    wang = aperiodic_tiling(aperiodic_tiles("culik-13"), 3)
    tiling = translated_tiling(wang, "subdivision")
    tile = int(wang.indices(4, -3, 1, 1)[0, 0])
    n, e, s, w = wang.tiles.slots[tile].tolist()
    star, center = 5 + 13, 5 + tile
    quarters = tiling.tiles.slots[tiling.indices(8, -6, 2, 2)].tolist()  # NE, SE, SW, NW
    assert quarters == [
        [[n, center, w, star], [star, e, center, n]],
        [[center, s, star, w], [e, star, s, center]],
    ]


def test_long_windows_are_laid_in_blocks_that_meet():
    tiling = aperiodic_tiling(aperiodic_tiles("jeandel-rao-36"), 3)
    check(tiling, (-600, 40), 1200, 25)
    check(tiling, (40, -600), 30, 1200)


def test_translations_follow_one_another():
    tiling = aperiodic_tiling(aperiodic_tiles("jeandel-rao-11-5"), 3)
    for construction, count in (("rotation", 36), ("wang", 36), ("diagonal", None), ("wang", None)):
        tiling = translated_tiling(tiling, construction)
        assert count in (None, len(tiling.tiles))
        check(tiling, (-40, REACH - 100), 30, 30)


def test_other_tilings_of_the_plane_can_be_translated():
    for wang in (direct(wang_tiles(2), 1), direct(wang_tiles(2), 1, period=(6, 4))):
        for construction in ("diagonal", "rotation", "subdivision"):
            check(translated_tiling(wang, construction), (-5, -7), 40, 30)
    with pytest.raises(TilewrightValueError, match="tiling is of a rectangle"):
        translated_tiling(array_tiling(wang_tiles(2), [[0]]), "diagonal")


@pytest.mark.parametrize("name", ["kari-14", "jeandel-rao-24"])
def test_a_texture_is_laid_by_an_aperiodic_tiling(name):
    material = handmade(aperiodic_tiles(name), size=4)
    tiling = aperiodic_tiling(material.tiles, 1)
    pixels = TextureField(material, tiling).render(-40, 4 * 10**12, 80, 60)
    for y, x in ((0, 0), (14, 19), (7, 3)):
        tile = tiling.indices(-10 + x, 10**12 + y, 1, 1)[0, 0]
        assert np.array_equal(pixels[4 * y : 4 * y + 4, 4 * x : 4 * x + 4], material.pixels[tile])


def test_refusals():
    known = aperiodic_tiles("kari-14")
    with pytest.raises(
        TilewrightValueError, match="no endless tiling is known for the complete set of 16 corner"
    ):
        aperiodic_tiling(corner_tiles(2))
    with pytest.raises(TilewrightTypeError, match="tiles must be a TileSet"):
        aperiodic_tiling("kari-14")
    for seed in (-1, 2**64, 0.5, None):
        with pytest.raises(TilewrightError, match="seed"):
            aperiodic_tiling(known, seed)
    with pytest.raises(TilewrightTypeError, match="tiling must be a Tiling"):
        translated_tiling(known, "diagonal")
    tiling = aperiodic_tiling(known)
    with pytest.raises(TilewrightValueError, match="construction is 'sideways'; allowed are diagonal"):
        translated_tiling(tiling, "sideways")
    with pytest.raises(TilewrightValueError, match="only corner sets have"):
        translated_tiling(tiling, "wang")
    with pytest.raises(TilewrightValueError, match="horizontal translation fails"):
        translated_tiling(tiling, "horizontal")
    with pytest.raises(TilewrightValueError, match=f"x is {REACH}; allowed are"):
        tiling.indices(REACH, 0, 1, 1)
