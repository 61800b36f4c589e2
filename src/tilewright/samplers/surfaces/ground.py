"""What moving points need of a surface, and of each other."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.domains import Spots, Surface

_PIECE = 1.0
"""Length of pieces of the boundary, in spacings: short enough to be found by their middles."""


@dataclass(frozen=True, eq=False)
class Ground:
    """A surface to walk on.

    Attributes
    ----------
    surface : Surface
    slopes : float64 array, shape (T, 3, 3)
        By how much each weight of a triangle grows with x, y and z, within its plane.
    """

    surface: Surface
    slopes: NDArray[np.float64]

    @classmethod
    def of(cls, surface: Surface) -> "Ground":
        """The slopes of all triangles."""
        corners = surface.vertices[surface.triangles]
        sides = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
        slopes = np.cross(surface.normals[:, np.newaxis], sides)
        slopes /= 2 * surface.areas[:, np.newaxis, np.newaxis]
        return cls(surface, np.ascontiguousarray(slopes))

    def walk(self, spots: "Walkers", moving: NDArray[np.int32], moves: NDArray[np.float64]) -> None:
        """Move walkers by vectors in the planes of their triangles."""
        from tilewright.kernels.surface_walks import walk_all

        here = self.surface
        ground = (here.vertices, here.triangles, here.twins, self.slopes)
        walk_all(len(moving), moving, moves, ground, spots.triangles, spots.weights, spots.places)

    def walls(self, spacing: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Begins and ends (w, 3) of pieces of the boundary, which the surface lies left of."""
        triangle, side = np.nonzero(self.surface.twins < 0)
        begins = self.surface.vertices[self.surface.triangles[triangle, side]]
        ends = self.surface.vertices[self.surface.triangles[triangle, (side + 1) % 3]]
        counts = np.ceil(np.linalg.norm(ends - begins, axis=1) / (_PIECE * spacing)).astype(np.int64)
        counts = np.maximum(counts, 1)
        step = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        share = (step / np.repeat(counts, counts))[:, np.newaxis]
        along = np.repeat((ends - begins) / counts[:, np.newaxis], counts, axis=0)
        firsts = np.repeat(begins, counts, axis=0) + share * np.repeat(ends - begins, counts, axis=0)
        return firsts, firsts + along


@dataclass(frozen=True, eq=False)
class Walkers:
    """Spots that move: changed in place.

    Attributes
    ----------
    triangles : int32 array, shape (n,)
    weights, places : float64 array, shape (n, 3)
    """

    triangles: NDArray[np.int32]
    weights: NDArray[np.float64]
    places: NDArray[np.float64]

    @classmethod
    def of(cls, spots: Spots, surface: Surface) -> "Walkers":
        """Copies of spots."""
        weights = np.ascontiguousarray(spots.weights, np.float64).copy()
        return cls(spots.triangles.astype(np.int32), weights, spots.positions(surface))

    @property
    def spots(self) -> Spots:
        """Where they are."""
        return Spots(self.triangles.copy(), self.weights.copy())


def walk_spots(ground: Ground, spots: Spots, steps: NDArray[np.float64]) -> Spots:
    """Where spots come to lie that go straight along the surface, as far and where ``steps`` (n, 3) point.

    What points out of a triangle's plane is left out; along the boundary they slide.
    """
    normals = spots.normals(ground.surface)
    flat = steps - np.einsum("nd,nd->n", steps, normals)[:, np.newaxis] * normals
    walkers = Walkers.of(spots, ground.surface)
    ground.walk(walkers, np.arange(len(spots), dtype=np.int32), flat)
    return Spots(walkers.triangles, walkers.weights)


@dataclass(frozen=True, eq=False)
class Lists:
    """The nearest places around each of n others.

    Attributes
    ----------
    numbers : int32 array, shape (n, room)
    counts : int32 array, shape (n,)
    """

    numbers: NDArray[np.int32]
    counts: NDArray[np.int32]

    @classmethod
    def of(
        cls, queries: NDArray[np.float64], places: NDArray[np.float64], reach: NDArray[np.float64], room: int
    ) -> "Lists":
        """The nearest of ``places`` within ``reach`` of each query; none is its own neighbor."""
        from tilewright.kernels.surface_lists import list_neighbors

        numbers, counts = np.zeros((len(queries), room), np.int32), np.zeros(len(queries), np.int32)
        if len(places):
            both = places if queries is places else np.concatenate([queries, places])
            low = both.min(axis=0)
            # Cells as large as the reach, and not so many along a side that their numbers overflow.
            size = max(float(reach.max()), float(np.ptp(both, axis=0).max()) / 2**20)
            low = low - size  # so that the cells before the first have numbers too
            steps = ((both.max(axis=0) - low) / size).astype(np.int64) + 3
            cells = ((places - low) / size).astype(np.int64)
            keys = (cells[:, 2] * steps[1] + cells[:, 1]) * steps[0] + cells[:, 0]
            order = np.argsort(keys, kind="stable")
            there = (keys[order], order.astype(np.int32), places[order])
            grid = (low, size, steps)
            itself = queries is places
            rows = there[1] if itself else np.arange(len(queries), dtype=np.int32)
            list_neighbors(len(queries), queries, rows, grid, there, reach, itself, numbers, counts)
        return cls(numbers, counts)
