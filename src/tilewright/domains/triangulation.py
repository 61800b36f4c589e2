"""Faces cut into triangles, and a flat polygon for each face that its points are placed in.

Parameter polygons are the unit triangle, the unit square or a regular polygon. Points that are placed there
and lifted by the triangles of the face need no projection, which left holes on warped faces.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.half_edges import HalfEdges, pair
from tilewright.domains.surface import Surface

_THIN = 1e-12
"""Twice the area of a triangle over the square of its longest side, below which it counts as a line."""


@dataclass(frozen=True, eq=False)
class Triangulation:
    """The triangles of faces, those of a face one after another.

    Attributes
    ----------
    surface : Surface
        The T triangles.
    faces : int64 array, shape (T,)
        The face each is a part of.
    starts : int64 array, shape (F + 1,)
        Where the triangles of each face start and end.
    polygons : float64 array, shape (H, 2)
        Every corner's place in the parameter polygon of its face.
    uv : float64 array, shape (T, 3, 2)
        The same for the corners of the triangles.
    corners : int64 array, shape (T, 3)
        The half-edges that begin at the corners of the triangles.
    """

    surface: Surface
    faces: NDArray[np.int64]
    starts: NDArray[np.int64]
    polygons: NDArray[np.float64]
    uv: NDArray[np.float64]
    corners: NDArray[np.int64]

    @cached_property
    def stretches(self) -> NDArray[np.float64]:
        """Area on the surface over area in the parameter polygon, of every triangle, float64, shape (T,)."""
        first, second = self.uv[:, 1] - self.uv[:, 0], self.uv[:, 2] - self.uv[:, 0]
        return self.surface.areas / (np.abs(_cross(first, second)) / 2)


def triangulate(vertices: NDArray[np.float64], half_edges: HalfEdges) -> tuple[Triangulation, int]:
    """Cut every face into triangles by a fan from its first corner, or by ears where that turns one over.

    Also tells how many triangles without area were left out.
    """
    starts, sizes = half_edges.starts, np.diff(half_edges.starts)
    corners = _fan(starts, sizes)
    faces = np.repeat(np.arange(len(sizes)), sizes - 2)
    bad = np.unique(faces[_turned_over(vertices, half_edges, corners, faces)])
    firsts = np.concatenate([[0], np.cumsum(sizes - 2)])
    for face in bad.tolist():
        ring = np.arange(starts[face], starts[face + 1])
        corners[firsts[face] : firsts[face + 1]] = ring[_cut_ears(vertices[half_edges.origins[ring]])]
    stay = _heights(vertices[half_edges.origins[corners]]) > _THIN
    corners, faces = corners[stay], faces[stay]
    surface = Surface(
        vertices, half_edges.origins[corners].astype(np.int32), _triangle_twins(half_edges, corners, faces)
    )
    polygons = _polygons(starts, sizes)
    counts = np.bincount(faces, minlength=len(sizes))
    made = Triangulation(
        surface, faces, np.concatenate([[0], np.cumsum(counts)]), polygons, polygons[corners], corners
    )
    return made, int((~stay).sum())


def _fan(starts: NDArray[np.int64], sizes: NDArray[np.int64]) -> NDArray[np.int64]:
    """Corners of the triangles of fans, shape (T, 3)."""
    faces = np.repeat(np.arange(len(sizes)), sizes - 2)
    firsts = np.concatenate([[0], np.cumsum(sizes - 2)])
    steps = np.arange(len(faces)) - firsts[faces]
    first = starts[:-1][faces]
    return np.stack([first, first + steps + 1, first + steps + 2], axis=1)


def _heights(places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Twice the area of triangles over the square of their longest sides."""
    sides = places - np.roll(places, 1, axis=1)
    doubled = np.linalg.norm(np.cross(sides[:, 1], sides[:, 2]), axis=1)
    heights: NDArray[np.float64] = doubled / (sides**2).sum(axis=2).max(axis=1)
    return heights


def _turned_over(
    vertices: NDArray[np.float64],
    half_edges: HalfEdges,
    corners: NDArray[np.int64],
    faces: NDArray[np.int64],
) -> NDArray[np.bool_]:
    """Which triangles of larger faces look away from their face, or have no area."""
    a, b, c = (vertices[half_edges.origins[corners[:, k]]] for k in range(3))
    doubled = np.cross(b - a, c - a)
    total = np.zeros((int(faces[-1]) + 1, 3))
    np.add.at(total, faces, doubled)
    length = np.linalg.norm(doubled, axis=1) * np.linalg.norm(total[faces], axis=1)
    found: NDArray[np.bool_] = np.einsum("td,td->t", doubled, total[faces]) <= 1e-9 * length
    return found


def _cut_ears(places: NDArray[np.float64]) -> NDArray[np.int64]:
    """Triangles of one polygon by cutting ears, the roundest first; shape (n - 2, 3)."""
    after = np.roll(places, -1, axis=0)
    normal = np.cross(places, after).sum(axis=0)
    axis = int(np.argmax(np.abs(normal)))
    flat = np.delete(places, axis, axis=1) * ([1, -1][axis == 1] * np.sign(normal[axis]), 1)
    ring, made = list(range(len(places))), []
    round = [_roundness(flat, ring, k) for k in range(len(ring))]
    while len(ring) > 3:
        if max(round) < 0:  # what lay within an ear may be gone
            round = [_roundness(flat, ring, k) for k in range(len(ring))]
        k = round.index(max(round))
        made.append((ring[k - 1], ring[k], ring[(k + 1) % len(ring)]))
        del ring[k], round[k]
        for near in (k - 1, k % len(ring)):  # the only ones whose ears have changed
            round[near] = _roundness(flat, ring, near)
    return np.array([*made, ring])


def _roundness(flat: NDArray[np.float64], ring: list[int], k: int) -> float:
    """How round the ear at the k-th corner of what is left is; below 0 where it is none."""
    a, b, c = flat[ring[k - 1]], flat[ring[k]], flat[ring[(k + 1) % len(ring)]]
    doubled = _cross(b - a, c - a)
    longest = max(((b - a) ** 2).sum(), ((c - b) ** 2).sum(), ((a - c) ** 2).sum())
    if doubled <= 0:
        return float(doubled / longest) - 1.0
    others = flat[[i for i in ring if i not in (ring[k - 1], ring[k], ring[(k + 1) % len(ring)])]]
    inside = (
        (_cross(b - a, others - a) >= 0) & (_cross(c - b, others - b) >= 0) & (_cross(a - c, others - c) >= 0)
    )
    return -0.5 if inside.any() else float(doubled / longest)


def _cross(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    crossed: NDArray[np.float64] = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return crossed


def _triangle_twins(
    half_edges: HalfEdges, corners: NDArray[np.int64], faces: NDArray[np.int64]
) -> NDArray[np.int32]:
    """What lies across every side of the triangles, as `Surface` tells it."""
    targets = np.roll(corners, -1, axis=1)
    # Sides that are sides of the face meet as its half-edges do, the others within the face.
    outer = half_edges.nexts[corners] == targets
    table = np.full(len(half_edges), -1)
    table[corners[outer]] = np.flatnonzero(outer)
    across = half_edges.twins[corners[outer]]
    twins = np.full(outer.shape, -1)
    twins[outer] = np.where(across >= 0, table[across], -1)
    if not outer.all():
        twins[~outer] = _renumbered(pair(corners[~outer], targets[~outer]), np.flatnonzero(~outer))
    return twins.astype(np.int32)


def _renumbered(twins: NDArray[np.int64], numbers: NDArray[np.int64]) -> NDArray[np.int64]:
    return np.where(twins >= 0, numbers[twins], -1)


def _polygons(starts: NDArray[np.int64], sizes: NDArray[np.int64]) -> NDArray[np.float64]:
    """The corners of the parameter polygons, one after another."""
    size = np.repeat(sizes, sizes)
    step = np.arange(int(starts[-1])) - np.repeat(starts[:-1], sizes)
    angle = 2 * np.pi * step / size
    places = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    places[size == 4] = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)[step[size == 4]]
    places[size == 3] = np.array([(0, 0), (1, 0), (0, 1)], float)[step[size == 3]]
    return places
