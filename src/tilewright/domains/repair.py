"""From a mesh as people bring it to one that can be tiled: welded, turned alike, cut open where it must be.

A surface that tiles can lie on has one face or two at every edge, turned alike, and one fan of faces at every
vertex. What is not so is mended by the least change, and said.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.half_edges import HalfEdges, next_corners, pair
from tilewright.domains.mesh import Mesh
from tilewright.domains.triangulation import Triangulation, triangulate
from tilewright.errors import TilewrightValueError
from tilewright.showing import many


@dataclass(frozen=True, eq=False)
class SoundMesh:
    """A mesh that can be tiled, and what was done to make it so.

    Attributes
    ----------
    vertices : float64 array, shape (V, 3)
    half_edges : HalfEdges
        The sides of its F faces.
    cut : Triangulation
        The triangles of the faces.
    face_numbers : int64 array, shape (F,)
        The face of the mesh as it came that each face was.
    vertex_numbers : int64 array, shape (V,)
        The vertex of the mesh as it came that each vertex was.
    corner_numbers : int64 array, shape (H,)
        The corner of the mesh as it came that each corner was.
    notes : tuple of str
        Sentences on what was welded, dropped, turned and cut.
    """

    vertices: NDArray[np.float64]
    half_edges: HalfEdges
    cut: Triangulation
    face_numbers: NDArray[np.int64]
    vertex_numbers: NDArray[np.int64]
    corner_numbers: NDArray[np.int64]
    notes: tuple[str, ...]


def make_sound(mesh: Mesh) -> SoundMesh:
    """Mend a mesh so that it can be tiled.

    Raises
    ------
    TilewrightValueError
        No face has an area.
    """
    notes: list[str] = []
    # Step 1: vertices at the same place are one.
    corners = _weld(mesh, notes)
    # Step 2: corners that repeat the one before them go, then faces that are none.
    kept = _distinct_corners(corners, mesh.starts)
    faces = np.repeat(np.arange(len(mesh)), mesh.sizes)[kept]
    numbers, corners = np.flatnonzero(kept), corners[kept]
    flat = _flat_faces(mesh.vertices, corners, faces, len(mesh), notes)
    stay = ~flat[faces]
    numbers, corners, faces = numbers[stay], corners[stay], faces[stay]
    starts = np.concatenate([[0], np.cumsum(np.bincount(faces, minlength=len(mesh))[~flat])])
    # Step 3: faces are turned alike.
    turned = _turned(corners, starts, notes)
    order = _reversed(starts, turned)
    numbers, corners = numbers[order], corners[order]
    # Step 4: faces meet where exactly one runs each way along an edge; elsewhere the surface is cut.
    twins = pair(corners, corners[next_corners(starts)])
    # Step 5: each fan of faces about a vertex has a copy of it of its own.
    half_edges = HalfEdges(corners, starts, twins)
    fans = _fans(half_edges)
    firsts = np.unique(fans, return_index=True)[1]
    _tell_cuts(half_edges, fans, notes)
    vertex_numbers = corners[firsts]
    half_edges = HalfEdges(fans, starts, twins)
    cut, slits = triangulate(mesh.vertices[vertex_numbers], half_edges)
    if slits:
        notes.append(f"{many(slits, 'triangle')} without area left out of faces that have one")
    return SoundMesh(
        mesh.vertices[vertex_numbers],
        half_edges,
        cut,
        np.flatnonzero(~flat),
        vertex_numbers,
        numbers,
        tuple(notes),
    )


def _weld(mesh: Mesh, notes: list[str]) -> NDArray[np.int64]:
    """The corners, with the first of all vertices at the same place in place of each."""
    places = mesh.vertices + 0.0  # so that -0 is 0
    used = np.unique(mesh.corners)
    order = used[np.lexsort(places[used].T)]
    new = (np.diff(places[order], axis=0, prepend=np.nan) != 0).any(axis=1)
    groups = np.cumsum(new) - 1
    firsts = np.full(int(groups[-1]) + 1, len(places))
    np.minimum.at(firsts, groups, order)
    welded = np.arange(len(places))
    welded[order] = firsts[groups]
    if len(firsts) < len(used):
        notes.append(f"{len(used) - len(firsts)} of {len(used)} vertices welded to others at the same place")
    if len(used) < len(places):
        notes.append(f"{len(places) - len(used)} of {len(places)} vertices belong to no face")
    return welded[mesh.corners]


def _distinct_corners(corners: NDArray[np.int64], starts: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which corners name another vertex than the one after them in their face."""
    return corners != corners[next_corners(starts)]


def _flat_faces(
    vertices: NDArray[np.float64],
    corners: NDArray[np.int64],
    faces: NDArray[np.int64],
    count: int,
    notes: list[str],
) -> NDArray[np.bool_]:
    """Which faces have no area, or visit a vertex twice."""
    sizes = np.bincount(faces, minlength=count)
    firsts = np.concatenate([[0], np.cumsum(sizes)])[faces]
    rest = vertices[corners] - vertices[corners[firsts]]
    after = np.roll(rest, -1, axis=0)  # what follows the last corner of a face does not count, see below
    inner = np.append(faces[1:] == faces[:-1], False)
    doubled = np.zeros((count, 3))
    np.add.at(doubled, faces[inner], np.cross(rest[inner], after[inner]))
    reach = np.zeros(count)
    np.maximum.at(reach, faces, (rest**2).sum(axis=1))
    flat = (sizes < 3) | ~(np.linalg.norm(doubled, axis=1) > 1e-12 * reach)
    twice = np.zeros(count, bool)
    order = np.lexsort((corners, faces))
    same = (np.diff(corners[order]) == 0) & (np.diff(faces[order]) == 0)
    twice[faces[order][1:][same]] = True
    if (flat & ~twice).any():
        notes.append(f"{many(int((flat & ~twice).sum()), 'face')} without area left out")
    if twice.any():
        notes.append(f"{many(int(twice.sum()), 'face')} that visit a vertex twice left out")
    if (flat | twice).all():
        raise TilewrightValueError("has no face with an area", argument="mesh")
    return flat | twice


def _turned(corners: NDArray[np.int64], starts: NDArray[np.int64], notes: list[str]) -> NDArray[np.bool_]:
    """Which faces to turn over so that neighbors run opposite ways along their common edge."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import breadth_first_order, connected_components

    count = len(starts) - 1
    targets = corners[next_corners(starts)]
    faces = np.repeat(np.arange(count), np.diff(starts))
    low, high = np.minimum(corners, targets), np.maximum(corners, targets)
    order = np.lexsort((high, low))
    new = (np.diff(low[order], prepend=-1) != 0) | (np.diff(high[order], prepend=-1) != 0)
    firsts = np.flatnonzero(new)
    pairs = firsts[np.diff(firsts, append=len(order)) == 2]
    one, other = order[pairs], order[pairs + 1]
    alike = corners[one] == corners[other]
    turned = np.zeros(count, bool)
    if not alike.any():
        return turned
    rows = np.concatenate([faces[one], faces[other]])
    columns = np.concatenate([faces[other], faces[one]])
    odd = set(zip(faces[one[alike]].tolist(), faces[other[alike]].tolist(), strict=True))
    graph = coo_array((np.ones(len(rows)), (rows, columns)), (count, count)).tocsr()
    parts = connected_components(graph, directed=False)[1]
    for part in np.unique(parts[faces[one[alike]]]):
        members = np.flatnonzero(parts == part)
        reached, before = breadth_first_order(graph, members[0], directed=False)
        for face in reached[1:].tolist():
            last = int(before[face])
            turned[face] = turned[last] ^ ((last, face) in odd or (face, last) in odd)
        if 2 * turned[members].sum() > len(members):  # most of them know better
            turned[members] ^= True
    if turned.any():
        notes.append(f"{many(int(turned.sum()), 'face')} turned over to agree with the others")
    return turned


def _reversed(starts: NDArray[np.int64], turned: NDArray[np.bool_]) -> NDArray[np.int64]:
    """The order of corners in which those of turned faces run the other way."""
    order = np.arange(int(starts[-1]))
    faces = np.repeat(np.arange(len(turned)), np.diff(starts))
    back = starts[:-1][faces] + starts[1:][faces] - 1 - order
    return np.where(turned[faces], back, order)


def _fans(half_edges: HalfEdges) -> NDArray[np.int64]:
    """The fan that each half-edge's corner belongs to, numbered by vertex and then by first corner."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count = len(half_edges)
    joined = np.flatnonzero(half_edges.around >= 0)
    ones = np.ones(len(joined), bool)
    graph = coo_array((ones, (joined, half_edges.around[joined])), (count, count))
    labels = connected_components(graph, directed=False)[1]
    first = np.unique(labels, return_index=True)[1]
    order = np.lexsort((first, half_edges.origins[first]))
    numbers = np.empty_like(order)
    numbers[order] = np.arange(len(order))
    return numbers[labels].astype(np.int64)


def _tell_cuts(half_edges: HalfEdges, fans: NDArray[np.int64], notes: list[str]) -> None:
    """Say how many edges and vertices were cut that did belong together."""
    targets = half_edges.origins[half_edges.nexts]
    edges = np.stack([np.minimum(half_edges.origins, targets), np.maximum(half_edges.origins, targets)])
    lone = edges[:, half_edges.twins < 0]
    kinds, meetings = np.unique(lone, axis=1, return_counts=True)
    cut = int((meetings > 1).sum())
    if cut:
        notes.append(f"cut open along {many(cut, 'edge')} where faces do not meet in twos and turned alike")
    vertices = half_edges.origins[np.unique(fans, return_index=True)[1]]
    apart = np.setdiff1d(vertices[1:][np.diff(vertices) == 0], kinds[:, meetings > 1])
    if len(apart):
        notes.append(f"cut apart at {many(len(apart), 'vertex', 'vertices')} where fans of faces touch")
