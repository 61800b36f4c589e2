"""Flow tiles: particles on dappled tilings (Kaji et al. 2016, section 5)."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

import tilewright as tw
from cores import cores
from tilewright.errors import Cancelled, TilewrightError
from tilewright.flows.flow import FLOW_TILES, Flow, FlowTile, simulate_flow, strew_tiles
from tilewright.seeds import derive_key, make_key

ALL = (
    FlowTile("-", 0.7),
    FlowTile("|", 1.3),
    FlowTile("+", 2.9, kills=0.2),
    FlowTile("-", 0.25, emits=0.3),
    FlowTile("|", 1.0, emits=1.6, kills=0.4),
)
KINDS = np.random.default_rng(2).integers(0, 5, (4, 5))
BORDERS = {"torus": {}, "closed": {"torus": False}, "open": {"torus": False, "leaves": True}}
STEP = ((0, -1), (1, 0), (0, 1), (-1, 0))


def word(key, counter):
    """SplitMix64, from its paper."""
    low = 2**64 - 1
    z = (int(key) * 0x94D049BB133111EB + (counter + 1) * 0x9E3779B97F4A7C15) & low
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & low
    z = (z ^ z >> 27) * 0x94D049BB133111EB & low
    return z ^ z >> 31


def unit(key, counter):
    return Fraction(word(key, counter) >> 11, 2**53)


class Slow:
    """Whole lives of particles, one after the other, as corners of paths with exact times."""

    def __init__(self, cells, tiles, border, turns_back, steps):
        self.cells, self.tiles, self.border, self.back, self.steps = cells, tiles, border, turns_back, steps
        self.height, self.width = cells.shape
        self.key = derive_key(make_key(7), 16, 0)
        self.departures = np.zeros((*cells.shape, 4), int)
        self.paths, self.fates = [], []

    def tile(self, x, y):
        return self.tiles[self.cells[y % self.height, x % self.width]]

    def inside(self, x, y):
        return 0 <= x < self.width and 0 <= y < self.height

    def choose(self, x, y, came, number):
        ways = {"-": [1, 3], "|": [0, 2], "+": [0, 1, 2, 3]}[self.tile(x, y).ways]
        if came is not None and not self.back:
            ways = [way for way in ways if way != (came + 2) % 4]
        way = ways[(number >> 32) * len(ways) >> 32]
        out = not self.inside(x + STEP[way][0], y + STEP[way][1])
        return (way + 2) % 4 if self.border == "closed" and out else way

    def live(self, number, count, birth=None):
        own = word(self.key, number)
        if birth is None:
            place = int((number + unit(own, 0)) / count * self.cells.size)
            along, now = unit(own, 2), Fraction(0)
        else:
            place, along, now = birth[1], Fraction(0), birth[0] + unit(own, 0)
        x, y = place % self.width, place // self.width
        way, draw = self.choose(x, y, None, word(own, 1)), 3
        if birth is None and self.border == "open" and along >= 0.5:
            along -= 0 if self.inside(x + STEP[way][0], y + STEP[way][1]) else Fraction(1, 2)
        if birth is not None:
            self.departures[y, x, way] += 1
        path, fate = [], "alive"
        while True:
            dx, dy = STEP[way]
            center = (x + Fraction(1, 2), y + Fraction(1, 2))
            for start, end, tile in (
                (along, Fraction(1, 2), self.tile(x, y)),
                (max(along, Fraction(1, 2)), Fraction(1), self.tile(x + dx, y + dy)),
            ):
                if start < end:
                    later = now + (end - start) / Fraction(tile.speed)
                    path.append((now, later, way, *(
                        (center[0] + dx * at, center[1] + dy * at) for at in (start, end)
                    )))  # fmt: skip
                    now = later
                if now > self.steps:
                    break
                if end < 1 and self.border == "open" and not self.inside(x + dx, y + dy):
                    fate = "left"
                    break
            if fate == "left" or now > self.steps:
                break
            x, y, along = x + dx, y + dy, Fraction(0)
            drawn, draw = word(own, draw), draw + 1
            if (drawn & 0xFFFFFFFF) < self.tile(x, y).kills * 2**32:
                fate = "killed"
                break
            way = self.choose(x % self.width, y % self.height, way, drawn)
            self.departures[y % self.height, x % self.width, way] += 1
        self.paths.append(path)
        self.fates.append((fate, now))

    def run(self, particles):
        births, key = [], derive_key(make_key(7), 16, 1)
        for step in range(self.steps):
            for place, kind in enumerate(self.cells.ravel()):
                rate = Fraction(self.tiles[kind].emits)
                births += [(step, place)] * int(rate + unit(key, step * self.cells.size + place))
        for number in range(particles):
            self.live(number, particles)
        for number, birth in enumerate(births, particles):
            self.live(number, particles, birth)
        return births

    def frame(self, time):
        """Who is alive, sorted: x, y, way."""
        there = []
        for path in self.paths:
            for start, end, way, a, b in path:
                if start <= time < end:
                    t = (time - start) / (end - start)
                    x, y = (float(p + t * (q - p)) for p, q in zip(a, b, strict=True))
                    there.append((x % self.width, y % self.height, way))
        return np.array(sorted(there))


def sorted_frame(flow, frame):
    on = flow.alive[frame]
    rows = np.column_stack([flow.positions[frame][on], flow.ways[frame][on]])
    return rows[np.lexsort(rows.T[::-1])]


@pytest.mark.parametrize("turns_back", [True, False])
@pytest.mark.parametrize("border", BORDERS)
def test_a_slow_simulation_agrees(border, turns_back):
    steps = 9
    slow = Slow(KINDS, ALL, border, turns_back, steps)
    births = slow.run(12)
    flow = simulate_flow(
        KINDS, ALL, particles=12, steps=steps, turns_back=turns_back, seed=7, **BORDERS[border]
    )
    assert np.array_equal(flow.departures, slow.departures)
    for frame in range(1, steps + 1):
        assert np.allclose(sorted_frame(flow, frame), slow.frame(frame), atol=1e-5)
        assert flow.born[frame] == sum(step < frame for step, _ in births)
        for fate, count in (("killed", flow.killed), ("left", flow.left)):
            assert count[frame] == sum(f == fate and time <= frame for f, time in slow.fates)
    assert flow.killed[-1] > 10
    assert (flow.left[-1] > 5) == (border == "open")


@pytest.fixture(scope="module")
def busy():
    """Births and deaths in many cells, every step recorded."""
    cells = np.random.default_rng(1).integers(0, 5, (30, 40))
    return simulate_flow(cells, ALL, particles=500, steps=60, torus=False, leaves=True, seed=3)


def test_the_balance_holds_in_every_frame(busy):
    alive = busy.alive.sum(axis=1)
    assert np.array_equal(alive, 500 + busy.born - busy.killed - busy.left)
    assert min(busy.born[-1], busy.killed[-1], busy.left[-1]) > 100
    assert np.array_equal(np.isnan(busy.positions).all(axis=2), ~busy.alive)
    assert (busy.born[-1] + 500) > 2 * busy.alive.shape[1]  # slots are used again


def test_a_column_holds_one_particle_as_long_as_it_is_alive(busy):
    both = busy.alive[1:] & busy.alive[:-1]
    moved = np.abs(np.diff(busy.positions, axis=0))[both].sum(axis=-1)
    assert moved.max() <= max(tile.speed for tile in ALL) + 1e-5
    # On rows, between frames so far apart that slots would be free for others in between.
    tiles = [FlowTile("-", emits=0.02, kills=0.02)]
    rows = simulate_flow(np.zeros((40, 10), int), tiles, particles=300, steps=900, every=150)
    both = rows.alive[1:] & rows.alive[:-1]
    assert both.sum() > 30
    assert not np.diff(rows.positions[..., 1], axis=0)[both].any()


def test_neither_frames_nor_threads_matter(busy):
    for count in (1, 3):
        with cores(count):
            again = simulate_flow(busy.cells, ALL, particles=500, steps=60, torus=False, leaves=True, seed=3)
        assert np.array_equal(again.positions, busy.positions, equal_nan=True)
    rare = simulate_flow(busy.cells, ALL, particles=500, steps=60, torus=False, leaves=True, seed=3, every=25)
    assert rare.times.tolist() == [0, 25, 50, 60]
    for frame, time in enumerate(rare.times):
        assert np.array_equal(sorted_frame(rare, frame), sorted_frame(busy, time))
    assert np.array_equal(rare.departures, busy.departures)
    other = simulate_flow(busy.cells, ALL, particles=500, steps=60, torus=False, leaves=True, seed=4)
    assert not np.array_equal(other.departures, busy.departures)


def test_rows_are_kept_and_spread_as_a_random_walk_does():
    steps, n = 40, 20000
    flow = simulate_flow(np.zeros((5, 9), int), particles=n, steps=steps, seed=5)
    assert flow.alive.all()
    assert np.array_equal(flow.positions[..., 1], np.broadcast_to(flow.positions[0, :, 1], (steps + 1, n)))
    moved = np.diff(flow.positions[..., 0].astype(float), axis=0)
    moved -= 9 * np.rint(moved / 9)
    walked = moved.sum(axis=0)
    # T - 1 whole steps and two parts a and 1 - a of steps: T - 1 + 2/3.
    variance = steps - 1 / 3
    assert walked.mean() == pytest.approx(0, abs=4 * (variance / n) ** 0.5)
    assert walked.var() == pytest.approx(variance, rel=4 * (2 / n) ** 0.5)


def test_particles_spread_alike_on_every_tiling():
    """Both ways are equally likely, so no step depends on those before: T steps spread as T - 1/3."""
    cells = tw.dapple(tw.random_start(16, 16, seed=3), {"H0": 2, "V1": 3}, cyclic=True)
    spread = []
    for turns_back in (True, False):
        flow = simulate_flow(cells, particles=20000, steps=30, seed=2, turns_back=turns_back)
        moved = np.diff(flow.positions.astype(float), axis=0)
        moved -= 16 * np.rint(moved / 16)
        spread.append((moved.sum(axis=0) ** 2).sum(axis=1).mean())
    assert spread[0] == pytest.approx(30 - 1 / 3, rel=0.03)
    assert spread[1] > 1.4 * spread[0]


def test_without_turning_back_rows_are_walked_for_ever():
    flow = simulate_flow(np.zeros((3, 8), int), particles=50, steps=30, turns_back=False)
    assert np.array_equal(flow.ways, np.broadcast_to(flow.ways[0], flow.ways.shape))
    crossing = simulate_flow(
        np.zeros((3, 8), int), [FlowTile("+")], particles=5000, steps=20, turns_back=False
    )
    turn = (crossing.ways[1:] - crossing.ways[:-1]) % 4
    assert np.bincount(turn.ravel(), minlength=4) / turn.size == pytest.approx(
        [1 / 3, 1 / 3, 0, 1 / 3], abs=0.01
    )


def test_visits_are_those_of_the_markov_chain():
    cells = tw.dapple(tw.random_start(6, 6, seed=2), {"H0": 2, "V1": 2}, cyclic=True)
    n, steps = 40000, 30
    chain = np.zeros((36, 36))
    for (y, x), tile in np.ndenumerate(cells):
        for way in ((1, 3), (0, 2))[tile]:
            chain[6 * y + x, 6 * ((y + STEP[way][1]) % 6) + (x + STEP[way][0]) % 6] += 0.5
    at, expected = np.full(36, n / 36), np.zeros(36)
    for _ in range(steps):
        at = at @ chain
        expected += at
    flow = simulate_flow(cells, particles=n, steps=steps, seed=8)
    assert flow.visits().sum() == n * steps
    assert flow.visits().ravel() == pytest.approx(expected, rel=0.04, abs=1e-9)
    assert expected.max() > 2 * expected.mean()


@pytest.mark.parametrize("border", BORDERS)
def test_density_is_the_time_that_particles_spend(border):
    tiles = (FlowTile("-", 0.4), FlowTile("|", 2.0), FlowTile("+", 0.9, emits=0.5, kills=0.2))
    cells = np.random.default_rng(6).integers(0, 3, (4, 6))
    flow = simulate_flow(cells, tiles, particles=400, steps=2000, seed=1, **BORDERS[border])
    seen = flow.positions[flow.alive].astype(float)
    for detail in (1, 4, 5):
        x, y = np.floor(seen.T * detail).astype(int)
        counted = np.bincount(6 * detail * y + x, minlength=24 * detail**2) / 2001
        counted = counted.reshape(4 * detail, 6 * detail)
        density = flow.density(detail)
        # On even grids counting puts lines to one side of the border that they run on.
        whole = [a.reshape(4, detail, 6, detail).sum(axis=(1, 3)) for a in (density, counted)]
        assert whole[0] == pytest.approx(whole[1], rel=0.06, abs=0.03)
    assert density == pytest.approx(counted, rel=0.12, abs=0.06)
    assert density.sum() == pytest.approx(flow.alive.sum(axis=1).mean(), rel=0.02)


def test_births_come_at_the_rate_asked_for():
    tiles = (FlowTile("-"), FlowTile("|", emits=0.03), FlowTile("|", emits=2.5))
    cells = np.random.default_rng(3).integers(0, 3, (20, 20))
    flow = simulate_flow(cells, tiles, particles=0, steps=100, every=100)
    expected = 100 * ((cells == 1).sum() * 0.03 + (cells == 2).sum() * 2.5)
    assert flow.alive[-1].sum() == flow.born[-1] == pytest.approx(expected, rel=0.02)


def test_strewn_cells_keep_their_ways():
    cells = tw.random_start(200, 100, seed=4)
    strewn, tiles = strew_tiles(cells, emitting=0.1, killing=0.2, slow=0.05, fast=0.3, seed=4)
    assert all(tiles[s].ways == "-|"[c] for s, c in zip(strewn.ravel(), cells.ravel(), strict=True))
    shares = np.bincount(strewn.ravel() // 2, minlength=5) / strewn.size
    assert shares == pytest.approx([0.35, 0.1, 0.2, 0.05, 0.3], abs=0.012)
    assert np.corrcoef(cells.ravel(), strewn.ravel() // 2)[0, 1] == pytest.approx(0, abs=0.03)
    assert (tiles[2].emits, tiles[5].kills, tiles[6].speed, tiles[9].speed) == (0.02, 1, 0.4, 2.5)
    assert np.array_equal(strew_tiles(cells, killing=1)[0], cells + 4)
    assert np.array_equal(strew_tiles(cells)[0], cells)


GOOD = {"cells": np.zeros((3, 3), int), "particles": 4, "steps": 5}


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: FlowTile("-", float("nan")), "speed is nan; allowed are 0.001 to 8"),
        (lambda: FlowTile("-", 0), "speed is 0"),
        (lambda: FlowTile("x"), "ways is 'x'; allowed are -, |, +"),
        (lambda: FlowTile("-", emits=-1), "emits is -1"),
        (lambda: FlowTile("-", kills=1.5), "kills is 1.5"),
        (lambda: simulate_flow(**{**GOOD, "cells": [[0, 2]]}), "cells hold tile 2; tiles are 0 to 1"),
        (lambda: simulate_flow(**{**GOOD, "cells": [[0, -1]]}), "cells hold tile -1"),
        (lambda: simulate_flow(**{**GOOD, "cells": [0, 1]}), r"shape \(2,\); expected \(height, width\)"),
        (lambda: simulate_flow(**{**GOOD, "cells": [[0.5]]}), "cells"),
        (lambda: simulate_flow(**{**GOOD, "particles": -1}), "particles is -1"),
        (lambda: simulate_flow(**{**GOOD, "particles": 2**24 + 1}), "particles is 16777217"),
        (lambda: simulate_flow(**{**GOOD, "steps": 0}), "steps is 0"),
        (lambda: simulate_flow(**GOOD, every=0), "every is 0"),
        (lambda: simulate_flow(**GOOD, progress=3), "progress must be a function"),
        (lambda: simulate_flow(**GOOD, torus="no"), "torus must be True or False, not 'no'"),
        (lambda: simulate_flow(**GOOD, leaves=True), "leaves is True; a torus has no border"),
        (lambda: simulate_flow(**{**GOOD, "cells": [[0, 1]]}, torus=False), "2 x 1; closed borders need"),
        (lambda: simulate_flow(**{**GOOD, "particles": 2**20, "steps": 500}), "501 frames of 1,048,576"),
        (lambda: simulate_flow(**GOOD, tiles=["-", "|"]), "tiles must hold FlowTile objects, not '-'"),
        (lambda: simulate_flow(**GOOD, tiles=[]), "the number of tiles is 0"),
        (lambda: simulate_flow(**GOOD, tiles=5), "tiles must be a sequence of FlowTile"),
        (
            lambda: simulate_flow(
                np.zeros((130, 130), int), [FlowTile("-", emits=1000)], particles=0, steps=9
            ),
            "more than 16,777,216 particles would be alive",
        ),
        (lambda: strew_tiles([[0]], slow=0.6, fast=0.6), "the sum of the shares is 1.2"),
        (lambda: strew_tiles([[2]]), "cells hold 2 to 2; tiles are 0 to 1"),
        (
            lambda: strew_tiles([[0]], tiles=[FlowTile("-")] * 52),
            "the number of tiles is 52; allowed are 1 to 51",
        ),
    ],
)
def test_refusals_are_one_line(call, said):
    with pytest.raises(TilewrightError, match=said) as raised:
        call()
    assert "\n" not in str(raised.value)


def test_progress_can_stop_it():
    def stop(done, total, what):
        assert (total, what) == (2000, "walking")
        if done > 100:
            raise Cancelled

    with pytest.raises(Cancelled):
        simulate_flow(np.zeros((3, 3), int), particles=5, steps=2000, every=2000, progress=stop)


def test_tiles_of_a_tiling_are_taken_too():
    window = tw.direct(tw.corner_tiles(colors=2)).indices(0, 0, 12, 9) % 2
    flow = simulate_flow(window, FLOW_TILES, particles=30, steps=4)
    assert isinstance(flow, Flow)
    assert np.array_equal(flow.cells, window)
    assert replace(FLOW_TILES[0], ways="|") == FLOW_TILES[1]
