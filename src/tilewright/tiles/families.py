"""Named tile sets: complete, compact, and the published small sets.

Every set is built from a rule that says which colors its tiles may carry, by which `recognition` tells it
from its slots alone, also when it comes from a file.
"""

from math import prod

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, check_int
from tilewright.errors import TilewrightValueError
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.shape import CORNER, CORNER_CODED, CORNER_CUBE, DOMINO, FREE, WANG, WANG_CUBE, Shape
from tilewright.tiles.tileset import MOST_COLORS, TileSet, check_colors, check_tiles, decode


def _complete(shape: Shape, radices: tuple[int, ...]) -> TileSet:
    return ListedTileSet(shape, decode(np.arange(prod(radices)), radices), radices, "complete")


def dominoes(colors: int = 2) -> TileSet:
    """The complete set of dominoes, C^2 tiles with colored ends E and W (Lagae 2007, section 2.10)."""
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
    """
    return _complete(FREE, (check_int("count", count, 1, MOST_COLORS),))


def wang_tiles(colors: int = 2, vertical_colors: int | None = None) -> TileSet:
    """The complete set of Wang tiles (Lagae 2007, section 2.7).

    Parameters
    ----------
    colors : int
        Number of colors of the horizontal edges N and S, 1 to 16.
    vertical_colors : int, optional
        Number of colors of the vertical edges E and W; the same as ``colors`` by default.
    """
    c_h, c_v = _both(colors, vertical_colors)
    return _complete(WANG, (c_h, c_v, c_h, c_v))


def corner_tiles(colors: int = 2, choices: int | None = None) -> TileSet:
    """Corner tiles: the complete set, or a compact one.

    Parameters
    ----------
    colors : int
        1 to 16.
    choices : int, optional
        How many tiles fit once the NE, NW and SW corners are known. By default all C: the complete set
        of C^4 tiles (Lagae & Dutré 2006, section 3). With fewer, d, the set holds the d C^3 tiles with
        (SE - d NW) mod C < d; 2 gives the compact set of 2 C^3 tiles (Lagae 2007, section 3.2.2), in the
        form for which a direct algorithm exists.
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
    """Corner tiles whose columns are chains: (SW - d NW) mod C < d and (SE - d NE) mod C < d.

    With d = ``choices`` these are (d C)^2 tiles; not every three corners occur together.
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
    """The compact set of 2 C_h C_v Wang tiles for scanline tiling (Lagae 2007, section 3.2.1).

    Two tiles for each pair of N and W colors, b = 0 and 1: S = N + b + 2 W and E = W + b + 2 S. Each pair
    of S and E colors occurs twice as well, so the set also tiles from south-east to north-west.
    """
    c_h, c_v = _both(colors, vertical_colors)
    n, w, b = (a.ravel() for a in np.indices((c_h, c_v, 2)))
    s = (n + b + 2 * w) % c_h
    e = (w + b + 2 * s) % c_v
    slots = np.unique(np.stack([n, e, s, w], axis=1), axis=0)
    return ListedTileSet(WANG, slots, (c_h, c_v, c_h, c_v), "compact")


def cohen_tiles(count: int = 8) -> TileSet:
    """The sets of 8, 12 and 18 Wang tiles of Cohen et al. 2003, figure 1.

    8 tiles have two colors on either axis, 12 have two on the horizontal edges N and S and three on the
    vertical edges E and W (the figure's caption; its text says the other way round), 18 have three on
    both. The figure is not at hand: these are sets of that size with the properties the text asks for,
    two tiles for each pair of N and W colors and for each pair of S and E colors.
    """
    sizes = {8: (2, 2), 12: (2, 3), 18: (3, 3)}
    if count not in sizes:
        raise TilewrightValueError(f"count is {count!r}; Cohen's sets have 8, 12 or 18 tiles")
    return compact_wang_tiles(*sizes[count])


def summed_wang_tiles(colors: int = 2) -> TileSet:
    """The compact set of C^3 Wang tiles whose edge colors are sums of corner colors modulo C.

    N = NW + NE and so on (Lagae 2007, section 3.3.2.2); it has a direct tiling from a single hash.
    """
    c = check_colors(colors)
    ne, se, sw, nw = _complete(CORNER, (c,) * 4).slots.astype(int).T
    slots = np.stack([nw + ne, ne + se, se + sw, sw + nw], axis=1) % c
    return ListedTileSet(WANG, np.unique(slots, axis=0), (c,) * 4, "summed")


def shifted_wang_tiles(colors: int = 2) -> TileSet:
    """2 C^2 Wang tiles, C a power of two, with a direct tiling from one bit per tile.

    A bit b enters on either axis: S = 2 N + b and E = 2 W + b modulo C.
    """
    c = check_colors(colors, 2)
    if c & (c - 1):
        raise TilewrightValueError(f"colors is {c}; the shifted set needs a power of two: 2, 4, 8 or 16")
    n, w, b = (a.ravel() for a in np.indices((c, c, 2)))
    slots = np.stack([n, (2 * w + b) % c, (2 * n + b) % c, w], axis=1)
    return ListedTileSet(WANG, slots, (c,) * 4, "shifted")


def corner_coded_tiles(base: TileSet | None = None, *, scanline_only: bool = False) -> TileSet:
    """A Wang set with every combination of marked and unmarked corners (Cohen et al. 2003, section 3.4).

    Parameters
    ----------
    base : TileSet, optional
        A set of Wang tiles; Cohen's 8 tiles by default, which gives 128.
    scanline_only : bool
        Keep half of them: three corners of a tile are known when it is placed in scanline order, so the
        fourth may follow from them and the edges. Here the SE mark is the parity of the other marks and of
        the tile's rank among those with the same N and W edges, which leaves the choice random.
    """
    base = cohen_tiles(8) if base is None else check_tiles("base", base)
    if base.shape is not WANG:
        raise TilewrightValueError(f"base must be a set of Wang tiles, not of {base.shape.name} ones")
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
    """Complete Wang tiles that also know the edges crossing at their corners (Lagae 2007, section 4.3).

    C^12 tiles: a tile's own four edges and the eight others that meet its corners. The color of a corner
    is ((north C + east) C + south) C + west of the edges around it. A tiling of these is a Wang tiling in
    which each tile's corners are told apart by all that meets there, which solves the corner problem.

    Parameters
    ----------
    colors : int
        1 or 2; three colors would make 531,441 tiles.
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


def tile_set(slots: object, shape: str = "wang", *, name: str = "custom") -> TileSet:
    """A set of one's own from a table of slot colors, one row per tile.

    Parameters
    ----------
    slots : array-like of int, shape (T, S)
        Columns in the order of the shape: N, E, S, W; NE, SE, SW, NW; see `Shape`.
    shape : str
        ``"domino"``, ``"wang"``, ``"corner"``, ``"corner-coded"``, ``"wang-cube"``, ``"corner-cube"`` or
        ``"free"``.
    """
    shapes = {s.name: s for s in (DOMINO, WANG, CORNER, CORNER_CODED, WANG_CUBE, CORNER_CUBE, FREE)}
    return ListedTileSet(shapes[check_choice("shape", shape, tuple(shapes))], slots, name=name)  # type: ignore[arg-type]


def as_wang_tiles(corners: TileSet) -> TileSet:
    """The Wang set equivalent to a corner set: an edge color for each pair of corner colors that occurs.

    The pairs (west, east) on N and S edges are numbered in ascending order, those (north, south) on E and W
    edges likewise, from 0 on (Lagae 2007, section 8.4). In a complete set all pairs occur and the color of
    an edge whose ends are a and b is a C + b (section 2.9).
    """
    if check_tiles("corners", corners).shape is not CORNER:
        raise TilewrightValueError(
            f"only corner sets have an equivalent Wang set, not {corners.shape.name} ones"
        )
    c = max(corners.colors)
    ne, se, sw, nw = corners.slots.astype(int).T
    level, n_s = np.unique([nw * c + ne, sw * c + se], return_inverse=True)
    upright, e_w = np.unique([ne * c + se, nw * c + sw], return_inverse=True)
    (n, s), (e, w) = n_s.reshape(2, -1), e_w.reshape(2, -1)
    return ListedTileSet(
        WANG,
        np.stack([n, e, s, w], axis=1),
        (len(level), len(upright)) * 2,
        f"{corners.name} (from corners)",
    )


def _both(colors: int, vertical_colors: int | None) -> tuple[int, int]:
    c_h = check_colors(colors)
    return c_h, c_h if vertical_colors is None else check_colors(vertical_colors, name="vertical_colors")
