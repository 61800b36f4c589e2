"""Growing points around points: the three samplers of Dunbar & Humphreys (2006).

Names of the grid as in `darts`; its offsets go to images on a torus one by one. Lengths in ``near`` and in
sectors are in units of the least distance.
"""

import numpy as np

from tilewright.kernels.chance import draw_unit, draw_word
from tilewright.kernels.compiled import kernel
from tilewright.kernels.darts import find_home, place
from tilewright.kernels.polygons import enlarge, put_inside
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


@kernel()
def find_near(i, reach, distance, points, heads, after, counts, extent, torus, offsets, near):
    """The images of points closer to point i than ``reach``, its own too, nearest cells first.

    near : float64 (room, 3), filled with index and place as seen from i; returned after their number.
    """
    home = np.empty(2, np.int64)
    find_home(points[i], counts, extent, home)
    count = 0
    for k in range(offsets.shape[0]):
        column, row = home[0] + offsets[k, 0], home[1] + offsets[k, 1]
        lap_x, lap_y = column // counts[0], row // counts[1]
        if not torus and (lap_x != 0 or lap_y != 0):
            continue
        j = heads[(column - lap_x * counts[0]) * counts[1] + row - lap_y * counts[1]]
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
def add_point(n, i, x, y, distance, points, heads, after, counts, extent, torus):
    """Make the point n at (x, y) as seen from point i, or from the corner of the box where i is -1."""
    point, home = np.empty(2), np.empty(2, np.int64)
    for a in range(2):
        seen = (x if a == 0 else y) * distance
        point[a] = put_inside(seen + (points[i, a] if i >= 0 else 0.0), extent[a], torus)
    place(point, find_home(point, counts, extent, home), n, points, heads, after)


@kernel()
def add_first(key, distance, points, heads, after, counts, extent, torus):
    """Make the first point, anywhere."""
    x, y = draw_unit(key, 0) * extent[0] / distance, draw_unit(key, 1) * extent[1] / distance
    add_point(0, -1, x, y, distance, points, heads, after, counts, extent, torus)


@kernel()
def store_region(i, sectors, count, rows, used, starts, sizes, room, tree):
    """Write the sectors of point i, at the end if they have outgrown their place, and weigh them."""
    if count > room[i]:
        room[i] = count + count // 2
        starts[i] = used
        used += room[i]
        rows = enlarge(rows, used)
    rows[starts[i] : starts[i] + count] = sectors[:count]
    sizes[i] = count
    set_weight(tree, i, sum_areas(sectors, count))
    return rows, used


@kernel()
def open_region(
    n, distance, points, heads, after, counts, extent, torus, offsets, near, sectors, spare,
    rows, used, starts, sizes, room, tree,
):  # fmt: skip
    """Give the new point n the part of its ring that is in no ring or disk of an earlier one, and take its
    disk from the earlier ones' parts. Returns the scratches, rows and used."""
    found, near = find_near(n, 4.0, distance, points, heads, after, counts, extent, torus, offsets, near)
    count = start_ring(points[n], extent, distance, torus, sectors)
    for k in range(found):
        x, y = near[k, 1], near[k, 2]
        # Of two images of itself, one counts as the earlier.
        earlier = near[k, 0] != n or x < 0 or (x == 0 and y < 0)
        count, sectors, spare = subtract_from_all(sectors, count, x, y, 2.0 if earlier else 1.0, spare)
        if count == 0:
            break
    rows, used = store_region(n, sectors, count, rows, used, starts, sizes, room, tree)
    for k in range(found):
        i, x, y = np.int64(near[k, 0]), near[k, 1], near[k, 2]
        if i != n and sizes[i] > 0 and x * x + y * y < 9.0:
            count, spare, _ = subtract_from_all(rows[starts[i] :], sizes[i], -x, -y, 1.0, spare)
            rows, used = store_region(i, spare, count, rows, used, starts, sizes, room, tree)
    return near, sectors, spare, rows, used


@kernel()
def grow_by_area(
    key, placed, last, distance, points, heads, after, counts, extent, torus, offsets,
    rows, used, starts, sizes, room, tree,
):  # fmt: skip
    """Place points anywhere in the rings, all places equally likely, up to ``last`` or until none is left.

    points : float64 (n, 2) and the grid, filled on. rows : float64 (any, 11), sectors, of which ``used`` are
    taken, starts, sizes, room : int64 (n,), where those of each point are. tree : their area. Returns the
    points placed, rows, which may have grown, and how many are used.
    """
    near, sectors, spare = np.empty((64, 3)), np.empty((64, FIELDS)), np.empty((64, FIELDS))
    if placed == 0:
        add_first(key, distance, points, heads, after, counts, extent, torus)
    while placed < last:
        if placed > 0:
            if tree[1] <= 0:
                break
            i, amount = choose_leaf(tree, draw_unit(key, 2 * placed) * tree[1])
            chance = draw_unit(key, 2 * placed + 1)
            x, y = draw_from_sectors(rows[starts[i] :], sizes[i], amount, chance)
            add_point(placed, i, x, y, distance, points, heads, after, counts, extent, torus)
        near, sectors, spare, rows, used = open_region(
            placed, distance, points, heads, after, counts, extent, torus, offsets, near, sectors, spare,
            rows, used, starts, sizes, room, tree,
        )  # fmt: skip
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
def grow_by_turns(
    key, drawn, placed, last, waiting, active, distance, points, heads, after, counts, extent, torus, offsets,
    done,
):  # fmt: skip
    """Take points in turn and fill the ring of each, up to ``last`` points or until none waits.

    active : int32 (n,), the points that wait. done : bool (n,), whose rings are full. points and the grid
    are filled on. Returns how many numbers were drawn, the points placed and how many wait.
    """
    near, sectors, spare = np.empty((64, 3)), np.empty((64, FIELDS)), np.empty((64, FIELDS))
    laps = np.empty(2, np.int64)
    count_laps(distance, extent, torus, laps)
    if placed == 0:
        add_first(key, distance, points, heads, after, counts, extent, torus)
        active[0] = 0
        drawn, placed, waiting = 2, 1, 1
    while waiting > 0 and placed < last:
        i = take_any(key, drawn, active, waiting)
        drawn += 1
        waiting -= 1
        found, near = find_near(i, 4.0, distance, points, heads, after, counts, extent, torus, offsets, near)
        count = start_ring(points[i], extent, distance, torus, sectors)
        for k in range(found):
            r = 2.0 if done[np.int64(near[k, 0])] else 1.0
            count, sectors, spare = subtract_from_all(sectors, count, near[k, 1], near[k, 2], r, spare)
            if count == 0:
                break
        while count > 0:
            amount = draw_unit(key, drawn) * sum_areas(sectors, count)
            x, y = draw_from_sectors(sectors, count, amount, draw_unit(key, drawn + 1))
            drawn += 2
            add_point(placed, i, x, y, distance, points, heads, after, counts, extent, torus)
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
def grow_by_touch(
    key, drawn, placed, last, waiting, active, distance, points, heads, after, counts, extent, torus, offsets
):  # fmt: skip
    """Take points in turn and put others around each that touch it, as many as there is room for.

    As `grow_by_turns`; the room is ranges of directions.
    """
    near, ranges, spare = np.empty((64, 3)), np.empty((64, 2)), np.empty((64, 2))
    laps = np.empty(2, np.int64)
    count_laps(distance, extent, torus, laps)
    if placed == 0:
        add_first(key, distance, points, heads, after, counts, extent, torus)
        active[0] = 0
        drawn, placed, waiting = 2, 1, 1
    while waiting > 0 and placed < last:
        i = take_any(key, drawn, active, waiting)
        drawn += 1
        waiting -= 1
        ranges[0, 0], ranges[0, 1] = 0.0, 2 * np.pi
        count = 1
        if not torus:
            for a in range(2):
                for ahead in range(2):
                    wall = (extent[a] - points[i, a] if ahead else points[i, a]) / distance
                    if wall < 1:
                        middle = 0.5 * np.pi * a + (0.0 if ahead else np.pi)
                        count, ranges, spare = block_angles(ranges, count, middle, np.arccos(wall), spare)
        found, near = find_near(i, 2.0, distance, points, heads, after, counts, extent, torus, offsets, near)
        for k in range(found):
            count, ranges, spare = block_point(ranges, count, near[k, 1], near[k, 2], spare)
        while count > 0:
            k = np.int64(draw_word(key, drawn) % np.uint64(count))
            angle = ranges[k, 0] + draw_unit(key, drawn + 1) * (ranges[k, 1] - ranges[k, 0])
            drawn += 2
            x, y = np.cos(angle), np.sin(angle)
            add_point(placed, i, x, y, distance, points, heads, after, counts, extent, torus)
            active[waiting] = placed
            placed, waiting = placed + 1, waiting + 1
            for lap_x in range(-laps[0], laps[0] + 1):
                for lap_y in range(-laps[1], laps[1] + 1):
                    ax, ay = x + lap_x * extent[0] / distance, y + lap_y * extent[1] / distance
                    count, ranges, spare = block_point(ranges, count, ax, ay, spare)
    return drawn, placed, waiting
