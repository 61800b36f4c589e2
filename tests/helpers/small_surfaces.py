"""Surfaces made in code, those of shared meshes, and points on them."""

import numpy as np

from meshes import FOLDER as MESHES
from tilewright import read_mesh
from tilewright.domains import Spots, Surface


def surface_of(vertices, triangles):
    """A surface, its twins found in a table of edges."""
    triangles = np.asarray(triangles, np.int32)
    edges = {
        (row[k], row[(k + 1) % 3]): 3 * t + k for t, row in enumerate(triangles.tolist()) for k in range(3)
    }
    twins = [[edges.get((row[(k + 1) % 3], row[k]), -1) for k in range(3)] for row in triangles.tolist()]
    return Surface(np.asarray(vertices, np.float64), triangles, np.asarray(twins, np.int32))


def grid(across, down, fold=lambda x, y: (x, y, 0 * x)):
    """A sheet of squares, each cut into two; ``fold`` says where x and y of 0 to 1 come to lie."""
    x, y = np.meshgrid(np.linspace(0, 1, across + 1), np.linspace(0, 1, down + 1))
    vertices = np.stack(np.broadcast_arrays(*fold(x.ravel(), y.ravel())), axis=1)
    corner = (np.arange(down)[:, None] * (across + 1) + np.arange(across)).ravel()
    up = corner + across + 1
    first, second = np.stack([corner, corner + 1, up + 1], 1), np.stack([corner, up + 1, up], 1)
    return surface_of(vertices, np.concatenate([first, second]))


def box(width=1.0, depth=1.0, height=1.0):
    """The six sides of a box, of two triangles each."""
    vertices = np.array([(x, y, z) for z in (0, height) for y in (0, depth) for x in (0, width)], float)
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return surface_of(vertices, [t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))])


def torus(around=48, across=24, radius=1.0, thickness=0.4):
    """A torus about the z axis."""
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * u.ravel() / around, 2 * np.pi * v.ravel() / across
    out = radius + thickness * np.cos(b)
    vertices = np.stack([out * np.cos(a), out * np.sin(a), thickness * np.sin(b)], axis=1)
    at = lambda i, j: ((i % around) * across + j % across).ravel()  # noqa: E731
    p, q, r, s = at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)
    return surface_of(vertices, np.concatenate([np.stack([p, q, r], 1), np.stack([p, r, s], 1)]))


def random_spots(surface, count, seed=0):
    """Points by chance, even in area."""
    rng = np.random.default_rng(seed)
    triangles = rng.choice(len(surface.triangles), count, p=surface.areas / surface.area).astype(np.int32)
    return Spots(triangles, rng.dirichlet((1, 1, 1), count))


def spots_at(surface, places):
    """Spots at places, each in the triangle that comes nearest."""
    triangles, weights = [], []
    for place in np.asarray(places, float):
        a, b, c = (surface.vertices[surface.triangles[:, k]] for k in range(3))
        twice = 2 * surface.areas
        n = surface.normals
        parts = [
            np.einsum("td,td->t", np.cross(q - p, place - p), n) / twice for p, q in ((b, c), (c, a), (a, b))
        ]
        own = np.stack(parts, axis=1)
        off = np.abs(np.einsum("td,td->t", place - a, n)) + np.maximum(-own, 0).sum(1)
        best = int(np.argmin(off))
        triangles.append(best)
        weights.append(own[best])
    return Spots(np.array(triangles, np.int32), np.array(weights))


def shared_mesh(name):
    """A mesh of the shared data, or None where there is none."""
    return read_mesh(MESHES / name) if (MESHES / name).exists() else None


def shared_surface(name):
    """The same as a surface, its faces cut into fans."""
    mesh = shared_mesh(name)
    return mesh and surface_of(
        mesh.vertices, [(f[0], f[k], f[k + 1]) for f in mesh.faces for k in range(1, len(f) - 1)]
    )
