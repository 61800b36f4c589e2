"""Boxes that every sampler is tried in, and how close and how far points of a set are."""

from itertools import product

import numpy as np
import pytest
from scipy.spatial import cKDTree

from tilewright.samplers import METHODS, Box, PointSet, nearest_distances

ALMOST = 1 - 1e-9
"""Rounding that a promised distance may lose."""

TORUS, PLAIN = Box(), Box(torus=False)
LONG, LOW = Box((3.0, 0.5)), Box((0.7, 20.0), torus=False)
CUBE, ROOM = Box((1.0, 1.0, 1.0)), Box((1.0, 2.0, 0.5), torus=False)
BOXES = {"torus": TORUS, "plain": PLAIN, "long": LONG, "low": LOW, "cube": CUBE, "room": ROOM}
FILLING = [name for name, method in METHODS.items() if method.fills]


def works_in(method: str, box: Box) -> None:
    if box.dimension not in METHODS[method].dimensions:
        pytest.skip(f"{method} works in planes")
    if box.torus and not METHODS[method].tori:
        pytest.skip(f"{method} does not go around tori")


def least_distance(points: np.ndarray, box: Box) -> float:
    """By comparing all pairs, images and all; of many points by SciPy."""
    if len(points) > 400:
        return float(nearest_distances(points, box).min())
    laps = product((-1, 0, 1), repeat=box.dimension) if box.torus else [(0,) * box.dimension]
    least = np.inf
    for lap in laps:
        apart = np.linalg.norm(points[:, None] - points + np.multiply(lap, box.extent), axis=2)
        if not any(lap):
            np.fill_diagonal(apart, np.inf)
        least = min(least, apart.min())
    return float(least)


def widest_gap(made: PointSet, steps: int) -> float:
    """From a fine grid of places, the farthest from all points; in units of the promised distance."""
    sides = np.array(made.box.extent)
    counts = np.maximum((steps * sides / sides.max()).astype(int), 8)
    axes = [(np.arange(c) + 0.5) / c * side for c, side in zip(counts, sides, strict=True)]
    places = np.stack(np.meshgrid(*axes), -1).reshape(-1, len(sides))
    tree = cKDTree(made.points, boxsize=sides if made.box.torus else None)
    return float(tree.query(places)[0].max()) / made.distance
