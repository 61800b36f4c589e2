"""Laws of texture synthesis, over methods, tile sets, pixel types and choices of the artist."""

import numpy as np
import pytest

from tilewright.errors import (
    Cancelled,
    TilewrightError,
    TilewrightTypeError,
    TilewrightValueError,
    TilewrightWarning,
)
from tilewright.signals.textures import Exemplar, resynthesize, synthesize
from tilewright.tiles import ListedTileSet, corner_tiles, wang_tiles

CORNER_METHODS = ("nested", "ng", "squares")
EDGE_METHODS = ("centered-diamonds", "diamonds", "burke")


def small(gravel, side=200):
    return Exemplar([{"gray": gravel[:side, :side]}])


def one_per_method():
    return [(corner_tiles(2), m) for m in CORNER_METHODS] + [(wang_tiles(2), m) for m in EDGE_METHODS]


def border_misses(material):
    """Share of pixel pairs across joints of tiles that may meet whose origins do not continue."""
    tiles, origins = material.tiles, material.origins.astype(int)
    missed = pairs = 0
    for axis, joint in enumerate(tiles.shape.joints):
        far = [f for f, _ in joint]
        near = [n for _, n in joint]
        for a in range(len(tiles)):
            for b in range(len(tiles)):
                if (tiles.slots[a, far] != tiles.slots[b, near]).any():
                    continue
                if axis == 0:
                    step = origins[b, :, 0] - origins[a, :, -1] - (0, 0, 1)
                else:
                    step = origins[b, 0] - origins[a, -1] - (0, 1, 0)
                missed += step.any(axis=1).sum()
                pairs += len(step)
    return missed / pairs


@pytest.mark.parametrize(("tiles", "method"), one_per_method(), ids=lambda v: v if isinstance(v, str) else "")
def test_every_method_makes_tiles_that_meet(gravel, tiles, method):
    material = synthesize(small(gravel), tiles, tile_size=48, seed=1, method=method)
    assert material.origins.shape == (16, 48, 48, 3)
    assert border_misses(material) < 0.06
    s, y, x = np.moveaxis(material.origins, -1, 0)
    assert (s == 0).all()
    assert np.array_equal(material.pixels, material.sources[0]["gray"][y, x])


def test_wrong_neighbors_are_told_apart_by_that_measure(gravel):
    material = synthesize(small(gravel), corner_tiles(2), tile_size=48, seed=1)
    shuffled = ListedTileSet(
        material.tiles.shape, material.tiles.slots[np.random.default_rng(0).permutation(16)]
    )
    object.__setattr__(material, "tiles", shuffled)
    assert border_misses(material) > 0.3


@pytest.mark.parametrize(("tiles", "method"), one_per_method(), ids=lambda v: v if isinstance(v, str) else "")
def test_one_seed_gives_one_set_on_any_number_of_threads(gravel, tiles, method):
    first, second, other = (
        synthesize(small(gravel), tiles, tile_size=32, seed=seed, method=method, threads=threads).origins
        for seed, threads in ((5, 1), (5, 2), (6, 2))
    )
    assert np.array_equal(first, second)
    assert not np.array_equal(first, other)


@pytest.mark.parametrize("colors", [1, 2, 3])
def test_corner_colors(gravel, colors):
    material = synthesize(small(gravel), corner_tiles(colors), tile_size=32, seed=1)
    assert len(material.pixels) == colors**4
    centers = {tuple(p) for n, p in material.recipe["patches"].items() if n.startswith("center")}
    assert len(centers) == colors**4  # every tile has content of its own


def test_many_tiles_from_a_small_photograph(gravel):
    """Places run out long before 256 tiles; then they may lie nearer to each other, but still differ."""
    material = synthesize(small(gravel, 56), corner_tiles(4), tile_size=16, seed=1)
    centers = {tuple(p) for n, p in material.recipe["patches"].items() if n.startswith("center")}
    assert len(material.pixels) == 256
    assert len(centers) > 100
    assert border_misses(material) < 0.06


def test_unequal_edge_colors(gravel):
    material = synthesize(small(gravel), wang_tiles(1, 3), tile_size=32, seed=1)
    assert border_misses(material) < 0.06


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_pixel_types_and_channels_are_kept(gravel, kind, channels):
    scale = {np.uint8: 1, np.uint16: 257, np.float32: 1 / 255}[kind]
    pixels = (np.repeat(gravel[:120, :120].astype(float), channels, 2) * scale).astype(kind)
    material = synthesize(Exemplar([{"a": pixels}]), corner_tiles(1), tile_size=32)
    assert material.pixels.dtype == kind
    assert material.pixels.shape[3] == channels
    assert set(np.unique(material.pixels)) <= set(np.unique(pixels))


def test_the_range_of_values_does_not_change_the_choice(gravel):
    whole = synthesize(Exemplar([{"a": gravel[:150, :150]}]), corner_tiles(2), tile_size=32)
    wide = gravel[:150, :150].astype(np.uint16) * 256
    assert np.array_equal(
        whole.origins, synthesize(Exemplar([{"a": wide}]), corner_tiles(2), tile_size=32).origins
    )


def test_all_maps_of_a_stack_are_cut_alike(photograph):
    names = ("albedo", "normal", "roughness", "height")
    maps = {n: photograph(f"leaves_{n}")[:256, :256] for n in names}
    material = synthesize(Exemplar([maps]), corner_tiles(2), tile_size=64, seed=2)
    _, y, x = np.moveaxis(material.origins, -1, 0)
    for name in names:
        same = (material.maps[name] == maps[name][y, x]).all(axis=3)
        assert same.all() == (name in ("albedo", "roughness"))
        assert same.mean() > (0.3 if name == "height" else 0.8)  # closed beside cuts, see test_map_stacks.py


def test_marked_corners_come_from_the_second_source(gravel):
    dark, light = gravel[:200, :200] // 2, 128 + gravel[200:400, :200] // 2
    tiles = corner_tiles(4)
    exemplar = Exemplar([{"a": dark}, {"a": light}])
    material = synthesize(exemplar, tiles, tile_size=16, seed=1)
    corner_pixels = {"NE": (1, -2), "SE": (-2, -2), "SW": (-2, 1), "NW": (1, 1)}
    for slot, (y, x) in corner_pixels.items():
        marked = tiles.slots[:, tiles.shape.slot(slot)] >= 2
        assert np.array_equal(material.origins[:, y, x, 0], marked)
    pure = (tiles.slots < 2).all(axis=1)
    assert (material.origins[pure, ..., 0] == 0).all()
    assert (material.origins[~pure, ..., 0] == 1).any()


def test_masked_pixels_are_never_copied(gravel):
    mask = np.ones((240, 240), bool)
    mask[100:140, 60:200] = False
    material = synthesize(Exemplar([{"a": gravel[:240, :240]}], [mask]), corner_tiles(2), tile_size=32)
    _, y, x = np.moveaxis(material.origins, -1, 0)
    assert mask[y, x].all()
    assert not mask.all()


def test_a_rejected_patch_is_taken_from_elsewhere_and_stays_rejected(gravel):
    first = synthesize(small(gravel), corner_tiles(2), tile_size=32, seed=3)
    second = resynthesize(first, reject=["center:5"])
    third = resynthesize(second, reject=["corner:0"])

    def distance(a, b, name):
        return np.hypot(*np.subtract(a.recipe["patches"][name], b.recipe["patches"][name])[1:])

    assert distance(first, second, "center:5") >= 8
    assert distance(first, third, "corner:0") >= 8
    assert third.recipe["rejected"].keys() == {"center:5", "corner:0"}
    again = resynthesize(third)
    assert np.array_equal(third.origins, again.origins)


@pytest.mark.parametrize(
    ("tiles", "name"),
    [(corner_tiles(2), n) for n in ("corner:1", "edge-h:0-1", "center:3")] + [(wang_tiles(2), "edge-v:1")],
)
def test_a_picked_patch_lies_where_it_was_picked(gravel, tiles, name):
    picked = synthesize(small(gravel), tiles, tile_size=32, seed=3, pick={name: (0, 101, 67)})
    assert picked.recipe["patches"][name] == [0, 101, 67]
    if name == "center:3":
        assert tuple(picked.origins[3, 16, 16]) == (0, 117, 83)
    if name == "corner:1":
        tile = int(tiles.fitting(NW=1)[0])
        assert tuple(picked.origins[tile, 0, 0]) == (0, 101, 67)


def test_auto_size_follows_the_period(photograph):
    weave = Exemplar([{"a": photograph("weave")}])
    assert synthesize(weave, corner_tiles(1), tile_size="auto").tile_size in (126, 128)
    with pytest.warns(TilewrightWarning, match=r"repeats every .* tile_size 148"):
        synthesize(weave, corner_tiles(1), tile_size=148)


def test_a_hidden_copy_is_told(gravel):
    half = gravel[:256]
    with pytest.warns(TilewrightWarning, match="shows itself again"):
        synthesize(Exemplar([{"a": np.concatenate([half, half])}]), corner_tiles(1), tile_size=64)


def test_progress_counts_every_patch_and_can_stop(gravel):
    seen = []
    synthesize(
        small(gravel),
        corner_tiles(2),
        tile_size=32,
        progress=lambda *step: seen.append(step),
        method="nested",
    )
    assert [done for done, _, _ in seen] == list(range(1, 27))
    assert {total for _, total, _ in seen} == {26}

    def stop(done, total, what):
        raise Cancelled("enough")

    with pytest.raises(Cancelled):
        synthesize(small(gravel), corner_tiles(2), tile_size=32, progress=stop)


BAD = {
    "size 0": ({"tile_size": 0}, "tile_size is 0; allowed are 16 to 1024"),
    "size odd": ({"tile_size": 33}, "tile_size is 33; it must be even"),
    "size huge": ({"tile_size": 10**6}, "allowed are 16 to 1024"),
    "size text": ({"tile_size": "big"}, "tile_size must be an integer"),
    "too large for the photograph": (
        {"tile_size": 190},
        "choose a smaller tile size or a larger photograph",
    ),
    "method": ({"method": "magic"}, "method is 'magic'; allowed are faithful, nested"),
    "method of the other kind": ({"method": "burke"}, "does not go with corner tiles"),
    "seed": ({"seed": -1}, "seed is -1"),
    "pick outside": ({"pick": {"center:0": (0, 199, 0)}}, "center:0 does not leave room"),
    "pick nobody": ({"pick": {"center:99": (0, 5, 5)}}, "no patch is called 'center:99'"),
    "pick another source": ({"pick": {"center:0": (1, 5, 5)}}, "source of center:0 is 1"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_arguments_get_one_clear_line(gravel, case):
    options, message = BAD[case]
    with pytest.raises(TilewrightError) as error:
        synthesize(small(gravel), corner_tiles(2), **{"tile_size": 32, **options})
    assert message in str(error.value)
    assert "\n" not in str(error.value)


def bad_exemplars():
    good = np.zeros((64, 64, 3), np.uint8)
    holes = np.zeros((64, 64), np.float32)
    holes[3, 7] = np.nan
    return {
        "nothing": (lambda: Exemplar([]), "at least one source"),
        "no map": (lambda: Exemplar([{}]), "at least one map"),
        "one pixel": (lambda: Exemplar([{"a": good[:1, :1]}]), "1 x 1 pixels; allowed are 32 to 32768"),
        "nan": (lambda: Exemplar([{"a": holes}]), "not finite at x=7, y=3"),
        "text": (lambda: Exemplar([{"a": np.array([["x"]])}]), "allowed are uint8, uint16, float32"),
        "five channels": (lambda: Exemplar([{"a": np.zeros((64, 64, 5), np.uint8)}]), "1 to 4 channels"),
        "unequal maps": (
            lambda: Exemplar([{"a": good, "b": good[:50]}]),
            "differ in size: a 64 x 64, b 64 x 50",
        ),
        "unequal sources": (lambda: Exemplar([{"a": good}, {"a": good[..., :1]}]), "they must agree"),
        "mask of another size": (
            lambda: Exemplar([{"a": good}], [np.ones((3, 3), bool)]),
            "mask of source 0",
        ),
        "mask of nothing": (lambda: Exemplar([{"a": good}], [np.zeros((64, 64), bool)]), "leaves no pixel"),
    }


@pytest.mark.parametrize("case", bad_exemplars())
def test_bad_exemplars_get_one_clear_line(case):
    make, message = bad_exemplars()[case]
    with pytest.raises((TilewrightValueError, TilewrightTypeError)) as error:
        make()
    assert message in str(error.value)
    assert "\n" not in str(error.value)


def test_a_blank_exemplar_still_works():
    material = synthesize(Exemplar([{"a": np.full((100, 100), 7, np.uint8)}]), corner_tiles(2), tile_size=32)
    assert (material.pixels == 7).all()


def test_large_sets_say_what_they_cost(gravel):
    with pytest.raises(TilewrightValueError, match="choose fewer colors or a smaller tile size"):
        synthesize(small(gravel), corner_tiles(16), tile_size=128)

    def stop(done, total, what):
        raise Cancelled("enough")

    cost = "4096 tiles of 64 x 64 pixels take about 3 minutes"
    with pytest.warns(TilewrightWarning, match=cost), pytest.raises(Cancelled):
        synthesize(small(gravel), corner_tiles(8), tile_size=64, progress=stop)
