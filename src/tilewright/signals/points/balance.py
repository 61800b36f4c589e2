"""Balanced sets: all points of a set move until no frequency of the tile lattice stands out.

What repeats from tile to tile shows as spikes of height |m(k)|^2 (see `spikes`). The sum over all
frequencies is fixed, since corner points stand for 1 / C of the plane and edge points for 1 / C^2; but it
can be spread evenly. Every spike above a limit is pulled down to it, as one would project onto a set of
constraints, and the limit is lowered as long as that succeeds. The best of all rounds counts.
"""

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.signals.points.plan import SWEEPS, Parts, Plan, fill_interiors
from tilewright.signals.points.spikes import Spikes, frequencies, mean_spectrum, window_reach

# What was seen when a number was changed: the highest spike within the periodogram over the mean of the
# spectrum (`Spikes.window` over ``floor``), for four sets of `corner_tiles(2)` with 16 points at rho 0.7.
# As the numbers stand it is 2.33, and its spread from set to set is 0.08: less than that is no difference.
_ROUNDS = 500
"""Rounds of moving all points. With 250 spikes are at 2.38, with 1000 at 2.17 in twice the time."""
_WARM = 20
"""First rounds, which pull at all frequencies by half, not at spikes only. 10 and 40 make no difference."""
_WARM_PULL = 0.5
"""Share of every frequency that these rounds pull at."""
_MEND = 0.6
"""Share of the rounds after which stuck tiles are filled anew. At rho 0.7 it changes nothing; at 0.85
spikes are at 3.09, and at 3.61 without it."""
_START = 2.5
"""The first limit of spikes, in means of the spectrum. 1.25 and 5 end at 2.21 and 2.25."""
_LOWER, _RAISE, _NEAR = 0.99, 1.003, 1.1
"""The limit is lowered by the first factor where the highest spike is below ``_NEAR`` times the limit, else
raised by the second. 0.98, 0.995, 1.0015, 1.006 and a near of 1.05 make no difference; 1.2 ends at 2.19."""
_GAIN = 0.7
"""Share of an excess that a round takes away. 0.35 ends at 2.38, 1.4 at 2.15."""
_STEP = 0.05
"""The farthest way of a point in a round, in mean spacings. 0.025 and 0.1 make no difference."""
_RING = 0.3
"""Power of the crowding of frequencies on a ring by which the limit is lowered there; 0 asks the same of all.
With 0 spikes are at 1.92, with 0.6 at 2.86: lower rings are paid for with higher spikes elsewhere."""
_RING_LOWEST = 0.4
"""The lowest limit of a ring, as a share of that elsewhere."""
_SWEEPS = 4
"""Rounds of pushing interior points apart after each move; what they leave crowded the next ones push on."""


def balance(plan: Plan, parts: Parts, progress: Progress | None = None) -> None:
    """Move the points of all parts; interiors may be a little crowded in the end, see `settle`."""
    reach = 2 * window_reach(plan.points)
    shape = _ring_shape(plan, reach)
    solver = _PoissonEquation(plan, reach)
    meets = plan.anatomy.meetings()
    weights = parts.all_points(plan)[1]
    limit = _START * float((weights**2).sum())
    lowest, best = np.inf, parts
    for round in range(_ROUNDS):
        if progress is not None:
            progress(round, _ROUNDS, "balancing the spectrum")
        points, weights = parts.all_points(plan)
        spectrum = mean_spectrum(points, weights, reach)
        height = np.abs(spectrum) ** 2 / shape
        if height.max() < lowest:
            lowest, best = float(height.max()), parts.copy()
        if round < _WARM:
            pull = np.full(height.shape, _WARM_PULL)
        else:
            pull = 1 - np.sqrt(limit / np.maximum(height, limit))
            limit *= _LOWER if height.max() < _NEAR * limit else _RAISE
        _move(plan, parts, meets, solver.velocity(points, _GAIN * pull * spectrum))
        if round == int(_MEND * _ROUNDS):
            settle(plan, parts, 0)
            lowest = np.inf
    parts.take(best)


def settle(plan: Plan, parts: Parts, round: int) -> int:
    """Push the points of every interior apart, fill those anew that stay stuck; how many failed."""
    stuck = _move_interiors(plan, parts, np.zeros_like(parts.inner), SWEEPS)
    return fill_interiors(plan, parts, stuck, 1 + round, 50) if len(stuck) else 0


def _ring_shape(plan: Plan, reach: int) -> NDArray[np.float64]:
    """The limit's shape: lower on rings, one sample wide, on which many lattice frequencies fall together.

    There spikes add up in the anisotropy, whose rings are as wide. Samples are those of a periodogram of
    the usual number of points.
    """
    kx, ky = frequencies(reach)
    along = np.sqrt(Spikes.usual_tiles(plan.points))
    radius = np.hypot(kx, ky)
    ring = np.rint(radius * along).astype(int)
    crowd = np.bincount(ring.ravel())[ring]
    expected = np.maximum(2 * np.pi * radius / along, 1)
    return np.clip((expected / crowd) ** _RING, _RING_LOWEST, 1)


class _PoissonEquation:
    """Finds velocities under which a spectrum shrinks: u = -grad psi with -laplace psi = its density."""

    def __init__(self, plan: Plan, reach: int) -> None:
        kx, ky = frequencies(reach)
        square = (kx**2 + ky**2).astype(float)
        square[reach, reach] = 1
        scale = -2j * np.pi / (4 * np.pi**2 * square * plan.points)
        self.gradient = np.stack([scale * kx, scale * ky])

    def velocity(self, points: NDArray[np.float64], spectrum: NDArray[np.complex128]) -> NDArray[np.float64]:
        """-sum_k i k ... exp(2 pi i k x) at every point, shape (P, 2)."""
        import finufft

        size = spectrum.shape[0] + 1
        modes = np.zeros((2, size, size), np.complex64)
        modes[:, 1:, 1:] = self.gradient * spectrum
        angle = (2 * np.pi * (points % 1.0)).astype(np.float32)
        x, y = np.ascontiguousarray(angle[:, 0]), np.ascontiguousarray(angle[:, 1])
        found = finufft.nufft2d2(x, y, modes, isign=1, eps=1e-4, nthreads=1)
        velocity: NDArray[np.float64] = found.real.T.astype(np.float64)
        return velocity


def _move(
    plan: Plan,
    parts: Parts,
    meets: tuple[NDArray[np.int32], NDArray[np.float64], NDArray[np.int32]],
    velocity: NDArray[np.float64],
) -> None:
    """Move every point, none by more than `_STEP`, and push interiors apart."""
    from tilewright.kernels.growth import move_frame

    longest = _STEP / np.sqrt(plan.points)
    speed = np.hypot(velocity[:, 0], velocity[:, 1])
    velocity *= np.minimum(1, longest / np.maximum(speed, 1e-12))[:, np.newaxis]
    frame = np.zeros_like(parts.frame)
    here = int(parts.frame_counts.sum())
    frame[parts.frame_slots] = velocity[:here]
    move_frame(
        frame,
        plan.anatomy.kinds,
        *meets,
        *plan.shape_settings,
        plan.distance,
        parts.frame,
        parts.frame_counts,
    )
    inner = np.zeros_like(parts.inner)
    inner[parts.inner_slots] = velocity[here:]
    _move_interiors(plan, parts, inner, _SWEEPS)


def _move_interiors(plan: Plan, parts: Parts, moves: NDArray[np.float64], sweeps: int) -> NDArray[np.intp]:
    """Move interior points and push them apart; which interiors are still crowded."""
    from tilewright.kernels.growth import move_interiors

    settled = np.zeros(len(parts.inner), bool)
    frame, radius, distance = parts.frame_around(plan.anatomy.items), plan.shape_settings, plan.distance
    inner = (parts.inner, parts.inner_counts)
    move_interiors(len(settled), frame, *radius, distance, moves, sweeps, *inner, settled)
    return np.flatnonzero(~settled)
