"""Particles that walk from the center of a cell to the next: births, steps and records of flow tiles.

Ways are 0 to 3: north, east, south, west.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.chance import draw_unit, draw_word
from tilewright.kernels.compiled import kernel

FREE, KILLED, LEFT = 4, 5, 6
"""Instead of a way: no particle; one that died, or left the rectangle, in the steps just made."""
TORUS, CLOSED, OPEN = 0, 1, 2
"""Borders: joined; a particle is turned back; a particle leaves."""
DRAWN = 3
"""Numbers of a particle's chance that its beginning takes: place or moment, way, how far it is."""

_EAST, _SOUTH = (0, 1, 0, -1), (-1, 0, 1, 0)
_BELOW_HALF = 0.49999999999999994


class Particles(NamedTuple):
    """State of particles: every array has shape (n,), a row for each slot."""

    x: NDArray[np.int32]
    """Column of the cell whose center it left last."""
    y: NDArray[np.int32]
    """Row of that cell."""
    ways: NDArray[np.uint8]
    """Which way it left, or `FREE`, `KILLED`, `LEFT`."""
    gone: NDArray[np.float64]
    """How much of the way to the next center lies behind it, [0, 1)."""
    keys: NDArray[np.uint64]
    """The key of its chance."""
    visits: NDArray[np.int32]
    """Numbers drawn so far."""
    waits: NDArray[np.float64]
    """Steps until it begins."""

    @classmethod
    def empty(cls, capacity: int) -> "Particles":
        """Slots without particles."""
        kinds = (np.int32, np.int32, np.uint8, np.float64, np.uint64, np.int32, np.float64)
        arrays = cls(*(np.zeros(capacity, kind) for kind in kinds))  # type: ignore[arg-type]
        arrays.ways.fill(FREE)
        return arrays

    def widened(self, capacity: int) -> "Particles":
        """The same particles and further slots."""
        wide = Particles.empty(capacity)
        there = len(self.ways)
        for name in self._fields:
            getattr(wide, name)[:there] = getattr(self, name)
        return wide


class Rules(NamedTuple):
    """The tiles of a rectangle, and what each of t tiles does with particles."""

    cells: NDArray[np.uint8]
    """(h, w): the tile of each cell."""
    options: NDArray[np.uint8]
    """(t, 5, 4): the ways on for one that comes along way 0 to 3, or is born (4)."""
    counts: NDArray[np.uint8]
    """(t, 5): how many of these there are."""
    speeds: NDArray[np.float64]
    """(t,): cells for each step."""
    slowness: NDArray[np.float64]
    """(t,): 1 / speeds."""
    deaths: NDArray[np.uint64]
    """(t,): chance to die, in units of 2^-32."""
    border: int
    """`TORUS`, `CLOSED` or `OPEN`."""


@kernel(inline=True)
def choose(word, options, count):
    """One of the first ``count`` options, all equally likely, by the upper half of a word."""
    return options[((word >> np.uint64(32)) * np.uint64(count)) >> np.uint64(32)]


@kernel(inline=True)
def step_from(at, by, extent):
    """The next cell along an axis, around the torus."""
    to = at + by
    return to + extent if to < 0 else (to - extent if to >= extent else to)


@kernel(inline=True)
def leads_out(x, y, way, width, height):
    """Whether a way crosses the border of the rectangle."""
    to_x, to_y = x + _EAST[way], y + _SOUTH[way]
    return to_x < 0 or to_x >= width or to_y < 0 or to_y >= height


@kernel()
def start_particles(key, particles, rules):
    """Spread particles 0 to n - 1 over the cells, each somewhere between two centers.

    The cells, row by row, are cut into n equal parts, and each particle begins in its own: they lie
    evenly, and neighbors in memory work on neighboring cells.
    """
    x, y, ways, gone, keys, visits, waits = particles
    cells, options, counts, _, _, _, border = rules
    height, width = cells.shape
    for i in range(x.size):
        own = draw_word(key, i)
        # The last parts of large crowds may be rounded up to their end.
        place = min(np.int64((i + draw_unit(own, 0)) / x.size * cells.size), cells.size - 1)
        x[i], y[i] = place % width, place // width
        tile = cells[y[i], x[i]]
        way = choose(draw_word(own, 1), options[tile, 4], counts[tile, 4])
        along = draw_unit(own, 2)
        if border != TORUS and leads_out(x[i], y[i], way, width, height):
            if border == CLOSED:
                way = (way + 2) & 3
            elif along >= 0.5:
                along -= 0.5
        ways[i], gone[i], keys[i], visits[i], waits[i] = way, along, own, DRAWN, 0.0


@kernel()
def count_births(key, places, rates, cell_count, step, out):
    """How many are born in each emitting cell in a step: the rate rounded up or down by chance."""
    total = 0
    for i in range(places.size):
        out[i] = np.int64(rates[i] + draw_unit(key, step * cell_count + places[i]))
        total += out[i]
    return total


@kernel()
def bear_particles(key, number, slots, places, steps, particles, rules, passed):
    """Particles ``number`` on come to life in the centers of cells, some moment of the given steps."""
    x, y, ways, gone, keys, visits, waits = particles
    cells, options, counts, _, _, _, border = rules
    height, width = cells.shape
    for j in range(slots.size):
        i, own = slots[j], draw_word(key, number + j)
        x[i], y[i] = places[j] % width, places[j] // width
        tile = cells[y[i], x[i]]
        way = choose(draw_word(own, 1), options[tile, 4], counts[tile, 4])
        if border == CLOSED and leads_out(x[i], y[i], way, width, height):
            way = (way + 2) & 3
        ways[i], gone[i], keys[i], visits[i] = way, 0.0, own, DRAWN
        waits[i] = steps[j] + draw_unit(own, 0)
        passed[y[i], x[i], way] += 1


@kernel()
def walk_particles(first, last, steps, particles, rules, passed):
    """Move particles ``first`` up to ``last`` for a number of steps.

    passed : int64 (h, w, 4), adds who set out from a center along a way.
    """
    x, y, ways, gone, keys, visits, waits = particles
    cells, options, counts, speeds, slowness, deaths, border = rules
    height, width = cells.shape
    for i in range(first, last):
        way = ways[i]
        if way >= FREE:
            continue
        at_x, at_y, along, own, visit, wait = x[i], y[i], gone[i], keys[i], visits[i], waits[i]
        to_x, to_y = step_from(at_x, _EAST[way], width), step_from(at_y, _SOUTH[way], height)
        here, there = speeds[cells[at_y, at_x]], speeds[cells[to_y, to_x]]
        slow_here, slow_there = slowness[cells[at_y, at_x]], slowness[cells[to_y, to_x]]
        for step in range(steps):
            time = min(1.0, step + 1.0 - wait)
            while time >= 0.0 and way < FREE:
                # Up to the edge of the cell, with the speed of this cell.
                if along < 0.5:
                    needed = (0.5 - along) * slow_here
                    if needed > time:
                        along = min(along + time * here, _BELOW_HALF)
                        break
                    time -= needed
                    along = 0.5
                    if border == OPEN and leads_out(at_x, at_y, way, width, height):
                        way = LEFT
                        break
                # On to the next center, with the speed of the next cell.
                needed = (1.0 - along) * slow_there
                if needed > time:
                    along += time * there
                    break
                time -= needed
                # At the center: die there, or pick one of the ways that its tile allows.
                at_x, at_y, along = to_x, to_y, 0.0
                tile = cells[at_y, at_x]
                word = draw_word(own, visit)
                visit += 1
                if (word & np.uint64(0xFFFFFFFF)) < deaths[tile]:
                    way = KILLED
                    break
                way = choose(word, options[tile, way], counts[tile, way])
                if border == CLOSED and leads_out(at_x, at_y, way, width, height):
                    way = (way + 2) & 3
                passed[at_y, at_x, way] += 1
                to_x, to_y = step_from(at_x, _EAST[way], width), step_from(at_y, _SOUTH[way], height)
                tile_there = cells[to_y, to_x]
                here, there = speeds[tile], speeds[tile_there]
                slow_here, slow_there = slowness[tile], slowness[tile_there]
        x[i], y[i], ways[i], gone[i], visits[i], waits[i] = at_x, at_y, way, along, visit, 0.0


@kernel(parallel=True)
def walk_in_parallel(first, last, steps, particles, rules, passed):
    """`walk_particles` for all, in as many parts as ``passed``, int64 (parts, h, w, 4), has tables."""
    parts, n = passed.shape[0], particles.x.size
    for part in range(first, last):
        begin, end = n * part // parts, n * (part + 1) // parts
        walk_particles(begin, end, steps, particles, rules, passed[part])


@kernel()
def record_places(particles, width, height, places, headings):
    """Where particles are: places float32 (n, 2), NaN where there is none; headings uint8 (n,)."""
    x, y, ways, gone, _, _, _ = particles
    for i in range(x.size):
        way = headings[i] = ways[i]
        if way >= FREE:
            places[i, 0] = places[i, 1] = np.nan
            continue
        across = np.float32((x[i] + 0.5 + gone[i] * _EAST[way]) % width)
        down = np.float32((y[i] + 0.5 + gone[i] * _SOUTH[way]) % height)
        # Rounded up to the border, it is on the other side.
        places[i, 0] = across if across < width else 0.0
        places[i, 1] = down if down < height else 0.0
