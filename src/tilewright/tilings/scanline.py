"""Scanline stochastic tiling: tiles are placed one after another, each at random among those that fit."""

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, check_int
from tilewright.tiles import TileSet
from tilewright.tilings.tiling import ArrayTiling


def scanline(tiles: TileSet, width: int, height: int, seed: int = 0) -> ArrayTiling:
    """Tile a rectangle from west to east and from north to south.

    Each tile is chosen at random among those whose slots agree with the neighbors already placed to the
    west and north: N and W edges for Wang tiles (Cohen et al. 2003, section 2; Lagae 2007, 3.2.1), NE,
    NW and SW corners for corner tiles (Lagae & Dutré 2006, 4.1; Lagae 2007, 3.2.2), and both for tiles
    with both.

    Parameters
    ----------
    tiles : TileSet
        Square tiles.
    width, height : int
        Cells, 1 to 65,536 each.
    seed : int

    Raises
    ------
    TilewrightValueError
        No tile fits at some cell: the message names the cell and the colors that were asked for.
    """
    if tiles.shape.dimension != 2:
        raise TilewrightValueError(f"scanline tiling is for square tiles, not {tiles.shape.name} ones")
    width, height = check_int("width", width, 1, 65536), check_int("height", height, 1, 65536)
    rng = np.random.default_rng(check_int("seed", seed, 0, 2**64 - 1))
    cells = np.empty((height, width), np.int32)
    fitting = _Fitting(tiles)
    for y in range(height):
        draws = rng.random(width)
        for x in range(width):
            west = int(cells[y, x - 1]) if x else -1
            north = int(cells[y - 1, x]) if y else -1
            choices = fitting.after(west, north)
            if not len(choices):
                raise TilewrightValueError(_dead_end(tiles, x, y, west, north))
            cells[y, x] = choices[int(draws[x] * len(choices))]
    return ArrayTiling(tiles, cells)


class _Fitting:
    """Which tiles fit east of one tile and south of another, found once for each pair of tiles."""

    def __init__(self, tiles: TileSet) -> None:
        self.tiles = tiles
        self.known: dict[tuple[bytes, bytes], NDArray[np.int64]] = {}
        (self.east, self.south) = (np.array(joint).T for joint in tiles.shape.joints)

    def after(self, west: int, north: int) -> NDArray[np.int64]:
        slots = self.tiles.slots
        asked = (
            slots[west, self.east[0]].tobytes() if west >= 0 else b"",
            slots[north, self.south[0]].tobytes() if north >= 0 else b"",
        )
        if asked not in self.known:
            keep = np.ones(len(slots), bool)
            if west >= 0:
                keep &= (slots[:, self.east[1]] == slots[west, self.east[0]]).all(axis=1)
            if north >= 0:
                keep &= (slots[:, self.south[1]] == slots[north, self.south[0]]).all(axis=1)
            self.known[asked] = keep.nonzero()[0]
        return self.known[asked]


def _dead_end(tiles: TileSet, x: int, y: int, west: int, north: int) -> str:
    wanted = {}
    for tile, joint in ((west, tiles.shape.joints[0]), (north, tiles.shape.joints[1])):
        for far, near in joint:
            if tile >= 0:
                wanted[tiles.shape.slots[near]] = int(tiles.slots[tile, far])
    colors = ", ".join(f"{slot}={color}" for slot, color in wanted.items())
    return f"dead end at cell x={x}, y={y}: the {tiles.name} set has no tile with {colors}"
