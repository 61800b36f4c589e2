"""Tile sets and tilings as pictures: triangles for edge colors, quarter discs for corner colors."""

import colorsys
from collections.abc import Iterator
from functools import cache
from math import cos, pi, sin

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.export.drawing.svg import document, element, path_of, text
from tilewright.pixels import LUMA, read_hex
from tilewright.tiles import Shape, TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings import Tiling

Point = tuple[float, float]

MOST_TILES = 2048
"""Of a drawn set."""
MOST_CELLS = 2**17
"""Of a drawn tiling."""
MOST_PIXELS = 2**28
_INK, _PAPER, _LIGHT = "#1d1d26", "#ffffff", "#fffdf8"
# Neighbors in the list differ in hue and in lightness, so that they are told apart without hue too.
_COLORS = (
    "#ecd5a3", "#27548f", "#e2572f", "#f4b52f", "#3f9a62", "#8a57a6", "#7cc7de", "#33323f",
    "#dd78a8", "#9aa63a", "#70492f", "#aaa9b5", "#c9e58d", "#157a77", "#d9c8f2", "#8e1b3e",
)  # fmt: skip


def color_of(number: int) -> str:
    """The color, as ``#rrggbb``, in which pictures show a color of tiles.

    Sixteen are chosen by hand; from there on hues go round by the golden ratio, in three lightnesses.
    """
    if number < len(_COLORS):
        return _COLORS[number]
    hue, lightness = number * 0.618034 % 1, (0.36, 0.55, 0.76)[number % 3]
    return "#" + "".join(f"{round(255 * part):02x}" for part in colorsys.hls_to_rgb(hue, lightness, 0.6))


def draw_tiles(tiles: TileSet) -> str:
    """Draw a tile set as SVG: every tile with its colors and their numbers, its index below.

    Parameters
    ----------
    tiles : TileSet
        Up to 2048 square tiles: a triangle for every edge, a quarter of a disc for every corner.

    Returns
    -------
    str
        The text of an SVG file; `save_svg` writes it.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set.
    TilewrightValueError
        The tiles are not square, or there are too many.

    Examples
    --------
    >>> import tilewright as tw
    >>> drawing = tw.draw_tiles(tw.corner_tiles(2))
    >>> drawing.count("translate(")  # a group for each tile
    16
    """
    _check_square(tiles)
    if len(tiles) > MOST_TILES:
        raise TilewrightValueError(
            f"the {tiles.name} set has {len(tiles)} tiles; up to {MOST_TILES} are drawn"
        )
    columns, pitch, below = _columns(len(tiles)), 1.3, 0.25
    rows = -(-len(tiles) // columns)
    body = [element("rect", width=columns * pitch + 0.3, height=rows * (pitch + below) + 0.3, fill=_PAPER)]
    for tile in range(len(tiles)):
        x, y = tile % columns * pitch + 0.3, tile // columns * (pitch + below) + 0.3
        number = text(str(tile), x=0.5, y=1.22, text_anchor="middle", font_size=0.2, fill=_INK)
        drawn = (*_tile(tiles, tile), *_numbers(tiles, tile), number)
        body.append(element("g", *drawn, transform=f"translate({x:.4g} {y:.4g})"))
    width, height = columns * pitch + 0.3, rows * (pitch + below) + 0.3
    return _page(body, width, height, max(40, min(96, round(1280 / width))))


def draw_tiling(tiling: Tiling, x: int = 0, y: int = 0, width: int = 32, height: int = 32) -> str:
    """Draw a window of a tiling by square tiles as SVG.

    Parameters
    ----------
    tiling : Tiling
        By square tiles.
    x : int, optional
        First cell along x; default 0.
    y : int, optional
        First cell along y; default 0.
    width : int, optional
        Cells along x; default 32; a window has up to 131,072 cells.
    height : int, optional
        Cells along y; default 32; a window has up to 131,072 cells.

    Returns
    -------
    str
        The text of an SVG file; `save_svg` writes it. Each tile is in it once, its places refer to it.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The tiles are not square, or the window has too many cells (`paint_tiling` makes larger pictures) or
        lies outside the tiling.

    Examples
    --------
    >>> import tilewright as tw
    >>> drawing = tw.draw_tiling(tw.direct(tw.corner_tiles(2), seed=7), width=8, height=4)
    >>> drawing.count("<use ")
    32
    """
    _check_square(_tiles_of(tiling))
    if check_int("width", width, 1, MOST_CELLS) * check_int("height", height, 1, MOST_CELLS) > MOST_CELLS:
        raise TilewrightValueError(
            f"{width} x {height} cells are too many for a drawing; allowed are {MOST_CELLS:,}: draw a "
            "smaller window, or make a PNG"
        )
    cells = tiling.indices(x, y, width, height)
    tiles = (element("g", *_tile(tiling.tiles, t), id=f"t{t}") for t in np.unique(cells).tolist())
    body = [element("defs", *tiles)]
    for row, line in enumerate(cells.tolist()):
        places = (f'<use href="#t{tile}" x="{column}"/>' for column, tile in enumerate(line))
        body.append(element("g", *places, transform=f"translate(0 {row})") + "\n")
    return _page(body, width, height, max(4, min(64, 1280 // max(width, height))))


def paint_tiles(tiles: TileSet) -> NDArray[np.uint8]:
    """Paint a tile set as pixels: the picture that `draw_tiles` draws, without numbers.

    Parameters
    ----------
    tiles : TileSet
        Square tiles; one has 64 x 64 pixels.

    Returns
    -------
    uint8 array, shape (height, width, 3)
        sRGB colors.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set.
    TilewrightValueError
        The tiles are not square.
    """
    _check_square(tiles)
    size, gap, columns = 64, 16, _columns(len(tiles))
    rows = -(-len(tiles) // columns)
    sheet = np.full((rows * (size + gap) + gap, columns * (size + gap) + gap, 3), 255, np.uint8)
    for tile, pixels in enumerate(_paint(tiles, range(len(tiles)), size)):
        top, left = (gap + n * (size + gap) for n in divmod(tile, columns))
        sheet[top : top + size, left : left + size] = pixels
    return sheet


def paint_tiling(
    tiling: Tiling, x: int = 0, y: int = 0, width: int = 32, height: int = 32, *, size: int | None = None
) -> NDArray[np.uint8]:
    """Paint a window of a tiling by square tiles as pixels.

    Parameters
    ----------
    tiling : Tiling
        By square tiles.
    x : int, optional
        First cell along x; default 0.
    y : int, optional
        First cell along y; default 0.
    width : int, optional
        Cells along x; default 32.
    height : int, optional
        Cells along y; default 32.
    size : int, optional
        Pixels along the side of a tile, 1 to 512; by default 4 to 64, for a picture of up to 1280 pixels.

    Returns
    -------
    uint8 array, shape (height * size, width * size, 3)
        sRGB colors.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The tiles are not square, the picture has more than 2^28 pixels, or the window lies outside the
        tiling.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.paint_tiling(tw.direct(tw.wang_tiles(3), seed=7), width=8, height=4, size=16).shape
    (64, 128, 3)
    """
    tiles = _tiles_of(tiling)
    _check_square(tiles)
    longest = max(check_int("width", width, 1, 2**20), check_int("height", height, 1, 2**20))
    pixels = max(4, min(64, 1280 // longest)) if size is None else check_int("size", size, 1, 512)
    if width * height * pixels**2 > MOST_PIXELS:
        raise TilewrightValueError(
            f"{width} x {height} cells of {pixels} x {pixels} pixels are too many; allowed are 2^28 pixels"
        )
    used, place = np.unique(tiling.indices(x, y, width, height), return_inverse=True)
    painted = np.stack(list(_paint(tiles, used.tolist(), pixels)))
    rows = painted[place.reshape(height, width)].transpose(0, 2, 1, 3, 4)
    return rows.reshape(height * pixels, width * pixels, 3)


def _tiles_of(tiling: Tiling) -> TileSet:
    if not isinstance(tiling, Tiling):
        raise TilewrightValueError(
            f"must be a Tiling, not {type(tiling).__name__}",
            argument="tiling",
            value=tiling,
            allowed="a Tiling",
        )
    return tiling.tiles


def _check_square(tiles: TileSet) -> None:
    if check_tiles("tiles", tiles).shape.dimension != 2:
        raise TilewrightValueError(f"pictures are of square tiles, not of {tiles.shape.name} ones")


def _columns(count: int) -> int:
    """Tiles in a row of a sheet that is about as high as it is wide, and less so for few."""
    return max(min(count, 8), round((1.4 * count) ** 0.5))


def _page(body: list[str], width: float, height: float, scale: int) -> str:
    font = element("g", *body, font_family="Helvetica, Arial, sans-serif")
    return document([font], width, height, scale=scale)


# --- One tile, as filled shapes in a square of side 1 -------------------------------------------------


@cache
def _regions(shape: Shape) -> tuple[tuple[int, tuple[Point, ...], Point], ...]:
    """For every slot its number, its region and where its label stands."""
    found: list[tuple[int, tuple[Point, ...], Point]] = []
    radius = 0.25 if "N" in shape.slots else 0.5
    for slot, name in enumerate(shape.slots):
        x, y = ("E" in name) - ("W" in name), ("S" in name) - ("N" in name)
        center = (0.5 + x / 2, 0.5 + y / 2)
        if len(name) == 1:
            side = ((center[0] + y / 2, center[1] + x / 2), (center[0] - y / 2, center[1] - x / 2))
            found.append((slot, (*side, (0.5, 0.5)), (0.5 + x / 3, 0.5 + y / 3)))
        else:
            turns = (n / 32 * pi for n in range(17))
            arc = ((center[0] - x * radius * cos(a), center[1] - y * radius * sin(a)) for a in turns)
            found.append((slot, (center, *arc), (center[0] - x * radius * 0.4, center[1] - y * radius * 0.4)))
    return tuple(found)


def _tile(tiles: TileSet, tile: int) -> Iterator[str]:
    yield element("path", d="M0 0H1V1H0Z", fill=_LIGHT)
    for slot, region, _ in _regions(tiles.shape):
        fill = color_of(int(tiles.slots[tile, slot]))
        # The outline in its own color covers the hairline that is left between two regions.
        yield element("path", d=path_of(region), fill=fill, stroke=fill, stroke_width=0.02)
    yield element("path", d="M0 0H1V1H0Z", fill="none", stroke=_INK, stroke_width=0.03)


def _numbers(tiles: TileSet, tile: int) -> Iterator[str]:
    """Numbers of the colors, each in its region."""
    size = 0.12 if len(tiles.shape.slots) > 4 or max(tiles.colors) > 100 else 0.17
    for slot, _, (x, y) in _regions(tiles.shape):
        color = int(tiles.slots[tile, slot])
        ink = _INK if _is_light(color_of(color)) else _PAPER
        yield text(str(color), x=x, y=y + 0.36 * size, text_anchor="middle", font_size=size, fill=ink)


def _is_light(color: str) -> bool:
    return sum(weight * part for weight, part in zip(LUMA, read_hex(color), strict=True)) > 140


def _paint(tiles: TileSet, which: range | list[int], size: int) -> Iterator[NDArray[np.uint8]]:
    """Tiles as pixels, drawn four times as large and made smaller."""
    from PIL import Image, ImageDraw

    large = 4 * size
    for tile in which:
        image = Image.new("RGB", (large, large), _LIGHT)
        pencil = ImageDraw.Draw(image)
        for slot, region, _ in _regions(tiles.shape):
            fill = color_of(int(tiles.slots[tile, slot]))
            pencil.polygon([(x * large, y * large) for x, y in region], fill=fill)
        if size >= 12:  # lines on smaller tiles would be most of the picture
            pencil.rectangle((0, 0, large - 1, large - 1), outline=_INK, width=max(1, round(0.015 * large)))
        yield np.asarray(image.resize((size, size), Image.Resampling.BOX))
