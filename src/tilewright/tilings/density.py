"""Tilings steered by a map: where corners are marked follows a picture or a function."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_choice, check_function_of_place, check_real
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.pixels import as_pixels, mean_gray, white
from tilewright.tiles import CORNER, CORNER_CODED, TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.algorithms import Lattice, Slots, corner_slots, evaluate
from tilewright.tilings.direct_tiling import SlotTiling, recognize
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, as_grid, make_hash

Density = Callable[[NDArray[np.float64], NDArray[np.float64]], ArrayLike]
"""``density(x, y)``: for two arrays of one shape the shares there, 0 to 1, in an array of that shape."""
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
        return evaluate_density(self.density, x, y)


def evaluate_density(density: Density, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    """What a density says of places, if it says a share for each, or one for all; the shape of ``x``."""
    x, y = _read_only(x), _read_only(y)
    try:
        found = np.asarray(density(x, y))
    except ValueError as error:
        if "read-only" in str(error):
            raise TilewrightValueError("the density function writes into the arrays it is given") from None
        raise
    if found.dtype.kind not in "buif":
        raise TilewrightTypeError(f"the density function answered {found.dtype}; expected numbers")
    if found.shape not in (x.shape, ()):
        raise TilewrightValueError(
            f"the density function answered shape {found.shape} for places of shape {x.shape}; expected one "
            "number for each"
        )
    shares = np.broadcast_to(found.astype(np.float64), x.shape)
    bad = ~((shares >= 0) & (shares <= 1))
    if bad.any():
        at = np.unravel_index(int(np.argmax(bad)), bad.shape)
        raise TilewrightValueError(
            f"the density function is {shares[at]} at x={x[at]}, y={y[at]}; shares are 0 to 1"
        )
    return shares


def _read_only(given: NDArray[np.float64]) -> NDArray[np.float64]:
    shown = given.view()
    shown.setflags(write=False)
    return shown


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
        ``density(x, y)`` of lattice points, two float64 arrays of one shape, that answers the probability
        of each, 0 to 1, in an array of that shape; or a gray map, an array of shape (h, w) or
        (h, w, channels) or a Pillow image, whose colors are averaged and alpha ignored: floats 0 to 1, or
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
    if callable(density):
        check_function_of_place("density", density)
    else:
        check_choice("outside", outside, ("clamp", "repeat"))
        size = check_real("cells_per_pixel", cells_per_pixel, 1e-6, 1e9)
        density = _Interpolation(_as_gray(density), size, outside)
    return DensityTiling(tiles, make_hash(hash, seed), algorithm or "", density)


def _as_gray(given: ArrayLike) -> NDArray[np.float64]:
    try:
        map_ = np.asarray(as_pixels("density", given))
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


@dataclass(frozen=True, eq=False)
class _Interpolation:
    """A gray map as a density: between the centers of pixels of ``size`` cells values are interpolated."""

    gray: NDArray[np.float64]
    size: float
    outside: str

    def __call__(self, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
        column, row = x / self.size - 0.5, y / self.size - 0.5
        left, top = np.floor(column).astype(np.int64), np.floor(row).astype(np.int64)
        dx, dy = column - left, row - top
        upper = self._at(top, left) * (1 - dx) + self._at(top, left + 1) * dx
        lower = self._at(top + 1, left) * (1 - dx) + self._at(top + 1, left + 1) * dx
        return np.asarray(upper * (1 - dy) + lower * dy)

    def _at(self, i: NDArray[np.int64], j: NDArray[np.int64]) -> NDArray[np.float64]:
        h, w = self.gray.shape
        if self.outside == "repeat":
            return self.gray[i % h, j % w]
        return self.gray[i.clip(0, h - 1), j.clip(0, w - 1)]
