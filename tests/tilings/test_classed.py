"""Corner tiles in classes: equal tiles never meet, and all that holds for direct tilings holds."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightValueError

SETS = [(2, 2), (2, 5), (1, 3), (3, 4), (2, 13), (16, 16)]
FAR = 2**61 - 100


def classed(colors, classes, **options):
    return tw.direct(tw.classed_corner_tiles(colors, classes), seed=7, **options)


@pytest.mark.parametrize(("colors", "classes"), SETS[:-1])
def test_tiles_are_told_by_class_and_colors(colors, classes):
    tiles = tw.classed_corner_tiles(colors, classes)
    assert len(tiles) == classes * colors**4
    step = tiles.parameters["step"]
    assert (tiles.family, tiles.parameters) == (
        "classed",
        {"colors": colors, "classes": classes, "step": step},
    )
    ne, se, sw, nw = tiles.slots.astype(int).T
    assert (nw // colors == np.arange(len(tiles)) // colors**4).all()
    for corner, ahead in ((ne, 1), (sw, step), (se, 1 + step)):
        assert ((corner // colors - nw // colors - ahead) % classes == 0).all()


@pytest.mark.parametrize(("classes", "step"), [(2, 1), (5, 2), (13, 5)])
def test_the_step_keeps_like_points_apart(classes, step):
    assert tw.classed_corner_tiles(2, classes).parameters["step"] == step


@pytest.mark.parametrize(("colors", "classes"), SETS)
@pytest.mark.parametrize("at", [(0, 0), (-17, 10**15), (-FAR, FAR)])
def test_cells_follow_from_hash_and_class(colors, classes, at):
    """Told cell by cell in plain Python."""
    tiling, (x0, y0) = classed(colors, classes), at
    step = tiling.tiles.parameters["step"]

    def corner(x, y):
        bit = int(tw.MixerHash(7).colors(colors, 0, x, y))
        return (x + step * y) % classes * colors + bit

    found = tiling.tiles.slots_of(tiling.indices(x0, y0, 5, 4))
    for j in range(4):
        for i in range(5):
            x, y = x0 + i, y0 + j
            assert found[j, i].tolist() == [
                corner(x + 1, y),
                corner(x + 1, y + 1),
                corner(x, y + 1),
                corner(x, y),
            ]


@pytest.mark.parametrize(("colors", "classes"), SETS[:-1])
def test_equal_tiles_never_meet(colors, classes):
    cells = classed(colors, classes).indices(-300, 40, 500, 400)
    assert not (cells[:, 1:] == cells[:, :-1]).any()
    assert not (cells[1:] == cells[:-1]).any()
    if classes == 5:
        for lag in ((1, 1), (2, 0), (0, 2), (2, 2)):
            assert not (cells[lag[1] :, lag[0] :] == cells[: 400 - lag[1], : 500 - lag[0]]).any()


def test_all_tiles_are_as_likely():
    counts = np.bincount(classed(2, 5).indices(0, 0, 2000, 2000).ravel(), minlength=80)
    assert counts.min() > 0.97 * counts.mean()
    assert counts.max() < 1.03 * counts.mean()


def test_windows_agree_across_strips_and_words():
    tiling = classed(2, 5)
    whole = tiling.indices(2**32 - 150, -130, 300, 260)
    for x, y, w, h in ((0, 0, 300, 1), (149, 63, 3, 70), (297, 250, 3, 10)):
        assert (tiling.indices(2**32 - 150 + x, -130 + y, w, h) == whole[y : y + h, x : x + w]).all()


def test_periods_go_with_the_classes():
    ring = classed(2, 5, period=(10, 15))
    window = ring.indices(-10, -15, 20, 30)
    assert (window[:, :10] == window[:, 10:]).all()
    assert (window[:15] == window[15:]).all()
    assert not (window[:, 1:] == window[:, :-1]).any()
    with pytest.raises(TilewrightValueError, match=r"12 along x; 5 classes .* take 10 or 15"):
        classed(2, 5, period=(12, None))
    with pytest.raises(TilewrightValueError, match=r"3 along y; 5 classes .* take 5 or 10"):
        classed(2, 5, period=(None, 3))


def test_any_order_and_any_hash_do():
    tiles = tw.classed_corner_tiles(2, 5)
    mixed = tw.tile_set(np.random.default_rng(1).permutation(tiles.slots), "corner")
    assert mixed.family == "classed"
    there, here = (tw.direct(t, seed=7).indices(-5, 9, 60, 50) for t in (mixed, tiles))
    assert (mixed.slots_of(there) == tiles.slots_of(here)).all()
    table = tw.direct(tiles, seed=7, hash="permutation")
    cells = table.indices(0, 0, 60, 50)
    assert not (cells[:, 1:] == cells[:, :-1]).any()
    assert (table.indices(20, 30, 5, 5) == cells[30:35, 20:25]).all()


@pytest.mark.parametrize(("colors", "classes"), [(0, 5), (17, 5), (2, 1), (2, 17)])
def test_numbers_out_of_range_are_refused(colors, classes):
    with pytest.raises(TilewrightValueError):
        tw.classed_corner_tiles(colors, classes)


def test_other_sets_are_not_taken_for_classed():
    tiles = tw.classed_corner_tiles(2, 5)
    slots = tiles.slots.astype(int)
    slots[3, 0] ^= 1
    slots = np.unique(slots, axis=0)
    assert tw.tile_set(slots, "corner").family != "classed"
