"""Windows of point fields: where they lie, and the points found there with who they are."""

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, floor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, check_int, check_real
from tilewright.tilings.domain import LARGEST_CELL

MOST_POINTS = 2**31
"""What can be given at once."""
_COARSEST = 0.01
"""Largest step between floating-point numbers, as a share of the distance of points."""


@dataclass(frozen=True, eq=False)
class PointWindow:
    """Points of a window and who they are.

    Attributes
    ----------
    points : float64 array, shape (n, 2)
    cells : int64 array, shape (n, 2)
        The cell (x, y) each point lies in.
    numbers : int64 array, shape (n,)
        Its number among the points of its tile.
    ranks : float32 array, shape (n,)
    bits : int
        Bits that a number takes in an id.
    """

    points: NDArray[np.float64]
    cells: NDArray[np.int64]
    numbers: NDArray[np.int64]
    ranks: NDArray[np.float32]
    bits: int

    @property
    def ids(self) -> NDArray[np.uint64]:
        """Cell and number in one word: number, then cell y, then cell x from the low bits up.

        A point has the same id in every window. An error where a cell is too far out to fit.
        """
        half = (64 - self.bits) // 2
        reach = 2 ** (half - 1)
        if len(self.cells) and (self.cells.min() < -reach or self.cells.max() >= reach):
            raise TilewrightValueError(
                f"cells reach from {self.cells.min()} to {self.cells.max()}; ids hold -{reach} to "
                f"{reach - 1}, so use cells and numbers"
            )
        x, y = (self.cells + reach).astype(np.uint64).T
        packed: NDArray[np.uint64] = (x << np.uint64(half) | y) << np.uint64(self.bits) | self.numbers.astype(
            np.uint64
        )
        return packed


@dataclass(frozen=True, eq=False)
class View:
    """A window as cells and a rectangle measured from the first of them."""

    column: int
    row: int
    cells: NDArray[np.int32]
    left: float
    top: float
    width: float
    height: float

    @classmethod
    def of(
        cls,
        look_up: Callable[..., NDArray[np.int32]],
        density: float,
        x: Any,
        y: Any,
        width: Any,
        height: Any,
    ) -> "View":
        """The cells of a window by ``look_up(column, row, columns, rows)``, if they are not too many."""
        check_window(x, y, width, height)
        column, row = floor(x), floor(y)
        left, top = float(x - column), float(y - row)
        columns, rows = ceil(left + float(width)), ceil(top + float(height))
        about = columns * rows * max(density, 1)
        if about > MOST_POINTS:
            raise TilewrightValueError(
                f"a window of {width} x {height} tiles holds about {about:.3g} points, more than can be "
                "given at once; blocks() gives them a piece at a time"
            )
        cells = look_up(column, row, columns, rows)
        return cls(column, row, cells, left, top, float(width), float(height))

    @property
    def is_whole(self) -> bool:
        """Whether the window is made of whole cells."""
        return self.left == self.top == 0 and self.cells.shape == (self.height, self.width)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Left, top, right and bottom."""
        return self.left, self.top, self.left + self.width, self.top + self.height

    def origin(self, local: bool, kind: np.dtype[Any], spacing: float) -> tuple[float, float]:
        """Coordinates of the first cell's corner, if points there can be told apart."""
        x, y = (-self.left, -self.top) if local else (float(self.column), float(self.row))
        farthest = max(abs(x), abs(y), abs(x + self.cells.shape[1]), abs(y + self.cells.shape[0]))
        if float(np.spacing(kind.type(farthest))) > _COARSEST * spacing:
            advice = "float64 or smaller windows" if local or kind == np.float32 else "local=True"
            raise TilewrightValueError(
                f"coordinates of {farthest:.6g} tiles in {kind} are too coarse for points {spacing:.3g} "
                f"apart; use {advice}"
            )
        return x, y


def check_window(x: Any, y: Any, width: Any, height: Any) -> None:
    """Raise unless a window is a rectangle within the plane."""
    for name, value in (("x", x), ("y", y)):
        if not isinstance(value, (int, np.integer)) or isinstance(value, bool):
            check_real(name, value, -float(LARGEST_CELL), float(LARGEST_CELL))
        else:
            check_int(name, value, -LARGEST_CELL, LARGEST_CELL)
    for name, value in (("width", width), ("height", height)):
        if not check_real(name, value, 0.0, float(LARGEST_CELL)) > 0:
            raise TilewrightValueError(f"{name} is {value}; a window needs more than 0")
