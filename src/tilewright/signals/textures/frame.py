"""The geometry of a canvas of one tile: where patches must lie, may lie and must not."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures.patchwork import FORCED_NEW, FORCED_OLD, OPEN


def shared_border(size: int) -> int:
    """Pixels along the border of a tile of ``size`` pixels that all tiles with that border have alike.

    A power of two, so that whole texels of the first mip levels fill it: up to a 32nd of a tile, at least 2.
    A wider border would be seen to recur, and coarser levels hardly need it, see ``mipmaps.py``.
    """
    return max(2, 1 << max(1, size // 32).bit_length() - 1)


@dataclass(frozen=True)
class Frame:
    """A square canvas of ``size`` pixels; u runs east and v south from its middle.

    The canvas of a tile has the tile's middle in its middle, the canvas of an edge the edge's. Half a
    tile on either side of an edge, less what its two end corners keep, is the diamond |u| + |v| < size/2:
    the diamonds of different edges never overlap.
    """

    size: int

    @property
    def half(self) -> int:
        """Pixels from the border to the middle."""
        return self.size // 2

    @cached_property
    def v(self) -> NDArray[np.float64]:
        """Pixel centers' distance south of the middle."""
        return np.indices((self.size, self.size))[0] + 0.5 - self.half

    @cached_property
    def u(self) -> NDArray[np.float64]:
        """Pixel centers' distance east of the middle."""
        return np.indices((self.size, self.size))[1] + 0.5 - self.half

    @cached_property
    def diamond(self) -> NDArray[np.bool_]:
        """Pixels whose content an edge decides."""
        return np.abs(self.u) + np.abs(self.v) < self.half

    def along_across(self, axis: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Coordinates along and across an edge of the given axis."""
        return (self.u, self.v) if axis == 0 else (self.v, self.u)

    def superellipse(self, reach: float) -> NDArray[np.bool_]:
        """A square with round corners (exponent 4), ``reach`` tiles from the middle to its sides."""
        powers = ((np.arange(self.size) + 0.5 - self.half) / (reach * self.size)) ** 4
        return powers + powers[:, np.newaxis] < 1

    def ring(self, core: NDArray[np.bool_], limit: NDArray[np.bool_]) -> NDArray[np.uint8]:
        """State of a patch that must fill ``core`` and may reach up to ``limit``."""
        state = np.where(limit, OPEN, FORCED_OLD).astype(np.uint8)
        state[core] = FORCED_NEW
        return state

    @cached_property
    def triangles(self) -> tuple[NDArray[np.bool_], ...]:
        """The four triangles N, E, S, W the diagonals cut a tile into; each pixel is in one."""
        north = (self.v < 0) & (np.abs(self.u) < -self.v)
        south = (self.v > 0) & (np.abs(self.u) < self.v)
        west = (self.u < 0) & ~north & ~south
        return north, ~(north | south | west), south, west

    @cached_property
    def triangle_pixels(self) -> tuple[tuple[NDArray[np.intp], ...], ...]:
        """Rows and columns of the pixels of each triangle."""
        return tuple(triangle.nonzero() for triangle in self.triangles)

    def edge_offset(self, side: int) -> tuple[int, int]:
        """Canvas of edge N, E, S or W, seen from the tile: edge pixel = tile pixel + this."""
        return ((self.half, 0), (0, -self.half), (-self.half, 0), (0, self.half))[side]

    def corner_offset(self, corner: int) -> tuple[int, int]:
        """Lattice point NE, SE, SW or NW in tile pixels."""
        return ((0, self.size), (self.size, self.size), (self.size, 0), (0, 0))[corner]
