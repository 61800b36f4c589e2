"""Where a field is seen from: a window of the plane from straight above, or the plane in perspective.

A camera is a homography with rows x, y and w of three numbers: pixel (X, Y) sees the point
(x . q / w . q, y . q / w . q) of the plane, q = (X, Y, 1), and nothing where w . q <= 0. Whole cells are
split off exactly, so that what goes to the GPU as 32-bit floats is small anywhere on the plane.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from fractions import Fraction
from math import cos, floor, inf, pi, sin, tan

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, check_real
from tilewright.errors import TilewrightValueError
from tilewright.tilings.domain import LARGEST_CELL

_LARGEST_SIDE = 2**15
_FARTHEST = 2**26
"""Cells from a block's own cell in which the place of the next block's may lie."""


@dataclass(frozen=True, eq=False)
class Sight:
    """What a block of pixels sees: rows x, y, w of a homography to tiles counted from ``cell``."""

    cell: tuple[int, int]
    rows: NDArray[np.float64]


class Camera(ABC):
    """A picture of ``width`` x ``height`` pixels."""

    width: int
    height: int

    @abstractmethod
    def sight(self, left: int, top: int, width: int, height: int, tile_size: int) -> Sight:
        """What a block of the picture sees; its pixels count from its own corner."""

    @property
    @abstractmethod
    def filtering(self) -> str:
        """What a texture unit must do: ``"nearest"``, ``"trilinear"`` or ``"anisotropic"``."""


@dataclass(frozen=True)
class OrthographicCamera(Camera):
    """A window of the plane from straight above.

    Parameters
    ----------
    x, y : int or float, optional
        The north-west corner, in texels: pixels of the tiles, as in `TextureField.render`; default 0.
        Integers of any size are exact.
    width, height : int, optional
        Pixels of the picture, 1 to 32,768; default 1,024.
    scale : float, optional
        Texels per pixel, 2^-16 to 2^16; default 1, which shows the pixels of `TextureField.render`. 8 shows
        them at an eighth of their size.

    Raises
    ------
    TilewrightTypeError
        An argument that is no number.
    TilewrightValueError
        A number out of range.
    """

    x: float = 0
    y: float = 0
    width: int = 1024
    height: int = 1024
    scale: float = 1

    def __post_init__(self) -> None:
        _check_picture(self)
        check_real("scale", self.scale, 2.0**-16, 2.0**16)

    @property
    def filtering(self) -> str:
        """Nothing is to be filtered where every pixel is exactly one texel."""
        exact = self.scale == 1 and all(Fraction(c).denominator == 1 for c in (self.x, self.y))
        return "nearest" if exact else "trilinear"

    def sight(self, left: int, top: int, width: int, height: int, tile_size: int) -> Sight:
        """Tell what a block of the picture sees; its pixels count from its own corner.

        Parameters
        ----------
        left, top : int
            North-west pixel of the block.
        width, height : int
            Size of the block in pixels.
        tile_size : int
            Texels along a tile.

        Returns
        -------
        Sight
            A cell, and a homography from pixels to tiles counted from it.

        Raises
        ------
        TilewrightValueError
            The block sees cells that are too far out.
        """
        step = Fraction(self.scale) / tile_size
        x, y = Fraction(self.x) / tile_size + left * step, Fraction(self.y) / tile_size + top * step
        check_reach(self.x, self.y, tile_size, max(self.width, self.height) * float(step))
        rows = [[float(step), 0, float(x % 1)], [0, float(step), float(y % 1)], [0, 0, 1]]
        return Sight((floor(x), floor(y)), np.array(rows))


@dataclass(frozen=True)
class PerspectiveCamera(Camera):
    """The plane in perspective, from a point above it.

    Parameters
    ----------
    x, y : int or float, optional
        The point of the plane below the camera, in texels; default 0.
    altitude : float, optional
        Height of the camera above the plane, in texels, 0.001 to 10^9; default 512.
    tilt : float, optional
        Radians from straight down (0) to the horizon in the middle of the picture (pi / 2); default 1.2.
    heading : float, optional
        Direction of view in radians, clockwise from north, which is up in pictures; east is pi / 2; default
        0.
    fov : float, optional
        Vertical angle of view in radians, 0.001 to 3.1; default 0.8.
    width, height : int, optional
        Pixels of the picture, 1 to 32,768; default 1,024. The sky is 0 in all channels.

    Raises
    ------
    TilewrightTypeError
        An argument that is no number.
    TilewrightValueError
        A number out of range.
    """

    x: float = 0
    y: float = 0
    altitude: float = 512
    tilt: float = 1.2
    heading: float = 0
    fov: float = 0.8
    width: int = 1024
    height: int = 1024

    def __post_init__(self) -> None:
        _check_picture(self)
        check_real("altitude", self.altitude, 1e-3, 1e9)
        check_real("tilt", self.tilt, 0, pi / 2)
        check_real("heading", self.heading, -1e6, 1e6)
        check_real("fov", self.fov, 1e-3, 3.1)

    @property
    def filtering(self) -> str:
        """Pixels see long strips of the plane."""
        return "anisotropic"

    def sight(self, left: int, top: int, width: int, height: int, tile_size: int) -> Sight:
        """Tell what a block of the picture sees; its pixels count from its own corner.

        Parameters
        ----------
        left, top : int
            North-west pixel of the block.
        width, height : int
            Size of the block in pixels.
        tile_size : int
            Texels along a tile.

        Returns
        -------
        Sight
            A cell, and a homography from pixels to tiles counted from it.

        Raises
        ------
        TilewrightValueError
            The camera stands too far out.
        """
        check_reach(self.x, self.y, tile_size, 0)
        foot = [Fraction(c) / tile_size for c in (self.x, self.y)]
        rows = self._rows(tile_size) @ np.array([[1, 0, left], [0, 1, top], [0, 0, 1]])
        seen = _nearest_seen(rows, width, height)
        # The cell of the block: the cell below the camera, and whole cells from there to what the block sees.
        cells = [floor(f) + floor(s) for f, s in zip(foot, seen, strict=True)]
        for row, (f, cell) in enumerate(zip(foot, cells, strict=True)):
            rows[row] += float(f - cell) * rows[2]
        return Sight((cells[0], cells[1]), rows)

    def _rows(self, tile_size: int) -> NDArray[np.float64]:
        """The homography, in tiles from the point below the camera."""
        dip = pi / 2 - self.tilt
        ahead, right = (sin(self.heading), -cos(self.heading)), (cos(self.heading), sin(self.heading))
        focus = self.height / 2 / tan(self.fov / 2)
        reach = self.altitude / tile_size
        rows = np.empty((3, 3))
        for axis in (0, 1):
            # Along the picture's x axis, along its y axis, and straight ahead.
            rows[axis] = reach * np.array(
                [right[axis], -ahead[axis] * sin(dip), ahead[axis] * cos(dip) * focus]
            )
        rows[2] = [0, cos(dip), sin(dip) * focus]
        rows[:, 2] -= rows[:, :2] @ [self.width / 2, self.height / 2]
        return rows


def check_reach(x: float, y: float, tile_size: int, span: float) -> None:
    """Raise unless a camera stays over cells that have tiles."""
    for name, value in (("x", x), ("y", y)):
        if (
            not abs(Fraction(value)) + Fraction(span) * tile_size
            <= (LARGEST_CELL - _FARTHEST * 16) * tile_size
        ):
            raise TilewrightValueError(
                f"is {value}; cells reach to +-2^61, which is {LARGEST_CELL * tile_size} texels",
                argument=name,
                value=value,
            )


def _check_picture(camera: OrthographicCamera | PerspectiveCamera) -> None:
    for name in ("width", "height"):
        check_int(name, getattr(camera, name), 1, _LARGEST_SIDE)
    for name in ("x", "y"):
        value = getattr(camera, name)
        if not isinstance(value, int):
            check_real(name, value, -1e30, 1e30)


def _nearest_seen(rows: NDArray[np.float64], width: int, height: int) -> tuple[float, float]:
    """The point nearest to the camera that the corners of a block see; (0, 0) where they see the sky only."""
    best, near = (0.0, 0.0), inf
    for corner in ((0, 0), (width, 0), (0, height), (width, height)):
        x, y, w = rows @ [*corner, 1]
        if w > 0 and max(abs(x), abs(y)) / w < min(near, _FARTHEST):
            best, near = (x / w, y / w), max(abs(x), abs(y)) / w
    return best
