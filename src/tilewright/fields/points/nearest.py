"""The nearest point of a field, found among the cells around a position."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.signals.points import PointTiles

_FARTHEST = 16
"""How many tiles around a position are looked at; only sets with many empty tiles need more than one."""


class NearestSearch:
    """Looks for nearest points in the cells around positions, farther out where near ones are empty.

    Parameters
    ----------
    tiles : PointTiles
    look_up : function
        ``look_up(column, row, columns, rows)`` tells the filling of each cell.
    """

    def __init__(self, tiles: PointTiles, look_up: Callable[..., NDArray[np.int32]]) -> None:
        self.tiles = tiles
        self.look_up = look_up

    def find(
        self, positions: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
        """Distance, cell (x, y) and number in its tile of the nearest point to each position."""
        n = len(positions)
        columns, rows = np.floor(positions).astype(np.int64).T
        distances = np.full(n, np.inf)
        names = np.zeros((n, 3), np.int64)
        reach, open = 1, np.arange(n)
        while len(open):
            if reach > _FARTHEST:
                raise TilewrightValueError(
                    f"no point lies within {_FARTHEST} tiles of {tuple(positions[open[0]].tolist())}"
                )
            self._look(positions, columns, rows, open, reach, names, distances)
            inside = positions[open] - np.floor(positions[open])
            border = reach + np.minimum(inside, 1 - inside).min(axis=1)
            open = open[distances[open] > border]
            reach *= 2
        cells = np.stack([columns + names[:, 1], rows + names[:, 0]], axis=1)
        return distances, cells, names[:, 2]

    def _look(
        self,
        positions: NDArray[np.float64],
        columns: NDArray[np.int64],
        rows: NDArray[np.int64],
        which: NDArray[np.intp],
        reach: int,
        names: NDArray[np.int64],
        distances: NDArray[np.float64],
    ) -> None:
        from tilewright.kernels.emission import find_nearest

        steps = np.arange(-reach, reach + 1)
        around = np.stack(np.meshgrid(steps, steps), axis=-1)
        cells = np.stack([columns[which], rows[which]], axis=1)[:, np.newaxis, np.newaxis] + around
        inside = positions[which] - np.floor(positions[which])
        found, squares = np.zeros((len(which), 3), np.int64), np.zeros(len(which))
        find_nearest(
            len(which),
            inside[:, 0],
            inside[:, 1],
            self.rows_of(cells),
            self.tiles.starts,
            self.tiles.points,
            reach,
            found,
            squares,
        )
        names[which], distances[which] = found, np.sqrt(squares)

    def rows_of(self, cells: NDArray[np.int64]) -> NDArray[np.int32]:
        """Which filling each of some cells has; neighboring cells are looked up together."""
        flat = cells.reshape(-1, 2)
        result = np.empty(len(flat), np.int32)
        blocks, inverse = np.unique(flat >> 6, axis=0, return_inverse=True)
        order = np.argsort(inverse.ravel(), kind="stable")
        ends = np.searchsorted(inverse.ravel()[order], np.arange(len(blocks) + 1))
        for b in range(len(blocks)):
            mine = order[ends[b] : ends[b + 1]]
            low, high = flat[mine].min(axis=0), flat[mine].max(axis=0)
            window = self.look_up(*low.tolist(), *(high - low + 1).tolist())
            result[mine] = window[flat[mine, 1] - low[1], flat[mine, 0] - low[0]]
        return result.reshape(cells.shape[:-1])
