"""Point sets whose figures are known: white noise and lattices."""

from math import sqrt

import numpy as np

from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet

PLAIN = Box(torus=False)
BOXES = [Box(), Box((2.0, 0.5)), Box((3.0, 1.7), torus=False), Box((46, 46))]


def white(count, seed=0, box=None):
    domain = box or Box()
    return PointSet(np.random.default_rng(seed).random((count, domain.dimension)) * domain.extent, domain)


def square_grid(n, place=0.5, box=None):
    domain = box or Box()
    cells = np.stack(np.meshgrid(np.arange(n), np.arange(n)), axis=-1).reshape(-1, 2)
    return PointSet((cells + place) / n * domain.extent, domain, "square grid")


def hexagons(columns, rows, torus=True):
    """A hexagonal lattice of nearest distance 1; ``rows`` must be even."""
    height = sqrt(3) / 2
    points = [((i + j % 2 / 2), j * height) for j in range(rows) for i in range(columns)]
    return PointSet(np.array(points), Box((columns, rows * height), torus), "hexagons")
