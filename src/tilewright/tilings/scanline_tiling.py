"""Scanline stochastic tiling: tiles are placed one after another, each at random among those that fit."""

from math import prod
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.hashes import MixerHash
from tilewright.tilings.streams import DRAWS
from tilewright.tilings.tiling import ArrayTiling

if TYPE_CHECKING:
    from tilewright.kernels.placing import Fitting

Integers = NDArray[np.int64]
_MOST_TILES = 2**20
_MOST_CELLS = 2**31


def scanline(tiles: TileSet, width: int, height: int = 1, seed: int = 0, *, depth: int = 1) -> ArrayTiling:
    """Tile a rectangle from west to east and from north to south; a block of cubes from top to bottom too.

    Each tile is chosen at random among those whose slots agree with the neighbors already placed to the west,
    to the north (and above): N and W edges for Wang tiles, NE, NW and SW corners for corner tiles, and both
    for tiles with both.

    Parameters
    ----------
    tiles : TileSet
        At most 2^20 tiles.
    width : int
        Cells along x, 1 to 65,536; 2^31 cells in all at most.
    height : int, optional
        Cells along y, 1 to 65,536, of dominoes 1; default 1.
    seed : int, optional
        0 to 2^64 - 1; default 0. A larger rectangle continues a smaller one of the same seed.
    depth : int, optional
        Cells along z, 1 to 65,536, of all but cubes 1; default 1.

    Returns
    -------
    ArrayTiling
        The rectangle, from cell (0, 0) on.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        No tile fits at some cell: the message names the cell and the colors that were asked for. Or there are
        too many cells or tiles, or a number is out of range.

    Notes
    -----
    Cohen et al. 2003, section 2; Lagae 2007, sections 3.2.1 and 3.2.2; Lagae & Dutré 2006, section 4.1.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiling = tw.scanline(tw.cohen_tiles(8), 6, 4, seed=2)
    >>> tiling.indices(0, 0, 6, 4).shape
    (4, 6)
    """
    dimension = check_tiles("tiles", tiles).shape.dimension
    named = (("width", width), ("height", height), ("depth", depth))
    extent = [
        check_int(name, count, 1, 65536 if axis < dimension else 1, f"the tiles are {tiles.shape.name} tiles")
        for axis, (name, count) in enumerate(named)
    ]
    if prod(extent) > _MOST_CELLS:
        raise TilewrightValueError(f"{' x '.join(map(str, extent))} cells are too many; 2^31 are allowed")
    if len(tiles) > _MOST_TILES:
        raise TilewrightValueError(
            f"the {tiles.name} set has {len(tiles)} tiles; scanline tiling takes at most 2^20"
        )
    rows = _Rows(tiles, MixerHash(seed), np.empty(extent[::-1], np.int32))
    for z in range(extent[2]):
        for y in range(extent[1]):
            rows.lay(y, z)
    return ArrayTiling(tiles, rows.cells.reshape(extent[:dimension][::-1]))


class _Rows:
    """Cells ``[z, y, x]`` that are laid row by row.

    Across each axis, what tiles ask of each other is numbered: ``near[axis]`` is the number a tile offers at
    its west, north or upper side, ``far[axis]`` the number it asks the next tile to offer there.
    """

    def __init__(self, tiles: TileSet, hash: MixerHash, cells: NDArray[np.int32]) -> None:
        self.tiles = tiles
        self.hash = hash
        self.cells = cells
        self.near, self.far = zip(
            *(_number_sides(tiles, a) for a in range(tiles.shape.dimension)), strict=True
        )
        self.fitting: dict[tuple[int, ...], Fitting] = {}

    def lay(self, y: int, z: int) -> None:
        """Fill one row, whose neighbors to the north and above have been laid."""
        from tilewright.kernels.placing import place_row

        row = self.cells[z, y]
        before = {1: (z, y - 1)} if y else {}
        before |= {2: (z - 1, y)} if z else {}
        # Step 1: what the neighbors to the north and above ask of each cell.
        known = tuple(before)
        beside = self._key(known, [self.far[axis][self.cells[at]] for axis, at in before.items()], len(row))
        # Step 2: the first tile is asked for that alone, the others by the tile to the west too.
        first, rest = self._fitting_when(known), self._fitting_when((*known, 0))
        laid = place_row(beside, self.far[0], self._count(0), first, rest, y, z, DRAWS, self.hash.seed, row)
        if laid < len(row):
            neighbors = {0: row[laid - 1]} if laid else {}
            neighbors |= {axis: self.cells[at][laid] for axis, at in before.items()}
            raise TilewrightValueError(self._dead_end((laid, y, z), neighbors))

    def _count(self, axis: int) -> int:
        return int(self.near[axis].max()) + 2

    def _key(self, known: tuple[int, ...], numbers: list[Integers], size: int) -> Integers:
        """One number for what is asked across all known axes."""
        key = np.zeros(size, np.int64)
        for axis, number in zip(known, numbers, strict=True):
            key = key * self._count(axis) + number
        return key

    def _fitting_when(self, known: tuple[int, ...]) -> "Fitting":
        """The tiles by what they offer across the known axes."""
        from tilewright.kernels.placing import Fitting

        if known not in self.fitting:
            key = self._key(known, [self.near[axis] for axis in known], len(self.tiles))
            order = np.argsort(key, kind="stable")
            keys, starts = np.unique(key[order], return_index=True)
            self.fitting[known] = Fitting(keys, np.append(starts, len(order)), order)
        return self.fitting[known]

    def _dead_end(self, cell: tuple[int, ...], neighbors: dict[int, int]) -> str:
        tiles = self.tiles
        asked = {
            tiles.shape.slots[near]: int(tiles.slots[tile, far])
            for axis, tile in neighbors.items()
            for far, near in tiles.shape.across(axis)
        }
        at = ", ".join(f"{name}={n}" for name, n in zip("xyz", cell[: tiles.shape.dimension], strict=False))
        colors = ", ".join(f"{slot}={color}" for slot, color in asked.items())
        return f"dead end at cell {at}: the {tiles.name} set has no tile with {colors}"


def _number_sides(tiles: TileSet, axis: int) -> tuple[Integers, Integers]:
    """Numbers for the colors that tiles offer at the near side of an axis, and for those they ask for."""
    far, near = np.array(tiles.shape.across(axis), int).reshape(-1, 2).T
    sides = np.concatenate([tiles.slots[:, near], tiles.slots[:, far]])
    numbers = np.unique(sides, axis=0, return_inverse=True)[1].ravel()
    offered, ours = np.unique(numbers[: len(tiles)], return_inverse=True)
    asked = numbers[len(tiles) :]
    place = np.searchsorted(offered, asked).clip(max=len(offered) - 1)
    # What no tile offers has the number after the last.
    return ours, np.where(offered[place] == asked, place, len(offered))
