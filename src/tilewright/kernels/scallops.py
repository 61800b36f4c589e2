"""Growing points around points: the three samplers of Dunbar & Humphreys (2006).

cells : `Cells` whose offsets go to images on a torus one by one. Lengths in ``near`` and in sectors are in
units of the least distance.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.chance import draw_unit, draw_word
from tilewright.kernels.compiled import kernel
from tilewright.kernels.darts import find_home, place
from tilewright.kernels.polygons import copy_rows, enlarge, put_inside
from tilewright.kernels.sectors import (
    FIELDS,
    draw_from_sectors,
    start_ring,
    subtract_from_all,
    sum_areas,
)
from tilewright.kernels.weights import choose_leaf, set_weight

_THIN = 1e-9
"""Radians that count as none."""


class Regions(NamedTuple):
    """Where the sectors of each point lie among rows of them, and the area of each point's."""

    starts: NDArray[np.int64]
    """(n,): the first row."""
    sizes: NDArray[np.int64]
    """(n,): rows in use."""
    room: NDArray[np.int64]
    """(n,): rows set aside; zero at first."""
    tree: NDArray[np.float64]
    """Areas, see `weights`."""


@kernel()
def find_near(i, reach, distance, cells, near):
    """The images of points closer to point i than ``reach``, its own too, nearest cells first.

    near : float64 (room, 3), filled with index and place as seen from i; returned after their number.
    """
    points, _, after, counts, offsets, extent, torus = cells
    home = np.empty(2, np.int64)
    find_home(points[i], counts, extent, home)
    count = 0
    for k in range(offsets.shape[0]):
        column, row = home[0] + offsets[k, 0], home[1] + offsets[k, 1]
        lap_x, lap_y = column // counts[0], row // counts[1]
        if not torus and (lap_x != 0 or lap_y != 0):
            continue
        j = cells.heads[(column - lap_x * counts[0]) * counts[1] + row - lap_y * counts[1]]
        while j >= 0:
            x = (points[j, 0] + lap_x * extent[0] - points[i, 0]) / distance
            y = (points[j, 1] + lap_y * extent[1] - points[i, 1]) / distance
            if x * x + y * y < reach * reach and not (j == i and lap_x == 0 and lap_y == 0):
                near = enlarge(near, count + 1)
                near[count, 0], near[count, 1], near[count, 2] = j, x, y
                count += 1
            j = after[j]
    return count, near


@kernel()
def add_point(n, i, x, y, distance, cells):
    """Make the point n at (x, y) as seen from point i, or from the corner of the box where i is -1."""
    point, home = np.empty(2), np.empty(2, np.int64)
    for a in range(2):
        seen = (x if a == 0 else y) * distance
        origin = cells.points[i, a] if i >= 0 else 0.0
        point[a] = put_inside(seen + origin, cells.extent[a], cells.torus)
    place(point, find_home(point, cells.counts, cells.extent, home), n, cells)


@kernel()
def add_first(key, distance, cells):
    """Make the first point, anywhere."""
    extent = cells.extent
    x, y = draw_unit(key, 0) * extent[0] / distance, draw_unit(key, 1) * extent[1] / distance
    add_point(0, -1, x, y, distance, cells)


@kernel()
def store_region(i, sectors, count, rows, used, regions):
    """Write the sectors of point i, at the end if they have outgrown their place, and weigh them."""
    if count > regions.room[i]:
        regions.room[i] = count + count // 2
        regions.starts[i] = used
        used += regions.room[i]
        rows = enlarge(rows, used)
    first = regions.starts[i]
    copy_rows(sectors, count, rows[first:])
    regions.sizes[i] = count
    set_weight(regions.tree, i, sum_areas(sectors, count))
    return rows, used


@kernel()
def open_region(n, distance, cells, near, sectors, spare, rows, used, regions):
    """Give the new point n the part of its ring that is in no ring or disk of an earlier one, and take its
    disk from the earlier ones' parts. Returns the scratches, rows and used."""
    found, near = find_near(n, 4.0, distance, cells, near)
    count = start_ring(cells.points[n], cells.extent, distance, cells.torus, sectors)
    for k in range(found):
        x, y = near[k, 1], near[k, 2]
        # Of two images of itself, one counts as the earlier.
        earlier = near[k, 0] != n or x < 0 or (x == 0 and y < 0)
        count, sectors, spare = subtract_from_all(sectors, count, x, y, 2.0 if earlier else 1.0, spare)
        if count == 0:
            break
    rows, used = store_region(n, sectors, count, rows, used, regions)
    for k in range(found):
        i, x, y = np.int64(near[k, 0]), near[k, 1], near[k, 2]
        if i != n and regions.sizes[i] > 0 and x * x + y * y < 9.0:
            own = rows[regions.starts[i] :]
            count, spare, _ = subtract_from_all(own, regions.sizes[i], -x, -y, 1.0, spare)
            rows, used = store_region(i, spare, count, rows, used, regions)
    return near, sectors, spare, rows, used


@kernel()
def grow_by_area(key, placed, last, distance, cells, rows, used, regions):
    """Place points anywhere in the rings, all places equally likely, up to ``last`` or until none is left.

    The cells are filled on. rows : float64 (any, 11), sectors, of which ``used`` are taken. regions :
    `Regions`, filled on. Returns the points placed, rows, which may have grown, and how many are used.
    """
    near, sectors, spare = np.empty((64, 3)), np.empty((64, FIELDS)), np.empty((64, FIELDS))
    if placed == 0:
        add_first(key, distance, cells)
    while placed < last:
        if placed > 0:
            if regions.tree[1] <= 0:
                break
            i, amount = choose_leaf(regions.tree, draw_unit(key, 2 * placed) * regions.tree[1])
            chance = draw_unit(key, 2 * placed + 1)
            x, y = draw_from_sectors(rows[regions.starts[i] :], regions.sizes[i], amount, chance)
            add_point(placed, i, x, y, distance, cells)
        near, sectors, spare, rows, used = open_region(
            placed, distance, cells, near, sectors, spare, rows, used, regions
        )
        placed += 1
    return placed, rows, used


@kernel()
def take_any(key, counter, active, waiting):
    """One of the points that wait, each equally likely; it waits no longer."""
    at = np.int64(draw_word(key, counter) % np.uint64(waiting))
    i = active[at]
    active[at] = active[waiting - 1]
    return i


@kernel()
def count_laps(distance, extent, torus, laps):
    """How often to go around a torus to meet all images closer than 4."""
    for a in range(2):
        laps[a] = np.int64(np.ceil(4 * distance / extent[a])) if torus else 0


@kernel()
def grow_by_turns(key, drawn, placed, last, waiting, active, distance, cells, done):
    """Take points in turn and fill the ring of each, up to ``last`` points or until none waits.

    active : int32 (n,), the points that wait. done : bool (n,), whose rings are full. The cells are filled
    on. Returns how many numbers were drawn, the points placed and how many wait.
    """
    near, sectors, spare = np.empty((64, 3)), np.empty((64, FIELDS)), np.empty((64, FIELDS))
    extent, laps = cells.extent, np.empty(2, np.int64)
    count_laps(distance, extent, cells.torus, laps)
    if placed == 0:
        add_first(key, distance, cells)
        active[0] = 0
        drawn, placed, waiting = 2, 1, 1
    while waiting > 0 and placed < last:
        i = take_any(key, drawn, active, waiting)
        drawn += 1
        waiting -= 1
        found, near = find_near(i, 4.0, distance, cells, near)
        count = start_ring(cells.points[i], extent, distance, cells.torus, sectors)
        for k in range(found):
            r = 2.0 if done[np.int64(near[k, 0])] else 1.0
            count, sectors, spare = subtract_from_all(sectors, count, near[k, 1], near[k, 2], r, spare)
            if count == 0:
                break
        while count > 0:
            amount = draw_unit(key, drawn) * sum_areas(sectors, count)
            x, y = draw_from_sectors(sectors, count, amount, draw_unit(key, drawn + 1))
            drawn += 2
            add_point(placed, i, x, y, distance, cells)
            active[waiting] = placed
            placed, waiting = placed + 1, waiting + 1
            for lap_x in range(-laps[0], laps[0] + 1):
                for lap_y in range(-laps[1], laps[1] + 1):
                    ax, ay = x + lap_x * extent[0] / distance, y + lap_y * extent[1] / distance
                    count, sectors, spare = subtract_from_all(sectors, count, ax, ay, 1.0, spare)
        done[i] = True
    return drawn, placed, waiting


@kernel()
def block_angles(ranges, count, middle, half, spare):
    """Take the directions ``middle`` +- ``half`` out of ranges of [0, 2 pi]; how many are left, in ``spare``,
    and both scratches."""
    spare = enlarge(spare, 2 * count + 2)
    left = 0
    low = (middle - half) % (2 * np.pi)
    for k in range(count):
        # The blocked part as it is, and once more a turn lower, since it may go over the end.
        start, end = ranges[k, 0], ranges[k, 1]
        for turn in range(2):
            begin = low - (1 - turn) * 2 * np.pi
            if start < min(end, begin) - _THIN:
                spare[left, 0], spare[left, 1] = start, min(end, begin)
                left += 1
            start = max(start, begin + 2 * half)
        if start < end - _THIN:
            spare[left, 0], spare[left, 1] = start, end
            left += 1
    return left, spare, ranges


@kernel()
def block_point(ranges, count, x, y, spare):
    """Take out the directions in which a point at distance 1 would be closer than 1 to (x, y)."""
    apart = np.sqrt(x * x + y * y)
    if apart >= 2.0:
        return count, ranges, spare
    return block_angles(ranges, count, np.arctan2(y, x), np.arccos(0.5 * apart), spare)


@kernel()
def grow_by_touch(key, drawn, placed, last, waiting, active, distance, cells):
    """Take points in turn and put others around each that touch it, as many as there is room for.

    As `grow_by_turns`; the room is ranges of directions.
    """
    near, ranges, spare = np.empty((64, 3)), np.empty((64, 2)), np.empty((64, 2))
    extent, laps = cells.extent, np.empty(2, np.int64)
    count_laps(distance, extent, cells.torus, laps)
    if placed == 0:
        add_first(key, distance, cells)
        active[0] = 0
        drawn, placed, waiting = 2, 1, 1
    while waiting > 0 and placed < last:
        i = take_any(key, drawn, active, waiting)
        drawn += 1
        waiting -= 1
        ranges[0, 0], ranges[0, 1] = 0.0, 2 * np.pi
        count = 1
        if not cells.torus:
            for a in range(2):
                for ahead in range(2):
                    at = cells.points[i, a]
                    wall = (extent[a] - at if ahead else at) / distance
                    if wall < 1:
                        middle = 0.5 * np.pi * a + (0.0 if ahead else np.pi)
                        count, ranges, spare = block_angles(ranges, count, middle, np.arccos(wall), spare)
        found, near = find_near(i, 2.0, distance, cells, near)
        for k in range(found):
            count, ranges, spare = block_point(ranges, count, near[k, 1], near[k, 2], spare)
        while count > 0:
            k = np.int64(draw_word(key, drawn) % np.uint64(count))
            angle = ranges[k, 0] + draw_unit(key, drawn + 1) * (ranges[k, 1] - ranges[k, 0])
            drawn += 2
            x, y = np.cos(angle), np.sin(angle)
            add_point(placed, i, x, y, distance, cells)
            active[waiting] = placed
            placed, waiting = placed + 1, waiting + 1
            for lap_x in range(-laps[0], laps[0] + 1):
                for lap_y in range(-laps[1], laps[1] + 1):
                    ax, ay = x + lap_x * extent[0] / distance, y + lap_y * extent[1] / distance
                    count, ranges, spare = block_point(ranges, count, ax, ay, spare)
    return drawn, placed, waiting
