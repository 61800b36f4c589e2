"""The natural neighbors of points on a surface, each looked at in its own tangent plane."""

from math import nan
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

_AROUND = 16
"""Nearest points among which the natural neighbors are looked for."""
_MOST_SIDES = 14
_OPEN = np.cos(np.radians(150))
"""Between two neighbors in turn that lie farther around than this there is no point: the border is near."""


def share_of_six(tree: "cKDTree", points: NDArray[np.float64], normals: NDArray[np.float64]) -> float:
    """Which part of the points have six natural neighbors; NaN where none is surrounded by others.

    Points beyond the border of the surface would be neighbors too, so those beside it are left out, as are
    those with fewer than three points on their own side of a thin part.
    """
    near = tree.query(points, min(_AROUND + 1, len(points)))[1][:, 1:]
    around = points[near] - points[:, np.newaxis]
    facing = np.einsum("nkd,nd->nk", normals[near], normals) > 0
    inverted = _invert(around, normals, facing)
    counts = _count_hull(inverted)
    known = counts > 0
    return float((counts[known] == 6).mean()) if known.any() else nan


def _invert(
    around: NDArray[np.float64], normals: NDArray[np.float64], facing: NDArray[np.bool_]
) -> NDArray[np.complex128]:
    """Neighbors in the tangent plane, inverted at the unit circle: the natural ones make the convex hull.

    Those that do not count come to lie in the center, which is on no hull that surrounds it.
    """
    first = np.cross(normals, np.eye(3)[np.abs(normals).argmin(axis=1)])
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(normals, first)
    flat = np.einsum("nkd,nd->nk", around, first) + 1j * np.einsum("nkd,nd->nk", around, second)
    squared = np.abs(flat) ** 2
    counts = facing & (squared > 0)
    return np.where(counts, flat / np.where(counts, squared, 1), 0)


def _count_hull(points: NDArray[np.complex128]) -> NDArray[np.int64]:
    """Corners of the convex hull of each row; 0 where it does not surround the center well."""
    rows = np.arange(len(points))
    start = np.abs(points).argmax(axis=1)
    at, heading = start, 1j * points[rows, start]
    counts, closed = np.zeros(len(points), np.int64), np.abs(points[rows, start]) == 0
    good = ~closed
    for _ in range(_MOST_SIDES):
        here = points[rows, at]
        ahead = points - here[:, np.newaxis]
        with np.errstate(divide="ignore", invalid="ignore"):
            turn = np.angle(ahead * heading.conj()[:, np.newaxis]) % (2 * np.pi)
        turn[ahead == 0] = np.inf
        following = turn.argmin(axis=1)
        there = points[rows, following]
        seen = here.conj() * there
        open_here = (seen.imag <= 0) | (seen.real < _OPEN * np.abs(seen))
        good &= closed | ~open_here
        counts += ~closed
        closed = closed | (following == start)
        at, heading = following, there - here
        if closed.all():
            break
    return np.where(good & closed, counts, 0)
