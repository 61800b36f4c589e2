"""Tiles that may meet anywhere: dappled tilings carry any signal."""

import numpy as np
import pytest

import tilewright as tw
from handmade import handmade
from tilewright.shaders.mipmaps import atlas_mipmaps
from tilewright.signals.points import PointTiles

LIMITS = {"H0": 3, "V0": 3, "H1": 3, "V1": 3}


def dappled():
    """A stored dappled tiling and an endless one."""
    start = tw.random_start(12, 10, seed=3)
    cells = tw.dapple(start, LIMITS)
    return {
        "stored": tw.array_tiling(tw.free_tiles(2), cells),
        "endless": tw.endless_dappled_tiling(LIMITS, seed=5),
        "torus": tw.array_tiling(tw.free_tiles(2), cells, torus=True),
    }


@pytest.mark.parametrize("name", ["stored", "endless", "torus"])
def test_a_texture_lies_on_a_dappled_tiling(name):
    tiling = dappled()[name]
    material = handmade(tw.free_tiles(2), size=8)
    picture = tw.TextureField(material, tiling).render(0, 0, 96, 80)
    cells = tiling.indices(0, 0, 12, 10)
    expected = material.pixels[cells].swapaxes(1, 2).reshape(80, 96, 3)
    assert np.array_equal(picture, expected)


@pytest.mark.parametrize("name", ["stored", "endless", "torus"])
def test_points_lie_on_a_dappled_tiling(name):
    tiling = dappled()[name]
    tiles = PointTiles.of(tw.free_tiles(2), [np.array([[0.25, 0.5]]), np.array([[0.75, 0.25], [0.5, 0.5]])])
    points = tw.PointField(tiles, tiling).points(2, 3, 7, 5)
    cells = tiling.indices(2, 3, 7, 5)
    assert len(points) == cells.size + cells.sum()
    x, y = (points.astype(int) - (2, 3)).T
    assert np.array_equal(np.bincount(y * 7 + x, minlength=35).reshape(5, 7), cells + 1)


def test_an_endless_dappled_tiling_is_a_tiling():
    tiling = dappled()["endless"]
    assert isinstance(tiling, tw.Tiling)
    assert tiling.domain.kind == "plane"
    for window in ((-3, 5, 40, 30), (2**40, -(2**50), 9, 8)):
        assert np.array_equal(tiling.indices(*window), tiling.cells(*window))


@pytest.mark.parametrize("seed", [1, 2])
def test_free_tiles_lie_anywhere(seed):
    tiles = tw.free_tiles(5)
    assert (len(tiles), tiles.shape.slots, tiles.shape.dimension) == (5, ("tile",), 2)
    assert list(tiles.fitting(tile=3)) == [3]
    cells = tw.direct(tiles, seed).indices(-50, 9, 100, 100)
    counts = np.bincount(cells.ravel(), minlength=5)
    assert counts.min() > 1800
    scanned = tw.scanline(tiles, 100, 100, seed).indices(0, 0, 100, 100)
    assert np.bincount(scanned.ravel(), minlength=5).min() > 1800
    torus = tw.direct(tiles, seed, period=(7, 9)).indices(0, 0, 14, 18)
    assert np.array_equal(torus[:9, :7], torus[9:, 7:])


def test_free_tiles_in_a_folder_come_back(tmp_path):
    material = handmade(tw.free_tiles(3), size=8)
    tw.save(material, tmp_path / "set")
    back = tw.load(tmp_path / "set")
    assert back.tiles.shape is tw.free_tiles(3).shape
    assert back.tiles.family == "free"
    assert np.array_equal(back.pixels, material.pixels)


def test_bad_numbers_of_free_tiles():
    with pytest.raises(tw.TilewrightError, match="count is 0"):
        tw.free_tiles(0)


def test_smaller_levels_of_an_atlas_agree_wherever_free_tiles_may_meet():
    """Any tile may lie beside any other, so texels at borders are those of no one tile."""
    atlas = atlas_mipmaps(handmade(tw.free_tiles(3), size=16), np.array([[0, 1, 2]]))
    level = atlas.levels[1][0].reshape(8, 3, 8, 3).swapaxes(0, 1)
    assert (level[:, 0, 1:-1] == level[:1, 0, 1:-1]).all()
    assert (level[:, 1:-1, -1] == level[:1, 1:-1, -1]).all()
    assert not (level[:, 4, 4] == level[:1, 4, 4]).all()
