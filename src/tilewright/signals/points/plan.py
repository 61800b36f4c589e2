"""What is to be built, and the points of its parts while it is being built."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius
from tilewright.seeds import derive_key
from tilewright.signals.points.anatomy import (
    INTERIOR,
    LARGEST_RADIUS,
    OFFSETS,
    Anatomy,
    Regions,
    anatomy_of,
)
from tilewright.tiles import TileSet

if TYPE_CHECKING:
    from tilewright.kernels.growth import Frame

_SLACK = 1e-5
"""How much farther apart points are built than promised, as a share. Rounding to float32 takes away up to
1e-7 of a tile, which is 2e-6 of the distance of 256 points at rho 0.75."""
SWEEPS = 400
"""Rounds of pushing points apart, after which they count as stuck. 100 gave the same sets at rho 0.7; at 0.85
their spikes (see balance.py) were as high, 3.13 and 3.09."""


@dataclass(frozen=True, eq=False)
class Plan:
    """The settings of a construction.

    Attributes
    ----------
    points : int
        Points per tile, N.
    distance : float
        The least distance, 2 rho r_max and a little more, in tile lengths.
    key : uint64
        What chance is derived from.
    lloyd : int
        Iterations of Lloyd's method for every part.
    """

    tiles: TileSet
    anatomy: Anatomy
    regions: Regions
    points: int
    distance: float
    variants: int
    key: np.uint64
    lloyd: int

    @classmethod
    def of(
        cls, tiles: TileSet, points: int, rho: float, variants: int, key: np.uint64, shape: str, lloyd: int
    ) -> "Plan":
        """A plan, or an error where the disks are too large for a tile."""
        distance = 2 * rho * max_radius(points, Box()) * (1 + _SLACK)
        largest = LARGEST_RADIUS / max_radius(points, Box()) / (1 + _SLACK)
        if rho > largest:
            raise TilewrightValueError(
                f"is {rho}; with {points} points disks are too large for a tile beyond "
                f"{int(100 * largest) / 100}",
                argument="rho",
                value=rho,
                advice="ask for more points per tile or less rho",
            )
        return cls(
            tiles, anatomy_of(tiles), Regions(distance / 2, shape), points, distance, variants, key, lloyd
        )

    @property
    def colors(self) -> int:
        """How many different points a place of the coarsest parts averages over: C of the tile set."""
        return int(min(self.tiles.colors))

    @property
    def shape_settings(self) -> tuple[float, bool]:
        """Radius and kind of region, as kernels take them."""
        return self.regions.radius, self.regions.is_cusp


@dataclass(eq=False)
class Parts:
    """Points of all frame items and interiors.

    Attributes
    ----------
    frame : float64 array, shape (items, slots, 2), as seen from each item's lattice point.
    frame_counts : int32 array, shape (items,)
    inner : float64 array, shape (T V, slots, 2)
    inner_counts : int32 array, shape (T V,)
    """

    frame: NDArray[np.float64]
    frame_counts: NDArray[np.int32]
    inner: NDArray[np.float64]
    inner_counts: NDArray[np.int32]

    @classmethod
    def empty(cls, plan: Plan) -> "Parts":
        """No points yet, and room for as many as can come."""
        items, interiors = len(plan.anatomy.kinds), len(plan.tiles) * plan.variants
        room = min(plan.points + 1, 8 + plan.points // 2)
        return cls(
            np.zeros((items, room, 2)),
            np.zeros(items, np.int32),
            np.zeros((interiors, plan.points, 2)),
            np.zeros(interiors, np.int32),
        )

    def copy(self) -> "Parts":
        """The same points, to go back to."""
        return Parts(self.frame.copy(), self.frame_counts.copy(), self.inner.copy(), self.inner_counts.copy())

    def take(self, other: "Parts") -> None:
        """Go back to other points."""
        self.frame, self.frame_counts = other.frame, other.frame_counts
        self.inner, self.inner_counts = other.inner, other.inner_counts

    @property
    def frame_slots(self) -> NDArray[np.bool_]:
        """Which places of `frame` hold points."""
        return np.arange(self.frame.shape[1]) < self.frame_counts[:, np.newaxis]

    @property
    def inner_slots(self) -> NDArray[np.bool_]:
        """Which places of `inner` hold points."""
        return np.arange(self.inner.shape[1]) < self.inner_counts[:, np.newaxis]

    def frame_around(self, items: NDArray[np.int32]) -> "Frame":
        """The frame points as kernels take them, for tiles of the given items."""
        from tilewright.kernels.growth import Frame

        return Frame(items, OFFSETS, self.frame, self.frame_counts)

    def all_points(self, plan: Plan) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Every point of the set once, and how often it occurs for each tile: (P, 2) and (P,)."""
        per_item = np.repeat(plan.anatomy.weights, self.frame_counts)
        per_inner = np.full(int(self.inner_counts.sum()), 1 / len(self.inner))
        points = np.concatenate([self.frame[self.frame_slots], self.inner[self.inner_slots]])
        return points, np.concatenate([per_item, per_inner])

    def tile_points(self, plan: Plan) -> tuple[list[NDArray[np.float64]], list[NDArray[np.int64]]]:
        """The points inside each tile and variant, and numbers that tell which of them are the same ones."""
        frame_numbers = np.cumsum(self.frame_slots.ravel()).reshape(self.frame_slots.shape) - 1
        number = int(self.frame_counts.sum())
        rows, classes = [], []
        for m in range(len(self.inner)):
            items = plan.anatomy.items[m // plan.variants]
            slots = self.frame_slots[items]
            frame = (self.frame[items] + OFFSETS[:, np.newaxis])[slots]
            inside = ((frame >= 0) & (frame < 1)).all(axis=1)
            n = self.inner_counts[m]
            rows.append(np.concatenate([frame[inside], self.inner[m, :n]]))
            classes.append(np.concatenate([frame_numbers[items][slots][inside], number + np.arange(n)]))
            number += n
        return rows, classes


def fill_interiors(plan: Plan, parts: Parts, which: NDArray[np.intp], round: int, attempts: int) -> int:
    """Fill some interiors anew so that their tiles hold the planned number of points; how many failed."""
    from tilewright.kernels.growth import Effort, grow_interiors

    keys = np.array([derive_key(plan.key, INTERIOR, round, int(m)) for m in which], np.uint64)
    inner = np.zeros((len(which), *parts.inner.shape[1:]))
    counts = np.zeros(len(which), np.int32)
    frame = parts.frame_around(plan.anatomy.items[which // plan.variants])
    effort = Effort(plan.distance, plan.lloyd, attempts, SWEEPS)
    grow_interiors(len(keys), keys, frame, plan.points, *plan.shape_settings, effort, inner, counts)
    made = counts >= 0
    parts.inner[which[made]] = inner[made]
    parts.inner_counts[which[made]] = counts[made]
    return int((~made).sum())
