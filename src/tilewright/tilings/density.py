"""Tilings steered by a map: where corners are marked follows a picture or a function."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_choice, check_real
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.pixels import mean_gray, white
from tilewright.tiles import CORNER, CORNER_CODED, TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.algorithms import Lattice, Slots, corner_slots, evaluate
from tilewright.tilings.direct_tiling import SlotTiling, recognize
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, as_grid, make_hash

Density = Callable[[NDArray[np.float64], NDArray[np.float64]], ArrayLike]
_DENSITY = 8
"""Stream of the hash that is compared with the density."""


class DensityTiling(SlotTiling):
    """A tiling whose marked corners follow a density; made by `density_tiling`."""

    def __init__(self, tiles: TileSet, hash: LatticeHash, algorithm: str, density: Density) -> None:
        super().__init__(tiles, Domain.plane(None))
        self.hash = hash
        self.algorithm = algorithm
        self.density = density

    def slots(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
        """The slots of a window, with corner colors drawn from the marked or the unmarked half."""
        at = Lattice(self.tiles, self.hash, self.domain.periods, start, extent)
        columns, rows = at.points(0), at.points(1)
        marked = self.hash.numbers(_DENSITY, *as_grid((columns, rows))) < self.marks(columns, rows) * 2.0**24
        colors = self.tiles.colors[-1]
        plain = (colors + 1) // 2
        low = self.hash.grid(plain, 0, columns, rows)
        high = plain + self.hash.grid(colors - plain, 1, columns, rows)
        corners = corner_slots(np.where(marked, high, low).astype(np.uint8))
        if self.tiles.shape is CORNER:
            return corners
        return evaluate(self.algorithm.removeprefix("marked-"), at) + corners

    def marks(self, columns: NDArray[np.int64], rows: NDArray[np.int64]) -> NDArray[np.float64]:
        """The density at the lattice points of a grid, checked, shape (len(rows), len(columns))."""
        x, y = np.meshgrid(columns.astype(float), rows.astype(float))
        given = self.density(x, y)
        try:
            found = np.asarray(given)
            if found.dtype.kind not in "buif":
                raise TypeError(f"it gave {found.dtype}")
            values = np.broadcast_to(found.astype(float), x.shape)
        except (TypeError, ValueError) as error:
            raise TilewrightValueError(
                f"the density function did not give one number for each point of {x.shape}: {error}"
            ) from None
        if not ((values >= 0) & (values <= 1)).all():
            raise TilewrightValueError("the density function gave values outside 0 to 1 (or NaN)")
        return values


def density_tiling(
    tiles: TileSet,
    density: Density | ArrayLike,
    seed: int = 0,
    *,
    cells_per_pixel: float = 1.0,
    outside: str = "clamp",
    hash: LatticeHash | str = "mixer",
) -> DensityTiling:
    """An endless tiling whose corners are marked with the probability a map gives.

    The upper half of the corner colors are the marked ones, as in two-source texture tiles (Cohen et al.
    2003, section 3.5). Marks are fixed by the map, so every combination of them must be in the set.

    Parameters
    ----------
    tiles : TileSet
        A complete corner set over 2 colors or more, or a corner-coded set with all 16 marks (128 tiles over
        Cohen's 8).
    density : function or 2D array
        ``f(x, y)`` of lattice points (arrays of float) that returns the probability, 0 to 1; or a gray map,
        shape (h, w) or (h, w, channels), whose colors are averaged and alpha ignored: floats 0 to 1, or
        integers of their type's range. Pixel (0, 0) of a map covers the cells from (0, 0).
    seed : int
    cells_per_pixel : float
        Size of a map's pixels in cells; values between pixel centers are interpolated.
    outside : str
        ``"clamp"`` repeats the map's border, ``"repeat"`` the map.
    """
    algorithm = recognize(check_tiles("tiles", tiles))
    if not (
        (tiles.shape is CORNER and algorithm == "corners" and tiles.colors[0] > 1)
        or (tiles.shape is CORNER_CODED and algorithm is not None)
    ):
        raise TilewrightValueError(
            "a density needs a complete corner set or a corner-coded set with all marks; "
            f"the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles is neither"
        )
    if not callable(density):
        check_choice("outside", outside, ("clamp", "repeat"))
        size = check_real("cells_per_pixel", cells_per_pixel, 1e-6, 1e9)
        density = _interpolate(_as_gray(density), size, outside)
    return DensityTiling(tiles, make_hash(hash, seed), algorithm or "", density)


def _as_gray(given: ArrayLike) -> NDArray[np.float64]:
    try:
        map_ = np.asarray(given)
    except ValueError:
        raise TilewrightValueError("the density map is not a table of equally long rows") from None
    if map_.ndim == 2:
        map_ = map_[..., np.newaxis]
    if map_.ndim != 3 or not 1 <= map_.shape[2] <= 4 or map_.size == 0:
        raise TilewrightValueError(
            f"the density map has shape {np.shape(given)}; expected (height, width) or "
            "(height, width, channels) with 1 to 4 channels"
        )
    if map_.dtype.kind not in "ubf":
        raise TilewrightTypeError(
            f"the density map has type {map_.dtype}; allowed are floats, bool and unsigned integers"
        )
    values = mean_gray(map_) / white(map_.dtype)
    if not ((values >= 0) & (values <= 1)).all():
        raise TilewrightValueError("the density map has values outside 0 to 1 (or NaN)")
    return values


def _interpolate(gray: NDArray[np.float64], size: float, outside: str) -> Density:
    def density(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[Any]:
        column, row = x / size - 0.5, y / size - 0.5
        left, top = np.floor(column).astype(np.int64), np.floor(row).astype(np.int64)
        dx, dy = column - left, row - top

        def at(i: NDArray[np.int64], j: NDArray[np.int64]) -> NDArray[np.float64]:
            h, w = gray.shape
            if outside == "repeat":
                return gray[i % h, j % w]
            return gray[i.clip(0, h - 1), j.clip(0, w - 1)]

        upper = at(top, left) * (1 - dx) + at(top, left + 1) * dx
        lower = at(top + 1, left) * (1 - dx) + at(top + 1, left + 1) * dx
        return upper * (1 - dy) + lower * dy

    return density
