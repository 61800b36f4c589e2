"""Jigsaw puzzles: pieces fit where colors agree and nowhere else, and nothing is cut twice or too thin."""

import base64
import io
import re
from collections import Counter
from itertools import pairwise, product
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image

import tilewright as tw
from tilewright.cli.main import run
from tilewright.export.drawing.jigsaw import Jigsaw, draw_jigsaw
from tilewright.tilings.packings.recursion import recursive_packing
from tilewright.tilings.packings.search import random_packing

SVG = "{http://www.w3.org/2000/svg}"
BOARDS = {
    "wang 2": random_packing(tw.wang_tiles(2), seed=1),
    "corner 2": random_packing(tw.corner_tiles(2)),
    "wang 2 x 3": random_packing(tw.wang_tiles(2, 3)),
    "wang 4": tw.packing(tw.wang_tiles(4)),
    "corner 4": recursive_packing(tw.corner_tiles(4)),
}
PIECE = 30
CLEAR = 0.08 * PIECE
"""What keeps wrong pieces apart, in mm: far more than the 0.2 mm a laser burns away."""


@pytest.fixture(params=BOARDS)
def puzzle(request):
    return Jigsaw(BOARDS[request.param], PIECE)


def sides(puzzle):
    """The different sides that pieces have: name, colors and points relative to the side's first corner."""
    found = {}
    for y, x in product(range(puzzle.height), range(puzzle.width)):
        slots = puzzle.tiling.tiles.slots_of(puzzle.tiling.indices(x, y, 1, 1))[0, 0]
        at = (np.array([x, y]) + 0.6) * PIECE
        ends = {"N": (0,), "E": (1,), "S": (2,), "W": (3,)}
        if puzzle.tiling.tiles.shape.name == "corner":
            ends = {"N": (3, 0), "E": (0, 1), "S": (2, 1), "W": (3, 2)}
        for name, down, dx, dy in (("N", 0, 0, 0), ("E", 1, 1, 0), ("S", 0, 0, 1), ("W", 1, 0, 0)):
            colors = tuple(int(slots[slot]) for slot in ends[name])
            line = puzzle.edge(x + dx, y + dy, bool(down)) - at - (dx * PIECE, dy * PIECE)
            known = found.setdefault((name, colors), line)
            assert np.allclose(known, line, atol=1e-9)
    return found


def dense(line, step=0.3):
    """Points along a line, at most ``step`` apart."""
    parts = [np.linspace(a, b, max(2, int(np.hypot(*(b - a)) / step) + 2))[:-1] for a, b in pairwise(line)]
    return np.concatenate([*parts, line[-1:]])


def apart(one, other, step=0.5):
    """The Hausdorff distance between two lines."""
    gaps = np.hypot(*(dense(one, step)[:, None] - dense(other, step)).transpose(2, 0, 1))
    return max(gaps.min(axis=0).max(), gaps.min(axis=1).max())


def test_sides_fit_exactly_where_their_colors_agree(puzzle):
    found = sides(puzzle)
    for facing in ("SN", "EW"):
        ours = {c: line for (name, c), line in found.items() if name == facing[0]}
        theirs = {c: line for (name, c), line in found.items() if name == facing[1]}
        assert ours.keys() == theirs.keys()
        for (a, one), (b, other) in product(ours.items(), theirs.items()):
            assert (apart(one, other) < 1e-9) if a == b else (apart(one, other) > CLEAR)


def test_no_tab_goes_into_the_hole_of_another_color():
    tabs = [line for (name, _), line in sorted(sides(Jigsaw(BOARDS["wang 4"], PIECE)).items()) if name == "N"]
    for a, b in product(range(4), repeat=2):
        outside = [p for p in dense(tabs[a]) if p[1] > 1 and not inside(p, tabs[b])]
        deep = [p for p in outside if np.hypot(*(dense(tabs[b]) - p).T).min() > CLEAR / 2]
        assert (len(deep) > 0) == (a != b)


def inside(point, line):
    """Whether a point lies between a tab and the straight line from its first end to its last."""
    (x, y), a, b = point, line, np.roll(line, -1, axis=0)
    spans = (a[:, 1] > y) != (b[:, 1] > y)
    crossings = a[spans, 0] + (y - a[spans, 1]) / (b[spans, 1] - a[spans, 1]) * (b[spans, 0] - a[spans, 0])
    return np.count_nonzero(crossings > x) % 2 == 1


@pytest.mark.parametrize("board", ["wang 4", "corner 2"])
def test_a_turned_piece_fits_nowhere(board):
    found = sides(Jigsaw(BOARDS[board], PIECE))
    kinds = {n: [line for (name, _), line in found.items() if name == n] for n in "NESW"}
    assert all(line[:, 1].max() > 0.15 * PIECE for line in kinds["S"])
    assert all(line[:, 0].max() > 0.15 * PIECE for line in kinds["E"])
    for quarters in (1, 2, 3):
        misfits = 0
        for at, name in enumerate("NESW"):
            # Clockwise, x and y become -y and x; then its first end is to be at (0, 0) again.
            turned = [line @ np.linalg.matrix_power([[0, 1], [-1, 0]], quarters) for line in kinds[name]]
            turned = [line - np.minimum(line[-1], 0) for line in turned]
            beside = kinds["NESW"[(at + quarters) % 4]]
            misfits += all(apart(a, b, step=2) > CLEAR for a, b in product(turned, beside))
        assert misfits >= 2


def test_outlines_do_not_cross_themselves_and_have_no_thin_necks(puzzle):
    step = max(1, puzzle.width * puzzle.height // 32)
    for number in range(0, puzzle.width * puzzle.height, step):
        outline = puzzle.outline(number % puzzle.width, number // puzzle.width)
        assert not crosses_itself(outline)
        points = dense(np.concatenate([outline, outline[:1]]), 0.4)[:-1]
        length = np.hypot(*(np.roll(points, -1, axis=0) - points).T)
        along = np.concatenate([[0], np.cumsum(length)[:-1]])
        way = np.abs(along[:, None] - along)
        way = np.minimum(way, length.sum() - way)
        gap = np.hypot(*(points[:, None] - points).transpose(2, 0, 1))
        # A neck: near across, far along the border.
        assert gap[way > 2.5 * gap].min() > 0.12 * PIECE


def crosses_itself(outline):
    a, b = outline, np.roll(outline, -1, axis=0)

    def side(p, q, r):
        return np.sign((q - p)[..., 0] * (r - p)[..., 1] - (q - p)[..., 1] * (r - p)[..., 0])

    here = side(a[:, None], b[:, None], a[None]) * side(a[:, None], b[:, None], b[None])
    crossing = (here < 0) & (here.T < 0)
    return bool(crossing.any())


def test_a_crossing_is_seen():
    assert crosses_itself(np.array([(0.0, 0), (1, 1), (1, 0), (0, 1)]))
    assert not crosses_itself(np.array([(0.0, 0), (1, 0), (1, 1), (0, 1)]))


def segments(line):
    ends = np.round(line, 3)
    return [frozenset(map(tuple, pair)) for pair in np.stack([ends[:-1], ends[1:]], axis=1).tolist()]


def test_every_line_is_cut_once_and_bounds_the_pieces(puzzle):
    drawing = ElementTree.fromstring(draw_jigsaw(puzzle.tiling, piece=PIECE))
    cut = next(g for g in drawing.iter(f"{SVG}g") if g.get("id") == "cut")
    assert cut.get("stroke") == "#ff0000"
    cuts = Counter()
    for path in cut.iter(f"{SVG}path"):
        numbers = np.array(re.findall(r"-?[\d.]+", path.get("d")), float)
        cuts.update(segments(numbers.reshape(-1, 2)))
    assert set(cuts.values()) == {1}
    borders = Counter()
    for y, x in product(range(puzzle.height), range(puzzle.width)):
        outline = puzzle.outline(x, y)
        borders.update(segments(np.concatenate([outline, outline[:1]])))
    assert cuts.keys() == borders.keys()
    around = [puzzle.row(0), puzzle.row(puzzle.height), puzzle.column(0), puzzle.column(puzzle.width)]
    outer = {segment for line in around for segment in segments(line)}
    assert all(count == (1 if segment in outer else 2) for segment, count in borders.items())


def test_the_board_continues_itself(puzzle):
    down, right = np.diag([puzzle.width, puzzle.height])[::-1] * PIECE
    assert np.allclose(puzzle.row(0) + down, puzzle.row(puzzle.height))
    assert np.allclose(puzzle.column(0) + right, puzzle.column(puzzle.width))


def test_the_drawing_is_in_millimeters_and_in_layers():
    drawing = ElementTree.fromstring(draw_jigsaw(BOARDS["corner 2"], piece=25, engrave="numbers"))
    assert drawing.get("width") == drawing.get("height") == "130mm"
    assert drawing.get("viewBox") == "0 0 130 130"
    assert [g.get("id") for g in drawing] == ["picture", "engrave", "cut"]
    numbers = [int(mark.text) for mark in drawing.iter(f"{SVG}text")]
    assert numbers == BOARDS["corner 2"].cells.ravel().tolist()


def test_colors_are_engraved_where_pieces_share_them():
    for name, mark, count in (("corner 2", "circle", 25), ("wang 2", "path", 40)):
        drawing = ElementTree.fromstring(draw_jigsaw(BOARDS[name], engrave="colors"))
        engraved = drawing.find(f"{SVG}g[@id='engrave']")
        assert len(engraved) == len(engraved.findall(f"{SVG}{mark}")) == count
        assert len({shape.get("fill") for shape in engraved}) == 2


@pytest.mark.parametrize("kind", ["png", "jpeg"])
def test_a_picture_goes_into_the_drawing_as_it_is(tmp_path, kind):
    file = tmp_path / "photograph"
    buffer = io.BytesIO()
    Image.new("RGB", (40, 30), "navy").save(buffer, kind)
    file.write_bytes(buffer.getvalue())
    drawing = ElementTree.fromstring(draw_jigsaw(BOARDS["wang 2"], picture=file))
    image = drawing.find(f"{SVG}g[@id='picture']/{SVG}image")
    head, content = image.get("href").split(",")
    assert head == f"data:image/{kind};base64"
    assert base64.b64decode(content) == file.read_bytes()
    assert image.get("preserveAspectRatio") == "xMidYMid slice"


REFUSED = {
    "nothing": (lambda: draw_jigsaw(5), "tiling must be a packing or another torus, not int"),
    "five colors": (lambda: draw_jigsaw(tw.packing(tw.corner_tiles(5))), "over 2 to 4 colors"),
    "one color": (lambda: draw_jigsaw(tw.packing(tw.wang_tiles(1))), "over 2 to 4 colors"),
    "cubes": (lambda: draw_jigsaw(tw.packing(tw.corner_cubes(2))), "not from corner-cube tiles"),
    "a plane": (lambda: draw_jigsaw(tw.direct(tw.wang_tiles(2))), "cut from a torus of up to 4096"),
    "small": (lambda: draw_jigsaw(BOARDS["wang 2"], piece=1), "piece is 1.0; allowed are 5 to 500"),
    "nan": (lambda: draw_jigsaw(BOARDS["wang 2"], piece=float("nan")), "piece is nan"),
    "engraving": (
        lambda: draw_jigsaw(BOARDS["wang 2"], engrave="names"),
        "allowed are none, colors, numbers",
    ),
    "no picture": (lambda: draw_jigsaw(BOARDS["wang 2"], picture="none.png"), "none.png cannot be read"),
    "no image": (lambda: draw_jigsaw(BOARDS["wang 2"], picture=__file__), "is no PNG or JPEG file"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_bad_input_is_refused_in_one_line(case):
    ask, message = REFUSED[case]
    with pytest.raises(tw.TilewrightError, match=message) as refusal:
        ask()
    assert "\n" not in str(refusal.value)


def test_the_command_writes_the_puzzle(tmp_path):
    file = tmp_path / "puzzle.svg"
    with pytest.raises(SystemExit) as ended:
        run(["pack", "--tiles", "wang", "--piece-mm", "20", "--engrave", "colors", "-o", str(file)])
    assert ended.value.code == 0
    assert file.read_text() == draw_jigsaw(tw.packing(tw.wang_tiles(2)), piece=20, engrave="colors")
