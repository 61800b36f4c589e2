"""What is measured: a piece of a random tiling, laid from the index map.

The pixels are copied from the exemplar along ``origins``, never taken from ``maps``, so that no
blending or blur applied to the tiles can flatter a figure.
"""

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.fft import dctn, idctn

from tilewright.errors import TilewrightTypeError, TilewrightValueError, check_int
from tilewright.signals.textures import TextureTiles
from tilewright.tilings import direct, scanline

Gray = NDArray[np.float32]


class Sample:
    """A square piece of a random tiling with a texture tile set.

    Parameters
    ----------
    material : TextureTiles
    cells : int
        Cells along each side, 2 to 64.
    seed : int
        Which tiling: direct where the set has one, else scanline.
    """

    def __init__(self, material: TextureTiles, cells: int = 12, seed: int = 0) -> None:
        if not isinstance(material, TextureTiles):
            raise TilewrightTypeError(f"material must be TextureTiles, not {type(material).__name__}")
        self.material = material
        self.cells = check_int("cells", cells, 2, 64)
        self.size = material.tile_size
        self.indices = _random_cells(material, self.cells, seed)

    @cached_property
    def exemplars(self) -> list[NDArray[np.float32]]:
        """The main map of each source as float32, shape (h, w, channels), in its own units."""
        return [source[self.material.main].astype(np.float32) for source in self.material.sources]

    @cached_property
    def places(self) -> NDArray[np.int64]:
        """One number for the origin of each tile pixel, shape (T, H, W).

        East of a pixel its own patch goes on with the next number, south of it with ``stride`` more; one
        spare row and column keep the end of a row or a source from looking like that.
        """
        s, y, x = (self.material.origins[..., k].astype(np.int64) for k in range(3))
        return (s * self._rows + y) * self.stride + x

    @cached_property
    def stride(self) -> int:
        return max(e.shape[1] for e in self.exemplars) + 1

    @property
    def _rows(self) -> int:
        return max(e.shape[0] for e in self.exemplars) + 1

    @cached_property
    def tile_pixels(self) -> NDArray[np.float32]:
        """Every tile, copied from the exemplar, shape (T, H, W, channels)."""
        pixels = np.empty((*self.places.shape, self.exemplars[0].shape[2]), np.float32)
        origins = self.material.origins
        for number, exemplar in enumerate(self.exemplars):
            here = origins[..., 0] == number
            pixels[here] = exemplar[origins[here, 1], origins[here, 2]]
        return pixels

    @cached_property
    def pixels(self) -> NDArray[np.float32]:
        """The tiling, shape (n H, n W, channels)."""
        return self._lay(self.tile_pixels)

    @cached_property
    def gray(self) -> Gray:
        """Mean over the channels of ``pixels``."""
        return self._lay(self.tile_pixels.mean(axis=3))

    @cached_property
    def placed(self) -> NDArray[np.int64]:
        """``places`` over the tiling, shape (n H, n W)."""
        return self._lay(self.places)

    @cached_property
    def cuts(self) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Whether the patch changes from each pixel to its eastern, and to its southern neighbor."""
        return find_cuts(self.placed, self.stride)

    def _lay(self, tiles: NDArray[Any]) -> NDArray[Any]:
        n, size = self.cells, self.size
        return tiles[self.indices].swapaxes(1, 2).reshape(n * size, n * size, *tiles.shape[3:])


def as_sample(material: TextureTiles | Sample, cells: int, seed: int) -> Sample:
    """The sample itself, or a new one of a material."""
    return material if isinstance(material, Sample) else Sample(material, cells, seed)


def _random_cells(material: TextureTiles, cells: int, seed: int) -> NDArray[np.int32]:
    try:
        tiling = direct(material.tiles, seed)
    except TilewrightValueError:  # an incomplete set that only a scanline can lay
        return scanline(material.tiles, cells, cells, seed).indices(0, 0, cells, cells)
    return tiling.indices(0, 0, cells, cells)


def find_cuts(places: NDArray[np.int64], stride: int) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Pairs of neighbors along the last two axes that are not neighbors in the exemplar: east, south."""
    return np.diff(places, axis=-1) != 1, np.diff(places, axis=-2) != stride


class Blur:
    """Gaussian low-pass of one picture at several widths; the picture is mirrored at its borders."""

    def __init__(self, gray: Gray) -> None:
        self._spectrum = dctn(gray, norm="ortho")
        self._decay = [
            (np.pi * np.arange(n, dtype=np.float32) / n) ** 2 / 2 for n in gray.shape
        ]  # of a Gaussian of one pixel, as an exponent

    def low(self, sigma: float) -> Gray:
        """The picture smoothed by ``sigma`` pixels."""
        rows, columns = (np.exp(-(sigma**2) * d) for d in self._decay)
        return idctn(self._spectrum * rows[:, np.newaxis] * columns, norm="ortho")
