"""Meshes in PLY files: vertices, faces, and texture coordinates of either."""

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, brief
from tilewright.files.meshes.ply_elements import Columns, Lists, read_elements
from tilewright.files.meshes.raw import RawMesh, has_no_faces
from tilewright.showing import many

_INDICES = ("vertex_indices", "vertex_index")
_COORDINATES = (("s", "t"), ("u", "v"), ("texture_u", "texture_v"), ("texture_s", "texture_t"))
_STATED = {"edge": "edge", "tristrips": "triangle strip", "polyline": "polyline", "line": "line"}
"""Elements that hold shapes of another kind."""


def read_ply(data: bytes) -> RawMesh:
    """The mesh of a PLY file, in ASCII or in binary of either order; further properties are passed over."""
    elements, left = read_elements(data)
    if "vertex" not in elements:
        raise TilewrightValueError("has no vertices")
    vertices = _vertices(elements["vertex"])
    faces = elements.get("face", {})
    if not faces:
        if elements.get("tristrips"):
            raise TilewrightValueError("holds triangle strips and no faces, and strips are not read")
        raise has_no_faces(len(vertices), readable=True)
    indices = next((faces[name] for name in _INDICES if name in faces), None)
    if not isinstance(indices, Lists):
        raise TilewrightValueError("has faces without lists of vertex_indices")
    if indices.values.dtype.kind not in "iu":
        raise TilewrightValueError(f"names vertices by {indices.values.dtype}, not by whole numbers")
    corners = indices.values.astype(np.int64)
    mesh = RawMesh(vertices, corners, indices.starts)
    mesh.texcoords = _texcoords(elements["vertex"], faces, mesh)
    mesh.notes += _notes(elements, left)
    return mesh


def read_ply_property(data: bytes, name: str) -> NDArray[np.float64]:
    """A number that every vertex of a PLY file has, or else every face."""
    elements, _ = read_elements(data)
    found = [elements.get(element, {}) for element in ("vertex", "face")]
    for columns in found:
        if isinstance(values := columns.get(name), np.ndarray):
            return values.astype(np.float64)
    names = [one for columns in found for one in columns if isinstance(columns[one], np.ndarray)]
    raise TilewrightValueError(
        f"holds no property {brief(name)}", value=name, advice=f"it holds {', '.join(names)}" if names else ""
    )


def _vertices(columns: Columns) -> NDArray[np.float64]:
    """Places of the vertices."""
    if not columns:
        raise TilewrightValueError("has no vertices")
    axes = [columns.get(axis) for axis in "xyz"]
    if not all(isinstance(axis, np.ndarray) for axis in axes):
        raise TilewrightValueError("has vertices without x, y and z")
    return np.stack([np.asarray(axis, np.float64) for axis in axes], axis=1)


def _texcoords(vertex: Columns, faces: Columns, mesh: RawMesh) -> NDArray[np.float64] | None:
    """Texture coordinates of corners: of their faces, else of their vertices, else none."""
    listed = faces.get("texcoord")
    if isinstance(listed, Lists):
        if np.array_equal(listed.starts, 2 * mesh.starts):
            return listed.values.astype(np.float64).reshape(-1, 2)
        mesh.notes.append("texture coordinates, which some of its faces lack")
        return None
    for names in _COORDINATES:
        pair = [vertex.get(name) for name in names]
        if all(isinstance(one, np.ndarray) for one in pair):
            if ((mesh.corners < 0) | (mesh.corners >= len(mesh.vertices))).any():
                return None  # the mesh is refused for this
            return np.stack([np.asarray(one, np.float64) for one in pair], axis=1)[mesh.corners]
    return None


def _notes(elements: dict[str, Columns], left: int) -> list[str]:
    """What the file states and is not heeded."""
    notes = []
    for name, noun in _STATED.items():
        if columns := elements.get(name):
            first = next(iter(columns.values()))
            notes.append(many(len(first.starts) - 1 if isinstance(first, Lists) else len(first), noun))
    textures = elements.get("face", {}).get("texnumber")
    if isinstance(textures, np.ndarray) and len(textures) and (textures != textures[0]).any():
        notes.append(f"which of {len(np.unique(textures))} textures each face has")
    if left:
        notes.append("what follows its last element")
    return notes
