"""Fewer points, by their ranks: a given number of a window's, or a share that changes from place to place."""

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.fields.points.window import PointWindow, View
from tilewright.signals.points import PointTiles
from tilewright.tilings import MixerHash
from tilewright.tilings.density import Density as DensityFunction
from tilewright.tilings.streams import LOTS

Density = float | DensityFunction
"""A share 0 to 1 of the points, or a function of x and y that gives it at every place."""


def share_out(tiles: PointTiles, view: View, count: int) -> NDArray[np.int32]:
    """How many points each cell gives, so that all together give the ``count`` of lowest rank.

    Within a cell points come in the order of their ranks, so these are always its first ones.
    """
    cells = np.bincount(view.cells.ravel(), minlength=len(tiles.starts) - 1)
    times = np.repeat(cells, tiles.counts)
    order = np.argsort(tiles.ranks, kind="stable")
    total = np.cumsum(times[order])
    _check_enough(count, int(total[-1]) if len(total) else 0)
    last = tiles.ranks[order[int(np.searchsorted(total, count))]]
    row = np.repeat(np.arange(len(cells)), tiles.counts)
    quotas = np.bincount(row[tiles.ranks <= last], minlength=len(cells)).astype(np.int32)[view.cells]
    excess = int(quotas.sum(dtype=np.int64)) - count
    # Of the cells that hold a point of the highest rank some give one less, by lot.
    i, j = np.nonzero(np.isin(view.cells, row[tiles.ranks == last]))
    lots = MixerHash(0).words(LOTS, view.window.column + j, view.window.row + i)
    lose = np.argsort(lots, kind="stable")[:excess]
    quotas[i[lose], j[lose]] -= 1
    return quotas


def draw_lowest(window: PointWindow, count: int) -> NDArray[np.intp]:
    """Which ``count`` points of a window have the lowest ranks, in the window's order."""
    _check_enough(count, len(window.points))
    x, y = window.cells.T
    lots = MixerHash(0).words(LOTS, x, y, window.numbers)
    return np.sort(np.lexsort((lots, window.ranks))[:count])


def _check_enough(count: int, there: int) -> None:
    if there < count:
        raise TilewrightValueError(
            f"is {count}; the window holds {there} points, so ask for fewer or for a larger one",
            argument="count",
            value=count,
        )
