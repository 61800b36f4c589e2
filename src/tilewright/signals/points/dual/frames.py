"""Frames: what tiles of a dual set share, an octagon about every corner and a strip along every side.

Interiors of tiles that touch are a least distance apart, so frames settle all that may come too close (Li et
al. 2010, sections III.A and III.B).
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.seeds import derive_key
from tilewright.signals.points.dual.places import in_octagon, rotate, to_plane, to_polar

_CORNER, _EDGE = 1, 2
_ATTEMPTS = 50
_AROUND = 0.9
"""Half width of the square that a corner is cut from the middle of."""
_OCTAGON = (1 + np.sqrt(2)) / 2
"""Half width of an octagon of side 1."""


@dataclass(eq=False)
class Frames:
    """The octagons and strips of a set, made when first asked for.

    Attributes
    ----------
    colors : int
    points : int
        Points in a square of side 1.
    distance : float
        The least distance of points.
    key : uint64
    """

    colors: int
    points: int
    distance: float
    key: np.uint64
    corners: dict[int, NDArray[np.float64]] = field(default_factory=dict)
    edges: dict[tuple[int, int], NDArray[np.float64]] = field(default_factory=dict)

    @property
    def corner_half(self) -> float:
        """Half width of an octagon, whose sides are as long as the least distance."""
        return _OCTAGON * self.distance

    @property
    def strip_half(self) -> float:
        """Half thickness of a strip."""
        return self.distance / 2

    def corner(self, color: int) -> NDArray[np.float64]:
        """The points of the octagon of a color, about (0, 0)."""
        if color not in self.corners:
            shape = (_AROUND, _AROUND, 0.0, 0.0)
            count = round(self.points * (2 * _AROUND) ** 2)
            made = to_plane(self.fill(4, shape, np.zeros((0, 2)), count, False, _CORNER, color))
            self.corners[color] = made[in_octagon(made, self.corner_half)]
        return self.corners[color]

    def edge(self, here: int, there: int) -> NDArray[np.float64]:
        """The points of a strip from a corner at (0, 0) to one at (1, 0), told by what they show along it.

        ``here`` is the first corner's slot seen along the strip, ``there`` the second's seen back along it.
        Seen from its other end it is the same strip.
        """
        if here > there:
            return np.array([(1.0, 0.0)]) - self.edge(there, here)
        if (here, there) not in self.edges:
            self.edges[here, there] = self._make_edge(here, there)
        return self.edges[here, there]

    def turned_corner(self, slot: int) -> NDArray[np.float64]:
        """The points of the octagon of a corner that shows a slot along the x axis."""
        return rotate(self.corner(slot // 4), slot % 4)

    def _make_edge(self, here: int, there: int) -> NDArray[np.float64]:
        # Step 1: both corners in their places, seen from the middle of the side.
        ends = [
            self.turned_corner(here) - np.array([(0.5, 0)]),
            rotate(self.turned_corner(there), 2) + np.array([(0.5, 0)]),
        ]
        fixed = to_polar(np.concatenate(ends))
        # Step 2: the rest of a rectangle about both; in twos where the strip is its own half turn (figure 6).
        half = (1.3, 0.8)
        count = round(self.points * 4 * half[0] * half[1]) - len(fixed)
        paired = here == there
        count -= count % 2 if paired else 0
        shape = (*half, self.corner_half, self.strip_half)
        made = to_plane(self.fill(4, shape, fixed, count, paired, _EDGE, here, there)[len(fixed) :])
        # Step 3: the strip is cut out.
        inside = (np.abs(made[:, 1]) < self.strip_half) & (np.abs(made[:, 0]) < 0.5)
        return made[inside] + np.array([(0.5, 0)])

    def fill(
        self,
        corners: int,
        shape: tuple[float, float, float, float],
        fixed: NDArray[np.float64],
        count: int,
        paired: bool,
        *path: int,
    ) -> NDArray[np.float64]:
        """Places on the cone of so many quarter turns: ``fixed``, and ``count`` more that keep apart."""
        from tilewright.kernels.cones import fill_cone

        places = np.zeros((len(fixed) + count, 2))
        places[: len(fixed)] = fixed
        turn = corners * np.pi / 2
        for attempt in range(_ATTEMPTS):
            key = derive_key(self.key, *path, attempt)
            if fill_cone(key, turn, shape, len(fixed), len(places), paired, self.distance, places):
                return places
        raise TilewrightValueError(
            f"no way was found to keep points {self.distance:.4f} tiles apart", advice="ask for less rho"
        )
