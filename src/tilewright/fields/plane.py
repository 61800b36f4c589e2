"""The common face of fields of pixels: maps of any window of a plane, in memory or in files."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_choice, check_out, check_progress
from tilewright.errors import Progress, TilewrightValueError
from tilewright.fields.sampling import FarView, sample_pixels, scaled_pixels, scaled_sides
from tilewright.fields.windows import (
    PixelMap,
    PixelWindow,
    check_pair,
    check_pixel_window,
    indexed_window,
)
from tilewright.files.atomic import AnyPath, as_path
from tilewright.files.image_streams import stream_image
from tilewright.files.picture_forms import picture_form
from tilewright.showing import Shown, describe, many
from tilewright.tilings import Domain

_BLOCK_BYTES = 16 << 20
"""Of a piece that `PixelField.blocks` gives, where no size is asked for."""


class PixelField(Shown, ABC):
    """Pixels of one or more maps at any place of a plane.

    A field never changes and holds no state of what was asked, so windows may be rendered in any order, by
    several threads, and by other processes that it was pickled to.

    Attributes
    ----------
    domain : Domain
        Where there are pixels, and after how many of them they repeat, x first.
    maps : dict of str to PixelMap
        The type, channels and kind of every map; the first is the main one.

    Notes
    -----
    x grows east and y grows south.
    """

    reach: tuple[int, int]
    """Pixels from the origin that an endless axis reaches to, along x and y."""

    @property
    @abstractmethod
    def domain(self) -> Domain:
        """Where there are pixels, and after how many of them they repeat, x first."""

    @property
    @abstractmethod
    def maps(self) -> dict[str, PixelMap]:
        """The type, channels and kind of every map; the first is the main one."""

    @abstractmethod
    def _paint(self, window: PixelWindow, outs: Mapping[str, NDArray[Any]]) -> None:
        """Fill the pixels of a window of each map into its C-contiguous array."""

    def __repr__(self) -> str:
        main, *others = self.maps
        shown = f"{main} ({self.dtype}, {many(self.channels, 'channel')})"
        return describe(self, shown, *others, str(self.domain))

    @property
    def main(self) -> str:
        """Name of the main map."""
        return next(iter(self.maps))

    @property
    def dtype(self) -> np.dtype[Any]:
        """Type of the main map's numbers."""
        return self.maps[self.main].dtype

    @property
    def channels(self) -> int:
        """Channels of the main map."""
        return self.maps[self.main].channels

    def __getitem__(self, key: Any) -> NDArray[Any]:
        """Give the pixels of ``field[y, x]``, where y and x are numbers or ranges with both ends.

        Returns
        -------
        array, shape (height, width, channels), less the axes that are numbers
            Pixels of the main map; a step takes every nth.
        """
        window, taken = indexed_window(self.domain, key)
        pixels: NDArray[Any] = self.render(*window)[taken]
        return pixels

    __iter__ = None  # an endless plane is not gone through

    def at(
        self,
        points: ArrayLike,
        *,
        map: str | None = None,
        footprint: float = 1.0,
        origin: tuple[int, int] = (0, 0),
    ) -> NDArray[Any]:
        """Give what is seen at scattered places, between pixels and from afar.

        Parameters
        ----------
        points : array-like of shape (..., 2)
            Places in pixels, x first; pixel (0, 0) has its center at (0.5, 0.5).
        map : str, optional
            Which map; by default the main one.
        footprint : float, optional
            Pixels along the square that a place stands for, 0 to 1,024; default 1. From 1.5 on, the plane is
            reduced as in the mip level nearest to it, colors as light and normals as vectors.
        origin : (int, int), optional
            Whole pixels, of any size, that are added to all places; default (0, 0). For places so far out
            that a float has no fractions there.

        Returns
        -------
        array, shape (..., channels)
            For each place the value between the centers of four pixels, of the map's type.

        Raises
        ------
        TilewrightTypeError
            Something else than numbers.
        TilewrightValueError
            A place outside the domain, another shape, an unknown map, or a footprint larger than the plane.
        """
        name = self._name(map)
        view = FarView.of(self.domain, origin, points)
        found = sample_pixels(
            lambda x, y, width, height: self._render(self._window(*view.place(x, y), width, height), name),
            view.domain,
            self.maps[name].kind,
            view.points,
            footprint,
        )
        return found.reshape(*view.shape, found.shape[-1])

    def render(
        self,
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        map: str | None = None,
        scale: float = 1.0,
        out: NDArray[Any] | None = None,
    ) -> NDArray[Any]:
        """Give the pixels of a window, equal to the same pixels of any other window.

        Parameters
        ----------
        x, y : int, optional
            North-west pixel of the window; default (0, 0).
        width, height : int, optional
            Size of the window in pixels, 1 to 2^31 - 1; default 1024 each.
        map : str, optional
            Which map; by default the main one.
        scale : float, optional
            Pixels of the picture for each of the window, 1/1,024 to 64; default 1. Other pictures are
            ``round(scale * width)`` wide, and read as by `at` with a footprint of ``1 / scale``.
        out : array, shape (height, width, channels) of the map's type, optional
            C-contiguous; filled and returned. By default a new array is made.

        Returns
        -------
        array, shape (height, width, channels)
            Pixels ``[y, x]`` of the map's type, row 0 in the north.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer, or an ``out`` that is no array.
        TilewrightValueError
            A window outside the domain or larger than memory, an unknown map, or an ``out`` that does not
            fit.
        """
        name = self._name(map)
        window = self._window(x, y, width, height)
        picture = PixelWindow(0, 0, *scaled_sides(window.width, window.height, scale))
        if out is None:
            out = self._make_out(picture, name)
        else:
            shape, kind = self._shape(picture, name), self.maps[name].dtype
            check_out(out, lambda given: (given.shape, given.dtype) == (shape, kind), f"{kind} {shape}")
        if scale != 1:
            return scaled_pixels(self._reader(window, name, scale), scale, picture, out)
        self._paint(window, {name: out})
        return out

    def _reader(self, window: PixelWindow, name: str, scale: float) -> Any:
        """Reads places of a window, for a picture of it at some scale."""
        return partial(self.at, map=name, footprint=1 / scale, origin=window[:2])

    def render_maps(
        self,
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        maps: Sequence[str] | None = None,
    ) -> dict[str, NDArray[Any]]:
        """Give several maps of a window, which share the work where they can; each as `render` gives it.

        Parameters
        ----------
        x, y : int, optional
            North-west pixel of the window; default (0, 0).
        width, height : int, optional
            Size of the window in pixels, 1 to 2^31 - 1; default 1024 each.
        maps : sequence of str, optional
            Which maps; by default all that a material is made of.

        Returns
        -------
        dict of str to array, shape (height, width, channels)
            The pixels of each map, of its own type.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer.
        TilewrightValueError
            A window outside the domain or larger than memory, or an unknown map.
        """
        known = self.maps
        chosen = self._usual if maps is None else [check_choice("maps", n, tuple(known)) for n in maps]
        window = self._window(x, y, width, height)
        outs = {name: self._make_out(window, name) for name in chosen}
        self._paint(window, outs)
        return outs

    def blocks(
        self,
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        map: str | None = None,
        size: tuple[int, int] | None = None,
    ) -> Iterator[tuple[int, int, NDArray[Any]]]:
        """Give the pixels of a window in pieces, for windows larger than memory.

        Parameters
        ----------
        x, y : int, optional
            North-west pixel of the window; default (0, 0).
        width, height : int, optional
            Size of the window in pixels, 1 to 2^31 - 1; default 1024 each.
        map : str, optional
            Which map; by default the main one.
        size : (int, int), optional
            Width and height of a piece in pixels; by default bands of about 16 MB. The last piece of a row
            or column may be smaller.

        Returns
        -------
        iterator of (int, int, array)
            For each piece its north-west pixel, x and y, and its pixels, shape (height, width, channels).

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer, or a size that is no pair.
        TilewrightValueError
            A window outside the domain, an unknown map, or a size below 1.
        """
        name = self._name(map)
        window = self._window(x, y, width, height)
        pieces = window.split(*(self._band(window, name) if size is None else check_pair("size", size)))
        # Checked now, and not when the first piece is asked for.
        return ((piece.x, piece.y, self._render(piece, name)) for piece, _ in pieces)

    def save(
        self,
        path: AnyPath,
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        map: str | None = None,
        scale: float = 1.0,
        progress: Progress | None = None,
    ) -> None:
        """Render a window to a file, a block at a time, in memory that does not grow with the window.

        The file appears when it is complete.

        Parameters
        ----------
        path : str or path-like
            ``.tif``, which becomes a tiled BigTIFF; ``.png`` for 8 and 16 bit; ``.exr``, which holds floats,
            of colors their linear light; ``.jpg`` and ``.webp`` for looking at.
        x, y : int, optional
            North-west pixel of the window; default (0, 0).
        width, height : int, optional
            Size of the window in pixels, 1 to 2^31 - 1; default 1024 each.
        map : str, optional
            Which map; by default the main one.
        scale : float, optional
            Pixels of the picture for each of the window, as for `render`; default 1.
        progress : callable, optional
            Called as ``progress(done, total, what)``, counted in rows of pixels; raise `Cancelled` in it to
            stop.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer, something else than a path, or pixels of a type that files of
            this suffix do not hold.
        TilewrightValueError
            A window outside the domain, an unknown map, or another suffix.
        TilewrightFileError
            The file cannot be written.
        """
        name = self._pictured(self._name(map))
        file = as_path(path)
        form = self.maps[name]
        picture_form(file, form.dtype, form.channels, form.kind)
        check_progress(progress)
        window = self._window(x, y, width, height)
        across, down = scaled_sides(width, height, scale)

        def block(left: int, top: int, columns: int, rows: int) -> NDArray[Any]:
            if progress is not None:
                progress(top, down, f"rendering {file.name}")
            if scale != 1:
                out = self._make_out(PixelWindow(0, 0, columns, rows), name)
                part = (left, top, columns, rows)
                return scaled_pixels(self._reader(window, name, scale), scale, part, out)
            return self._render(PixelWindow(window.x + left, window.y + top, columns, rows), name)

        stream_image(file, block, down, across, form.channels, form.dtype, form.kind)
        if progress is not None:
            progress(down, down, f"rendering {file.name}")

    @property
    def _usual(self) -> list[str]:
        """The maps that `render_maps` gives when none are named."""
        return list(self.maps)

    def _pictured(self, map: str) -> str:
        """The map that a picture file shows for ``map``: another one where no file holds its numbers."""
        return map

    def _render(self, window: PixelWindow, name: str) -> NDArray[Any]:
        """One map of a window that has been checked."""
        out = self._make_out(window, name)
        self._paint(window, {name: out})
        return out

    def _name(self, map: str | None) -> str:
        return self.main if map is None else check_choice("map", map, tuple(self.maps))

    def _window(self, x: Any, y: Any, width: Any, height: Any) -> PixelWindow:
        return check_pixel_window(self.domain, self.reach, x, y, width, height)

    def _shape(self, window: PixelWindow, name: str) -> tuple[int, int, int]:
        return window.height, window.width, self.maps[name].channels

    def _make_out(self, window: PixelWindow, name: str) -> NDArray[Any]:
        try:
            return np.empty(self._shape(window, name), self.maps[name].dtype)
        except (MemoryError, ValueError):
            raise TilewrightValueError(
                f"a window of {window.width} x {window.height} pixels does not fit in memory",
                advice="render smaller ones, go through its blocks(), or save() it to a file",
            ) from None

    def _band(self, window: PixelWindow, name: str) -> tuple[int, int]:
        """Width and height of pieces of a window that hold about 16 MB."""
        pixels = max(1, _BLOCK_BYTES // (self.maps[name].channels * self.maps[name].dtype.itemsize))
        columns = min(window.width, pixels)
        return columns, max(1, pixels // columns)
