"""Figures of how points lie to each other, without a spectrum."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from math import nan, pi, sqrt

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from tilewright.analysis.points.checks import check_set, check_sets
from tilewright.checks import check_choice, check_int, check_real
from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet
from tilewright.samplers.radius import max_radius, nearest_distances
from tilewright.showing import describe_record

MOST_FOR_DISCREPANCY = 2**15
_MOST = 10**5
"""Points that the repetitions of a thin torus may have together."""
_DISCREPANCIES = {"centered": "CD", "wrapped": "WD", "star": "L2-star"}


def nearest_mean(points: PointSet) -> float:
    """Measure the mean distance to the nearest other point, over 2 r_max: 1 for the hexagonal lattice.

    Where rho is the least of these distances, this is their mean. White noise in a plane has 0.465.

    Parameters
    ----------
    points : PointSet
        In a plane or a volume, at least 3 points.

    Returns
    -------
    float
        The mean distance, in units of 2 r_max.

    Raises
    ------
    TilewrightTypeError
        Something else than a `PointSet`.
    TilewrightValueError
        Too few points, or points outside their box.

    Examples
    --------
    >>> import tilewright as tw
    >>> round(tw.nearest_mean(tw.sample_points("hexagonal", 1000)), 2)
    1.0
    """
    given = check_set(points, dimensions=(2, 3))
    return float(nearest_distances(given.points, given.box).mean() / (2 * given.max_radius))


def nearest_mean_within(points: PointSet) -> float:
    """`nearest_mean`, on a plain box of the points that have as much around them as any of them needs.

    Points near a side may have a nearer neighbor beyond it.
    """
    if points.box.torus:
        return nearest_mean(points)
    nearest = nearest_distances(points.points, points.box)
    to_side = np.minimum(points.points, np.array(points.box.extent) - points.points).min(axis=1)
    used = to_side >= nearest.max()
    return float(nearest[used if used.any() else slice(None)].mean() / (2 * points.max_radius))


@dataclass(frozen=True, eq=False)
class RadialDistribution:
    """How many points there are at each distance from a point.

    Attributes
    ----------
    distance : float64 array, shape (bins,)
        Middle of each bin, over 2 r_max.
    density : float64 array, shape (bins,)
        Points at that distance, over how many there would be in white noise of as many points in this box.
    """

    distance: NDArray[np.float64]
    density: NDArray[np.float64]

    __repr__ = describe_record


def radial_distribution(
    sets: PointSet | Sequence[PointSet], reach: float | None = None, bins: int = 250
) -> RadialDistribution:
    """Measure the radial distribution function, also called pair correlation, mean of one or several sets.

    Its Hankel transform is the radial power (Heck, Schloemer & Deussen 2013). What the border of a plain box
    cuts off is made up for, exactly in the mean, by the box's set covariance.

    Parameters
    ----------
    sets : PointSet or list of PointSet
        Of one box, in a plane or a volume; distances are counted in 2 r_max of their mean number of points.
    reach : float, optional
        The largest distance, over 2 r_max; at most half the shortest side of a torus, or the shortest side
        of a plain box. By default 5 or as far as is allowed.
    bins : int, optional
        Number of bins of equal width, 1 to 100,000; default 250.

    Returns
    -------
    RadialDistribution
        The middle of each bin, and the density there over that of white noise.

    Raises
    ------
    TilewrightTypeError
        Something else than point sets and numbers.
    TilewrightValueError
        Too few points, sets of different boxes, or a number out of range.
    """
    from scipy.spatial import cKDTree

    given = check_sets(sets, dimensions=(2, 3))
    box = given[0].box
    unit = 2 * max_radius(round(np.mean([len(s) for s in given])), box)
    most = min(box.extent) / unit / (2 if box.torus else 1)
    # A torus takes its own half length for two distances; stay just below.
    far = min(5.0, 0.999 * most) if reach is None else check_real("reach", reach, 1e-6, 0.999 * most)
    edges = np.linspace(0, far, check_int("bins", bins, 1, 10**5) + 1)
    pairs, expected = np.zeros(bins), np.zeros(bins)
    chance = np.diff(_pair_chance(box)(edges * unit))
    for one in given:
        tree = cKDTree(one.points, boxsize=box.extent if box.torus else None)
        found = tree.count_neighbors(tree, edges[1:] * unit, cumulative=False)
        found[0] -= len(one)
        pairs += found
        expected += len(one) * (len(one) - 1) * chance
    return RadialDistribution((edges[1:] + edges[:-1]) / 2, pairs / expected)


def _pair_chance(box: Box) -> Polynomial:
    """Chance that two random points of the box are closer than a distance."""
    volume, sides = box.volume, box.extent
    sphere = Polynomial([0, 2 * pi] if box.dimension == 2 else [0, 0, 4 * pi])
    # Mean over all directions of the part of the box that overlaps the box moved by a distance.
    if box.torus:
        overlap = Polynomial([volume])
    elif box.dimension == 2:
        overlap = Polynomial([volume, -2 * sum(sides) / pi, 1 / pi])
    else:
        faces = volume * sum(1 / s for s in sides)
        overlap = Polynomial([volume, -faces / 2, 2 * sum(sides) / (3 * pi), -1 / (4 * pi)])
    return (sphere * overlap / volume**2).integ()


def coverage_radius(points: PointSet) -> float:
    """Measure the largest circle (sphere) without a point: its radius over r_max; its center lies in the box.

    No point can be added to a set of relative radius rho if this is less than 2 rho: it is maximal. The
    hexagonal lattice has 1.155, the least there is in a plane.

    Parameters
    ----------
    points : PointSet
        In a plane or a volume. On a plain box circles are centered inside but may reach out of it.

    Returns
    -------
    float
        The radius, in units of r_max.

    Raises
    ------
    TilewrightTypeError
        Something else than a `PointSet`.
    TilewrightValueError
        Too few points, or points outside their box.

    Examples
    --------
    >>> import tilewright as tw
    >>> round(tw.coverage_radius(tw.sample_points("hexagonal", 1000)), 2)
    1.15
    """
    given = check_set(points, dimensions=(2, 3))
    return _neighborhood(given).coverage


def bond_order(points: PointSet) -> float:
    """Measure order: mean over the points of |mean over their Voronoi neighbors of exp(6 i angle)|.

    It is 1 for hexagons, and tells ordered from disordered sets even where they have many domains (local
    bond-orientational order, after Halperin & Nelson 1978). White noise has about 0.36, dart throwing at 0.7
    about 0.41.

    Parameters
    ----------
    points : PointSet
        In a plane. On a plain box, points so near to its sides that they might lack neighbors are left out.

    Returns
    -------
    float
        The mean, 0 to 1; NaN if no points remain.

    Raises
    ------
    TilewrightTypeError
        Something else than a `PointSet`.
    TilewrightValueError
        Too few points, or a set that is not in a plane.
    """
    return _neighborhood(check_set(points)).bond_order


@dataclass(frozen=True)
class Neighborhood:
    """Two figures of one Voronoi diagram, see `coverage_radius` and `bond_order`."""

    coverage: float
    bond_order: float


def measure_neighborhood(points: PointSet) -> Neighborhood:
    """Both figures of a set in a plane, in the time of one of them.

    Where the box is plain, its points may go on beyond it: only circles that lie within it count, so that
    its sides open none. NaN where there is no such circle.
    """
    given = check_set(points)
    return _neighborhood(given) if given.box.torus else _neighborhood_within(given)


def _too_thin(points: PointSet) -> TilewrightValueError:
    size = " x ".join(f"{side:g}" for side in points.box.extent)
    return TilewrightValueError(
        f"are {len(points)} in {size}, too thin for circles among them",
        argument="points",
        value=len(points),
        advice="give more points, or a wider box",
    )


def _neighborhood(points: PointSet) -> Neighborhood:
    from scipy.spatial import QhullError, Voronoi, cKDTree

    extent = np.array(points.box.extent)
    slack = 1e-9 * extent
    margin = 6 * points.max_radius
    while True:
        around = _surroundings(points, margin)
        try:
            diagram = Voronoi(around, qhull_options="Qbb Qc Qz")
        except QhullError:  # beside such a length the width is rounded away
            raise _too_thin(points) from None
        corners = diagram.vertices
        inside = corners[((corners >= -slack) & (corners <= extent + slack)).all(axis=1)]
        # Neighbors are twice the radius apart at most: where the margin is less, some may be missing.
        radius = float(cKDTree(around).query(inside)[0].max()) if len(inside) else margin
        if 2 * radius < margin or (not points.box.torus and margin > extent.max()):
            break
        margin *= 2
    order = _mean_bond_order(points, around, diagram.ridge_points, margin) if len(extent) == 2 else nan
    return Neighborhood(radius / points.max_radius, order)


def _neighborhood_within(points: PointSet) -> Neighborhood:
    """Of a plain box, by what lies within it alone."""
    from scipy.spatial import QhullError, Voronoi, cKDTree

    at, extent = points.points, np.array(points.box.extent)
    try:
        diagram = Voronoi(at, qhull_options="Qbb Qc Qz")
    except QhullError:  # all points lie on a line
        return Neighborhood(nan, nan)
    corners = diagram.vertices
    corners = corners[((corners > 0) & (corners < extent)).all(axis=1)]
    radius = cKDTree(at).query(corners)[0] if len(corners) else np.empty(0)
    widest = float(radius.max(where=radius <= np.minimum(corners, extent - corners).min(axis=1), initial=0))
    if widest == 0:
        return Neighborhood(nan, nan)
    order = _mean_bond_order(points, at, diagram.ridge_points, 2 * widest)
    return Neighborhood(widest / points.max_radius, order)


def _mean_bond_order(
    points: PointSet, around: NDArray[np.float64], pairs: NDArray[np.int32], margin: float
) -> float:
    n = len(points)
    own, other = np.concatenate([pairs, pairs[:, ::-1]])[np.concatenate([pairs[:, 0], pairs[:, 1]]) < n].T
    bonds = (around[other] - around[own]) @ (1, 1j)
    turns = (bonds / abs(bonds)) ** 6
    counts = np.bincount(own, minlength=n)
    order = np.hypot(np.bincount(own, turns.real, n), np.bincount(own, turns.imag, n))
    # A point that lies on another one has no neighbors.
    used = counts > 0
    if not points.box.torus:
        extent = np.array(points.box.extent)
        used &= ((points.points >= margin) & (points.points <= extent - margin)).all(axis=1)
    return float((order[used] / counts[used]).mean()) if used.any() else nan


def _surroundings(points: PointSet, margin: float) -> NDArray[np.float64]:
    """The points, and after them their copies outside the box up to ``margin`` from it.

    A torus goes on periodically. A plain box is mirrored at its sides, which makes them Voronoi edges and
    its corners Voronoi corners.
    """
    extent = np.array(points.box.extent)
    # Nearer than its first mirror images no other image of a point can be.
    most = np.ceil(margin / extent) if points.box.torus else np.minimum(np.ceil(margin / extent), 1)
    if points.box.torus and len(points) * np.prod(1 + 2 * margin / extent) > max(100 * len(points), _MOST):
        raise _too_thin(points)
    reach = [range(-int(n), int(n) + 1) for n in most]
    around = [points.points]
    for shift in product(*reach):
        if not any(shift):
            continue
        odd = np.array(shift) % 2 == 1
        within = np.where(odd & (not points.box.torus), extent - points.points, points.points)
        copy = within + np.array(shift) * extent
        around.append(copy[((copy > -margin) & (copy < extent + margin)).all(axis=1)])
    return np.concatenate(around)


def discrepancy(points: PointSet, kind: str = "centered") -> float:
    """Measure the L2 discrepancy: how far shares of points in boxes are from the boxes' areas.

    Parameters
    ----------
    points : PointSet
        In a plane or a volume, up to 32,768 points, since each pair of them is looked at.
    kind : str, optional
        ``"star"``: boxes with one corner at the origin (Warnock 1972). ``"centered"`` (default; Hickernell
        1998): boxes at each corner of the domain. ``"wrapped"``: boxes anywhere on the torus.

    Returns
    -------
    float
        The discrepancy, a root: scipy.stats.qmc, which measures it, gives the square of the last two.

    Raises
    ------
    TilewrightTypeError
        Something else than a `PointSet`.
    TilewrightValueError
        An unknown kind, or too few or too many points.
    """
    from scipy.stats import qmc

    given = check_set(points, dimensions=(2, 3))
    method = _DISCREPANCIES[check_choice("kind", kind, tuple(_DISCREPANCIES))]
    if len(given) > MOST_FOR_DISCREPANCY:
        raise TilewrightValueError(
            f"has {len(given)} points; the discrepancy takes time for each pair of them and is limited "
            f"to {MOST_FOR_DISCREPANCY}",
            argument="points",
            value=len(given),
            advice="give a smaller set",
        )
    value = float(qmc.discrepancy(given.points / np.array(given.box.extent), method=method))
    return value if kind == "star" else sqrt(value)
