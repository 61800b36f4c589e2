"""Where the joints of brick Wang tiles meet their edges."""

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tiles import WANG, TileSet


def check_traversed(tiles: TileSet) -> TileSet:
    """``tiles`` if a line traverses each of them (Kaji et al. 2016, section 4)."""
    if tiles.shape is not WANG:
        raise TilewrightTypeError(
            f"must be brick Wang tiles, not {tiles.shape.name} tiles",
            argument="tiles",
            value=tiles.shape.name,
            allowed="brick Wang tiles",
        )
    north, east, south, west = tiles.slots.T
    free = ((north != south) & (west != east)).nonzero()[0]
    if len(free):
        slots = tiles.slots[free[0]].tolist()
        raise TilewrightValueError(
            f"tile {free[0]} of the {tiles.name} set has N, E, S, W {slots}; a line must traverse each "
            "tile of a wall: W and E the same, or N and S"
        )
    return tiles


def place_positions(count: int, length: int) -> NDArray[np.int64]:
    """Pixels along an edge at which joints of ``count`` positions meet it: (k + 1) / (count + 1) of it."""
    at = np.rint((np.arange(count) + 1) * length / (count + 1)).astype(np.int64)
    if len(np.unique(at)) < count:
        raise TilewrightValueError(
            f"{count} positions do not fit on an edge of {length} pixels", advice=f"take at least {count + 1}"
        )
    return at


def find_thinnest(places: list[NDArray[np.int64]], size: tuple[int, int]) -> int:
    """The least width or height of a brick, with half the mortar on either side."""
    return min(int(length + at[0] - at[-1]) for at, length in zip(places, size, strict=True))
