"""Meshes of all other kinds, through trimesh: STL, glTF and GLB, 3MF and what it has readers for."""

import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.files.meshes.raw import RawMesh
from tilewright.showing import many


def read_foreign(path: Path) -> RawMesh:
    """The mesh of a file that trimesh reads, in triangles; several geometries are joined."""
    import trimesh

    suffix = path.suffix.lower()
    if suffix.lstrip(".") not in trimesh.available_formats():
        raise TilewrightValueError(
            f"is not a mesh that can be read here; trimesh reads none of the kind {suffix}",
            advice="a package that trimesh needs for it may be missing, or convert it to OBJ or PLY",
        )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        scene = trimesh.load_scene(path, process=False)
    parts, left = _parts(scene)
    if not parts:
        points = sum(len(one.vertices) for one in scene.geometry.values() if hasattr(one, "vertices"))
        raise TilewrightValueError(f"holds {many(points, 'point')} and no faces")
    mesh = _join(parts)
    if suffix == ".stl":
        mesh = _weld(mesh)
    if len(parts) > 1:
        mesh.notes.append(f"{len(parts)} geometries as such, which were joined")
    if left:
        mesh.notes.append(f"{many(left, 'path or point cloud')}")
    return mesh


Part = tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64] | None]
"""Vertices in their place in the scene, triangles, and texture coordinates of vertices."""


def _parts(scene: Any) -> tuple[list[Part], int]:
    """The triangles of a scene, each geometry as often as it is placed; and how many geometries have none."""
    parts: list[Part] = []
    left = 0
    for node in scene.graph.nodes_geometry:
        place, name = scene.graph[node]
        geometry = scene.geometry[name]
        triangles = np.asarray(getattr(geometry, "faces", ()), np.int64)
        if not len(triangles):
            left += 1
            continue
        vertices = np.asarray(geometry.vertices, np.float64) @ place[:3, :3].T + place[:3, 3]
        if np.linalg.det(place[:3, :3]) < 0:  # mirrored: what was outside is inside
            triangles = triangles[:, ::-1]
        coords = getattr(geometry.visual, "uv", None)
        fits = coords is not None and np.shape(coords) == (len(vertices), 2)
        parts.append((vertices, triangles, np.asarray(coords, np.float64) if fits else None))
    return parts, left


def _join(parts: list[Part]) -> RawMesh:
    """One mesh of all parts; texture coordinates where all have them."""
    offsets = np.cumsum([0, *(len(vertices) for vertices, _, _ in parts)])
    vertices = np.concatenate([part[0] for part in parts])
    triangles = np.concatenate([part[1] + offset for part, offset in zip(parts, offsets, strict=False)])
    corners = triangles.ravel()
    mesh = RawMesh(vertices, corners, np.arange(len(triangles) + 1) * 3)
    coords = [part[2] for part in parts if part[2] is not None]
    if len(coords) == len(parts) and ((corners >= 0) & (corners < len(vertices))).all():
        mesh.texcoords = np.concatenate(coords)[corners]
    elif coords:
        mesh.notes.append("texture coordinates, which some of its geometries lack")
    return mesh


def _weld(mesh: RawMesh) -> RawMesh:
    """The same with one vertex at each place; STL knows no vertices, only triangles."""
    vertices, which = np.unique(mesh.vertices, axis=0, return_inverse=True)
    return RawMesh(vertices, which.reshape(-1)[mesh.corners], mesh.starts, mesh.texcoords, mesh.notes)
