"""Maps of scanned materials: found, brought together, cut by one decision, closed, saved and added to."""

import dataclasses
import json
import time
from pathlib import Path

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

import tilewright as tw
from tilewright.analysis.textures.repetition import tile_lag_autocorrelation
from tilewright.analysis.textures.sample import lay_sample
from tilewright.analysis.textures.seams import cut_line_ratio
from tilewright.cli.main import run
from tilewright.files.map_stack import recognize_map
from tilewright.shaders.mipmaps import layer_mipmaps
from tilewright.signals.textures import TextureTiles, copy_from_sources
from tilewright.signals.textures.preparation import find_green, flatten_light, match_sizes, mend_normals


@pytest.fixture(scope="module")
def surface():
    """A bumpy surface of 160 x 160 pixels: its heights, and unit normals with green up."""
    rng = np.random.default_rng(3)
    height = gaussian_filter(rng.normal(size=(160, 160)), 3)
    height = (height - height.min()) / np.ptp(height)
    south, east = np.gradient(height * 12)
    vectors = np.stack([-east, south, np.ones_like(east)], axis=2)
    return height[..., None], vectors / np.linalg.norm(vectors, axis=2, keepdims=True)


def eight_bit(values):
    return np.rint(np.clip(values, 0, 1) * 255).astype(np.uint8)


def stack(surface, kind=np.uint8):
    height, normals = surface
    rng = np.random.default_rng(4)
    albedo = eight_bit(0.7 * height + 0.3 * rng.random((160, 160, 3)))
    as_kind = {
        np.uint8: eight_bit,
        np.uint16: lambda v: np.rint(v * 65535).astype(np.uint16),
        np.float32: lambda v: v.astype(np.float16).astype(np.float32),
    }[kind]
    return {
        "albedo": albedo,
        "normal": as_kind(normals * 0.5 + 0.5),
        "roughness": as_kind(rng.random((160, 160, 1))),
        "height": as_kind(height),
    }


def make(maps, **options):
    return tw.texture_tiles(maps, tw.corner_tiles(2), tile_size=32, seed=1, normal="gl", **options)


@pytest.mark.parametrize(
    ("stem", "name"),
    [
        ("Moss002_2K-PNG_Color", "albedo"),
        ("Moss002_2K-PNG_NormalGL", "normal"),
        ("Moss002_2K-PNG_NormalDX", "normal-dx"),
        ("Moss002_2K-PNG_AmbientOcclusion", "ao"),
        ("rock_wall_diff_2k", "albedo"),
        ("rock_wall_nor_gl_4k", "normal"),
        ("rock_wall_nor_dx_1k", "normal-dx"),
        ("rock_wall_arm_2k", "arm"),
        ("rock_wall_disp_16k", "height"),
        ("wood_basecolor", "albedo"),
        ("wood_Base_Color", "albedo"),
        ("Wood_BaseColor", "albedo"),
        ("wood_ambient_occlusion", "ao"),
        ("wood_metallic", "metalness"),
        ("leaves_height", "height"),
        ("grass", None),
        ("coral", None),
    ],
)
def test_files_are_recognized_by_their_usual_names(stem, name):
    assert recognize_map(stem) == name


def test_a_folder_of_maps(tmp_path, surface):
    maps = stack(surface)
    for name, file in (
        ("normal", "A_1K-PNG_NormalDX"),
        ("albedo", "A_1K-PNG_Color"),
        ("roughness", "A_1K-PNG_Roughness"),
        ("albedo", "preview"),
    ):
        tw.write_image(tmp_path / f"{file}.png", maps[name])
    with pytest.warns(tw.TilewrightWarning, match=r"left out preview\.png"):
        found = tw.open_exemplar(tmp_path)  # the file says which way green points: no note on that
    (tmp_path / "preview.png").unlink()
    assert list(found.sources[0]) == ["albedo", "normal", "roughness"]
    assert found.kinds == {"albedo": "color", "normal": "normal-dx", "roughness": "roughness"}
    tw.write_image(tmp_path / "A_1K-PNG_NormalGL.png", maps["normal"])
    assert tw.open_exemplar(tmp_path).kinds["normal"] == "normal-gl"
    tw.write_image(tmp_path / "B_diff.png", maps["albedo"])
    with pytest.raises(
        tw.TilewrightError, match=r"two files for albedo, A_1K-PNG_Color\.png and B_diff\.png"
    ):
        tw.open_exemplar(tmp_path)
    (tmp_path / "empty").mkdir()
    with pytest.raises(tw.TilewrightError, match="no maps that can be told by name"):
        tw.open_exemplar(tmp_path / "empty")


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
def test_green_is_found_by_heights_and_without(surface, kind):
    maps = stack(surface, kind)
    white = 1 if kind is np.float32 else np.iinfo(kind).max
    flipped = maps["normal"].copy()
    flipped[..., 1] = white - flipped[..., 1]
    for height in (maps["height"], (white - maps["height"]).astype(kind), None):
        assert find_green(maps["normal"], height)[0] == "normal-gl"
        assert find_green(flipped, height)[0] == "normal-dx"
    flat = np.full_like(maps["normal"], white // 2 if white > 1 else 0.5)
    assert find_green(flat, maps["height"])[0] is None


def test_what_is_found_is_said(surface):
    maps = stack(surface)
    with pytest.warns(tw.TilewrightWarning, match=r"'normal' is read as OpenGL .* the height map tells"):
        assert tw.open_exemplar(maps).kinds["normal"] == "normal-gl"
    del maps["height"]
    with pytest.warns(tw.TilewrightWarning, match="its own slopes tell"):
        tw.open_exemplar(maps)
    assert tw.open_exemplar(maps, normal="dx").kinds["normal"] == "normal-dx"
    assert tw.open_exemplar(maps, kinds={"normal": "normal-dx"}).kinds["normal"] == "normal-dx"


def test_the_leaves_have_directx_normals(photograph):
    normals, height = photograph("leaves_normal"), photograph("leaves_height")
    assert find_green(normals, height) == ("normal-dx", "the height map tells")
    assert find_green(normals) == ("normal-dx", "its own slopes tell")
    mended = mend_normals(normals, "normal-dx", "normal")
    length = np.linalg.norm(mended / 127.5 - 1, axis=2)
    assert np.abs(length - 1).max() < 0.009
    assert np.array_equal(mend_normals(mended, "normal-dx", "normal"), mended)


@pytest.mark.parametrize("kind", [np.uint16, np.float32])
def test_deep_maps_are_kept_to_the_last_bit(tmp_path, surface, kind):
    maps = stack(surface, kind)
    material = make(maps)
    _, y, x = np.moveaxis(material.origins, -1, 0)
    assert material.maps["roughness"].dtype == kind
    for name in ("albedo", "roughness"):
        assert np.array_equal(material.maps[name], maps[name][y, x])
    tw.save(material, tmp_path / "set")
    loaded = tw.load(tmp_path / "set")
    assert loaded.kinds == material.kinds
    for name, pixels in material.maps.items():
        assert loaded.maps[name].dtype == pixels.dtype
        assert np.array_equal(loaded.maps[name], pixels)
    if kind is np.float32:  # halves stay halves
        assert np.array_equal(material.maps["roughness"].astype(np.float16), material.maps["roughness"])


def test_only_pixels_beside_cuts_are_changed(surface):
    maps = stack(surface)
    material = make(maps)
    s = lay_sample(material, 8, 0)
    east, south = s.cuts
    near = np.zeros(s.cells.shape[0] * 32 * np.ones(2, int), bool)
    near[:, :-1] |= east
    near[:, 1:] |= east
    near[:-1] |= south
    near[1:] |= south
    _, y, x = np.moveaxis(s.origins, -1, 0)
    changed = (s.assemble(material.maps["normal"]) != maps["normal"][y, x]).any(axis=2)
    assert changed.any()
    assert not (changed & ~near).any()
    lengths = np.linalg.norm(material.maps["normal"] / 127.5 - 1, axis=3)
    assert np.abs(lengths - 1).max() < 0.02


@pytest.mark.parametrize("tiles", [tw.corner_tiles(2), tw.corner_tiles(3), tw.wang_tiles(2)])
def test_closed_maps_go_on_over_borders(surface, tiles):
    """Steps of heights and normals across tile borders are not larger than those of the copied pixels."""
    material = tw.texture_tiles(stack(surface), tiles, tile_size=32, seed=1, normal="gl")
    copied = dataclasses.replace(material, maps=copy_from_sources(material.sources, material.origins))
    for name in ("height", "normal"):
        borders, largest = [], []
        for made in (material, copied):
            picture = tw.TextureField(made, tw.direct(tiles, 3)).render(0, 0, 512, 512, map=name).astype(int)
            east, south = (np.abs(np.diff(picture, axis=axis)).max(axis=2) for axis in (1, 0))
            border = np.concatenate([east[:, 31::32].ravel(), south[31::32].ravel()])
            borders.append(border.mean())
            largest.append(border.max())
        assert borders[0] <= borders[1] + 0.1
        assert largest[0] <= largest[1] + 1


def test_leaves_as_a_whole_material(photograph):
    """The asked figures: color at most 1.10, every other map 1.25, repetition 0.20."""
    names = ("albedo", "normal", "roughness", "height")
    maps = {n: photograph(f"leaves_{n}")[:512, :512] for n in names}
    material = tw.texture_tiles(maps, tw.corner_tiles(2), seed=1, tile_size=96, normal="dx")
    assert tile_lag_autocorrelation(lay_sample(material))[0] <= 0.17
    for name in names:
        alone = TextureTiles(
            material.tiles,
            {name: material.maps[name]},
            tuple({name: s[name]} for s in material.sources),
            material.origins,
        )
        assert cut_line_ratio(lay_sample(alone)) <= (1.10 if name == "albedo" else 1.0)


def test_sizes_may_differ_by_powers_of_two(surface):
    maps = stack(surface)
    small = dict(maps, roughness=maps["roughness"][::4, ::4], normal=maps["normal"][::2, ::2])
    material = make(small)
    assert material.maps["roughness"].shape == (16, 32, 32, 1)
    lengths = np.linalg.norm(material.maps["normal"] / 127.5 - 1, axis=3)
    assert np.abs(lengths - 1).max() < 0.02
    for wrong in (maps["roughness"][:100, :100], maps["roughness"][:80], maps["roughness"][:53, :53]):
        with pytest.raises(tw.TilewrightError, match=r"differ in size: albedo 160 x 160.*powers of two"):
            make(dict(maps, roughness=wrong))
    kinds = {"a": "color"}
    flat = match_sizes({"a": np.full((8, 8, 3), 77, np.uint8)}, kinds, (32, 32))["a"]
    assert flat.shape == (32, 32, 3)
    assert (flat == 77).all()
    assert match_sizes({"a": flat}, kinds, (8, 8))["a"].shape == (8, 8, 3)


def test_maps_that_cannot_belong_together(surface):
    maps = stack(surface)
    broken = maps["normal"] / np.float32(255)
    broken[3, 4, 1] = np.nan
    for wrong, message in (
        (dict(maps, normal=maps["albedo"]), "holds no normals: .* Name its kind"),
        (dict(maps, normal=broken), "'normal' is not finite at x=4, y=3"),
        (dict(maps, normal=maps["height"]), "one channel and holds no normals"),
        ({"a\nb": maps["albedo"]}, "a name is a text"),
        ({"\ud800": maps["albedo"]}, "a name is a text"),
        ({"日" * 100: maps["albedo"]}, "a name is a text"),
    ):
        with pytest.raises(tw.TilewrightError, match=message):
            make(wrong)
    with pytest.raises(tw.TilewrightError, match="normal is 'up'; allowed are gl, dx"):
        tw.open_exemplar(maps, normal="up")
    with pytest.raises(tw.TilewrightError, match="normal-dx by kinds and gl by normal"):
        tw.open_exemplar(maps, normal="gl", kinds={"normal": "normal-dx"})
    with pytest.raises(tw.TilewrightError, match="flatten must be True or False"):
        tw.open_exemplar(maps, flatten="no")
    for mask in (np.zeros((0, 5), bool), np.ones((80, 160), bool)):
        with pytest.raises(tw.TilewrightError, match="the mask of source 0 has shape"):
            tw.open_exemplar(maps, normal="gl", mask=mask)
    with pytest.raises(tw.TilewrightError, match="none of the maps holds normals"):
        tw.open_exemplar(maps["albedo"], normal="gl")
    with pytest.raises(tw.TilewrightError, match="kind of map 'height' is 'bumps'"):
        make(maps, kinds={"height": "bumps"})


def test_flatten_takes_out_slow_light_only(gravel):
    light = np.linspace(0.5, 1, 512)[None, :, None]
    lit = np.rint(gravel * light).astype(np.uint8)
    flat = flatten_light(lit)

    def slope(pixels):
        columns = pixels.mean(axis=(0, 2))
        return columns[-128:].mean() / columns[:128].mean()

    assert slope(lit) > 1.4
    assert abs(slope(flat) - 1) < 0.1

    def fine(pixels):
        gray = pixels[..., 0].astype(float)
        return gray - gaussian_filter(gray, 4)

    # What is fine stays what it is: it is the undimmed photograph's.
    assert np.corrcoef(fine(flat).ravel(), fine(gravel).ravel())[0, 1] > 0.97
    even = tw.texture_tiles(lit, tw.corner_tiles(2), tile_size=32, seed=1, flatten=True)
    assert np.array_equal(even.sources[0]["albedo"], flat)


def test_maps_can_be_added_later(surface):
    maps = stack(surface)
    whole = make(maps)
    part = make({n: maps[n] for n in ("albedo", "normal", "height")})
    later = tw.add_maps(part, {"roughness": maps["roughness"][::2, ::2], "emissive": maps["albedo"]})
    assert list(later.maps) == ["albedo", "normal", "height", "roughness", "emissive"]
    assert np.array_equal(later.maps["emissive"], part.maps["albedo"])
    assert later.kinds["roughness"] == "roughness"
    # The same decision closes heights and normals as it did at once.
    again = tw.add_maps(whole, {n: maps[n] for n in ("normal", "height")}, normal="gl")
    for name in whole.maps:
        assert np.array_equal(again.maps[name], whole.maps[name])
    with pytest.raises(tw.TilewrightError, match=r"glow 100 x 100 and must fit 160 x 160"):
        tw.add_maps(part, {"glow": maps["albedo"][:100, :100]})
    with pytest.raises(tw.TilewrightError, match="made from 1 photographs"):
        tw.add_maps(part, {"a": maps["albedo"]}, second={"a": maps["albedo"]})
    # Maps that came later count nothing when the set is made again.
    assert np.array_equal(tw.resynthesize(later).origins, part.origins)


def test_two_photographs(surface, tmp_path):
    maps = stack(surface)
    turned = dict(reversed(maps.items()))  # another order, and green the other way
    turned["normal"] = maps["normal"].copy()
    turned["normal"][..., 1] = 255 - maps["normal"][..., 1]
    for name, pixels in maps.items():
        tw.write_image(tmp_path / f"a_{name}{'GL' if name == 'normal' else ''}.png", pixels)
    with pytest.warns(tw.TilewrightWarning, match="'normal' of the second photograph is read as DirectX"):
        found = tw.open_exemplar(tmp_path, second=turned)
    assert list(found.sources[0]) == list(found.sources[1])
    assert found.kinds["normal"] == "normal-gl"
    assert np.abs(found.sources[0]["normal"].astype(int) - found.sources[1]["normal"]).max() <= 1
    material = tw.texture_tiles(maps, tw.corner_tiles(2), second=turned, kinds=found.kinds, tile_size=16)
    tw.save(material, tmp_path / "set")
    assert tw.load(tmp_path / "set").maps.keys() == material.maps.keys()
    both = tw.add_maps(material, {"e": maps["albedo"]}, second={"e": maps["albedo"]})
    assert np.array_equal(both.maps["e"], material.maps["albedo"])


def test_slopes_tell_where_the_height_map_does_not(surface):
    maps = stack(surface)
    other = np.random.default_rng(1).random((160, 160, 1)).astype(np.float32)
    assert find_green(maps["normal"], other) == ("normal-gl", "its own slopes tell")


def test_alpha_of_roughness_is_no_roughness(surface):
    rough = np.dstack([stack(surface)["roughness"], np.full((160, 160, 1), 128, np.uint8)])
    material = make(dict(stack(surface), roughness=rough))
    for level in layer_mipmaps(material, "roughness").levels:
        assert (level[..., 1] == 128).all()


def test_the_same_seed_gives_the_same_bytes_of_files(surface, tmp_path):
    material = make(stack(surface, np.float32))
    for name in ("a", "b"):
        tw.save(material, tmp_path / name)
        time.sleep(1.1)  # a file that holds its time would differ
    manifests = [(tmp_path / name / "tileset.json").read_bytes() for name in ("a", "b")]
    assert manifests[0] == manifests[1]


def test_normals_agree_at_borders_whatever_the_method(surface):
    for method in ("nested", "ng", "squares"):
        material = make(stack(surface), method=method)
        slots = material.tiles.slots  # NE, SE, SW, NW
        for tile in range(16):
            for other in range(16):
                if (slots[tile, 0], slots[tile, 1]) == (slots[other, 0], slots[other, 1]):
                    ours, theirs = (material.maps["normal"][t][:, -1].astype(int) for t in (tile, other))
                    assert np.abs(ours - theirs).max() <= 1


@pytest.mark.filterwarnings("ignore:map 'normal' is read")
def test_the_commands(tmp_path, surface, capsys):
    for name, pixels in stack(surface).items():
        tw.write_image(tmp_path / f"x_{name}.png", pixels)

    def call(*arguments):
        with pytest.raises(SystemExit) as ended:
            run([str(a) for a in arguments])
        return ended.value.code, capsys.readouterr()

    folder = tmp_path / "set"
    small = ("--tile-size", 32, "--seed", 1, "-o", folder, "--json")
    code, said = call("texture", tmp_path, *small)
    assert code == 0
    assert json.loads(said.out)["kinds"]["normal"] == "normal-gl"
    code, said = call("texture", "--like", folder, "--map", f"emissive={tmp_path / 'x_albedo.png'}", "--json")
    assert code == 0
    assert json.loads(said.out)["maps"][-1] == "emissive"
    assert tw.load(folder).kinds["emissive"] == "color"
    for arguments, message in (
        (("--like", folder), "give them with --map"),
        (("--like", folder, "--seed", 3), "--seed has no use with --like"),
        ((tmp_path, "--kind", "height=x", *small), "kind of map 'height' is 'x'"),
        ((tmp_path / "x_albedo.png", "--normal", "gl", *small), "none of the maps holds normals"),
    ):
        code, said = call("texture", *arguments)
        assert code == 2
        assert message in said.err.splitlines()[-1]


def test_sets_of_the_first_schema_are_read(tmp_path, surface):
    material = make(
        {"albedo": stack(surface)["albedo"], "roughness": stack(surface)["roughness"]}
        | {"normal": stack(surface)["normal"]}
    )
    tw.save(material, tmp_path / "set")
    path: Path = tmp_path / "set" / "tileset.json"
    manifest = json.loads(path.read_text())
    assert manifest["schema"] == 2
    del manifest["kinds"]
    manifest["schema"] = 1
    path.write_text(json.dumps(manifest))
    assert tw.load(tmp_path / "set").kinds == material.kinds
