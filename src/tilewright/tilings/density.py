"""Tilings steered by a map: where corners are marked follows a picture or a function."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_array, check_choice, check_function_of_place, check_real, shape_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.pixels import as_pixels, mean_gray, white
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.algorithms import Algorithm, Lattice, Slots, corner_slots, recognize
from tilewright.tilings.direct_tiling import SlotTiling
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, as_grid
from tilewright.tilings.streams import COLORS, DENSITY, SECOND
from tilewright.tilings.table_hashes import make_hash

Density = Callable[[NDArray[np.float64], NDArray[np.float64]], ArrayLike]
"""``density(x, y)``: for two arrays of one shape the shares there, 0 to 1, in an array of that shape."""


class DensityTiling(SlotTiling):
    """A tiling whose marked corners follow a density; made by `density_tiling`.

    Parameters
    ----------
    tiles : TileSet
        The tiles.
    hash : LatticeHash
        Where chance comes from.
    algorithm : str
        The algorithm that goes with the tiles.
    density : callable
        ``f(x, y)`` of arrays of lattice points, the probability of a mark, 0 to 1.
    """

    def __init__(self, tiles: TileSet, hash: LatticeHash, algorithm: Algorithm, density: Density) -> None:
        super().__init__(tiles, Domain.plane(None))
        self.hash = hash
        self.algorithm = algorithm
        self.density = density

    def slots(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
        """Give the colors of every slot of a window; corners draw from the marked or the unmarked half."""
        at = Lattice(self.tiles, self.hash, self.domain.periods, start, extent)
        columns, rows = at.points(0), at.points(1)
        marked = self.hash.numbers(DENSITY, *as_grid((columns, rows))) < self.marks(columns, rows) * 2.0**24
        colors = self.tiles.colors[-1]
        plain = (colors + 1) // 2
        low = self.hash.grid(plain, COLORS, columns, rows)
        high = plain + self.hash.grid(colors - plain, SECOND, columns, rows)
        corners = corner_slots(np.where(marked, high, low).astype(np.uint8))
        base = self.algorithm.base
        return corners if base is None else base.slots(at) + corners

    def marks(self, columns: NDArray[np.int64], rows: NDArray[np.int64]) -> NDArray[np.float64]:
        """Evaluate the density at the lattice points of a grid.

        Parameters
        ----------
        columns : int64 array, shape (w,)
            x of the points.
        rows : int64 array, shape (h,)
            y of the points.

        Returns
        -------
        float64 array, shape (h, w)
            Probabilities of a mark, 0 to 1.

        Raises
        ------
        TilewrightTypeError, TilewrightValueError
            The function did not give one number from 0 to 1 for each point.
        """
        x, y = np.meshgrid(columns.astype(float), rows.astype(float))
        return evaluate_density(self.density, x, y)


def evaluate_density(density: Density, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    """Ask a density for its shares at places, and check the answer.

    Parameters
    ----------
    density : callable
        ``density(x, y)``, which answers a share for each place, or one for all.
    x : float64 array
        x of the places.
    y : float64 array, of the shape of x
        y of the places.

    Returns
    -------
    float64 array, of the shape of x
        Shares, 0 to 1.

    Raises
    ------
    TilewrightTypeError
        The answer does not hold numbers.
    TilewrightValueError
        The answer has another shape or values outside 0 to 1, or the function writes into its arrays.
    """
    x, y = _read_only(x), _read_only(y)
    try:
        found = np.asarray(density(x, y))
    except ValueError as error:
        if "read-only" in str(error):
            raise TilewrightValueError(
                "writes into the arrays it is given", argument="the density function"
            ) from None
        raise
    if found.dtype.kind not in "buif":
        raise TilewrightTypeError(
            f"answered {found.dtype}; expected numbers",
            argument="the density function",
            value=found.dtype,
            allowed="numbers",
        )
    if found.shape not in (x.shape, ()):
        raise TilewrightValueError(
            f"answered shape {found.shape} for places of shape {x.shape}; expected one number for each",
            argument="the density function",
            value=found.shape,
            allowed=f"{x.shape} or one number",
        )
    shares = np.broadcast_to(found.astype(np.float64), x.shape)
    bad = ~((shares >= 0) & (shares <= 1))
    if bad.any():
        at = np.unravel_index(int(np.argmax(bad)), bad.shape)
        raise TilewrightValueError(
            f"is {shares[at]} at x={x[at]}, y={y[at]}; shares are 0 to 1",
            argument="the density function",
            value=float(shares[at]),
            allowed="0 to 1",
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
    """Make an endless tiling whose corners are marked with the probability a map gives.

    The upper half of the corner colors are the marked ones, as in texture tiles of two sources. Marks are
    fixed by the map, so every combination of them must be in the set.

    Parameters
    ----------
    tiles : TileSet
        A complete corner set over 2 colors or more, or a corner-coded set with all 16 marks (128 tiles over
        Cohen's 8).
    density : callable, array-like of shape (h, w) or (h, w, channels), or Pillow image
        ``density(x, y)`` of lattice points, two float64 arrays of one shape, that answers the probability of
        each, 0 to 1, in an array of that shape. Or a gray map, whose colors are averaged and alpha ignored:
        floats 0 to 1, or integers of their type's range. Pixel (0, 0) of a map covers the cells from (0, 0).
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.
    cells_per_pixel : float, optional
        Size of a map's pixels in cells, 1e-6 to 1e9; default 1. Values between pixel centers are
        interpolated.
    outside : str, optional
        ``"clamp"``, the default, repeats the map's border, ``"repeat"`` the map.
    hash : str or LatticeHash, optional
        As of `direct`; default ``"mixer"``.

    Returns
    -------
    DensityTiling
        A tiling of the plane.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The set is neither of these, the map holds values outside its range, or a number is out of range.

    Notes
    -----
    Cohen et al. 2003, section 3.5.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiling = tw.density_tiling(tw.corner_tiles(2), lambda x, y: x > 0, seed=1)
    >>> tiling.indices(-2, 0, 4, 1)
    array([[ 0,  0, 12, 15]], dtype=int32)
    """
    algorithm = recognize(check_tiles("tiles", tiles))
    has_corners = tiles.family == "corner" and tiles.colors[0] > 1
    if algorithm is None or not (has_corners or algorithm.base):
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
    return DensityTiling(tiles, make_hash(hash, seed), algorithm, density)


def _as_gray(given: ArrayLike) -> NDArray[np.float64]:
    map_ = as_array("the density map", as_pixels("density", given))
    if map_.ndim == 2:
        map_ = map_[..., np.newaxis]
    if map_.ndim != 3 or not 1 <= map_.shape[2] <= 4 or map_.size == 0:
        raise shape_error(
            "the density map",
            np.shape(given),
            "(height, width) or (height, width, channels) with 1 to 4 channels",
        )
    if map_.dtype.kind not in "ubf":
        allowed = "floats, bool and unsigned integers"
        raise TilewrightTypeError(
            f"has type {map_.dtype}; allowed are {allowed}",
            argument="the density map",
            value=map_.dtype,
            allowed=allowed,
        )
    values = mean_gray(map_) / white(map_.dtype)
    if not ((values >= 0) & (values <= 1)).all():
        raise TilewrightValueError("has values outside 0 to 1 (or NaN)", argument="the density map")
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
