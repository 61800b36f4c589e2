"""Exports for engines: every dialect finds the tiles that Python finds, and draws the same pixels."""

import dataclasses
import shutil
import subprocess

import numpy as np
import pytest

import dialects
import tilewright as tw
from handmade import handmade, under_clouds
from tilewright.errors import TilewrightError
from tilewright.export.engines.kit import prepare
from tilewright.export.engines.parts import fill
from tilewright.shaders import lookup as lookups
from tilewright.tilings import packing

SEEDS = (0, 2**32 + 5, 2**64 - 1)
EDGE = 2**31


def many_cells():
    """Cells around the origin, near the ends of 32 bits, and anywhere: (N, 2)."""
    near = [-EDGE, -EDGE + 1, -3, -2, -1, 0, 1, 2, 3, EDGE - 2, EDGE - 1]
    grid = np.stack(np.meshgrid(near, near), -1).reshape(-1, 2)
    rng = np.random.default_rng(4)
    anywhere = rng.integers(-EDGE, EDGE, (150, 2))
    around = rng.integers(-50, 50, (60, 2))
    return np.concatenate([grid, anywhere, around])


CELLS = many_cells()


@pytest.fixture(scope="module")
def table():
    """Tiles of `CELLS`, by number of colors and seed: the one table all dialects are held against."""
    return {(c, s): dialects.tile_table(c, s, *CELLS.T) for c in range(1, 9) for s in SEEDS}


@pytest.fixture(scope="module")
def device():
    return dialects.device()


def places(colors, tiles):
    """Row * 256 + column in the atlas."""
    x, y = packing(tw.corner_tiles(colors)).place(tiles)
    return np.asarray(y) * 256 + np.asarray(x)


def include_of(dialect, kit):
    """The text that an export puts into a shader."""
    if dialect == "unity":
        values = kit.numbers() | kit.example_tone()
        return fill("unity/Tilewright.hlsl", **values, include=kit.lookup("hlsl"))
    return kit.lookup(dialect)


def test_the_table_is_what_direct_says(table):
    tiling = tw.direct(tw.corner_tiles(3), SEEDS[1])
    for (x, y), tile in list(zip(CELLS.tolist(), table[3, SEEDS[1]], strict=True))[::20]:
        assert tiling.indices(x - 1, y - 1, 3, 3)[1, 1] == tile
    assert len(np.unique(table[8, 0])) > 200


@pytest.mark.parametrize(
    ("dialect", "colors"),
    [("wgsl", c) for c in range(1, 9)] + [(d, c) for d in ("glsl", "hlsl", "godot") for c in (1, 2, 5, 8)],
)
def test_a_dialect_finds_the_tiles_and_their_places(dialect, colors, table, device, tmp_path):
    for seed in SEEDS:
        array = lookups.lookup(dialect, colors, seed, 16, 2)
        got = dialects.ask(device, dialect, array, CELLS, "tile", tmp_path)
        np.testing.assert_array_equal(got, table[colors, seed])
    if dialect == "godot" and colors == 2:
        return  # 16 tiles are never an atlas there
    atlas = lookups.lookup(dialect, colors, seed, 16, None)
    got = dialects.ask(device, dialect, atlas, CELLS, "place", tmp_path)
    np.testing.assert_array_equal(got, places(colors, table[colors, seed]))


@pytest.mark.parametrize("variants", [2, 3, 256])
@pytest.mark.parametrize("dialect", ["wgsl", "glsl", "hlsl", "godot"])
def test_a_dialect_draws_the_variants(dialect, variants, table, device, tmp_path):
    for seed in SEEDS:
        include = lookups.lookup(dialect, 3, seed, 16, 2, variants)
        got = dialects.ask(device, dialect, include, CELLS, "variant", tmp_path)
        np.testing.assert_array_equal(got, dialects.variant_table(variants, seed, *CELLS.T))
    got = dialects.ask(device, dialect, include, CELLS, "tile", tmp_path)
    np.testing.assert_array_equal(got, table[3, seed])


def test_the_table_of_variants_is_what_the_tiling_says():
    tiles = tw.corner_tiles(3)
    tiling, variants = tw.direct(tiles, SEEDS[1]), tw.Variants.uniform(tiles, 5)
    wanted = dialects.variant_table(5, SEEDS[1], *CELLS.T)
    for (x, y), variant in list(zip(CELLS.tolist(), wanted, strict=True))[::20]:
        assert tiling.placements(x - 1, y - 1, 3, 3, variants=variants).variants[1, 1] == variant
    assert len(np.unique(wanted)) == 5


DRAWN = ("wgsl", "glsl", "hlsl", "unity")
# Dialect, colors, and whether as an atlas; Unreal gets atlases only.
ARRAYS = [(dialect, colors, False) for dialect in DRAWN for colors in (1, 3, 4)]
FORMS = ARRAYS + [(dialect, colors, True) for dialect in (*DRAWN, "unreal") for colors in (2, 5, 6)]


@pytest.mark.parametrize(("dialect", "colors", "atlas"), FORMS)
def test_a_dialect_draws_the_pixels_of_the_field(dialect, colors, atlas, device, tmp_path):
    material = handmade(tw.corner_tiles(colors), 16)
    kit = prepare(material, 9, atlas=atlas)
    levels, _ = kit.levels("map0")
    field = tw.TextureField(material, tw.direct(material.tiles, seed=9))
    for texel in ((-70, -37), (16 * 1000 + 3, -16 * 900000)):
        drawn = dialects.draw(
            device, dialect, include_of(dialect, kit), levels, 16, texel, (128, 96), tmp_path, atlas=atlas
        )
        np.testing.assert_array_equal(drawn[..., :3], field.render(*texel, 128, 96))


# Colors, classes, variants; in an array, and in a grid, where there are more than 256 pictures too.
CLASSED = [(2, 5, 1), (2, 5, 3), (3, 2, 1), (2, 5, 4)]
IN_CLASSES = [
    (d, *c, grid)
    for d in (*DRAWN, "unreal")
    for grid, sets in ((False, CLASSED[:2]), (True, CLASSED[1:]))
    for c in sets
    if grid or d != "unreal"
]


@pytest.mark.parametrize(("dialect", "colors", "classes", "variants", "grid"), IN_CLASSES)
def test_a_dialect_draws_tiles_in_classes(dialect, colors, classes, variants, grid, device, tmp_path):
    tiles = tw.classed_corner_tiles(colors, classes)
    material = handmade(tiles, 16, variants=tw.Variants.uniform(tiles, variants))
    kit = prepare(material, 9, atlas=grid and variants < 4)
    assert kit.form == ("grid" if grid else "array")
    levels, _ = kit.levels("map0")
    field = tw.TextureField(material, tw.direct(tiles, seed=9))
    for cell in ((-5, -3), (1000, -900000), (2**22 + 1, -(2**22)), (-1, 2**22 - 7)):
        texel = (16 * cell[0] + 3, 16 * cell[1] + 5)
        drawn = dialects.draw(
            device, dialect, include_of(dialect, kit), levels, 16, texel, (64, 48), tmp_path, atlas=grid
        )
        np.testing.assert_array_equal(drawn[..., :3], field.render(*texel, 64, 48))


@pytest.mark.parametrize(("span", "tiles"), [(1, tw.classed_corner_tiles(2, 5)), (3, tw.corner_tiles(2))])
@pytest.mark.parametrize("dialect", ["wgsl", "hlsl", "unity", "unreal"])
def test_a_dialect_lays_the_tone(dialect, span, tiles, device, tmp_path):
    material = under_clouds(handmade(tiles, 32), span)
    kit = prepare(material, 9, atlas=dialect == "unreal")
    levels, _ = kit.levels("map0")
    include = kit.lookup("unreal", tone=False) if dialect == "unreal" else include_of(dialect, kit)
    field = tw.TextureField(material, tw.direct(tiles, seed=9))
    for cell in ((-5, -3), (1000, -900000), (2**22 + 1, -(2**22)), (-1, 2**22 - 7)):
        texel = (32 * cell[0] + 3, 32 * cell[1] + 5)
        drawn = dialects.draw(
            device, dialect, include, levels, 32, texel, (96, 64), tmp_path,
            atlas=dialect == "unreal", tone=kit.tone("map0"), laid=kit.lookup("unreal tone"),
            mean=kit.example_tone()["mean"],
        )  # fmt: skip
        off = np.abs(drawn[..., :3].astype(int) - field.render(*texel, 96, 64))
        assert off.max() <= 2
        assert off.mean() < 0.4


# As array and as atlas; 3 colors in 4 variants are more layers than all devices have.
SEVERAL = [(d, c, v, False) for d in DRAWN for c, v in ((2, 3), (3, 2))]
SEVERAL += [(d, c, v, True) for d in (*DRAWN, "unreal") for c, v in ((2, 3), (3, 4), (4, 2))]


@pytest.mark.parametrize(("dialect", "colors", "variants", "atlas"), SEVERAL)
def test_a_dialect_draws_the_pixels_of_variants(dialect, colors, variants, atlas, device, tmp_path):
    tiles = tw.corner_tiles(colors)
    material = handmade(tiles, 16, variants=tw.Variants.uniform(tiles, variants))
    kit = prepare(material, 9, atlas=atlas)
    assert kit.form == ("atlas" if atlas else "array")
    levels, _ = kit.levels("map0")
    field = tw.TextureField(material, tw.direct(material.tiles, seed=9))
    for texel in ((-70, -37), (16 * 1000 + 3, -16 * 900000)):
        drawn = dialects.draw(
            device, dialect, include_of(dialect, kit), levels, 16, texel, (128, 96), tmp_path, atlas=atlas
        )
        np.testing.assert_array_equal(drawn[..., :3], field.render(*texel, 128, 96))


def test_variants_that_no_shader_draws_are_refused(tmp_path):
    tiles = tw.corner_tiles(2)
    weighted = handmade(tiles, variants=tw.Variants.weighted([[1, 2]] * 16))
    many = handmade(tw.corner_tiles(1), variants=tw.Variants.uniform(tw.corner_tiles(1), 257))
    for material in (weighted, many):
        with pytest.raises(TilewrightError, match="every tile needs as many, drawn alike, 1 to 256"):
            tw.save_for_engine(material, tmp_path / "out", "godot")
        with pytest.raises(TilewrightError, match="every tile needs as many"):
            tw.make_atlas(material)


def test_atlases_of_variants_lie_side_by_side():
    tiles = tw.corner_tiles(2)
    material = handmade(tiles, 16, variants=tw.Variants.uniform(tiles, 3))
    pixels, packed = tw.make_atlas(material)
    assert pixels.shape == (64, 192, 3)
    for tile in range(16):
        for variant in range(3):
            x, y = packed.place(tile)
            x += variant * packed.size[0]
            there = pixels[16 * y : 16 * y + 16, 16 * x : 16 * x + 16]
            np.testing.assert_array_equal(there, material.pixels[3 * tile + variant])


_ASK_CPP = """#include <cmath>
#include <cstdio>
using std::floor;
%s
int main() {
  int x, y;
  while (std::scanf("%%d %%d", &x, &y) == 2) {
    float u, v;
    tw_find(0.5f, 0.5f, x, y, u, v);
    std::printf("%%.9g %%.9g\\n", u, v);
  }
}"""


@pytest.mark.skipif(shutil.which("g++") is None, reason="g++ is not installed")
@pytest.mark.parametrize(("colors", "variants"), [(2, 1), (2, 3), (3, 5), (4, 256)])
def test_open_shading_language_read_as_another_language(colors, variants, table, tmp_path):
    """OSL's integers are C's, wrapping; its outputs are references."""
    for seed in SEEDS:
        text = lookups.lookup("osl", colors, seed, 16, None, variants)
        text = text.replace("output int ", "int &").replace("output float ", "float &")
        (tmp_path / "lookup.cpp").write_text(_ASK_CPP % text)
        build = ["g++", "-fwrapv", "-O1", "-o", tmp_path / "lookup", tmp_path / "lookup.cpp"]
        subprocess.run(build, check=True)
        cells = "\n".join(f"{x} {y}" for x, y in CELLS.tolist())
        run = subprocess.run([tmp_path / "lookup"], input=cells, capture_output=True, text=True, check=True)
        found = np.array(run.stdout.split(), float).reshape(-1, 2)
        column, row = packing(tw.corner_tiles(colors)).place(table[colors, seed])
        column = column + colors**2 * dialects.variant_table(variants, seed, *CELLS.T)
        np.testing.assert_array_equal(np.floor(found[:, 0] * colors**2 * variants), column)
        np.testing.assert_array_equal(np.floor(found[:, 1] * colors**2), row)


@pytest.fixture(scope="module")
def gravel_tiles(gravel):
    """Tiles whose first mip levels are plain means up to their borders."""
    made = tw.texture_tiles(gravel[:200, :200], tw.corner_tiles(2), tile_size=64, seed=1)
    return dataclasses.replace(made, kinds=dict.fromkeys(made.maps, "data"))


@pytest.mark.parametrize(("dialect", "atlas"), sorted({(dialect, atlas) for dialect, _, atlas in FORMS}))
def test_gradients_do_not_break_at_tile_borders(dialect, atlas, device, gravel_tiles, tmp_path):
    kit = prepare(gravel_tiles, 3, atlas=atlas)
    assert kit.mipmaps(kit.material.main).clean >= 1
    levels = [np.repeat(level[..., :1], 4, axis=-1) for level in kit.levels(kit.material.main)[0]]
    # Two texels a pixel, so that quads of pixels lie across the borders of tiles.
    drawn = dialects.draw(
        device,
        dialect,
        include_of(dialect, kit),
        levels,
        64,
        (-130, -66),
        (128, 128),
        tmp_path,
        atlas=atlas,
        step=2,
    )
    field = tw.TextureField(gravel_tiles, tw.direct(gravel_tiles.tiles, seed=3))
    fine = field.render(-130, -66, 256, 256)[..., 0].astype(float)
    mean = fine.reshape(128, 2, 128, 2).mean(axis=(1, 3))
    assert np.abs(drawn[..., 0] - mean).max() <= 1
