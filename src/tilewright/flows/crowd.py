"""The particles of a flow as they are now, and the film of where they were."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.flows.tiles import WAYS, FlowTile
from tilewright.seeds import derive_key, make_key
from tilewright.tilings.streams import FLOWS

MOST_PARTICLES = 2**24
_MOST_PLACES = 2**27
"""Positions of a film, of 9 bytes each."""
_MOST_COUNTS = 2**24
"""Cells of the tables of all threads, of 32 bytes each."""
_FEW = 2**14
"""Moves that one thread has made before others have begun."""
NOBODY = 4
"""Instead of a way: no particle. As the way by which one came: it was born here."""


class Crowd:
    """Particles on a tiling. A newborn one takes the slot of one that is gone, where there is one."""

    def __init__(
        self, cells: NDArray[np.uint8], tiles: Sequence[FlowTile], border: int, turns_back: bool, seed: int
    ) -> None:
        from tilewright.kernels.flow import Particles, Rules
        from tilewright.kernels.threads import count_threads

        key = make_key(seed)
        self._key, self._birth_key = derive_key(key, FLOWS, 0), derive_key(key, FLOWS, 1)
        options, choices = _ways_on(tiles, turns_back)
        speeds = np.array([tile.speed for tile in tiles], np.float64)
        deaths = np.array([round(tile.kills * 2**32) for tile in tiles], np.uint64)
        self._rules = Rules(cells, options, choices, speeds, 1 / speeds, deaths, border)
        rates = np.array([tile.emits for tile in tiles], np.float64)[cells].ravel()
        self._emitters = np.flatnonzero(rates)
        self._rates = rates[self._emitters]
        # Every thread counts for itself, unless all tables together would be too large.
        threads = max(1, min(count_threads(), _MOST_COUNTS // cells.size))
        self._passed = np.zeros((threads, *cells.shape, 4), np.int64)
        self._numbers = 0
        self.particles = Particles.empty(0)
        self.born = self.killed = self.left = 0

    @property
    def departures(self) -> NDArray[np.int64]:
        """Who set out from each center along each way, int64 (height, width, 4)."""
        return np.asarray(self._passed.sum(axis=0))

    def begin(self, count: int) -> None:
        """Spread the first particles."""
        from tilewright.kernels.flow import Particles, start_particles

        self.particles = Particles.empty(count)
        start_particles(self._key, self.particles, self._rules)
        self._numbers = count

    def give_birth(self, now: int, steps: int, busy: NDArray[np.bool_]) -> None:
        """All births of some steps, which begin to walk when their moment comes; ``busy`` slots are kept."""
        if not len(self._emitters):
            return
        from tilewright.kernels.flow import bear_particles

        place, moment = self._births(now, steps)
        slots = self._slots(len(place), busy)
        bear_particles(
            self._key, self._numbers, slots, place, moment, self.particles, self._rules, self._passed[0]
        )
        self._numbers += len(place)
        self.born += len(place)

    def _births(self, now: int, steps: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Cells, and steps after ``now``, in which particles are born."""
        from tilewright.kernels.flow import count_births

        places, moments, total = [], [], 0
        count = np.empty(len(self._emitters), np.int64)
        for step in range(steps):
            total += count_births(
                self._birth_key, self._emitters, self._rates, self._rules.cells.size, now + step, count
            )
            _check_number(total)
            places.append(np.repeat(self._emitters, count))
            moments.append(np.full(len(places[-1]), step))
        return np.concatenate(places), np.concatenate(moments)

    def _slots(self, count: int, busy: NDArray[np.bool_]) -> NDArray[np.int64]:
        """Free slots; further ones are made as they are needed."""
        taken = self.particles.ways != NOBODY
        taken[: len(busy)] |= busy
        free = np.flatnonzero(~taken)[:count]
        missing = count - len(free)
        if missing:
            there = len(taken)
            _check_number(there + missing)
            self.particles = self.particles.widened(there + missing)
            free = np.append(free, np.arange(there, there + missing))
        return free

    def walk(self, steps: int) -> None:
        """Move all particles; those that died or left give up their slots."""
        from tilewright.kernels.flow import KILLED, LEFT, walk_in_parallel, walk_particles

        n = len(self.particles.x)
        if n * steps < _FEW:
            walk_particles(0, n, steps, self.particles, self._rules, self._passed[0])
        else:
            walk_in_parallel(len(self._passed), steps, self.particles, self._rules, self._passed)
        ways = self.particles.ways
        self.killed += int((ways == KILLED).sum())
        self.left += int((ways == LEFT).sum())
        ways[ways > NOBODY] = NOBODY


class Film:
    """Frames: where particles were."""

    def __init__(self, frames: int, extent: tuple[int, int]) -> None:
        self._frames, self._extent = frames, extent
        self.positions = np.empty((frames, 0, 2), np.float32)
        self.ways = np.empty((frames, 0), np.uint8)
        self.counts = np.zeros((3, frames), np.int64)
        """Born, killed and left until each frame."""
        self.busy = np.zeros(0, bool)
        """Slots that were taken in the last frame."""
        self._used = 0

    def make_room(self, slots: int) -> None:
        """Widen the frames; an error where that is too much."""
        if slots * self._frames > _MOST_PLACES:
            raise TilewrightValueError(
                f"{self._frames:,} frames of {slots:,} particles are too many; allowed are "
                f"{_MOST_PLACES:,} positions: make every larger"
            )
        room = self.ways.shape[1]
        if slots <= room:
            return
        # Half as many again, so that a crowd that grows is not copied at every frame.
        wide = slots if room == 0 else min(max(slots, room + room // 2), _MOST_PLACES // self._frames)
        positions = np.full((self._frames, wide, 2), np.nan, np.float32)
        ways = np.full((self._frames, wide), NOBODY, np.uint8)
        positions[:, :room], ways[:, :room] = self.positions, self.ways
        self.positions, self.ways = positions, ways

    def take(self, frame: int, crowd: Crowd) -> None:
        """Record a frame."""
        from tilewright.kernels.flow import record_places

        now = crowd.particles
        self._used = used = len(now.x)
        self.make_room(used)
        record_places(now, *self._extent, self.positions[frame, :used], self.ways[frame, :used])
        self.counts[:, frame] = crowd.born, crowd.killed, crowd.left
        self.busy = now.ways != NOBODY

    def cut(self) -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
        """Positions and ways, as wide as was needed."""
        return self.positions[:, : self._used], self.ways[:, : self._used]


def _check_number(particles: int) -> None:
    if particles > MOST_PARTICLES:
        raise TilewrightValueError(
            f"more than {MOST_PARTICLES:,} particles would be alive",
            advice="let tiles emit less or kill more",
        )


def _ways_on(tiles: Sequence[FlowTile], turns_back: bool) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """The ways that each tile allows one who came along way 0 to 3 or was born, and how many, by tile."""
    options = np.zeros((len(tiles), NOBODY + 1, 4), np.uint8)
    choices = np.zeros((len(tiles), NOBODY + 1), np.uint8)
    for t, tile in enumerate(tiles):
        for came in range(NOBODY + 1):
            back = (came + 2) % 4 if came != NOBODY and not turns_back else None
            ways = [way for way in WAYS[tile.ways] if way != back]
            options[t, came, : len(ways)] = ways
            choices[t, came] = len(ways)
    return options, choices
