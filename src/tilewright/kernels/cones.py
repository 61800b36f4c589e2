"""Points on cones: the tile of n corners is the cone of n quarter turns about its center, the plane that of
four.

A place is its distance from the apex and its angle, 0 up to the whole turn of the cone. Shapes that are
filled are told by ``shape``: rectangle float64 (2,), half its width and height about the apex; or with a
width of 0 the inside of a tile; then ``corner``, the half width of the octagon about each corner that is left
out, and ``strip``, half the thickness of the strip along each side.
"""

import numpy as np

from tilewright.kernels.chance import draw_unit
from tilewright.kernels.compiled import kernel

_CANDIDATES = 12
_SWEEPS = 300
_EAGER, _EAGER_SWEEPS = 1.12, 12
"""By how much farther than asked points are pushed at first, and how long."""
_BEYOND = 1.004
_POWER = 8.0


@kernel()
def measure(radius, angle, other_radius, other_angle, turn):
    """Distance of two places on a cone."""
    apart = abs(angle - other_angle)
    apart = min(apart, turn - apart)
    if apart >= np.pi:
        return radius + other_radius
    square = radius * radius + other_radius * other_radius - 2.0 * radius * other_radius * np.cos(apart)
    return np.sqrt(max(square, 0.0))


@kernel()
def is_in_octagon(x, y, half):
    """Whether a place lies in the regular octagon of half width ``half`` about the origin."""
    x, y = abs(x), abs(y)
    return max(x, y) <= half and x + y <= half * 1.4142135623730951


@kernel()
def is_free(radius, angle, shape):
    """Whether a place lies in what is to be filled."""
    width, height, corner, strip = shape
    if width > 0.0:
        x, y = radius * np.cos(angle), radius * np.sin(angle)
        if abs(x) > width or abs(y) > height:
            return False
        return not (is_in_octagon(x - 0.5, y, corner) or is_in_octagon(x + 0.5, y, corner))
    turned = angle % (np.pi / 2) - np.pi / 4
    x, y = 0.5 + radius * np.sin(turned), 0.5 - radius * np.cos(turned)
    return y > strip and not (is_in_octagon(x, y, corner) or is_in_octagon(x - 1.0, y, corner))


@kernel()
def throw(key, counter, shape, turn):
    """A place by chance in what is to be filled, and the next counter."""
    width, height = shape[0], shape[1]
    while True:
        u, v = draw_unit(key, counter), draw_unit(key, counter + 1)
        counter += 2
        if width > 0.0:
            x, y = (2.0 * u - 1.0) * width, (2.0 * v - 1.0) * height
            radius, angle = np.sqrt(x * x + y * y), np.arctan2(y, x) % (2.0 * np.pi)
        else:
            # A sector and a place in it: u tells both.
            sectors = turn / (np.pi / 2)
            sector = np.floor(u * sectors)
            along = u * sectors - sector
            depth = np.sqrt(v)
            x, y = depth * (along - 0.5), 0.5 * depth
            radius = np.sqrt(x * x + y * y)
            angle = (sector + 0.5) * (np.pi / 2) + np.arctan2(x, y)
        if is_free(radius, angle, shape):
            return radius, angle, counter


@kernel()
def find_least(radius, angle, places, count, skip, turn):
    """Distance to the nearest of the first ``count`` places but one."""
    least = np.inf
    for j in range(count):
        if j != skip:
            least = min(least, measure(radius, angle, places[j, 0], places[j, 1], turn))
    return least


@kernel()
def fill_cone(key, turn, shape, fixed, last, paired, distance, places):
    """Fill a shape: places[fixed:last] are thrown, each the farthest of some candidates, and pushed apart.

    places : float64 (last, 2), of which the first ``fixed`` stay where they are; with ``paired`` the free
    ones come in twos, the second half a turn about the apex from the first. Whether all keep their distance.
    """
    counter, step = 0, 2 if paired else 1
    for i in range(fixed, last - step + 1, step):
        best = -1.0
        for _ in range(_CANDIDATES):
            radius, angle, counter = throw(key, counter, shape, turn)
            least = find_least(radius, angle, places, i, -1, turn)
            if paired:
                least = min(least, 2.0 * radius)
            if least > best:
                best, places[i, 0], places[i, 1] = least, radius, angle
        if paired:
            places[i + 1, 0], places[i + 1, 1] = places[i, 0], (places[i, 1] + np.pi) % turn
    for sweep in range(_SWEEPS):
        wanted = distance * (_EAGER if sweep < _EAGER_SWEEPS else _BEYOND)
        counter, close = push_sweep(key, counter, turn, shape, fixed, last, step, wanted, distance, places)
        if close == 0 and sweep >= _EAGER_SWEEPS:
            return True
    return False


@kernel()
def push_sweep(key, counter, turn, shape, fixed, last, step, wanted, distance, places):
    """Push every free place away from those that are too close; how many still were, and the next counter."""
    close = 0
    for i in range(fixed, last - step + 1, step):
        radius, angle = places[i, 0], places[i, 1]
        mx, my = 0.0, 0.0  # away from the apex, and with growing angle
        for j in range(last):
            if j == i:
                continue
            apart = angle - places[j, 1]
            if apart > turn / 2:
                apart -= turn
            elif apart < -turn / 2:
                apart += turn
            near = measure(radius, angle, places[j, 0], places[j, 1], turn)
            if near >= wanted:
                continue
            if near < distance:
                close += 1
            share = (wanted - near) * (1.0 if j < fixed else 0.5)
            if abs(apart) >= np.pi or near == 0.0:
                mx += share
                continue
            # The other lies at an angle of -apart from this one, seen from the apex.
            dx, dy = radius - places[j, 0] * np.cos(apart), places[j, 0] * np.sin(apart)
            mx, my = mx + share * dx / near, my + share * dy / near
        if mx == 0.0 and my == 0.0:
            continue
        for _ in range(4):
            x, y = radius + mx, my
            there = np.sqrt(x * x + y * y)
            turned = (angle + np.arctan2(y, x)) % turn
            if is_free(there, turned, shape):
                places[i, 0], places[i, 1] = there, turned
                break
            # Into what is not free: less far, and a little aside.
            aside = (draw_unit(key, counter) - 0.5) * 2.0
            counter += 1
            mx, my = 0.6 * (mx - aside * my), 0.6 * (my + aside * mx)
        if step == 2:
            places[i + 1, 0], places[i + 1, 1] = places[i, 0], (places[i, 1] + np.pi) % turn
    return counter, close


@kernel()
def rank_cone(turn, points, outside, places, order):
    """The order in which points of a tile may be left out last to first: the most crowded goes first.

    places : float64 (points + outside, 2): those of the tile, then those around it, which thin out as it
    does. order : int64 (points,): the numbers of the points, the one that stays longest first.
    """
    gone = np.zeros(points, np.bool_)
    loads = np.zeros(points)
    left, next_stage = points, points
    reach = 0.0
    area = turn / (2.0 * np.pi)  # in squares of four quarter turns, of side 1
    while left > 0:
        if left == next_stage:
            # Distances count on the scale of half as many points (Yuksel 2015, section 3).
            next_stage = left // 2
            reach = 2.0 / np.sqrt(2.0 * np.sqrt(3.0) * max(left / 2.0, 0.5) / area)
            for i in range(points):
                loads[i] = 0.0
                if gone[i]:
                    continue
                for j in range(points + outside):
                    if j == i or (j < points and gone[j]):
                        continue
                    near = measure(places[i, 0], places[i, 1], places[j, 0], places[j, 1], turn)
                    if near < reach:
                        weight = (1.0 - near / reach) ** _POWER
                        loads[i] += weight if j < points else weight * left / points
        worst = -1
        for i in range(points):
            if not gone[i] and (worst < 0 or loads[i] > loads[worst]):
                worst = i
        gone[worst] = True
        left -= 1
        order[left] = worst
        for i in range(points):
            if not gone[i]:
                near = measure(places[i, 0], places[i, 1], places[worst, 0], places[worst, 1], turn)
                if near < reach:
                    loads[i] -= (1.0 - near / reach) ** _POWER
