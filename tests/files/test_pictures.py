"""Pictures as people bring them: paths of any kind, Pillow images, arrays."""

import os
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

import tilewright as tw
from tilewright.errors import TilewrightError
from tilewright.files.images import open_picture
from tilewright.pixels import as_pixels, is_pillow

PHOTO = np.random.default_rng(5).integers(0, 256, (48, 40, 3), np.uint8)


class Name(os.PathLike):
    """A path that is neither a str nor a Path."""

    def __init__(self, path):
        self.path = path

    def __fspath__(self):
        return str(self.path)


def palette_with_hole():
    image = Image.fromarray(PHOTO).convert("P")
    image.info["transparency"] = 7
    return image


IMAGES = {
    "1": lambda: Image.fromarray(PHOTO[..., 0]).convert("1"),
    "L": lambda: Image.fromarray(PHOTO[..., 0]),
    "LA": lambda: Image.fromarray(PHOTO).convert("LA"),
    "P": lambda: Image.fromarray(PHOTO).convert("P"),
    "P with transparency": palette_with_hole,
    "RGB": lambda: Image.fromarray(PHOTO),
    "RGBA": lambda: Image.fromarray(PHOTO).convert("RGBA"),
    "I;16": lambda: Image.fromarray(PHOTO[..., 0].astype(np.uint16) * 257),
}


@pytest.mark.parametrize("mode", IMAGES)
def test_a_pillow_image_is_what_its_file_is(mode, tmp_path):
    image = IMAGES[mode]()
    image.save(tmp_path / "a.png")
    wanted = tw.read_image(tmp_path / "a.png")
    for given in (image, Image.open(tmp_path / "a.png"), Name(tmp_path / "a.png"), str(tmp_path / "a.png")):
        pixels = open_picture("photo", given)
        assert pixels.dtype == wanted.dtype
        assert np.array_equal(pixels, wanted)


def test_floats_stay_floats():
    pixels = as_pixels("photo", Image.fromarray(PHOTO[..., 0].astype(np.float32) / 7))
    assert pixels.dtype == np.float32
    assert np.array_equal(pixels[..., 0], PHOTO[..., 0].astype(np.float32) / 7)


@pytest.mark.parametrize("orientation", range(1, 9))
def test_a_turned_photograph_comes_upright(orientation, tmp_path):
    image = Image.fromarray(PHOTO.repeat(4, axis=0).repeat(4, axis=1))
    exif = image.getexif()
    exif[0x0112] = orientation
    image.save(tmp_path / "a.jpg", quality=95, exif=exif)
    with Image.open(tmp_path / "a.jpg") as opened:
        pixels = open_picture("photo", opened)
    wanted = tw.read_image(tmp_path / "a.jpg")
    assert pixels.shape == wanted.shape
    assert np.abs(pixels.astype(int) - wanted).max() <= 3


def test_photos_are_taken_in_every_form(tmp_path):
    Image.fromarray(PHOTO).save(tmp_path / "a.png")
    forms = (PHOTO, Image.fromarray(PHOTO), Name(tmp_path / "a.png"), tmp_path / "a.png")
    sources = [tw.open_exemplar(form).sources[0]["albedo"] for form in forms]
    sources += [tw.Exemplar([{"albedo": Image.fromarray(PHOTO)}]).sources[0]["albedo"]]
    sources += [field(form).photo for form in forms for field in (tw.RepeatField, tw.HexField)]
    assert all(np.array_equal(source, PHOTO) for source in sources)
    mask = PHOTO[..., 0] >= 128
    Image.fromarray(mask).save(tmp_path / "mask.png")
    for form in (mask, Image.fromarray(mask), Name(tmp_path / "mask.png")):
        assert np.array_equal(tw.open_exemplar(PHOTO, mask=form).masks[0], mask)


def test_gray_pictures_steer_in_every_form():
    image = Image.fromarray(PHOTO)
    tiles = tw.corner_tiles(2)
    assert np.array_equal(tw.start_from_image(image, 9, 7), tw.start_from_image(PHOTO, 9, 7))
    here, there = (tw.density_tiling(tiles, p).indices(0, 0, 9, 9) for p in (image, PHOTO))
    assert np.array_equal(here, there)


def test_what_is_no_picture_gets_one_clear_line(tmp_path):
    cases = {
        "photo must be a path, an array or a Pillow image, not list": lambda: tw.open_exemplar([[0]]),
        "mask must be a path, an array or a Pillow image": lambda: tw.open_exemplar(PHOTO, mask=3),
        "density must be an array or a Pillow image, not a path; open it": lambda: tw.density_tiling(
            tw.corner_tiles(2), "map.png"
        ),
        "pixels must be an array or a Pillow image, not a path": lambda: tw.start_from_image(
            tmp_path / "a.png", 5, 5
        ),
        "beyond 16 bits": lambda: as_pixels("photo", Image.fromarray(np.full((4, 4), 70000, np.int32))),
    }
    for message, make in cases.items():
        with pytest.raises(TilewrightError, match=message) as error:
            make()
        assert "\n" not in str(error.value)


def test_pillow_is_told_without_being_loaded():
    code = (
        "import sys; from tilewright.pixels import is_pillow; import numpy; "
        "assert not is_pillow(numpy.zeros(3)); import tilewright.jobs.materials"
        "; assert 'PIL' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
    assert is_pillow(Image.new("L", (2, 2)))
