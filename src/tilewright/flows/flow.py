"""Flow: particles that go where the tiles of a tiling send them (Kaji et al. 2016, section 5)."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_cells, check_flag, check_int, check_progress
from tilewright.errors import Progress, TilewrightValueError
from tilewright.flows.crowd import MOST_PARTICLES, NOBODY, Crowd, Film
from tilewright.flows.tiles import FLOW_TILES, FlowTile, check_tiles, strew_tiles
from tilewright.showing import describe_record

__all__ = ["FLOW_TILES", "Flow", "FlowTile", "simulate_flow", "strew_tiles"]

_MOST_CELLS = 2**22
_MOST_STEPS = 2**20
_PART = 2**24
"""Moves between two calls of progress, at least a step and at most 64 steps of all particles."""


@dataclass(frozen=True, eq=False)
class Flow:
    """Where particles were; made by `simulate_flow`.

    Attributes
    ----------
    cells : uint8 array, shape (height, width)
        Tile of each cell.
    tiles : tuple of FlowTile
        What these numbers stand for.
    torus : bool
        Whether opposite sides meet.
    times : int64 array, shape (frames,)
        Steps made when each frame was taken; 0 first, all of them last.
    positions : float32 array, shape (frames, capacity, 2)
        x and y in cells, the center of cell (0, 0) is (0.5, 0.5); NaN where there is no particle. A column
        that is alive in two frames in a row holds the same particle in both; later it may hold another.
    ways : uint8 array, shape (frames, capacity)
        Where particles go: 0 to 3 for north, east, south, west; 4 where there is none.
    departures : int64 array, shape (height, width, 4)
        How often particles set out from the center of each cell along each way.
    born : int64 array, shape (frames,)
        Number of particles born until each frame. Alive are ``particles + born - killed - left``.
    killed : int64 array, shape (frames,)
        Number of particles killed until each frame.
    left : int64 array, shape (frames,)
        Number of particles that left the rectangle until each frame.

    Notes
    -----
    Kaji et al. 2016, section 5.
    """

    cells: NDArray[np.uint8]
    tiles: tuple[FlowTile, ...]
    torus: bool
    times: NDArray[np.int64]
    positions: NDArray[np.float32]
    ways: NDArray[np.uint8]
    departures: NDArray[np.int64]
    born: NDArray[np.int64]
    killed: NDArray[np.int64]
    left: NDArray[np.int64]

    __repr__ = describe_record

    @cached_property
    def alive(self) -> NDArray[np.bool_]:
        """Which columns hold a particle: bool, shape (frames, capacity)."""
        return self.ways < NOBODY

    @property
    def figures(self) -> dict[str, int | float | None]:
        """What the run is told by: its size, how many were born, killed, left and alive, and visits to cells.

        ``visits`` is the mean number of visits to a cell, ``variation`` their standard deviation over it, and
        ``unvisited`` the share of cells where no particle set out.
        """
        height, width = self.cells.shape
        visits = self.visits()
        mean = float(visits.mean())
        return {
            "width": width,
            "height": height,
            "steps": int(self.times[-1]),
            "frames": len(self.times),
            "start": int(self.alive[0].sum()),
            "born": int(self.born[-1]),
            "killed": int(self.killed[-1]),
            "left": int(self.left[-1]),
            "alive": int(self.alive[-1].sum()),
            "visits": round(mean, 4),
            "variation": round(float(visits.std()) / mean, 4) if mean else None,
            "unvisited": round(float((visits == 0).mean()), 4),
        }

    def visits(self) -> NDArray[np.int64]:
        """Count how often a particle set out from the center of each cell.

        Returns
        -------
        int64 array, shape (height, width)
            Numbers of departures.
        """
        return np.asarray(self.departures.sum(axis=2))

    def density(self, detail: int = 1) -> NDArray[np.float64]:
        """Give the number of particles that are in a place at a time, on average over the whole run.

        It is made from ``departures``: every walk along half a cell counts the time that it takes at the
        cell's speed. Walks count where they begin, so those under way at the start are left out and those not
        ended count as a whole.

        Parameters
        ----------
        detail : int, optional
            Pixels along a cell, 1 to 64; default 1. Particles are on the lines that join centers: pixels
            beside these are 0; the two pixels that a line runs between share it.

        Returns
        -------
        float64 array, shape (height * detail, width * detail)
            Particles in each pixel.

        Raises
        ------
        TilewrightTypeError
            The detail is not an integer.
        TilewrightValueError
            It is out of range, or makes more than 2^28 pixels.
        """
        check_int("detail", detail, 1, 64)
        check_int("pixels", self.cells.size * detail**2, 1, 2**28, "take a smaller detail")
        height, width = self.cells.shape
        out = np.zeros((height, detail, width, detail))
        for spent, stencil in zip(np.moveaxis(self.arms(), 2, 0), _stencils(detail), strict=True):
            for row, column in np.argwhere(stencil):
                out[:, row, :, column] += spent * stencil[row, column]
        return out.reshape(height * detail, width * detail)

    def arms(self) -> NDArray[np.float64]:
        """Give `density` of the four arms from each cell's center.

        Returns
        -------
        float64 array, shape (height, width, 4)
            Particles on the arms to the north, east, south and west.
        """
        speeds = np.array([tile.speed for tile in self.tiles])[self.cells]
        passed = np.stack([self.departures[..., way] + self._arrivals(way) for way in range(4)], axis=2)
        return np.asarray(passed * (0.5 / (speeds[..., np.newaxis] * float(self.times[-1]))))

    def _arrivals(self, way: int) -> NDArray[np.int64]:
        """How often particles set out to each cell's center from the neighbor that lies along a way."""
        axis, shift = way % 2, (1, -1, -1, 1)[way]
        coming = np.roll(self.departures[..., (way + 2) % 4], shift, axis)
        if not self.torus:
            np.moveaxis(coming, axis, 0)[0 if shift == 1 else -1] = 0
        return coming


def _stencils(detail: int) -> list[NDArray[np.float64]]:
    """How the time on each of a cell's four arms is shared out to its pixels, (detail, detail) each."""
    edges = np.arange(detail + 1) / detail
    first = np.diff(np.minimum(edges, 0.5)) * 2
    across = (np.eye(detail)[(detail - 1) // 2] + np.eye(detail)[detail // 2]) / 2
    north, west = np.outer(first, across), np.outer(across, first)
    return [north, west[:, ::-1], north[::-1], west]


def simulate_flow(
    cells: ArrayLike,
    tiles: Sequence[FlowTile] = FLOW_TILES,
    *,
    particles: int,
    steps: int,
    torus: bool = True,
    leaves: bool = False,
    turns_back: bool = True,
    every: int = 1,
    seed: int = 0,
    progress: Progress | None = None,
) -> Flow:
    """Let particles walk over a tiling.

    They are spread evenly over the lines that join neighboring centers. Each moves to the center of the
    next cell, with the speed of the cell that it is on. There it picks one of the ways of the cell's tile.
    A particle does not see others. What happens to it depends on the seed and its number alone, so the
    result is the same on any number of threads and for any ``every``.

    Parameters
    ----------
    cells : array-like of int, shape (height, width)
        The tile of each cell, as `dapple` or a window of a tiling gives them; up to 2^22 cells.
    tiles : sequence of FlowTile, optional
        What the numbers in ``cells`` stand for, 1 to 256 of them; default `FLOW_TILES`: 0 is ``-`` and 1 is
        ``|``.
    particles : int
        Number of particles at the start, 0 to 2^24. No more may be alive later, when tiles give birth to
        others.
    steps : int
        Steps to make, 1 to 2^20.
    torus : bool, optional
        Whether a particle that leaves at a side comes in at the opposite one; default True. Otherwise the
        borders are closed: a particle that has picked a way out of the rectangle goes the opposite way.
    leaves : bool, optional
        Without ``torus``, whether such a particle walks on to the border instead, and is gone; default False.
    turns_back : bool, optional
        Whether a particle may go back where it came from; default True. Otherwise it does only at closed
        borders.
    every : int, optional
        Steps from one frame to the next, 1 to 2^20; default 1. Frames are taken at the start and at the end
        too. All frames together hold up to 2^27 positions of 9 bytes.
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    Flow
        All frames, and counts of who passed where.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        An argument is out of range; or, while tiles give birth, there are too many particles or positions.

    Notes
    -----
    Kaji et al. 2016, section 5. The paper says "choose either left or right", so a particle may turn back.

    Examples
    --------
    >>> import tilewright as tw
    >>> cells = tw.dapple(tw.random_start(16, 16, seed=1), {"H0": 2, "V1": 2}, cyclic=True)
    >>> flow = tw.simulate_flow(cells, particles=50, steps=20, seed=1)
    >>> flow.positions.shape, int(flow.alive[-1].sum())
    ((21, 50, 2), 50)
    """
    kinds = check_tiles(tiles)
    given = _check_cells(cells, kinds)
    check_int("particles", particles, 0, MOST_PARTICLES)
    check_int("steps", steps, 1, _MOST_STEPS)
    check_int("every", every, 1, _MOST_STEPS)
    check_progress(progress)
    for name, flag in (("torus", torus), ("leaves", leaves), ("turns_back", turns_back)):
        check_flag(name, flag)
    if torus and leaves:
        raise TilewrightValueError(
            "is True; a torus has no border to leave by, give torus=False", argument="leaves"
        )
    if not (torus or leaves) and min(given.shape) < 2:
        raise TilewrightValueError(
            f"are {given.shape[1]} x {given.shape[0]}; closed borders need at least 2 x 2", argument="cells"
        )
    times = np.minimum(np.arange(0, steps + every, every), steps)
    crowd = Crowd(given, kinds, 0 if torus else 1 + leaves, turns_back, seed)
    film = Film(len(times), (given.shape[1], given.shape[0]))
    film.make_room(particles)
    crowd.begin(particles)
    film.take(0, crowd)
    most = max(1, min(64, _PART // max(particles, 1)))
    for frame in range(1, len(times)):
        now = int(times[frame - 1])
        while now < times[frame]:
            if progress is not None:
                progress(now, steps, "walking")
            part = min(most, int(times[frame]) - now)
            crowd.give_birth(now, part, film.busy)
            film.make_room(len(crowd.particles.x))
            crowd.walk(part)
            now += part
        film.take(frame, crowd)
    if progress is not None:
        progress(steps, steps, "walking")
    positions, ways = film.cut()
    return Flow(given, kinds, bool(torus), times, positions, ways, crowd.departures, *film.counts)


def _check_cells(cells: ArrayLike, tiles: tuple[FlowTile, ...]) -> NDArray[np.uint8]:
    given = as_cells(cells)
    check_int("the number of cells", given.size, 1, _MOST_CELLS)
    for number in (int(given.min()), int(given.max())):
        if not 0 <= number < len(tiles):
            raise TilewrightValueError(
                f"hold tile {number}; tiles are 0 to {len(tiles) - 1}", argument="cells", value=number
            )
    return np.array(given, np.uint8, order="C")  # its own: a flow is looked at later
