"""Several pictures a tile: over the same borders, drawn by the tiling, kept by recipes and folders."""

import json
from dataclasses import replace

import numpy as np
import pytest

import tilewright as tw
from handmade import handmade
from tilewright.errors import TilewrightError, TilewrightValueError
from tilewright.shaders.mipmaps import layer_mipmaps
from tilewright.signals.textures.frame import shared_border
from tilewright.signals.textures.sharing import Shared

KINDS = {
    "nested": (tw.corner_tiles(2), 32, 2),
    "ng": (tw.corner_tiles(2), 32, 1),
    "centered-diamonds": (tw.wang_tiles(2), 32, 2),
}
_MADE = {}


@pytest.fixture
def made(gravel):
    def make(method, variants=3):
        tiles, size, _ = KINDS[method]
        if (method, variants) not in _MADE:
            exemplar = tw.Exemplar([{"gray": gravel[:140, :170]}])
            _MADE[method, variants] = tw.synthesize(
                exemplar, tiles, tile_size=size, seed=2, method=method, variants=variants
            )
        return _MADE[method, variants]

    return make


@pytest.mark.parametrize("method", KINDS)
def test_any_variant_meets_any_neighbor(made, method):
    material, width = made(method), KINDS[method][2]
    assert width <= shared_border(material.tile_size)
    pixels = material.origins.reshape(16, 3, *material.origins.shape[1:])
    rim = np.ones(pixels.shape[2:4], bool)
    rim[width:-width, width:-width] = False
    # What lies along the border is one and the same, so the seam between two tiles knows no variants.
    assert (pixels[:, :, rim] == pixels[:, :1, rim]).all()
    inside = (pixels[:, :, ~rim] != pixels[:, :1, ~rim]).any(axis=-1)
    assert inside[:, 1:].mean() > 0.2
    assert (
        material.pixels[..., 0]
        == material.sources[0]["gray"][*material.origins[..., 1:].transpose(3, 0, 1, 2), 0]
    ).all()


@pytest.mark.parametrize("method", KINDS)
def test_the_first_variants_are_the_set_without(made, method):
    one, three = made(method, 1), made(method)
    assert np.array_equal(three.origins[::3], one.origins)
    assert "variants" not in one.recipe
    assert three.recipe["variants"] == 3
    assert three.recipe["patches"].items() >= one.recipe["patches"].items()
    assert {"center:5", "center:5:1", "center:5:2"} <= set(three.recipe["patches"])


def test_patches_of_variants_are_rejected_and_picked_by_name(made):
    material = replace(made("nested"), variants=tw.Variants.weighted([[1, 2, 0]] * 16))
    again = tw.resynthesize(material, reject=["center:15:2"])
    before, after = (m.recipe["patches"] for m in (material, again))
    assert [name for name in before if before[name] != after[name]] == ["center:15:2"]
    assert np.array_equal(again.origins[:-1], material.origins[:-1])
    assert again.variants == material.variants
    picked = tw.resynthesize(material, pick={"center:15:2": before["center:0"]})
    assert picked.recipe["patches"]["center:15:2"] == before["center:0"]
    with pytest.raises(TilewrightError, match="no patch is called 'center:3:3'"):
        tw.resynthesize(material, reject=["center:3:3"])


def test_maps_that_come_later_and_mended_ones_agree_at_borders(made):
    material = made("nested")
    gray = material.sources[0]["gray"]
    later = tw.add_maps(material, {"height": gray[..., 0].astype(np.float32) / 255})
    heights = later.maps["height"].reshape(16, 3, 32, 32)
    assert later.variants == material.variants
    for edge in (heights[:, :, 0], heights[:, :, -1], heights[:, :, :, 0], heights[:, :, :, -1]):
        assert np.ptp(edge, axis=1).max() < 1e-5
    assert np.array_equal(tw.resynthesize(later).origins, material.origins)


def test_a_field_shows_what_the_tiling_draws(made):
    material = made("nested")
    tiling = tw.direct(material.tiles, 5, period=(7, None))
    field = tw.TextureField(material, tiling)
    x, y = -100, 2**40 + 5
    picture = field.render(x, y, 300, 200)
    assert np.array_equal(field.render(x + 31, y + 60, 100, 90), picture[60:150, 31:131])
    assert np.array_equal(field.render(x + 7 * 32, y, 300, 200), picture)
    placed = tiling.placements(x // 32, y // 32, 11, 8, variants=material.variants)
    whole = material.pixels[3 * placed.indices + placed.variants].swapaxes(1, 2).reshape(8 * 32, 11 * 32, 1)
    top, left = y % 32, x % 32
    assert np.array_equal(picture, whole[top : top + 200, left : left + 300])


def test_repetition_falls(made):
    one, three = (tw.analyze(made("nested", n)).figures for n in (1, 3))
    assert three["same_place_share"] < one["same_place_share"] - 0.02
    assert three["repetition"] < one["repetition"]
    assert three["edge_cut_share"] < 0.06


@pytest.mark.parametrize("weights", [None, [[1], [2, 1], [0, 1, 1]]])
def test_folders_keep_variants(tmp_path, weights):
    tiles = tw.tile_set([[0, 0, 0, 0], [0, 1, 0, 1], [1, 0, 1, 0]])
    variants = tw.Variants.uniform(tiles, 2) if weights is None else tw.Variants.weighted(weights)
    material = handmade(tiles, 16, maps=2, variants=variants)
    tw.save(material, tmp_path / "set")
    manifest = json.loads((tmp_path / "set" / "tileset.json").read_text())
    assert manifest["schema"] == 3
    files = ["0.png", "0-1.png", "1.png", "1-1.png", "2.png", "2-1.png"]
    if weights:
        files = ["0.png", "1.png", "1-1.png", "2.png", "2-1.png", "2-2.png"]
    assert manifest["maps"]["map1"] == [f"map1/{file}" for file in files]
    again = tw.load(tmp_path / "set")
    assert again.variants == variants
    assert all(np.array_equal(again.maps[name], pixels) for name, pixels in material.maps.items())
    assert np.array_equal(again.origins, material.origins)


def test_one_picture_a_tile_is_stored_as_ever(tmp_path):
    tw.save(handmade(tw.corner_tiles(2)), tmp_path / "set")
    manifest = json.loads((tmp_path / "set" / "tileset.json").read_text())
    assert manifest["schema"] == 2
    assert "variants" not in manifest


def test_mip_levels_share_borders_over_all_variants(made):
    material = replace(made("nested"), kinds={"gray": "data"})
    shared = Shared(material.tiles, material.variants)
    assert np.array_equal(shared.edges["N"][::3], shared.edges["N"][1::3])
    levels = layer_mipmaps(material).levels
    assert levels[0].shape[0] == 48
    for level in levels[1:4]:
        edges = level.reshape(16, 3, *level.shape[1:])[:, :, 0]  # beyond the northern border
        assert np.array_equal(edges, np.broadcast_to(edges[:, :1], edges.shape))


def test_methods_without_patches_of_their_own_refuse_variants(gravel):
    exemplar = tw.Exemplar([{"gray": gravel[:100, :100]}])
    for method, tiles, use in (
        ("squares", tw.corner_tiles(2), "faithful or nested or ng"),
        ("diamonds", tw.wang_tiles(2), "centered-diamonds"),
        ("burke", tw.wang_tiles(2), "centered-diamonds"),
    ):
        with pytest.raises(TilewrightValueError, match=f"variants is 2, and method '{method}'.*use {use}"):
            tw.synthesize(exemplar, tiles, tile_size=32, method=method, variants=2)
    with pytest.raises(TilewrightValueError, match="variants is 257; allowed are 1 to 256"):
        tw.synthesize(exemplar, tw.corner_tiles(2), tile_size=32, variants=257)
    with pytest.raises(TilewrightValueError, match="16 pictures were given for a set of 16 tiles with 32"):
        replace(handmade(tw.corner_tiles(2)), variants=tw.Variants.uniform(tw.corner_tiles(2), 2))
