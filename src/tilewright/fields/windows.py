"""Maps of a plane and windows of it in pixels, which may lie anywhere where there are pixels."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from tilewright.checks import check_int, type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tilings import Domain

LARGEST_SIDE = 2**31 - 1
_FAR = 2**80
"""Beyond every plane, which says itself how far it goes."""


class PixelMap(NamedTuple):
    """What a map of a field is made of.

    Parameters
    ----------
    dtype : dtype
        Type of its numbers.
    channels : int
        Numbers of a pixel, 1 to 4.
    kind : str
        What the numbers mean: ``"color"``, ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``.
    """

    dtype: np.dtype[Any]
    channels: int
    kind: str = "color"


class PixelWindow(NamedTuple):
    """A rectangle of the plane in pixels, its north-west pixel as integers of any size."""

    x: int
    y: int
    width: int
    height: int

    def grow(self, margin: int) -> "PixelWindow":
        """The window with ``margin`` more pixels on every side."""
        return PixelWindow(
            self.x - margin, self.y - margin, self.width + 2 * margin, self.height + 2 * margin
        )

    def split(self, columns: int, rows: int) -> Iterator[tuple["PixelWindow", tuple[slice, slice]]]:
        """Pieces of at most ``columns`` x ``rows`` pixels, row by row, and where each lies in the window."""
        for top in range(0, self.height, rows):
            for left in range(0, self.width, columns):
                width, height = min(columns, self.width - left), min(rows, self.height - top)
                at = slice(top, top + height), slice(left, left + width)
                yield PixelWindow(self.x + left, self.y + top, width, height), at


def check_pixel_window(
    domain: Domain, reach: tuple[int, int], x: Any, y: Any, width: Any, height: Any
) -> PixelWindow:
    """A window as integers of any size, if it lies in a domain of pixels and within ``reach``."""
    first, extent = [], []
    for axis, (at, count) in enumerate(((x, width), (y, height))):
        name, side = "xy"[axis], ("width", "height")[axis]
        extent.append(check_int(side, count, 1, LARGEST_SIDE))
        low, high = domain.bounds[axis] or (-reach[axis], reach[axis])
        if extent[axis] > high - low:
            raise TilewrightValueError(
                f"is {count}; there are {high - low} pixels",
                argument=side,
                value=count,
                allowed=f"1 to {high - low}",
            )
        first.append(check_int(name, at, low, high - extent[axis]))
    return PixelWindow(*first, *extent)


def check_pair(name: str, given: Any) -> tuple[int, int]:
    """Width and height in pixels, both at least 1."""
    if not isinstance(given, (tuple, list)) or len(given) != 2:
        raise type_error(name, given, "a width and a height in pixels")
    width, height = (check_int(name, side, 1, LARGEST_SIDE) for side in given)
    return width, height


def indexed_window(domain: Domain, key: Any) -> tuple[tuple[int, int, int, int], tuple[Any, Any]]:
    """The window x, y, width, height that ``[y, x]`` asks for, and what is taken of its rows and columns.

    A range may be left open where the plane ends; numbers below 0 are places of their own, not counted from
    an end.
    """
    if not isinstance(key, tuple) or len(key) != 2:
        raise TilewrightTypeError("is indexed by y and x, as [0:50, 0:100]", argument="field", value=key)
    rows, columns = (_indexed_axis(domain, axis, part) for axis, part in ((1, key[0]), (0, key[1])))
    return (columns[0], rows[0], columns[1], rows[1]), (rows[2], columns[2])


def _indexed_axis(domain: Domain, axis: int, part: Any) -> tuple[int, int, Any]:
    """First pixel, number of pixels, and what is taken of them, along an axis."""
    name = "xy"[axis]
    if not isinstance(part, slice):
        return check_int(name, part, -_FAR, _FAR), 1, 0
    low, high = domain.bounds[axis] or (None, None)
    start, stop = low if part.start is None else part.start, high if part.stop is None else part.stop
    if start is None or stop is None:
        raise TilewrightValueError(
            "is a range without an end, and the plane has none", argument=name, advice="give both ends"
        )
    start, stop = check_int(name, start, -_FAR, _FAR), check_int(name, stop, -_FAR, _FAR)
    if stop <= start:
        raise TilewrightValueError(f"is {start}:{stop}, which holds no pixel", argument=name)
    return start, stop - start, slice(None, None, part.step)
