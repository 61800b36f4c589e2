"""Point tiles laid tile by tile, without a field."""

import numpy as np
from scipy.spatial import cKDTree

from tilewright.signals.points.neighborhood import OFFSETS
from tilewright.tilings import first_mismatch, stochastic

SIDE = 40


def random_cells(tiles, side=SIDE, seed=0):
    return stochastic(tiles, side, side, seed).indices(0, 0, side, side)


def lay(tiles, cells):
    """All points of a tiling in a plane."""
    rows = [tiles.tile(t) + np.array([x, y], np.float64) for (y, x), t in np.ndenumerate(cells)]
    return np.concatenate(rows)


def nearest(points):
    return cKDTree(points).query(points, k=2)[0][:, 1].min()


def fits_all_around(tiles, t, ring):
    """Whether eight tiles in the order of OFFSETS fit around tile t, by laying all nine."""
    cells = np.empty((3, 3), int)
    cells[1, 1] = t
    for (x, y), tile in zip(OFFSETS, ring, strict=True):
        cells[1 + y, 1 + x] = tile
    return first_mismatch(tiles, cells, torus=False) is None
