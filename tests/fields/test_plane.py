"""What all fields of pixels promise: one face, one pixel at one place, whoever asks for it."""

import pickle

import numpy as np
import pytest

import tilewright as tw
from handmade import handmade
from tilewright.errors import TilewrightError
from tilewright.fields.plane import PixelField
from walls import WALLS


def photo(channels=3):
    return np.random.default_rng(1).integers(0, 256, (40, 56, channels), np.uint8)


def laid(tiling=tw.direct, **options):
    material = handmade(tw.corner_tiles(2), 16, np.uint16, 2, maps=2)
    return tw.TextureField(material, tiling(material.tiles, **options))


def rectangle(tiles):
    return tw.array_tiling(tiles, tw.direct(tiles, seed=4).indices(0, 0, 9, 7))


FIELDS = {
    "texture": laid,
    "texture on a torus": lambda: laid(tw.direct, period=(3, 5)),
    "texture on a rectangle": lambda: laid(rectangle),
    "texture by a picture": lambda: laid(tw.density_tiling, density=[[0.1, 0.9]]),
    "wall": lambda: tw.BrickField(WALLS["wang"](), seed=3),
    "wall with holes": lambda: tw.BrickField(
        tw.brick_region([[1, 1, 1, 1], [1, 0, 0, 1]], positions=3, seed=1), size=(30, 40)
    ),
    "repeat": lambda: tw.RepeatField(photo()),
    "hex": lambda: tw.HexField(photo(1), "height", seed=2),
    "noise": lambda: tw.NoiseField(photo(), seed=2),
}
WINDOW = (7, 5, 61, 43)
"""Which lies in all of them."""


@pytest.fixture(params=FIELDS)
def field(request) -> PixelField:
    return FIELDS[request.param]()


def test_maps_say_what_is_rendered(field):
    assert isinstance(field, PixelField)
    for name, form in field.maps.items():
        pixels = field.render(*WINDOW, map=name)
        assert pixels.shape == (43, 61, form.channels)
        assert pixels.dtype == form.dtype
    assert np.array_equal(field.render(*WINDOW), field.render(*WINDOW, map=field.main))
    assert (field.dtype, field.channels) == field.maps[field.main][:2]


def test_maps_together_are_the_maps_alone(field):
    for name, pixels in field.render_maps(*WINDOW, maps=list(field.maps)).items():
        assert np.array_equal(pixels, field.render(*WINDOW, map=name)), name
    assert set(field.render_maps(*WINDOW)) <= set(field.maps)


def test_out_is_filled(field):
    for name, form in field.maps.items():
        out = np.full((43, 61, form.channels), 77, form.dtype)
        assert field.render(*WINDOW, map=name, out=out) is out
        assert np.array_equal(out, field.render(*WINDOW, map=name))


def test_blocks_are_the_window_in_pieces(field):
    for name in field.maps:
        whole = field.render(*WINDOW, map=name)
        for size in (None, (20, 17)):
            laid_out = np.zeros_like(whole)
            for x, y, pixels in field.blocks(*WINDOW, map=name, size=size):
                height, width = pixels.shape[:2]
                assert size is None or (width <= 20 and height <= 17)
                laid_out[y - 5 : y - 5 + height, x - 7 : x - 7 + width] = pixels
            assert np.array_equal(laid_out, whole), name


def test_blocks_of_a_huge_window_are_small():
    x, y, pixels = next(laid().blocks(-5, 3, 2**31 - 1, 2**31 - 1, map="map1"))
    assert (x, y) == (-5, 3)
    assert pixels.nbytes <= 16 << 20


def test_a_pickled_field_shows_the_same(field):
    again = pickle.loads(pickle.dumps(field))
    for name in field.maps:
        assert np.array_equal(again.render(*WINDOW, map=name), field.render(*WINDOW, map=name))
    assert again.domain == field.domain


def test_files_hold_what_is_rendered(field, tmp_path):
    for name, form in field.maps.items():
        path = tmp_path / f"{name}.png"
        field.save(path, *WINDOW, map=name)
        shown = "id-color" if form.dtype == np.int64 else name
        assert np.array_equal(tw.read_image(path), field.render(*WINDOW, map=shown)), name


def test_the_domain_is_in_pixels(field):
    for axis, (period, bound) in enumerate(zip(field.domain.periods, field.domain.bounds, strict=True)):
        if period is not None and bound is None:
            there = list(WINDOW)
            there[axis] += 3 * period
            assert np.array_equal(field.render(*there), field.render(*WINDOW))
        if bound is not None:
            first, last = [0, 0, 2, 2], [0, 0, 2, 2]
            first[axis], last[axis] = bound[0], bound[1] - 2
            assert field.render(*first).shape[:2] == field.render(*last).shape[:2] == (2, 2)
            last[axis] += 1
            with pytest.raises(TilewrightError, match=f"{'xy'[axis]} is {last[axis]}; allowed are"):
                field.render(*last)


def test_some_domains_repeat_and_some_end():
    assert FIELDS["texture on a torus"]().domain.periods == (48, 80)
    assert FIELDS["texture on a rectangle"]().domain.bounds == ((0, 144), (0, 112))
    assert FIELDS["wall with holes"]().domain.bounds == ((0, 120), (0, 80))
    assert FIELDS["repeat"]().domain.periods == (56, 40)
    assert FIELDS["noise"]().domain.kind == "plane"


def test_bad_windows_get_one_clear_line(field, tmp_path):
    cases = {
        "width is 0": lambda: field.render(0, 0, 0, 5),
        "height must be an integer": lambda: field.blocks(0, 0, 5, 5.5),
        "x must be an integer": lambda: field.render_maps("a", 0, 5, 5),
        "map is 'heat'": lambda: field.save(tmp_path / "a.png", *WINDOW, map="heat"),
        "maps is 'heat'": lambda: field.render_maps(*WINDOW, maps=["heat"]),
        "size must be a width": lambda: field.blocks(*WINDOW, size=5),
        "size is 0": lambda: field.blocks(*WINDOW, size=(4, 0)),
        "out must be an array": lambda: field.render(*WINDOW, out=[1]),
        "expected": lambda: field.render(*WINDOW, out=np.empty((43, 61, 7), np.uint8)),
        "progress must be": lambda: field.save(tmp_path / "a.png", *WINDOW, progress=3),
    }
    for message, make in cases.items():
        with pytest.raises(TilewrightError, match=message) as error:
            make()
        assert "\n" not in str(error.value)
    assert not list(tmp_path.iterdir())


def test_windows_larger_than_memory_name_the_ways_out():
    with pytest.raises(TilewrightError, match=r"does not fit in memory.*blocks\(\).*save\(\)"):
        laid().render(0, 0, 2**31 - 1, 2**31 - 1)
