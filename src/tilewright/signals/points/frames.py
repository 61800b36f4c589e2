"""Frames: the corner regions and edge strips of a set, grown one kind after the other.

Corner tiles: corners first, then each edge between its two corners (Lagae & Dutré 2006, section 7.1).
Crossed Wang tiles: edges first, then each corner between its four edges (Lagae 2007, section 4.3).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress, TilewrightValueError
from tilewright.seeds import derive_key
from tilewright.signals.points.anatomy import COLUMN_EDGE, CORNER_PART, ROW_EDGE
from tilewright.signals.points.plan import SWEEPS, Parts, Plan
from tilewright.tiles import CORNER

# What was seen when a number was changed is told by the same figure as in balance.py: 2.33 as the numbers
# stand, with a spread of 0.08 from set to set.
_ATTEMPTS = 20
"""Times that a torus is filled anew when its points do not come apart. With 2 the same sets come out, at rho
0.7 and 0.85: it takes hardly ever more than one."""
_ROUNDS = 8
"""Times that all candidates that failed are grown again, from other keys; after the last rho is too much."""
_POOL = 192
"""Candidates that all items of the first kind share. 96 and 384 make no difference."""
_CANDIDATES = 10
"""Candidates for each item of a later kind. With 1 spikes are at 2.45; 5 and 20 make no difference."""
_RASTER = 512
"""Pixels along a tile of the masks whose spectrum stands for an even density. 64 gave the same set."""
_WIDTH = 0.55
"""Width of the weights that low frequencies have in a choice, in units of the square root of the points per
tile times the colors: a little more than half the frequency of the mean spacing of all these points."""
_REACH = 2.6
"""How many of these widths frequencies are looked at: there the weight is exp(-2.6^2) = 0.001."""
_UNEVEN = 1.0
"""Points by which half a part may hold more or less than half of what is fair, without a penalty."""
_DESCENTS = 4
"""Rounds of choosing anew for each item in turn, given the choices for the others."""


@dataclass(frozen=True, eq=False)
class Batch:
    """Candidates for items of one kind.

    Attributes
    ----------
    kind : int
    items : int array, shape (n,)
    owners : int array, shape (m,)
        Row of ``items`` each candidate was grown for; -1 where any may take it.
    points : float64 array, shape (m, slots, 2)
    counts : int32 array, shape (m,)
    """

    kind: int
    items: NDArray[np.intp]
    owners: NDArray[np.intp]
    points: NDArray[np.float64]
    counts: NDArray[np.int32]


def grow_frame(plan: Plan, parts: Parts, *, choose: bool, progress: Progress | None = None) -> None:
    """Grow all frame items; with ``choose`` the best of several candidates for each, see `Chooser`."""
    # Step 1: which parts come first: corners (Lagae & Dutré 2006, 7.1) or edges (Lagae 2007, 4.3).
    kinds = (CORNER_PART, ROW_EDGE, COLUMN_EDGE)
    order = kinds if plan.tiles.shape is CORNER else (ROW_EDGE, COLUMN_EDGE, CORNER_PART)
    first = order[:1] if plan.tiles.shape is CORNER else order[:2]
    chooser = Chooser(plan) if choose else None
    for step, kind in enumerate(order):
        if progress is not None:
            progress(step, len(order), "growing the frame")
        # Step 2: candidates for all parts of a kind, between the parts that are there already.
        batch = _grow_kind(plan, parts, kind, kind in first, choose)
        # Step 3: one of them for each part, which from now on is fixed.
        chosen = _first_of_each(batch) if chooser is None else chooser.choose(batch)
        parts.frame[batch.items, : batch.points.shape[1]] = batch.points[chosen]
        parts.frame_counts[batch.items] = batch.counts[chosen]


def _grow_kind(plan: Plan, parts: Parts, kind: int, is_first: bool, choose: bool) -> Batch:
    """Candidates for the items of a kind: as first ones from free tori, else between their neighbors.

    Figures in the comments are those of Lagae & Dutré 2006, section 7.1.
    """
    # Step 1: how many candidates: first ones are all alike and shared, later ones belong to an item.
    items = np.flatnonzero(plan.anatomy.kinds == kind)
    if is_first:
        owners = np.full(_POOL, -1) if choose else np.arange(len(items))
    else:
        owners = np.repeat(np.arange(len(items)), _CANDIDATES if choose else 1)
    # Step 2: a torus around each, with the parts that meet the item in their places (figures 13a, 14a).
    size = (1, 1) if is_first else {CORNER_PART: (2, 2), ROW_EDGE: (2, 1), COLUMN_EDGE: (1, 2)}[kind]
    around = _Surroundings.of(plan, parts, kind, size, items[owners], is_first)
    points = np.zeros((len(owners), parts.frame.shape[1], 2))
    counts = np.full(len(owners), -1, np.int32)
    from tilewright.kernels.growth import Effort, Torus, grow_parts

    torus = Torus(*size, *plan.shape_settings, around.open)
    effort = Effort(plan.distance, plan.lloyd, _ATTEMPTS, SWEEPS)
    # Step 3: fill the torus by darts and Lloyd's method and cut the part out (figures 13 and 14, b to d).
    for round in range(_ROUNDS):
        missing = np.flatnonzero(counts < 0)
        if len(missing) == 0:
            break
        keys = np.array([derive_key(plan.key, kind, round, int(m)) for m in missing], np.uint64)
        made, made_counts = np.zeros((len(missing), *points.shape[1:])), np.zeros(len(missing), np.int32)
        fixed, fixed_counts = around.fixed[missing], around.fixed_counts[missing]
        count = plan.points * size[0] * size[1]
        grow_parts(len(keys), keys, fixed, fixed_counts, count, torus, effort, kind, made, made_counts)
        points[missing], counts[missing] = made, made_counts
        good = counts >= 0
        if choose and len(np.unique(owners[good])) == len(np.unique(owners)):
            owners, points, counts = owners[good], points[good], counts[good]
    if (counts < 0).any():
        raise TilewrightValueError(
            f"no way was found to keep points {plan.distance:.4f} tiles apart along the borders of tiles",
            advice="ask for less rho",
        )
    return Batch(kind, items, owners, points, counts)


@dataclass(frozen=True, eq=False)
class _Surroundings:
    """The points already grown around items, on a torus with the item's lattice point at (0, 0)."""

    fixed: NDArray[np.float64]
    fixed_counts: NDArray[np.int32]
    open: NDArray[np.bool_]

    @classmethod
    def of(
        cls, plan: Plan, parts: Parts, kind: int, size: tuple[int, int], items: NDArray[np.intp], bare: bool
    ) -> "_Surroundings":
        width, height = size
        open = np.ones(4 * width * height, bool)
        if bare:
            return cls(np.zeros((len(items), 0, 2)), np.zeros(len(items), np.int32), open)
        numbers, places, meets = plan.anatomy.meetings()
        most = int(meets[items].max())
        fixed = np.zeros((len(items), most * parts.frame.shape[1], 2))
        counts = np.zeros(len(items), np.int32)
        for row, item in enumerate(items):
            for k in range(meets[item]):
                other, place = numbers[item, k], places[item, k]
                n = parts.frame_counts[other]
                fixed[row, counts[row] : counts[row] + n] = parts.frame[other, :n] + place
                counts[row] += n
                column, line = int(place[0]) % width, int(place[1]) % height
                open[plan.anatomy.kinds[other] + 4 * (column + width * line)] = False
        return cls(fixed, counts, open)


def _first_of_each(batch: Batch) -> NDArray[np.intp]:
    return np.array([np.flatnonzero(batch.owners == n)[0] for n in range(len(batch.items))])


class Chooser:
    """Picks candidates so that the density of the frame, averaged over colors, is even.

    The measure is the low part of the spectrum of the mean over the set, sum_j w_j exp(-2 pi i k x_j),
    less that of an even density in the parts grown so far, by coordinate descent. Candidates whose
    halves, on either side of an edge, hold too many or too few points are left out as far as can be:
    they would leave interiors too full or too empty.
    """

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.width = _WIDTH * np.sqrt(plan.points * plan.colors)
        reach = int(np.ceil(_REACH * self.width))
        self.kx, self.ky = np.arange(-reach, reach + 1), np.arange(reach + 1)
        square = self.kx[:, np.newaxis] ** 2 + self.ky**2
        self.weights = np.exp(-square / self.width**2) * np.where(self.ky == 0, 1.0, 2.0)
        self.excess = np.zeros(square.shape, np.complex128)

    def choose(self, batch: Batch) -> NDArray[np.intp]:
        """The candidate for each item of a batch."""
        weight = self.plan.anatomy.weights[batch.items]
        spectra, even = self._spectra(batch), self._even(batch.kind)
        allowed = self._allowed(batch, float(even[len(self.kx) // 2, 0].real))
        chosen = np.array([a[0] for a in allowed])
        total = np.tensordot(weight, spectra[chosen], 1) + self.excess - even
        for _ in range(_DESCENTS):
            for n, candidates in enumerate(allowed):
                total -= weight[n] * spectra[chosen[n]]
                rest = np.abs(total + weight[n] * spectra[candidates]) ** 2
                chosen[n] = candidates[int(np.argmin((rest * self.weights).sum(axis=(1, 2))))]
                total += weight[n] * spectra[chosen[n]]
        self.excess = total
        return chosen

    def _spectra(self, batch: Batch) -> NDArray[np.complex64]:
        """sum exp(-2 pi i k x) over the points of each candidate, shape (m, kx, ky)."""
        there = (np.arange(batch.points.shape[1]) < batch.counts[:, np.newaxis])[:, np.newaxis]
        x, y = batch.points[..., 0], batch.points[..., 1]
        along = np.exp(-2j * np.pi * self.kx[:, np.newaxis] * x[:, np.newaxis]) * there
        across = np.exp(-2j * np.pi * self.ky[:, np.newaxis] * y[:, np.newaxis])
        spectra: NDArray[np.complex64] = np.matmul(
            along.astype(np.complex64), across.astype(np.complex64).swapaxes(1, 2)
        )
        return spectra

    def _even(self, kind: int) -> NDArray[np.complex128]:
        """The spectrum of N points per tile spread evenly over the parts of a kind."""
        from tilewright.kernels.growth import mark_kind

        mask = np.empty((_RASTER, _RASTER))
        mark_kind(*self.plan.shape_settings, kind, mask)
        spectrum = np.fft.fft2(mask) / mask.size * self.plan.points
        shift = np.exp(-1j * np.pi * (self.kx[:, np.newaxis] + self.ky) / _RASTER)
        return spectrum[self.kx[:, np.newaxis], self.ky] * shift

    def _allowed(self, batch: Batch, fair: float) -> list[NDArray[np.intp]]:
        """For each item the candidates it may take: those whose halves hold about half of ``fair`` points."""
        penalty = np.zeros(len(batch.points))
        there = np.arange(batch.points.shape[1]) < batch.counts[:, np.newaxis]
        for axis in {CORNER_PART: (0, 1), ROW_EDGE: (1,), COLUMN_EDGE: (0,)}[batch.kind]:
            low = ((batch.points[..., axis] < 0) & there).sum(axis=1)
            for half in (low, batch.counts - low):
                penalty += np.maximum(np.abs(half - fair / 2) - _UNEVEN, 0) ** 2
        allowed = []
        for n in range(len(batch.items)):
            mine = np.flatnonzero((batch.owners == n) | (batch.owners < 0))
            allowed.append(mine[penalty[mine] <= penalty[mine].min() + 1e-9])
        return allowed
