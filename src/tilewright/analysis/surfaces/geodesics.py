"""Distances along a surface from places to the nearest of its points."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.spots import Spots
from tilewright.domains.surface import Surface

if TYPE_CHECKING:
    from tilewright.kernels.geodesics import Marks, Unfolding

_MOST = 500_000
"""Strips of triangles that are looked at for a place before its search is given up."""
_FARTHER = 1.25
"""How much farther than straight through space is looked at first."""
_LEAST = 1e-6
"""The same where points coincide, in mean distances."""
_SADDLE = 1e-9
"""Radians by which the angles around a vertex must exceed a full turn for a shortest way to turn there."""
_AT = 1 - 1e-9
"""Weight from which on a point lies at a vertex."""


class Ways:
    """Shortest ways along a surface to the nearest of its spots."""

    def __init__(self, surface: Surface, spots: Spots) -> None:
        held = surface.triangles[spots.triangles][spots.weights >= _AT]
        self._unfolding = _unfold(surface, held)
        self._marks = _mark(surface, spots)
        self._least = _LEAST * float(np.sqrt(surface.area / len(spots)))
        self._spots = spots

    def between_spots(self, straight: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        """As `from_places`, from every spot to the nearest other one."""
        return self._find(self._spots, straight, np.arange(len(self._spots)))

    def from_places(
        self, places: Spots, straight: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        """How far it is from places to the nearest spot, exactly, and where that is certain.

        straight : float64 (n,), how far it is through space, which also stands where the search was given up.
        Infinite where no spot can be reached.
        """
        inside = np.clip(places.weights, 1 - _AT, None)  # a way starts at a vertex only where a spot is there
        inside /= inside.sum(axis=1, keepdims=True)
        return self._find(Spots(places.triangles, inside), straight, np.full(len(places), -1))

    def _find(
        self, places: Spots, straight: NDArray[np.float64], own: NDArray[np.int64]
    ) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
        from tilewright.kernels.geodesics import find_nearest

        found, certain = np.empty(len(places)), np.empty(len(places), np.bool_)
        if len(places):
            edges = places.triangles * np.int64(3)
            weights = np.ascontiguousarray(places.weights, np.float64)
            reach = np.maximum(straight * _FARTHER, self._least)
            starts = (edges, weights, own, reach)
            find_nearest(len(places), self._unfolding, self._marks, *starts, _MOST, found, certain)
        return np.where(certain, np.maximum(found, straight), straight), certain


def _unfold(surface: Surface, held: NDArray[np.int32]) -> "Unfolding":
    """Lengths, third corners and fans of the triangles, and the vertices at which shortest ways may turn."""
    from tilewright.kernels.geodesics import Unfolding

    corners = surface.vertices[surface.triangles]
    sides = np.roll(corners, -1, axis=1) - corners
    lengths = np.linalg.norm(sides, axis=2)
    back = -np.roll(sides, 1, axis=1)
    along = np.einsum("tkd,tkd->tk", sides, back)
    aside = np.broadcast_to(2 * surface.areas[:, np.newaxis], along.shape)
    apexes = np.stack([along, aside], axis=2).reshape(-1, 2) / lengths.reshape(-1, 1) ** 2
    count = len(surface.vertices)
    around = surface.triangles.ravel()
    angles = np.bincount(around, np.arctan2(aside, along).ravel(), count)
    turning = angles > 2 * np.pi + _SADDLE
    border = surface.twins < 0
    turning[surface.triangles[border]] = True
    turning[np.roll(surface.triangles, -1, axis=1)[border]] = True
    turning[held] = True
    starts = np.concatenate([[0], np.cumsum(np.bincount(around, minlength=count))])
    return Unfolding(
        np.ascontiguousarray(surface.triangles, np.int32),
        np.ascontiguousarray(surface.twins, np.int32),
        lengths,
        apexes,
        turning,
        np.argsort(around, kind="stable"),
        starts,
    )


def _mark(surface: Surface, spots: Spots) -> "Marks":
    """Spots in the order of their triangles and of their first weights."""
    from tilewright.kernels.geodesics import Marks

    counts = np.bincount(spots.triangles, minlength=len(surface.triangles))
    order = np.lexsort((spots.weights[:, 0], spots.triangles))
    weights = np.ascontiguousarray(spots.weights[order], np.float64)
    return Marks(order, weights, np.concatenate([[0], np.cumsum(counts)]))
