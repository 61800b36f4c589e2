"""Smaller sets out of larger ones: colors that become one, and center colors that tiles can share."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, range_error
from tilewright.errors import TilewrightValueError
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.shape import CORNER
from tilewright.tiles.tileset import MOST_COLORS, TileSet, check_tiles
from tilewright.tiles.translations import distinct, subdivide, wang_slots

_MOST_GROUPED = 20
"""Tiles of a set whose groupings are searched: there are 2^20 subsets."""


def merge_colors(tiles: TileSet, mapping: ArrayLike, name: str | None = None) -> TileSet:
    """Make the set in which colors have become one.

    Every tiling by ``tiles`` gives one by the result; `check_lifting` finds out whether the reverse holds.

    Parameters
    ----------
    tiles : TileSet
        Corner tiles.
    mapping : array-like of int, shape (C,)
        The new color of each of the set's C colors, 0 to 2^15 - 1.
    name : str, optional
        What messages and files call the result; by default the name of ``tiles`` and "merged".

    Returns
    -------
    TileSet
        Tiles that have become equal are there once, in ascending order of their colors.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set, or colors that are not integers.
    TilewrightValueError
        The tiles are not corner tiles, or the mapping has another length or colors out of range.
    """
    if check_tiles("tiles", tiles).shape is not CORNER:
        raise TilewrightValueError(
            f"must be a set of corner tiles, not of {tiles.shape.name} ones",
            argument="tiles",
            value=tiles.shape.name,
            allowed="a set of corner tiles",
        )
    new = check_mapping(mapping, tiles)
    slots = distinct(new[tiles.slots.astype(np.int64)])
    return ListedTileSet(CORNER, slots, name=f"{tiles.name}, merged" if name is None else name)


def check_mapping(mapping: ArrayLike, tiles: TileSet) -> NDArray[np.int64]:
    """A new color, 0 or more, for each color of a corner set."""
    new = as_integers("mapping", mapping)
    if new.shape != (tiles.colors[0],):
        raise TilewrightValueError(
            f"has shape {new.shape}; the set has {tiles.colors[0]} colors",
            argument="mapping",
            value=new.shape,
        )
    if new.min() < 0 or new.max() >= MOST_COLORS:
        raise range_error("mapping", new, f"0 to {MOST_COLORS - 1}")
    return new.astype(np.int64)


@dataclass(frozen=True)
class Grouping:
    """A subdivision in which tiles share center colors, and how it came about.

    Attributes
    ----------
    tiles : TileSet
    classes : tuple of tuple of int
        The Wang tiles that share each center color.
    plain : int
        How many corner tiles there are when no two Wang tiles share one.
    """

    tiles: TileSet
    classes: tuple[tuple[int, ...], ...]
    plain: int


def grouped_subdivision(wang: TileSet) -> Grouping:
    """Subdivide Wang tiles into the fewest corner tiles, letting Wang tiles share center colors.

    A class of Wang tiles may share one if quarters of its tiles fit around a center only where they make up a
    tile of the set. So every tiling by the result comes from one by ``wang``, and where that is aperiodic so
    is the result. Of all partitions into such classes this is the one with the fewest corner tiles, then with
    the fewest classes: an exact optimum, by dynamic programming over all subsets.

    Parameters
    ----------
    wang : TileSet
        Up to 20 Wang tiles; 20 of them take about 20 seconds.

    Returns
    -------
    Grouping
        ``tiles``, the corner set; ``classes``, the Wang tiles that share each center color; ``plain``, the
        number of corner tiles when none share.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set.
    TilewrightValueError
        There are more tiles, or they are not Wang tiles.

    Notes
    -----
    Lagae 2007, section 8.3.4, mentions such groupings without a rule or an optimum; both are ours.
    """
    slots = wang_slots(wang)
    count = len(slots)
    if count > _MOST_GROUPED:
        raise TilewrightValueError(
            f"the {wang.name} set has {count} tiles; groupings are searched of up to {_MOST_GROUPED}"
        )
    classes = _cheapest_partition([tuple(tile) for tile in slots.tolist()])
    center = np.empty(count, np.int64)
    for color, members in enumerate(classes):
        center[list(members)] = color
    edge_colors = max(wang.colors)
    made = subdivide(slots, center, edge_colors)
    tiles = ListedTileSet(
        CORNER, made, (edge_colors + len(classes) + 1,) * 4, f"{wang.name}, grouped subdivision"
    )
    return Grouping(tiles, classes, 4 * count)


_QUARTERS = ((0, 3), (0, 1), (2, 1), (2, 3))
"""The two edges that each quarter of a Wang tile holds: NW, NE, SE, SW."""

Tile = tuple[int, ...]


def _cheapest_partition(tiles: list[Tile]) -> tuple[tuple[int, ...], ...]:
    """Dynamic programming over subsets, as bit masks: a class for the lowest tile, then the rest.

    Of partitions that cost the same it takes the one whose class of the lowest tile is largest.
    """
    count = len(tiles)
    classes = sorted(_admissible_classes(tiles), key=lambda c: -c.bit_count())
    # A class costs its distinct quarters; a little more for each class, so that ties go to few of them.
    costs = [64 * sum(map(len, _quarters(tiles, c))) + 1 for c in classes]
    best = np.zeros(2**count, np.int64)
    choice = np.zeros(2**count, np.int64)
    for tile in range(count - 1, -1, -1):
        rest = np.arange(2 ** (count - 1 - tile)) << (tile + 1)
        least = np.full(len(rest), np.iinfo(np.int64).max)
        chosen = np.zeros(len(rest), np.int64)
        for mask, cost in zip(classes, costs, strict=True):
            if mask & -mask == 1 << tile:
                others = mask ^ (1 << tile)
                total = np.where(rest & others == others, best[rest & ~others] + cost, least)
                chosen[total < least] = mask
                np.minimum(least, total, out=least)
        best[rest | 1 << tile], choice[rest | 1 << tile] = least, chosen
    left, found = 2**count - 1, []
    while left:
        found.append(tuple(_members(int(choice[left]))))
        left &= ~int(choice[left])
    return tuple(found)


def _admissible_classes(tiles: list[Tile]) -> list[int]:
    """Masks of all classes whose quarters make up only tiles of the set; subsets of such are such."""
    known = set(tiles)
    level = [1 << t for t in range(len(tiles))]
    found = list(level)
    while level:
        grown = [c | 1 << t for c in level for t in range(c.bit_length(), len(tiles))]
        level = [c for c in grown if _mixtures(_quarters(tiles, c)) <= known]
        found += level
    return found


def _members(mask: int) -> list[int]:
    return [t for t in range(mask.bit_length()) if mask >> t & 1]


def _quarters(tiles: list[Tile], mask: int) -> list[set[Tile]]:
    """The distinct NW, NE, SE and SW quarters of the tiles in a class, as pairs of edges."""
    return [{(tiles[t][a], tiles[t][b]) for t in _members(mask)} for a, b in _QUARTERS]


def _mixtures(quarters: list[set[Tile]]) -> set[Tile]:
    """Every tile (N, E, S, W) that can be put together from the quarters."""
    n_w, n_e, s_e, s_w = quarters
    return {
        (n, e, s, w)
        for n, w in n_w
        for n_too, e in n_e
        if n_too == n
        for s, e_too in s_e
        if e_too == e and (s, w) in s_w
    }
