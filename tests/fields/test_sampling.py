"""What is seen at scattered places of a plane, between pixels and from afar."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.signals.textures.kinds import from_values, to_values


@pytest.fixture(scope="module")
def material(gravel):
    rng = np.random.default_rng(3)
    photo = {
        "albedo": rng.integers(0, 256, (96, 96, 3), np.uint8),
        "height": rng.integers(0, 65536, (96, 96, 1)).astype(np.uint16),
        "roughness": rng.random((96, 96, 1)).astype(np.float32),
    }
    return tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16, seed=1)


@pytest.fixture(scope="module")
def field(material):
    return tw.TextureField(material, tw.direct(material.tiles, 7))


def test_indexing_is_a_window(field):
    assert np.array_equal(field[-5:20, 100:140], field.render(100, -5, 40, 25))
    assert np.array_equal(field[3, 7], field.render(7, 3, 1, 1)[0, 0])
    assert np.array_equal(field[3, 0:10:2], field.render(0, 3, 10, 1)[0, ::2])
    far = 2**60
    assert np.array_equal(field[far : far + 3, -far : 2 - far], field.render(-far, far, 2, 3))
    ends = tw.TextureField(field.material, tw.array_tiling(field.material.tiles, [[0]], torus=False))
    assert np.array_equal(ends[:, :], ends.render(0, 0, 16, 16))


@pytest.mark.parametrize(
    ("key", "message"),
    [
        (5, "is indexed by y and x"),
        ((slice(None), slice(0, 5)), "give both ends"),
        ((slice(5, 5), 0), "holds no pixel"),
        ((0.5, 1), "y must be an integer"),
        ((slice(0, "a"), 1), "y must be an integer"),
    ],
)
def test_what_is_no_window(field, key, message):
    with pytest.raises(tw.TilewrightError, match=message):
        field[key]
    with pytest.raises(TypeError):
        iter(field)


@pytest.mark.parametrize("map", ["albedo", "height", "roughness"])
def test_centers_are_pixels(field, map):
    y, x = np.indices((40, 50))
    found = field.at(np.stack([x - 20, y + 30], axis=-1) + 0.5, map=map)
    wanted = field.render(-20, 30, 50, 40, map=map)
    if map == "roughness":
        assert np.allclose(found, wanted, atol=1e-6)  # its fourth power is averaged
    else:
        assert np.array_equal(found, wanted)
    assert found.dtype == wanted.dtype


def naive(field, place, map, step):
    """One place, by the book: mean of squares, then between four of them."""
    kind = field.maps[map].kind
    u, v = np.asarray(place) / step - 0.5
    k, m = int(np.floor(u)), int(np.floor(v))
    pixels = field.render(k * step, m * step, 2 * step, 2 * step, map=map)
    values = to_values(pixels, kind).reshape(2, step, 2, step, -1).mean(axis=(1, 3))
    a, b = u - k, v - m
    north, south = (row[0] * (1 - a) + row[1] * a for row in values)
    return from_values((north * (1 - b) + south * b)[None, None].astype(np.float32), kind, pixels)[0, 0]


@pytest.mark.parametrize("map", ["albedo", "height", "roughness"])
@pytest.mark.parametrize(("footprint", "step"), [(0, 1), (1, 1), (2.5, 2), (8, 8), (100, 128)])
def test_places_between_pixels_and_from_afar(field, map, footprint, step):
    places = np.random.default_rng(1).uniform(-300, 300, (30, 2))
    found = field.at(places, map=map, footprint=footprint)
    wanted = np.array([naive(field, place, map, step) for place in places])
    assert np.abs(found.astype(float) - wanted).max() <= (1e-5 if map == "roughness" else 1)


def test_light_is_averaged_and_not_its_code():
    photo = np.zeros((64, 64, 1), np.uint8)
    photo[:, ::2] = 255
    plane = tw.RepeatField(photo)
    assert abs(int(plane.at([[32.0, 32.0]], footprint=16)[0, 0]) - 188) <= 1


def test_far_out_places_are_those_near_the_origin(field):
    places = np.random.default_rng(2).uniform(0, 50, (20, 2))
    origin = (2**60 + 5, -(2**59) - 3)
    for footprint in (1, 4):
        found = field.at(places, origin=origin, footprint=footprint)
        again = field.at(places - (11, 7), origin=(origin[0] + 11, origin[1] + 7), footprint=footprint)
        assert np.array_equal(found, again)
    center = field.at([[0.5, 0.5]], origin=origin)[0]
    assert np.array_equal(center, field.render(*origin, 1, 1)[0, 0])


def test_shapes_and_nothing(field):
    assert field.at(np.zeros((2, 3, 2))).shape == (2, 3, 3)
    assert field.at([0.5, 0.5]).shape == (3,)
    assert field.at(np.zeros((0, 2))).shape == (0, 3)
    assert field.at(np.zeros((0, 2)), map="height").dtype == np.uint16


def test_planes_that_end(material):
    ends = tw.TextureField(material, tw.array_tiling(material.tiles, [[0]], torus=False))
    assert np.array_equal(ends.at([[0.0, 0.0], [16.0, 16.0]]), ends.render(0, 0, 16, 16)[[0, 15], [0, 15]])
    for points, footprint, message in (
        ([[16.1, 3]], 1, "lie outside the plane, which goes from 0 to 16 along x"),
        ([[3, 3]], 40, "footprint is about 32 pixels"),
        ([[np.nan, 3]], 1, "must be finite"),
        ([[1, 2, 3]], 1, r"expected \(..., 2\)"),
        ([["a", "b"]], 1, "must be numbers"),
        ([[3, 3]], 2000, "footprint is 2000"),
    ):
        with pytest.raises(tw.TilewrightError, match=message):
            ends.at(points, footprint=footprint)
    with pytest.raises(tw.TilewrightError, match="origin must be two whole numbers"):
        ends.at([[0, 0]], origin=5)


def test_pictures_at_another_scale(field, tmp_path):
    half = field.render(-8, 4, 64, 48, scale=0.5)
    assert half.shape == (24, 32, 3)
    values = to_values(field.render(-8, 4, 64, 48), "color").reshape(24, 2, 32, 2, 3).mean(axis=(1, 3))
    assert np.abs(half.astype(int) - from_values(values, "color", half)).max() <= 1
    large = field.render(-8, 4, 20, 10, scale=3)
    assert large.shape == (30, 60, 3)
    assert np.array_equal(large[1::3, 1::3], field.render(-8, 4, 20, 10))
    field.save(tmp_path / "a.png", -8, 4, 64, 48, scale=0.5)
    assert np.array_equal(tw.read_image(tmp_path / "a.png"), half)
    out = np.empty((24, 32, 3), np.uint8)
    assert field.render(-8, 4, 64, 48, scale=0.5, out=out) is out
    with pytest.raises(tw.TilewrightError, match="scale is 0"):
        field.render(scale=0)


def test_other_planes_have_it_too(gravel):
    wall = tw.BrickField(tw.BondBricks("herringbone", (24, 8)))
    assert np.array_equal(wall.at([[5.5, 9.5]])[0], wall[9, 5])
    noise = tw.NoiseField(gravel[:64, :64])
    assert np.array_equal(noise[0:4, 0:4], noise.render(0, 0, 4, 4))
