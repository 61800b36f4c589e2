"""Exports rendered in the engines that can be had: Blender's Cycles, and Godot built for the web."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest

import in_godot
import tilewright as tw
from handmade import handmade, of_numbers, surface_under_clouds, under_clouds
from tilewright.export.engines import save_for_engine
from tilewright.shaders import lookup as lookups
from tilewright.tilings import packing

BLENDER = Path(__file__).parents[2] / ".venv/blender/bin/python"


@pytest.fixture(scope="module")
def in_blender(tmp_path_factory):
    """Run jobs in Blender's Python; see in_blender.py."""
    if not BLENDER.exists():
        pytest.skip("Blender's Python module is not installed; .ci/install-validators does it")
    folder = tmp_path_factory.mktemp("blender")

    def run(jobs):
        for n, job in enumerate(jobs):
            job["out"] = str(folder / f"{n}.npy")
        (folder / "jobs.json").write_text(json.dumps(jobs))
        script = Path(__file__).parents[1] / "helpers" / "in_blender.py"
        done = subprocess.run(
            [BLENDER, script, folder / "jobs.json"], capture_output=True, text=True, timeout=300, check=False
        )
        assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
        return [np.load(job["out"]) for job in jobs]

    return run


_ASK_OSL = """%s
shader ask(point Position = 0, int OriginX = 0, int OriginY = 0, output color Answer = 0) {
  int ne, se, sw, nw, column, row;
  tw_corners(int(floor(Position[0])) + OriginX, int(floor(Position[1])) + OriginY, ne, se, sw, nw);
  tw_place(ne, se, sw, nw, column, row);
  Answer = color(column, row, 0);
}"""


def test_open_shading_language_finds_the_tiles(in_blender, tmp_path):
    edge, seeds = 2**31, (0, 7, 2**64 - 1)
    origins = [
        (-8, -8),
        (-edge, -edge),
        (edge - 16, -9),
        (edge - 16, edge - 16),
        (123456789, -edge),
        (-17, 40),
    ]
    cases, jobs = [(c, seeds[c % 3]) for c in range(1, 9)], []
    for colors, seed in cases:
        path = tmp_path / f"{colors}.osl"
        path.write_text(_ASK_OSL % lookups.lookup("osl", colors, seed, 16, None))
        jobs.append({"osl": str(path), "output": "Answer", "origins": origins, "pixels": 16, "tiles": 16})
    for (colors, seed), answers in zip(cases, in_blender(jobs), strict=True):
        tiling = tw.direct(tw.corner_tiles(colors), seed)
        for (x, y), answer in zip(origins, answers, strict=True):
            places = packing(tiling.tiles).place(tiling.indices(x, y, 16, 16))
            np.testing.assert_array_equal(answer[..., 0], places[0])
            np.testing.assert_array_equal(answer[..., 1], places[1])


def with_variants(colors, count):
    tiles = tw.corner_tiles(colors)
    return handmade(tiles, 16, variants=tw.Variants.uniform(tiles, count))


def in_classes(count):
    tiles = tw.classed_corner_tiles(2, 5)
    return handmade(tiles, 16, variants=tw.Variants.uniform(tiles, count))


def under_one_sky(tiles):
    return under_clouds(handmade(tiles, 32), 2)


def least_off(material, drawn, place):
    """A drawing against the field: equal, but for tone, which is laid in floats."""
    field = tw.TextureField(material, tw.direct(material.tiles, seed=7))
    off = np.abs(np.rint(255 * drawn) - field.render(*place, *drawn.shape[1::-1]))
    assert off.max() <= (0 if material.tone is None else 2)
    assert off.mean() < 0.4


def test_the_osl_shader_draws_the_pixels_of_the_field(in_blender, tmp_path):
    made = [handmade(tw.corner_tiles(colors), 16) for colors in (2, 5)]
    made += [with_variants(2, 3), with_variants(3, 2)]
    made += [under_one_sky(tiles) for tiles in (tw.corner_tiles(2), tw.classed_corner_tiles(2, 5))]
    made += [of_numbers(made[-1], "roughness")]
    origins = [(0, 0), (-300, 77)]
    jobs = []
    for n, material in enumerate(made):
        folder = tmp_path / str(n)
        save_for_engine(material, folder, "osl", seed=7)
        shader = (folder / "tilewright.osl").read_text()
        told = shader.replace('string Tone = ""', f'string Tone = "{folder}/map0_tone.tx"')
        assert (told == shader) == (material.tone is None)
        (folder / "tilewright.osl").write_text(told)
        files = {"osl": str(folder / "tilewright.osl"), "map": str(folder / "map0.tx")}
        tiles = 128 // material.tile_size
        jobs.append({**files, "output": "Color", "origins": origins, "pixels": 128, "tiles": tiles})
    for material, answers in zip(made, in_blender(jobs), strict=True):
        for (x, y), drawn in zip(origins, answers, strict=True):
            least_off(material, drawn, (material.tile_size * x, material.tile_size * y))


def test_blender_renders_the_pixels_of_the_field(in_blender, tmp_path):
    made = [*(handmade(tw.corner_tiles(colors), 16) for colors in (2, 3, 6)), with_variants(2, 3)]
    made += [handmade(tw.classed_corner_tiles(2, 5)), under_one_sky(tw.classed_corner_tiles(2, 5))]
    made += [under_one_sky(tw.corner_tiles(2))]
    jobs = []
    for n, material in enumerate(made):
        save_for_engine(material, tmp_path / str(n), "blender", seed=7)
        tiles = 128 // material.tile_size
        jobs.append({"material": str(tmp_path / str(n) / "material.py"), "pixels": 128, "tiles": tiles})
    for material, drawn in zip(made, in_blender(jobs), strict=True):
        least_off(material, drawn, (0, -128))


def test_blender_wires_every_map(in_blender, tmp_path):
    save_for_engine(surface_under_clouds(), tmp_path / "blender", "blender", seed=7)
    job = {"material": str(tmp_path / "blender" / "material.py"), "pixels": 16, "tiles": 1}
    in_blender([job])
    wired = json.loads(Path(job["out"]).with_suffix(".json").read_text())
    assert wired == ["Base Color", "Emission Color", "Metallic", "Normal", "Roughness"]


needs_godot = pytest.mark.skipif(
    not in_godot.ENGINE.exists(), reason="Godot for the web is not installed; sh .ci/install-validators"
)


@needs_godot
@pytest.mark.browser
@pytest.mark.parametrize("kind", ["six colors", "classes", "tone"])
def test_godot_renders_the_pixels_of_the_field(kind, browser, tmp_path):
    material = {
        "six colors": lambda: with_variants(6, 1),
        "classes": lambda: in_classes(3),
        "tone": lambda: under_one_sky(tw.classed_corner_tiles(2, 5)),
    }[kind]()
    save_for_engine(material, tmp_path / "godot", "godot", seed=7)
    size = material.tile_size
    drawn, errors = in_godot.draw(browser, tmp_path / "godot", 128 // size, (-3, -5), 128)
    field = tw.TextureField(material, tw.direct(material.tiles, seed=7))
    # Godot decodes and encodes sRGB by approximations of its own.
    difference = np.abs(drawn.astype(int) - field.render(-3 * size, -5 * size, 128, 128))
    assert difference.max() <= 8
    assert difference.mean() < 1
    assert errors == []


@needs_godot
@pytest.mark.browser
def test_godot_takes_every_map(browser, tmp_path):
    save_for_engine(surface_under_clouds(), tmp_path / "godot", "godot", seed=7)
    _, errors = in_godot.draw(browser, tmp_path / "godot", 8, (0, 0), 64)
    assert errors == []
