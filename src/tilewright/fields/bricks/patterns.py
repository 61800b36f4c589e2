"""Where bricks lie in a wall, at any place of it; walls of brick tiles and of regions."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, type_error
from tilewright.errors import TilewrightTypeError
from tilewright.fields.windows import PixelWindow, check_pixel_window
from tilewright.showing import describe
from tilewright.signals.bricks.edges import check_traversed, find_thinnest, place_positions
from tilewright.tilings import Domain, Tiling
from tilewright.tilings.bricks import BrickRegion
from tilewright.tilings.domain import LARGEST_CELL, fold

SIZE = (144, 48)
"""Width and height of a usual brick in pixels."""
_LARGEST_BRICK = 4096
_MARGIN = 4
"""Units around a window that are asked for besides, which must not leave the plane."""

Range = tuple[int, int]
"""The first, and how many."""


@dataclass(frozen=True, eq=False)
class Bricks:
    """Bricks that touch a window of pixels.

    Attributes
    ----------
    sides : int64 array, shape (n, 4)
        West, north, east and south side of each brick, to the middle of the mortar, in pixels from the
        north-west of the window. Bricks do not overlap and leave nothing free.
    ids : int64 array, shape (n, 2)
        Who each of them is, the same in every window.
    """

    sides: NDArray[np.int64]
    ids: NDArray[np.int64]


class BrickPattern(ABC):
    """Bricks of a wall, found anywhere.

    Attributes
    ----------
    unit : (int, int)
        Pixels of a cell of the lattice that the bricks are bound to.
    course : int
        Usual height of a brick in pixels.
    thinnest : int
        The least width or height of a brick in pixels.
    domain : Domain
        Of units.
    """

    unit: tuple[int, int]
    course: int
    thinnest: int
    domain: Domain

    def __repr__(self) -> str:
        width, height = self.unit
        return describe(self, f"units of {width} x {height} pixels", str(self.domain))

    def bricks(self, x: int, y: int, width: int, height: int) -> Bricks:
        """All bricks that touch a window of pixels; pixel (0, 0) is the north-west one of unit (0, 0)."""
        return self._find(*self.check_window(x, y, width, height))

    def locate(self, x: int, y: int, width: int, height: int) -> tuple[NDArray[np.int32], Bricks]:
        """The brick of each pixel of a window, int32 (height, width): its place in the `Bricks` there.

        It is -1 where the wall has a hole.
        """
        x, y, width, height = self.check_window(x, y, width, height)
        index, found = self._locate(x, y, width, height)
        covered = self.covers(x, y, width, height)
        if covered is not None:
            index[~covered] = -1
        return index, found

    def covers(self, x: int, y: int, width: int, height: int) -> NDArray[np.bool_] | None:
        """Which pixels of a window the wall covers, shape (height, width); None where it has no holes."""
        return None

    def check_window(self, x: int, y: int, width: int, height: int) -> PixelWindow:
        """A window of pixels as integers of any size; raise unless it lies in the wall."""
        return check_pixel_window(self.pixels, self.reach, x, y, width, height)

    @property
    def pixels(self) -> Domain:
        """The domain in pixels."""
        return self.domain.scaled(*self.unit)

    @property
    def reach(self) -> tuple[int, int]:
        """Pixels from the origin that an endless wall reaches to, along x and y."""
        width, height = self.unit
        return (LARGEST_CELL - _MARGIN) * width, (LARGEST_CELL - _MARGIN) * height

    def _locate(self, x: int, y: int, width: int, height: int) -> tuple[NDArray[np.int32], Bricks]:
        """`locate`, also a few pixels beyond a wall and into its holes, where the bricks at its rim go on."""
        from tilewright.kernels.brick_drawing import fill_rectangles

        found = self._find(x, y, width, height)
        index = np.full((height, width), -1, np.int32)
        fill_rectangles(found.sides, index)
        return index, found

    def _find(self, x: int, y: int, width: int, height: int) -> Bricks:
        """`bricks`, of any window."""
        units = [self._units(axis, *window) for axis, window in enumerate(((x, width), (y, height)))]
        sides, ids = self._around(*units)
        origin = np.array(
            [first * u - at for (first, _), u, at in zip(units, self.unit, (x, y), strict=True)]
        )
        sides = sides + np.tile(origin, 2)
        near = (sides[:, :2] < (width, height)).all(axis=1) & (sides[:, 2:] > 0).all(axis=1)
        return Bricks(sides[near], ids[near])

    def _units(self, axis: int, first: int, count: int) -> Range:
        """The first unit of a range of pixels, and how many it touches."""
        unit = first // self.unit[axis]
        return unit, (first + count - 1) // self.unit[axis] - unit + 1

    @abstractmethod
    def _around(self, across: Range, down: Range) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Sides, in pixels from the first unit's north-west, and ids of at least all bricks that touch units.

        ``across`` and ``down`` are the first unit and the number of units along x and y.
        """


class PositionBricks(BrickPattern):
    """Bricks known from the positions on edges."""

    places: list[NDArray[np.int64]]
    """Pixels of each position along N and S edges, and along E and W edges."""

    def _set_size(self, size: Any, counts: Sequence[int]) -> None:
        """For cells of ``size`` pixels, with ``counts`` positions on edges along x and along y."""
        self.unit = check_size("size", size)
        self.course = self.unit[1]
        self.places = [place_positions(n, length) for n, length in zip(counts, self.unit, strict=True)]
        self.thinnest = find_thinnest(self.places, self.unit)

    @abstractmethod
    def _edges(
        self, x: int, y: int, columns: int, rows: int
    ) -> tuple[NDArray[np.integer[Any]], NDArray[np.integer[Any]]]:
        """Positions on the edges of cells of a window, -1 on edges that have none.

        N edges of all rows and S edges of the last one, shape (rows + 1, columns); W edges of all columns and
        E edges of the last one, shape (rows, columns + 1).
        """

    def _around(self, across: Range, down: Range) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        (x, columns), (y, rows) = self._cells(0, *across), self._cells(1, *down)
        level, upright = self._edges(x, y, columns, rows)
        west, east = _joints(level, self.places[0], x - across[0], self.unit[0])
        north, south = (side.T for side in _joints(upright.T, self.places[1], y - down[0], self.unit[1]))
        point_x = fold(x, columns + 1, self.domain.periods[0])
        point_y = fold(y, rows + 1, self.domain.periods[1])
        sides = np.stack([west, north, east, south], axis=-1).reshape(-1, 4)
        return sides, np.stack(np.meshgrid(point_x, point_y), axis=-1).reshape(-1, 2)

    def _cells(self, axis: int, first: int, count: int) -> Range:
        """Cells that the bricks of some cells depend on: one more on either side, where there are such."""
        low, high = first - 1, first + count + 1
        bound = self.domain.bounds[axis]
        if bound is not None:
            low, high = max(low, bound[0]), min(high, bound[1])
        return low, high - low


class WangBricks(PositionBricks):
    """Bricks of a tiling by brick Wang tiles (Kaji et al. 2016, section 4).

    Where two lines never cross, each lattice point lies in one brick and each brick holds one lattice point;
    its sides are the positions on the four edges that meet there. So a brick is known from four tiles, and
    its id is the lattice point (x, y): the north-west corner of cell (x, y).

    Parameters
    ----------
    tiling : Tiling
        Of Wang tiles, each traversed by a line: its W and E colors are the same, or its N and S colors.
    size : (int, int)
        Width and height of a cell in pixels. Position k of n on an edge is (k + 1) / (n + 1) of its length,
        so bricks are a cell wide and high on average, and 2 / (n + 1) cells at least.

    Raises
    ------
    TilewrightValueError
        Tiles that no line traverses, or cells so small that two positions fall together.

    Notes
    -----
    Where a wall ends, the bricks at its rim are cut by it, and their ids are lattice points at its rim.
    """

    def __init__(self, tiling: Tiling, size: tuple[int, int] = SIZE) -> None:
        if not isinstance(tiling, Tiling):
            raise TilewrightTypeError(
                f"a wall takes a Tiling of brick Wang tiles, not {type(tiling).__name__}"
            )
        check_traversed(tiling.tiles)
        self.tiling = tiling
        self.domain = tiling.domain
        self._set_size(size, tiling.tiles.colors[:2])

    def _edges(
        self, x: int, y: int, columns: int, rows: int
    ) -> tuple[NDArray[np.integer[Any]], NDArray[np.integer[Any]]]:
        slots = self.tiling.tiles.slots[self.tiling.indices(x, y, columns, rows)]
        north, east, south, west = np.moveaxis(slots, -1, 0)
        return np.concatenate([north, south[-1:]]), np.concatenate([west, east[:, -1:]], axis=1)


class RegionBricks(PositionBricks):
    """Bricks of a region of the plane, which may have holes; see `brick_region`.

    Parameters
    ----------
    region : BrickRegion
    size : (int, int)
        Width and height of a cell in pixels, see `WangBricks`.

    Notes
    -----
    Bricks are cut at the border of the region.
    """

    def __init__(self, region: BrickRegion, size: tuple[int, int] = SIZE) -> None:
        self.region = region
        height, width = region.cells.shape
        self.domain = Domain((None, None), ((0, width), (0, height)))
        self._set_size(size, region.tiles.colors[:2])

    def covers(self, x: int, y: int, width: int, height: int) -> NDArray[np.bool_]:
        """Which pixels of a window lie in the region, shape (height, width)."""
        last = [n - 1 for n in self.region.cells.shape[::-1]]
        column = ((x + np.arange(width)) // self.unit[0]).clip(0, last[0])
        row = ((y + np.arange(height)) // self.unit[1]).clip(0, last[1])
        return (self.region.cells >= 0)[np.ix_(row, column)]

    def _edges(
        self, x: int, y: int, columns: int, rows: int
    ) -> tuple[NDArray[np.integer[Any]], NDArray[np.integer[Any]]]:
        level = self.region.horizontal[y : y + rows + 1, x : x + columns]
        return level, self.region.vertical[y : y + rows, x : x + columns + 1]

    def _around(self, across: Range, down: Range) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        sides, points = super()._around(across, down)
        inside = np.pad(self.region.cells >= 0, 1)
        x, y = points.T
        touched = inside[y, x] | inside[y + 1, x] | inside[y, x + 1] | inside[y + 1, x + 1]
        return sides[touched], points[touched]


def check_size(name: str, given: Any) -> tuple[int, int]:
    """Width and height in pixels."""
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise type_error(name, given, "a width and a height in pixels")
    width, height = (check_int(name, side, 4, _LARGEST_BRICK) for side in given)
    return width, height


def _joints(
    positions: NDArray[np.integer[Any]], places: NDArray[np.int64], first: int, unit: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Where the joints before and after each lattice point lie, along rows of cells from ``first`` on.

    Where cells have ended bricks go on for a cell, and across an edge that has no position for half of one.
    """
    lines, count = positions.shape
    starts = (first + np.arange(-1, count + 1)) * unit
    before, after = np.empty((2, lines, count + 1), np.int64)
    before[:, 0], after[:, -1] = starts[0], starts[-1] + unit
    before[:, 1:] = after[:, :-1] = starts[1:-1] + np.where(positions < 0, unit // 2, places[positions])
    return before, after
