"""Walls as vector drawings: bricks as rounded outlines on mortar, or the lines between them."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, check_real
from tilewright.errors import TilewrightValueError
from tilewright.export.drawing.svg import document, element, path_of
from tilewright.fields.bricks.field import BrickField
from tilewright.fields.bricks.patterns import BrickPattern, Bricks, RegionBricks
from tilewright.tilings import Tiling
from tilewright.tilings.bricks import BrickRegion

MODES = ("bricks", "lines")
MOST_CELLS = 200_000
_INK, _LINE = "#222222", 2


def draw_wall(
    wall: BrickField | BrickPattern | BrickRegion | Tiling,
    x: int = 0,
    y: int = 0,
    width: int = 1024,
    height: int = 1024,
    *,
    mode: str = "bricks",
    scale: float = 1,
) -> str:
    """Draw a window of a wall as SVG.

    Parameters
    ----------
    wall : BrickField, BrickPattern, BrickRegion or Tiling
        A field gives colors, mortar and rounding; the others are drawn as a field with the usual style is.
    x : int, optional
        West side of the window in pixels of the wall, which are the drawing's user units; default 0.
    y : int, optional
        North side of the window, in pixels; default 0.
    width : int, optional
        Width of the window, in pixels; default 1024.
    height : int, optional
        Height of the window, in pixels; default 1024.
    mode : str, optional
        ``"bricks"``, the default: a rectangle with round corners for each brick, with its id as ``data-id``,
        on mortar. ``"lines"``: the middle lines of the mortar, each piece once, for plotters and cutters.
    scale : float, optional
        Size on the page, in CSS pixels per user unit, 1e-4 to 1e4; default 1.

    Returns
    -------
    str
        The text of an SVG file; `save_svg` writes it.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The window is outside the wall or has more than 200,000 cells, or a number is out of range.

    Notes
    -----
    Kaji et al. 2016, section 4, has such walls; drawing them as vectors is our own.
    """
    field = wall if isinstance(wall, BrickField) else BrickField(wall)
    check_choice("mode", mode, MODES)
    x, y, width, height = field.pattern.check_window(x, y, width, height)
    check_real("scale", scale, 1e-4, 1e4)
    cells = width * height // (field.pattern.unit[0] * field.pattern.unit[1])
    if cells > MOST_CELLS:
        raise TilewrightValueError(
            f"the window holds {cells:,} cells; allowed are {MOST_CELLS:,}: draw a smaller one"
        )
    found = field.bricks(x, y, width, height)
    if mode == "lines":
        body = [_draw_lines(found.sides, width, height)]
    else:
        mortar = np.rint(255 * field.style.lime).astype(np.uint8)
        body = [element("rect", width=width, height=height, fill=_hex(mortar)), *_draw_bricks(field, found)]
    if isinstance(field.pattern, RegionBricks):
        body = _clip(body, field.pattern, (x, y))
    return document(body, width, height, scale=scale)


def _draw_bricks(field: BrickField, found: Bricks) -> Iterator[str]:
    """A rectangle for each brick, without the mortar around it."""
    own = found.sides + field.look.insets
    tones = field.tones(found)
    for (west, north, east, south), (x, y), tone in zip(own.tolist(), found.ids, tones, strict=True):
        yield element(
            "rect",
            x=west,
            y=north,
            width=east - west,
            height=south - north,
            rx=field.look.rounding,
            fill=_hex(tone),
            data_id=f"{x} {y}",
        )


def _draw_lines(sides: NDArray[np.int64], width: int, height: int) -> str:
    """All joints in the window: the west and the north sides of bricks, joined where they go on."""
    upright = [((at, low), (at, high)) for at, low, high in _join(sides[:, [0, 1, 3]], width, height)]
    level = [((low, at), (high, at)) for at, low, high in _join(sides[:, [1, 0, 2]], height, width)]
    lines = "".join(path_of(line, closed=False) for line in (*upright, *level))
    return element("path", d=lines, fill="none", stroke=_INK, stroke_width=_LINE)


def _clip(body: list[str], pattern: RegionBricks, corner: tuple[int, int]) -> list[str]:
    """A drawing cut to the cells of a region, seen from the north-west corner of the window."""
    (x, y), (u, v) = corner, pattern.unit
    shape = ""
    for row, inside in enumerate(pattern.region.cells >= 0):
        top, bottom = row * v - y, (row + 1) * v - y
        ends = np.flatnonzero(np.diff(inside, prepend=False, append=False)) * u - x
        for left, right in ends.reshape(-1, 2):
            shape += path_of([(left, top), (right, top), (right, bottom), (left, bottom)])
    clip = element("clipPath", element("path", d=shape), id="wall")
    return [clip, element("g", *body, clip_path="url(#wall)")]


def _join(pieces: NDArray[np.int64], reach: int, length: int) -> list[Any]:
    """Lines from pieces (at, low, high), in a window of ``reach`` across them and ``length`` along."""
    pieces = pieces[(pieces[:, 0] > 0) & (pieces[:, 0] < reach)]
    pieces = np.concatenate([pieces[:, :1], pieces[:, 1:].clip(0, length)], axis=1)
    at, low, high = pieces[np.lexsort((pieces[:, 1], pieces[:, 0]))].T
    first = np.ones(len(at), bool)
    first[1:] = (at[1:] != at[:-1]) | (low[1:] != high[:-1])
    last = np.append(first[1:], True)[: len(at)]
    return np.stack([at[first], low[first], high[last]], axis=1).tolist()


def _hex(color: NDArray[np.uint8]) -> str:
    return "#" + bytes(color.tolist()).hex()
