"""The plane from a photograph without tiles: repeated, or blended from patches on a triangle grid.

These are the methods that tiles are compared with; `tilewright.compare_textures` measures them.
"""

from abc import abstractmethod
from collections.abc import Mapping
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.fields.photos.gaussian import gaussianize
from tilewright.fields.plane import PixelField
from tilewright.fields.windows import PixelMap, PixelWindow
from tilewright.files.images import open_picture
from tilewright.pixels import LUMA, is_pillow
from tilewright.signals.textures.exemplar import check_map
from tilewright.signals.textures.kinds import from_values, to_values
from tilewright.tilings import Domain, MixerHash
from tilewright.tilings.streams import PATCH_COLUMNS, PATCH_ROWS

_LUMA = np.array(LUMA, np.float32)
CONTRAST, EXPONENT = 0.6, 7
"""How much a patch's brightness and its place count in hex-tiling (Mikkelsen 2022)."""
_REACH = 2**62
_BLOCK = 2**18


class PhotoField(PixelField):
    """A plane made from one photograph, which reaches to pixels +-2^62.

    Parameters
    ----------
    photo : path, Pillow image, or array of shape (h, w, channels) or (h, w), uint8, uint16 or float32
        The photograph, 32 to 32,768 pixels on each side.
    kind : str, optional
        What it holds: ``"color"`` (default), ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``.

    Attributes
    ----------
    lattice : int64 array, shape (2, 2)
        Two vectors (x, y), in pixels, of the lattice that the method works on.
    """

    lattice: NDArray[np.int64]
    reach = (_REACH, _REACH)

    def __init__(self, photo: Any, kind: str = "color") -> None:
        brought = isinstance(photo, str | PathLike) or is_pillow(photo)
        opened = open_picture("photo", photo, color=kind == "color") if brought else photo
        self.photo = check_map("photo", opened)
        self.kind = kind

    @property
    def domain(self) -> Domain:
        """Where there are pixels, and after how many of them they repeat, x first."""
        return Domain()

    @property
    def maps(self) -> dict[str, PixelMap]:
        """The type, channels and kind of the one map, ``"photo"``."""
        return {"photo": PixelMap(self.photo.dtype, self.photo.shape[2], self.kind)}

    def _paint(self, window: PixelWindow, outs: Mapping[str, NDArray[Any]]) -> None:
        """Painted in blocks of rows."""
        for out in outs.values():
            columns = min(window.width, _BLOCK)
            for piece, at in window.split(columns, max(1, _BLOCK // columns)):
                out[at] = self._fill(*piece)

    @abstractmethod
    def _fill(self, x: int, y: int, width: int, height: int) -> NDArray[Any]:
        """Pixels of a window of a size that fits in memory."""


class RepeatField(PhotoField):
    """The photograph laid side by side, as it is.

    Parameters
    ----------
    photo : path, Pillow image, or array of shape (h, w, channels) or (h, w), uint8, uint16 or float32
        The photograph, 32 to 32,768 pixels on each side.
    kind : str, optional
        What it holds: ``"color"`` (default), ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``.

    Attributes
    ----------
    lattice : int64 array, shape (2, 2)
        The photograph's width and height as two vectors (x, y), in pixels.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        A photograph of another type, shape or size, or one that holds NaN or infinity.
    """

    def __init__(self, photo: Any, kind: str = "color") -> None:
        super().__init__(photo, kind)
        h, w = self.photo.shape[:2]
        self.lattice = np.array([[w, 0], [0, h]])

    @property
    def domain(self) -> Domain:
        """The plane, which repeats after the size of the photograph."""
        return Domain(self.photo.shape[1::-1], (None, None))

    def _fill(self, x: int, y: int, width: int, height: int) -> NDArray[Any]:
        h, w = self.photo.shape[:2]
        return self.photo[(np.arange(height) + y % h) % h][:, (np.arange(width) + x % w) % w]


class BlendField(PhotoField):
    """Three patches of the photograph blended at each pixel, one for each vertex of a triangle.

    Heitz & Neyret 2018 ("High-Performance By-Example Noise using a Histogram-Preserving Blending Operator",
    HPG), section 3: every vertex of a triangle grid has a random patch of the photograph, a hexagon as wide
    as two edges of the grid, and patches fade from their vertex to the edge of the hexagon. An edge of the
    grid is 1 / (2 sqrt 3) of the photograph's shorter side.

    Departs from it in two ways. Both papers take a seamless photograph; here any will do, as patches reach
    over its border only where they have faded to half, and find it mirrored there. The grid is rounded to
    whole pixels, so that it is exact anywhere on the plane.

    Parameters
    ----------
    photo, kind : as for `PhotoField`
    seed : int
        0 to 2^64 - 1; the patch of a vertex depends on the vertex and the seed only.

    Attributes
    ----------
    edge, row : int
        Pixels from vertex to vertex of a row, and from row to row.
    range : ((int, int), (int, int))
        The first place, and how many, that the middle of a patch may have in x and in y.
    """

    def __init__(self, photo: Any, kind: str = "color", *, seed: int = 0) -> None:
        super().__init__(photo, kind)
        self.hash = MixerHash(seed)
        self.edge, self.row = triangle_grid(self.photo.shape[:2])
        self.lattice = np.array([[self.edge, 0], [self.edge // 2, self.row]])
        self.range = patch_range(self.photo.shape[:2])

    def _fill(self, x: int, y: int, width: int, height: int) -> NDArray[Any]:
        weights, rows, columns = self._patches(x, y, width, height)
        return self._blend(weights, rows, columns)

    @abstractmethod
    def _blend(
        self, weights: NDArray[np.float64], rows: NDArray[np.int64], columns: NDArray[np.int64]
    ) -> NDArray[Any]:
        """Pixels from three places of the photograph each; arrays of shape (3, height, width)."""

    def _patches(
        self, x: int, y: int, width: int, height: int
    ) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
        """Barycentric weight and photograph pixel of each of three patches."""
        a, h = self.edge, self.row
        # Whole rows and columns of the grid are taken off first, so that no digit is lost far out.
        j0, top = divmod(y, h)
        i0, left = divmod(x - j0 * (a // 2), a)
        py, px = np.meshgrid(top + np.arange(height), left + np.arange(width), indexing="ij")
        v = (py + 0.5) / h
        u = (px + 0.5) / a - v / 2
        i, j = np.floor(u).astype(np.int64), np.floor(v).astype(np.int64)
        u, v = u - i, v - j
        upper = u + v > 1
        one = upper.astype(np.int64)
        weights = np.where(upper, (u + v - 1, 1 - v, 1 - u), (1 - u - v, u, v))
        vertices = ((i + one, j + one), (i + 1, j), (i, j + 1))
        rows, columns = np.empty_like(weights, np.int64), np.empty_like(weights, np.int64)
        patches = self._centers(_wrapped(i0), _wrapped(j0), i.min(), i.max() + 2, j.max() + 2)
        for k, (vi, vj) in enumerate(vertices):
            patch_x, patch_y = patches[:, vj, vi - i.min()]
            columns[k] = mirrored(px - (vi * a + vj * (a // 2)) + patch_x, self.photo.shape[1])
            rows[k] = mirrored(py - vj * h + patch_y, self.photo.shape[0])
        return weights, rows, columns

    def _centers(self, i0: np.int64, j0: np.int64, first: int, last: int, rows: int) -> NDArray[np.int64]:
        """Middles (x, y) of the patches of vertices (i, j), in the photograph.

        Shape (2, rows, last - first), for i from first up to last and j from 0 on, counted from (i0, j0).
        """
        i, j = np.meshgrid(i0 + np.arange(first, last), j0 + np.arange(rows))
        return np.stack(
            [
                least + (self.hash.numbers(stream, i, j) * count >> 24)
                for (least, count), stream in zip(self.range, (PATCH_COLUMNS, PATCH_ROWS), strict=True)
            ]
        )


class HexField(BlendField):
    """Hex-tiling: patches blended sharply, the brighter one further in front (Mikkelsen 2022).

    Parameters
    ----------
    photo : path, Pillow image, or array of shape (h, w, channels) or (h, w), uint8, uint16 or float32
        The photograph, 32 to 32,768 pixels on each side.
    kind : str, optional
        What it holds: ``"color"`` (default), ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``.
    seed : int, optional
        Seed of the places that patches are taken from, 0 to 2^64 - 1; default 0.

    Attributes
    ----------
    lattice : int64 array, shape (2, 2)
        Two vectors (x, y), in pixels, of the triangle grid.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        A photograph of another type, shape or size, or one that holds NaN or infinity; a seed out of range.

    Notes
    -----
    Mikkelsen 2022 ("Practical Real-Time Hex-Tiling", JCGT 11 (2)): weights are barycentric ones to the 7th
    power, times the patch's luminance mixed with 1 (contrast 0.6), and sum to 1. Light is blended linearly.
    His options to turn patches and to sharpen further (gain) stay off, as photographs have a direction of
    light. There is nothing to prepare, and no table.
    """

    def __init__(self, photo: Any, kind: str = "color", *, seed: int = 0) -> None:
        super().__init__(photo, kind, seed=seed)
        self._values = to_values(self.photo, kind)

    def _blend(
        self, weights: NDArray[np.float64], rows: NDArray[np.int64], columns: NDArray[np.int64]
    ) -> NDArray[Any]:
        values = self._values[rows, columns]
        bright = values[..., :3] @ _LUMA if values.shape[-1] >= 3 else values[..., 0]
        weights = (1 + CONTRAST * (bright - 1)) * weights**EXPONENT
        weights /= weights.sum(axis=0)
        blended = (weights[..., np.newaxis] * values).sum(axis=0)
        return from_values(blended.astype(np.float32), self.kind, self.photo)


class NoiseField(BlendField):
    """By-example noise: patches blended so that the histogram of the photograph stays (Heitz & Neyret 2018).

    Parameters
    ----------
    photo : path, Pillow image, or array of shape (h, w, channels) or (h, w), uint8, uint16 or float32
        The photograph, 32 to 32,768 pixels on each side.
    kind : str, optional
        What it holds: ``"color"`` (default), ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``.
    seed : int, optional
        Seed of the places that patches are taken from, 0 to 2^64 - 1; default 0.

    Attributes
    ----------
    lattice : int64 array, shape (2, 2)
        Two vectors (x, y), in pixels, of the triangle grid.
    gaussian : Gaussianized
        The photograph with Gaussian histograms, and the table that leads back.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        A photograph of another type, shape or size, or one that holds NaN or infinity; a seed out of range.

    Notes
    -----
    Heitz & Neyret 2018, section 4, in the variant of Deliot & Heitz 2019: the photograph gets Gaussian
    histograms once, for each axis of its encoded colors; blending divides by the root of the sum of squared
    weights, which keeps their variance; a table leads back.
    """

    def __init__(self, photo: Any, kind: str = "color", *, seed: int = 0) -> None:
        super().__init__(photo, kind, seed=seed)
        self._low, self._high = _bounds(self.photo)
        self.gaussian = gaussianize((self.photo - self._low) / (self._high - self._low))

    def _blend(
        self, weights: NDArray[np.float64], rows: NDArray[np.int64], columns: NDArray[np.int64]
    ) -> NDArray[Any]:
        gauss = self.gaussian.pixels[rows, columns] / 255 - 0.5
        mixed = (weights[..., np.newaxis] * gauss).sum(axis=0)
        mixed /= np.sqrt((weights**2).sum(axis=0))[..., np.newaxis]
        color = self._low + self.gaussian.restore(mixed + 0.5) * (self._high - self._low)
        return (color if self.photo.dtype.kind == "f" else np.rint(color)).astype(self.photo.dtype)


def triangle_grid(size: tuple[int, ...]) -> tuple[int, int]:
    """Edge and row height, in pixels, of the triangle grid for a photograph (h, w); the edge is even."""
    edge = 2 * round(min(size) / (4 * 3**0.5))
    return edge, round(edge * 3**0.5 / 2)


def mirrored(index: NDArray[np.int64], size: int) -> NDArray[np.int64]:
    """Places along a side of ``size`` pixels that is mirrored at its ends, again and again."""
    index = index % (2 * size)
    return np.where(index < size, index, 2 * size - 1 - index)


def patch_range(size: tuple[int, ...]) -> tuple[tuple[int, int], tuple[int, int]]:
    """First place and number of places, in x and y, of the middles of patches in a photograph (h, w)."""
    halves = tuple(step // 2 for step in triangle_grid(size))
    (first_x, count_x), (first_y, count_y) = (
        (half, extent - 2 * half + 1) for half, extent in zip(halves, size[1::-1], strict=True)
    )
    return (first_x, count_x), (first_y, count_y)


def _bounds(photo: NDArray[Any]) -> tuple[float, float]:
    """What stands for 0 and 1."""
    if photo.dtype.kind == "u":
        return 0.0, float(np.iinfo(photo.dtype).max)
    low, high = min(0.0, float(photo.min())), max(1.0, float(photo.max()))
    return low, high


def _wrapped(index: int) -> np.int64:
    return np.uint64(index % 2**64).astype(np.int64)
