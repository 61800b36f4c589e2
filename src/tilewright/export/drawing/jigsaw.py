"""Jigsaw puzzles from tilings, for a laser cutter (Lagae 2007, section 5.5.4).

Pieces fit where colors agree. An edge's color is the shape of its tab; a corner's color is the way in which
the four cuts that meet there are wound about it. Tabs point south and east, so a piece that is turned or
mirrored fits nowhere.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, check_real, check_type
from tilewright.errors import TilewrightValueError
from tilewright.export.drawing.prints import print_of
from tilewright.export.drawing.svg import document, element, path_of, text
from tilewright.export.drawing.tiles import color_of
from tilewright.files.atomic import AnyPath
from tilewright.showing import describe
from tilewright.tiles import CORNER, WANG
from tilewright.tilings import Tiling

Line = NDArray[np.float64]

MOST_COLORS = 4
"""As many shapes of tabs, and ways of winding, are told apart by hand."""
ENGRAVINGS = ("none", "colors", "numbers")
_MOST_PIECES = 4096
_MARGIN = 0.6
"""Of the sheet around the pieces, for the frame."""
_WOUND = 0.28
"""How far from a corner its color winds the cuts."""
_STEP = np.pi / 15
"""Arcs are made of straight lines that turn by this; 0.02 mm off in a piece of 30 mm."""
_BLEED = 0.05
"""How far the picture goes on around the frame."""
THIN = 0.1
"""Millimeters: just wide enough to be seen on a screen."""


class Jigsaw:
    """Where a puzzle is cut. Lengths are in millimeters, x east and y south from the sheet's corner.

    Parameters
    ----------
    tiling : Tiling
        A torus of Wang tiles or corner tiles over 2 to 4 colors, such as a packing; every cell
        becomes a piece.
    piece : float, optional
        Size of a piece without its tabs, 5 to 500 mm; default 30.

    Attributes
    ----------
    width : int
        Number of pieces along x.
    height : int
        Number of pieces along y.
    piece : float
        Size of a piece, in mm.
    sheet : tuple of (float, float)
        Width and height with the frame, in mm.
    tiling : Tiling
        As given.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The tiling is another one, or the size is out of range.

    Notes
    -----
    Lagae 2007, section 5.5.4. Opposite sides of the board fit together too, so the whole picture can be moved
    around the torus; a frame that fits the board keeps it together.
    """

    def __repr__(self) -> str:
        return describe(self, f"{self.width} x {self.height} pieces of {self.piece:g} mm", repr(self.tiling))

    def __init__(self, tiling: Tiling, piece: float = 30) -> None:
        self.width, self.height = _check_tiling(tiling)
        self.piece = check_real("piece", piece, 5, 500)
        self.tiling = tiling
        self.sheet = (self.piece * (self.width + 2 * _MARGIN), self.piece * (self.height + 2 * _MARGIN))
        slots = tiling.tiles.slots_of(tiling.indices(0, 0, self.width, self.height))
        rows, columns = np.arange(self.height + 1) % self.height, np.arange(self.width + 1) % self.width
        self._slots = slots[np.ix_(rows, columns)]
        """Colors of the pieces, with the first row and column once more at the end."""

    def row(self, y: int) -> Line:
        """Give the cut along the north of a row of pieces.

        Parameters
        ----------
        y : int
            Number of the row; ``height`` gives the south of the last row.

        Returns
        -------
        float64 array, shape (points, 2)
            The line, in mm.
        """
        return _joined(self.edge(x, y, False) for x in range(self.width))

    def column(self, x: int) -> Line:
        """Give the cut along the west of a column of pieces.

        Parameters
        ----------
        x : int
            Number of the column; ``width`` gives the east of the last column.

        Returns
        -------
        float64 array, shape (points, 2)
            The line, in mm.
        """
        return _joined(self.edge(x, y, True) for y in range(self.height))

    def outline(self, x: int, y: int) -> Line:
        """Give the border of a piece.

        Parameters
        ----------
        x : int
            Its column.
        y : int
            Its row.

        Returns
        -------
        float64 array, shape (points, 2)
            The line, in mm, clockwise from its north-west corner, not closed.
        """
        north, east = self.edge(x, y, False), self.edge(x + 1, y, True)
        south, west = self.edge(x, y + 1, False)[::-1], self.edge(x, y, True)[::-1]
        return _joined(iter((north, east, south, west)))[:-1]

    @property
    def board(self) -> Line:
        """The border of all pieces together, as that of a piece."""
        sides = self.row(0), self.column(self.width), self.row(self.height)[::-1], self.column(0)[::-1]
        return _joined(iter(sides))[:-1]

    @property
    def frame(self) -> Line:
        """The outside of the frame, with round corners, as the border of a piece."""
        bleed, (width, height) = _BLEED * self.piece, self.sheet
        corners = ((width - bleed, bleed), (width - bleed, height - bleed), (bleed, height - bleed))
        start = (width / 2, bleed)
        return _rounded([start, *corners, (bleed, bleed), start], self.piece / 6)[:-1]

    def edge(self, x: int, y: int, down: bool) -> Line:
        """Give the cut between two neighboring lattice points.

        Parameters
        ----------
        x : int
            Column of the first point.
        y : int
            Row of the first point.
        down : bool
            Whether the second point is the next one down; otherwise to the right.

        Returns
        -------
        float64 array, shape (points, 2)
            The line, in mm.
        """
        slots = self._slots[y, x]
        if self.tiling.tiles.shape is WANG:
            shape = _tab(int(slots[3 if down else 0]))
            line = shape[:, ::-1] if down else shape
        else:
            start = int(slots[3])
            end = int(self._slots[y + down, x + (not down)][3])
            line = _wound_edge(start, end, down)
        return np.asarray((line + np.array([x, y]) + _MARGIN) * self.piece)


def draw_jigsaw(
    tiling: Tiling,
    *,
    piece: float = 30,
    picture: AnyPath | None = None,
    engrave: str = "none",
) -> str:
    """Draw a jigsaw puzzle as SVG in millimeters, for a laser cutter.

    Its layers are the groups ``picture`` (to print), ``engrave`` (to engrave) and ``cut`` (thin red
    lines, every one once, those of the pieces first, the frame's outside last).

    Parameters
    ----------
    tiling : Tiling
        A torus of Wang tiles or corner tiles over 2 to 4 colors. Packings hold every piece once; those of a
        search make better puzzles than those in closed form.
    piece : float, optional
        Size of a piece without its tabs, 5 to 500 mm; default 30.
    picture : path, optional
        A PNG or JPEG file, put into the drawing upright and cropped to the sheet; by default none.
    engrave : str, optional
        ``"none"``, the default; ``"colors"``: the colors, at edges or corners; ``"numbers"``: the index of
        each piece's tile.

    Returns
    -------
    str
        The text of an SVG file; `save_svg` writes it.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The tiling is another one, there is no such engraving, or the size is out of range.
    TilewrightFileError
        The picture cannot be read.

    Notes
    -----
    Lagae 2007, section 5.5.4.

    Examples
    --------
    >>> import tilewright as tw
    >>> drawing = tw.draw_jigsaw(tw.packing(tw.corner_tiles(2)), piece=25)
    >>> 'width="130mm"' in drawing
    True
    """
    check_choice("engrave", engrave, ENGRAVINGS)
    puzzle = Jigsaw(tiling, piece)
    marks = {"none": lambda _: iter(()), "colors": _color_marks, "numbers": _number_marks}[engrave](puzzle)
    width, height = puzzle.sheet
    layers = [
        element("g", *print_of(picture, width, height), id="picture"),
        element("g", *marks, id="engrave"),
        element("g", *_cuts(puzzle), id="cut", fill="none", stroke="#ff0000", stroke_width=THIN),
    ]
    return document(layers, width, height, unit="mm")


def _cuts(puzzle: Jigsaw) -> Iterator[str]:
    """One path for every row and column, then the frame."""
    lines = [puzzle.row(y) for y in range(puzzle.height + 1)]
    lines += [puzzle.column(x) for x in range(puzzle.width + 1)]
    for line in lines:
        yield element("path", d=path_of(np.round(line, 3), closed=False))
    bleed = _BLEED * puzzle.piece
    width, height = (size - 2 * bleed for size in puzzle.sheet)
    yield element("rect", x=bleed, y=bleed, width=width, height=height, rx=puzzle.piece / 6)


def _color_marks(puzzle: Jigsaw) -> Iterator[str]:
    """A diamond on every edge, or a disc on every corner, in the color that the library's pictures show."""
    for x, y in np.ndindex(puzzle.width + 1, puzzle.height + 1):
        yield from _marks_from(puzzle, x, y)


def color_marks_at(puzzle: Jigsaw, x: int, y: int) -> Iterator[str]:
    """The marks of a piece, whole, and some of its neighbors."""
    for across, down in np.ndindex(2, 2):
        yield from _marks_from(puzzle, x + across, y + down)


def _marks_from(puzzle: Jigsaw, x: int, y: int) -> Iterator[str]:
    """The marks at a lattice point, and on the edges that begin there."""
    left, top = (x + _MARGIN) * puzzle.piece, (y + _MARGIN) * puzzle.piece
    slots, half = puzzle._slots[y, x], puzzle.piece / 2
    if puzzle.tiling.tiles.shape is CORNER:
        yield element("circle", cx=left, cy=top, r=puzzle.piece * 0.1, fill=color_of(slots[3]))
        return
    if x < puzzle.width:
        yield _diamond(left + half, top, puzzle.piece * 0.1, slots[0])
    if y < puzzle.height:
        yield _diamond(left, top + half, puzzle.piece * 0.1, slots[3])


def _diamond(x: float, y: float, r: float, color: int) -> str:
    return element("path", d=path_of([(x, y - r), (x + r, y), (x, y + r), (x - r, y)]), fill=color_of(color))


def _number_marks(puzzle: Jigsaw) -> Iterator[str]:
    """The index of the tile on every piece, upright where the piece is."""
    for y, x in np.ndindex(puzzle.height, puzzle.width):
        yield from number_mark_at(puzzle, x, y)


def number_mark_at(puzzle: Jigsaw, x: int, y: int) -> Iterator[str]:
    """The index of the tile of one piece."""
    yield text(
        str(puzzle.tiling.indices(x, y, 1, 1)[0, 0]),
        x=(x + _MARGIN + 0.54) * puzzle.piece,
        y=(y + _MARGIN + 0.6) * puzzle.piece,
        font_size=puzzle.piece * 0.15,
        text_anchor="middle",
        font_family="sans-serif",
    )


def _check_tiling(tiling: Tiling) -> tuple[int, int]:
    """Pieces along x and y of a tiling that makes a puzzle."""
    check_type("tiling", tiling, Tiling, "a packing or another torus")
    tiles = tiling.tiles
    if tiles.shape not in (WANG, CORNER) or not 2 <= max(tiles.colors) <= MOST_COLORS:
        raise TilewrightValueError(
            f"puzzles are cut from Wang tiles and corner tiles over 2 to {MOST_COLORS} colors, not from "
            f"{tiles.shape.name} tiles over {max(tiles.colors)}"
        )
    width, height = (0 if p is None else p for p in tiling.domain.periods)
    if tiling.domain.kind != "torus" or width * height > _MOST_PIECES:
        raise TilewrightValueError(
            f"puzzles are cut from a torus of up to {_MOST_PIECES} cells, such as packing() gives"
        )
    return width, height


def _joined(lines: Iterator[Line]) -> Line:
    """Lines that go on from each other, as one."""
    first, *others = lines
    return np.concatenate([first, *(line[1:] for line in others)])


def _arc(center: tuple[float, float], radius: float, start: float, turn: float) -> Line:
    """Points of an arc; angles in radians, from x towards y."""
    angles = start + np.linspace(0, turn, int(np.ceil(abs(turn) / _STEP)) + 1)
    return np.asarray(center) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _knob(x: float, radius: float, reach: float, fillet: float) -> Line:
    """A round tab at x that stands out to y = reach, its neck filleted."""
    height = reach - radius
    aside = np.sqrt((radius + fillet) ** 2 - (height - fillet) ** 2)
    lean = np.arctan2(height - fillet, aside)
    left = _arc((x - aside, fillet), fillet, -np.pi / 2, np.pi / 2 + lean)
    head = _arc((x, height), radius, np.pi + lean, -np.pi - 2 * lean)
    right = _arc((x + aside, fillet), fillet, np.pi - lean, np.pi / 2 + lean)
    return np.concatenate([left, head[1:], right[1:]])


def _rounded(corners: list[tuple[float, float]], radius: float) -> Line:
    """A line from corner to corner, every corner between its ends rounded."""
    points = np.array(corners)
    parts = [points[:1]]
    for before, here, after in zip(points[:-2], points[1:-1], points[2:], strict=True):
        into, out = (here - before) / np.hypot(*(here - before)), (after - here) / np.hypot(*(after - here))
        turn = np.arctan2(into[0] * out[1] - into[1] * out[0], into @ out)
        start = here - into * radius * np.tan(abs(turn) / 2)
        normal = np.sign(turn) * np.array([-into[1], into[0]])
        center = start + normal * radius
        parts.append(_arc(tuple(center), radius, np.arctan2(*(-normal)[::-1]), turn))
    return np.concatenate([*parts, points[-1:]])


def _tab(color: int) -> Line:
    """An edge from (0, 0) to (1, 0) with the tab of its color, which points towards positive y.

    A round knob, a keystone, an arrow, two small knobs; none goes into the hole of another.
    """
    if color == 0:
        return np.concatenate([[(0, 0)], _knob(0.38, 0.1, 0.23, 0.04), [(1, 0)]])
    if color == 1:
        keystone = [(0.55, 0), (0.505, 0.19), (0.735, 0.19), (0.69, 0)]
        return _rounded([(0, 0), *keystone, (1, 0)], 0.03)
    if color == 2:
        half = [(0.436, 0), (0.436, 0.075), (0.36, 0.075)]
        other = [(1 - x, y) for x, y in reversed(half)]
        return _rounded([(0, 0), *half, (0.5, 0.24), *other, (1, 0)], 0.018)
    knobs = [_knob(x, 0.085, 0.185, 0.03) for x in (0.31, 0.69)]
    return np.concatenate([[(0, 0)], *knobs, [(1, 0)]])


def _wound_edge(start: int, end: int, down: bool) -> Line:
    """An edge from (0, 0) to (0, 1) or (1, 0), wound about its ends by their colors, with a knob between.

    Every cut about a corner is turned by the same angle at the same distance, so cuts never meet, and all
    four pieces have the same part of the disc.
    """
    radius = np.linspace(0, 1, 25)
    heading = np.pi / 2 if down else 0.0
    knob = _knob(0.5, 0.095, 0.215, 0.035)
    ends = []
    for color, direction in ((start, heading), (end, heading + np.pi)):
        angle = direction + _winding(color, radius)
        ends.append(_WOUND * (radius * np.stack([np.cos(angle), np.sin(angle)])).T)
    far = (0, 1) if down else (1, 0)
    return np.concatenate([ends[0], knob[:, ::-1] if down else knob, ends[1][::-1] + far])


def _winding(color: int, radius: Line) -> Line:
    """The angle by which cuts are turned at a distance from the corner, 0 to 1: none at 1."""
    if color == 2:
        return 0 * radius
    fading = (1 - radius**2) ** 2
    return np.asarray(10 * radius**4 * fading if color == 3 else (1.6, -1.6)[color] * fading)
