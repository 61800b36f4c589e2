"""How the vectors that move Penrose points are made.

``tools/make_penrose_vectors.py`` makes the stored table again. The vectors are those of
Lloyd's relaxation, each the mean over all points with the same indices
(Ostromoukhov, Donohue & Jodoin 2004). Means alone leave relative radii of 0.50 to 0.72; so points that are
still too close are then pushed apart, again by means over the indices, in which the closest pairs count most.
"""

from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.lloyd import centroids
from tilewright.samplers.penrose import (
    INDICES,
    PHI,
    STRUCTURES,
    TURNS,
    Samples,
    Window,
    find_samples,
)
from tilewright.samplers.radius import max_radius

_SQUARE = Box(torus=False)
_LEVEL = 18
_SHARES = (0.004, 0.2, 0.4, 0.6, 0.8, 0.996)
"""Where in the range of an importance index the densities lie whose vectors are made."""
_STEPS = 300
_STEP = 0.5


def relax_vectors(
    *, iterations: int = 16, rho: float = 0.76, progress: Progress | None = None
) -> NDArray[np.float64]:
    """The table of vectors, in scales in the frame of a point's tile.

    Parameters
    ----------
    iterations : int
        Of Lloyd's relaxation.
    rho : float
        Relative radius up to which points are pushed apart afterwards.
    progress : callable, optional

    Returns
    -------
    float64 array, shape (21, 21, 2)
        For each importance index and structural index, x first; 0 for structures that are not kept.
    """
    table = np.zeros((INDICES, STRUCTURES, 2))
    for index in range(INDICES):
        if progress is not None:
            progress(index, INDICES, "relaxing vectors")
        table[index] = relax_index(index, iterations, rho)
    return table


def relax_index(index: int, iterations: int = 16, rho: float = 0.76) -> NDArray[np.float64]:
    """The vectors of one importance index, shape (21, 2)."""
    window = Window.choose(_SQUARE, 0)
    samples = find_samples(window, _LEVEL)
    patches = [Patch.of(samples, window, index, share) for share in _SHARES]
    vectors = np.zeros(STRUCTURES, np.complex128)
    for _ in range(iterations):
        vectors += _mean([p.lloyd_moves(vectors) for p in patches])
    for _ in range(_STEPS):
        moves = [p.push_moves(vectors, rho) for p in patches]
        if not any(len(m.structures) for m in moves):
            break
        vectors += _STEP * _mean(moves)
    return np.stack([vectors.real, vectors.imag], axis=-1)


@dataclass(frozen=True, eq=False)
class Moves:
    """How points would move, in the frames of their tiles, and how much each counts."""

    structures: NDArray[np.int64]
    moves: NDArray[np.complex128]
    weights: NDArray[np.float64]


def _mean(moves: list[Moves]) -> NDArray[np.complex128]:
    """Weighted mean of the moves of each structural index."""
    structures = np.concatenate([m.structures for m in moves])
    weights = np.concatenate([m.weights for m in moves])
    each = np.concatenate([m.moves for m in moves]) * weights
    x, y, total = (np.bincount(structures, w, STRUCTURES) for w in (each.real, each.imag, weights))
    mean = np.zeros(STRUCTURES, np.complex128)
    np.divide(x + 1j * y, total, out=mean, where=total > 0)
    return mean


@dataclass(frozen=True, eq=False)
class Patch:
    """The samples of one density in the unit square.

    Those near its border see no neighbors outside and do not count. ``radius`` is r_max of the density.
    """

    points: NDArray[np.complex128]
    frames: NDArray[np.complex128]
    structures: NDArray[np.int64]
    counted: NDArray[np.bool_]
    radius: float

    @classmethod
    def of(cls, samples: Samples, window: Window, index: int, share: float) -> "Patch":
        """The density at a share of the range of an importance index, at the level of the samples."""
        importance = int((PHI ** (2 * (_LEVEL + (index + share) / INDICES)) - 1) / sqrt(5))
        radius = max_radius(round(importance / window.importance_each), _SQUARE)
        kept = slice(0, samples.kept(importance))
        points, structures = samples.points[kept], samples.structures[kept]
        border = 6 * samples.scale
        inside = (np.abs(points.real - 0.5) < 0.5 - border) & (np.abs(points.imag - 0.5) < 0.5 - border)
        return cls(points, TURNS[samples.directions[kept]] * samples.scale, structures, inside, radius)

    def placed(self, vectors: NDArray[np.complex128]) -> NDArray[np.complex128]:
        """The points moved by the vectors of their structures."""
        return self.points + vectors[self.structures] * self.frames

    def lloyd_moves(self, vectors: NDArray[np.complex128]) -> Moves:
        """From where the vectors put the points to the middles of their Voronoi cells."""
        placed = self.placed(vectors)
        inside = (np.abs(placed.real - 0.5) < 0.5) & (np.abs(placed.imag - 0.5) < 0.5)
        middles = placed.copy()
        pairs = np.stack([placed.real, placed.imag], axis=1)[inside]
        middles[inside] = centroids(pairs, _SQUARE)[0] @ np.array([1, 1j])
        moves = ((middles - placed) / self.frames)[self.counted]
        return Moves(self.structures[self.counted], moves, np.ones(len(moves)))

    def push_moves(self, vectors: NDArray[np.complex128], rho: float) -> Moves:
        """Apart, for pairs that are closer than 2 rho r_max."""
        from scipy.spatial import cKDTree

        placed, distance = self.placed(vectors), 2 * rho * self.radius
        tree = cKDTree(np.stack([placed.real, placed.imag], axis=1))
        pairs = tree.query_pairs(distance, output_type="ndarray")
        pairs = pairs[self.counted[pairs].all(axis=1)]
        gaps = placed[pairs[:, 0]] - placed[pairs[:, 1]]
        missing = distance - np.abs(gaps)
        moves = missing / 2 * gaps / np.abs(gaps)
        both = np.concatenate([pairs[:, 0], pairs[:, 1]])
        return Moves(
            self.structures[both],
            np.concatenate([moves, -moves]) / self.frames[both],
            np.concatenate([missing, missing]),
        )
