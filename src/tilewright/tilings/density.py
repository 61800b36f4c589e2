"""Tilings steered by a map: where corners are marked follows a picture or a function."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_array, check_choice, check_real, shape_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.algorithms import Algorithm, Lattice, Slots, corner_slots, recognize
from tilewright.tilings.direct_tiling import SlotTiling
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, as_grid
from tilewright.tilings.streams import COLORS, DENSITY, SECOND
from tilewright.tilings.table_hashes import make_hash

Density = Callable[[NDArray[np.float64], NDArray[np.float64]], ArrayLike]


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
        TilewrightValueError
            The function did not give one number from 0 to 1 for each point.
        """
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
    """Make an endless tiling whose corners are marked with the probability a map gives.

    The upper half of the corner colors are the marked ones, as in texture tiles of two sources. Marks are
    fixed by the map, so every combination of them must be in the set.

    Parameters
    ----------
    tiles : TileSet
        A complete corner set over 2 colors or more, or a corner-coded set with all 16 marks (128 tiles over
        Cohen's 8).
    density : callable or array-like, shape (h, w) or (h, w, channels)
        ``f(x, y)`` of lattice points (arrays of float) that returns the probability, 0 to 1. Or a gray map,
        whose colors are averaged and alpha ignored: floats 0 to 1, or integers of their type's range. Pixel
        (0, 0) of a map covers the cells from (0, 0).
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
    if not callable(density):
        check_choice("outside", outside, ("clamp", "repeat"))
        size = check_real("cells_per_pixel", cells_per_pixel, 1e-6, 1e9)
        density = _interpolate(_as_gray(density), size, outside)
    return DensityTiling(tiles, make_hash(hash, seed), algorithm, density)


def _as_gray(given: ArrayLike) -> NDArray[np.float64]:
    map_ = as_array("the density map", given)
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
    # Gray is the mean of the colors; alpha (the last of 2 or 4 channels) says nothing.
    colors = map_[..., : 1 if map_.shape[2] < 3 else 3]
    values = colors.mean(axis=2, dtype=np.float64)
    if map_.dtype.kind == "u":
        return values / np.iinfo(map_.dtype).max
    if not ((values >= 0) & (values <= 1)).all():
        raise TilewrightValueError("has values outside 0 to 1 (or NaN)", argument="the density map")
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
