"""Points over a tiling: those of any window of an endless plane, each with an identity that stays."""

from collections.abc import Iterator
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.fields.points.laying import LaidPoints, check_share
from tilewright.fields.points.nearest import NearestSearch
from tilewright.fields.points.thinning import Density, draw_lowest
from tilewright.fields.points.window import MOST_POINTS, PointWindow, View, Window
from tilewright.samplers.box import Box, as_points
from tilewright.samplers.point_set import PointSet
from tilewright.showing import Shown, describe
from tilewright.tilings.domain import LARGEST_CELL


class PointField(Shown, LaidPoints):
    """Point tiles laid by a tiling: an endless plane of points.

    Parameters
    ----------
    tiles : PointTiles
        The points of each tile.
    tiling : Tiling
        A tiling of the same tile set.

    Attributes
    ----------
    tiles : PointTiles
        The points of each tile.
    tiling : Tiling
        Which tile goes where.

    Raises
    ------
    TilewrightTypeError
        Something else than point tiles and a tiling.
    TilewrightValueError
        The tiling lays another tile set.

    Notes
    -----
    Lengths are in tiles: cell (x, y) covers [x, x + 1) x [y, y + 1); x grows east and y grows south. Cells
    reach to +-2^61. Windows are half open, so that those side by side share no point. Variants of tiles are
    drawn as `Tiling.placements` tells.

    Examples
    --------
    >>> import tilewright as tw
    >>> blue = tw.ready_tiles()
    >>> field = tw.PointField(blue, tw.direct(blue.tiles, seed=7))
    >>> field.points(x=0, y=0, width=10, height=10).shape
    (3200, 2)
    >>> field.points(0, 0, 1, 1, density=0.1).shape
    (3, 2)
    >>> field.sample(1000).shape
    (1000, 2)
    """

    def __repr__(self) -> str:
        return describe(self, repr(self.tiles), repr(self.tiling))

    def points(
        self,
        x: float = 0,
        y: float = 0,
        width: float = 10,
        height: float = 10,
        *,
        density: Density = 1.0,
        local: bool = False,
        out: NDArray[Any] | None = None,
    ) -> NDArray[Any]:
        """Give the points of a window, equal to those of any other window that holds them.

        Parameters
        ----------
        x, y : float or int, optional
            North-west corner of the window, in tiles; default 0.
        width, height : float, optional
            Size of the window, in tiles; default 10.
        density : float or callable, optional
            The share of the points to keep, 0 to 1, the first of them by rank; default 1. A function
            ``density(x, y)`` gets two float64 arrays of shape (n,), the points as they are asked for, and
            answers the share of each.
        local : bool, optional
            Measure from the window's corner instead of from the origin, which keeps far windows exact;
            default False.
        out : float32 or float64 array, shape (at least as many as come, 2), C-contiguous, optional
            An array to be written to from the first row on; by default a new one is made.

        Returns
        -------
        float64 array, shape (n, 2)
            Points, x first, row by row of cells and by rank within a cell; or the part of ``out`` that was
            written.

        Raises
        ------
        TilewrightTypeError
            An argument of another type.
        TilewrightValueError
            A window that is empty, too large to hold, or so far out that its points would run together in
            the precision of the result; too small an ``out``.
        """
        view = self._view(Window.of(x, y, width, height))
        return self._lay(view, density, local, out)[0]

    def window(
        self,
        x: float = 0,
        y: float = 0,
        width: float = 10,
        height: float = 10,
        *,
        density: Density = 1.0,
        local: bool = False,
    ) -> PointWindow:
        """Give the points of a window with cells, numbers in the tile, ranks and ids.

        Parameters
        ----------
        x, y : float or int, optional
            North-west corner of the window, in tiles; default 0.
        width, height : float, optional
            Size of the window, in tiles; default 10.
        density : float or callable, optional
            The share of the points to keep, as in `PointField.points`; default 1.
        local : bool, optional
            Measure from the window's corner instead of from the origin; default False.

        Returns
        -------
        PointWindow
            The points in the order of `PointField.points`, and who they are.

        Raises
        ------
        TilewrightTypeError, TilewrightValueError
            As `PointField.points` raises them.
        """
        view = self._view(Window.of(x, y, width, height))
        points, names = self._lay(view, density, local, None, named=True)
        ranks = self._ranks_of(view, names)
        cells = names[:, 1::-1] + np.array([view.window.column, view.window.row], np.int64)
        return PointWindow(points, cells, names[:, 2], ranks, self._bits)

    def count(
        self,
        x: float = 0,
        y: float = 0,
        width: float = 10,
        height: float = 10,
        *,
        density: float = 1.0,
    ) -> int:
        """Count the points of a window without making them.

        Parameters
        ----------
        x, y : float or int, optional
            North-west corner of the window, in tiles; default 0.
        width, height : float, optional
            Size of the window, in tiles; default 10.
        density : float, optional
            The share of the points to keep, 0 to 1; default 1.

        Returns
        -------
        int
            Number of points that `PointField.points` gives for the same window and share.

        Raises
        ------
        TilewrightTypeError, TilewrightValueError
            As `PointField.points` raises them.
        """
        rank = check_share(density)
        return int(self._counts(self._view(Window.of(x, y, width, height)), rank).sum())

    def sample(
        self,
        count: int,
        x: float = 0,
        y: float = 0,
        width: float | None = None,
        height: float | None = None,
        *,
        local: bool = False,
    ) -> NDArray[np.float64]:
        """Give exactly ``count`` points of a window: those of lowest rank, and of equal rank some by chance.

        Parameters
        ----------
        count : int
            Number of points, 1 to 2^31.
        x, y : float or int, optional
            North-west corner of the window, in tiles; default 0.
        width, height : float, optional
            Size of the window, in tiles; by default the smallest square of whole tiles that holds enough
            points.
        local : bool, optional
            Measure from the window's corner instead of from the origin; default False.

        Returns
        -------
        float64 array, shape (count, 2)
            Points, x first, in tiles.

        Raises
        ------
        TilewrightTypeError
            A number of another type, or a width without a height.
        TilewrightValueError
            The window holds fewer points, or cannot be used as `PointField.points` tells.
        """
        n = check_int("count", count, 1, MOST_POINTS, "sample_blocks() gives larger sets a piece at a time")
        if (width is None) != (height is None):
            raise TilewrightTypeError(
                "width and height go together", advice="leave out both for the smallest square"
            )
        if width is None or height is None:
            width = height = self.side_for(n, x, y)
        window = Window.of(x, y, width, height)
        if window.is_whole:
            return np.concatenate(list(self._lay_quotas(self._view(window), n, local)))
        found = self.window(x, y, width, height, local=local)
        kept = draw_lowest(found, n)
        return found.points[kept]

    def sample_blocks(
        self, count: int, x: int = 0, y: int = 0, side: int | None = None, *, local: bool = False
    ) -> Iterator[NDArray[np.float64]]:
        """Give the points of `PointField.sample` for a square of whole tiles, in pieces of some million.

        Parameters
        ----------
        count : int
            Number of points, 1 to 2^40.
        x, y : int, optional
            North-west cell of the square, within +-2^61; default 0.
        side : int, optional
            Side of the square in tiles, 1 to 2^31; by default the smallest that holds enough points.
        local : bool, optional
            Measure from the square's corner instead of from the origin; default False.

        Yields
        ------
        float64 array, shape (n, 2)
            The next points, x first, in tiles.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer.
        TilewrightValueError
            The square holds fewer points, or does not lie in the tiling.
        """
        n = check_int("count", count, 1, 2**40)
        left, top = (check_int(a, v, -LARGEST_CELL, LARGEST_CELL) for a, v in (("x", x), ("y", y)))
        along = self.side_for(n, left, top) if side is None else check_int("side", side, 1, MOST_POINTS)
        view = View.of(self.rows_at, 1.0, Window.of(left, top, along, along))
        yield from self._lay_quotas(view, n, local)

    def side_for(self, count: int, x: float = 0, y: float = 0) -> int:
        """Find the smallest square of whole tiles that holds a number of points.

        Parameters
        ----------
        count : int
            Number of points, 1 to 2^40.
        x, y : float or int, optional
            North-west corner of the square, in tiles; default 0.

        Returns
        -------
        int
            Side of the square in tiles.

        Raises
        ------
        TilewrightTypeError
            A count that is not an integer.
        TilewrightValueError
            The tiles hold no points, or the count is out of range.
        """
        n = check_int("count", count, 1, 2**40)
        if self.tiles.density == 0:
            raise TilewrightValueError("the tiles hold no points")
        side = max(1, ceil((n / self.tiles.density) ** 0.5))
        if self._same and Window.of(x, y, 1, 1).is_whole:
            return side
        while side > 1 and self.count(x, y, side - 1, side - 1) >= n:
            side -= 1
        while self.count(x, y, side, side) < n:
            side += 1
        return side

    def blocks(
        self,
        x: float = 0,
        y: float = 0,
        width: float = 10,
        height: float = 10,
        *,
        density: Density = 1.0,
        local: bool = False,
    ) -> Iterator[NDArray[np.float64]]:
        """Give the points of a window in pieces of some million, for sets larger than memory.

        The pieces together hold the same points as `PointField.points`; they are bands of whole rows of
        cells, or parts of bands where these are long.

        Parameters
        ----------
        x, y : float or int, optional
            North-west corner of the window, in tiles; default 0.
        width, height : float, optional
            Size of the window, in tiles, as large as one likes; default 10.
        density : float or callable, optional
            The share of the points to keep, as in `PointField.points`; default 1.
        local : bool, optional
            Measure from the corner of the whole window instead of from the origin; default False.

        Yields
        ------
        float64 array, shape (n, 2)
            The next points, x first, in tiles.

        Raises
        ------
        TilewrightTypeError, TilewrightValueError
            As `PointField.points` raises them.
        """
        most = max(1, int(self._block_points / max(self.tiles.density, 1e-9)))
        for piece in Window.of(x, y, width, height).pieces(most):
            yield self._lay(self._view(piece), density, local, None)[0]

    def nearest(self, positions: ArrayLike) -> tuple[NDArray[np.float64], PointWindow]:
        """Find the nearest point of the field to each position (Lagae 2007, section 7.6.2).

        Parameters
        ----------
        positions : array-like of float, shape (n, 2)
            Where to look from, x first, in tiles.

        Returns
        -------
        distances : float64 array, shape (n,)
            Distances to the nearest points, in tiles.
        found : PointWindow
            One point for each position.

        Raises
        ------
        TilewrightTypeError
            Something else than pairs of numbers.
        TilewrightValueError
            No point lies within 16 tiles of a position.
        """
        given = as_points(positions)
        search = NearestSearch(self.tiles, self.rows_at)
        distances, cells, numbers = search.find(given)
        rows = search.rows_of(cells)
        at = self.tiles.starts[rows] + numbers
        points = cells + self.tiles.points[at].astype(np.float64)
        return distances, PointWindow(points, cells, numbers, self.tiles.ranks[at], self._bits)

    def torus(self) -> PointSet:
        """Give all points of a tiling that goes around, see ``period`` of `direct`.

        Returns
        -------
        PointSet
            The points in tiles, in a box that is a torus.

        Raises
        ------
        TilewrightValueError
            The tiling does not go around.
        """
        periods = self.tiling.domain.periods
        if any(p is None for p in periods):
            raise TilewrightValueError(
                f"the tiling's domain is a {self.tiling.domain.kind}",
                advice="direct(tiles, period=(n, n)) makes a torus",
            )
        width, height = (int(p) for p in periods if p is not None)
        box = Box((float(width), float(height)))
        points = self.points(0, 0, width, height)
        distance = self.tiles.distance if min(width, height) > 1 else 0.0
        return PointSet(points, box, f"{self.tiles.method} tiles", distance)
