"""Steps that even out points of a surface: pushes apart, and moves to the middles of their cells."""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.polygons import cut_cell, find_reach, is_cut

_CORNERS = 40
_BEYOND = 1.003
"""How much farther than asked pairs are pushed, so that they do not come there by ever smaller steps."""


@kernel(parallel=True)
def push_apart(first, last, active, places, normals, lists, counts, wanted, moves, close):
    """How far each point is pushed by those that are too close: half of what is missing, by every one.

    active : int32 (m,); places, normals : float64 (n, 3); lists : int32 (n, room); wanted : float64 (n,),
    half of the distance that two of its kind keep. moves : float64 (n, 3); close : int32 (n,), how many are
    too close.
    """
    for m in range(first, last):
        i = active[m]
        moves[i] = 0.0
        close[i] = 0
        for s in range(counts[i]):
            j = lists[i, s]
            dx, dy, dz = places[i, 0] - places[j, 0], places[i, 1] - places[j, 1], places[i, 2] - places[j, 2]
            square = dx * dx + dy * dy + dz * dz
            least = wanted[i] + wanted[j]
            if square >= least * least:
                continue
            close[i] += 1
            # Along the plane of its triangle, as far as it would be in a straight line.
            height = dx * normals[i, 0] + dy * normals[i, 1] + dz * normals[i, 2]
            dx, dy, dz = dx - height * normals[i, 0], dy - height * normals[i, 1], dz - height * normals[i, 2]
            flat = np.sqrt(dx * dx + dy * dy + dz * dz)
            if flat < 1e-9 * least:
                continue
            push = 0.5 * (_BEYOND * least - np.sqrt(square)) / flat
            moves[i, 0] += push * dx
            moves[i, 1] += push * dy
            moves[i, 2] += push * dz


@kernel()
def find_axes(normal, axes):
    """Two unit vectors at right angles to each other and to a normal, float64 (2, 3)."""
    least = 0
    for a in range(1, 3):
        if abs(normal[a]) < abs(normal[least]):
            least = a
    b, c = (least + 1) % 3, (least + 2) % 3
    length = np.sqrt(normal[b] * normal[b] + normal[c] * normal[c])
    axes[0, least], axes[0, b], axes[0, c] = 0.0, normal[c] / length, -normal[b] / length
    for a in range(3):
        b, c = (a + 1) % 3, (a + 2) % 3
        axes[1, a] = normal[b] * axes[0, c] - normal[c] * axes[0, b]


@kernel()
def lay_flat(here, there, axes):
    """What lies between two places, along two axes, and how long it is in space."""
    x, y, square = 0.0, 0.0, 0.0
    for a in range(3):
        way = there[a] - here[a]
        x, y, square = x + way * axes[0, a], y + way * axes[1, a], square + way * way
    return x, y, np.sqrt(square)


@kernel(parallel=True)
def center_cells(first, last, points, lists, counts, walls, wall_lists, wall_counts, spacing, omega, out):
    """How far the middle of each point's cell is, and its farthest corner.

    points : places, normals float64 (n, 3). walls : begins, ends, normals float64 (w, 3) of pieces of the
    boundary; wall_lists : int32 (n, room). spacing : float64 (n,). out : moves, far float64 (n, 3), reach
    float64 (n,).
    """
    places, normals = points
    begins, ends = walls
    moves, far, reaches = out
    one, other, axes = np.empty((_CORNERS, 3)), np.empty((_CORNERS, 3)), np.empty((2, 3))
    for i in range(first, last):
        # Step 1: two axes of the plane of its triangle.
        find_axes(normals[i], axes)
        # Step 2: a square, cut by the bisectors with its neighbors, the nearest first.
        half = 2.4 * spacing[i]
        one[0, 0], one[0, 1], one[1, 0], one[1, 1] = -half, -half, half, -half
        one[2, 0], one[2, 1], one[3, 0], one[3, 1] = half, half, -half, half
        corners, reach = 4, 2.0 * half * half
        for s in range(counts[i] + wall_counts[i]):
            if s < counts[i]:
                j = lists[i, s]
                x, y, whole = lay_flat(places[i], places[j], axes)
                flat = np.sqrt(x * x + y * y)
                # One farther than twice the farthest corner cuts nothing, nor one on another sheet.
                if whole * whole > 4.0 * reach or flat < 0.3 * whole or whole == 0.0:
                    continue
                x, y = x * whole / flat, y * whole / flat
            else:
                # A boundary cuts as the point's mirror image behind it would.
                j = wall_lists[i, s - counts[i]]
                px, py, _ = lay_flat(places[i], begins[j], axes)
                qx, qy, _ = lay_flat(begins[j], ends[j], axes)
                square = qx * qx + qy * qy
                if square == 0.0:
                    continue
                # The surface lies left of its boundary, so outside is to the right: (qy, -qx).
                off = (px * qy - py * qx) / square
                off = max(off, 1e-6 * spacing[i] / np.sqrt(square))
                x, y = 2.0 * off * qy, -2.0 * off * qx
            if corners + 2 < _CORNERS and is_cut(one, corners, x, y):
                corners = cut_cell(one, corners, x, y, 0.0, other)
                one, other = other, one
                if corners < 3:
                    break
                reach = find_reach(one, corners)
        # Step 3: its middle, and its farthest corner.
        moves[i] = 0.0
        far[i] = 0.0
        reaches[i] = 0.0
        if corners < 3:
            continue
        area, mx, my = 0.0, 0.0, 0.0
        for k in range(corners):
            l = k + 1 if k + 1 < corners else 0
            doubled = one[k, 0] * one[l, 1] - one[k, 1] * one[l, 0]
            area += doubled
            mx += doubled * (one[k, 0] + one[l, 0])
            my += doubled * (one[k, 1] + one[l, 1])
            square = one[k, 0] * one[k, 0] + one[k, 1] * one[k, 1]
            if square > reaches[i]:
                reaches[i] = square
                for a in range(3):
                    far[i, a] = one[k, 0] * axes[0, a] + one[k, 1] * axes[1, a]
        reaches[i] = np.sqrt(reaches[i])
        if area > 0.0:
            mx, my = omega * mx / (3.0 * area), omega * my / (3.0 * area)
            for a in range(3):
                moves[i, a] = mx * axes[0, a] + my * axes[1, a]
