"""Normals that make a surface of triangles look round but keep its creases."""

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.surface import Surface

_CREASE = np.cos(np.radians(60))
"""Triangles around a vertex that turn away farther than this are beyond a crease."""
_MANY = 32
"""Of vertices with more triangles all are taken together."""


def corner_normals(surface: Surface, flat: bool) -> NDArray[np.float64]:
    """Unit normals at the corners of every triangle, (T, 3, 3).

    Each is the mean, by area, of the triangles around the vertex on the same side of creases, or the
    triangle's own where the surface is to look flat.
    """
    own = np.repeat(surface.normals, 3, axis=0)
    if flat:
        return own.reshape(-1, 3, 3)
    vertices = surface.triangles.ravel().astype(np.int64)
    pull = own * surface.areas.repeat(3)[:, np.newaxis]
    corners, others = _pairs_around(vertices)
    close = np.einsum("nd,nd->n", own[corners], own[others]) >= _CREASE
    smooth = _sum_by(corners[close], pull[others[close]], len(vertices))
    many = (np.bincount(vertices) > _MANY)[vertices]
    together = _unit(_sum_by(vertices, pull, len(surface.vertices)))[vertices]
    smooth[many] = np.where((together * own).sum(axis=1, keepdims=True) >= _CREASE, together, own)[many]
    return _unit(smooth).reshape(-1, 3, 3)


def _pairs_around(vertices: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """All pairs of corners that share a vertex of not too many, each with itself too."""
    order = np.argsort(vertices, kind="stable")
    counts = np.bincount(vertices)
    starts = np.concatenate([[0], np.cumsum(counts)])
    few = np.flatnonzero(counts[vertices] <= _MANY)
    sizes = counts[vertices[few]]
    ahead = np.arange(sizes.sum()) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    return few.repeat(sizes), order[starts[vertices[few]].repeat(sizes) + ahead]


def _sum_by(numbers: NDArray[np.int64], vectors: NDArray[np.float64], count: int) -> NDArray[np.float64]:
    """Sums of the vectors of each number, (count, 3)."""
    return np.stack([np.bincount(numbers, vectors[:, d], count) for d in range(3)], axis=1)


def _unit(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-300)
