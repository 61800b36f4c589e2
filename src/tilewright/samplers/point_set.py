"""What every sampler answers: points in a box, and what is promised about them."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius, relative_radius
from tilewright.showing import Shown, describe, many
from tilewright.tabling import Tabled


@dataclass(frozen=True, eq=False)
class PointSet(Shown, Tabled):
    """Points of a box, and what is promised about them: the answer of every sampler.

    Attributes
    ----------
    points : float64 array, shape (N, d)
        Coordinates, x first; 0 <= points < box.extent.
    box : Box
        The domain; by default the unit torus.
    method : str
        Name of the method that made them; default ``"given"``.
    distance : float
        No two points are closer, but for rounding; 0, the default, where the method promises nothing.
    figures : dict
        What else the method has to say: iterations, darts thrown, whether the set is maximal; by default
        nothing.

    Notes
    -----
    Lagae 2007, section 4.2.1, defines the distributions; section 4.2.3 the relative radius ``rho``.

    Examples
    --------
    >>> import tilewright as tw
    >>> grid = tw.PointSet([[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]])
    >>> round(grid.rho, 4)
    0.9306
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

    def columns(self) -> dict[str, NDArray[Any]]:
        """Give the coordinates as columns.

        Returns
        -------
        dict of str to float64 array, shape (N,)
            ``x``, ``y`` and in volumes ``z``.
        """
        return dict(zip("xyz", np.asarray(self.points).T, strict=False))

    @property
    def max_radius(self) -> float:
        """Radius r_max of the densest packing of as many disks in the box; see `max_radius`."""
        return max_radius(len(self.points), self.box)

    @property
    def rho(self) -> float:
        """The relative radius, measured; see `relative_radius`."""
        return relative_radius(self.points, self.box)
