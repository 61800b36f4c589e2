"""Tone outside the tiles: taken out and laid again, alike in all windows, on tori and in files."""

import json
from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

import tilewright as tw
from tilewright.errors import TilewrightError, TilewrightValueError, TilewrightWarning
from tilewright.fields.tone import tone_window
from tilewright.signals.textures.kinds import to_encoded, to_linear
from tilewright.signals.textures.tone import STRENGTH, Tone, share_of_tone, take_tone, texel_of
from tilewright.tilings import Domain


@pytest.fixture(scope="module")
def cloudy():
    """Grain under clouds of color, 256 x 256 x 3."""
    rng = np.random.default_rng(3)
    grain = rng.normal(0, 12, (256, 256, 1))
    clouds = gaussian_filter(rng.normal(0, 1, (256, 256, 3)), (40, 40, 0), mode="wrap")
    clouds *= 20 / clouds.std(axis=(0, 1))
    return np.clip(np.rint(120 + clouds + grain), 0, 255).astype(np.uint8)


@pytest.fixture(scope="module")
def toned(cloudy):
    return tw.texture_tiles(cloudy, method="faithful", tone=True, tile_size=32, seed=1)


def low(pixels, sigma=24):
    return gaussian_filter(pixels.astype(float), (sigma, sigma, 0), mode="nearest")


@pytest.mark.parametrize(("size", "texel"), [(16, 1), (64, 4), (128, 8), (100, 5), (122, 2), (1024, 64)])
def test_a_tile_is_a_whole_number_of_texels(size, texel):
    assert texel_of(size) == texel


def test_what_is_taken_and_what_is_left_are_the_photograph(cloudy):
    tone, held = take_tone(tw.Exemplar([{"albedo": cloudy}]), 64)
    left = held.sources[0]["albedo"]
    assert left.dtype == np.uint8
    # What is left varies less where all is smooth, and has the same mean.
    assert low(left).std(axis=(0, 1)).max() < (1 - STRENGTH + 0.12) * low(cloudy).std(axis=(0, 1)).min()
    # A factor takes from dark pixels other than it gives to bright ones.
    assert left.mean() == pytest.approx(cloudy.mean(), abs=0.5)
    assert abs(tone.maps["albedo"].mean()) < 1


def test_the_plane_has_the_mean_and_the_contrast_of_the_photograph(cloudy, toned):
    field = tw.TextureField(toned, tw.direct(toned.tiles, seed=5))
    plane = field.render(0, 0, 1024, 1024)
    assert np.abs(plane.mean(axis=(0, 1)) - cloudy.mean(axis=(0, 1))).max() < 3
    ratio = low(plane, 16).std(axis=(0, 1)) / low(cloudy, 16).std(axis=(0, 1))
    assert ratio.min() > 0.7
    assert ratio.max() < 1.3


@pytest.mark.parametrize("origin", [(0, 0), (-1000, 77), (2**40 + 3, -(2**50) - 11), (2**65, -(2**65))])
def test_windows_agree(toned, origin):
    field = tw.TextureField(toned, tw.direct(toned.tiles, seed=5))
    x, y = origin
    whole = field.render(x, y, 150, 130)
    for dx, dy, w, h in ((0, 0, 1, 1), (149, 129, 1, 1), (63, 5, 40, 90), (100, 100, 50, 30)):
        assert (field.render(x + dx, y + dy, w, h) == whole[dy : dy + h, dx : dx + w]).all()


def test_a_torus_closes(toned):
    side = toned.tile_size
    field = tw.TextureField(toned, tw.direct(toned.tiles, seed=5, period=(10, 5)))
    picture = field.render(-3, 8, 2 * 10 * side, 2 * 5 * side)
    assert (picture[:, : 10 * side] == picture[:, 10 * side :]).all()
    assert (picture[: 5 * side] == picture[5 * side :]).all()


@pytest.mark.parametrize(("span", "period"), [(1, 7), (3, 9), (4, 6), (3, 7)])
def test_the_grid_goes_into_any_period(span, period):
    rng = np.random.default_rng(0)
    tone = Tone(64, span, {"a": rng.normal(size=(30, 40, 1)).astype(np.float32)})
    domain, hash = Domain.plane((period, None)), tw.MixerHash(3)
    here, there = (tone_window(tone, hash, domain, x, 5, 200, 60).maps["a"] for x in (0, 64 * period))
    assert (here == there).all()


def test_seeds_and_strangers_differ(toned):
    first, second = (
        tw.TextureField(toned, tw.direct(toned.tiles, seed=s)).render(0, 0, 64, 64) for s in (1, 2)
    )
    assert (first != second).any()


@pytest.mark.parametrize("kind", ["uint16", "float32", "gray", "alpha"])
def test_every_type_of_map(cloudy, kind):
    photo = {
        "uint16": cloudy.astype(np.uint16) * 257,
        "float32": (cloudy / 255).astype(np.float32) ** 2.2,
        "gray": cloudy[..., :1],
        "alpha": np.concatenate([cloudy, np.full_like(cloudy[..., :1], 200)], axis=2),
    }[kind]
    material = tw.texture_tiles(photo, method="faithful", tone=True, tile_size=16, seed=1)
    plane = tw.TextureField(material, tw.direct(material.tiles, seed=5)).render(0, 0, 800, 800)
    assert (plane.dtype, plane.shape[2]) == (photo.dtype, photo.shape[2])
    white = 1 if kind == "float32" else np.iinfo(photo.dtype).max
    assert np.abs(plane.mean(axis=(0, 1)) - photo.mean(axis=(0, 1))).max() < 0.02 * white
    if kind == "alpha":
        assert (plane[..., 3] == 200).all()


def test_a_folder_keeps_tone(toned, tmp_path):
    tw.save(toned, tmp_path / "set")
    again = tw.load(tmp_path / "set")
    assert again.tone.span == toned.tone.span
    assert (again.tone.maps["albedo"] == toned.tone.maps["albedo"]).all()
    assert (again.tone.mean("albedo") == toned.tone.mean("albedo")).all()
    first, second = (
        tw.TextureField(m, tw.direct(m.tiles, seed=5)).render(9, 9, 99, 99) for m in (toned, again)
    )
    assert (first == second).all()


def test_sets_of_older_folders_keep_their_bytes(toned, tmp_path):
    """Schema 4 knows no means: there tone is an offset alone."""
    material = replace(toned, tone=replace(toned.tone, means={}))
    tw.save(material, tmp_path / "set")
    assert '"schema": 4' in (tmp_path / "set" / "tileset.json").read_text()
    again = tw.load(tmp_path / "set")
    tiling = tw.direct(toned.tiles, seed=5)
    plane = tw.TextureField(again, tiling).render(9, 9, 99, 99).astype(float)
    bare = tw.TextureField(replace(toned, tone=None), tiling).render(9, 9, 99, 99)
    laid = tone_window(toned.tone, tiling.chance, tiling.domain, 9, 9, 99, 99)
    rows, columns = (np.clip(np.arange(99) + edge, 0, None) // laid.texel for edge in (laid.top, laid.left))
    # Texels, not interpolated, tell it roughly.
    assert np.corrcoef((plane - bare).ravel(), laid.maps["albedo"][rows][:, columns].ravel())[0, 1] > 0.95


@pytest.mark.parametrize("mean", [[], [1.0], [1.0, 2.0, -3.0], [1.0, 2.0, 1e999]])
def test_means_that_cannot_be_are_refused(toned, tmp_path, mean):
    tw.save(toned, tmp_path / "set")
    file = tmp_path / "set" / "tileset.json"
    told = json.loads(file.read_text())
    assert told["schema"] == 5
    told["tone"]["means"]["albedo"] = mean
    file.write_text(json.dumps(told))
    with pytest.raises(TilewrightError):
        tw.load(tmp_path / "set")


def test_a_set_is_made_again_from_its_recipe(toned):
    again = tw.resynthesize(toned)
    assert (again.pixels == toned.pixels).all()
    assert (again.tone.maps["albedo"] == toned.tone.maps["albedo"]).all()


def test_other_methods_have_no_tone(cloudy):
    with pytest.raises(TilewrightValueError, match="faithful"):
        tw.texture_tiles(cloudy, tw.corner_tiles(2), tile_size=32, tone=True)


@pytest.mark.parametrize(
    ("photo", "options", "words"),
    [
        ("color", {"tone": "yes"}, "tone must be True, False or None, not 'yes'"),
        ("mask", {"tone": True}, r"none of the maps holds color, roughness or heights: mask \(data\)"),
        ("two", {"tone": True}, "tone is that of one photograph; 2 were given"),
    ],
)
def test_tone_that_cannot_be_is_refused(cloudy, photo, options, words):
    maps = {"mask": cloudy[..., 0]} if photo == "mask" else cloudy
    options = options | ({"kinds": {"mask": "data"}} if photo == "mask" else {})
    second = cloudy if photo == "two" else None
    with pytest.raises(TilewrightError, match=words):
        tw.texture_tiles(maps, second=second, method="faithful", tile_size=32, **options)


def test_maps_of_other_kinds_have_no_tone(cloudy):
    maps = {"mask": cloudy[..., 0]}
    assert tw.texture_tiles(maps, kinds={"mask": "data"}, tile_size=16, seed=1).tone is None


@pytest.fixture(scope="module")
def stack(cloudy):
    """A surface whose bright places are high and smooth."""
    bright = cloudy[..., :1]
    maps = {
        "albedo": cloudy,
        "roughness": 255 - bright,
        "height": (bright / np.float32(50)).astype(np.float32) - 1,
        "metalness": bright,
    }
    return maps, tw.texture_tiles(maps, tone=True, tile_size=32, seed=1)


def test_bright_places_stay_high_and_smooth(stack):
    maps, material = stack
    assert list(material.tone.maps) == ["albedo", "roughness", "height"]
    assert list(material.tone.means) == ["albedo"]
    field = tw.TextureField(material, tw.direct(material.tiles, seed=5))
    tones = {name: low(field.render(0, 0, 800, 800, map=name))[..., 0].ravel() for name in maps}
    assert np.corrcoef(tones["albedo"], tones["height"])[0, 1] > 0.97
    assert np.corrcoef(tones["albedo"], tones["roughness"])[0, 1] < -0.97
    for name in ("roughness", "height"):
        assert tones[name].std() == pytest.approx(low(maps[name]).std(), rel=0.3)


def test_roughness_in_floats_stays_within_its_range(stack):
    maps, _ = stack
    rough = {"roughness": (maps["roughness"] > 140).astype(np.float32)}
    material = tw.texture_tiles(rough, tone=True, tile_size=32, seed=1)
    plane = tw.TextureField(material, tw.direct(material.tiles, seed=5)).render(0, 0, 400, 400)
    assert (plane.min(), plane.max()) == (0, 1)


@pytest.mark.parametrize("kind", [np.uint8, np.float32])
def test_dark_pixels_keep_their_hue(kind):
    """Black grains on ground that is gray here and brown there: none of them turns blue."""
    rng = np.random.default_rng(4)
    brown = gaussian_filter(rng.normal(0, 1, (256, 256, 1)), (40, 40, 0), mode="wrap")
    brown = np.clip(0.5 + brown / brown.std() / 4, 0, 1)
    ground = brown * (120, 80, 50) + (1 - brown) * (60, 60, 60)
    photo = np.clip(ground * np.exp(rng.normal(-0.3, 0.7, (256, 256, 1))), 0, 255)
    photo = np.rint(photo).astype(np.uint8) if kind == np.uint8 else to_linear(photo / 255)
    material = tw.texture_tiles(photo, tone=True, tile_size=32, seed=1)
    plane = tw.TextureField(material, tw.direct(material.tiles, seed=5)).render(0, 0, 800, 800)
    shown = plane / 255 if kind == np.uint8 else to_encoded(plane)
    assert np.maximum(0, shown[..., 2] - shown[..., 0]).mean() < 0.0008


def test_heights_below_zero_take_tone_as_an_offset(cloudy):
    heights = (cloudy[..., :1] - np.float32(120)) / np.float32(30)
    material = tw.texture_tiles({"height": heights}, tone=True, tile_size=32, seed=1)
    plane = tw.TextureField(material, tw.direct(material.tiles, seed=5)).render(0, 0, 800, 800)
    assert np.isfinite(plane).all()
    assert plane.std() == pytest.approx(heights.std(), rel=0.2)
    assert plane.min() > heights.min() - 2


def test_roughness_in_floats_is_of_the_photograph(cloudy):
    rough = cloudy[..., :1] / np.float32(255)
    rough[::7, ::5] = 0.02
    material = tw.texture_tiles({"roughness": rough}, tone=True, tile_size=32, seed=1)
    assert material.pixels.min() < 0  # dark specks, less their tone
    plane = tw.TextureField(material, tw.direct(material.tiles, seed=5)).render(0, 0, 800, 800)
    assert (plane == 1).mean() < 1e-3
    assert plane.mean() == pytest.approx(rough.mean(), abs=0.03)


def test_light_below_zero_is_none(cloudy, tmp_path):
    """Maps of unknown names are taken for color, heights around 0 too."""
    light = (cloudy.astype(np.float32) - 100) / 100
    material = tw.texture_tiles(light, tone=True, tile_size=32, seed=1)
    tw.save(material, tmp_path / "set")
    again = tw.load(tmp_path / "set")
    plane = tw.TextureField(again, tw.direct(again.tiles, seed=5)).render(0, 0, 1200, 1200)
    assert np.abs(plane.mean(axis=(0, 1)) - np.maximum(light, 0).mean(axis=(0, 1))).max() < 0.05


def test_what_leaves_the_tiles_comes_back(cloudy):
    """Laid again where it was taken, tone makes the photograph."""
    dark = (cloudy.astype(float) ** 2 / 255).astype(np.uint8)
    tone, held = take_tone(tw.Exemplar([{"albedo": dark}]), 64)
    left, mean = held.sources[0]["albedo"].astype(float), tone.mean("albedo")
    away = low(dark, 64 / 5) - low(dark, 64 / 5).mean(axis=(0, 1))
    taken = STRENGTH * away / share_of_tone(dark, mean).mean(axis=(0, 1))
    inner = (slice(40, -40),) * 2
    assert np.abs(left + taken * share_of_tone(left, mean) - dark)[inner].mean() < 1.5
    assert np.abs(left - dark)[inner].mean() > 5


def test_maps_that_are_added_leave_their_tone_too(cloudy, toned):
    again = tw.add_maps(toned, {"albedo": cloudy, "emissive": cloudy, "height": cloudy[..., 0]})
    assert (again.maps["albedo"] == toned.maps["albedo"]).all()
    assert (again.maps["emissive"] == toned.maps["albedo"]).all()
    assert list(again.tone.maps) == ["albedo", "emissive", "height"]
    assert list(again.tone.means) == ["albedo", "emissive"]
    tiling = tw.direct(toned.tiles, seed=5)
    first, second = (tw.TextureField(m, tiling).render(-9, 3, 99, 77) for m in (toned, again))
    assert (first == second).all()


def test_pictures_of_tiles_say_that_they_lack_tone(toned, tmp_path):
    with pytest.warns(TilewrightWarning, match="'albedo' has tone outside its tiles"):
        tw.save_array(toned, tmp_path / "a.png")
