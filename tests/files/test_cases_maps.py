"""Whole materials as people bring them: the files beside the checkout, and the values asked of them."""

import json
import warnings
from xml.etree import ElementTree

import numpy as np
import pytest

import tilewright as tw
from commands import call
from tilewright.tilings import packing


def opened(photo, **options):
    """An exemplar, and the notes that were made."""
    with warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        found = tw.open_exemplar(photo, **options)
    return found, " ".join(str(note.message) for note in notes)


FOLDERS = {
    "substance": ("albedo", "normal", "roughness", "height"),
    "poliigon": ("albedo", "normal", "roughness"),
    "map_suffix": ("albedo", "normal", "roughness", "ao"),
    "gltf": ("albedo", "normal", "roughness", "metalness"),
    "mac": ("albedo", "normal"),
    "jp2": ("albedo", "normal"),
}


@pytest.mark.parametrize("name", FOLDERS)
def test_a_folder_gives_all_its_maps(case, name):
    found, notes = opened(case(f"folders/{name}"))
    assert tuple(found.sources[0]) == FOLDERS[name]
    assert found.kinds["normal"] == "normal-gl"
    assert found.kinds.get("roughness", "roughness") == "roughness"
    assert "left out" not in notes


def test_files_that_are_not_read_are_named(case):
    found, notes = opened(case("folders/dds"))
    if "roughness" in found.sources[0]:
        assert found.sources[0]["roughness"].mean() == pytest.approx(132.5, abs=1)
    else:
        assert "left out rock_normal.dds, rock_roughness.dds" in notes


def test_metal_stays_none_from_afar(case, tmp_path):
    """In the map of glTF, 0 in blue was mixed with roughness in mip levels."""
    from tilewright.shaders.mipmaps import layer_mipmaps

    with pytest.warns(tw.TilewrightWarning, match=r"Default_metalRoughness\.png is 255, 51, 0 everywhere"):
        material = tw.texture_tiles(case("folders/gltf"), tw.corner_tiles(2), tile_size=16, normal="gl")
    assert all(not level.any() for level in layer_mipmaps(material, "metalness").levels)
    rough = layer_mipmaps(material, "roughness").levels
    assert (rough[0] == 51).all()
    assert rough[-1].min() > 51  # what the normals lose


@pytest.mark.parametrize(
    ("name", "most"), [("true", 0), ("profile", 0), ("blue_0", 3), ("blue_255", 3), ("green_alpha", 3)]
)
def test_normals_without_blue(case, name, most):
    maps = {"albedo": case("normals/albedo.png"), "normal": case(f"normals/{name}_normal.png")}
    found = tw.open_exemplar(maps, normal="gl").sources[0]["normal"]
    true = tw.read_image(case("normals/true_normal.png"))
    vectors, wanted = (pixels / 127.5 - 1 for pixels in (found, true))
    lengths = np.linalg.norm(vectors, axis=2) * np.linalg.norm(wanted, axis=2)
    angles = np.degrees(np.arccos(np.clip((vectors * wanted).sum(axis=2) / lengths, -1, 1)))
    assert angles.mean() <= most or np.array_equal(found, true)
    assert most or np.array_equal(found, true)


@pytest.mark.parametrize("name", ["half_erased", "turned_in_paint_program", "hole_color_kept"])
def test_places_that_are_not_there_are_not_copied(case, name):
    with pytest.warns(tw.TilewrightWarning, match="of the photograph is transparent and not copied"):
        material = tw.texture_tiles(case(f"transparent/{name}.png"), tile_size=16)
    assert material.pixels[..., 3].min() == 255


def test_alpha_that_is_part_of_the_pattern_is_kept(case):
    found, notes = opened(case("transparent/fence.png"))
    assert found.masks[0].all()
    assert not notes


def test_a_drawing_on_nothing(case, tmp_path):
    picture = case("drawings/black_disc_on_nothing.png")
    cells = tmp_path / "d.npy"
    call("dapple", "--input", picture, "-o", cells, "--width", 24, "--height", 24,
         "--limit", "H0=24", "--limit", "V0=24")  # fmt: skip
    assert 0.28 <= (np.load(cells) == 0).mean() <= 0.33


def test_a_mask_whose_shape_lies_in_alpha(case):
    found = tw.open_exemplar(case("drawings/red_and_blue.png"), mask=case("drawings/mask_in_alpha.png"))
    red, _, blue = found.sources[0]["albedo"][found.masks[0]].mean(axis=0)
    assert red > 190
    assert blue < 50


@pytest.mark.parametrize("second", ["gray.jpg", "color.gif"])
def test_two_photographs_in_other_formats(case, second):
    found = tw.open_exemplar(case("two_sources/color.png"), second=case(f"two_sources/{second}"))
    assert [source["albedo"].shape[2] for source in found.sources] == [3, 3]


def test_long_names_of_colors(case, tmp_path):
    with pytest.warns(tw.TilewrightWarning, match="colors 1 to 210303 are called 0 to 2"):
        call("aperiodic", case("labels/long_labels.csv"), "-o", tmp_path / "l.npy",
             "--width", 6, "--height", 4)  # fmt: skip
    cells = np.load(tmp_path / "l.npy")
    assert cells.shape == (4, 6)
    assert (cells[:, 1:] != cells[:, :-1]).all() or (cells[1:] != cells[:-1]).all()


def test_a_turned_photograph_is_printed_upright(case):
    import base64
    import io

    from PIL import Image

    drawing = ElementTree.fromstring(
        tw.draw_jigsaw(packing(tw.corner_tiles(2)), picture=case("puzzle/portrait.jpg"))
    )
    (image,) = drawing.iter("{http://www.w3.org/2000/svg}image")
    stored = Image.open(io.BytesIO(base64.b64decode(image.get("href").partition(",")[2])))
    assert stored.getexif().get(0x0112, 1) == 1
    pixels = np.asarray(stored.convert("RGB")).astype(int)
    above, below = pixels[: len(pixels) // 3].mean(axis=(0, 1)), pixels[-len(pixels) // 3 :].mean(axis=(0, 1))
    assert above[0] > above[2] + 50
    assert below[2] > below[0] + 50


def test_photographs_of_other_things_are_no_material(case):
    folder = case("README.md").parents[1] / "data" / "textures"
    if not folder.is_dir():
        pytest.skip("the photographs are not at hand")
    with pytest.raises(tw.TilewrightError, match=r"4 maps \(leaves_albedo\.png.* among 9 pictures"):
        tw.open_exemplar(folder)
    assert list(tw.find_maps(folder / "leaves")) == ["albedo", "normal", "roughness", "height"]


def test_the_command_tells_the_maps(case, tmp_path, capsys):
    call("texture", case("folders/map_suffix"), "-o", tmp_path / "out", "--tile-size", 16,
         "--tiles", "corner", "--normal", "gl", "--json")  # fmt: skip
    assert json.loads(capsys.readouterr().out)["maps"] == ["albedo", "normal", "roughness", "ao"]


@pytest.mark.parametrize("target", ["godot", "unity", "unreal", "blender", "threejs"])
def test_exports_of_a_fence_show_its_holes(case, tmp_path, target):
    material = tw.texture_tiles(case("transparent/fence.png"), tw.corner_tiles(2), tile_size=32)
    assert 0.3 < (material.pixels[..., 3] == 0).mean() < 0.6
    tw.save_for_engine(material, tmp_path / "out", target)
    assert "is below 0.5, which the material shows" in (tmp_path / "out" / "README.md").read_text()
