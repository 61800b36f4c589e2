"""A texture over a tiling: pixels of any window of an endless plane."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.fields.agreement import check_agreement
from tilewright.fields.plane import PixelField
from tilewright.fields.tone import add_tone, tone_window
from tilewright.fields.windows import PixelMap, PixelWindow
from tilewright.signals.textures import TextureTiles
from tilewright.tilings import Domain, Tiling
from tilewright.tilings.domain import LARGEST_CELL


class TextureField(PixelField):
    """Texture tiles laid by a tiling.

    Parameters
    ----------
    material : TextureTiles
        The pictures of each tile.
    tiling : Tiling
        A tiling of the same tile set.

    Attributes
    ----------
    material : TextureTiles
        The pictures of each tile.
    tiling : Tiling
        Which tile goes where.

    Raises
    ------
    TilewrightTypeError
        Something else than texture tiles and a tiling.
    TilewrightValueError
        The tiling lays another tile set.

    Notes
    -----
    Pixel (0, 0) is the north-west pixel of cell (0, 0); x grows east and y grows south. Cells reach
    to +-2^61, so pixel coordinates are Python integers of any size up to that many tiles. Variants of tiles
    are drawn as `Tiling.placements` tells.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16)
    >>> field = tw.TextureField(material, tw.direct(material.tiles, seed=7))
    >>> picture = field.render(x=-1000, y=0, width=60, height=40)
    >>> picture.shape
    (40, 60, 3)
    >>> bool((field.render(x=-990, y=10, width=5, height=5) == picture[10:15, 10:15]).all())
    True
    """

    def __init__(self, material: TextureTiles, tiling: Tiling) -> None:
        check_agreement(material, TextureTiles, tiling)
        self.material = material
        self.tiling = tiling
        self.reach = (LARGEST_CELL * material.tile_size,) * 2

    @property
    def domain(self) -> Domain:
        """Where there are pixels, and after how many of them they repeat, x first."""
        return self.tiling.domain.scaled(self.material.tile_size, self.material.tile_size)

    @property
    def maps(self) -> dict[str, PixelMap]:
        """The type, channels and kind of every map; the first is the main one."""
        return {
            name: PixelMap(pixels.dtype, pixels.shape[3], self.material.kinds[name])
            for name, pixels in self.material.maps.items()
        }

    def _paint(self, window: PixelWindow, outs: Mapping[str, NDArray[Any]]) -> None:
        from tilewright.kernels.assembly import copy_tiles

        size = self.material.tile_size
        column, left, columns = _cells(window.x, window.width, size)
        row, top, rows = _cells(window.y, window.height, size)
        pictures = self.tiling.rows(column, row, columns, rows, variants=self.material.variants)
        for map, out in outs.items():
            tiles = self.material.maps[map]
            pixel = tiles.shape[3] * tiles.itemsize
            copy_tiles(
                window.height,
                np.ascontiguousarray(tiles).view(np.uint8).reshape(len(tiles), size, size * pixel),
                pictures,
                top,
                left,
                size,
                pixel,
                out.view(np.uint8).reshape(window.height, window.width * pixel),
            )
        self._lay_tone(window, outs)

    def _lay_tone(self, window: PixelWindow, outs: Mapping[str, NDArray[Any]]) -> None:
        """Add what varies over more than a tile to the maps that have it."""
        tone = self.material.tone
        toned = {} if tone is None else {name: out for name, out in outs.items() if name in tone.maps}
        if tone is None or not toned:
            return
        laid = tone_window(tone, self.tiling.chance, self.tiling.domain, *window)
        for name, out in toned.items():
            add_tone(out, laid, name, self.material.kinds[name])


def _cells(first: int, count: int, size: int) -> tuple[int, int, int]:
    """First cell of a range of pixels, pixels of it to skip, and the number of cells."""
    cell, skipped = divmod(first, size)
    return cell, skipped, (skipped + count - 1) // size + 1
