"""Points over a tiling: those of any window of an endless plane, each with an identity that stays."""

from collections.abc import Iterator
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_int, check_out, check_real
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.fields.agreement import check_agreement
from tilewright.fields.points.nearest import NearestSearch
from tilewright.fields.points.thinning import DensityFunction, draw_lowest, evaluate_density, share_out
from tilewright.fields.points.window import MOST_POINTS, PointWindow, View, Window
from tilewright.samplers.box import Box, as_points
from tilewright.samplers.point_set import PointSet
from tilewright.signals.points import PointTiles
from tilewright.tilings import MixerHash, Tiling
from tilewright.tilings.direct_tiling import DirectTiling
from tilewright.tilings.domain import LARGEST_CELL
from tilewright.tilings.streams import VARIANTS

Density = float | DensityFunction
"""A share 0 to 1 of the points, or a function that gives it at points, shape (n, 2) -> (n,)."""

_BLOCK_POINTS = 2**22


class PointField:
    """Point tiles laid by a tiling.

    Parameters
    ----------
    tiles : PointTiles
    tiling : Tiling
        A tiling of the same tile set.

    Notes
    -----
    Lengths are in tiles: cell (x, y) covers [x, x + 1) x [y, y + 1); x grows east and y grows south. Cells
    reach to +-2^61. Windows are half open, so that those side by side share no point.
    """

    def __init__(self, tiles: PointTiles, tiling: Tiling) -> None:
        check_agreement(tiles, PointTiles, tiling)
        self.tiles = tiles
        self.tiling = tiling
        counts = tiles.counts
        self._same = int(counts[0]) if (counts == counts[0]).all() else 0
        self._bits = max(int(counts.max()) - 1, 1).bit_length()

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
        """Points of a window, equal to those of any other window that holds them.

        Parameters
        ----------
        x, y : float or int
            North-west corner, in tiles.
        width, height : float
            In tiles.
        density : float or function, optional
            Keep this share of the points, the first of them by rank. A function is called with points,
            float64, shape (n, 2), and answers shares from 0 to 1 for each.
        local : bool
            Measure from the window's corner instead of from the origin, which keeps far windows exact.
        out : float32 or float64 array, shape (at least as many as come, 2), C-contiguous, optional
            Written to from the first row on.

        Returns
        -------
        float64 array, shape (n, 2), or the part of ``out`` that was written
            Row by row of cells; within a cell by rank.

        Raises
        ------
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
        """Points of a window with cells, numbers in the tile, ranks and ids.

        Parameters, order and errors are those of `points`.
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
        """How many points `points` gives for the same window and share; errors are those of `points`."""
        rank = _check_share(density)
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
        """Exactly ``count`` points of a window: those of lowest rank, and of equal rank some by chance.

        Parameters
        ----------
        count : int
        x, y : float or int
            North-west corner.
        width, height : float, optional
            By default the smallest square of whole tiles that holds enough points.
        local : bool
            As in `points`.

        Returns
        -------
        float64 array, shape (count, 2)
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
        """The points `sample` gives for a square of whole tiles, in pieces of some million.

        Parameters
        ----------
        count : int
        x, y : int
            North-west cell.
        side : int, optional
            Side of the square in tiles; the smallest that holds enough points by default.
        local : bool
            As in `points`.

        Yields
        ------
        float64 array, shape (n, 2)
        """
        n = check_int("count", count, 1, 2**40)
        left, top = (check_int(a, v, -LARGEST_CELL, LARGEST_CELL) for a, v in (("x", x), ("y", y)))
        along = self.side_for(n, left, top) if side is None else check_int("side", side, 1, MOST_POINTS)
        view = View.of(self.rows_at, 1.0, Window.of(left, top, along, along))
        yield from self._lay_quotas(view, n, local)

    def side_for(self, count: int, x: float = 0, y: float = 0) -> int:
        """Side of the smallest square, in whole tiles and from (x, y) on, that holds ``count`` points."""
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
        """The points of a window in pieces of some million, for sets larger than memory.

        The pieces together hold the same points as `points`; they are bands of whole rows of cells, or
        parts of bands where these are long. With ``local``, points count from the corner of the window.
        Parameters and errors are those of `points`, but that windows may be of any size.

        Yields
        ------
        float64 array, shape (n, 2)
        """
        most = max(1, int(_BLOCK_POINTS / max(self.tiles.density, 1e-9)))
        for piece in Window.of(x, y, width, height).pieces(most):
            yield self._lay(self._view(piece), density, local, None)[0]

    def nearest(self, positions: ArrayLike) -> tuple[NDArray[np.float64], PointWindow]:
        """The nearest point of the field to each position (Lagae 2007, section 7.6.2).

        Parameters
        ----------
        positions : array-like, shape (n, 2)

        Returns
        -------
        distances : float64 array, shape (n,)
        found : PointWindow
            One point for each position.

        Raises
        ------
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
        """All points of a tiling of a torus, see ``period`` of `direct`, in tile lengths.

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

    def rows_at(self, column: int, row: int, columns: int, rows: int) -> NDArray[np.int32]:
        """Which filling each cell of a window has: tile index times variants, plus the variant."""
        indices = self.tiling.indices(column, row, columns, rows)
        variants = self.tiles.variants
        if variants == 1:
            return indices
        domain = self.tiling.domain
        hash = self.tiling.hash if isinstance(self.tiling, DirectTiling) else MixerHash(0)
        x, y = domain.wrap(0, column, columns), domain.wrap(1, row, rows)
        picked = hash.numbers(VARIANTS, x[np.newaxis, :], y[:, np.newaxis]) * variants >> 24
        return (indices * variants + picked).astype(np.int32)

    def _view(self, window: Window) -> View:
        return View.of(self.rows_at, self.tiles.density, window)

    def _counts(self, view: View, rank: float) -> NDArray[np.int64]:
        """Points below a rank in every row of cells."""
        from tilewright.kernels.emission import count_points

        counts = np.zeros(view.cells.shape[0], np.int64)
        tiles = self.tiles
        count_points(view.cells, tiles.starts, tiles.points, tiles.ranks, rank, *view.window.bounds, counts)
        return counts

    def _lay(
        self,
        view: View,
        density: Density,
        local: bool,
        out: NDArray[Any] | None,
        named: bool = False,
    ) -> tuple[NDArray[Any], NDArray[np.int64]]:
        """Points of a window and, if ``named``, row and column of their cells and numbers in the tile."""
        from tilewright.kernels.emission import Sides, lay_points, lay_whole_tiles

        tiles, function = self.tiles, density if callable(density) else None
        if out is not None:
            _check_out(out, 0)
        rank = 1.0 if callable(density) else _check_share(density)
        named = named or function is not None
        whole = view.window.is_whole and self._same > 0 and rank >= 1 and not named
        counts = None if whole else self._counts(view, rank)
        n = view.cells.size * self._same if counts is None else int(counts.sum())
        target = _check_out(out, n) if function is None else _make_out(n)
        kinds = (target.dtype,) if out is None else (target.dtype, out.dtype)
        x0, y0 = view.window.origin(local, kinds, self._spacing)
        names = np.zeros((n if named else 0, 3), np.int64)
        if counts is None:
            lay_whole_tiles(view.cells, tiles.points.ravel(), self._same, x0, y0, target.reshape(-1))
        else:
            held, sides = (tiles.starts, tiles.points, tiles.ranks), Sides(*view.window.bounds)
            firsts = np.cumsum(counts) - counts
            lay_points(view.cells, *held, rank, sides, firsts, x0, y0, target, named, names)
        if function is None:
            return target, names
        kept = self._ranks_of(view, names) < evaluate_density(function, target)
        if out is not None:
            kept_out = _check_out(out, int(kept.sum()))
            kept_out[...] = target[kept]
            return kept_out, names[kept]
        return target[kept], names[kept]

    def _ranks_of(self, view: View, names: NDArray[np.int64]) -> NDArray[np.float32]:
        rows = view.cells[names[:, 0], names[:, 1]]
        ranks: NDArray[np.float32] = self.tiles.ranks[self.tiles.starts[rows] + names[:, 2]]
        return ranks

    @property
    def _spacing(self) -> float:
        """A length that coordinates must tell apart."""
        return self.tiles.distance or 0.1 / max(self.tiles.density, 1e-9) ** 0.5

    def _lay_quotas(self, view: View, count: int, local: bool) -> Iterator[NDArray[np.float64]]:
        """The ``count`` points of lowest rank of whole cells, a band of rows at a time."""
        from tilewright.kernels.emission import lay_first_points

        x0, y0 = view.window.origin(local, (np.dtype(np.float64),), self._spacing)
        quotas = share_out(self.tiles, view, count)
        per_row = quotas.sum(axis=1, dtype=np.int64)
        band = max(1, _BLOCK_POINTS // max(1, int(per_row.max())))
        for top in range(0, len(per_row), band):
            rows = slice(top, top + band)
            points = np.empty((int(per_row[rows].sum()), 2))
            firsts = np.cumsum(per_row[rows]) - per_row[rows]
            starts, held = self.tiles.starts, self.tiles.points
            lay_first_points(view.cells[rows], quotas[rows], firsts, starts, held, x0, y0 + top, points)
            yield points


def _check_share(density: Any) -> float:
    return check_real("density", density, 0.0, 1.0)


def _make_out(n: int) -> NDArray[np.float64]:
    try:
        return np.empty((n, 2))
    except MemoryError:
        raise TilewrightValueError(
            f"{n} points do not fit in memory", advice="blocks() gives them a piece at a time"
        ) from None


def _check_out(out: Any, n: int) -> NDArray[Any]:
    if out is None:
        return _make_out(n)
    kinds = (np.float32, np.float64)
    check_out(
        out,
        lambda o: o.ndim == 2 and o.shape[1] == 2 and len(o) >= n and o.dtype in kinds,
        f"float32 or float64 (at least {n}, 2)",
    )
    return out[:n]
