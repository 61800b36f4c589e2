"""From Wang sets to corner sets by five constructions that carry tilings over (Lagae 2007, section 8.3).

Each lays the lattice of the corner tiles otherwise over that of the Wang tiles and lists every corner tile
that can then appear. The way back is `as_wang_tiles` (section 8.4).
"""

import warnings

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice
from tilewright.errors import TilewrightValueError, TilewrightWarning
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.shape import CORNER, WANG
from tilewright.tiles.tileset import TileSet, check_tiles

CONSTRUCTIONS = ("diagonal", "horizontal", "vertical", "rotation", "subdivision")

Colors = NDArray[np.int64]


def as_wang_tiles(corners: TileSet) -> TileSet:
    """Make the Wang set that is equivalent to a corner set.

    An edge has a color for each pair of corner colors that occurs at its ends. The pairs (west, east) on N
    and S edges are numbered in ascending order, those (north, south) on E and W edges likewise, from 0 on.

    Parameters
    ----------
    corners : TileSet
        Corner tiles.

    Returns
    -------
    TileSet
        As many Wang tiles, in the same order. In a complete set all pairs occur, and the color of an edge
        whose ends are a and b is a C + b.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set.
    TilewrightValueError
        The set is not of corner tiles.

    Notes
    -----
    Lagae 2007, section 8.4; complete sets in section 2.9.
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


def as_corner_tiles(wang: TileSet, construction: str) -> TileSet:
    """Make a corner set from a Wang set by one of five constructions.

    Parameters
    ----------
    wang : TileSet
        Wang tiles.
    construction : str
        ``"diagonal"`` (8.3.1): a corner tile for every valid 2 x 2 block, colored by the tiles themselves.
        ``"horizontal"`` (8.3.2): one for every two tiles side by side, colored by their N and S edges.
        ``"vertical"`` (8.3.2): one for every two tiles one above the other, colored by their E and W edges.
        ``"rotation"`` (8.3.3): one for every tile and one for the edges at every vertex, colored by edges.
        The colors of N and S edges come first, those of E and W edges after them.
        ``"subdivision"`` (8.3.4): four for every tile, colored by its edges, the tile and one more color.

    Returns
    -------
    TileSet
        If the Wang set is aperiodic so is the corner set, except for a translation that is not sound.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set.
    TilewrightValueError
        Different pairs give the same corner tile in a horizontal or vertical translation ("failed" in table
        8.1), no tiles fit together, the tiles are not Wang tiles, or there is no such construction.

    Warns
    -----
    TilewrightWarning
        A horizontal or vertical translation is not sound (`translation_is_sound`): the corner set can have
        tilings that come from no Wang tiling.

    Notes
    -----
    Lagae 2007, section 8.3; the numbers above are its subsections. `as_wang_tiles` is the way back (8.4).

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.as_corner_tiles(tw.aperiodic_tiles("jeandel-rao-11-5"), "rotation")
    <TileSet jeandel-rao-11-5, rotation: 36 corner tiles, colors (9, 9, 9, 9)>
    """
    # Each construction lays the corner lattice otherwise over the Wang lattice (figures 8.7, 8.8, 8.9, 8.12).
    slots = wang_slots(wang)
    check_choice("construction", construction, CONSTRUCTIONS)
    if construction in ("horizontal", "vertical"):
        made, colors = _translate(slots, construction), wang.colors[construction == "vertical"]
        if not translation_is_sound(wang, construction):
            ends = "N and S" if construction == "horizontal" else "E and W"
            warnings.warn(
                f"the {wang.name} set has tiles that differ, yet not at {ends}: the corner set by "
                f"{construction} translation may have tilings that no Wang tiling gives, also periodic ones",
                TilewrightWarning,
                stacklevel=2,
            )
    elif construction == "diagonal":
        # 8.3.1: a corner lies in the middle of a Wang tile and has its number for a color.
        made, colors = blocks(slots)[:, [1, 3, 2, 0]], len(slots)
    elif construction == "rotation":
        made, colors = _rotate(slots)
    else:
        made = subdivide(slots, np.arange(len(slots)), max(wang.colors))
        colors = max(wang.colors) + len(slots) + 1
    if not len(made):
        raise TilewrightValueError(
            f"no tiles of the {wang.name} set fit together; there is nothing to translate"
        )
    return ListedTileSet(CORNER, made, (int(colors),) * 4, f"{wang.name}, {construction}")


def translation_is_sound(wang: TileSet, construction: str) -> bool:
    """Tell whether every tiling by the translated set comes from one tiling by the Wang set.

    It does where the N and S colors of a Wang tile determine the tile (horizontal translation), or its E
    and W colors (vertical).

    Parameters
    ----------
    wang : TileSet
        Wang tiles.
    construction : str
        ``"horizontal"`` or ``"vertical"``; the others are always sound.

    Returns
    -------
    bool
        Whether the translation is sound.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set.
    TilewrightValueError
        The tiles are not Wang tiles, or there is no such translation.

    Notes
    -----
    Lagae 2007, section 8.3.2, asks less: that different pairs of tiles give different corner tiles. Then two
    neighbors may take the Wang tile between them for different ones.
    """
    slots = wang_slots(wang)
    check_choice("construction", construction, ("horizontal", "vertical"))
    kept = slots[:, [0, 2]] if construction == "horizontal" else slots[:, [1, 3]]
    return len(np.unique(kept, axis=0)) == len(slots)


def subdivide(slots: Colors, centers: Colors, edge_colors: int) -> Colors:
    """Four corner tiles for each Wang tile, its center colored as given (Lagae 2007, section 8.3.4).

    The colors are those of the edges, then those of the centers, then one more for the corners. A corner tile
    that several Wang tiles give is there once. Slots NE, SE, SW, NW.
    """
    n, e, s, w = slots.T
    center = edge_colors + centers
    star = np.full(len(slots), edge_colors + int(centers.max()) + 1)
    quarters = [(n, center, w, star), (star, e, center, n), (e, star, s, center), (center, s, star, w)]
    return distinct(np.concatenate([np.stack(quarter, axis=1) for quarter in quarters]))


def beside(slots: Colors) -> tuple[Colors, Colors]:
    """All pairs of tiles that fit side by side: indices of the west ones and of the east ones."""
    return join(slots[:, 1], slots[:, 3])


def above(slots: Colors) -> tuple[Colors, Colors]:
    """All pairs of tiles that fit one above the other: indices of the north ones and of the south ones."""
    return join(slots[:, 2], slots[:, 0])


def blocks(slots: Colors) -> Colors:
    """All valid 2 x 2 blocks, shape (B, 4): the tiles at NW, NE, SW, SE."""
    west, east = beside(slots)
    south_sides = _numbers(slots[west, 2], slots[east, 2])
    north_sides = _numbers(slots[west, 0], slots[east, 0])
    upper, lower = join(south_sides, north_sides)
    return np.stack([west[upper], east[upper], west[lower], east[lower]], axis=1)


def wang_slots(wang: TileSet) -> Colors:
    """Slots N, E, S, W of a set of Wang tiles, as int64."""
    shape = check_tiles("wang", wang).shape
    if shape is not WANG:
        raise TilewrightValueError(
            f"must be a set of Wang tiles, not of {shape.name} ones",
            argument="wang",
            value=shape.name,
            allowed="a set of Wang tiles",
        )
    return wang.slots.astype(np.int64)


def join(left: Colors, right: Colors) -> tuple[Colors, Colors]:
    """All pairs of positions (i, j) with left[i] == right[j], ordered by i, then j."""
    order = np.argsort(right, kind="stable")
    ordered = right[order]
    first = np.searchsorted(ordered, left, "left")
    count = np.searchsorted(ordered, left, "right") - first
    i = np.repeat(np.arange(len(left)), count)
    within = np.arange(len(i)) - np.repeat(np.cumsum(count) - count, count)
    return i, order[np.repeat(first, count) + within]


def count_pairs(left: Colors, right: Colors) -> int:
    """How many pairs `join` would find, for small numbers from 0 on."""
    most = int(max(left.max(initial=0), right.max(initial=0))) + 1
    return int(np.bincount(left, minlength=most) @ np.bincount(right, minlength=most))


def distinct(rows: Colors) -> Colors:
    """The rows, each once, in ascending order."""
    return np.unique(rows, axis=0)


def _numbers(a: Colors, b: Colors) -> Colors:
    """One number for each pair of colors."""
    return a.astype(np.int64) * 2**31 + b


def _translate(slots: Colors, construction: str) -> Colors:
    """Corner tiles between two Wang tiles (Lagae 2007, section 8.3.2)."""
    n, e, s, w = slots.T
    # Step 1: every two tiles that fit; a corner has the color of the edge in whose middle it lies.
    if construction == "horizontal":
        # The lattice lies half a tile further east: corners are on N and S edges, the tiles' shared edge is
        # ignored.
        a, b = beside(slots)
        pairs = np.stack([n[b], s[b], s[a], n[a]], axis=1)
    else:
        # The lattice lies half a tile further south: corners are on E and W edges.
        a, b = above(slots)
        pairs = np.stack([e[a], e[b], w[b], w[a]], axis=1)
    # Step 2: two different pairs must not give the same corner tile, or the way back would be lost.
    made = distinct(pairs)
    if len(made) < len(pairs):
        raise TilewrightValueError(
            f"{construction} translation fails: {len(pairs)} different pairs of tiles give only "
            f"{len(made)} corner tiles",
            advice="try rotation, which works for every set",
        )
    return made


def _rotate(slots: Colors) -> tuple[Colors, int]:
    """White tiles (one Wang tile) and black ones (the edges that meet at a vertex), and their colors.

    A white tile's corners NE, SE, SW, NW are its edges N, E, S, W; a black one's are the edges that lead
    north, east, south and west from the vertex. The two kinds alternate by themselves: only white tiles have
    colors of N and S edges at NE and SW, only black ones have them at SE and NW.

    Lagae 2007, section 8.3.3; departs from it in these colors: there a checkers set (figure 8.10) is laid
    over the tiles to make white and black alternate.
    """
    # Step 1: number the colors of N and S edges, and those of E and W edges after them.
    level, n_s = np.unique(slots[:, [0, 2]], return_inverse=True)
    upright, e_w = np.unique(slots[:, [1, 3]], return_inverse=True)
    n, s = n_s.reshape(-1, 2).T
    e, w = (e_w.reshape(-1, 2) + len(level)).T
    # Step 2: white tiles, turned by 45 degrees: each corner lies on an edge of one Wang tile.
    white = np.stack([n, e, s, w], axis=1)
    # Step 3: black tiles, between four Wang tiles: each corner lies on one of the edges that meet there.
    nw, ne, sw, _ = blocks(slots).T
    black = np.stack([e[nw], s[ne], e[sw], s[nw]], axis=1)
    return np.concatenate([white, distinct(black)]), len(level) + len(upright)
