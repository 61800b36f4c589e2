"""Pictures of tile sets and tilings, and the command that makes them."""

import json
import re
import warnings
from xml.etree import ElementTree

import numpy as np
import pytest

import commands
import tilewright as tw
from tilewright.errors import TilewrightError, TilewrightWarning
from tilewright.export.drawing.tiles import color_of, draw_tiles, draw_tiling, paint_tiles, paint_tiling
from tilewright.tiles import corner_coded_tiles, corner_tiles, crossed_wang_tiles, dominoes, wang_tiles
from tilewright.tiles.aperiodic import APERIODIC_SETS, aperiodic_tiles
from tilewright.tiles.translations import as_corner_tiles
from tilewright.tilings import array_tiling, direct
from tilewright.tilings.aperiodic import aperiodic_tiling, translated_tiling

SVG = "{http://www.w3.org/2000/svg}"
SETS = [wang_tiles(3), corner_tiles(2), corner_coded_tiles(), aperiodic_tiles("jeandel-rao-36")]
# Inside each slot's region, near the middle of the edge or the corner.
SPOTS = {"N": (0.5, 0.1), "E": (0.9, 0.5), "S": (0.5, 0.9), "W": (0.1, 0.5),
         "NE": (0.9, 0.1), "SE": (0.9, 0.9), "SW": (0.1, 0.9), "NW": (0.1, 0.1)}  # fmt: skip


def rgb(color):
    return [int(color[i : i + 2], 16) for i in (1, 3, 5)]


def read(drawing):
    return ElementTree.fromstring(drawing)


def call(*arguments):
    commands.call("aperiodic", *arguments)


def test_colors_are_told_apart():
    colors = [color_of(n) for n in range(256)]
    assert len(set(colors)) == 256
    assert all(re.fullmatch("#[0-9a-f]{6}", c) for c in colors)
    first = np.array([rgb(c) for c in colors[:16]], float)
    apart = np.abs(first[:, None] - first).sum(axis=-1) + 1e9 * np.eye(16)
    assert apart.min() > 60


@pytest.mark.parametrize("tiles", SETS, ids=lambda tiles: tiles.name)
def test_pixels_have_the_colors_of_the_slots(tiles):
    cells = np.arange(len(tiles)).reshape(1, -1)[:, :9]
    for size in (8, 40):
        for tile in cells[0]:
            tiling = array_tiling(tiles, [[tile]])
            pixels = paint_tiling(tiling, 0, 0, 1, 1, size=size)
            assert pixels.shape == (size, size, 3)
            for name, color in zip(tiles.shape.slots, tiles.slots[tile], strict=True):
                x, y = (int(part * size) for part in SPOTS[name])
                assert pixels[y, x].tolist() == rgb(color_of(int(color)))


def test_a_painted_window_is_made_of_painted_tiles():
    tiling = aperiodic_tiling(aperiodic_tiles("ammann-16"), 1)
    pixels = paint_tiling(tiling, -7, 5, 30, 20, size=11)
    assert np.array_equal(pixels[33:66, 55:110], paint_tiling(tiling, -2, 8, 5, 3, size=11))
    assert paint_tiling(tiling, 0, 0, 400, 10).shape == (40, 1600, 3)
    assert paint_tiling(tiling, 0, 0, 10, 10).shape == (640, 640, 3)


@pytest.mark.parametrize("tiles", SETS, ids=lambda tiles: tiles.name)
def test_a_drawn_window_refers_to_its_tiles(tiles):
    tiling = direct(tiles, 3) if tiles.name != "jeandel-rao-36" else aperiodic_tiling(tiles)
    page = read(draw_tiling(tiling, 4, -5, 12, 7))
    drawn = {g.get("id"): g for g in page.iter(f"{SVG}g") if g.get("id")}
    rows = [[int(u.get("href")[2:]) for u in g.findall(f"{SVG}use")] for g in page.iter(f"{SVG}g")]
    assert np.array_equal([row for row in rows if row], tiling.indices(4, -5, 12, 7))
    assert set(drawn) == {f"t{tile}" for row in rows for tile in row}
    for name, group in drawn.items():
        fills = [path.get("fill") for path in group.findall(f"{SVG}path")][1:-1]
        assert fills == [color_of(int(c)) for c in tiles.slots[int(name[1:])]]


@pytest.mark.parametrize("tiles", SETS, ids=lambda tiles: tiles.name)
def test_a_sheet_holds_every_tile_with_its_numbers(tiles):
    page = read(draw_tiles(tiles))
    groups = [g for g in page.iter(f"{SVG}g") if g.get("transform")]
    numbers = [[int(t.text) for t in g.findall(f"{SVG}text")] for g in groups]
    assert numbers == [[*slots, tile] for tile, slots in enumerate(tiles.slots.tolist())]
    assert paint_tiles(tiles).shape[0] > 64
    assert len({g.get("transform") for g in groups}) == len(tiles)


def test_refusals():
    with pytest.raises(TilewrightError, match="set has 4096 tiles; up to 2048 are drawn"):
        draw_tiles(crossed_wang_tiles(2))
    tiling = direct(wang_tiles(2))
    for make in (draw_tiling, paint_tiling):
        with pytest.raises(TilewrightError, match="width is 0"):
            make(tiling, 0, 0, 0, 5)
        with pytest.raises(TilewrightError, match="too many"):
            make(tiling, 0, 0, 20000, 100000)
        with pytest.raises(TilewrightError, match="square tiles, not of domino"):
            make(direct(dominoes(2)), 0, 0, 5, 5)
        with pytest.raises(TilewrightError, match="tiling must be a Tiling"):
            make(wang_tiles(2))
    with pytest.raises(TilewrightError, match="size is 0"):
        paint_tiling(tiling, size=0)
    with pytest.raises(TilewrightError, match="tiles must be a TileSet"):
        draw_tiles("kari-14")


# --- The command --------------------------------------------------------------------------------------


def test_the_command_lists_the_sets(capsys):
    call("--json")
    listed = json.loads(capsys.readouterr().out)["sets"]
    assert [s["name"] for s in listed] == list(APERIODIC_SETS)
    assert {"shape": "corner", "tiles": 31, "colors": 4}.items() <= listed[8].items()
    call()
    assert capsys.readouterr().out.count("\n") == len(APERIODIC_SETS)


def test_the_command_writes_what_the_functions_make(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    tiling = aperiodic_tiling(aperiodic_tiles("kari-14"), 3)
    call("kari-14", "--x", 10**12, "--width", 9, "--height", 8, "--seed", 3)
    assert (tmp_path / "kari-14.svg").read_text() == draw_tiling(tiling, 10**12, 0, 9, 8)
    call("kari-14", "-o", "a.png", "--width", 9, "--height", 8, "--seed", 3)
    assert np.array_equal(tw.read_image(tmp_path / "a.png"), paint_tiling(tiling, 0, 0, 9, 8))
    call("kari-14", "-o", "a.npy", "--to", "vertical", "--y", -4, "--seed", 3)
    cells = translated_tiling(tiling, "vertical").indices(0, -4, 40, 30)
    assert np.array_equal(np.load(tmp_path / "a.npy"), cells)
    call("kari-14", "--set")
    assert (tmp_path / "kari-14-tiles.svg").read_text() == draw_tiles(tiling.tiles)
    capsys.readouterr()
    call("kari-14", "--set", "--to", "rotation", "-o", "b.npy", "--json")
    said = json.loads(capsys.readouterr().out)
    assert (said["tiles"], said["colors"], said["sound"], said["file"]) == (94, 9, True, "b.npy")
    assert np.array_equal(np.load(tmp_path / "b.npy"), as_corner_tiles(tiling.tiles, "rotation").slots)


def test_the_command_finds_periods_or_proves_that_there_are_none(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    call("lagae-44", "--period", 5, 5, "--json")
    assert json.loads(capsys.readouterr().out)["period"] == [2, 3]
    call("kari-14", "--period", 4, 4)
    assert "tile no torus of up to 4 x 4 cells; this is proven" in capsys.readouterr().out
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", TilewrightWarning)
        call("ammann-16", "--to", "horizontal", "--period", 3, 3)
    assert "period 2 x 3" in capsys.readouterr().out
    assert sorted(p.name for p in tmp_path.iterdir()) == ["ammann-16-horizontal.svg", "lagae-44.svg"]


def test_the_command_tiles_with_a_set_of_ones_own(tmp_path, capsys):
    own, out = tmp_path / "own.csv", tmp_path / "a.npy"
    own.write_text("0, 1, 1, 0\n1, 0, 0, 1\n")
    call(own, "-o", out, "--width", 6, "--height", 5)
    x, y = np.meshgrid(range(6), range(5))
    assert np.load(out).shape == (5, 6)
    assert len(np.unique((np.load(out) + x + y) % 2)) == 1
    np.save(tmp_path / "corners.npy", corner_tiles(2).slots)
    call(tmp_path / "corners.npy", "--shape", "corner", "--set", "-o", tmp_path / "b.svg", "--json")
    assert '"tiles": 16' in capsys.readouterr().out


@pytest.mark.parametrize(
    ("written", "arguments", "message"),
    [
        (None, ["nonesuch"], "NAME is 'nonesuch'; allowed are culik-13"),
        (None, ["penrose-32"], "only its size is known here"),
        (None, ["kari-14", "-o", "a.txt"], "which ends in '.txt'; allowed are .svg, .pdf, .dxf, .png, .npy"),
        (None, ["kari-14", "--to", "sideways"], "construction is 'sideways'"),
        (None, ["culik-13", "--to", "horizontal"], "horizontal translation fails"),
        (None, ["kari-14", "--period", 0, 4], "width is 0; allowed are 1 to 64"),
        (None, ["none.csv"], "none.csv does not exist"),
        ("a,b", ["own.csv"], "own.csv does not hold a table of whole numbers"),
        ("0,0,0", ["own.csv"], r"slots has shape \(1, 3\); wang tiles need"),
        ("0,0,0,0\n0,0,0,0", ["own.csv"], "the own set holds a tile twice"),
        ("0,0,0,1", ["own.csv"], "no tiling of a rectangle of 40 x 30 cells; this is proven"),
        ("0,0,0,0", ["own.csv", "--shape", "round"], "shape is 'round'"),
    ],
)  # fmt: skip
def test_refusals_leave_nothing_behind(tmp_path, monkeypatch, written, arguments, message):
    monkeypatch.chdir(tmp_path)
    if written is not None:
        (tmp_path / "own.csv").write_text(written)
    with pytest.raises(TilewrightError, match=message) as refused:
        call(*arguments)
    assert "\n" not in str(refused.value)
    assert [p.name for p in tmp_path.iterdir()] == ["own.csv"] * (written is not None)
