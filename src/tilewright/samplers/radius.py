"""The relative radius: how far apart points are, whatever their number (Lagae 2007, section 4.2.3)."""

from math import inf, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_type
from tilewright.samplers.box import Box

LARGEST_COUNT = 2**31 - 1


def max_radius(count: int, box: Box) -> float:
    """Give the radius r_max of disks, or spheres, in their densest packing.

    It is half the distance of nearest points in a hexagonal lattice (a face-centered cubic one in three
    dimensions) with ``count`` points in the box.

    Parameters
    ----------
    count : int
        Number of disks, 1 or more.
    box : Box
        The domain.

    Returns
    -------
    float
        The radius, in the box's units.

    Raises
    ------
    TilewrightTypeError
        Something else than a box.

    Notes
    -----
    Lagae 2007, section 4.2.3, eq. 4.2; of spheres section 4.6.1.2, eq. 4.5.

    Examples
    --------
    >>> import tilewright as tw
    >>> round(tw.max_radius(1000, tw.Box()), 5)
    0.01699
    """
    check_type("box", box, Box, "a Box", "Box((width, height)) makes one")
    return float((box.volume / count / cell_volume(box.dimension)) ** (1 / box.dimension))


def cell_volume(dimension: int) -> float:
    """Area or volume that each disk or sphere of radius 1 has to itself in the densest packing."""
    return 2 * sqrt(3) if dimension == 2 else 4 * sqrt(2)


def nearest_distances(points: ArrayLike, box: Box) -> NDArray[np.float64]:
    """Measure the distance from every point to the nearest other one.

    Parameters
    ----------
    points : array-like of float, shape (N, d)
        Coordinates inside the box, x first.
    box : Box
        The domain. On a torus a point's own images count too: nothing is farther than its shortest side.

    Returns
    -------
    float64 array, shape (N,)
        Distances in the box's units; infinity for a single point of a plain box.

    Raises
    ------
    TilewrightTypeError
        The coordinates are not numbers.
    TilewrightValueError
        They have another shape, are not finite, or lie outside the box.
    """
    from scipy.spatial import cKDTree

    given = box.check_points(points)
    farthest = float(box.periods.min())
    if len(given) < 2:
        return np.full(len(given), farthest)
    tree = cKDTree(given, boxsize=box.extent if box.torus else None)
    return np.minimum(tree.query(given, k=2)[0][:, 1], farthest)


def relative_radius(points: ArrayLike, box: Box | None = None) -> float:
    """Measure the relative radius: rho = r / r_max, with r half the least distance of two points.

    Parameters
    ----------
    points : array-like of float, shape (N, d)
        Coordinates inside the box, x first.
    box : Box, optional
        The domain; by default the unit torus.

    Returns
    -------
    float
        0, where two points coincide, to 1, a hexagonal lattice; 0.7 and more is a good Poisson disk set.
        Infinity where there are no points.

    Raises
    ------
    TilewrightTypeError
        The coordinates are not numbers, or the box is none.
    TilewrightValueError
        They have another shape, are not finite, or lie outside the box.

    Notes
    -----
    Lagae 2007, section 4.2.3, eq. 4.3.

    Examples
    --------
    >>> import tilewright as tw
    >>> round(tw.relative_radius([[0.1, 0.1], [0.6, 0.6]]), 4)
    0.9306
    """
    domain = Box() if box is None else check_type("box", box, Box, "a Box", "Box((width, height)) makes one")
    distances = nearest_distances(points, domain)
    if not len(distances):
        return inf
    return float(distances.min()) / 2 / max_radius(len(distances), domain)
