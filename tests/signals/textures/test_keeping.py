"""A set made again with a patch elsewhere: nothing moves but what touches that patch."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.signals.textures import drafting
from tilewright.signals.textures.plan import make_plan

SETS = {
    "nested": (lambda: tw.corner_tiles(2), {}),
    "faithful": (lambda: None, {}),
    "variants": (lambda: tw.corner_tiles(2), {"variants": 2}),
    "ng": (lambda: tw.corner_tiles(2), {"method": "ng"}),
    "Wang": (lambda: tw.wang_tiles(2), {}),
    "corner-coded": (tw.corner_coded_tiles, {}),
}


@pytest.fixture(scope="module")
def made(gravel):
    """A set of each kind, made once."""
    known = {}

    def make(kind):
        if kind not in known:
            tiles, options = SETS[kind]
            known[kind] = tw.texture_tiles(gravel[:200, :200], tiles(), tile_size=32, seed=4, **options)
        return known[kind]

    return make


def moved(before, after):
    return [n for n, spot in before.recipe["patches"].items() if after.recipe["patches"][n] != spot]


def changed(before, after):
    return [
        row
        for row, pair in enumerate(zip(before.origins, after.origins, strict=True))
        if (pair[0] != pair[1]).any()
    ]


@pytest.mark.parametrize("kind", SETS)
def test_a_rejected_center_changes_its_own_picture_alone(made, kind):
    before = made(kind)
    name = "center:6:1" if kind == "variants" else "center:6"
    after = tw.resynthesize(before, reject=[name])
    assert moved(before, after) == [name]
    assert changed(before, after) == [6 * (2 if kind == "variants" else 1) + name.count(":") - 1]
    assert after.recipe["picked"] == {}
    assert list(after.recipe["rejected"]) == [name]
    assert tw.resynthesize(after) == after


@pytest.mark.parametrize("kind", ["nested", "faithful", "variants", "corner-coded"])
def test_a_rejected_corner_or_edge_changes_the_tiles_that_show_it(made, kind):
    before = made(kind)
    plan = make_plan(before.tiles, 1)
    edges = [n for n in before.recipe["patches"] if n.startswith("edge")]
    for name in ("corner:1", *edges[1:2]):
        after = tw.resynthesize(before, reject=[name])
        numbers = (
            plan.tile_corners == 1
            if name == "corner:1"
            else np.array([[plan.edges[e].name == name for e in row] for row in plan.tile_edges])
        )
        rows = np.repeat(numbers.any(axis=1), len(before.pixels) // len(before.tiles)).nonzero()[0]
        assert moved(before, after) == [name]
        assert set(changed(before, after)) <= set(rows.tolist())
        assert len(changed(before, after)) > 0.7 * len(rows)


def test_a_pick_moves_nothing_else_and_pictures_still_meet(made):
    before = made("nested")
    after = tw.resynthesize(before, pick={"corner:0": (0, 90, 110)})
    assert moved(before, after) == ["corner:0"]
    assert after.recipe["picked"] == {"corner:0": [0, 90, 110]}
    pictures = after.pixels[..., 0]
    for side, (name, row) in enumerate({"N": 0, "S": -1}.items()):
        ends = (("NW", "NE"), ("SW", "SE"))[side]
        slots = [after.tiles.slots[:, after.tiles.shape.slots.index(end)] for end in ends]
        for pair in {*zip(*(s.tolist() for s in slots), strict=True)}:
            alike = pictures[(slots[0] == pair[0]) & (slots[1] == pair[1]), row]
            assert (alike == alike[0]).all(), name


def test_the_rest_is_searched_for_again_where_that_is_asked_for(made):
    before = made("nested")
    after = tw.resynthesize(before, reject=["corner:0"], reseed_rest=True)
    assert len(moved(before, after)) > 5
    assert after.recipe["picked"] == {}
    with pytest.raises(tw.TilewrightError, match="give it with from_"):
        tw.jobs.TextureJob(photo="a.png", reseed_rest=True)


def test_places_found_at_a_smaller_scale_stay_too(gravel, monkeypatch):
    monkeypatch.setattr(drafting, "draft_step", lambda exemplar, size: 2)
    monkeypatch.setattr("tilewright.signals.textures.synthesis.draft_step", lambda exemplar, size: 2)
    before = tw.texture_tiles(gravel[:256, :256], tile_size=32, seed=1)
    after = tw.resynthesize(before, reject=["center:9"])
    assert moved(before, after) == ["center:9"]
    assert changed(before, after) == [9]


def test_every_map_of_the_tile_changes_and_no_other(gravel):
    photo = {"albedo": gravel[:160, :160], "height": gravel[:160, :160, 0].astype(np.uint16) * 200}
    before = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=32, seed=2)
    after = tw.resynthesize(before, reject=["center:3"])
    differ = {
        n: np.abs(before.maps[n].astype(float) - after.maps[n]).max(axis=(1, 2, 3)) for n in before.maps
    }
    assert differ["albedo"].nonzero()[0].tolist() == [3]
    # Heights are closed over borders, which neighbors share.
    steps = differ["height"] / before.maps["height"].std()
    assert steps[3] > 1
    assert np.delete(steps, 3).max() < 0.05


def test_bars_of_lone_things_hold_for_what_stays():
    """One bright thing, shown once: a tile whose patch is rejected does not show it again."""
    rng = np.random.default_rng(5)
    photo = rng.integers(90, 110, (160, 160, 3)).astype(np.uint8)
    photo[40:48, 100:108] = 255
    before = tw.texture_tiles(photo, tile_size=16, seed=1, tone=False)
    shows = [t for t, picture in enumerate(before.pixels) if (picture > 200).any()]
    other = next(t for t in range(len(before.pixels)) if t not in shows)
    after = tw.resynthesize(before, reject=[f"center:{other}"])
    assert not (after.pixels[other] > 200).any()
