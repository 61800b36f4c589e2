"""Which tiles can lie around a tile."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles

OFFSETS = np.array([(1, 0), (0, 1), (1, 1), (-1, 1), (-1, 0), (0, -1), (-1, -1), (1, -1)], np.int64)
"""The eight directions E, S, SE, SW and, four later, their opposites W, N, NW, NE; x first."""
EAST, SOUTH, SOUTH_EAST, SOUTH_WEST, WEST, NORTH, NORTH_WEST, NORTH_EAST = range(8)


@dataclass(frozen=True, eq=False)
class Neighbors:
    """The tiles that can lie in each of eight directions of each tile.

    Attributes
    ----------
    fits : bool array, shape (8, T, T)
        ``fits[d, t, u]``: whether u can be in direction d of t. Across a corner it can if there are tiles
        for the two cells between.
    """

    fits: NDArray[np.bool_]

    @classmethod
    def of(cls, tiles: TileSet) -> "Neighbors":
        """Of a set of square tiles."""
        if check_tiles("tiles", tiles).shape.dimension != 2:
            raise TilewrightValueError(
                f"is a set of {tiles.shape.name} tiles; points need square tiles", argument="tiles"
            )
        east, south = (_joined(tiles, axis) for axis in (0, 1))
        south_east = _linked(east, south) & _linked(south, east)
        south_west = _linked(east.T, south) & _linked(south, east.T)
        ahead = np.stack([east, south, south_east, south_west])
        return cls(np.concatenate([ahead, ahead.transpose(0, 2, 1)]))

    def lists(self) -> tuple[NDArray[np.int64], NDArray[np.int32]]:
        """starts, shape (8, T + 1), and members: see `tilewright.kernels.wang_points`."""
        ends = np.cumsum(self.fits.sum(axis=2).ravel()).reshape(self.fits.shape[:2])
        firsts = np.concatenate([[0], ends[:-1, -1]])
        return np.column_stack([firsts, ends]), np.nonzero(self.fits)[2].astype(np.int32)


def _joined(tiles: TileSet, axis: int) -> NDArray[np.bool_]:
    """Whether tile u can be the next of tile t along an axis."""
    fits = np.ones((len(tiles), len(tiles)), bool)
    for far, near in tiles.shape.across(axis):
        fits &= tiles.slots[:, far, None] == tiles.slots[None, :, near]
    return fits


def _linked(first: NDArray[np.bool_], second: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether there is a tile that is ``first`` of tile t and of which tile u is ``second``."""
    return (first.astype(np.float32) @ second.astype(np.float32)) > 0
