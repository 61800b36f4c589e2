"""Where the vertices of a surface come to lie on a picture, seen from afar."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.surface import Surface

_MARGIN = 0.05
"""Part of the picture that is left free on each side."""
_AXES = {
    "y": ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    "z": ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0)),
}
"""To the right, up and towards the eye, at azimuth 0 and elevation 0."""


class Camera(NamedTuple):
    """Parallel rays from the eye.

    Attributes
    ----------
    frame : float64 array, shape (3, 3)
        Unit vectors in space: to the right, up, and towards the eye.
    middle : float64 array, shape (3,)
        What is seen in the middle of the picture, in this frame.
    scale : float
        Pixels for each unit of length.
    """

    frame: NDArray[np.float64]
    middle: NDArray[np.float64]
    scale: float

    def project(self, points: NDArray[np.float64], width: int, height: int) -> NDArray[np.float64]:
        """Of points in space x and y in pixels, y downwards, and height towards the eye."""
        seen = (points @ self.frame.T - self.middle) * self.scale
        return seen * (1, -1, 1) + (width / 2, height / 2, 0)


def aim(surface: Surface, width: int, height: int, view: tuple[float, float], up: str) -> Camera:
    """Look from a direction, so that all of the surface fits into the picture."""
    azimuth, elevation = np.radians(view)
    right, above, ahead = map(np.array, _AXES[up])
    around = np.cos(azimuth) * ahead + np.sin(azimuth) * right
    aside = np.cos(azimuth) * right - np.sin(azimuth) * ahead
    eye = np.cos(elevation) * around + np.sin(elevation) * above
    frame = np.stack([aside, np.cos(elevation) * above - np.sin(elevation) * around, eye])
    seen = surface.vertices[np.unique(surface.triangles)] @ frame.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    room = (1 - 2 * _MARGIN) * np.array([width, height])
    return Camera(frame, (low + high) / 2, float((room / np.maximum(high - low, 1e-300)[:2]).min()))
