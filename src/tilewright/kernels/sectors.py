"""Scalloped sectors: what disks leave of the ring around a point (Dunbar & Humphreys 2006, section 4).

A sector is the part of the plane between two angles and two curves, as seen from its apex: a row of
(from, to, inner curve, outer curve, area), angles in radians, ``from`` less than ``to``. A curve is (x, y, r,
kind): the near (kind -1) or far (+1) side of a circle around (x, y), or (0) the straight line at distance r
along the unit vector (x, y). Lengths are in units of the least distance of two points, so the ring goes
from 1 to 2.
"""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.polygons import enlarge
from tilewright.kernels.weights import CLOSE, STEPS, step_inside

INNER, OUTER, AREA, FIELDS = 2, 6, 10, 11
"""Where a sector's row has its curves and its area, and how long it is."""

_NOTHING = 1e-12
"""Area that counts as none: rounding errors make as much."""
_TOUCHING = 1e-9
"""Squared length by which circles that pass by each other still count as touching."""
_TURN = 2 * np.pi


@kernel()
def find_curve(sector, c, angle):
    """Distance from the apex to the curve at ``c`` in a direction."""
    x, y, r = sector[c], sector[c + 1], sector[c + 2]
    along = x * np.cos(angle) + y * np.sin(angle)
    if sector[c + 3] == 0:
        return r / along
    return along + sector[c + 3] * np.sqrt(max(r * r - x * x - y * y + along * along, 0.0))


@kernel()
def integrate_curve(sector, c, angle):
    """Area between the apex and the curve at ``c`` up to ``angle``, but for a constant."""
    x, y, r = sector[c], sector[c + 1], sector[c + 2]
    cosine, sine = np.cos(angle), np.sin(angle)
    along, across = x * cosine + y * sine, x * sine - y * cosine
    if sector[c + 3] == 0:
        return 0.5 * r * r * across / along
    if x == 0 and y == 0:
        return 0.5 * r * r * angle
    root = np.sqrt(max(r * r - across * across, 0.0))
    arc = across * root + r * r * np.arcsin(min(max(across / r, -1.0), 1.0))
    return 0.5 * (across * along + r * r * angle + sector[c + 3] * arc)


@kernel()
def measure_sector(sector, angle):
    """Area of a sector up to ``angle``."""
    outer = integrate_curve(sector, OUTER, angle) - integrate_curve(sector, OUTER, sector[0])
    return outer - integrate_curve(sector, INNER, angle) + integrate_curve(sector, INNER, sector[0])


@kernel()
def add_angle(angles, count, sector, angle):
    """Note where a sector has to be divided, if that is inside it; how many such angles there are."""
    turned = sector[0] + (angle - sector[0]) % _TURN
    if sector[0] < turned < sector[1]:
        at = count
        while at > 0 and angles[at - 1] > turned:
            angles[at] = angles[at - 1]
            at -= 1
        angles[at] = turned
        return count + 1
    return count


@kernel()
def add_crossings(angles, count, sector, c, x, y, r):
    """Note the directions in which the curve at ``c`` meets the circle of radius r around (x, y)."""
    cx, cy, cr = sector[c], sector[c + 1], sector[c + 2]
    if sector[c + 3] == 0:
        ux, uy = cx, cy
        along = cr - (ux * x + uy * y)
        square = r * r - along * along
        fx, fy = x, y
    else:
        ux, uy = x - cx, y - cy
        apart = np.sqrt(ux * ux + uy * uy)
        if apart < 1e-12:
            return count
        ux, uy = ux / apart, uy / apart
        along = (apart * apart + cr * cr - r * r) / (2 * apart)
        square = cr * cr - along * along
        fx, fy = cx, cy
    if square < -_TOUCHING:
        return count
    # From the center along the unit vector, then to both sides.
    side = np.sqrt(max(square, 0.0))
    for sign in (-1.0, 1.0):
        px, py = fx + along * ux - sign * side * uy, fy + along * uy + sign * side * ux
        count = add_angle(angles, count, sector, np.arctan2(py, px))
    return count


@kernel()
def write_curve(sector, c, x, y, r, kind):
    """Set the curve at ``c``."""
    sector[c], sector[c + 1], sector[c + 2], sector[c + 3] = x, y, r, kind


@kernel()
def subtract_disk(sector, x, y, r, first, width, out, count):
    """Write what a disk of radius r around (x, y) leaves of a sector into out[count:]; the new count.

    first, width : the directions in which the disk lies.
    """
    square = x * x + y * y
    start = (first - sector[0]) % _TURN
    if start >= sector[1] - sector[0] and start + width <= _TURN:
        out[count] = sector
        return count + 1
    # Divide where the disk is touched or its circle meets a curve.
    angles = np.empty(8)
    divisions = 0
    if square > r * r:
        divisions = add_angle(angles, divisions, sector, first)
        divisions = add_angle(angles, divisions, sector, first + width)
    divisions = add_crossings(angles, divisions, sector, INNER, x, y, r)
    divisions = add_crossings(angles, divisions, sector, OUTER, x, y, r)
    begin = count
    low, code = sector[0], -1
    for k in range(divisions + 1):
        high = angles[k] if k < divisions else sector[1]
        middle = 0.5 * (low + high)
        inner, outer = find_curve(sector, INNER, middle), find_curve(sector, OUTER, middle)
        along = x * np.cos(middle) + y * np.sin(middle)
        root = r * r - square + along * along
        near = far = np.inf
        if root > 0 and (along > 0 or square < r * r):
            near, far = along - np.sqrt(root), along + np.sqrt(root)
        before = code
        if far <= inner or near >= outer:
            code = 0
        else:
            code = 1 + (2 if inner < near else 0) + (4 if far < outer else 0)
        # A division that changed nothing: what is there goes on.
        pieces = 1 if code == 0 else (code - 1) // 4 + (code - 1) // 2 % 2
        if code == before:
            for piece in range(count - pieces, count):
                out[piece, 1] = high
        else:
            for piece in range(count, count + pieces):
                out[piece] = sector
                out[piece, 0], out[piece, 1] = low, high
            if code > 0 and (code - 1) // 2 % 2 == 1:
                write_curve(out[count], OUTER, x, y, r, -1.0)
            count += pieces
            if code > 4:
                write_curve(out[count - 1], INNER, x, y, r, 1.0)
        low = high
    # Keep what has an area.
    left = begin
    for piece in range(begin, count):
        area = measure_sector(out[piece], out[piece, 1])
        if area > _NOTHING:
            out[left] = out[piece]
            out[left, AREA] = area
            left += 1
    return left


@kernel()
def subtract_from_all(sectors, count, x, y, r, spare):
    """Subtract a disk from several sectors; how many there are then, in ``spare``, and both scratches."""
    apart = np.sqrt(x * x + y * y)
    if apart >= r + 2.0:
        return count, sectors, spare
    first, width = 0.0, _TURN
    if apart > r:
        width = 2 * np.arcsin(r / apart)
        first = np.arctan2(y, x) - width / 2
    left = 0
    for i in range(count):
        spare = enlarge(spare, left + 16)
        left = subtract_disk(sectors[i], x, y, r, first, width, spare, left)
    return left, spare, sectors


@kernel()
def start_ring(point, extent, distance, torus, sectors):
    """The ring from 1 to 2 around a point, inside a plain box; how many sectors it makes.

    point, extent : float64 (2,), not in units of the ``distance``. sectors : room for 32, filled.
    """
    whole = np.empty(FIELDS)
    whole[0], whole[1] = 0.0, _TURN
    write_curve(whole, INNER, 0.0, 0.0, 1.0, 1.0)
    write_curve(whole, OUTER, 0.0, 0.0, 2.0, 1.0)
    if torus:
        whole[AREA] = measure_sector(whole, _TURN)
        sectors[0] = whole
        return 1
    walls = np.zeros((4, 3))  # west, east, north, south: outward and how far
    for a in range(2):
        walls[2 * a, a], walls[2 * a, 2] = -1.0, point[a] / distance
        walls[2 * a + 1, a], walls[2 * a + 1, 2] = 1.0, (extent[a] - point[a]) / distance
    # Divide where a wall meets a circle or another wall.
    angles = np.empty(32)
    divisions = 0
    for w in range(4):
        middle = np.arctan2(walls[w, 1], walls[w, 0])
        for r in (1.0, 2.0):
            if walls[w, 2] < r:
                half = np.arccos(walls[w, 2] / r)
                divisions = add_angle(angles, divisions, whole, middle - half)
                divisions = add_angle(angles, divisions, whole, middle + half)
    for east in range(2):
        for south in range(2, 4):
            corner = np.arctan2(walls[south, 1] * walls[south, 2], walls[east, 0] * walls[east, 2])
            divisions = add_angle(angles, divisions, whole, corner)
    count = 0
    low = 0.0
    for k in range(divisions + 1):
        high = angles[k] if k < divisions else _TURN
        middle = 0.5 * (low + high)
        nearest, outer = -1, 2.0
        for w in range(4):
            toward = walls[w, 0] * np.cos(middle) + walls[w, 1] * np.sin(middle)
            if toward > 0 and walls[w, 2] / toward < outer:
                nearest, outer = w, walls[w, 2] / toward
        if outer > 1:
            sectors[count] = whole
            sectors[count, 0], sectors[count, 1] = low, high
            if nearest >= 0:
                ux, uy, apart = walls[nearest]
                write_curve(sectors[count], OUTER, ux, uy, apart, 0.0)
            sectors[count, AREA] = measure_sector(sectors[count], high)
            if sectors[count, AREA] > _NOTHING:
                count += 1
        low = high
    return count


@kernel()
def sum_areas(sectors, count):
    """Area of several sectors."""
    area = 0.0
    for i in range(count):
        area += sectors[i, AREA]
    return area


@kernel()
def draw_from_sectors(sectors, count, amount, chance):
    """A point of the sectors, as seen from their apex: the one up to which there is ``amount`` of area.

    chance : of [0, 1), says how far out.
    """
    i = 0
    while i < count - 1 and amount >= sectors[i, AREA]:
        amount -= sectors[i, AREA]
        i += 1
    sector = sectors[i]
    amount = min(amount, sector[AREA])
    low, high = sector[0], sector[1]
    angle = 0.5 * (low + high)
    for _ in range(STEPS):
        before = angle
        inner, outer = find_curve(sector, INNER, angle), find_curve(sector, OUTER, angle)
        missing = amount - measure_sector(sector, angle)
        angle, low, high = step_inside(angle, low, high, missing, 0.5 * (outer * outer - inner * inner))
        if abs(angle - before) <= CLOSE * (sector[1] - sector[0]):
            break
    inner, outer = find_curve(sector, INNER, angle), find_curve(sector, OUTER, angle)
    out = np.sqrt(inner * inner + chance * max(outer * outer - inner * inner, 0.0))
    return out * np.cos(angle), out * np.sin(angle)
