"""Density over a mesh: where points are to lie closer, told by vertices, faces, a picture or a function."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_array, shape_error, type_error
from tilewright.domains import Mesh, Spots
from tilewright.domains.repair import SoundMesh
from tilewright.domains.spreading import spread_spots
from tilewright.errors import TilewrightTypeError, TilewrightValueError

Density = ArrayLike | Callable[[NDArray[np.float64]], ArrayLike]
"""Weights of the vertices (V,) or of the faces (F,), a picture (h, w), or a function of places (n, 3)."""


_PROBES = 65536
"""Spots over the whole surface at which the mean density is found."""
WIDEST = 16.0
"""How many times as far apart as on average points are wanted at most: at densities below 1 / 256."""


@dataclass(frozen=True, eq=False)
class Weighting:
    """How dense points are wanted at spots of a sound mesh, in any unit.

    Attributes
    ----------
    sound : SoundMesh
    given : callable or array
        A function of places, or what ``kind`` says.
    kind : str
        ``function``, ``corners`` (T, 3), ``faces`` (T,) or ``picture`` (h, w).
    texcoords : float64 array, shape (T, 3, 2), or None
        Texture coordinates of the corners of triangles, of pictures.
    """

    sound: SoundMesh
    given: Any
    kind: str
    texcoords: NDArray[np.float64] | None = None

    def __post_init__(self) -> None:
        if not self.mean > 0:
            raise TilewrightValueError("is 0 everywhere", argument="density", allowed="more than 0 somewhere")

    @cached_property
    def mean(self) -> float:
        """The mean over the whole surface, as many spots tell it."""
        return float(self.at(spread_spots(self.sound.cut.surface, _PROBES)).mean())

    @classmethod
    def of(cls, mesh: Mesh, sound: SoundMesh, density: Density) -> "Weighting":
        """What ``density`` says of a mesh; see `surface_points`."""
        if callable(density):
            return cls(sound, density, "function")
        values = as_array("density", density)
        if values.dtype.kind not in "iufb":
            raise type_error("density", density, "numbers or a function of places (n, 3)")
        values = values.astype(np.float64)
        _check(values)
        corners = sound.corner_numbers[sound.cut.corners]
        if values.ndim == 2:
            if mesh.texcoords is None:
                raise TilewrightValueError(
                    "is a picture, and the mesh has no texture coordinates", argument="density"
                )
            return cls(sound, values, "picture", mesh.texcoords[corners])
        if values.shape == (len(mesh.vertices),):
            return cls(sound, values[mesh.corners[corners]], "corners")
        if values.shape == (len(mesh),):
            return cls(sound, values[sound.face_numbers[sound.cut.faces]], "faces")
        expected = f"({len(mesh.vertices)},) for vertices, ({len(mesh)},) for faces, or (h, w) for a picture"
        raise shape_error("density", values.shape, expected)

    def at(self, spots: Spots) -> NDArray[np.float64]:
        """How dense at every spot, float64, shape (n,)."""
        if self.kind == "corners":
            return np.asarray((self.given[spots.triangles] * spots.weights).sum(axis=1))
        if self.kind == "faces":
            return np.asarray(self.given[spots.triangles])
        if self.kind == "picture":
            assert self.texcoords is not None
            uv = np.einsum("nk,nkd->nd", spots.weights, self.texcoords[spots.triangles])
            return _look_up(self.given, uv)
        places = spots.positions(self.sound.cut.surface)
        try:
            values = np.asarray(self.given(places), np.float64)
        except (TypeError, ValueError) as reason:
            raise TilewrightTypeError(
                f"does not take places (n, 3) and give numbers: {reason}", argument="density"
            ) from reason
        if values.shape != (len(places),):
            raise shape_error("density", values.shape, f"({len(places)},), one number for every place")
        _check(values)
        return values

    def spacing(self, spots: Spots) -> NDArray[np.float64]:
        """How far apart points are to lie at spots, over what is right where density is the mean."""
        with np.errstate(divide="ignore"):
            return np.minimum(np.sqrt(self.mean / self.at(spots)), WIDEST)


def _look_up(picture: NDArray[np.float64], uv: NDArray[np.float64]) -> NDArray[np.float64]:
    """The picture at texture coordinates, linear between pixels, repeated beyond 0 to 1; v runs up."""
    height, width = picture.shape
    x, y = uv[:, 0] * width - 0.5, (1 - uv[:, 1]) * height - 0.5
    column, row = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    right, down = x - column, y - row
    upper = _mix(picture[row % height, column % width], picture[row % height, (column + 1) % width], right)
    row = row + 1
    lower = _mix(picture[row % height, column % width], picture[row % height, (column + 1) % width], right)
    return _mix(upper, lower, down)


def _mix(a: NDArray[np.float64], b: NDArray[np.float64], share: NDArray[np.float64]) -> NDArray[np.float64]:
    return a + (b - a) * share


def _check(values: NDArray[np.float64]) -> None:
    if values.size == 0:
        raise TilewrightValueError("is empty", argument="density")
    if not np.isfinite(values).all() or values.min() < 0:
        raise TilewrightValueError(
            f"holds {values[~np.isfinite(values) | (values < 0)].flat[0]}; allowed are 0 and more",
            argument="density",
            allowed="0 and more",
        )
