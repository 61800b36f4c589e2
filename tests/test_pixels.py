"""What channels, numbers and names of pictures mean."""

import re
from pathlib import Path

import numpy as np
import pytest

from tilewright.errors import TilewrightError
from tilewright.files.map_stack import recognize_map
from tilewright.pixels import (
    LUMA,
    LUMINANCE,
    MAP_WORDS,
    as_pixels,
    as_rgb,
    as_rgba,
    as_texels,
    has_alpha,
    mean_gray,
    read_hex,
    white,
    without_alpha,
)
from tilewright.signals.textures.kinds import KINDS, guess_kind


def picture(channels, kind=np.uint8):
    return np.random.default_rng(channels).integers(0, 250, (5, 4, channels)).astype(kind)


@pytest.mark.parametrize(("channels", "colors"), [(1, 1), (2, 1), (3, 3), (4, 3)])
def test_alpha_is_the_last_of_two_or_four_channels(channels, colors):
    pixels = picture(channels)
    assert np.array_equal(without_alpha(pixels), pixels[..., :colors])
    assert np.shares_memory(without_alpha(pixels), pixels)
    assert has_alpha(channels) == (colors < channels)
    assert np.allclose(mean_gray(pixels), pixels[..., :colors].astype(float).mean(axis=2))


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
def test_more_channels_repeat_gray_and_keep_alpha(kind):
    for channels in (1, 2, 3, 4):
        pixels = picture(channels, kind)
        wide = as_rgba(pixels)
        assert wide.dtype == kind
        for c in range(3):
            assert np.array_equal(wide[..., c], pixels[..., min(c, 0 if channels < 3 else 2)])
        full = np.iinfo(kind).max if kind is not np.float32 else 1
        assert np.array_equal(wide[..., 3], pixels[..., -1] if has_alpha(channels) else np.full((5, 4), full))
        assert np.array_equal(as_rgb(pixels), wide[..., :3])


def test_white_is_what_stands_for_one():
    kinds = (np.uint8, np.uint16, np.float32, np.float16, bool, np.int16)
    assert [white(np.dtype(kind)) for kind in kinds] == [255, 65535, 1, 1, 1, 32767]


@pytest.mark.parametrize("weights", [LUMA, LUMINANCE])
def test_white_has_luminance_one(weights):
    assert sum(weights) == pytest.approx(1, abs=1e-12)


def test_colors_are_read_from_hexadecimal_digits():
    assert read_hex("#27548f") == (0x27, 0x54, 0x8F)
    for bad in ("27548f", "#27548", "#27548g", "red", "#27548f0"):
        with pytest.raises(TilewrightError, match=f"a color is '{bad}'"):
            read_hex(bad)
    with pytest.raises(TilewrightError, match="must be a str"):
        read_hex(0x27548F)


def test_every_reader_agrees_on_what_a_map_is():
    for map, (kind, endings, words, slot) in MAP_WORDS.items():
        assert kind in KINDS
        for ending in endings:
            assert recognize_map(f"Moss_2K_{ending}") == map, ending
            assert guess_kind(ending) == kind or ending in NOT_BY_WORD, ending
        for word in words:
            assert guess_kind(f"moss_{word}") == kind, word
        assert not slot or any(re.search(slot, ending) for ending in endings)


NOT_BY_WORD = {"normal_dx", "nor_dx", "normal_directx", "spec"}
"""Endings of files that the last word of a name alone does not tell; `tell_green` looks for DirectX."""


def test_the_weights_of_light_stand_in_one_place():
    from tilewright import pixels

    source = Path(pixels.__file__)
    weights = re.compile(r"0?\.(299|587|114|2126|7152|0722)\b")
    found = [p.name for p in source.parent.rglob("*.py") if weights.search(p.read_text())]
    assert found == ["pixels.py"]


COUNTING = np.arange(12).reshape(3, 4)


@pytest.mark.parametrize(
    ("given", "kind", "wanted"),
    [
        (COUNTING > 5, np.uint8, (COUNTING > 5) * 255),
        (COUNTING.astype(np.int64) * 23, np.uint8, COUNTING * 23),
        (COUNTING.astype(np.int64) * 24, np.uint16, COUNTING * 24),
        (COUNTING.astype(np.int16), np.uint8, COUNTING),
        (COUNTING.astype(np.uint64) * 5957, np.uint16, COUNTING * 5957),
        (COUNTING / 8, np.float32, COUNTING / 8),
        (COUNTING.astype(np.float16) / 8, np.float32, COUNTING / 8),
        (COUNTING.astype(np.uint16), np.uint16, COUNTING),
    ],
)
def test_other_types_become_those_of_pictures(given, kind, wanted):
    texels = as_texels("photo", given)
    assert texels.dtype == kind
    assert np.array_equal(texels, wanted)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            COUNTING - 1,
            "photo has type int64 and holds -1 to 10; allowed are integers from 0 to 65535",
        ),
        (COUNTING * 6000, "holds 0 to 66000"),
        (COUNTING * 1j, "photo has type complex128; allowed are uint8, uint16, float32, and"),
        (COUNTING.astype(str), "has type <U"),
    ],
)
def test_numbers_that_no_picture_holds_are_refused(given, message):
    with pytest.raises(TilewrightError, match=re.escape(message)) as error:
        as_texels("photo", given)
    assert "\n" not in str(error.value)


class Offering:
    """An array of another library, which offers its numbers by one protocol."""

    def __init__(self, protocol, numbers):
        offers = {
            "__array__": lambda self, dtype=None, copy=None: numbers,
            "__array_interface__": property(lambda self: numbers.__array_interface__),
            "__dlpack__": lambda self, **rest: numbers.__dlpack__(**rest),
        }
        names = (protocol, "__dlpack_device__") if protocol == "__dlpack__" else (protocol,)
        offers["__dlpack_device__"] = lambda self: numbers.__dlpack_device__()
        self.__class__ = type("Tensor", (Offering,), {name: offers[name] for name in names})


@pytest.mark.parametrize("protocol", ["__array__", "__array_interface__", "__dlpack__"])
def test_arrays_of_other_libraries_are_taken(protocol):
    numbers = COUNTING.astype(np.uint8)
    pixels = as_pixels("photo", Offering(protocol, numbers))
    assert isinstance(pixels, np.ndarray)
    assert np.array_equal(pixels, numbers)


def test_arrays_that_are_not_at_hand_are_refused():
    class Tensor:
        def __array__(self, dtype=None, copy=None):
            raise TypeError("can't convert cuda:0 device type tensor to numpy.")

    with pytest.raises(TilewrightError, match=r"photo is a Tensor whose .*\.cpu\(\)\.numpy\(\)") as error:
        as_pixels("photo", Tensor())
    assert "cuda" not in str(error.value)
