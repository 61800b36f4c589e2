"""Cells of a box, for looking up which points are near."""

from dataclasses import dataclass
from itertools import product
from math import ceil, sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_memory

if TYPE_CHECKING:
    from tilewright.kernels.darts import Cells

_CELLS_EACH = 8
"""Cells for each point beyond which a finer grid finds nothing faster."""


@dataclass(frozen=True, eq=False)
class Grid:
    """Cells of a box, the points in each, and which cells can hold a point closer than some distance.

    Attributes
    ----------
    box : Box
        What is cut into cells.
    counts : int64 array, shape (d,)
        Cells along each axis.
    offsets : int64 array, shape (m, d)
        Where to look around a cell, the nearest cells first.
    gaps : float64 array, shape (m,)
        Square of the least distance from a point of the cell in the middle to one of that cell.
    heads : int32 array, shape (prod(counts),)
        A point in each cell, or -1.
    after : int32 array, shape (n,)
        For each point, the next one in its cell, or -1.
    """

    box: Box
    counts: NDArray[np.int64]
    offsets: NDArray[np.int64]
    gaps: NDArray[np.float64]
    heads: NDArray[np.int32]
    after: NDArray[np.int32]

    @classmethod
    def of(
        cls,
        box: Box,
        count: int,
        distance: float,
        *,
        reach: float | None = None,
        fine: bool = False,
        images: bool = False,
    ) -> "Grid":
        """An empty grid for up to ``count`` points.

        Parameters
        ----------
        distance : float
            No two points are closer. Cells are so small that none holds two, unless that would make far
            more cells than points.
        reach : float
            How far to look; ``distance`` by default.
        fine : bool
            Whether no cell may hold two points, however many cells that makes.
        images : bool
            Whether to look at the images of a cell on a torus one by one; else each cell once, whose
            points are then to be measured to their nearest images.
        """
        side = distance / sqrt(box.dimension)
        if not fine:
            side = coarsen(box, side, max(_CELLS_EACH * count, 64))
        cells = _cells(box, side)
        check_memory(f"points {distance:.3g} apart make a grid of {cells:.3g} cells", 4.0 * cells)
        counts = [ceil(e / side) for e in box.extent]
        offsets, gaps = look_around(box, counts, distance if reach is None else reach, images)
        heads, after = np.full(int(cells), -1, np.int32), np.full(count, -1, np.int32)
        return cls(box, np.array(counts, np.int64), offsets, gaps, heads, after)

    def over(self, points: NDArray[np.float64]) -> "Cells":
        """The cells as kernels take them, for ``points``, shape (n, d), which they hold or will hold."""
        from tilewright.kernels.darts import Cells

        extent = np.array(self.box.extent)
        return Cells(points, self.heads, self.after, self.counts, self.offsets, extent, self.box.torus)


@dataclass(frozen=True, eq=False)
class Bins:
    """Points that are all known, by cell.

    Attributes
    ----------
    counts : int64 array, shape (d,)
        Cells along each axis.
    order : int64 array, shape (n,)
        Indices of the points, cell by cell in C order.
    starts : int64 array, shape (prod(counts) + 1,)
        Where in ``order`` each cell begins.
    """

    counts: NDArray[np.int64]
    order: NDArray[np.int64]
    starts: NDArray[np.int64]

    @classmethod
    def of(cls, points: NDArray[np.float64], box: Box, side: float, cells_each: float) -> "Bins":
        """Sort ``points`` into cells of at least ``side``; at most ``cells_each`` cells a point."""
        side = coarsen(box, side, max(cells_each * len(points), 1))
        counts = np.array([max(1, int(e / side)) for e in box.extent])
        at = np.minimum((points * (counts / box.extent)).astype(np.int64), counts - 1)
        cells = np.ravel_multi_index(tuple(at.T), tuple(counts))
        order = np.argsort(cells, kind="stable")
        starts = np.zeros(counts.prod() + 1, np.int64)
        np.cumsum(np.bincount(cells, minlength=counts.prod()), out=starts[1:])
        return cls(counts, order, starts)


def coarsen(box: Box, side: float, most: float) -> float:
    """``side``, or a longer one that makes no more than ``most`` cells."""
    side = max(side, (box.volume / most) ** (1 / box.dimension))
    while _cells(box, side) > most:
        side *= 1.1
    return side


def _cells(box: Box, side: float) -> float:
    """Number of cells no longer than ``side``."""
    cells = 1.0
    for extent in box.extent:
        cells *= ceil(extent / side)
    return cells


def look_around(
    box: Box, counts: list[int], reach: float, images: bool = False
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """The offsets to cells closer than ``reach`` and the squares of their distances, nearest first.

    counts : cells along each axis. images : as for `Grid.of`.
    """
    sides = [e / n for e, n in zip(box.extent, counts, strict=True)]
    steps = []
    for side, count in zip(sides, counts, strict=True):
        back = ahead = ceil(min(reach / side, 2.0**40))
        if not box.torus:
            back, ahead = min(back, count - 1), min(ahead, count - 1)
        elif not images:
            back, ahead = min(back, (count - 1) // 2), min(ahead, count // 2)
        steps.append(range(-back, ahead + 1))
    near = []
    for offset in product(*steps):
        gap = sum((max(abs(o) - 1, 0) * s) ** 2 for o, s in zip(offset, sides, strict=True))
        if gap < reach**2:
            near.append((gap, sum(o * o for o in offset), offset))
    near.sort()
    offsets = np.array([offset for _, _, offset in near], np.int64).reshape(len(near), box.dimension)
    return offsets, np.array([gap for gap, _, _ in near])
