"""Points of a window from the tiles of its cells: what `PointField` is built on."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_function_of_place, check_real
from tilewright.fields.agreement import check_agreement
from tilewright.fields.points.thinning import Density, share_out
from tilewright.fields.points.window import View, Window, fit_out, make_out
from tilewright.signals.points import PointTiles
from tilewright.tilings import Tiling
from tilewright.tilings.density import evaluate_density


class LaidPoints:
    """Point tiles over a tiling, and the points that rows of cells give."""

    _block_points = 2**22
    """About how many points are laid at a time."""

    def __init__(self, tiles: PointTiles, tiling: Tiling) -> None:
        check_agreement(tiles, PointTiles, tiling)
        self.tiles = tiles
        self.tiling = tiling
        counts = tiles.counts
        self._same = int(counts[0]) if (counts == counts[0]).all() else 0
        self._bits = max(int(counts.max()) - 1, 1).bit_length()

    def rows_at(self, column: int, row: int, columns: int, rows: int) -> NDArray[np.int32]:
        """Tell which filling each cell of a window has: the row of its tile's variant.

        Parameters
        ----------
        column, row : int
            North-west cell of the window.
        columns, rows : int
            Size of the window in cells.

        Returns
        -------
        int32 array, shape (rows, columns)
            Rows of ``tiles.starts``, as `Tiling.rows` draws them for ``tiles.variants``.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer.
        TilewrightValueError
            The window is too large or not in the tiling.
        """
        return self.tiling.rows(column, row, columns, rows, variants=self.tiles.variants)

    def _view(self, window: Window) -> View:
        return View.of(self.rows_at, self.tiles.density, window)

    def _counts(self, view: View, rank: float) -> NDArray[np.int64]:
        """Points below a rank in every row of cells."""
        from tilewright.kernels.emission import count_points

        counts = np.zeros(view.cells.shape[0], np.int64)
        held = (self.tiles.starts, self.tiles.points, self.tiles.ranks)
        count_points(len(counts), view.cells, *held, rank, *view.window.bounds, counts)
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
        if function is not None:
            check_function_of_place("density", function)
        if out is not None:
            fit_out(out, 0)
        rank = check_share(density) if function is None else 1.0
        named = named or function is not None
        whole = view.window.is_whole and self._same > 0 and rank >= 1 and not named
        counts = None if whole else self._counts(view, rank)
        n = view.cells.size * self._same if counts is None else int(counts.sum())
        target = fit_out(out, n) if function is None else make_out(n)
        kinds = (target.dtype,) if out is None else (target.dtype, out.dtype)
        x0, y0 = view.window.origin(local, kinds, self._spacing)
        names = np.zeros((n if named else 0, 3), np.int64)
        if counts is None:
            flat, rows = target.reshape(-1), len(view.cells)
            lay_whole_tiles(rows, view.cells, tiles.points.ravel(), self._same, x0, y0, flat)
        else:
            held, sides = (tiles.starts, tiles.points, tiles.ranks), Sides(*view.window.bounds)
            firsts = np.cumsum(counts) - counts
            lay_points(len(counts), view.cells, *held, rank, sides, firsts, x0, y0, target, named, names)
        if function is None:
            return target, names
        kept = self._ranks_of(view, names) < evaluate_density(function, *target.T)
        if out is not None:
            kept_out = fit_out(out, int(kept.sum()))
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
        band = max(1, self._block_points // max(1, int(per_row.max())))
        for top in range(0, len(per_row), band):
            rows = slice(top, top + band)
            points = np.empty((int(per_row[rows].sum()), 2))
            firsts = np.cumsum(per_row[rows]) - per_row[rows]
            starts, held = self.tiles.starts, self.tiles.points
            cells = view.cells[rows]
            lay_first_points(len(cells), cells, quotas[rows], firsts, starts, held, x0, y0 + top, points)
            yield points


def check_share(density: Any) -> float:
    """A density as a number: a share of the points."""
    return check_real("density", density, 0.0, 1.0)
