"""Points on a surface and who they are."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.domains import Mesh, Spots, Surface
from tilewright.sameness import Alike
from tilewright.showing import describe, many
from tilewright.tabling import Tabled


@dataclass(frozen=True, eq=False)
class SurfacePoints(Alike, Tabled):
    """Points on a mesh: where they are, on what, and who they are.

    Attributes
    ----------
    mesh : Mesh
        The mesh as it came.
    surface : Surface
        Its triangles, on which ``spots`` lie: faces are fans from their first corners.
    spots : Spots
        The triangle and the weights of every point.
    faces : int64 array, shape (n,)
        The face of the mesh that each lies in.
    places : int64 array, shape (n,)
        The tile each comes from: faces of the subdivided mesh, then its vertices; -1 where none.
    numbers : int64 array, shape (n,)
        Its number in that tile. Place and number stay the same when fewer points are asked for.
    ranks : float32 array, shape (n,)
        From 0 up to 1: the points below d are a share of d of them, spread alike.
    moved : bool array, shape (n,)
        Whether it was put elsewhere, into a hole, rather than pushed from where its tile has it.
    distance : float
        No two points are closer, in a straight line, in the mesh's units; 0 where nothing is promised. With a
        density it is that of the densest place.
    figures : dict
        How they were made and what came of it, plain JSON values.
    notes : tuple of str
        What was mended in the mesh, and what could not be kept.

    See Also
    --------
    surface_points
    """

    mesh: Mesh
    surface: Surface
    spots: Spots
    faces: NDArray[np.int64]
    places: NDArray[np.int64]
    numbers: NDArray[np.int64]
    ranks: NDArray[np.float32]
    moved: NDArray[np.bool_]
    distance: float = 0.0
    figures: dict[str, Any] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.spots)

    def __repr__(self) -> str:
        return describe(self, many(len(self), "point"), f"distance {self.distance:.6g}")

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.positions, dtype, copy=copy)

    @property
    def positions(self) -> NDArray[np.float64]:
        """Where they are, in the mesh's coordinates, float64, shape (n, 3)."""
        return self.spots.positions(self.surface)

    @property
    def normals(self) -> NDArray[np.float64]:
        """The normals of their triangles, float64, shape (n, 3)."""
        return self.spots.normals(self.surface)

    def columns(self) -> dict[str, NDArray[Any]]:
        """Give the points and who they are as columns.

        Returns
        -------
        dict of str to array, shape (n,)
            ``x``, ``y``, ``z``; ``nx``, ``ny``, ``nz``; ``face``, ``triangle`` and weights ``w0``, ``w1``,
            ``w2``; ``place``, ``number``, ``rank``, ``moved``.
        """
        x, y, z = self.positions.T
        nx, ny, nz = self.normals.T
        w0, w1, w2 = self.spots.weights.T
        return {
            "x": x,
            "y": y,
            "z": z,
            "nx": nx,
            "ny": ny,
            "nz": nz,
            "face": self.faces,
            "triangle": self.spots.triangles,
            "w0": w0,
            "w1": w1,
            "w2": w2,
            "place": self.places,
            "number": self.numbers,
            "rank": self.ranks,
            "moved": self.moved,
        }

    def note(self) -> dict[str, Any]:
        """Say how they were made, as plain JSON values.

        Returns
        -------
        dict of str to value
            What ``figures`` holds, and the distance.
        """
        return {**self.figures, "distance": self.distance}
