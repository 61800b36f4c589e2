"""Wang tiles that carry colors at their corners too, so that a tile knows what meets there."""

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.tiles.families import cohen_tiles
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.shape import CORNER_CODED, WANG
from tilewright.tiles.tileset import TileSet, check_tiles, decode


def corner_coded_tiles(base: TileSet | None = None, *, scanline_only: bool = False) -> TileSet:
    """Make a Wang set with every combination of marked and unmarked corners.

    Parameters
    ----------
    base : TileSet, optional
        A set of Wang tiles; by default Cohen's 8 tiles, which gives 128.
    scanline_only : bool, optional
        Whether to keep only half of the tiles; default False. Three corners of a tile are known when it is
        placed in scanline order, so the fourth may follow from them and the edges. Here the SE mark is the
        parity of the other marks and of the tile's rank among those with the same N and W edges, which leaves
        the choice random.

    Returns
    -------
    TileSet
        16 tiles for each one of ``base``, or 8; slots N, E, S, W, NE, SE, SW, NW.

    Raises
    ------
    TilewrightTypeError
        The base is not a tile set.
    TilewrightValueError
        The base is not a set of Wang tiles.

    Notes
    -----
    Cohen et al. 2003, section 3.4.
    """
    base = cohen_tiles(8) if base is None else check_tiles("base", base)
    if base.shape is not WANG:
        raise TilewrightValueError(
            f"must be a set of Wang tiles, not of {base.shape.name} ones",
            argument="base",
            value=base.shape.name,
            allowed="a set of Wang tiles",
        )
    marks = decode(np.arange(16), (2,) * 4)
    slots = np.concatenate([np.repeat(base.slots, 16, axis=0), np.tile(marks, (len(base), 1))], axis=1)
    name = "corner-coded"
    if scanline_only:
        rank = np.repeat(_rank_among_alike(base.slots[:, [0, 3]]), 16)
        ne, se, sw, nw = slots[:, 4:].astype(int).T
        slots = slots[(se + ne + sw + nw + rank) % 2 == 0]
        name = "corner-coded-scanline"
    return ListedTileSet(CORNER_CODED, slots, base.colors + (2,) * 4, name)


def crossed_wang_tiles(colors: int = 2) -> TileSet:
    """Make complete Wang tiles that also know the edges crossing at their corners.

    A tile knows its own four edges and the eight others that meet its corners. The color of a corner is
    ((north C + east) C + south) C + west of the edges around it. A tiling of these is a Wang tiling in which
    each tile's corners are told apart by all that meets there, which solves the corner problem.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 or 2; default 2. Three colors would make 531,441 tiles.

    Returns
    -------
    TileSet
        C^12 tiles, slots N, E, S, W, NE, SE, SW, NW.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is not 1 or 2.

    Notes
    -----
    Lagae 2007, section 4.3.
    """
    c = check_int("colors", colors, 1, 2, "3 would make 531,441 tiles")
    edges = decode(np.arange(c**12), (c,) * 12).astype(int).T
    n, e, s, w = edges[:4]
    # The edges beyond each corner: the column edge and the row edge that lead away from the tile.
    (ne_n, ne_e), (se_e, se_s), (sw_s, sw_w), (nw_w, nw_n) = edges[4:].reshape(4, 2, -1)
    corners = [(ne_n, ne_e, e, n), (e, se_e, se_s, s), (w, s, sw_s, sw_w), (nw_n, n, w, nw_w)]
    codes = [((north * c + east) * c + south) * c + west for north, east, south, west in corners]
    slots = np.stack([n, e, s, w, *codes], axis=1)
    return ListedTileSet(CORNER_CODED, slots, (c,) * 4 + (c**4,) * 4, "crossed")


def _rank_among_alike(rows: NDArray[np.uint8]) -> NDArray[np.int64]:
    """For each row, how many equal rows come before it."""
    seen: dict[bytes, int] = {}
    ranks = np.empty(len(rows), np.int64)
    for t, row in enumerate(rows):
        ranks[t] = seen[row.tobytes()] = seen.get(row.tobytes(), -1) + 1
    return ranks
