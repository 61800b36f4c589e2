"""How points cover a surface: its place that is farthest from them all, and their number by area."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.surfaces.geodesics import Ways
from tilewright.domains.spots import Spots
from tilewright.domains.spreading import spread_spots
from tilewright.domains.surface import Surface
from tilewright.samplers.surfaces.ground import Ground, walk_spots

if TYPE_CHECKING:
    from scipy.spatial import cKDTree

SAMPLES = 16
"""Places that are looked at for each point."""
_FEWEST, _MOST = 8_000, 4_000_000
_WORST, _ROUNDS, _DIRECTIONS = 32, 8, 6
"""How many of the worst places climb to where it is worse still, how often, in how many directions."""
_OTHER_SHEET = -0.2
"""Cosine of the angle of two normals below which points are taken to lie on different sheets."""
CELLS = 64
"""Cells of about equal area in which points are counted."""
_EXPECTED = 5
"""Points that a cell should have at least; for fewer points there are fewer cells."""


def look_around(surface: Surface, count: int) -> Spots:
    """Places even in area, 16 for each of ``count`` points."""
    return spread_spots(surface, min(max(SAMPLES * count, _FEWEST), _MOST))


class Holes:
    """How far places of a surface are from the nearest of its points.

    It is told in space, but along the surface where the nearest point in space is on another sheet of a thin
    part, as its normal shows.
    """

    def __init__(self, surface: Surface, spots: Spots, tree: "cKDTree", ways: Ways) -> None:
        self._surface, self._tree, self._ways = surface, tree, ways
        self._normals = spots.normals(surface)

    def widest(self, places: Spots) -> float:
        """The greatest distance, found among the places and by climbing from the worst of them."""
        distances = self._measure(places)
        worst = np.argsort(distances)[-_WORST:]
        return float(self._climb(places[worst], distances[worst], len(places)).max())

    def _measure(self, places: Spots) -> NDArray[np.float64]:
        distances, nearest = self._tree.query(places.positions(self._surface))
        facing = np.einsum("nd,nd->n", self._normals[nearest], places.normals(self._surface))
        beyond = np.flatnonzero(facing < _OTHER_SHEET)
        distances[beyond] = self._ways.from_places(places[beyond], distances[beyond])[0]
        return distances

    def _climb(self, places: Spots, distances: NDArray[np.float64], count: int) -> NDArray[np.float64]:
        """Distances after steps to whichever place around is worst, each half as long where none is worse."""
        surface = self._surface
        reach = np.full(len(places), np.sqrt(surface.area / count), np.float64)
        ground = Ground.of(surface)
        angles = np.arange(_DIRECTIONS) * (2 * np.pi / _DIRECTIONS)
        for _ in range(_ROUNDS):
            steps = _ring(places.normals(surface), angles) * reach[:, np.newaxis, np.newaxis]
            starts = Spots(places.triangles.repeat(_DIRECTIONS), places.weights.repeat(_DIRECTIONS, axis=0))
            ends = walk_spots(ground, starts, steps.reshape(-1, 3))
            found = self._measure(ends).reshape(-1, _DIRECTIONS)
            best = found.argmax(axis=1)
            farthest = found[np.arange(len(best)), best]
            worse = farthest > distances
            chosen = ends[np.arange(len(best)) * _DIRECTIONS + best]
            places = Spots(
                np.where(worse, chosen.triangles, places.triangles),
                np.where(worse[:, np.newaxis], chosen.weights, places.weights),
            )
            distances = np.maximum(distances, farthest)
            reach[~worse] /= 2
        return distances


def _ring(normals: NDArray[np.float64], angles: NDArray[np.floating]) -> NDArray[np.float64]:
    """Unit vectors around normals, float64 (n, angles, 3)."""
    least = np.eye(3)[np.abs(normals).argmin(axis=1)]
    first = np.cross(normals, least)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(normals, first)
    turns = np.column_stack([np.cos(angles), np.sin(angles)])
    return np.einsum("ak,knd->nad", turns, np.stack([first, second]))


_ASLANT = np.linalg.qr(np.array([(1.0, 0.31, -0.17), (0.0, 1.0, 0.43), (0.0, 0.0, 1.0)]).T)[0]
"""A turn that leaves no axis along another."""


def count_evenness(places: NDArray[np.float64], points: NDArray[np.float64]) -> float:
    """Mean over 64 cells of (count - expected)^2 / expected: random points have about 1.

    The cells halve the area six times, each time across their longest side; small sets have fewer. places :
    float64 (m, 3), even in area.
    """
    halvings = int(np.log2(max(2, min(CELLS, len(points) / _EXPECTED))))
    # Walls across an axis would lie on one side of every cut as a whole, so nothing is cut along the axes.
    cells = [(places @ _ASLANT, points @ _ASLANT)]
    for _ in range(halvings):
        cells = [half for cell in cells for half in _halve(*cell)]
    areas, counts = np.array([[len(a), len(b)] for a, b in cells], np.float64).T
    expected = areas * (len(points) / len(places))
    return float(((counts - expected) ** 2 / expected).mean())


def _halve(
    places: NDArray[np.float64], points: NDArray[np.float64]
) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    axis = int(np.ptp(places, axis=0).argmax())
    middle = np.median(places[:, axis])
    return [(places[s], points[p]) for s, p in _sides(places[:, axis], points[:, axis], middle)]


def _sides(
    places: NDArray[np.float64], points: NDArray[np.float64], middle: float
) -> list[tuple[NDArray[np.bool_], NDArray[np.bool_]]]:
    """Both sides of a cut; what lies on it, as a wall across the axis does, is on the first."""
    return [(places <= middle, points <= middle), (places > middle, points > middle)]
