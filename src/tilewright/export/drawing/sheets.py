"""Pieces of puzzles laid apart on sheets, each cut along its own line, half a beam's width outside of it."""

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, check_real, type_error
from tilewright.errors import TilewrightValueError, TilewrightWarning
from tilewright.export.drawing.jigsaw import ENGRAVINGS, THIN, Jigsaw, color_marks_at, number_mark_at
from tilewright.export.drawing.prints import print_of
from tilewright.export.drawing.svg import document, element, path_of
from tilewright.files.atomic import AnyPath
from tilewright.tilings import Tiling

Line = NDArray[np.float64]
Marks = Callable[[Jigsaw, int, int], Iterator[str]]

_WIDEST = 0.02
"""The widest beam, for the size of a piece: the narrowest fillet of a tab has 0.018 of it as its radius, and
lines wound about the corners of the frame's hole begin with straight parts of 0.0117."""
_APART = 2.0
"""Millimeters of material that are left between two cuts, and around all of them."""


@dataclass(frozen=True)
class Part:
    """What is cut out by itself: its cuts as closed lines, outermost first, and the cell that it shows."""

    cuts: tuple[Line, ...]
    cell: tuple[int, int] | None

    @property
    def corner(self) -> Line:
        """The least x and y of its cuts."""
        return np.asarray(self.cuts[0].min(axis=0))

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of its cuts."""
        width, height = np.ptp(self.cuts[0], axis=0)
        return float(width), float(height)


@dataclass(frozen=True)
class Place:
    """Where a part lies: the sheet's number, and how far the part is moved from its place on the board."""

    part: Part
    sheet: int
    moved: Line


def draw_jigsaw_sheets(
    tiling: Tiling,
    *,
    piece: float = 30,
    kerf: float = 0,
    sheet: tuple[float, float] | None = None,
    picture: AnyPath | None = None,
    engrave: str = "none",
) -> list[str]:
    """Draw the pieces of a jigsaw puzzle apart from each other, for a beam of a known width.

    Every piece, and the frame, is cut along a line of its own, half the kerf outside its border. So
    pieces come out in their nominal size and touch without play, where `draw_jigsaw` cuts two pieces by
    one line and leaves a gap as wide as the beam.

    Parameters
    ----------
    tiling : Tiling
        As `draw_jigsaw` takes it.
    piece : float, optional
        Size of a piece without its tabs, 5 to 500 mm; default 30.
    kerf : float, optional
        Width of what the beam burns away, in mm, 0 to 2 % of a piece; default 0. Between pieces there is a
        gap of the beam's true width less ``kerf``.
    sheet : tuple of (float, float), optional
        Width and height of the sheets of material, in mm, up to 10,000; by default one that holds all. What
        is cut stays 2 mm away from what else is cut, and from the sides.
    picture : path, optional
        A PNG or JPEG file to print on the pieces, as `draw_jigsaw` lays it; by default none.
    engrave : str, optional
        ``"none"``, the default, ``"colors"`` or ``"numbers"``.

    Returns
    -------
    list of str
        The texts of SVG files, one for each sheet; `save_drawing` writes them, as the pages of a PDF too. The
        frame is left out where it is larger than a sheet.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The tiling is another one, there is no such engraving, the kerf is wider than tabs allow, or a sheet
        holds no piece.
    TilewrightFileError
        The picture cannot be read.

    Warns
    -----
    TilewrightWarning
        The frame is left out.

    Notes
    -----
    Lagae 2007, section 5.5.4, has the puzzles; cutting them apart is our own.

    Examples
    --------
    >>> import tilewright as tw
    >>> len(tw.draw_jigsaw_sheets(tw.packing(tw.corner_tiles(2)), kerf=0.15, sheet=(300, 200)))
    2
    """
    check_choice("engrave", engrave, ENGRAVINGS)
    puzzle = Jigsaw(tiling, piece)
    _check_kerf(kerf, puzzle.piece)
    places, sizes = _laid(_parts(puzzle, kerf), puzzle, None if sheet is None else _checked(sheet))
    print_ = "".join(print_of(picture, *puzzle.sheet))
    marks: Marks | None = {"none": None, "colors": color_marks_at, "numbers": number_mark_at}[engrave]
    return [
        _drawn(puzzle, [place for place in places if place.sheet == number], size, print_, marks)
        for number, size in enumerate(sizes)
    ]


def widened(outline: Line, by: float) -> Line:
    """A closed clockwise line with all its sides moved outwards; corners stay corners.

    Good as long as ``by`` is less than the radius of any curve that it narrows.
    """
    outline = outline[np.any(outline != np.roll(outline, 1, axis=0), axis=1)]
    along = np.roll(outline, -1, axis=0) - outline
    along /= np.hypot(*along.T)[:, np.newaxis]
    after = np.stack([along[:, 1], -along[:, 0]], axis=1)
    before = np.roll(after, 1, axis=0)
    share = 1 + np.sum(before * after, axis=1, keepdims=True)
    return np.asarray(outline + by * (before + after) / share)


def _check_kerf(kerf: float, piece: float) -> None:
    most = round(_WIDEST * piece, 4)
    if check_real("kerf", kerf, 0, 500) > most:
        raise TilewrightValueError(
            f"is {kerf:g} mm; the tabs of a piece of {piece:g} mm allow 0 to {most:g}: make larger pieces",
            argument="kerf",
            value=kerf,
            allowed=f"0 to {most:g}",
        )


def _checked(sheet: tuple[float, float]) -> tuple[float, float]:
    if not isinstance(sheet, (tuple, list)) or len(sheet) != 2:
        raise type_error("sheet", sheet, "a width and a height in mm")
    width, height = (check_real("sheet", side, 1, 10_000) for side in sheet)
    return width, height


def _parts(puzzle: Jigsaw, kerf: float) -> list[Part]:
    """The pieces, row by row, then the frame."""
    cells = ((x, y) for y in range(puzzle.height) for x in range(puzzle.width))
    pieces = [Part((widened(puzzle.outline(*cell), kerf / 2),), cell) for cell in cells]
    frame = widened(puzzle.frame, kerf / 2), widened(puzzle.board, -kerf / 2)
    return [*pieces, Part(frame, None)]


def _note_frame(frame: Part) -> None:
    """Say that the frame is not among what is cut."""
    width, height = frame.size
    warnings.warn(
        f"the frame, {width:.0f} x {height:.0f} mm, is larger than a sheet and left out",
        TilewrightWarning,
        stacklevel=5,
    )


def _laid(
    parts: list[Part], puzzle: Jigsaw, sheet: tuple[float, float] | None
) -> tuple[list[Place], list[tuple[float, float]]]:
    """Parts in rows from the north-west on, as many in a row and on a sheet as it holds; and the sheets."""
    if sheet is None:
        widest = max(part.size[0] + _APART for part in parts[:-1])
        room = (max(puzzle.width * widest, parts[-1].size[0] + _APART) + _APART, np.inf)
    else:
        room = sheet
    places: list[Place] = []
    x, y, row, number = _APART, _APART, 0.0, 0
    for part in parts:
        width, height = part.size
        if width + 2 * _APART > room[0] or height + 2 * _APART > room[1]:
            if part.cell is None:
                _note_frame(part)
                continue
            raise TilewrightValueError(
                f"is {room[0]:g} x {room[1]:g} mm; a piece with its tabs and 2 mm around it needs "
                f"{width + 2 * _APART:.1f} x {height + 2 * _APART:.1f}",
                argument="sheet",
                value=sheet,
            )
        if x + width + _APART > room[0]:
            x, y, row = _APART, y + row + _APART, 0.0
        if y + height + _APART > room[1]:
            x, y, row, number = _APART, _APART, 0.0, number + 1
        places.append(Place(part, number, np.array([x, y]) - part.corner))
        x, row = x + width + _APART, max(row, height)
    size = (room[0], y + row + _APART) if sheet is None else sheet
    return places, [size] * (number + 1)


def _drawn(
    puzzle: Jigsaw, places: list[Place], size: tuple[float, float], print_: str, marks: Marks | None
) -> str:
    """A sheet, with the layers of `draw_jigsaw`."""
    shown, engraved = [], []
    for number, place in enumerate(places):
        if print_:
            shown.append(_inside(place, number, '<use href="#print"/>'))
        if marks is not None and place.part.cell is not None:
            engraved.append(_inside(place, number, *marks(puzzle, *place.part.cell)))
    clips = [] if not (shown or engraved) else [_clip(place, number) for number, place in enumerate(places)]
    cuts = [
        element("path", d=path_of(np.round(line + place.moved, 3)))
        for place in places
        for line in place.part.cuts[::-1]
    ]
    defined = [element("g", print_, id="print"), *clips] if print_ else clips
    layers = [
        *([element("defs", *defined)] if defined else []),
        element("g", *shown, id="picture"),
        element("g", *engraved, id="engrave"),
        element("g", *cuts, id="cut", fill="none", stroke="#ff0000", stroke_width=THIN),
    ]
    return document(layers, *size, unit="mm")


def _clip(place: Place, number: int) -> str:
    """The area of a part, where it lies on the board; a hole goes round the other way."""
    outside, *holes = place.part.cuts
    lines = (outside, *(hole[::-1] for hole in holes))
    shape = "".join(path_of(np.round(line, 3)) for line in lines)
    return element("clipPath", element("path", d=shape), id=f"part{number}")


def _inside(place: Place, number: int, *content: str) -> str:
    """What is on a part, moved with it and cut to it."""
    x, y = np.round(place.moved, 3)
    return element("g", *content, transform=f"translate({x:g} {y:g})", clip_path=f"url(#part{number})")
