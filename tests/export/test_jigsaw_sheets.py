"""Puzzles cut apart: every cut half a kerf outside its piece, nothing too close, all on the sheets."""

import re
from itertools import combinations
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image

import tilewright as tw
from commands import call
from tilewright.errors import TilewrightError
from tilewright.export.drawing.sheets import widened

SVG = "{http://www.w3.org/2000/svg}"
BOARDS = {
    "wang 2": tw.packing(tw.wang_tiles(2)),
    "wang 3": tw.packing(tw.wang_tiles(3)),
    "wang 4": tw.packing(tw.wang_tiles(4)),
    "corner 4": tw.packing(tw.corner_tiles(4)),
}

pytestmark = pytest.mark.filterwarnings("ignore:the frame")


def away(points, line):
    """The distance of each point from a closed line."""
    side = np.roll(line, -1, axis=0) - line
    along = np.clip(((points[:, None] - line) * side).sum(-1) / (side**2).sum(-1), 0, 1)
    return np.hypot(*(points[:, None] - line - along[..., None] * side).T).min(axis=0)


def area(line):
    x, y = line.T
    return (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def cuts(drawing):
    """The closed lines of the layer of cuts."""
    group = next(g for g in ElementTree.fromstring(drawing).iter(f"{SVG}g") if g.get("id") == "cut")
    return [np.array(re.findall(r"[-\d.]+", p.get("d")), float).reshape(-1, 2) for p in group]


@pytest.mark.parametrize("board", BOARDS)
@pytest.mark.parametrize("kerf", [0.15, 0.6])
def test_a_cut_keeps_half_a_kerf_from_its_piece(board, kerf):
    puzzle = tw.Jigsaw(BOARDS[board], 30)
    rows = range(0, puzzle.height, max(1, puzzle.height // 4))
    lines = [puzzle.outline(x, y) for x in range(min(2, puzzle.width)) for y in rows]
    for line, by in [*((line, kerf / 2) for line in lines), (puzzle.board, -kerf / 2), (puzzle.frame, 0.1)]:
        cut = widened(line, by)
        middles = (cut + np.roll(cut, -1, axis=0)) / 2
        assert np.allclose(away(middles, line), abs(by), atol=0.01)  # no side is turned round or too close
        assert (away(cut, line) > abs(by) - 1e-9).all()
        assert np.sign(area(cut) - area(line)) == np.sign(by)
        assert area(line) > 0


def test_pieces_that_are_burned_have_their_nominal_area():
    puzzle = tw.Jigsaw(BOARDS["wang 3"], 20)
    drawing = tw.draw_jigsaw_sheets(BOARDS["wang 3"], piece=20, kerf=0.3)[0]
    board = [puzzle.outline(x, y) for y in range(9) for x in range(9)]
    for line, cut in zip(board, cuts(drawing), strict=False):
        assert abs(area(widened(cut, -0.15)) - area(line)) < 0.1  # of 400 mm2
    hole, frame = cuts(drawing)[-2:]
    assert 0.1 < area(puzzle.board) - area(hole) < 0.3 * 9 * 20 * 4
    assert area(frame) > area(puzzle.frame)


@pytest.mark.parametrize("sheet", [None, (300, 200), (100, 90)])
def test_all_is_cut_once_on_the_sheets_and_apart(sheet):
    drawings = tw.draw_jigsaw_sheets(BOARDS["wang 2"], piece=30, kerf=0.2, sheet=sheet)
    found = 0
    for drawing in drawings:
        root = ElementTree.fromstring(drawing)
        width, height = (float(n) for n in root.get("viewBox").split()[2:])
        assert root.get("width") == f"{width:g}mm" or sheet is None
        assert sheet is None or (width, height) == sheet
        lines = cuts(drawing)
        parts = [line for line in lines if np.ptp(line, axis=0).max() < 60]
        found += len(lines)
        for line in lines:
            assert line.min() > 1.99
            assert (line < (width - 1.99, height - 1.99)).all()
        for one, other in combinations(parts, 2):
            low, high = np.maximum(one.min(0), other.min(0)), np.minimum(one.max(0), other.max(0))
            assert (low - high).max() > 1.99
    assert found == (18 if sheet != (100, 90) else 16)  # with the frame, of two lines, where it fits
    assert len(drawings) == {None: 1, (300, 200): 2, (100, 90): 4}[sheet]


def test_a_frame_that_no_sheet_holds_is_told():
    with pytest.warns(tw.TilewrightWarning, match="the frame, .* mm, is larger than a sheet and left out"):
        tw.draw_jigsaw_sheets(BOARDS["wang 2"], sheet=(100, 90))


def test_pictures_and_engravings_go_with_their_piece(tmp_path):
    pdfium = pytest.importorskip("pypdfium2")
    x, y = np.meshgrid(np.arange(156), np.arange(156))
    picture = np.stack([x, y, 0 * x], axis=-1).astype(np.uint8)
    Image.fromarray(picture).save(tmp_path / "p.png")
    board = BOARDS["wang 2"]
    sheets = tw.draw_jigsaw_sheets(board, piece=30, kerf=0.2, picture=tmp_path / "p.png")
    path = tw.save_drawing(tmp_path / "j.pdf", sheets)
    page = pdfium.PdfDocument(path)[0]
    pixels = np.asarray(page.render(scale=72 / 25.4 * 2 / 72 * 25.4).to_pil().convert("RGB")).astype(int)
    scale = 2 * 72 / 25.4
    puzzle = tw.Jigsaw(board, 30)
    for n, cut in enumerate(cuts(sheets[0])[:16]):
        moved = cut[:1] - widened(puzzle.outline(n % 4, n // 4), 0.1)[:1]
        at = (np.array([n % 4, n // 4]) + 0.6 + (0.5, 0.4)) * 30
        column, row = ((at + moved[0]) * scale).astype(int)
        assert np.abs(pixels[row, column, :2] - at).max() < 2.5
    numbers = tw.draw_jigsaw_sheets(board, engrave="numbers", sheet=(100, 100))
    said = sorted(int(n) for sheet in numbers for n in re.findall(r">(\d+)</text>", sheet))
    assert said == list(range(16))
    colors = tw.draw_jigsaw_sheets(BOARDS["corner 4"], engrave="colors", sheet=(900, 900))
    assert all(sheet.count("clip-path=") == sheet.count("<clipPath") for sheet in colors)


def test_the_command_numbers_sheets_and_keeps_what_is_there(tmp_path):
    words = ("pack", "--tiles", "wang", "--kerf", 0.15, "--sheet", 100, 90)
    call(*words, "-o", tmp_path / "j.svg")
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"j-{n}.svg" for n in range(1, 5)]
    wanted = tw.draw_jigsaw_sheets(BOARDS["wang 2"], kerf=0.15, sheet=(100, 90))
    assert [(tmp_path / f"j-{n}.svg").read_text() for n in range(1, 5)] == wanted
    (tmp_path / "j-1.svg").unlink()
    with pytest.raises(TilewrightError, match=r"j-2\.svg is there already"):
        call(*words, "-o", tmp_path / "j.svg")
    assert not (tmp_path / "j-1.svg").exists()
    call(*words, "-o", tmp_path / "j.svg", "--force")
    call(*words, "-o", tmp_path / "j.pdf")
    pages = pytest.importorskip("pypdf").PdfReader(tmp_path / "j.pdf").pages
    assert [round(float(page.mediabox.width) * 25.4 / 72, 3) for page in pages] == [100] * 4
    call("pack", "--kerf", 0.1, "-o", tmp_path / "one.dxf", "--engrave", "numbers")
    assert (tmp_path / "one.dxf").exists()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--kerf", 1), "--kerf is 1 mm; the tabs of a piece of 30 mm allow 0 to 0.6: make larger pieces"),
        (("--kerf", -0.1), "--kerf"),
        (("--sheet", 30, 300), "--sheet is 30 x 300 mm; a piece with its tabs and 2 mm around it needs"),
        (("--kerf", 0.1, "--engrave", "colors", "-o", "a.dxf"), "take numbers, or name a FILE.pdf"),
        (("--kerf", 0.1, "-o", "a.png"), "--kerf is about the pieces of a puzzle"),
    ],
)
def test_what_cannot_be_cut_is_said_in_one_line(tmp_path, monkeypatch, words, said):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(TilewrightError, match=re.escape(said)):
        call("pack", *(() if "-o" in words else ("-o", "a.svg")), *words)
    assert not list(tmp_path.iterdir())
