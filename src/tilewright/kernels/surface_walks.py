"""Walking over triangles: straight on across their sides, and along the boundary where there is no more."""

import numpy as np

from tilewright.kernels.compiled import kernel

_MOST_TRIANGLES = 1000
"""Triangles that one walk may cross; rounding could keep it going around a vertex."""


@kernel()
def walk(triangle, weights, move, twins, slopes):
    """Move a spot straight on by a vector that lies in the plane of its triangle.

    weights : float64 (3,), changed in place; move : float64 (3,), used up. twins : int32 (T, 3);
    slopes : float64 (T, 3, 3), by how much each weight grows with x, y and z. Gives the triangle where it
    ends.
    """
    entered = -1
    for _ in range(_MOST_TRIANGLES):
        # Step 1: how far until a side is reached.
        share, exit = 1.0, -1
        for k in range(3):
            grow = 0.0
            for a in range(3):
                grow += slopes[triangle, k, a] * move[a]
            if grow < 0.0 and k != entered and weights[k] + share * grow < 0.0:
                share, exit = weights[k] / -grow, k
        total = 0.0
        for k in range(3):
            for a in range(3):
                weights[k] += share * slopes[triangle, k, a] * move[a]
            weights[k] = max(weights[k], 0.0) if k != exit else 0.0
            total += weights[k]
        for k in range(3):
            weights[k] /= total
        if exit < 0:
            break
        # Step 2: what is left of the way, along the side and across it.
        square = 0.0
        across = 0.0
        for a in range(3):
            slope = slopes[triangle, exit, a]
            square += slope * slope
            across += slope * move[a]
        for a in range(3):
            move[a] = (1.0 - share) * (move[a] - across / square * slopes[triangle, exit, a])
        side = exit + 1 if exit < 2 else 0
        twin = twins[triangle, side]
        if twin < 0:
            # Step 3a: along the boundary, which is left again only by another side.
            entered = exit
            continue
        # Step 3b: on in the next triangle, whose side runs the other way.
        across = -(1.0 - share) * across / np.sqrt(square)
        here, there = weights[side], weights[side + 1 if side < 2 else 0]
        triangle, begin = twin // 3, twin % 3
        end, entered = (begin + 1) % 3, (begin + 2) % 3
        weights[begin], weights[end], weights[entered] = there, here, 0.0
        square = 0.0
        for a in range(3):
            square += slopes[triangle, entered, a] * slopes[triangle, entered, a]
        for a in range(3):
            move[a] += across * slopes[triangle, entered, a] / np.sqrt(square)
    return triangle


@kernel(parallel=True)
def walk_all(first, last, moving, moves, ground, triangles, weights, places):
    """Walk from the spots that are ``moving``, and write where each comes to lie.

    moving : int32 (m,), numbers of spots; moves : float64 (n, 3), laid into the planes of their triangles.
    ground : vertices float64 (V, 3), corners int32 (T, 3), twins int32 (T, 3), slopes float64 (T, 3, 3).
    triangles : int32 (n,); weights, places : float64 (n, 3).
    """
    vertices, corners, twins, slopes = ground
    move = np.empty(3)
    for m in range(first, last):
        i = moving[m]
        for a in range(3):
            move[a] = moves[i, a]
        t = walk(triangles[i], weights[i], move, twins, slopes)
        triangles[i] = t
        for a in range(3):
            places[i, a] = 0.0
            for k in range(3):
                places[i, a] += weights[i, k] * vertices[corners[t, k], a]
