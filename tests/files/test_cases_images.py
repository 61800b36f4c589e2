"""Photographs as cameras, telephones and paint programs write them, with the values that are right.

The files and the values lie beside the checkout; where they are not at hand, `test_what_files_state.py` holds
the same rules by files that it makes.
"""

import warnings
from pathlib import Path

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightError, TilewrightWarning

CASES = Path(__file__).parents[3] / "shared" / "cases"

PLAIN = ((199.4, 89.5, 39.6), (59.8, 159.8, 69.7), (39.7, 69.6, 189.6))
P3 = ((215.1, 80.4, 14.1), (0.3, 162.7, 54.7), (28.0, 70.6, 196.8))
WIDE = ((227.7, 89.0, 29.7), (0.0, 161.1, 59.5), (9.7, 67.8, 194.5))
LINEAR = ((228.8, 159.6, 108.6), (132.4, 207.3, 142.2), (108.7, 142.1, 223.7))
GRAY = ((116.7,), (119.7,), (74.4,))

PHOTOGRAPHS = {
    "color/plain.png": (PLAIN, 2, ""),
    "color/profile_srgb.png": (PLAIN, 2, ""),
    "color/gama_45455.png": (PLAIN, 2, ""),
    "color/profile_p3.jpg": (P3, 2, "Display P3"),
    "color/profile_p3.webp": (P3, 2, "Display P3"),
    "color/profile_wide_gamma22.png": (WIDE, 2, "RGB gamma 2.2 wide"),
    "color/profile_linear.png": (LINEAR, 2, "linear sRGB primaries"),
    "color/gama_1.png": (LINEAR, 2, "gAMA"),
    "color/lab.tif": (PLAIN, 2, r"L\*a\*b\*"),
    "phone/gain_map.jpg": (PLAIN, 2, "gain map"),
    "phone/photo.avif": (PLAIN, 3, ""),
    "phone/stray_bytes_in_header.jpg": (PLAIN, 3, "stray bytes"),
    "bmp/rgb_32bit_fourth_byte_zero.bmp": (PLAIN, 2, ""),
    "bmp/masks_rgba_v5.bmp": (PLAIN, 2, ""),
    "bmp/masks_xbgr.bmp": (PLAIN, 2, ""),
    "bmp/rle8_gray.bmp": (GRAY, 2, ""),
    "transparent/no_attribute_bits.tga": (PLAIN, 2, ""),
    "channels/gray.dds": (GRAY, 2, ""),
}


def case(name):
    """A file by its name, or the test is skipped."""
    path = CASES / name
    if not path.exists():
        pytest.skip(f"{name} is not at hand")
    return path


def read(path, note, **options):
    """The pixels of a file that brings this note, or none."""
    with warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        pixels = tw.read_image(path, **options)
    assert len(notes) == bool(note)
    if note:
        with pytest.warns(TilewrightWarning, match=note):
            tw.read_image(path, **options)
    return pixels


def regions(pixels):
    """Means of the three regions."""
    parts = (pixels[:36, :68], pixels[44:, :68], pixels[:, 76:])
    return np.array([part.reshape(-1, pixels.shape[2]).mean(axis=0) for part in parts])


@pytest.mark.parametrize("name", PHOTOGRAPHS)
def test_photographs_have_the_colors_they_state(name):
    right, tolerance, note = PHOTOGRAPHS[name]
    pixels = read(case(name), note)
    assert pixels.dtype == np.uint8
    channels = len(right[0])
    assert pixels.shape[:2] == (80, 96)
    assert pixels.shape[2] in (channels, channels + 1)
    assert (pixels[..., channels:] == 255).all()
    assert np.abs(regions(pixels[..., :channels]) - right).max() <= tolerance


@pytest.mark.parametrize("name", ["profile_srgb.png", "gama_45455.png"])
def test_files_that_state_srgb_stay_byte_for_byte(name):
    assert np.array_equal(read(case(f"color/{name}"), ""), read(case("color/plain.png"), ""))


def test_a_map_without_color_stays_whatever_its_profile():
    profiled, plain = case("normals/profile_normal.png"), case("normals/true_normal.png")
    normals = read(plain, "")
    assert np.array_equal(read(profiled, "", color=False), normals)
    assert not np.array_equal(read(profiled, "Display P3"), normals)
    exemplar = tw.open_exemplar({"normal": profiled}, normal="gl")
    assert np.array_equal(exemplar.sources[0]["normal"], normals)


def test_a_turned_photograph_with_a_gain_map_comes_upright():
    turned = read(case("phone/gain_map_turned.jpg"), "gain map")
    plain = read(case("phone/gain_map.jpg"), "gain map")
    assert turned.dtype == np.uint8
    assert np.array_equal(turned, np.rot90(plain, -1))


def test_a_photograph_of_a_telephone_goes_with_a_plain_one():
    with pytest.warns(TilewrightWarning, match="gain map"):
        exemplar = tw.open_exemplar(case("phone/gain_map.jpg"), second=case("color/plain.png"))
    assert [source["albedo"].dtype for source in exemplar.sources] == [np.uint8, np.uint8]


def test_a_jpeg_that_is_cut_off_is_refused(tmp_path):
    for name in ("phone/stray_bytes_in_header.jpg", "phone/gain_map.jpg", "color/profile_p3.jpg"):
        data = case(name).read_bytes()
        if "gain" in name:  # the gain map lies behind the picture
            data = data[: data.rindex(b"\xff\xd8\xff")]
        (tmp_path / "cut.jpg").write_bytes(data[: len(data) * 2 // 3])
        with pytest.raises(TilewrightError, match="truncated or damaged") as error:
            tw.read_image(tmp_path / "cut.jpg")
        assert "\n" not in str(error.value)


@pytest.mark.parametrize("name", ["photo.dng", "mosaic.dng"])
def test_raw_files_of_cameras_are_refused(name, tmp_path):
    (tmp_path / "a.tif").write_bytes(case(f"raw/{name}").read_bytes())
    for path in (case(f"raw/{name}"), tmp_path / "a.tif"):
        with pytest.raises(TilewrightError, match=r"a camera's raw file.*; develop it"):
            tw.read_image(path)


HALVES = ["half_red.exr", "half_red.tif", "half_red_16bit.tif", "half_red_straight.png"]


@pytest.mark.parametrize("name", HALVES)
def test_alpha_that_is_multiplied_in_comes_straight(name):
    pixels = read(case(f"premultiplied/{name}"), "")
    most = 1 if pixels.dtype == np.float32 else np.iinfo(pixels.dtype).max
    half = np.abs(pixels[..., 3] / most - 0.5) < 0.01
    assert 0.3 < half.mean() < 0.7
    for part in (pixels[half], pixels[~half]):
        assert np.abs(part[:, :3].mean(axis=0) / most - (0.8, 0.2, 0.1)).max() < 0.005


def test_alpha_is_written_as_each_format_says(tmp_path):
    import OpenImageIO as oiio
    import tifffile

    material = tw.texture_tiles(case("premultiplied/half_red.exr"), tile_size=16)
    field = tw.TextureField(material, tw.direct(material.tiles))
    for suffix, light in ((".tif", (0.8, 0.2, 0.1)), (".exr", (0.4, 0.1, 0.05))):
        path = tmp_path / f"a{suffix}"
        field.save(path, width=64, height=64)
        stored = oiio.ImageInput.open(str(path), straight()).read_image("float")
        half = stored[..., 3] == 0.5
        assert np.abs(stored[half][:, :3].mean(axis=0) - light).max() < 0.01
        assert np.abs(stored[~half][:, :3].mean(axis=0) - (0.8, 0.2, 0.1)).max() < 0.01
        assert np.allclose(tw.read_image(path), field.render(width=64, height=64), rtol=1e-6)
    with tifffile.TiffFile(tmp_path / "a.tif") as file:
        assert file.pages[0].extrasamples == (2,)
    tw.save(material, tmp_path / "set")
    again = tw.load(tmp_path / "set")
    assert np.array_equal(again.pixels, material.pixels)


def straight():
    """What makes OpenImageIO give the numbers of a file as they are."""
    import OpenImageIO as oiio

    config = oiio.ImageSpec()
    config.attribute("oiio:UnassociatedAlpha", 1)
    return config


def test_depth_is_no_alpha():
    pixels = read(case("channels/color_and_depth.exr"), "in channel Z")
    assert pixels.shape == (80, 96, 3)
    assert pixels.max() <= 1
