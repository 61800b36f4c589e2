"""Packings: every tile once, neighbors matching, inverted both ways."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.tilings import first_mismatch


@pytest.mark.parametrize("c", range(1, 17))
def test_packings_hold_every_tile_once_and_are_inverted(c):
    for tiles in (tw.corner_tiles(c), tw.wang_tiles(c), tw.dominoes(c)):
        packed = tw.packing(tiles)
        cells = packed.indices(*(0,) * len(packed.size), *packed.size)
        assert np.array_equal(np.sort(cells.ravel()), np.arange(len(tiles)))
        assert first_mismatch(tiles, cells, torus=True) is None
        place = packed.place(np.arange(len(tiles)))
        assert np.array_equal(cells[tuple(reversed(place))], np.arange(len(tiles)))


@pytest.mark.parametrize("c", [1, 2, 3, 4])
def test_cube_packings(c):
    packed = tw.packing(tw.corner_cubes(c))
    cells = packed.indices(0, 0, 0, *packed.size)
    assert np.array_equal(np.sort(cells.ravel()), np.arange(c**8))
    assert first_mismatch(packed.tiles, cells, torus=True) is None
    x, y, z = packed.place(np.arange(c**8))
    assert np.array_equal(cells[z, y, x], np.arange(c**8))


@pytest.mark.parametrize("c", [1, 2, 3, 4])
def test_wang_cube_packings(c):
    packed = tw.packing(tw.wang_cubes(c))
    cells = packed.indices(0, 0, 0, *packed.size)
    assert np.array_equal(np.sort(cells.ravel()), np.arange(c**6))
    assert first_mismatch(packed.tiles, cells, torus=True) is None
    x, y, z = packed.place(np.arange(c**6))
    assert np.array_equal(cells[z, y, x], np.arange(c**6))


@pytest.mark.parametrize("c", [5, 8, 9, 16])
def test_large_cube_packings_are_inverted(c):
    packed = tw.packing(tw.corner_cubes(c))
    tiles = np.random.default_rng(c).integers(0, c**8, 2000)
    assert np.array_equal(packed.tile(*packed.place(tiles)), tiles)
    if c**8 < 2**31:
        assert np.array_equal(
            packed.indices(3, 4, 5, 4, 3, 2),
            packed.tile(3 + np.arange(4), 4 + np.arange(3)[:, None], 5 + np.arange(2)[:, None, None]),
        )


@pytest.mark.parametrize("c", range(2, 17))
def test_the_wang_packing_nests_the_one_over_a_color_less(c):
    big, small = tw.packing(tw.wang_tiles(c)), tw.packing(tw.wang_tiles(c - 1))
    n = (c - 1) ** 2
    assert np.array_equal(
        big.tiles.slots[big.indices(0, 0, n, n)], small.tiles.slots[small.indices(0, 0, n, n)]
    )


@pytest.mark.parametrize(("free", "shape"), [((0, 2), "wang"), ((1, 3), "wang"), ((0, 1), "domino")])
def test_sets_of_more_than_256_colors_have_packings_and_direct_tilings(free, shape):
    slots = np.zeros((300**2, 4 if shape == "wang" else 2), int)
    slots[:, free] = np.indices((300, 300)).reshape(2, -1).T
    tiles = tw.tile_set(slots, shape)
    assert tiles.is_complete
    packed = tw.packing(tiles)
    given = np.arange(300**2)
    places = packed.place(given)
    assert np.array_equal(packed.tile(*places), given)
    cells = packed.indices(*([0] * len(places)), *packed.size)
    assert np.array_equal(np.sort(cells.ravel()), given)
    kinds = ["edge-hash"] + ["two-hashes"] * (shape == "wang")
    for wang in kinds:
        window = (120, 120) if shape == "wang" else (14400,)
        cells = tw.direct(tiles, 3, wang=wang).indices(*([7] * len(window)), *window)
        assert first_mismatch(tiles, cells, torus=False) is None
        assert len(np.unique(tiles.slots[cells])) == 300


def test_cells_beyond_64_bits_are_refused():
    with pytest.raises(tw.TilewrightError, match=r"x holds 9223372036854775813"):
        tw.packing(tw.corner_tiles(3)).tile(2**63 + 5, 0)
    for make in (tw.packing, tw.direct, tw.stochastic):
        with pytest.raises(tw.TilewrightError, match="must be a TileSet"):
            make(5, 1, 1) if make is tw.stochastic else make(5)
