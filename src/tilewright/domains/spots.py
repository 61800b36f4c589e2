"""Spots: places on a surface, each told by its triangle and its weights there."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.surface import Surface
from tilewright.sameness import Alike
from tilewright.showing import describe, many


@dataclass(frozen=True, eq=False)
class Spots(Alike):
    """Places on a surface.

    Attributes
    ----------
    triangles : int32 array, shape (n,)
        The triangle of the surface that each lies in.
    weights : float64 array, shape (n, 3)
        Barycentric coordinates: how much of each corner; at least 0, and 1 in all.
    """

    triangles: NDArray[np.int32]
    weights: NDArray[np.float64]

    def __repr__(self) -> str:
        return describe(self, many(len(self), "spot"))

    def __len__(self) -> int:
        return len(self.triangles)

    def __getitem__(self, which: NDArray[np.intp] | NDArray[np.bool_] | slice) -> "Spots":
        return Spots(self.triangles[which], self.weights[which])

    def positions(self, surface: Surface) -> NDArray[np.float64]:
        """Tell where they are in space.

        Parameters
        ----------
        surface : Surface
            The surface that they lie on.

        Returns
        -------
        float64 array, shape (n, 3)
            Positions, in the units of its vertices.
        """
        corners = surface.vertices[surface.triangles[self.triangles]]
        return np.einsum("nk,nkd->nd", self.weights, corners)

    def normals(self, surface: Surface) -> NDArray[np.float64]:
        """Tell the normals of their triangles.

        Parameters
        ----------
        surface : Surface
            The surface that they lie on.

        Returns
        -------
        float64 array, shape (n, 3)
            Outward unit normals.
        """
        return surface.normals[self.triangles]
