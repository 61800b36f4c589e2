"""Named tile sets: complete, compact, and the published small sets.

Every set is built from a rule that says which colors its tiles may carry, by which `recognition` tells it
from its slots alone, also when it comes from a file.
"""

from math import prod

import numpy as np

from tilewright.checks import check_choice, check_int
from tilewright.errors import TilewrightValueError
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.shape import CORNER, CORNER_CODED, CORNER_CUBE, DOMINO, FREE, WANG, WANG_CUBE, Shape
from tilewright.tiles.tileset import MOST_COLORS, TileSet, check_colors, decode


def _complete(shape: Shape, radices: tuple[int, ...]) -> TileSet:
    return ListedTileSet(shape, decode(np.arange(prod(radices)), radices), radices, "complete")


def dominoes(colors: int = 2) -> TileSet:
    """Make the complete set of dominoes: C^2 tiles with colored ends E and W.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 to 16; default 2.

    Returns
    -------
    TileSet
        C^2 tiles, slots E, W.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is out of range.

    Notes
    -----
    Lagae 2007, section 2.10.
    """
    return _complete(DOMINO, (check_colors(colors),) * 2)


def free_tiles(count: int = 2) -> TileSet:
    """Tiles that may meet anywhere, without edges or corners: the tiles of dappled tilings.

    Parameters
    ----------
    count : int
        Number of tiles, 1 to 32,768.

    Returns
    -------
    TileSet
        Its one slot, ``tile``, is the tile's index.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is out of range.
    """
    return _complete(FREE, (check_int("count", count, 1, MOST_COLORS),))


def wang_tiles(colors: int = 2, vertical_colors: int | None = None) -> TileSet:
    """Make the complete set of Wang tiles.

    Parameters
    ----------
    colors : int, optional
        Number of colors of the horizontal edges N and S, 1 to 16; default 2.
    vertical_colors : int, optional
        Number of colors of the vertical edges E and W, 1 to 16; by default the same as ``colors``.

    Returns
    -------
    TileSet
        C_h^2 C_v^2 tiles, slots N, E, S, W.

    Raises
    ------
    TilewrightTypeError
        A number is not an integer.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Lagae 2007, section 2.7.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.wang_tiles(2)
    <TileSet complete: 16 wang tiles, colors (2, 2, 2, 2)>
    >>> tw.wang_tiles(2).slots[5]
    array([0, 1, 0, 1], dtype=uint8)
    """
    c_h, c_v = _both(colors, vertical_colors)
    return _complete(WANG, (c_h, c_v, c_h, c_v))


def corner_tiles(colors: int = 2, choices: int | None = None) -> TileSet:
    """Make a set of corner tiles: the complete one, or a compact one.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 to 16; default 2.
    choices : int, optional
        How many tiles fit once the NE, NW and SW corners are known, 2 to C; by default C, which is the
        complete set of C^4 tiles. With a smaller number d the set holds the d C^3 tiles for which
        (SE - d NW) mod C < d.

    Returns
    -------
    TileSet
        C^4 or d C^3 tiles, slots NE, SE, SW, NW.

    Raises
    ------
    TilewrightTypeError
        A number is not an integer.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    The complete set is that of Lagae & Dutré 2006, section 3. With 2 choices it is the compact set of 2 C^3
    tiles (Lagae 2007, section 3.2.2), in a form for which a direct algorithm exists: its colors make chains
    along the diagonal.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.corner_tiles(2)
    <TileSet complete: 16 corner tiles, colors (2, 2, 2, 2)>
    >>> len(tw.corner_tiles(4)), len(tw.corner_tiles(4, choices=2))
    (256, 128)
    """
    c = check_colors(colors)
    full = _complete(CORNER, (c,) * 4)
    if choices is None or c == 1:
        return full
    d = check_int("choices", choices, 2, c)
    if d == c:
        return full
    _, se, _, nw = full.slots.astype(int).T
    return ListedTileSet(CORNER, full.slots[(se - d * nw) % c < d], (c,) * 4, f"compact-{d}")


def column_corner_tiles(colors: int = 2, choices: int = 2) -> TileSet:
    """Make a compact set of corner tiles whose columns are chains.

    It holds the tiles for which (SW - d NW) mod C < d and (SE - d NE) mod C < d. Not every three corners
    occur together.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 to 16; default 2.
    choices : int, optional
        Colors d that can follow one another down a column, 2 to C; default 2.

    Returns
    -------
    TileSet
        (d C)^2 tiles, slots NE, SE, SW, NW.

    Raises
    ------
    TilewrightTypeError
        A number is not an integer.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    This set is not from a paper; the documentation page on compact sets derives it.
    """
    c = check_colors(colors)
    full = _complete(CORNER, (c,) * 4)
    if c == 1:
        return full
    d = check_int("choices", choices, 2, c)
    ne, se, sw, nw = full.slots.astype(int).T
    keep = ((sw - d * nw) % c < d) & ((se - d * ne) % c < d)
    return ListedTileSet(CORNER, full.slots[keep], (c,) * 4, f"columns-{d}")


def compact_wang_tiles(colors: int = 2, vertical_colors: int | None = None) -> TileSet:
    """Make the compact set of Wang tiles for scanline tiling: two tiles for each pair of N and W colors.

    They are S = N + b + 2 W modulo C_h and E = W + b + 2 S modulo C_v, for b = 0 and 1. Each pair of S and E
    colors occurs twice as well, so the set also tiles from south-east to north-west.

    Parameters
    ----------
    colors : int, optional
        Number of colors C_h of the horizontal edges N and S, 1 to 16; default 2.
    vertical_colors : int, optional
        Number of colors C_v of the vertical edges E and W, 1 to 16; by default the same as ``colors``.

    Returns
    -------
    TileSet
        2 C_h C_v tiles, slots N, E, S, W; fewer where an axis has one color only.

    Raises
    ------
    TilewrightTypeError
        A number is not an integer.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Lagae 2007, section 3.2.1.
    """
    c_h, c_v = _both(colors, vertical_colors)
    n, w, b = (a.ravel() for a in np.indices((c_h, c_v, 2)))
    s = (n + b + 2 * w) % c_h
    e = (w + b + 2 * s) % c_v
    slots = np.unique(np.stack([n, e, s, w], axis=1), axis=0)
    return ListedTileSet(WANG, slots, (c_h, c_v, c_h, c_v), "compact")


def cohen_tiles(count: int = 8) -> TileSet:
    """Make a set of 8, 12 or 18 Wang tiles, as Cohen et al. 2003 use them.

    Parameters
    ----------
    count : int, optional
        Number of tiles; default 8. 8 tiles have two colors on either axis, 12 have two on the horizontal
        edges N and S and three on the vertical edges E and W, 18 have three on both.

    Returns
    -------
    TileSet
        The tiles, slots N, E, S, W.

    Raises
    ------
    TilewrightValueError
        Another number of tiles.

    Notes
    -----
    Cohen et al. 2003, figure 1. Of the set of 12 the figure's caption is followed; the text has the axes the
    other way round. The figure was not at hand: these are sets of that size with the properties the text asks
    for, two tiles for each pair of N and W colors and two for each pair of S and E colors.
    """
    sizes = {8: (2, 2), 12: (2, 3), 18: (3, 3)}
    if count not in sizes:
        raise TilewrightValueError(
            f"is {count!r}; Cohen's sets have 8, 12 or 18 tiles", argument="count", value=count
        )
    return compact_wang_tiles(*sizes[count])


def summed_wang_tiles(colors: int = 2) -> TileSet:
    """Make the compact set of Wang tiles whose edge colors are sums of corner colors modulo C.

    The color of the N edge is NW + NE, and so around the tile. The set has a direct tiling from a single
    hash.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 to 16; default 2.

    Returns
    -------
    TileSet
        C^3 tiles, slots N, E, S, W.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is out of range.

    Notes
    -----
    Lagae 2007, section 3.3.2.2.
    """
    c = check_colors(colors)
    ne, se, sw, nw = _complete(CORNER, (c,) * 4).slots.astype(int).T
    slots = np.stack([nw + ne, ne + se, se + sw, sw + nw], axis=1) % c
    return ListedTileSet(WANG, np.unique(slots, axis=0), (c,) * 4, "summed")


def shifted_wang_tiles(colors: int = 2) -> TileSet:
    """Make a compact set of Wang tiles with a direct tiling from one bit for each tile.

    A bit b enters on either axis: S = 2 N + b and E = 2 W + b modulo C.

    Parameters
    ----------
    colors : int, optional
        Number of colors C: 2, 4, 8 or 16; default 2.

    Returns
    -------
    TileSet
        2 C^2 tiles, slots N, E, S, W.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is not one of these.

    Notes
    -----
    This set is not from a paper; the documentation page on compact sets derives it.
    """
    c = check_colors(colors, 2)
    if c & (c - 1):
        raise TilewrightValueError(
            f"is {c}; the shifted set needs a power of two: 2, 4, 8 or 16", argument="colors", value=c
        )
    n, w, b = (a.ravel() for a in np.indices((c, c, 2)))
    slots = np.stack([n, (2 * w + b) % c, (2 * n + b) % c, w], axis=1)
    return ListedTileSet(WANG, slots, (c,) * 4, "shifted")


def tile_set(slots: object, shape: str = "wang", *, name: str = "custom") -> TileSet:
    """Make a set of your own from a table of slot colors.

    Parameters
    ----------
    slots : array-like of int, shape (T, S)
        The colors of each tile, 0 to 2^15 - 1, a row for each tile. Columns are in the order of the shape: N,
        E, S, W for Wang tiles, NE, SE, SW, NW for corner tiles; see `Shape`.
    shape : str, optional
        ``"domino"``, ``"wang"``, ``"corner"``, ``"corner-coded"``, ``"wang-cube"``, ``"corner-cube"``
        or ``"free"``; default ``"wang"``.
    name : str, optional
        What messages and files call the set; default ``"custom"``.

    Returns
    -------
    TileSet
        The tiles in the order of the rows.

    Raises
    ------
    TilewrightTypeError
        The colors are not integers.
    TilewrightValueError
        There is no such shape, or the set is empty, has a wrong number of slots, a tile twice, or a color out
        of range.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiles = tw.tile_set([[0, 1, 1, 0], [1, 0, 0, 1]], "wang", name="two")
    >>> tiles
    <TileSet two: 2 wang tiles, colors (2, 2, 2, 2)>
    >>> tiles.find([1, 0, 0, 1]).item()
    1
    """
    shapes = {s.name: s for s in (DOMINO, WANG, CORNER, CORNER_CODED, WANG_CUBE, CORNER_CUBE, FREE)}
    return ListedTileSet(shapes[check_choice("shape", shape, tuple(shapes))], slots, name=name)  # type: ignore[arg-type]


def _both(colors: int, vertical_colors: int | None) -> tuple[int, int]:
    c_h = check_colors(colors)
    return c_h, c_h if vertical_colors is None else check_colors(vertical_colors, name="vertical_colors")
