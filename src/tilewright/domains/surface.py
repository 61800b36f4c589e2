"""Surfaces: meshes made fit to walk on, as triangles that know their neighbors."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tilewright.showing import describe, many


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles that know their neighbors: every edge has one triangle or two, turned alike.

    Attributes
    ----------
    vertices : float64 array, shape (V, 3)
        Places of the vertices.
    triangles : int32 array, shape (T, 3)
        The vertices of each triangle, counter-clockwise as seen from outside; none has area 0.
    twins : int32 array, shape (T, 3)
        What lies across the edge from corner k to corner k + 1 of triangle t: 3 u + j of the triangle u whose
        edge j is the same, from its other end; -1 on the boundary.
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int32]
    twins: NDArray[np.int32]

    def __repr__(self) -> str:
        vertices = many(len(self.vertices), "vertex", "vertices")
        return describe(self, vertices, many(len(self.triangles), "triangle"))

    @cached_property
    def _doubled(self) -> NDArray[np.float64]:
        a, b, c = (self.vertices[self.triangles[:, k]] for k in range(3))
        return np.cross(b - a, c - a)

    @cached_property
    def areas(self) -> NDArray[np.float64]:
        """Area of every triangle, float64, shape (T,)."""
        return np.linalg.norm(self._doubled, axis=1) / 2

    @cached_property
    def normals(self) -> NDArray[np.float64]:
        """Outward unit normal of every triangle, float64, shape (T, 3)."""
        return self._doubled / (2 * self.areas[:, np.newaxis])

    @property
    def area(self) -> float:
        """Area of all."""
        return float(self.areas.sum())
