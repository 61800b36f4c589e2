"""Image files of many kinds hold the pixels that were written into them, or that another decoder finds."""

import io
import warnings
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import odd_images
import tilewright as tw
from tilewright.pixels import as_pixels

EXACT = [
    *odd_images.png_files(),
    *odd_images.pillow_files(),
    *odd_images.bitmap_files(),
    *odd_images.tiff_files(),
    *odd_images.plain_files(),
]
LOSSY = odd_images.lossy_files()
ROUNDED = {"dxt1.dds", "dxt5.dds"}
"""What is between two colors of a block is rounded in one way or the other."""


@pytest.mark.parametrize(("name", "data", "wanted"), EXACT, ids=[name for name, *_ in EXACT])
def test_files_hold_what_was_written(tmp_path, name, data, wanted):
    (tmp_path / name).write_bytes(data)
    pixels = tw.read_image(tmp_path / name)
    assert pixels.dtype == wanted.dtype
    assert pixels.shape == wanted.shape
    assert np.array_equal(pixels, wanted)


@pytest.mark.parametrize("name", LOSSY)
def test_compressed_files_hold_what_another_decoder_finds(tmp_path, name):
    (tmp_path / name).write_bytes(LOSSY[name])
    pixels = tw.read_image(tmp_path / name)
    wanted = as_pixels(name, Image.open(io.BytesIO(LOSSY[name])))
    assert pixels.shape == wanted.shape
    assert np.abs(pixels.astype(int) - wanted).max() <= (name in ROUNDED)


def test_exr_files_hold_what_was_written(tmp_path):
    for name, data, wanted in odd_images.exr_files(tmp_path):
        (tmp_path / name).write_bytes(data)
        assert np.array_equal(tw.read_image(tmp_path / name), wanted), name


def test_pictures_of_packages_are_read_as_pillow_reads_them():
    """Whatever images matplotlib and scikit-image ship, icons and photographs among them."""
    import matplotlib
    import skimage

    folders = [Path(matplotlib.get_data_path()), Path(skimage.__file__).parent / "data"]
    endings = {".png", ".jpg", ".jpeg", ".gif", ".bmp"}
    paths = sorted(p for folder in folders for p in folder.rglob("*") if p.suffix in endings)
    assert len(paths) > 20
    for path in paths:
        with warnings.catch_warnings(), Image.open(path) as image:
            warnings.simplefilter("ignore")  # of profiles and frames, which are looked at elsewhere
            pixels, wanted = tw.read_image(path, color=False), as_pixels(path.name, image)
        if wanted.dtype == np.uint8 and pixels.dtype == np.uint16:  # Pillow leaves the lower byte out
            pixels = (pixels >> 8).astype(np.uint8)
        assert np.array_equal(pixels[..., : wanted.shape[2]], wanted), path.name
        assert (pixels[..., wanted.shape[2] :] == 255).all(), path.name
