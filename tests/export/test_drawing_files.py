"""Drawings as PDF and DXF, read back by other programs: true size, the same shapes, layers kept apart."""

import re
from itertools import pairwise

import numpy as np
import pytest
from PIL import Image

import commands
import tilewright as tw
from tilewright.errors import TilewrightError
from tilewright.export.drawing.dxf import _indexed, nearest_index
from tilewright.export.drawing.outlines import clipped, without_seams
from tilewright.export.drawing.pdf import _curves
from tilewright.export.drawing.shapes import Path, Step, box, read_drawing

CELLS = tw.dapple(np.random.default_rng(1).integers(0, 2, (12, 16)), {"H0": 2, "V1": 2})
PUZZLE = tw.packing(tw.corner_tiles(2))


def dxf(path):
    """What ezdxf reads, which finds nothing to mend."""
    ezdxf = pytest.importorskip("ezdxf")
    document = ezdxf.readfile(path)
    assert not document.audit().has_errors
    return document


def lines(document, layer=None):
    """Points of all lines as (x, y), y north, in millimeters, arcs as many short ones."""
    from ezdxf.path import make_path

    return [
        np.array([(v.x, v.y) for v in make_path(entity).flattening(1e-4)])
        for entity in document.modelspace().query("POLYLINE")
        if layer in (None, entity.dxf.layer)
    ]


def painted(path, width, page=0):
    """A page of a PDF as pixels, by PDFium."""
    pdfium = pytest.importorskip("pypdfium2")
    sheet = pdfium.PdfDocument(path)[page]
    return np.asarray(sheet.render(scale=width / sheet.get_width()).to_pil().convert("RGB"))


def test_a_pdf_is_read_without_complaint_in_true_size_with_its_layers(tmp_path):
    pypdf = pytest.importorskip("pypdf")
    path = tw.save_drawing(tmp_path / "jig.pdf", tw.draw_jigsaw(PUZZLE, piece=25, engrave="colors"))
    reader = pypdf.PdfReader(path, strict=True)
    assert [float(side) for side in reader.pages[0].mediabox[2:]] == pytest.approx([130 * 72 / 25.4] * 2)
    layers = reader.trailer["/Root"]["/OCProperties"]["/OCGs"]
    assert [layer.get_object()["/Name"] for layer in layers] == ["picture", "engrave", "cut"]
    assert reader.metadata is None


def test_a_pdf_shows_what_is_drawn(tmp_path):
    colors = ["#10a020", "#f0e0d0"]
    drawings = [tw.draw_cells(CELLS, colors=colors), tw.draw_cells(CELLS, motif="arcs", colors=colors)]
    path = tw.save_drawing(tmp_path / "cells.pdf", drawings)
    wanted = tw.paint_cells(CELLS, colors=colors, size=40)
    inner = (np.indices(wanted.shape[:2]) % 40 // 2 % 19 > 0).all(0)
    assert (painted(path, 640)[inner] == wanted[inner]).all()
    arcs = tw.paint_cells(CELLS, colors=colors, motif="arcs", size=40).astype(int)
    assert np.abs(painted(path, 640, page=1) - arcs).mean() < 1.5


def test_a_tiling_in_a_pdf_looks_as_painted(tmp_path):
    tiling = tw.direct(tw.wang_tiles(3), seed=7)
    path = tw.save_drawing(tmp_path / "t.pdf", tw.draw_tiling(tiling, width=10, height=6))
    wanted = tw.paint_tiling(tiling, width=10, height=6, size=64).astype(int)
    assert np.abs(painted(path, 640) - wanted).mean() < 5


def test_a_region_of_bricks_is_cut_in_a_pdf(tmp_path):
    region = tw.brick_region([[1, 1], [1, 0]], seed=1)
    path = tw.save_drawing(tmp_path / "r.pdf", tw.draw_wall(region, 0, 0, 288, 96))
    pixels = painted(path, 288)
    assert (pixels[50:, 146:] == 255).all()
    assert pixels[:46].mean() < 200


def test_digits_stand_upright_in_the_middle_of_their_piece(tmp_path):
    path = tw.save_drawing(tmp_path / "n.pdf", tw.draw_jigsaw(PUZZLE, engrave="numbers"))
    ink = (painted(path, 1560) < 60).all(-1)
    ys, xs = np.nonzero(ink[180:480, 180:480])
    assert abs(xs.mean() - 0.54 * 300) < 3
    assert abs(ys.mean() - (0.6 - 0.15 * 0.36) * 300) < 6
    reader = pytest.importorskip("pypdf").PdfReader(path)
    assert sorted(int(n) for n in reader.pages[0].extract_text().split()) == list(range(16))


@pytest.mark.parametrize(("kind", "mode"), [("png", "RGBA"), ("jpg", "RGB"), ("jpg", "L")])
def test_a_picture_is_printed_upright_and_cropped(tmp_path, kind, mode):
    picture = Image.new(mode, (40, 80), {"RGBA": (0, 0, 255, 255), "RGB": (0, 0, 255), "L": 200}[mode])
    picture.paste({"RGBA": (255, 0, 0, 255), "RGB": (255, 0, 0), "L": 30}[mode], (0, 0, 40, 40))
    picture.save(tmp_path / f"p.{kind}", quality=100)
    drawing = tw.draw_jigsaw(PUZZLE, picture=tmp_path / f"p.{kind}")
    pixels = painted(tw.save_drawing(tmp_path / "p.pdf", drawing), 156).astype(int)
    top, bottom = (30, 200) if mode == "L" else ((255, 0, 0), (0, 0, 255))
    assert np.abs(pixels[63, 63] - top).max() < 6
    assert np.abs(pixels[93, 63] - bottom).max() < 6
    page = pytest.importorskip("pypdf").PdfReader(tmp_path / "p.pdf").pages[0]
    kept = page.images[0].image
    assert kept.size == (40, 80) and kept.getpixel((5, 5))[:1] != (0,) if mode != "L" else True


@pytest.mark.parametrize("turn", [0.3, -2.0, 3.1, -4.5, 6.0])
def test_curves_keep_to_their_arc(turn):
    start, radius = np.array([3.0, 4.0]), 50.0
    angle = 0.7
    center = start - radius * np.array([np.cos(angle), np.sin(angle)])
    end = center + radius * np.array([np.cos(angle + turn), np.sin(angle + turn)])
    here = start
    for curve in _curves(*start, Step("A", *end, radius, turn)):
        points = np.array([float(n) for n in curve.split()[:6]]).reshape(3, 2)
        t = np.linspace(0, 1, 50)[:, None]
        weights = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3)
        line = sum(w * p for w, p in zip(weights, (here, *points), strict=True))
        assert np.abs(np.hypot(*(line - center).T) - radius).max() < 5e-4
        here = points[-1]
    assert np.allclose(here, end, atol=1e-4)


def test_very_large_sheets_keep_their_size(tmp_path):
    drawing = tw.draw_cells([[0, 1]], size=512).replace('width="1024"', 'width="1000000"')
    page = pytest.importorskip("pypdf").PdfReader(tw.save_drawing(tmp_path / "a.pdf", drawing)).pages[0]
    width = float(page.mediabox.width)
    assert width <= 14400
    assert width * float(page["/UserUnit"]) == pytest.approx(750000)


def test_a_dxf_says_millimeters_and_holds_every_cut_of_a_puzzle(tmp_path):
    puzzle = tw.Jigsaw(PUZZLE, 25)
    document = dxf(tw.save_drawing(tmp_path / "jig.dxf", tw.draw_jigsaw(PUZZLE, piece=25, engrave="colors")))
    assert document.units == 4
    assert document.header["$MEASUREMENT"] == 1
    assert {entity.dxf.layer for entity in document.modelspace()} == {"cut", "engrave"}
    assert document.layers.get("cut").color == 1
    cuts = lines(document, "cut")
    for n in range(5):
        assert np.allclose(cuts[n], puzzle.row(n) * (1, -1) + (0, 130), atol=1e-3)
        assert np.allclose(cuts[5 + n], puzzle.column(n) * (1, -1) + (0, 130), atol=1e-3)
    frame = cuts[-1]
    assert frame.min() == pytest.approx(1.25)
    assert frame.max() == pytest.approx(128.75)
    disc = lines(document, "engrave")[0]
    assert np.allclose(np.hypot(*(disc - (15, 115)).T), 2.5, atol=0.01)


def test_arcs_in_a_dxf_are_arcs(tmp_path):
    document = dxf(
        tw.save_drawing(tmp_path / "a.dxf", tw.draw_cells([[0, 1], [1, 0]], motif="arcs", size=96))
    )
    found = [part for line in document.modelspace() for part in line.virtual_entities()]
    arcs = [part for part in found if part.dxftype() == "ARC"]
    assert len(arcs) == 8  # two quarters in each cell of an inch
    for arc in arcs:
        assert arc.dxf.radius == pytest.approx(12.7, abs=1e-4)
        assert np.allclose(np.array(arc.dxf.center) % 25.4 % 25.3999, 0, atol=2e-4)
        assert (arc.dxf.end_angle - arc.dxf.start_angle) % 360 == pytest.approx(90, abs=1e-4)


def test_numbers_in_a_dxf_stand_where_they_are_drawn(tmp_path):
    document = dxf(tw.save_drawing(tmp_path / "n.dxf", tw.draw_jigsaw(PUZZLE, engrave="numbers")))
    words = list(document.modelspace().query("TEXT"))
    cells = PUZZLE.indices(0, 0, 4, 4)
    for word in words:
        x, y = (int(n // 30) for n in (word.dxf.align_point.x - 18, 156 - word.dxf.align_point.y - 18))
        assert int(word.dxf.text) == cells[y, x]
    assert len(words) == 16
    assert words[0].dxf.layer == "engrave"


def test_a_color_has_the_layer_of_the_nearest_in_the_index(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    hues = {index: color for index, color in _indexed().items() if 10 <= index < 250}
    theirs = [ezdxf.colors.int2rgb(ezdxf.colors.DXF_DEFAULT_COLORS[index]) for index in hues]
    differ = (np.abs(np.array(list(hues.values())) - theirs) > 2).any(axis=1)
    assert differ.mean() < 0.1  # some of theirs leave the rule
    assert nearest_index("#ff0000") == 1
    assert nearest_index("#000000") == 7
    document = dxf(
        tw.save_drawing(tmp_path / "c.dxf", tw.draw_cells([[0, 1]], colors=["#0000ff", "#ff0000"]))
    )
    assert {entity.dxf.layer for entity in document.modelspace()} == {"color-5", "color-1"}


def test_areas_are_outlined_without_seams():
    cells = np.random.default_rng(2).integers(0, 2, (9, 11))
    area = read_drawing(tw.draw_cells(cells)).layers[0].items[1]
    tile = 1 - np.bincount(cells.ravel()).argmax()
    member = np.pad(cells == tile, 1)
    sides = {*zip(*np.nonzero(np.diff(member, axis=0)), strict=True)}
    uprights = {*zip(*np.nonzero(np.diff(member, axis=1)), strict=True)}
    found = []
    steps = without_seams(area)
    for before, after in pairwise(steps):
        if after.kind == "M":
            continue
        (west, east), (north, south) = sorted((before.x, after.x)), sorted((before.y, after.y))
        found += [(north, x + 1) for x in np.arange(west, east)]
        found += [(y + 1, west, "upright") for y in np.arange(north, south)]
    assert len(found) == len(set(found)) == len(sides) + len(uprights)
    assert {side for side in found if len(side) == 2} == sides
    assert {side[:2] for side in found if len(side) == 3} == uprights


def test_areas_that_touch_at_a_corner_stay_apart():
    steps = without_seams(Path(box(0, 0, 1, 1) + box(1, 1, 1, 1), "#000000", None, 1, False))
    assert sum(step.kind == "Z" for step in steps) == 2
    stroked = Path(box(0, 0, 1, 1) + box(1, 0, 1, 1), None, "#000000", 1, False)
    assert without_seams(stroked) == stroked.steps


def test_lines_end_where_a_region_does(tmp_path):
    region = box(0, 0, 2, 1) + box(3, 0, 1, 1)
    line = (Step("M", -1, 0.5), Step("L", 9, 0.5))
    ends = [(step.kind, step.x) for step in clipped(Path(line, None, "#000000", 1, False), region)]
    assert ends == [("M", 0), ("L", 2), ("M", 3), ("L", 4)]
    region = tw.brick_region([[1, 1], [1, 0]], seed=1)
    drawing = tw.draw_wall(region, 0, 0, 288, 96, mode="lines")
    found = lines(dxf(tw.save_drawing(tmp_path / "r.dxf", drawing)))
    mm = 25.4 / 96
    assert all((line[:, 0] < 144.01 * mm).all() or (line[:, 1] > 47.9 * mm).all() for line in found)
    with pytest.raises(TilewrightError, match="cannot cut bricks"):
        tw.save_drawing(tmp_path / "b.dxf", tw.draw_wall(region, 0, 0, 288, 96))
    assert [path.name for path in tmp_path.iterdir()] == ["r.dxf"]


@pytest.mark.parametrize("suffix", ["pdf", "dxf"])
def test_the_same_drawing_gives_the_same_bytes(tmp_path, suffix):
    drawing = tw.draw_tiles(tw.corner_tiles(2))
    first, second = (tw.save_drawing(tmp_path / f"{n}.{suffix}", drawing).read_bytes() for n in "ab")
    assert first == second


@pytest.mark.parametrize(
    ("words", "name"),
    [
        (("dapple", "--width", 9, "--height", 7, "--motif", "strokes"), "d"),
        (("bricks", "--width", 3, "--height", 4, "--lines"), "w"),
        (("aperiodic", "kari-14", "--width", 5, "--height", 4), "a"),
        (("aperiodic", "kari-14", "--set"), "s"),
        (("pack", "--engrave", "numbers"), "j"),
    ],
)
def test_commands_write_all_kinds_of_drawings(tmp_path, words, name):
    for suffix in ("svg", "pdf", "dxf"):
        commands.call(*words, "-o", tmp_path / f"{name}.{suffix}")
    assert (tmp_path / f"{name}.pdf").read_bytes()[:5] == b"%PDF-"
    box_ = dxf(tmp_path / f"{name}.dxf").header["$EXTMAX"]
    sheet = read_drawing((tmp_path / f"{name}.svg").read_text())
    assert box_[:2] == pytest.approx((sheet.width * sheet.unit, sheet.height * sheet.unit), abs=1e-3)
    assert painted(tmp_path / f"{name}.pdf", 100).std() > 1


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("pack", "-o", "j.dxf", "--picture", "p.png"), "--picture has no use with a .dxf file"),
        (("pack", "-o", "j.png", "--engrave", "colors"), "give it with a FILE.svg, .pdf or .dxf"),
        (("bricks", "-o", "w.dxf", "--mask", "m.png"), "give --lines, or name a FILE.pdf"),
        (("bricks", "-o", "w.png", "--lines"), "name a FILE.svg, .pdf or .dxf"),
        (("dapple", "-o", "d.eps"), "allowed are .png, .svg, .pdf, .dxf, .npy, .cnf"),
        (("aperiodic", "kari-14", "-o", "d.eps"), "allowed are .svg, .pdf, .dxf, .png, .npy"),
    ],
)
def test_what_cannot_be_drawn_is_said_before_the_work(tmp_path, monkeypatch, words, said):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(TilewrightError, match=re.escape(said)):
        commands.call(*words)
    assert not list(tmp_path.iterdir())


def test_wrong_drawings_are_refused(tmp_path):
    drawing = tw.draw_cells([[0, 1]])
    for path, given, said in (
        ("a.eps", drawing, "allowed are .svg, .pdf, .dxf"),
        ("a.dxf", [drawing, drawing], "only a .pdf has pages"),
        ("a.pdf", [], "must be the text of an SVG file"),
        ("a.pdf", [drawing, 1], "must be the text of an SVG file"),
    ):
        with pytest.raises(TilewrightError, match=said):
            tw.save_drawing(tmp_path / path, given)
    assert not list(tmp_path.iterdir())
