"""The relative radius: how far apart points are, whatever their number (Lagae 2007, section 4.2.3)."""

from math import inf, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.samplers.box import Box

LARGEST_COUNT = 2**31 - 1


def max_radius(count: int, box: Box) -> float:
    """Radius of ``count`` disks in the densest packing: r_max of Lagae 2007, eq. 4.2, of spheres eq. 4.5.

    Half the distance of nearest points in a hexagonal lattice (a face-centered cubic one in three
    dimensions) with ``count`` points in the box.
    """
    return float((box.volume / count / cell_volume(box.dimension)) ** (1 / box.dimension))


def cell_volume(dimension: int) -> float:
    """Area or volume that each disk or sphere of radius 1 has to itself in the densest packing."""
    return 2 * sqrt(3) if dimension == 2 else 4 * sqrt(2)


def nearest_distances(points: ArrayLike, box: Box) -> NDArray[np.float64]:
    """Distance from every point to the nearest other one; infinity for a single point.

    On a torus a point's own images count too: nothing is farther than its shortest side.
    """
    from scipy.spatial import cKDTree

    given = box.check_points(points)
    farthest = float(box.periods.min())
    if len(given) < 2:
        return np.full(len(given), farthest)
    tree = cKDTree(given, boxsize=box.extent if box.torus else None)
    return np.minimum(tree.query(given, k=2)[0][:, 1], farthest)


def relative_radius(points: ArrayLike, box: Box | None = None) -> float:
    """rho = r / r_max, with r half the least distance of two points (Lagae 2007, eq. 4.3).

    Parameters
    ----------
    points : array-like, shape (N, d)
    box : Box
        The domain; the unit torus by default.
    """
    domain = Box() if box is None else box
    distances = nearest_distances(points, domain)
    if not len(distances):
        return inf
    return float(distances.min()) / 2 / max_radius(len(distances), domain)
