"""Meshes as people bring them: vertices, and faces of any number of corners."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_array, as_integers, shape_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.sameness import Alike
from tilewright.showing import describe, many


@dataclass(frozen=True, eq=False)
class Mesh(Alike):
    """A polygon mesh: triangles, quads and larger faces, mixed as they come.

    Attributes
    ----------
    vertices : float64 array, shape (V, 3)
        Places of the vertices, in the units of whoever made the mesh.
    corners : int64 array, shape (H,)
        The vertices of all faces one after another, each counter-clockwise as seen from outside.
    starts : int64 array, shape (F + 1,)
        Where the corners of each face start and end.
    texcoords : float64 array, shape (H, 2), or None
        Texture coordinates of every corner: u to the right and v up, 0 to 1 within the picture.

    Raises
    ------
    TilewrightTypeError
        Something else than numbers.
    TilewrightValueError
        No faces, a face of fewer than three corners, NaN, a corner that names no vertex.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.Mesh.of([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
    <Mesh: 4 vertices, 1 face, of 4 corners>
    """

    vertices: NDArray[np.float64]
    corners: NDArray[np.int64]
    starts: NDArray[np.int64]
    texcoords: NDArray[np.float64] | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "vertices", _as_vertices(self.vertices))
        for name in ("corners", "starts"):
            values = np.ascontiguousarray(as_integers(name, getattr(self, name)), np.int64)
            if values.ndim != 1:
                raise shape_error(name, values.shape, "one axis")
            object.__setattr__(self, name, values)
        self._check_faces()
        if self.texcoords is not None:
            coords = np.ascontiguousarray(as_array("texcoords", self.texcoords), np.float64)
            if coords.shape != (len(self.corners), 2):
                raise shape_error("texcoords", coords.shape, (len(self.corners), 2))
            object.__setattr__(self, "texcoords", coords)

    def _check_faces(self) -> None:
        sizes = np.diff(self.starts)
        if len(sizes) == 0:
            raise TilewrightValueError("has no faces", argument="mesh", allowed="one face or more")
        if self.starts[0] != 0 or self.starts[-1] != len(self.corners):
            raise TilewrightValueError(
                f"must rise from 0 to the number of corners, {len(self.corners)}", argument="starts"
            )
        if (sizes < 3).any():
            face = int(np.argmax(sizes < 3))
            raise TilewrightValueError(
                f"has {many(int(sizes[face]), 'corner')}; a face has three or more",
                argument=f"faces[{face}]",
                value=int(sizes[face]),
                allowed="three corners or more",
            )
        wrong = (self.corners < 0) | (self.corners >= len(self.vertices))
        if wrong.any():
            corner = int(np.argmax(wrong))
            face = int(np.searchsorted(self.starts, corner, side="right")) - 1
            raise TilewrightValueError(
                f"names vertex {self.corners[corner]}; there are {len(self.vertices)}, numbered from 0",
                argument=f"faces[{face}]",
                value=int(self.corners[corner]),
                allowed=f"0 to {len(self.vertices) - 1}",
            )

    @classmethod
    def of(cls, vertices: ArrayLike, faces: ArrayLike | Sequence[Sequence[int]]) -> "Mesh":
        """Make a mesh from vertices and faces.

        Parameters
        ----------
        vertices : array_like of float, shape (V, 3)
            Places of the vertices.
        faces : array_like of int, shape (F, k), or list of sequences of int
            The vertices of each face, numbered from 0, counter-clockwise as seen from outside.

        Returns
        -------
        Mesh
            The mesh, without texture coordinates.

        Raises
        ------
        TilewrightTypeError
            Faces that are no rows of numbers, vertices that are no numbers.
        TilewrightValueError
            As `Mesh` raises it.
        """
        if isinstance(faces, np.ndarray) and faces.ndim == 2:
            corners = as_integers("faces", faces)
            return cls(vertices, corners.ravel(), np.arange(len(corners) + 1) * corners.shape[1])  # type: ignore[arg-type]
        try:
            rows: list[Any] = [list(face) for face in faces]  # type: ignore[union-attr,arg-type]
        except TypeError:
            raise TilewrightTypeError(
                "must be a table of vertex numbers or a list of such rows", argument="faces", value=faces
            ) from None
        starts = np.concatenate([[0], np.cumsum([len(row) for row in rows], dtype=np.int64)])
        return cls(vertices, as_integers("faces", list(chain.from_iterable(rows))), starts)  # type: ignore[arg-type]

    @property
    def sizes(self) -> NDArray[np.int64]:
        """How many corners every face has, int64, shape (F,)."""
        return np.diff(self.starts)

    @property
    def faces(self) -> list[NDArray[np.int64]]:
        """The vertices of every face."""
        return np.split(self.corners, self.starts[1:-1])

    def __len__(self) -> int:
        return len(self.starts) - 1

    def __repr__(self) -> str:
        sizes = sorted(set(self.sizes.tolist()))
        of = f"of {sizes[0]} corners" if len(sizes) == 1 else f"of {sizes[0]} to {sizes[-1]} corners"
        return describe(self, many(len(self.vertices), "vertex", "vertices"), many(len(self), "face"), of)


def _as_vertices(given: Any) -> NDArray[np.float64]:
    """Vertices as numbers, all of them finite."""
    values = as_array("vertices", given)
    if values.dtype.kind not in "iuf":
        raise TilewrightTypeError(
            "must hold numbers", argument="vertices", value=values.dtype, allowed="numbers"
        )
    if values.ndim != 2 or values.shape[1] != 3:
        raise shape_error("vertices", values.shape, "(V, 3)")
    bad = ~np.isfinite(values).all(axis=1)
    if bad.any():
        vertex = int(np.argmax(bad))
        raise TilewrightValueError(
            f"is at {values[vertex].tolist()}; all coordinates must be finite",
            argument=f"vertices[{vertex}]",
            allowed="finite numbers",
        )
    return np.ascontiguousarray(values, np.float64)
