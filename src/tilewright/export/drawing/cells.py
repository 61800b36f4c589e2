"""Arrays of tile numbers as pictures: every cell in its tile's color, or its tile's strokes or arcs."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_cells, check_choice, check_int, type_error
from tilewright.errors import TilewrightValueError
from tilewright.export.drawing.svg import document, element
from tilewright.export.drawing.tiles import MOST_PIXELS, color_of
from tilewright.pixels import read_hex

MOTIFS = ("fill", "strokes", "arcs")
MOST_CELLS = 2**20
"""Of an SVG drawing."""
_LINE, _GROUND = "#27548f", "#fdf6e3"
_MOST_TILES = 256
_HALF = {"strokes": 0.1, "arcs": 0.11}
"""Half the width of lines, in cells."""
_REACH = 0.31
"""From the middle of a cell to the end of its stroke, along x or y."""
# Quarter circles about NW and SE for tile 0, about NE and SW for tile 1: start, turn, end from start.
_ARCS = (((0.5, 0, 1, -0.5), (1, 0.5, 0, -0.5)), ((0.5, 0, 0, 0.5), (0, 0.5, 1, 0.5)))


def draw_cells(
    cells: ArrayLike, *, colors: Sequence[str] | None = None, motif: str = "fill", size: int | None = None
) -> str:
    """Draw the tiles of cells as SVG: a path for each tile; runs of a tile are one rectangle.

    Parameters
    ----------
    cells : array-like of int, shape (height, width)
        Tiles 0 to 255, up to 2^20 cells.
    colors : sequence of str, optional
        As ``#rrggbb``: of each tile, or of the lines and the ground where ``motif`` is not ``"fill"``; by
        default colors of this library.
    motif : str, optional
        ``"fill"``, the default: squares. ``"strokes"``: tile t of T leans by 45 + 180 t / T degrees.
        ``"arcs"``: Truchet's quarter circles, of two tiles.
    size : int, optional
        Pixels along the side of a cell; by default 4 to 64.

    Returns
    -------
    str
        The text of an SVG file; `save_svg` writes it.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        There are too many cells, a tile or a number is out of range, or a color or motif is unknown.

    Examples
    --------
    >>> import tilewright as tw
    >>> drawing = tw.draw_cells([[0, 1], [1, 0]], motif="arcs")
    >>> drawing.startswith("<svg")
    True
    """
    tiles = _as_tiles(cells)
    height, width = tiles.shape
    if tiles.size > MOST_CELLS:
        raise TilewrightValueError(
            f"{width} x {height} cells are too many for a drawing; allowed are {MOST_CELLS:,}: make a PNG"
        )
    count, shades = _styled(tiles, colors, motif)
    scale = _scale(tiles, size)
    # What there is most of is the ground.
    ground = int(np.bincount(tiles.ravel()).argmax()) if motif == "fill" else 1
    body = [element("rect", width=width, height=height, fill=shades[ground])]
    if motif == "fill":
        for tile in np.unique(tiles).tolist():
            if tile != ground:
                body.append(element("path", d="".join(_rectangles(tiles == tile)), fill=shades[tile]))
        return document([element("g", *body, shape_rendering="crispEdges")], width, height, scale=scale)
    marks = "".join(_arcs(tiles) if motif == "arcs" else _strokes(tiles, count))
    width_of_line = 2 * _HALF[motif]
    body.append(
        element(
            "path", d=marks, fill="none", stroke=shades[0], stroke_width=width_of_line, stroke_linecap="round"
        )
    )
    return document(body, width, height, scale=scale)


def paint_cells(
    cells: ArrayLike, *, colors: Sequence[str] | None = None, motif: str = "fill", size: int | None = None
) -> NDArray[np.uint8]:
    """Paint the tiles of cells as pixels: the picture that `draw_cells` draws.

    Parameters
    ----------
    cells : array-like of int, shape (height, width)
        Tiles 0 to 255, any number of cells.
    colors : sequence of str, optional
        As of `draw_cells`.
    motif : str, optional
        As of `draw_cells`; default ``"fill"``.
    size : int, optional
        Pixels along the side of a cell; by default 4 to 64. The picture has up to 2^28 pixels.

    Returns
    -------
    uint8 array, shape (height * size, width * size, 3)
        sRGB colors.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        There are too many pixels, a tile or a number is out of range, or a color or motif is unknown.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.paint_cells([[0, 1]], colors=["#000000", "#ffffff"], size=1).tolist()
    [[[0, 0, 0], [255, 255, 255]]]
    """
    tiles = _as_tiles(cells)
    height, width = tiles.shape
    count, shades = _styled(tiles, colors, motif)
    side = _scale(tiles, size)
    if tiles.size * side**2 > MOST_PIXELS:
        raise TilewrightValueError(
            f"{width} x {height} cells of {side} x {side} pixels are too many; allowed are 2^28 pixels"
        )
    palette = np.array([read_hex(shade) for shade in shades], np.uint8)
    if motif == "fill":
        return palette[tiles.repeat(side, axis=0).repeat(side, axis=1)]
    line, ground = palette.astype(float)
    covered = np.stack([_coverage(motif, tile, count, side) for tile in range(count)])[..., None]
    painted = np.rint(covered * line + (1 - covered) * ground).astype(np.uint8)
    return painted[tiles].transpose(0, 2, 1, 3, 4).reshape(height * side, width * side, 3)


def _as_tiles(cells: ArrayLike) -> NDArray[np.uint8]:
    tiles = as_cells(cells)
    if tiles.min() < 0 or tiles.max() >= _MOST_TILES:
        raise TilewrightValueError(
            f"hold {tiles.min()} to {tiles.max()}; tiles are 0 to {_MOST_TILES - 1}", argument="cells"
        )
    return tiles.astype(np.uint8)


def _styled(tiles: NDArray[Any], colors: Sequence[str] | None, motif: str) -> tuple[int, list[str]]:
    """How many tiles there are, and the colors to draw them in."""
    count = max(int(tiles.max()) + 1, 2)
    if check_choice("motif", motif, MOTIFS) == "arcs" and count > 2:
        raise TilewrightValueError(f"arcs are of two tiles; the cells hold tiles up to {count - 1}")
    needed = count if motif == "fill" else 2
    if colors is None:
        return count, [color_of(t) for t in range(count)] if motif == "fill" else [_LINE, _GROUND]
    if isinstance(colors, str) or not hasattr(colors, "__iter__"):
        raise type_error("colors", colors, "a list such as ['#27548f', '#ecd5a3']")
    shades = list(colors)
    for shade in shades:
        read_hex(shade)
    if len(shades) < needed or (motif != "fill" and len(shades) > needed):
        what = f"the {count} tiles" if motif == "fill" else "the lines and the ground"
        raise TilewrightValueError(
            f"are {len(shades)}; {what} need {needed}", argument="colors", value=len(shades)
        )
    return count, shades


def _scale(tiles: NDArray[Any], size: int | None) -> int:
    """Pixels along the side of a cell."""
    if size is None:
        return max(4, min(64, 1280 // max(tiles.shape)))
    return check_int("size", size, 1, 512)


def _rectangles(member: NDArray[np.bool_]) -> Iterator[str]:
    """Runs along rows, those of equal ends below each other joined, as subpaths."""
    steps = np.diff(member, axis=1, prepend=False, append=False)
    row, end = (part.reshape(-1, 2) for part in np.nonzero(steps))
    runs = np.stack([end[:, 0], end[:, 1], row[:, 0]], axis=1)
    runs = runs[np.lexsort(runs.T[::-1])]
    goes_on = np.all(np.diff(runs, axis=0) == (0, 0, 1), axis=1)
    first = np.flatnonzero(np.append(True, ~goes_on))
    heights = np.diff(np.append(first, len(runs)))
    for (west, east, north), height in zip(runs[first].tolist(), heights.tolist(), strict=True):
        yield f"M{west} {north}h{east - west}v{height}H{west}Z"


def _strokes(tiles: NDArray[Any], count: int) -> Iterator[str]:
    reach = [np.round(_reach(count) * _direction(tile, count), 3).tolist() for tile in range(count)]
    for (y, x), tile in np.ndenumerate(tiles):
        across, down = reach[tile]
        yield f"M{x + 0.5 - across:g} {y + 0.5 - down:g}l{2 * across:g} {2 * down:g}"


def _arcs(tiles: NDArray[Any]) -> Iterator[str]:
    for (y, x), tile in np.ndenumerate(tiles):
        for left, top, turn, across in _ARCS[tile]:
            yield f"M{x + left:g} {y + top:g}a.5 .5 0 0 {turn} {across:g} .5"


def _direction(tile: int, count: int) -> NDArray[np.float64]:
    """Along the stroke of a tile; x east, y south."""
    angle = np.pi * (0.25 + tile / count)
    return np.array([np.cos(angle), np.sin(angle)])


def _reach(count: int) -> float:
    """From the middle of a cell to the ends of strokes, the same for all tiles and inside the cell."""
    return float(min(_REACH / np.abs(_direction(tile, count)).max() for tile in range(count)))


def _coverage(motif: str, tile: int, count: int, side: int) -> NDArray[np.float64]:
    """How much of each pixel of a cell its line covers, (side, side)."""
    y, x = (np.indices((side, side)) + 0.5) / side
    if motif == "arcs":
        corners = ((0, 0), (1, 1)) if tile == 0 else ((1, 0), (0, 1))
        away = np.min([np.abs(np.hypot(x - left, y - top) - 0.5) for left, top in corners], axis=0)
    else:
        across, down = _direction(tile, count)
        reach = _reach(count)
        along = np.clip((x - 0.5) * across + (y - 0.5) * down, -reach, reach)
        away = np.hypot(x - 0.5 - along * across, y - 0.5 - along * down)
    return np.clip(0.5 + (_HALF[motif] - away) * side, 0, 1)
