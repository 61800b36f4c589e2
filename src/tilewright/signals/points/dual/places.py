"""Coordinates: squares about corners and sides, sectors of tiles, and the cone that a tile is.

A sector is a triangle with its base from (0, 0), a corner, to (1, 0), the next, and its apex at (.5, .5), the
center of the tile. Sector i lies between the angles i and i + 1 quarter turns of the cone about that center.
"""

import numpy as np
from numpy.typing import NDArray

QUARTER = np.pi / 2


def rotate(points: NDArray[np.float64], quarters: int) -> NDArray[np.float64]:
    """Points turned counter-clockwise about the origin by quarters."""
    x, y = points[:, 0], points[:, 1]
    turned = ((x, y), (-y, x), (-x, -y), (y, -x))[quarters % 4]
    return np.stack(turned, axis=1)


def to_cone(points: NDArray[np.float64], sector: int, corners: int) -> NDArray[np.float64]:
    """Places on the cone of n quarter turns of points in, or near, one of its sectors."""
    x, y = points[:, 0] - 0.5, points[:, 1] - 0.5
    angles = (sector + 0.5) * QUARTER + np.arctan2(x, -y)
    return np.stack([np.hypot(x, y), angles % (corners * QUARTER)], axis=1)


def to_sectors(places: NDArray[np.float64], corners: int) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """The sector of places on the cone, and the points there."""
    sectors = np.minimum((places[:, 1] / QUARTER).astype(np.int64), corners - 1)
    turned = places[:, 1] - (sectors + 0.5) * QUARTER
    x, y = 0.5 + places[:, 0] * np.sin(turned), 0.5 - places[:, 0] * np.cos(turned)
    return sectors, np.stack([x, y], axis=1)


def to_polar(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Places on the cone of four quarter turns of points of the plane."""
    x, y = points[:, 0], points[:, 1]
    return np.stack([np.hypot(x, y), np.arctan2(y, x) % (4 * QUARTER)], axis=1)


def to_plane(places: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same way back."""
    return places[:, :1] * np.stack([np.cos(places[:, 1]), np.sin(places[:, 1])], axis=1)


def in_octagon(points: NDArray[np.float64], half: float) -> NDArray[np.bool_]:
    """Which points lie in the regular octagon of half width ``half`` about the origin."""
    x, y = np.abs(points).T
    inside: NDArray[np.bool_] = (np.maximum(x, y) <= half) & (x + y <= half * np.sqrt(2))
    return inside
