"""The spots of a surface that are nearest to places in space."""

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.spots import Spots
from tilewright.domains.surface import Surface

_BATCH = 16384
"""Places looked at together, which bounds the memory of their candidates."""


def nearest_spots(surface: Surface, places: NDArray[np.float64]) -> tuple[Spots, NDArray[np.float64]]:
    """The nearest spot of a surface to each place (n, 3), and how far it is, float64, shape (n,)."""
    from scipy.spatial import KDTree

    corners = surface.vertices[surface.triangles]
    middles = corners.mean(axis=1)
    reach = np.sqrt(((corners - middles[:, np.newaxis]) ** 2).sum(axis=2).max(axis=1))
    # Step 1: triangles of about one size share a tree, so that small ones need no wide search.
    octaves = np.floor(np.log2(reach)).astype(np.int64)
    groups = [np.flatnonzero(octaves == octave) for octave in np.unique(octaves)]
    trees = [(KDTree(middles[group]), group, float(reach[group].max())) for group in groups]
    found, weights = np.zeros(len(places), np.int32), np.zeros((len(places), 3))
    distances = np.full(len(places), np.inf)
    for first in range(0, len(places), _BATCH):
        batch = np.arange(first, min(first + _BATCH, len(places)))
        # Step 2: the triangle of the nearest middle bounds the distance.
        for tree, group, _ in trees:
            near = group[tree.query(places[batch])[1]]
            _take_nearer(surface, places, batch, near, (found, weights, distances))
        # Step 3: of the others only those are looked at whose spheres come as near.
        for tree, group, most in trees:
            lists = tree.query_ball_point(places[batch], distances[batch] * (1 + 1e-12) + most)
            counts = np.array([len(row) for row in lists])
            near = group[np.concatenate([np.asarray(row, np.int64) for row in lists])]
            _take_nearer(surface, places, np.repeat(batch, counts), near, (found, weights, distances))
    return Spots(found, weights), distances


def _take_nearer(
    surface: Surface,
    places: NDArray[np.float64],
    which: NDArray[np.int64],
    triangles: NDArray[np.int64],
    best: tuple[NDArray[np.int32], NDArray[np.float64], NDArray[np.float64]],
) -> None:
    """Keep for each place the nearest of the triangles that are named for it, the first of equal ones."""
    found, weights, distances = best
    made = nearest_weights(surface.vertices[surface.triangles[triangles]], places[which])
    there = np.einsum("nk,nkd->nd", made, surface.vertices[surface.triangles[triangles]])
    apart = np.linalg.norm(there - places[which], axis=1)
    order = np.lexsort((triangles, apart, which))
    order = order[np.diff(which[order], prepend=-1) != 0]
    order = order[apart[order] < distances[which[order]]]
    to = which[order]
    found[to], weights[to], distances[to] = triangles[order], made[order], apart[order]


def nearest_weights(corners: NDArray[np.float64], places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Weights of the point of each triangle (n, 3, 3) that is nearest to a place (n, 3)."""
    a, b, c = corners.swapaxes(0, 1)
    first, second, rest = b - a, c - a, places - a
    # Step 1: below the place, where that is within the triangle.
    normal = np.cross(first, second)
    square = (normal**2).sum(axis=1)
    v = np.einsum("nd,nd->n", np.cross(rest, second), normal) / square
    w = np.einsum("nd,nd->n", np.cross(first, rest), normal) / square
    made = np.stack([1 - v - w, v, w], axis=1)
    # Step 2: else on the nearest of its three sides.
    outside = np.flatnonzero(made.min(axis=1) < 0)
    least = np.full(len(outside), np.inf)
    for k in range(3):
        begin, end = corners[outside, k], corners[outside, (k + 1) % 3]
        along = end - begin
        share = np.einsum("nd,nd->n", places[outside] - begin, along) / (along**2).sum(axis=1)
        share = np.clip(share, 0, 1)
        apart = ((begin + share[:, np.newaxis] * along - places[outside]) ** 2).sum(axis=1)
        nearer = apart < least
        least[nearer] = apart[nearer]
        rows = outside[nearer]
        made[rows] = 0.0
        made[rows, k], made[rows, (k + 1) % 3] = 1 - share[nearer], share[nearer]
    return made
