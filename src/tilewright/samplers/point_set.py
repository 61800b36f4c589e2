"""What every sampler answers: points in a box, and what is promised about them."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius, relative_radius
from tilewright.showing import Shown, describe, many


@dataclass(frozen=True, eq=False)
class PointSet(Shown):
    """Points of a box.

    Attributes
    ----------
    points : float64 array, shape (N, d)
        x first; 0 <= points < box.extent.
    box : Box
    method : str
        Name of the method that made them.
    distance : float
        No two points are closer, but for rounding; 0 where the method promises nothing.
    figures : dict
        What else the method has to say: iterations, darts thrown, whether the set is maximal.
    """

    points: NDArray[np.float64]
    box: Box = field(default_factory=Box)
    method: str = "given"
    distance: float = 0.0
    figures: dict[str, Any] = field(default_factory=dict)

    def __repr__(self) -> str:
        size = " x ".join(f"{side:g}" for side in self.box.extent)
        kind = "torus" if self.box.torus else "box"
        return describe(self, many(len(self), "point"), f"{kind} {size}", f"method {self.method}")

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.points, dtype, copy=copy)

    def __len__(self) -> int:
        return len(self.points)

    @property
    def max_radius(self) -> float:
        """r_max of so many points in the box."""
        return max_radius(len(self.points), self.box)

    @property
    def rho(self) -> float:
        """The relative radius, measured."""
        return relative_radius(self.points, self.box)
