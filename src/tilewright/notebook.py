"""Small pictures of things for notebooks: what `_repr_png_` gives of tiles, tilings, textures and points."""

import io
from functools import singledispatch
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.export.display import screen_bytes
from tilewright.export.drawing.tiles import paint_tiles, paint_tiling
from tilewright.fields import PixelField, PointField, PointWindow
from tilewright.pixels import as_rgba
from tilewright.samplers import PointSet
from tilewright.signals.points import PointTiles
from tilewright.signals.textures import TextureTiles
from tilewright.tiles import TileSet
from tilewright.tilings import Domain, Tiling

Picture = NDArray[np.uint8]

WIDTH, HEIGHT = 640, 400
"""Pixels of pictures, at most."""
_MOST_TILES = 256
"""Of a set that is shown."""
_DOT = 2.0
"""Radius of points in pixels."""
_SPARE = 0.6
"""Of a picture: how much of it dots may cover before they get smaller."""


def paint_png(thing: Any) -> bytes | None:
    """Paint a small picture of a thing, as notebooks show it.

    Parameters
    ----------
    thing : TileSet, Tiling, TextureTiles, PixelField, PointTiles, PointField, PointSet or PointWindow
        What is to be seen; anything else has no picture.

    Returns
    -------
    bytes or None
        A PNG of up to 640 x 400 pixels; None of sets of more than 256 tiles, of volumes, and of things of no
        kind above.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.paint_png(tw.corner_tiles(2))[1:4]
    b'PNG'
    """
    from PIL import Image

    pixels = paint(thing)
    if pixels is None:
        return None
    image = Image.fromarray(pixels)
    image.thumbnail((WIDTH, HEIGHT), Image.Resampling.BOX)
    stream = io.BytesIO()
    image.save(stream, "PNG")
    return stream.getvalue()


@singledispatch
def paint(thing: Any) -> Picture | None:
    """A picture of a thing, uint8, shape (h, w, 3 or 4), of any size; None where there is nothing to see."""
    return None


@paint.register
def _(tiles: TileSet) -> Picture | None:
    return paint_tiles(tiles) if tiles.shape.dimension == 2 and len(tiles) <= _MOST_TILES else None


@paint.register
def _(tiling: Tiling) -> Picture | None:
    if tiling.tiles.shape.dimension != 2:
        return None
    return paint_tiling(tiling, *_window(tiling.domain, 20, 12), size=WIDTH // 20)


@paint.register
def _(material: TextureTiles) -> Picture | None:
    tiles = material.pixels[:_MOST_TILES]
    columns = max(1, round((len(tiles) * WIDTH / HEIGHT) ** 0.5))
    step = max(1, tiles.shape[1] * columns // WIDTH)
    shown = _as_color(tiles[:, ::step, ::step], material.kinds[material.main])
    side, gap = shown.shape[1], 4
    height, width = (n * (side + gap) - gap for n in (ceil(len(tiles) / columns), columns))
    sheet = np.zeros((height, width, 4), np.uint8)
    for number, tile in enumerate(shown):
        top, left = (n * (side + gap) for n in divmod(number, columns))
        sheet[top : top + side, left : left + side] = tile
    return sheet


@paint.register
def _(field: PixelField) -> Picture | None:
    return _as_color(field.render(*_window(field.domain, WIDTH, HEIGHT)), field.maps[field.main].kind)


@paint.register
def _(tiles: PointTiles) -> Picture | None:
    """The first variant of the first tiles, a gap of a tenth between them."""
    count, columns, pitch = min(len(tiles.tiles), 40), 8, 1.1
    columns = min(count, columns)
    places = [np.array([t % columns, t // columns]) * pitch + tiles.tile(t) for t in range(count)]
    extent = columns * pitch - 0.1, ceil(count / columns) * pitch - 0.1
    frames = [(t % columns * pitch, t // columns * pitch) for t in range(count)]
    return _dots(np.concatenate(places), (0, 0), extent, frames)


@paint.register
def _(field: PointField) -> Picture | None:
    """About two thousand points; fewer in a small domain."""
    side = max(1, round((2000 / max(field.tiles.density, 1e-9) / 1.6) ** 0.5))
    x, y, width, height = _window(field.tiling.domain, max(1, round(1.6 * side)), side)
    return _dots(field.points(x, y, width, height), (x, y), (width, height))


@paint.register
def _(points: PointSet) -> Picture | None:
    extent = points.box.extent
    return _dots(points.points, (0, 0), (extent[0], extent[1])) if len(extent) == 2 else None


@paint.register
def _(window: PointWindow) -> Picture | None:
    if not len(window.points):
        return None
    low, high = window.points.min(axis=0), window.points.max(axis=0)
    return _dots(window.points, low, np.maximum(high - low, 1e-12))


def _window(domain: Domain, width: int, height: int) -> tuple[int, int, int, int]:
    """A window of at most that size, from the origin of a domain on."""
    first, extent = [], []
    for count, bound, period in zip((width, height), domain.bounds, domain.periods, strict=True):
        low, high = bound or (0, period or count)
        first.append(low)
        extent.append(min(count, high - low))
    return first[0], first[1], extent[0], extent[1]


def _as_color(pixels: NDArray[Any], kind: str) -> Picture:
    shown = screen_bytes(pixels, kind == "color").pixels
    return as_rgba(shown)


def _dots(
    points: ArrayLike,
    corner: ArrayLike,
    extent: ArrayLike,
    frames: list[tuple[float, float]] | None = None,
) -> Picture:
    """Points of a rectangle as black dots on white, drawn four times as large and made smaller."""
    from PIL import Image, ImageDraw

    at = np.asarray(points, np.float64) - np.asarray(corner, np.float64)
    width, height = np.asarray(extent, np.float64)
    scale = min(WIDTH / width, HEIGHT / height)
    size = max(1, round(width * scale)), max(1, round(height * scale))
    radius = min(_DOT, (_SPARE * size[0] * size[1] / (np.pi * max(len(at), 1))) ** 0.5)
    image = Image.new("RGB", (4 * size[0], 4 * size[1]), "white")
    pencil = ImageDraw.Draw(image)
    for x, y in frames or ():
        pencil.rectangle([4 * scale * n for n in (x, y, x + 1, y + 1)], outline="#c8c8c8", width=4)
    for x, y in (4 * scale * at).tolist():
        pencil.ellipse((x - 4 * radius, y - 4 * radius, x + 4 * radius, y + 4 * radius), fill="black")
    return np.asarray(image.resize(size, Image.Resampling.BOX))
