"""Fields on a GPU: exact at one texel per pixel, and free of lines when minified."""

from math import tan

import numpy as np
import pytest

import tilewright as tw
from drawing import drawn
from handmade import handmade, of_numbers, under_clouds
from tilewright.errors import TilewrightError
from tilewright.gpu import (
    GpuField,
    GpuPicture,
    OrthographicCamera,
    PerspectiveCamera,
)
from tilewright.gpu.device import open_gpu
from tilewright.shaders.hashing import shader_hash
from tilewright.shaders.layouts import corner_configurations
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.frame import shared_border
from tilewright.signals.textures.kinds import from_values, to_values
from tilewright.tilings.tiling import first_mismatch

# Around the origin, across multiples of 2^31 and 2^32 cells of 16 pixels, and at the end of the plane.
WINDOWS = [
    (0, 0),
    (-53, -1000),
    (2**35 - 50, -(2**35) - 50),
    (2**36 - 77, -(2**36) - 11),
    (10**18, -(10**17)),
    (2**64, -(2**64)),
]
CORNER_SETS = [(tw.corner_tiles(c), layout) for c in (1, 2, 3, 4) for layout in ("array", "atlas")]
CORNER_SETS += [(tw.classed_corner_tiles(c, k), "array") for c, k in ((2, 5), (3, 2))]
WANG_SETS = [(tw.wang_tiles(h, v), "atlas") for h, v in ((2, 2), (3, 3), (2, 3), (4, 2))]


def weis_picture(material, tiling, x, y, width, height):
    """What Wei's method shows: near a tile's corner, the tile of the corner atlas with the same two edges."""
    size, reach = material.tile_size, shared_border(material.tile_size)
    columns, rows = width // size + 2, height // size + 2
    variants = material.variants
    placed = tiling.rows(x // size, y // size, columns, rows, variants=variants)
    slots = tiling.tiles.slots[variants.tiles[placed]]
    place = np.arange(size)
    ends = (place < reach, place >= size - reach)
    cells = np.broadcast_to(placed[..., None, None], (rows, columns, size, size)).copy()
    for across, near_row in zip((0, 2), ends, strict=True):  # N, S
        for along, near_column in zip((3, 1), ends, strict=True):  # W, E
            v, h = slots[..., across], slots[..., along]
            there = near_row[:, None] & near_column
            cells[:, :, there] = variants.starts[tiling.tiles.find(np.stack([v, h, v, h], axis=-1))][
                ..., None
            ]
    pixels = material.pixels[cells, place[:, None], place].swapaxes(1, 2)
    pixels = pixels.reshape(rows * size, columns * size, -1)
    return pixels[y % size : y % size + height, x % size : x % size + width]


@drawn
@pytest.mark.parametrize(
    ("tiles", "layout", "hash"),
    [(*s, "mixer") for s in CORNER_SETS + WANG_SETS]
    + [(*s, "permutation") for s in CORNER_SETS[::2] + WANG_SETS[::2]],
    ids=lambda v: getattr(v, "colors", v),
)
def test_a_texel_per_pixel_is_the_rendered_field(tiles, layout, hash):
    material = handmade(tiles, 16)
    tiling = tw.direct(tiles, 2**40 + 7, hash=hash)
    field = GpuField(material, tiling, layout=layout)
    for x, y in WINDOWS:
        picture = field.render(OrthographicCamera(x, y, 150, 110))
        if tiles.shape.name == "corner":
            wanted = tw.TextureField(material, tiling).render(x, y, 150, 110)
        else:  # handmade tiles are noise, of which Wei's method shows other pixels near corners
            wanted = weis_picture(material, tiling, x, y, 150, 110)
        np.testing.assert_array_equal(picture, wanted, err_msg=f"{x}, {y}")


@drawn
@pytest.mark.parametrize(
    ("tiles", "layout", "count"),
    [(*s, 2 + n % 2) for n, s in enumerate(CORNER_SETS + WANG_SETS)],
    ids=lambda v: getattr(v, "colors", v),
)
def test_variants_are_those_of_the_rendered_field(tiles, layout, count):
    material = handmade(tiles, 16, variants=tw.Variants.uniform(tiles, count))
    tiling = tw.direct(tiles, 2**40 + 7)
    if layout == "array" and len(tiles) * count > open_gpu().most_layers:
        layout = "atlas"
    field = GpuField(material, tiling, layout=layout)
    for x, y in WINDOWS:
        picture = field.render(OrthographicCamera(x, y, 150, 110))
        if tiles.shape.name == "corner":
            wanted = tw.TextureField(material, tiling).render(x, y, 150, 110)
        else:
            wanted = weis_picture(material, tiling, x, y, 150, 110)
        np.testing.assert_array_equal(picture, wanted, err_msg=f"{x}, {y}")


def toned(span, dtype=np.uint8):
    return under_clouds(handmade(tw.classed_corner_tiles(2, 5), 32, dtype), span)


@drawn
@pytest.mark.parametrize(("span", "dtype"), [(1, np.uint8), (3, np.uint8), (2, np.uint16), (1, np.float32)])
def test_tone_is_that_of_the_rendered_field(span, dtype):
    material = toned(span, dtype)
    tiling = tw.direct(material.tiles, 2**40 + 7)
    field, plain = GpuField(material, tiling), tw.TextureField(material, tiling)
    white = 1 if dtype is np.float32 else np.iinfo(dtype).max
    for x, y in WINDOWS:
        picture = field.render(OrthographicCamera(x, y, 150, 110)).astype(float)
        off = np.abs(picture - plain.render(x, y, 150, 110))
        assert off.max() <= 2.5 / 255 * white
        assert off.mean() < 0.4 / 255 * white


@drawn
@pytest.mark.parametrize("kind", ["roughness", "height"])
@pytest.mark.parametrize("dtype", [np.uint8, np.float32])
def test_tone_of_numbers_is_an_offset(kind, dtype):
    material = of_numbers(toned(2, dtype), kind)
    tiling = tw.direct(material.tiles, 5)
    picture = GpuField(material, tiling).render(OrthographicCamera(-70, 40, 150, 110)).astype(float)
    wanted = tw.TextureField(material, tiling).render(-70, 40, 150, 110)
    span = 255 if dtype is np.uint8 else 8 if kind == "height" else 1
    assert np.abs(picture - wanted).max() <= 2.5 / 255 * span
    if kind == "height" and dtype is np.float32:
        assert wanted.min() < 0 or wanted.max() > 1  # nothing clips heights


@drawn
def test_tone_stays_when_tiles_are_seen_from_afar():
    material = toned(1)
    tiling = tw.direct(material.tiles, 3)
    afar = GpuField(material, tiling).render(OrthographicCamera(0, 0, 64, 64, scale=16)).astype(float)
    plane = tw.TextureField(material, tiling).render(0, 0, 1024, 1024).astype(float)
    near = plane.reshape(64, 16, 64, 16, 3).mean(axis=(1, 3))
    assert np.corrcoef(afar.ravel(), near.ravel())[0, 1] > 0.8
    assert np.abs(afar.mean(axis=(0, 1)) - near.mean(axis=(0, 1))).max() < 3


@drawn
def test_tone_by_a_table_is_refused():
    material = toned(1)
    with pytest.raises(TilewrightError, match="tone is laid by the mixer"):
        GpuField(material, tw.direct(material.tiles, hash="permutation"))


@drawn
def test_variants_that_no_shader_draws_are_refused():
    tiles = tw.corner_tiles(2)
    weighted = handmade(tiles, variants=tw.Variants.weighted([[1, 2]] * 16))
    with pytest.raises(TilewrightError, match="every tile needs as many, drawn alike"):
        GpuField(weighted, tw.direct(tiles))
    even = handmade(tiles, variants=tw.Variants.uniform(tiles, 2))
    with pytest.raises(TilewrightError, match="variants are drawn by the mixer"):
        GpuField(even, tw.direct(tiles, hash="permutation"))


@drawn
@pytest.mark.parametrize("colors", range(1, 9))
def test_every_place_of_a_packing(colors):
    tiles = tw.corner_tiles(colors)
    material, tiling = handmade(tiles, 16), tw.direct(tiles, 5)
    picture = GpuField(material, tiling, layout="atlas").render(OrthographicCamera(-900, 5, 1800, 1800))
    np.testing.assert_array_equal(picture, tw.TextureField(material, tiling).render(-900, 5, 1800, 1800))


@drawn
@pytest.mark.parametrize(("size", "colors"), [(16, 3), (64, 5), (255, 3), (4096, 3), (65536, 3)])
def test_permutation_tables_of_other_sizes(size, colors):
    tiles = tw.corner_tiles(colors)
    material, tiling = handmade(tiles, 16), tw.direct(tiles, hash=tw.PermutationHash(3, size))
    field = GpuField(material, tiling)
    for x, y in WINDOWS:
        wanted = tw.TextureField(material, tiling).render(x, y, 200, 200)
        np.testing.assert_array_equal(field.render(OrthographicCamera(x, y, 200, 200)), wanted)


@drawn
@pytest.mark.parametrize("kind", ["color", "data", "normal-gl"])
@pytest.mark.parametrize("channels", [1, 2, 3, 4])
@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
def test_every_kind_of_map_keeps_every_bit(dtype, channels, kind):
    tiles = tw.corner_tiles(2)
    made = handmade(tiles, 16, dtype, channels)
    material = TextureTiles(tiles, made.maps, made.sources, made.origins, made.recipe, kinds={"map0": kind})
    if open_gpu().filters_floats or dtype is np.uint8:
        tiling = tw.direct(tiles)
        picture = GpuField(material, tiling).render(OrthographicCamera(-300, 20, 160, 90))
        np.testing.assert_array_equal(picture, tw.TextureField(material, tiling).render(-300, 20, 160, 90))
        assert picture.dtype == dtype


@drawn
def test_the_filter_finds_the_same_texels():
    # Straight down from the height where a pixel is a texel the picture goes through the trilinear filter.
    tiles = tw.corner_tiles(2)
    material, tiling = handmade(tiles, 32), tw.direct(tiles, 4)
    camera = PerspectiveCamera(
        10**12 + 150, -(10**12) + 150, altitude=150 / tan(0.4), tilt=0, width=300, height=300
    )
    for layout in ("array", "atlas"):
        picture = GpuField(material, tiling, layout=layout).render(camera)
        np.testing.assert_array_equal(
            picture, tw.TextureField(material, tiling).render(10**12, -(10**12), 300, 300)
        )


@drawn
def test_blocks_do_not_show():
    tiles = tw.corner_tiles(2)
    material, tiling = handmade(tiles, 32), tw.direct(tiles, 4)
    field = GpuField(material, tiling, map="map0")
    wanted = tw.TextureField(material, tiling).render(-3, 7, 1500, 1100)
    np.testing.assert_array_equal(field.render(OrthographicCamera(-3, 7, 1500, 1100)), wanted)
    whole = field.render(OrthographicCamera(0, 0, 1200, 1100, scale=1.5))
    part = field.render(OrthographicCamera(1000 * 1.5, 1000 * 1.5, 200, 100, scale=1.5))
    assert np.abs(whole[1000:, 1000:].astype(int) - part).max() <= 1
    # A narrower camera sees the middle of the same picture, cut into blocks elsewhere.
    wide, narrow = (
        field.render(PerspectiveCamera(3, 5, 300, 1.4, heading=2, width=width, height=1100))
        for width in (1300, 1000)
    )
    assert np.abs(wide[:, 150:1150].astype(int) - narrow).max() <= 2


@pytest.mark.parametrize("colors", [(1, 1), (2, 2), (2, 3), (4, 3)])
def test_corner_configurations_hold_every_meeting_of_four_edges_once(colors):
    tiles = tw.wang_tiles(*colors)
    cells = corner_configurations(tiles)
    assert cells.shape == (colors[1] ** 2, colors[0] ** 2)
    assert first_mismatch(tiles, cells, torus=True) is None
    slots = tiles.slots[cells]
    # Around a lattice point: the edges north and west of the tiles beyond it, and those of its own tile.
    north, west = np.roll(slots[..., 3], 1, axis=0), np.roll(slots[..., 0], 1, axis=1)
    meetings = np.stack([north, slots[..., 0], slots[..., 3], west], axis=-1).reshape(-1, 4)
    assert len(np.unique(meetings, axis=0)) == len(meetings) == (colors[0] * colors[1]) ** 2


# --- Filtered pictures --------------------------------------------------------------------------------

SIDE = 2048


@pytest.fixture(scope="module")
def made(gravel):
    """Materials from a photograph, their tilings, and 32 x 32 cells of each as one picture."""
    photo = np.repeat(gravel[:256, :256], 3, axis=2)
    found = {}
    for tiles in (tw.corner_tiles(2), tw.wang_tiles(2)):
        material = tw.texture_tiles(photo, tiles, tile_size=64, seed=1)
        tiling = tw.direct(tiles, 7)
        found[tiles.shape.name] = material, tiling, tw.TextureField(material, tiling).render(0, 0, SIDE, SIDE)
    return found


LAYOUTS = [("corner", "array"), ("corner", "atlas"), ("wang", "atlas")]


def psnr(a, b):
    error = np.mean((a.astype(float) - b) ** 2)
    return 10 * np.log10(255**2 / max(error, 1e-10))


def border_gradient(picture, camera, size):
    """Mean difference across tile borders over the mean elsewhere, along both axes."""
    ratios = []
    for axis, first in ((0, camera.y), (1, camera.x)):
        p = np.moveaxis(picture.astype(float), axis, 0)
        at_border = np.diff(np.floor((first + (np.arange(len(p)) + 0.5) * camera.scale) / size)) != 0
        steps = np.abs(np.diff(p, axis=0)).mean(axis=(1, 2))
        ratios.append(steps[at_border].mean() / steps[~at_border].mean())
    return np.array(ratios)


def averaged(picture, camera, size, samples):
    """What a camera sees, each pixel the mean of samples x samples texels in linear light."""
    values = to_values(picture, "color")
    sight = camera.sight(0, 0, camera.width, camera.height, size)
    total = np.zeros((camera.height, camera.width, 3))
    for dy in range(samples):
        for dx in range(samples):
            x = np.arange(camera.width) + (dx + 0.5) / samples
            y = np.arange(camera.height)[:, None] + (dy + 0.5) / samples
            u, v, w = (r[0] * x + r[1] * y + r[2] for r in sight.rows)
            at = [
                np.floor((p / w + c) * size).astype(int) % SIDE
                for p, c in zip((u, v), sight.cell, strict=True)
            ]
            total += values[at[1], at[0]]
    return from_values((total / samples**2).astype(np.float32), "color", picture)


@drawn
@pytest.mark.parametrize(("kind", "layout"), LAYOUTS)
def test_minified_as_one_picture(made, kind, layout):
    # The same plane as one texture is all that a filter can give; tiles must give the same up to `clean`.
    material, tiling, plane = made[kind]
    field, plain = GpuField(material, tiling, layout=layout), GpuPicture(plane)
    clean = min(mips.clean for mips in field.mipmaps)
    assert clean >= 1
    for level in range(6):
        scale = 2**level
        camera = OrthographicCamera(0.37 * scale, 0.61 * scale, *(min(80, SIDE // scale - 1),) * 2, scale)
        tiled, whole = field.render(camera), plain.render(camera)
        reference = averaged(plane, camera, 64, min(16, 4 * scale))
        assert psnr(tiled, whole) > (60 if level <= clean else 28), level
        assert psnr(tiled, reference) > psnr(whole, reference) - (0.1 if level <= clean else 2), level
        if level < 5:  # there a tile is four pixels and more
            ratio = border_gradient(tiled, camera, 64) / border_gradient(whole, camera, 64)
            assert (ratio < (1.05 if level <= clean else 1.2)).all(), level


@drawn
@pytest.mark.parametrize("layout", ["array", "atlas"])
def test_minified_pixels_are_means_of_their_texels(made, layout):
    material, tiling, plane = made["corner"]
    field = GpuField(material, tiling, layout=layout)
    for scale in (2, 4)[: field.mipmaps[0].clean]:
        if layout == "array" and field.mipmaps[0].gutter % scale:
            continue
        camera = OrthographicCamera(3 * scale, 5 * scale, 200, 150, scale)
        error = field.render(camera).astype(int) - averaged(plane, camera, 64, scale)
        assert np.abs(error).max() <= 1, scale


@drawn
@pytest.mark.parametrize(("kind", "mean"), [("color", 188), ("data", 128)])
@pytest.mark.parametrize(("dtype", "white"), [(np.uint8, 255), (np.uint16, 65535)])
def test_light_is_averaged_as_light(kind, mean, dtype, white):
    # Half way between black and white: half the light is 188 of 255 in sRGB (IEC 61966-2-1).
    stripes = np.zeros((8, 8, 3), dtype)
    stripes[:, ::2] = white
    seen = GpuPicture(stripes, kind).render(OrthographicCamera(0.5, 0, 8, 8))
    assert np.abs(seen / white * 255 - mean).max() <= 1


@drawn
def test_levels_are_blended():
    # Stripes a texel wide are gray in level 1; half way to it they have half their contrast.
    stripes = np.zeros((64, 64, 1), np.uint8)
    stripes[:, ::2] = 255
    seen = GpuPicture(stripes, "data").render(OrthographicCamera(0, 0, 40, 40, scale=2**0.5))
    assert 45 < np.abs(seen.astype(float) - 127.5).max() < 80


@drawn
@pytest.mark.parametrize(("kind", "layout"), LAYOUTS)
@pytest.mark.parametrize(("tilt", "least"), [(0.0, 60), (0.6, 40), (1.0, 34)])
def test_perspective(made, kind, layout, tilt, least):
    material, tiling, plane = made[kind]
    camera = PerspectiveCamera(SIDE / 2, SIDE * 0.9, 350, tilt, fov=0.6, width=256, height=256)
    tiled = GpuField(material, tiling, layout=layout).render(camera)
    whole = GpuPicture(plane).render(camera)
    reference = averaged(plane, camera, 64, 6)
    assert psnr(tiled, whole) > least
    assert psnr(tiled, reference) > max(27, psnr(whole, reference) - 1)


@drawn
def test_wei_at_a_texel_per_pixel(made):
    material, tiling, plane = made["wang"]
    picture = GpuField(material, tiling).render(OrthographicCamera(0, 0, SIDE, SIDE))
    np.testing.assert_array_equal(picture, plane)


@drawn
def test_wei_shows_no_dots(made):
    # Close to lattice points filters mix four tiles, which lie side by side in the corner atlas only.
    material, tiling, plane = made["wang"]
    field, plain = GpuField(material, tiling), GpuPicture(plane)
    camera = OrthographicCamera(0.5, 0.5, 1024, 1024, 1)
    error = np.abs(field.render(camera).astype(int) - plain.render(camera)).max(axis=2)
    x = np.arange(1024) + 1
    off = np.abs(x - 64 * np.round(x / 64))
    dots = np.maximum(off[:, None], off) < 1
    assert dots.sum() == 15**2 + 2 * 15 + 1
    assert error[dots].max() <= 1


@drawn
def test_the_sky_and_the_horizon():
    tiles = tw.corner_tiles(2)
    material = handmade(tiles, 16)
    picture = GpuField(material, tw.direct(tiles)).render(
        PerspectiveCamera(0, 0, 100, 1.4, width=64, height=400)
    )
    sky = (picture == 0).all(axis=(1, 2))
    assert sky[:30].all()
    assert not sky[200:].any()
    far = picture[np.flatnonzero(~sky)[1]].astype(float)
    assert far.std(axis=0).max() < 1  # one color: the mean of the set
    mean = from_values(
        to_values(material.pixels, "color").mean(axis=(0, 1, 2), keepdims=True), "color", material.pixels
    )
    assert np.abs(far.mean(axis=0) - mean.ravel()).max() <= 2


@drawn
def test_headings():
    # North is up; heading east, what lies east is up.
    tiles = tw.corner_tiles(2)
    field = GpuField(handmade(tiles, 16), tw.direct(tiles))
    seen = [
        field.render(PerspectiveCamera(8, 8, 40, 0, heading=h, width=64, height=64)) for h in (0, np.pi / 2)
    ]
    assert np.abs(np.rot90(seen[0]).astype(int) - seen[1]).mean() < 2
    assert np.abs(seen[0].astype(int) - seen[1]).mean() > 20


def test_the_mixer_s_start_states_are_the_hash():
    hash = tw.MixerHash(2**63 + 12345)
    states, low = shader_hash(hash, (3,)).place(-5, 2**40 + 3)
    a, b = (int(word) for word in states[0, :2])  # x < 0, y >= 0 here: the high word of y is 256

    def mix(h):
        h = (h ^ h >> 16) * 0x21F0AAAD % 2**32
        h = (h ^ h >> 15) * 0xD35A2D97 % 2**32
        return h ^ h >> 15

    a = mix(a ^ low[1])
    b = mix(((b ^ a) + low[1]) % 2**32)
    h = (low[0] % 2**32) ^ a
    h = ((h ^ h >> 16) * 0x21F0AAAD + b) % 2**32
    h = (h ^ h >> 15) * 0xD35A2D97 % 2**32
    assert h ^ h >> 15 == int(hash.words(0, -5, 2**40 + 3))
