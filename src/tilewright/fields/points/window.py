"""Windows of point fields: where they lie, and the points found there with who they are."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import ceil, floor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_flag, check_int, check_out, check_real
from tilewright.errors import TilewrightValueError
from tilewright.showing import Shown, describe, many
from tilewright.tabling import Tabled
from tilewright.tilings.domain import LARGEST_CELL

MOST_POINTS = 2**31
"""What can be given at once."""
_COARSEST = 0.01
"""Largest step between floating-point numbers, as a share of the distance of points."""


@dataclass(frozen=True, eq=False)
class PointWindow(Shown, Tabled):
    """Points of a window and who they are.

    Attributes
    ----------
    points : float64 array, shape (n, 2)
        The points, x first, in tiles.
    cells : int64 array, shape (n, 2)
        The cell (x, y) each point lies in.
    numbers : int64 array, shape (n,)
        Its number among the points of its tile.
    ranks : float32 array, shape (n,)
        Its rank, from 0 up to 1.
    bits : int
        Bits that a number takes in an id.
    """

    points: NDArray[np.float64]
    cells: NDArray[np.int64]
    numbers: NDArray[np.int64]
    ranks: NDArray[np.float32]
    bits: int

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return describe(self, many(len(self), "point"), f"numbers of {self.bits} bits")

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.points, dtype, copy=copy)

    def columns(self) -> dict[str, NDArray[Any]]:
        """Give the points and who they are as columns.

        Returns
        -------
        dict of str to array, shape (n,)
            ``x`` and ``y``, ``cell_x`` and ``cell_y``, ``number``, ``rank``, and ``id`` where the cells are
            near enough to fit into it, see `ids`.
        """
        (x, y), (cell_x, cell_y) = self.points.T, self.cells.T
        made = {
            "x": x,
            "y": y,
            "cell_x": cell_x,
            "cell_y": cell_y,
            "number": self.numbers,
            "rank": self.ranks,
        }
        return {**made, "id": self.ids} if self._ids_fit() else made

    def _ids_fit(self) -> bool:
        reach = 2 ** ((64 - self.bits) // 2 - 1)
        return not len(self.cells) or bool(self.cells.min() >= -reach and self.cells.max() < reach)

    @property
    def ids(self) -> NDArray[np.uint64]:
        """Cell and number in one word, uint64, shape (n,): number, cell y and cell x from the low bits up.

        A point has the same id in every window.

        Raises
        ------
        TilewrightValueError
            A cell is too far out to fit.
        """
        half = (64 - self.bits) // 2
        reach = 2 ** (half - 1)
        if not self._ids_fit():
            raise TilewrightValueError(
                f"cells reach from {self.cells.min()} to {self.cells.max()}; ids hold -{reach} to "
                f"{reach - 1}, so use cells and numbers"
            )
        x, y = (self.cells + reach).astype(np.uint64).T
        packed: NDArray[np.uint64] = (x << np.uint64(half) | y) << np.uint64(self.bits) | self.numbers.astype(
            np.uint64
        )
        return packed


@dataclass(frozen=True)
class Window:
    """A rectangle of the plane, measured from the first cell it touches, so that far ones are exact.

    Attributes
    ----------
    column, row : int
        The first cell.
    left, top, right, bottom : float
        Sides of the rectangle, in tiles from that cell's corner.
    corner : tuple of float
        Where local coordinates begin, from that cell's corner; of pieces, the corner of the whole.
    """

    column: int
    row: int
    left: float
    top: float
    right: float
    bottom: float
    corner: tuple[float, float]

    @classmethod
    def of(cls, x: Any, y: Any, width: Any, height: Any) -> "Window":
        """From a corner and a size, checked."""
        x, y = _place("x", x), _place("y", y)
        size = []
        for name, value in (("width", width), ("height", height)):
            size.append(check_real(name, value, 0.0, float(LARGEST_CELL)))
            if not size[-1] > 0:
                raise TilewrightValueError(
                    f"is {value}; a window needs more than 0", argument=name, value=value
                )
        column, row = floor(x), floor(y)
        left, top = float(x - column), float(y - row)
        return cls(column, row, left, top, left + size[0], top + size[1], (left, top))

    @property
    def columns(self) -> int:
        """Cells along x that it touches."""
        return ceil(self.right)

    @property
    def rows(self) -> int:
        """Cells along y that it touches."""
        return ceil(self.bottom)

    @property
    def is_whole(self) -> bool:
        """Whether it is made of whole cells."""
        return self.left == self.top == 0 and (self.right, self.bottom) == (self.columns, self.rows)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, top, right and bottom."""
        return self.left, self.top, self.right, self.bottom

    def pieces(self, most: int) -> Iterator["Window"]:
        """The rectangle cut at cell borders into pieces of about so many cells, band after band."""
        columns = min(self.columns, most)
        rows = max(1, most // columns)
        for i in range(0, self.rows, rows):
            for j in range(0, self.columns, columns):
                yield Window(
                    self.column + j,
                    self.row + i,
                    max(self.left - j, 0.0),
                    max(self.top - i, 0.0),
                    min(self.right - j, float(columns)),
                    min(self.bottom - i, float(rows)),
                    (self.corner[0] - j, self.corner[1] - i),
                )

    def origin(self, local: bool, kinds: tuple[np.dtype[Any], ...], spacing: float) -> tuple[float, float]:
        """Coordinates of the first cell's corner, if points there can be told apart in all ``kinds``."""
        check_flag("local", local)
        x, y = (-self.corner[0], -self.corner[1]) if local else (float(self.column), float(self.row))
        farthest = max(abs(x), abs(y), abs(x + self.columns), abs(y + self.rows))
        for kind in kinds:
            if float(np.spacing(kind.type(farthest))) > _COARSEST * spacing:
                advice = "float64 or smaller windows" if local or kind == np.float32 else "local=True"
                raise TilewrightValueError(
                    f"coordinates of {farthest:.6g} tiles in {kind} are too coarse for points "
                    f"{spacing:.3g} apart",
                    advice=f"use {advice}",
                )
        return x, y


@dataclass(frozen=True, eq=False)
class View:
    """A window and the filling of each of its cells, int32, shape (rows, columns)."""

    window: Window
    cells: NDArray[np.int32]

    @classmethod
    def of(cls, look_up: Callable[..., NDArray[np.int32]], density: float, window: Window) -> "View":
        """The cells of a window by ``look_up(column, row, columns, rows)``, if they are not too many."""
        about = window.columns * window.rows * max(density, 1)
        if about > MOST_POINTS:
            raise TilewrightValueError(
                f"a window of {window.columns} x {window.rows} tiles holds about {about:.3g} points, "
                "more than can be given at once",
                advice="blocks() gives them a piece at a time",
            )
        return cls(window, look_up(window.column, window.row, window.columns, window.rows))


def _place(name: str, value: Any) -> int | float:
    """A coordinate: a whole one as int, of any size within the plane."""
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool):
        return check_int(name, value, -LARGEST_CELL, LARGEST_CELL)
    return check_real(name, value, -float(LARGEST_CELL), float(LARGEST_CELL))


def make_out(n: int) -> NDArray[np.float64]:
    """An array for ``n`` points."""
    try:
        return np.empty((n, 2))
    except MemoryError:
        raise TilewrightValueError(
            f"{n} points do not fit in memory", advice="blocks() gives them a piece at a time"
        ) from None


def fit_out(out: Any, n: int) -> NDArray[Any]:
    """The first ``n`` rows of a given array, or a new one for None."""
    if out is None:
        return make_out(n)
    kinds = (np.float32, np.float64)
    check_out(
        out,
        lambda given: given.ndim == 2 and given.shape[1] == 2 and len(given) >= n and given.dtype in kinds,
        f"float32 or float64 (at least {n}, 2)",
    )
    return np.asarray(out)[:n]
