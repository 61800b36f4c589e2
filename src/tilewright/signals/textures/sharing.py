"""What tiles that meet have in common: edges and corners by color, and texels made to agree there."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures.kinds import Values
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import MOST_COLORS
from tilewright.tiles.variants import Variants

EQUAL = 2e-6
"""Values as near as this are the same, as a share of the largest: rounding of float32 means."""

_CORNERS = ("NW", "NE", "SW", "SE")
_ENDS = {"N": ("NW", "NE"), "E": ("NE", "SE"), "S": ("SW", "SE"), "W": ("NW", "SW")}
_OPPOSITE = {"N": "S", "S": "N", "W": "E", "E": "W"}
Colors = NDArray[np.int64]


@dataclass(frozen=True)
class Rim:
    """Which of a row of texels are filtered at a tile's border: the one within it, and the one beyond.

    Both are counted from the west or north; mirrored from the east and south. They are the same texel where
    one lies over the border; ``beyond`` is None where the neighbor's own texel is there.
    """

    count: int
    within: int
    beyond: int | None

    @classmethod
    def of_layer(cls, count: int, size: int, gutter: int) -> "Rim":
        """The rim of a level of ``count`` texels across a tile and its gutters."""
        at = gutter * count / (size + 2 * gutter) - 0.5  # the border, in texel centers
        before = int(np.floor(at))
        if before >= 0 and 0.25 <= at - before <= 0.75:
            return cls(count, before + 1, before)
        near = max(0, round(at))
        return cls(count, near, near)

    @property
    def is_single(self) -> bool:
        """Whether one texel lies at both borders."""
        return self.within >= self.count - 1 - self.within


class Shared:
    """What the tiles of a set share: colors of edges and corners by side, for each row of a signal."""

    def __init__(self, tiles: TileSet, variants: Variants) -> None:
        rows = tiles.slots[variants.tiles].astype(np.int64)
        slots = {name: rows[:, n] for n, name in enumerate(tiles.shape.slots)}
        self.corners: dict[str, Colors] = {c: slots[c] for c in _CORNERS if c in slots}
        self.edges: dict[str, Colors] = {}
        for side, ends in _ENDS.items():
            parts = [slots[p] for p in (side, *ends) if p in slots]
            self.edges[side] = sum(
                (p * MOST_COLORS**k for k, p in enumerate(parts)), np.zeros(len(rows), np.int64)
            )
        # Numbers from 0 on, the same for both sides that can meet.
        for pair in (("N", "S"), ("W", "E")):
            both = np.concatenate([self.edges[p] for p in pair])
            _, numbers = np.unique(both, return_inverse=True)
            self.edges |= dict(zip(pair, np.split(numbers.ravel(), 2), strict=True))

    def settle(self, level: Values, rim: Rim) -> tuple[Values, bool]:
        """A level whose texels at borders depend on shared colors alone; whether it did already."""
        if rim.is_single:
            mean = level.mean(axis=0, keepdims=True, dtype=np.float64).astype(np.float32)
            return np.broadcast_to(mean, level.shape), _is_same(level, mean)
        settled = level.copy()
        self._settle_edges(level, rim, settled, "W", "E")
        self._settle_edges(level, rim, settled, "N", "S")
        self._settle_corners(level, rim, settled)
        same = _is_same(level, settled)
        return (level if same else settled), same

    def settle_border(self, level: Values) -> None:
        """Let the outermost pixels of tiles depend on shared colors alone, in place."""
        n = level.shape[1]
        columns, rows = level[:, :, :: n - 1], level[:, :: n - 1]
        self.settle_strips(columns, rows)

    def settle_strips(self, columns: Values, rows: Values) -> None:
        """The same of the outermost columns, shape (T, n, 2, channels), and rows, (T, 2, n, channels)."""
        n, rim = columns.shape[1], Rim(2, 0, None)
        corners = columns[:, :: n - 1].copy()
        settled = corners.copy()
        self._settle_corners(corners, rim, settled)
        self._settle_edges(columns, rim, columns, "W", "E")
        self._settle_edges(rows, rim, rows, "N", "S")
        columns[:, :: n - 1] = settled
        rows[:, :, :: n - 1] = settled

    def _settle_edges(self, level: Values, rim: Rim, out: Values, near: str, far: str) -> None:
        last, axis = rim.count - 1, 2 if near == "W" else 1
        # Texels after the border, from tiles with that edge at their near side; and those before it.
        texels, filled = np.moveaxis(level, axis, 0), np.moveaxis(out, axis, 0)
        colors = 1 + int(max(self.edges[near].max(), self.edges[far].max()))
        after = _means(texels[rim.within], self.edges[near], colors)
        before = _means(texels[last - rim.within], self.edges[far], colors)
        if rim.beyond == rim.within:
            after = before = np.mean((after, before), axis=0)
        filled[rim.within] = after[self.edges[near]]
        filled[last - rim.within] = before[self.edges[far]]
        if rim.beyond is not None:
            filled[rim.beyond] = before[self.edges[near]]
            filled[last - rim.beyond] = after[self.edges[far]]

    def _settle_corners(self, level: Values, rim: Rim, out: Values) -> None:
        last = rim.count - 1
        low, high = rim.within, last - rim.within
        own = {"NW": (low, low), "NE": (low, high), "SW": (high, low), "SE": (high, high)}
        if not self.corners:
            for row, column in own.values():
                out[:, row, column] = level[:, row, column]
            return
        colors = 1 + int(max(c.max() for c in self.corners.values()))
        # The quadrant around a lattice point that a tile fills is opposite to the corner it has there.
        quadrants = {c: _means(level[:, *own[c]], self.corners[c], colors) for c in _CORNERS}
        if rim.beyond == rim.within:
            quadrants = dict.fromkeys(_CORNERS, np.mean(list(quadrants.values()), axis=0, dtype=np.float32))
        for corner, color in self.corners.items():
            for row in (False, True):
                for column in (False, True):
                    if (row or column) and rim.beyond is None:
                        continue
                    y = _texel(rim, corner[0] == "S", row)
                    x = _texel(rim, corner[1] == "E", column)
                    out[:, y, x] = quadrants[_across(corner, row, column)][color]


def _is_same(a: Values, b: Values) -> bool:
    return bool(np.abs(a - b).max() <= EQUAL * max(1.0, float(np.abs(a).max())))


def _texel(rim: Rim, far: bool, beyond: bool) -> int:
    """Position of a texel at a border: at the near or far side of a tile, within or beyond it."""
    at = rim.beyond if beyond and rim.beyond is not None else rim.within
    return rim.count - 1 - at if far else at


def _across(corner: str, row: bool, column: bool) -> str:
    """The corner that a tile has at this lattice point which lies across the rows or columns."""
    return (_OPPOSITE[corner[0]] if row else corner[0]) + (_OPPOSITE[corner[1]] if column else corner[1])


def _means(texels: Values, groups: Colors, count: int) -> Values:
    """Mean over the tiles of each group, shape (count, ...); 0 for groups without a tile."""
    total = np.zeros((count, *texels.shape[1:]), np.float64)
    for group, texel in zip(groups, texels, strict=True):  # numpy's add.at takes ten times as long
        total[group] += texel
    tiles = np.maximum(np.bincount(groups, minlength=count), 1)
    return (total / tiles.reshape(-1, *(1,) * (texels.ndim - 1))).astype(np.float32)


def with_gutters(tiles: NDArray[Any], gutter: int, shared: Shared) -> NDArray[Any]:
    """Tiles with pixels of neighbors around them: for each side and corner, of the first tile that fits."""
    count, n, _, channels = tiles.shape
    side = n + 2 * gutter
    out = np.empty((count, side, side, channels), tiles.dtype)
    bands = {-1: slice(0, gutter), 0: slice(gutter, side - gutter), 1: slice(side - gutter, side)}
    source = {-1: slice(n - gutter, n), 0: slice(0, n), 1: slice(0, gutter)}
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            neighbors = neighbors_of(shared, dy, dx)
            out[:, bands[dy], bands[dx]] = tiles[neighbors][:, source[dy], source[dx]]
    return out


def neighbors_of(shared: Shared, dy: int, dx: int) -> Colors:
    """For each tile, the first one that may lie dy rows and dx columns away; any over uncolored corners."""
    if not (dy or dx) or (dy and dx and not shared.corners):
        return np.arange(len(shared.edges["N"]))
    if dy and dx:
        corner = ("N" if dy < 0 else "S") + ("W" if dx < 0 else "E")
        ours, theirs = shared.corners[corner], shared.corners[_across(corner, True, True)]
    else:
        side = ("N" if dy < 0 else "S") if dy else ("W" if dx < 0 else "E")
        ours, theirs = shared.edges[side], shared.edges[_OPPOSITE[side]]
    first = np.zeros(1 + int(max(ours.max(), theirs.max())), np.int64)
    first[theirs[::-1]] = np.arange(len(theirs))[::-1]
    return first[ours]
