"""Small meshes made here, and those of the shared folder where there is one."""

from pathlib import Path

import numpy as np

import tilewright as tw
from tilewright.domains import Mesh

FOLDER = Path(__file__).parents[3] / "shared" / "data" / "meshes"

CUBE_VERTICES = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
CUBE_FACES = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def cube():
    return Mesh.of(CUBE_VERTICES, CUBE_FACES)


def square(n=4, size=1.0):
    """A flat square of n x n quads, open all around."""
    rows, columns = np.divmod(np.arange((n + 1) ** 2), n + 1)
    vertices = np.stack([columns, rows, 0 * rows], axis=1) * size / n
    first = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    return Mesh.of(vertices, np.stack([first, first + 1, first + n + 2, first + n + 1], axis=1))


def torus(m=24, n=12, large=1.0, small=0.4):
    """A torus of m x n quads."""
    u, v = np.meshgrid(np.arange(m), np.arange(n), indexing="ij")
    a, b = 2 * np.pi * u.ravel() / m, 2 * np.pi * v.ravel() / n
    ring = large + small * np.cos(b)
    vertices = np.stack([ring * np.cos(a), ring * np.sin(a), small * np.sin(b)], axis=1)

    def at(i, j):
        return ((u + i) % m * n + (v + j) % n).ravel()

    return Mesh.of(vertices, np.stack([at(0, 0), at(1, 0), at(1, 1), at(0, 1)], axis=1))


def band(n=24, width=0.3, twist=1):
    """A closed band of n quads, turned over ``twist`` times: 1 is Moebius'."""
    a = 2 * np.pi * np.arange(n) / n
    half = width * np.stack(
        [np.cos(a * twist / 2) * np.cos(a), np.cos(a * twist / 2) * np.sin(a), np.sin(a * twist / 2)], 1
    )
    middle = np.stack([np.cos(a), np.sin(a), 0 * a], axis=1)
    vertices = np.concatenate([middle - half, middle + half])
    faces = []
    for i in range(n):
        j = (i + 1) % n
        low, high = (j, n + j) if j or twist % 2 == 0 else (n + j, j)
        faces.append((i, low, high, n + i))
    return Mesh.of(vertices, faces)


def mixed():
    """A pyramid of four triangles on a prism over a pentagon-like house: triangles, quads and pentagons."""
    house = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
    vertices = [(x, y, z) for z in (0, 1) for x, y in house]
    sides = [(i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5) for i in range(5)]
    top = [(5, 6, 10), (6, 7, 10), (7, 8, 10), (8, 9, 10)]
    vertices.append((1, 1, 1.7))
    return Mesh.of(vertices, [(4, 3, 2, 1, 0), *sides, *top, (9, 5, 10)])


def fan(valence, height=0.5):
    """A closed cone of many triangles with a base of one face."""
    a = 2 * np.pi * np.arange(valence) / valence
    rim = np.stack([np.cos(a), np.sin(a), 0 * a], axis=1)
    sides = [(i, (i + 1) % valence, valence) for i in range(valence)]
    return Mesh.of([*rim, (0, 0, height)], [*sides, tuple(range(valence))[::-1]])


def triangles_of(mesh):
    """The same mesh, of triangles."""
    from tilewright.domains.repair import make_sound

    surface = make_sound(mesh).cut.surface
    return Mesh.of(surface.vertices, surface.triangles)


CLOSED = {
    "cube": cube(),
    "torus": torus(),
    "mixed": mixed(),
    "fan": fan(24),
    "triangles": triangles_of(torus(8, 6)),
}
OPEN = {"square": square(), "band": band(twist=2), "moebius": band(twist=1)}


def shared(name):
    """A mesh of the shared folder, or the test is skipped."""
    import pytest

    path = FOLDER / name
    if not path.exists():
        pytest.skip(f"no {name}")
    return tw.read_mesh(path)
