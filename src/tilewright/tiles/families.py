"""Named tile sets: complete, compact, and the published small sets."""

import numpy as np

from tilewright.errors import check_int
from tilewright.tiles.shape import CORNER, WANG
from tilewright.tiles.tileset import TileSet, decode


def wang_tiles(colors: int = 2, vertical_colors: int | None = None) -> TileSet:
    """The complete set of Wang tiles (Lagae 2007, section 2.7).

    Parameters
    ----------
    colors : int
        Number of colors of the horizontal edges N and S, 1 to 16.
    vertical_colors : int, optional
        Number of colors of the vertical edges E and W; the same as ``colors`` by default.
    """
    c_h = check_int("colors", colors, 1, 16)
    c_v = c_h if vertical_colors is None else check_int("vertical_colors", vertical_colors, 1, 16)
    radices = (c_h, c_v, c_h, c_v)
    return TileSet(WANG, decode(np.arange((c_h * c_v) ** 2), radices), radices, "complete")


def corner_tiles(colors: int = 2) -> TileSet:
    """The complete set of corner tiles over 1 to 16 colors (Lagae & Dutré 2006, section 3)."""
    radices = (check_int("colors", colors, 1, 16),) * 4
    return TileSet(CORNER, decode(np.arange(radices[0] ** 4), radices), radices, "complete")
