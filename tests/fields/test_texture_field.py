"""Any window of a texture field equals the same pixels of any other."""

import numpy as np
import pytest

import tilewright as tw
from cores import cores
from handmade import handmade
from tilewright.errors import Cancelled, TilewrightError


def slow_render(field, x, y, width, height, name):
    tiles = field.material.maps[name]
    n = field.material.tile_size
    out = np.empty((height, width, tiles.shape[3]), tiles.dtype)
    for i in range(height):
        for j in range(width):
            t = field.tiling.indices((x + j) // n, (y + i) // n, 1, 1)[0, 0]
            out[i, j] = tiles[t, (y + i) % n, (x + j) % n]
    return out


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_render_copies_the_right_pixels(kind, channels):
    material = handmade(tw.corner_tiles(2), 16, kind, channels, maps=2)
    field = tw.TextureField(material, tw.direct(material.tiles, 5))
    for x, y in ((-37, -5), (3, 250), (-(10**18), 10**18 + 7)):
        assert np.array_equal(
            field.render(x, y, 21, 18, map="map1"), slow_render(field, x, y, 21, 18, "map1")
        )


@pytest.mark.parametrize("tiles", [tw.corner_tiles(3), tw.wang_tiles(2), tw.corner_coded_tiles()], ids=repr)
def test_windows_agree(tiles):
    material = handmade(tiles, 32)
    field = tw.TextureField(material, tw.direct(tiles, 7))
    whole = field.render(-300, -200, 500, 400)
    assert np.array_equal(whole[150:250, 37:301], field.render(-263, -50, 264, 100))
    out = np.empty((100, 264, 3), np.uint8)
    assert field.render(-263, -50, 264, 100, out=out) is out
    assert np.array_equal(out, whole[150:250, 37:301])


def test_threads_do_not_matter():
    material = handmade(tw.corner_tiles(2), 32)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    here = field.render(5, 5, 300, 300)
    for count in (1, 3):
        with cores(count):
            assert np.array_equal(here, field.render(5, 5, 300, 300))


@pytest.mark.parametrize(("kind", "suffix"), [(np.uint8, ".png"), (np.uint16, ".tif"), (np.float32, ".exr")])
def test_saved_files_hold_what_is_rendered(tmp_path, kind, suffix):
    material = handmade(tw.corner_tiles(2), 32, kind)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    steps = []
    path = tmp_path / f"a{suffix}"
    field.save(path, -100, 30, 301, 600, progress=lambda *step: steps.append(step[:2]))
    assert np.array_equal(tw.read_image(path), field.render(-100, 30, 301, 600))
    assert steps == [(0, 600), (256, 600), (512, 600), (600, 600)]


def test_a_cancelled_save_leaves_nothing(tmp_path):
    material = handmade(tw.corner_tiles(2), 32)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))

    def stop(done, total, what):
        if done:
            raise Cancelled("enough")

    for name in ("a.png", "a.tif"):
        with pytest.raises(Cancelled):
            field.save(tmp_path / name, width=300, height=600, progress=stop)
    assert not any(tmp_path.iterdir())


def test_bad_fields_and_windows_get_one_clear_line(tmp_path):
    material = handmade(tw.corner_tiles(2), 16)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    cases = {
        "must be the same set": lambda: tw.TextureField(material, tw.direct(tw.wang_tiles(2))),
        "width is 0": lambda: field.render(0, 0, 0, 5),
        "height is -3": lambda: field.render(0, 0, 5, -3),
        "width must be an integer": lambda: field.render(0, 0, 5.5, 5),
        "map is 'normal'; allowed are map0": lambda: field.render(0, 0, 5, 5, map="normal"),
        "x is 99999999999999999999": lambda: field.render(99999999999999999999, 0, 5, 5),
        "out is uint8": lambda: field.render(0, 0, 5, 5, out=np.empty((5, 4, 3), np.uint8)),
        "allowed are .png, .tif": lambda: field.save(tmp_path / "a.gif", 0, 0, 5, 5),
    }
    for message, make in cases.items():
        with pytest.raises(TilewrightError) as error:
            make()
        assert message in str(error.value)
        assert "\n" not in str(error.value)
