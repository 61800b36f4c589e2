"""The parts that a Poisson disk radius divides tiles into, and which of them make up each tile.

Points closer than r to the border of a tile concern its neighbors. The strips along the edges are cut
back at the lattice points until points of two strips are at least 2r apart; what is left there are the
corner regions (Lagae & Dutré 2006, section 7.1). A *part* is a corner region around a lattice point, a
strip of width 2r along an edge, or the interior of a tile; a *frame* is all corner regions and strips.
"""

from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tiles import CORNER, CORNER_CODED, TileSet

# Where a tile's eight frame items lie: corners NE, SE, SW, NW; edges N, S; edges E, W.
OFFSETS = np.array([(1, 0), (1, 1), (0, 1), (0, 0), (0, 0), (0, 1), (1, 0), (0, 0)], np.float64)
CORNER_PART, ROW_EDGE, COLUMN_EDGE, INTERIOR = 0, 1, 2, 3
"""Kinds of parts; a row edge lies along x."""


@dataclass(frozen=True)
class Regions:
    """The shapes of the parts.

    Attributes
    ----------
    radius : float
        The Poisson disk radius r in tile lengths.
    shape : str
        ``"octagon"``, the corner region of the papers: half-width r (1 + sqrt 2), side 2r. ``"cusp"``, a
        smaller one that gives the same distances: |y| <= r and |x| <= sqrt 2 r + |y|, and the same with
        x and y exchanged. Their areas are (8 + 8 sqrt 2) r^2 and 8 sqrt 2 r^2.

    Notes
    -----
    Why the cusp keeps strips 2r apart: let (x, y) lie in a strip along the x axis and (u, v) in one along
    the y axis, in the same quadrant or nearer than that; then x - |u| >= sqrt 2 r + |y| - |u| and
    v - |y| >= sqrt 2 r + |u| - |y|, and the sum of the squares is 4 r^2 + 2 (|y| - |u|)^2.
    Strips on opposite sides of a lattice point are 2 sqrt 2 r apart, a strip and an interior that does
    not touch it (1 + sqrt 2) r, interiors 2r across an edge and 2 sqrt 2 r across a corner.
    """

    radius: float
    shape: str = "cusp"

    @property
    def is_cusp(self) -> bool:
        """Whether corner regions are cusps, as kernels take it."""
        return self.shape == "cusp"


LARGEST_RADIUS = 1 / (4 + 2 * sqrt(2))
"""In tiles: with larger disks the regions around two corners of a tile would be less than 2r apart."""


@dataclass(frozen=True, eq=False)
class Anatomy:
    """Which frame items surround each tile, and which items surround each item.

    Items are numbered corners first, then row edges (along x), then column edges (along y). The points of
    an item are given as seen from its lattice point: an edge's west or north end.

    Attributes
    ----------
    items : int32 array, shape (T, 8)
        Items of each tile in the order of `OFFSETS`.
    kinds : int8 array, shape (items,)
        0 corner, 1 row edge, 2 column edge.
    """

    items: NDArray[np.int32]
    kinds: NDArray[np.int8]

    @property
    def weights(self) -> NDArray[np.float64]:
        """How many times each item occurs for each tile, on average: 1 / C, 1 / C^2 in corner sets."""
        total = np.bincount(self.items.ravel(), minlength=len(self.kinds)) / len(self.items)
        per_tile = np.array([4.0, 2.0, 2.0])[self.kinds]
        return total / per_tile

    def meetings(self) -> tuple[NDArray[np.int32], NDArray[np.float64], NDArray[np.int32]]:
        """For each item the items that can touch it: numbers (items, n), places (items, n, 2), counts.

        Strips touch corner regions only; corner regions touch strips only.
        """
        found: list[set[tuple[int, int, int]]] = [set() for _ in self.kinds]
        for a in range(8):
            for b in range(8):
                if (a < 4) == (b < 4) or not _touch(a, b):
                    continue
                gap = OFFSETS[b] - OFFSETS[a]
                for one, other in np.unique(self.items[:, [a, b]], axis=0).tolist():
                    found[one].add((other, int(gap[0]), int(gap[1])))
        most = max(len(f) for f in found)
        numbers = np.zeros((len(found), most), np.int32)
        places = np.zeros((len(found), most, 2))
        counts = np.array([len(f) for f in found], np.int32)
        for item, near in enumerate(found):
            for k, (other, dx, dy) in enumerate(sorted(near)):
                numbers[item, k] = other
                places[item, k] = dx, dy
        return numbers, places, counts


def _touch(a: int, b: int) -> bool:
    """Whether slots a and b of a tile, one of them a corner, lie next to each other."""
    corner, edge = (a, b) if a < 4 else (b, a)
    ends = {4: (3, 0), 5: (2, 1), 6: (0, 1), 7: (3, 2)}
    return corner in ends[edge]


def anatomy_of(tiles: TileSet) -> Anatomy:
    """The frame items of corner tiles, or of Wang tiles that know the edges crossing at their corners.

    Corner tiles over C colors have C corners, C^2 row edges by (west, east) color and C^2 column edges by
    (north, south) color (Lagae 2007, section 4.5); `crossed_wang_tiles` have C^4 corners by the edges that
    meet there and C edges of either kind (section 4.3).
    """
    slots = tiles.slots.astype(np.int32).T
    if tiles.shape is CORNER:
        ne, se, sw, nw = slots
        corners = c = max(tiles.colors)
        edges = c * c
        n, s, e, w = nw * c + ne, sw * c + se, ne * c + se, nw * c + sw
    elif tiles.shape is CORNER_CODED:
        n, e, s, w, ne, se, sw, nw = slots
        corners, edges = max(tiles.colors[4:]), max(tiles.colors[:4])
        _check_crossings(tiles, edges)
    else:
        raise TilewrightValueError(
            "points keep their distance over corner tiles, such as corner_tiles(4), or over "
            f"crossed_wang_tiles(2); the {tiles.name} set of {tiles.shape.name} tiles does not say what "
            "meets at its corners"
        )
    rows, columns = corners, corners + edges
    items = np.stack([ne, se, sw, nw, rows + n, rows + s, columns + e, columns + w], axis=1)
    kinds = np.repeat(np.array([CORNER_PART, ROW_EDGE, COLUMN_EDGE], np.int8), [corners, edges, edges])
    return Anatomy(items.astype(np.int32), kinds)


def _check_crossings(tiles: TileSet, c: int) -> None:
    """Corner colors must be the edges that meet there: ((north C + east) C + south) C + west."""
    n, e, s, w, ne, se, sw, nw = tiles.slots.astype(np.int64).T
    south, west, east, north = (
        lambda x: x // c % c,
        lambda x: x % c,
        lambda x: x // c**2 % c,
        lambda x: x // c**3,
    )
    agree = [
        (west(ne), n), (south(ne), e), (north(se), e), (west(se), s),
        (north(sw), w), (east(sw), s), (east(nw), n), (south(nw), w),
    ]  # fmt: skip
    if set(tiles.colors[4:]) != {c**4} or any((a != b).any() for a, b in agree):
        raise TilewrightValueError(
            f"the corners of the {tiles.name} set do not name the edges that meet there, as those of "
            "crossed_wang_tiles(2) do"
        )
