"""A texture over a tiling: pixels of any window of an endless plane."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, check_int
from tilewright.errors import Progress, TilewrightTypeError, TilewrightValueError
from tilewright.fields.agreement import check_agreement
from tilewright.files.atomic import as_path
from tilewright.files.image_streams import stream_image
from tilewright.files.images import check_writable
from tilewright.signals.textures import TextureTiles
from tilewright.tilings import Tiling
from tilewright.tilings.domain import LARGEST_CELL

_LARGEST_SIDE = 2**31 - 1


class TextureField:
    """Texture tiles laid by a tiling.

    Parameters
    ----------
    material : TextureTiles
    tiling : Tiling
        A tiling of the same tile set.

    Notes
    -----
    Pixel (0, 0) is the north-west pixel of cell (0, 0); x grows east and y grows south. Cells reach
    to +-2^61, so pixel coordinates are Python integers of any size up to that many tiles. Variants of tiles
    are drawn as `Tiling.placements` tells.
    """

    def __init__(self, material: TextureTiles, tiling: Tiling) -> None:
        check_agreement(material, TextureTiles, tiling)
        self.material = material
        self.tiling = tiling

    def render(
        self,
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        map: str | None = None,
        out: NDArray[Any] | None = None,
    ) -> NDArray[Any]:
        """Pixels of a window, equal to the same pixels of any other window.

        Parameters
        ----------
        x, y : int
            North-west pixel.
        width, height : int
            Pixels.
        map : str, optional
            Which map; the main one by default.
        out : array, shape (height, width, channels) of the map's type, C-contiguous, optional
            Filled and returned.

        Returns
        -------
        array, shape (height, width, channels), of the map's type
        """
        tiles = self._map(map)
        size, channels = tiles.shape[1], tiles.shape[3]
        column, left, columns = self._cells("x", x, "width", width)
        row, top, rows = self._cells("y", y, "height", height)
        if out is None:
            out = _make_out((height, width, channels), tiles.dtype)
        else:
            _check_out(out, (height, width, channels), tiles.dtype)
        from tilewright.kernels.assembly import copy_tiles

        pixel = channels * tiles.itemsize
        copy_tiles(
            np.ascontiguousarray(tiles).view(np.uint8).reshape(len(tiles), size, size * pixel),
            self.tiling.rows(column, row, columns, rows, variants=self.material.variants),
            top,
            left,
            size,
            pixel,
            out.view(np.uint8).reshape(height, width * pixel),
        )
        return out

    def save(
        self,
        path: str | Path,
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        map: str | None = None,
        progress: Progress | None = None,
    ) -> None:
        """Render a window to a file, a block at a time, in memory that does not grow with the window.

        ``.tif`` becomes a tiled BigTIFF, ``.png`` holds 8 and 16 bit, ``.exr`` holds float. The file
        appears when it is complete; raise `Cancelled` in ``progress`` to stop.
        """
        tiles = self._map(map)
        check_writable(as_path(path), tiles.dtype)
        self._cells("x", x, "width", width)
        self._cells("y", y, "height", height)

        def block(left: int, top: int, columns: int, rows: int) -> NDArray[Any]:
            if progress is not None:
                progress(top, height, f"rendering {Path(path).name}")
            return self.render(x + left, y + top, columns, rows, map=map)

        stream_image(path, block, height, width, tiles.shape[3], tiles.dtype)
        if progress is not None:
            progress(height, height, f"rendering {Path(path).name}")

    def _map(self, name: str | None) -> NDArray[Any]:
        if name is None:
            return self.material.pixels
        return self.material.maps[check_choice("map", name, tuple(self.material.maps))]

    def _cells(self, axis: str, first: int, extent: str, count: int) -> tuple[int, int, int]:
        """First cell of a range of pixels, pixels of it to skip, and the number of cells."""
        size = self.material.tile_size
        reach = LARGEST_CELL * size
        count = check_int(extent, count, 1, _LARGEST_SIDE)
        first = check_int(axis, first, -reach, reach - count)
        cell, skipped = divmod(first, size)
        return cell, skipped, (skipped + count - 1) // size + 1


def _make_out(shape: tuple[int, ...], kind: np.dtype[Any]) -> NDArray[Any]:
    try:
        return np.empty(shape, kind)
    except (MemoryError, ValueError):
        raise TilewrightValueError(
            f"a window of {shape[1]} x {shape[0]} pixels does not fit in memory; "
            "render smaller ones, or save() it to a file"
        ) from None


def _check_out(out: NDArray[Any], shape: tuple[int, ...], kind: np.dtype[Any]) -> None:
    if type(out) is not np.ndarray:
        raise TilewrightTypeError(f"out must be an array, not {type(out).__name__}")
    if out.shape != shape or out.dtype != kind or not (out.flags.c_contiguous and out.flags.writeable):
        raise TilewrightValueError(
            f"out is {out.dtype} {out.shape}, C-contiguous: {out.flags.c_contiguous}, writable: "
            f"{out.flags.writeable}; expected {kind} {shape}, C-contiguous and writable"
        )
