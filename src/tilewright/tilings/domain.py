"""Where there are cells: the endless plane, a cylinder, a torus, a rectangle; lines and volumes too."""

from dataclasses import dataclass
from math import prod

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, type_error
from tilewright.errors import TilewrightValueError

LARGEST_CELL = 2**61
_MOST_CELLS = 2**31


@dataclass(frozen=True)
class Domain:
    """The cells of a tiling along each axis, x first: an endless plane, a cylinder, a torus, a rectangle.

    Attributes
    ----------
    periods : tuple of (int or None)
        For each axis the number of cells after which it repeats, or None where it does not. By default a
        plane.
    bounds : tuple of ((int, int) or None)
        For each axis the first cell and one more than the last, or None where it is endless, the default.
    """

    periods: tuple[int | None, ...] = (None, None)
    bounds: tuple[tuple[int, int] | None, ...] = (None, None)

    @classmethod
    def plane(cls, period: tuple[int | None, ...] | None, dimension: int = 2) -> "Domain":
        """Make a domain that is endless along every axis, and may repeat.

        Parameters
        ----------
        period : tuple of (int or None), or None
            Number of cells after which each axis repeats, x first, 1 to 2^31.
        dimension : int, optional
            Number of axes; default 2.

        Returns
        -------
        Domain
            A plane, cylinder or torus.

        Raises
        ------
        TilewrightTypeError
            The period is not a tuple of integers.
        TilewrightValueError
            It has another number of entries, or one out of range.
        """
        if period is not None and not isinstance(period, (tuple, list)):
            raise type_error("period", period, f"a tuple of {dimension} numbers or None")
        given = (None,) * dimension if period is None else tuple(period)
        if len(given) != dimension:
            raise TilewrightValueError(
                f"has {len(given)} entries; expected {dimension}, x first",
                argument="period",
                value=len(given),
                allowed=f"{dimension}, x first",
            )
        checked = tuple(None if p is None else check_int("period", p, 1, 2**31) for p in given)
        return cls(checked, (None,) * dimension)

    @property
    def kind(self) -> str:
        """``"plane"``, ``"cylinder"``, ``"torus"`` or ``"rectangle"``, as far as the axes tell."""
        if any(b is not None for b in self.bounds):
            return "rectangle"
        wrapped = sum(p is not None for p in self.periods)
        return "plane" if wrapped == 0 else "torus" if wrapped == len(self.periods) else "cylinder"

    def __str__(self) -> str:
        """``plane``, ``torus 3 x 5``, ``cylinder 3 x endless``, ``rectangle 0 to 8 x 0 to 6``."""
        if self.kind == "plane":
            return "plane"
        axes = zip(self.bounds, self.periods, strict=True)
        sides = (f"{b[0]} to {b[1] - 1}" if b else "endless" if p is None else str(p) for b, p in axes)
        return f"{self.kind} {' x '.join(sides)}"

    def scaled(self, *units: int) -> "Domain":
        """Give the same domain counted in parts of a cell, such as pixels.

        Parameters
        ----------
        *units : int
            How many parts make a cell along each axis, x first.

        Returns
        -------
        Domain
            Its periods and bounds are in parts.
        """
        periods = tuple(None if p is None else p * u for p, u in zip(self.periods, units, strict=True))
        bounds = tuple(
            None if b is None else (b[0] * u, b[1] * u) for b, u in zip(self.bounds, units, strict=True)
        )
        return Domain(periods, bounds)

    def check_window(self, start: tuple[int, ...], extent: tuple[int, ...]) -> None:
        """Refuse a window of cells that lies outside the domain or is too large to hold.

        Parameters
        ----------
        start : tuple of int
            The first cell, x first, within +-2^61.
        extent : tuple of int
            Number of cells along each axis, x first; 2^31 in all at most.

        Raises
        ------
        TilewrightTypeError
            A number is not an integer.
        TilewrightValueError
            The window is too large, or not inside.
        """
        axes = "xyz"
        for axis, (first, count) in enumerate(zip(start, extent, strict=True)):
            size = ("width", "height", "depth")[axis]
            check_int(size, count, 1, _MOST_CELLS)
            check_int(axes[axis], first, -LARGEST_CELL, LARGEST_CELL - count)
            bound = self.bounds[axis]
            if bound is not None and not (bound[0] <= first and first + count <= bound[1]):
                raise TilewrightValueError(
                    f"cells {axes[axis]}={first} to {first + count - 1} are outside the tiling, "
                    f"which has {bound[0]} to {bound[1] - 1}"
                )
        if prod(extent) > _MOST_CELLS:
            raise TilewrightValueError(
                f"a window of {' x '.join(map(str, extent))} cells is too large",
                advice="ask for at most 2^31 at once",
            )

    def wrap(self, axis: int, first: int, count: int) -> NDArray[np.int64]:
        """Fold coordinates into the period of an axis.

        Parameters
        ----------
        axis : int
            0 for x, 1 for y, 2 for z.
        first : int
            The first coordinate, of a cell or a lattice point.
        count : int
            Number of coordinates.

        Returns
        -------
        int64 array, shape (count,)
            The coordinates from ``first`` on, modulo the period where there is one.
        """
        return fold(first, count, self.periods[axis])


def fold(first: int, count: int, period: int | None) -> NDArray[np.int64]:
    """``count`` coordinates from ``first`` on, modulo ``period`` where there is one."""
    if period is None:
        return np.arange(first, first + count, dtype=np.int64)
    return (first % period + np.arange(count, dtype=np.int64)) % period
