"""The command that makes dappled tilings, and their pictures."""

import json
import re
from xml.etree import ElementTree

import numpy as np
import pytest

import commands
import tilewright as tw
from tilewright.errors import TilewrightError
from tilewright.export.drawing.cells import draw_cells, paint_cells
from tilewright.files import read_image, write_image
from tilewright.tilings.dappled import Conditions, find_violations

PAPER = {"H0": 2, "V1": 2}


def call(*arguments):
    commands.call("dapple", *arguments)


@pytest.fixture
def made(tmp_path, capsys):
    """The tiling that the command writes, and what it reports."""

    def make(*arguments):
        call("-o", tmp_path / "cells.npy", "--force", "--json", *arguments)
        return np.load(tmp_path / "cells.npy"), json.loads(capsys.readouterr().out)

    return make


def is_dappled(cells, limits, **options):
    return not any(bad.any() for bad in find_violations(cells, limits, **options).values())


def test_a_random_start_is_made_dappled(made):
    cells, said = made("--width", 30, "--height", 20, "--share", 1, "--share", 3, "--seed", 5)
    start = tw.random_start(30, 20, (1, 3), 5)
    assert is_dappled(cells, PAPER)
    assert said["changed"] == (cells != start).sum()
    assert said["violations"] == sum(bad.sum() for bad in find_violations(start, PAPER).values())
    assert said["shares"][1] == pytest.approx(cells.mean(), abs=1e-4)


def test_limits_of_subsets_and_of_more_tiles(made):
    limits = {"H0": np.inf, "V1": 1, "H0+2": 3}
    given = [part for limit in ("H0=inf", "V1=1", "H0+2=3") for part in ("--limit", limit)]
    cells, said = made("--width", 24, "--height", 18, "--tiles", 4, "--cyclic", *given)
    assert is_dappled(cells, limits, cyclic=True, tiles=4)
    assert said["tiles"] == 4
    assert set(np.unique(cells)) == {0, 1, 2, 3}


def test_a_picture_is_followed_in_its_own_proportions(made, tmp_path):
    shade = np.rint(np.linspace(0, 255, 80)).astype(np.uint8)
    write_image(tmp_path / "ramp.png", np.tile(shade, (40, 1))[..., None])
    cells, _ = made("--input", tmp_path / "ramp.png", "--dither", "--width", 60, "--limit", "H0=9")
    assert cells.shape == (30, 60)
    west, middle, east = cells[:, :20].mean(), cells[:, 20:40].mean(), cells[:, 40:].mean()
    assert west < 0.3 < middle < 0.7 < east


def test_dithered_tones_are_those_that_limits_allow(made, tmp_path):
    limits = Conditions({"H0": 4, "V0": 9, "H1": 2})
    for tiles, darkest, lightest in ((2, 1 / 5, 2 / 3), (3, 2 * 1 / 10, 2)):
        # Of three tiles, the others of a line may all be the middle one.
        for tone, share in ((0, darkest), (1, lightest)):
            flat = np.full((60, 60), tone, np.float32)
            start = tw.start_from_image(flat, 60, 60, tiles, dither=True, limits=Conditions(limits, tiles))
            assert start.mean() == pytest.approx(share, abs=0.01)
    shade = np.tile(np.array([0, 255], np.uint8).repeat(30), (40, 1))[..., None]
    write_image(tmp_path / "halves.png", shade)
    cells, said = made("--input", tmp_path / "halves.png", "--dither", "--width", 60)
    assert said["changed"] < 0.15 * cells.size
    assert cells[:, 30:].mean() - cells[:, :30].mean() > 0.2


def test_the_closest_tiling_changes_no_more_than_the_first(made):
    size = ("--width", 20, "--height", 16, "--cyclic")
    first, swept = made(*size)
    closest, best = made("--closest", *size)
    assert is_dappled(closest, PAPER, cyclic=True)
    assert best["distance"] == best["bound"] == best["changed"] < swept["changed"]
    assert best["gap"] == 0
    assert not np.array_equal(first, closest)


def test_endless_windows_agree(made):
    limits = ("--limit", "H1=2", "--limit", "V0=3", "--share", 0.4, "--share", 0.1, "--endless")
    large, _ = made("-x", 10**12, "-y", -40, "--width", 50, "--height", 60, *limits)
    small, said = made("-x", 10**12 + 7, "-y", -1, "--width", 9, "--height", 8, *limits)
    assert np.array_equal(small, large[39:47, 7:16])
    assert is_dappled(large, {"H1": 2, "V0": 3})
    assert large.mean() < 0.45
    assert (said["x"], said["y"]) == (10**12 + 7, -1)


def test_pins_stay_or_the_guilty_ones_are_named(made, tmp_path):
    pins = np.full((8, 10), -1)
    pins[2, 3:5] = 0
    np.save(tmp_path / "pins.npy", pins)
    cells, said = made("--pins", tmp_path / "pins.npy")
    assert is_dappled(cells, PAPER)
    assert np.array_equal(cells[pins >= 0], pins[pins >= 0])
    assert said["pinned"] == 2
    pins[2, 5] = pins[7, 0] = 0
    np.save(tmp_path / "pins.npy", pins)
    (tmp_path / "cells.npy").unlink()
    with pytest.raises(TilewrightError, match=r"\(x=3, y=2\) = 0, \(x=4, y=2\) = 0, \(x=5, y=2\) = 0; this"):
        made("--pins", tmp_path / "pins.npy")
    assert not (tmp_path / "cells.npy").exists()


def test_tilings_are_counted(capsys):
    call("--count", "--width", 5, "--height", 5)
    assert capsys.readouterr().out == "516724\n"
    call("--count", "--width", 1, "--height", 3, "--tiles", 3, "--json")
    assert json.loads(capsys.readouterr().out)["count"] == 26


def test_clauses_hold_for_dappled_tilings(tmp_path, capsys):
    call("-o", tmp_path / "f.cnf", "--width", 7, "--height", 5, "--json")
    lines = (tmp_path / "f.cnf").read_text().splitlines()
    clauses = [[int(word) for word in line.split()[:-1]] for line in lines[2:]]
    said = json.loads(capsys.readouterr().out)
    assert lines[1] == f"p cnf {said['variables']} {said['clauses']}" == f"p cnf 35 {len(clauses)}"
    for seed in range(20):
        cells = tw.random_start(7, 5, seed=seed)
        cells = cells if seed % 2 else tw.dapple(cells, PAPER)
        true = {n + 1 if tile else -n - 1 for n, tile in enumerate(cells.ravel().tolist())}
        assert all(true & set(clause) for clause in clauses) == is_dappled(cells, PAPER)


def test_pictures_show_the_tiles(tmp_path, capsys):
    colors = ["#102030", "#fFeedd", "#008800"]
    sizes = ("--width", 9, "--height", 7, "--tiles", 3, "--cell", 5)
    call("-o", tmp_path / "a.png", *sizes, "--colors", ",".join(colors))
    call("-o", tmp_path / "a.npy", *sizes[:-2])
    pixels, cells = read_image(tmp_path / "a.png"), np.load(tmp_path / "a.npy")
    palette = np.array([list(bytes.fromhex(color[1:])) for color in colors])
    assert np.array_equal(pixels, palette[cells].repeat(5, axis=0).repeat(5, axis=1))
    assert "changed" in capsys.readouterr().out


def test_drawn_rectangles_cover_each_cell_once():
    cells = np.random.default_rng(3).integers(0, 3, (12, 17))
    page = ElementTree.fromstring(draw_cells(cells, colors=["#000000", "#000001", "#000002"]))
    ground, *paths = page[0]
    drawn = np.full(cells.shape, int(ground.get("fill")[1:]))
    touched = np.zeros(cells.shape, int)
    count = 0
    for path in paths:
        for part in re.findall(r"M(\d+) (\d+)h(\d+)v(\d+)H\1Z", path.get("d")):
            x, y, width, height = map(int, part)
            drawn[y : y + height, x : x + width] = int(path.get("fill")[1:])
            touched[y : y + height, x : x + width] += 1
            count += 1
    assert np.array_equal(drawn, cells)
    assert touched.max() == 1
    assert count < (cells != int(ground.get("fill")[1:])).sum()


def test_arcs_and_strokes_join_what_they_should():
    black = {"size": 40, "colors": ["#000000", "#ffffff"]}
    arcs = paint_cells([[0, 1], [1, 0]], motif="arcs", **black)[..., 0]
    # A circle about the middle: dark at half a cell from it, light inside.
    away = np.hypot(*(np.indices(arcs.shape) - 39.5))
    assert arcs[np.abs(away - 20) < 3].max() == 0
    assert arcs[away < 14].min() == 255
    strokes = paint_cells([[0, 1]], motif="strokes", **black)[..., 0]
    assert np.array_equal(strokes, strokes[:, ::-1])
    assert strokes[np.arange(9, 31), np.arange(9, 31)].max() == 0
    assert strokes[:, [0, 39]].min() == 255


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--closest", "--endless"], "--closest has no use with --endless"),
        (["--count", "-o", "a.png"], "--output has no use with --count"),
        (["-o", "a.cnf", "--input", "a.png"], "--input has no use with a .cnf file"),
        (["-x", "3"], "--x is about --endless"),
        (["--dither"], "give --input"),
        (["--limit", "H0=2.5"], "allowed are 0, 1, 2"),
        (["--limit", "H0=2", "--limit", "H0=3"], "twice"),
        (["--limit", "H0=1", "--limit", "V1=2", "--endless"], "limits go down to 1"),
        (["--limit", "H0=0", "--limit", "H1=0"], "no tiling of 64 x 40 cells"),
        (["--width", "0"], "--width is 0"),
        (["--share", "1", "--tiles", "2"], "--share was given 1 times"),
        (["--colors", "#ff0000"], "the 2 tiles need 2"),
        (["--motif", "arcs", "--tiles", "3"], "arcs are of two tiles"),
        (["--pins", "missing.npy"], "missing.npy does not exist"),
        (["-o", "a.jpg"], "allowed are .png, .svg, .pdf, .dxf, .npy, .cnf"),
    ],
)
def test_what_cannot_be_is_refused_in_a_line(arguments, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(TilewrightError) as refused:
        call(*arguments)
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)
    assert not any(tmp_path.iterdir())
