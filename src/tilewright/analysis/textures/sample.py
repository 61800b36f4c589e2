"""A piece of the endless plane to measure: which tile, which origin and which color at each pixel."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.fields import TextureField
from tilewright.signals.textures import TextureTiles
from tilewright.tilings import stochastic


@dataclass(frozen=True, eq=False)
class Sample:
    """A random tiling of n x n cells with its pixels; nothing is blended.

    Attributes
    ----------
    material : TextureTiles
        The picture of each tile.
    cells : int32 array, shape (n, n)
        Picture in each cell: its row in the material's maps.
    plane : array, shape (n size, n size, channels), or None
        The main map as a field shows it, with tone over the tiles; None where there is none.
    """

    material: TextureTiles
    cells: NDArray[np.int32]
    plane: NDArray[np.generic] | None = None

    @property
    def size(self) -> int:
        """Pixels along a tile."""
        return self.material.tile_size

    def assemble(self, tiles: NDArray[np.generic]) -> NDArray[np.generic]:
        """Lay pictures side by side.

        Parameters
        ----------
        tiles : array, shape (rows, size, size, k)
            Pictures of any type, in the order of the material's maps.

        Returns
        -------
        array, shape (n * size, n * size, k)
            The pictures where the cells have them.
        """
        rows, columns = self.cells.shape
        picture = tiles[self.cells].swapaxes(1, 2)
        return picture.reshape(rows * self.size, columns * self.size, -1)

    @cached_property
    def pixels(self) -> NDArray[np.float32]:
        """The main map, shape (n size, n size, channels)."""
        return self.assemble(self.material.pixels).astype(np.float32)

    @property
    def shown(self) -> NDArray[np.generic]:
        """The main map as it is seen, of its own type."""
        return self.assemble(self.material.pixels) if self.plane is None else self.plane

    @cached_property
    def origins(self) -> NDArray[np.int32]:
        """(source, y, x) of each pixel."""
        return self.assemble(self.material.origins).astype(np.int32)

    @cached_property
    def cuts(self) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Pixel pairs whose origins do not continue each other: to the east (h, w - 1), to the south."""
        east = (np.diff(self.origins, axis=1) != (0, 0, 1)).any(axis=2)
        south = (np.diff(self.origins, axis=0) != (0, 1, 0)).any(axis=2)
        return east, south

    @cached_property
    def gray(self) -> NDArray[np.float32]:
        """Mean of the channels."""
        return self.pixels.mean(axis=2)


def lay_sample(material: TextureTiles, cells: int = 12, seed: int = 0) -> Sample:
    """Lay a random piece of n x n cells, directly where the set allows it and by scanline otherwise.

    Parameters
    ----------
    material : TextureTiles
        The picture of each tile.
    cells : int, optional
        Cells of the piece along a side, 4 to 64; default 12.
    seed : int, optional
        Seed of the tiling; default 0.

    Returns
    -------
    Sample
        The piece.

    Raises
    ------
    TilewrightTypeError
        A number that is not an integer.
    TilewrightValueError
        A number out of range.
    """
    n = check_int("cells", cells, 4, 64)
    tiling = stochastic(material.tiles, n, n, seed)
    plane = None
    if material.tone is not None:
        side = n * material.tile_size
        plane = TextureField(material, tiling).render(0, 0, side, side)
    return Sample(material, tiling.rows(0, 0, n, n, variants=material.variants), plane)
