"""Mip levels of layers and atlases: whole, true to the tiles, and alike on both sides of every border."""

import numpy as np
import pytest

import tilewright as tw
from handmade import handmade
from tilewright.shaders.mipmaps import atlas_mipmaps, layer_mipmaps
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.kinds import from_values, guess_kind, to_values
from tilewright.tilings import packing


def sample(layer, at):
    """Bilinear, clamped, as graphics hardware filters; ``at`` are (y, x) in texel centers."""
    out = 0
    low = np.floor(at).astype(int)
    for dy in (0, 1):
        for dx in (0, 1):
            y, x = (low + np.array((dy, dx))).T
            weight = np.abs(1 - np.array((dy, dx)) - (at - low)).prod(axis=1)
            n = len(layer)
            out = out + weight[:, None] * layer[y.clip(0, n - 1), x.clip(0, n - 1)]
    return out


def test_base_level_holds_the_pixels(gravel_tiles):
    mips = layer_mipmaps(gravel_tiles)
    g = mips.gutter
    assert g == 4
    assert np.array_equal(mips.levels[0][:, g:-g, g:-g], gravel_tiles.pixels)
    assert [level.shape[1] for level in mips.levels] == [72, 36, 18, 9, 4, 2, 1]
    cells = packing(gravel_tiles.tiles).indices(0, 0, 4, 4)
    atlas = atlas_mipmaps(gravel_tiles, cells)
    assert np.array_equal(atlas.levels[0][0], tw.make_atlas(gravel_tiles)[0])
    assert [level.shape[1] for level in atlas.levels] == [256, 128, 64, 32, 16, 8, 4, 2, 1]


def test_clean_levels_are_means_of_linear_light(gravel_tiles):
    mips = layer_mipmaps(gravel_tiles)
    assert mips.clean >= 1
    light = to_values(gravel_tiles.pixels, "color")
    for level in range(1, mips.clean + 1):
        step, g = 1 << level, mips.gutter >> level
        means = light.reshape(16, 64 // step, step, 64 // step, step, 1).mean(axis=(2, 4))
        wanted = from_values(means, "color", gravel_tiles.pixels).astype(int)
        assert np.abs(mips.levels[level][:, g:-g, g:-g].astype(int) - wanted).max() <= 1


@pytest.mark.parametrize(("colors", "size"), [(2, 64), (3, 32), (2, 48), (2, 52)])
def test_filtered_layers_agree_at_every_border_and_corner(gravel, gravel_tiles, colors, size):
    material = gravel_tiles
    if size != 64:
        material = tw.texture_tiles(gravel[:160, :160], tw.corner_tiles(colors), tile_size=size, seed=1)
    mips = layer_mipmaps(material)
    rng = np.random.default_rng(1)
    for number, level in enumerate(mips.levels):
        n = level.shape[1]
        along = rng.random(8)
        for _ in range(20):
            cells = tw.direct(material.tiles, int(rng.integers(2**32))).indices(0, 0, 2, 2)

            def at(tile, y, x, level=level, n=n):
                place = np.stack(np.broadcast_arrays(y, x), axis=1) * size + mips.gutter
                return sample(level[tile].astype(float), place * n / (size + 2 * mips.gutter) - 0.5)

            (a, b), (c, d) = cells
            steps = [
                at(a, along, np.ones(8)) - at(b, along, np.zeros(8)),
                at(a, np.ones(8), along) - at(c, np.zeros(8), along),
                at(a, np.ones(1), np.ones(1)) - at(d, np.zeros(1), np.zeros(1)),
            ]
            # Half a level of rounding on either side; tiles whose texels do not divide them have a rest.
            most = 1.01 if (size & (size - 1)) == 0 or number == 0 else 6
            assert max(np.abs(s).max() for s in steps) <= most


def test_atlas_levels_agree_wherever_tiles_may_meet(gravel_tiles):
    packed = packing(gravel_tiles.tiles)
    cells = packed.indices(0, 0, 4, 4)
    for level in atlas_mipmaps(gravel_tiles, cells).levels[:7]:
        n = level.shape[1] // 4
        tiles = np.empty((16, n, n), int)
        for y in range(4):
            for x in range(4):
                tiles[cells[y, x]] = level[0, y * n : y * n + n, x * n : x * n + n, 0]
        # What the atlas shows beyond a tile's east border is what any tile that may lie there begins with.
        for y in range(4):
            for x in range(4):
                slots = gravel_tiles.tiles.slots[cells[y, x]]
                shown = tiles[cells[y, (x + 1) % 4]][:, 0]
                for other in gravel_tiles.tiles.fitting(NW=int(slots[0]), SW=int(slots[1])):
                    assert np.abs(tiles[other][:, 0] - shown).max() <= 1


def test_the_last_level_is_the_mean_of_the_set(gravel_tiles):
    mean = to_values(gravel_tiles.pixels, "color").mean()
    top = to_values(layer_mipmaps(gravel_tiles).levels[-1], "color")
    assert np.ptp(top) == 0
    assert abs(top.mean() - mean) < 0.01


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_every_type_and_number_of_channels(kind, channels):
    material = handmade(tw.corner_tiles(2), 16, kind, channels)
    mips = layer_mipmaps(material)
    assert all(level.dtype == kind and level.shape[3] == channels for level in mips.levels)
    assert np.array_equal(mips.levels[0][:, 2:-2, 2:-2], material.pixels)


def bumpy(spread):
    """A material whose normals lean to all sides by ``spread``, and whose roughness is even."""
    rng = np.random.default_rng(1)
    slopes = rng.normal(0, spread, (16, 32, 32, 2))
    vectors = np.concatenate([-slopes, np.ones((16, 32, 32, 1))], axis=3)
    vectors /= np.linalg.norm(vectors, axis=3, keepdims=True)
    maps = {
        "albedo": np.full((16, 32, 32, 3), 99, np.uint8),
        "normal": (vectors * 0.5 + 0.5).astype(np.float32),
        "roughness": np.full((16, 32, 32, 1), 0.3, np.float32),
    }
    origins = np.zeros((16, 32, 32, 3), np.uint16)
    return TextureTiles(tw.corner_tiles(2), maps, ({n: m[0] for n, m in maps.items()},), origins)


def test_lost_length_of_normals_goes_into_roughness():
    material = bumpy(0.2)
    roughness = layer_mipmaps(material, "roughness")
    normals = layer_mipmaps(material, "normal")
    for level in normals.levels[1:]:
        assert np.abs(np.linalg.norm(level * 2.0 - 1, axis=3) - 1).max() < 1e-5
    # Width squared of a lobe is r^4; slopes of variance s^2 along each axis add 2 s^2.
    wanted = (0.3**4 + 2 * 0.2**2) ** 0.25
    assert abs(float(roughness.levels[-1].mean()) - wanted) < 0.02
    flat = layer_mipmaps(bumpy(0.0), "roughness")
    assert np.allclose(flat.levels[-1], 0.3, atol=1e-4)


def test_wang_tiles_have_atlases_and_no_layers():
    material = handmade(tw.wang_tiles(2))
    assert atlas_mipmaps(material, packing(material.tiles).indices(0, 0, 4, 4)).levels[0].shape == (
        1,
        64,
        64,
        3,
    )
    with pytest.raises(tw.TilewrightError, match="layers with gutters need tiles with corner colors"):
        layer_mipmaps(material)
    with pytest.raises(tw.TilewrightError, match="map is 'b'"):
        layer_mipmaps(handmade(tw.corner_tiles(2)), "b")
    with pytest.raises(tw.TilewrightError, match="cells must be"):
        atlas_mipmaps(material, np.zeros(4))


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("albedo", "color"),
        ("Moss_Color", "color"),
        ("emissive", "color"),
        ("normal", "normal-gl"),
        ("rock_nor_dx", "normal-dx"),
        ("NormalDX", "normal-dx"),
        ("nor_gl", "normal-gl"),
        ("roughness", "roughness"),
        ("rough", "roughness"),
        ("height", "height"),
        ("displacement", "height"),
        ("ao", "data"),
        ("chaos", "color"),
        ("rough_wood_albedo", "color"),
        ("Metal_Plate_Color", "color"),
        ("abnormal", "color"),
        ("x_normal-ogl", "normal-gl"),
        ("heightfield", "height"),
        ("metalness", "data"),
        ("opacity", "data"),
    ],
)
def test_kinds_are_guessed_from_names(name, kind):
    assert guess_kind(name) == kind
