"""The medial domain of a mesh: faces and vertices are its tiles, the middles of edges their corners.

Every corner has exactly four tiles, two faces and two vertices, whatever the mesh is made of (Li et al. 2010,
section II). A tile of n corners is n sectors: the triangle of its center and of two corners that follow each
other. Sectors are told in the parameter polygons of the faces that the mesh was given with.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.half_edges import HalfEdges
from tilewright.domains.repair import SoundMesh
from tilewright.domains.spots import Spots
from tilewright.seeds import derive_key

_VERTICES, _CENTERS, _MIDDLES = (derive_key(np.uint64(0), kind) for kind in (1, 2, 3))


@dataclass(frozen=True, eq=False)
class MedialDomain:
    """Tiles over a mesh that has been subdivided a number of times.

    Attributes
    ----------
    sound : SoundMesh
        The mesh that can be tiled, whose faces are the base faces.
    half_edges : HalfEdges
        The sides of the subdivided faces.
    bases : int64 array, shape (F,)
        The base face that each subdivided face is a part of.
    uv : float64 array, shape (H, 2)
        Where each half-edge begins, in the parameter polygon of its base face.
    names : uint64 array, shape (V,)
        A number of each vertex by which chance is drawn: it does not change where others do.
    level : int
        How many times the mesh has been subdivided.
    """

    sound: SoundMesh
    half_edges: HalfEdges
    bases: NDArray[np.int64]
    uv: NDArray[np.float64]
    names: NDArray[np.uint64]
    level: int = 0

    @classmethod
    def of(cls, sound: SoundMesh) -> "MedialDomain":
        """The domain of the mesh as it is."""
        names = mix(sound.vertex_numbers.astype(np.uint64) ^ _VERTICES)
        return cls(sound, sound.half_edges, np.arange(len(sound.face_numbers)), sound.cut.polygons, names)

    def subdivide(self) -> "MedialDomain":
        """Cut every face into quads, one at each of its corners (connectivity of Catmull & Clark 1978).

        Nothing moves: new vertices lie in the middle of sides and faces of the parameter polygon.
        """
        here = self.half_edges
        count, after, before = len(here), here.nexts, here.prevs
        vertices, edges = len(self.names), int(here.edges.max()) + 1
        # Step 1: the quad at corner h runs from there to the middle of edge h, the center, the middle before.
        middles = vertices + here.edges
        centers = vertices + edges + here.faces
        origins = np.stack([here.origins, middles, centers, middles[before]], axis=1)
        # Step 2: sides of quads meet across the old edges, and about the centers.
        twins = np.full((count, 4), -1)
        there = here.twins
        twins[:, 0] = np.where(there >= 0, 4 * after[there] + 3, -1)
        twins[:, 1] = 4 * after + 2
        twins[:, 2] = 4 * before + 1
        twins[:, 3] = np.where(here.around >= 0, 4 * here.around, -1)
        # Step 3: the same in the parameter polygons.
        halves = (self.uv + self.uv[after]) / 2
        inner = _face_means(self.uv, here)[here.faces]
        uv = np.stack([self.uv, halves, inner, halves[before]], axis=1)
        return replace(
            self,
            half_edges=HalfEdges(origins.ravel(), np.arange(0, 4 * count + 1, 4), twins.ravel()),
            bases=self.bases[here.faces],
            uv=uv.reshape(-1, 2),
            names=np.concatenate([self.names, self._middle_names(edges), self._center_names()]),
            level=self.level + 1,
        )

    def _middle_names(self, edges: int) -> NDArray[np.uint64]:
        names = np.empty(edges, np.uint64)
        names[self.half_edges.edges] = self.edge_names ^ _MIDDLES
        return mix(names)

    def _center_names(self) -> NDArray[np.uint64]:
        here = self.half_edges
        names = np.zeros(len(here.starts) - 1, np.uint64)
        np.add.at(names, here.faces, mix(self.names[here.origins] ^ _CENTERS))
        return mix(names)

    @cached_property
    def edge_names(self) -> NDArray[np.uint64]:
        """A number of the edge of each half-edge, which both sides agree on, uint64, shape (H,)."""
        one = self.names[self.half_edges.origins]
        other = one[self.half_edges.nexts]
        return mix(one) + mix(other)

    @cached_property
    def leads(self) -> NDArray[np.bool_]:
        """Whether a half-edge runs from the lower to the higher name of its ends, shape (H,)."""
        names = self.names[self.half_edges.origins]
        leads: NDArray[np.bool_] = names < names[self.half_edges.nexts]
        return leads

    @cached_property
    def rings(self) -> "Rings":
        """The half-edges about every vertex."""
        return Rings.of(self.half_edges, len(self.names))

    @cached_property
    def tile_starts(self) -> NDArray[np.int64]:
        """Where the corners of each tile start and end: the faces', then the vertices', shape (tiles + 1,).

        A vertex on the boundary has one corner more than edges: a virtual one, outside.
        """
        sizes = np.concatenate([np.diff(self.half_edges.starts), self.rings.counts + 2 * self.rings.open])
        return np.concatenate([[0], np.cumsum(sizes)])

    @cached_property
    def sectors(self) -> NDArray[np.int64]:
        """The sector from each corner of a tile to the next, -1 where there is no surface, int64.

        Sector h is that of the face from the middle of half-edge h to that of the next; sector H + h that of
        the vertex where h begins, from the middle of h to that of the half-edge before.
        """
        count = len(self.half_edges)
        made = np.full(int(self.tile_starts[-1]), -1)
        made[:count] = np.arange(count)
        firsts = self.tile_starts[len(self.bases) : -1]
        made[firsts[self.half_edges.origins] + self.rings.places] = count + np.arange(count)
        return made

    @cached_property
    def sector_tiles(self) -> NDArray[np.int64]:
        """The tile of each sector, int64, shape (2 H,)."""
        return np.concatenate([self.half_edges.faces, len(self.bases) + self.half_edges.origins])

    @cached_property
    def tile_names(self) -> NDArray[np.uint64]:
        """A number of each tile by which chance is drawn, uint64, shape (tiles,)."""
        return np.concatenate([self._center_names(), mix(self.names)])

    @cached_property
    def triangles(self) -> NDArray[np.float64]:
        """Center and both corners of every sector in the parameter polygon, float64, shape (2 H, 3, 2)."""
        here = self.half_edges
        middles = (self.uv + self.uv[here.nexts]) / 2
        inner = np.stack([_face_means(self.uv, here)[here.faces], middles, middles[here.nexts]], axis=1)
        outer = np.stack([self.uv, middles, middles[here.prevs]], axis=1)
        return np.concatenate([inner, outer])

    @cached_property
    def sector_bases(self) -> NDArray[np.int64]:
        """The base face that each sector lies in, int64, shape (2 H,)."""
        return np.tile(self.bases[self.half_edges.faces], 2)

    @cached_property
    def sector_areas(self) -> NDArray[np.float64]:
        """Area of every sector, as that of the triangle below its middle says, float64, shape (2 H,)."""
        return self.flat_areas * self.sound.cut.stretches[self.sector_middles.triangles]

    @cached_property
    def flat_areas(self) -> NDArray[np.float64]:
        """Area of every sector in its parameter polygon, float64, shape (2 H,)."""
        a, b, c = self.triangles.swapaxes(0, 1)
        return np.abs(_cross(b - a, c - a)) / 2

    @cached_property
    def sector_middles(self) -> Spots:
        """The middle of every sector."""
        return self.lift(self.sector_bases, self.triangles.mean(axis=1))

    def lift(self, bases: NDArray[np.int64], uv: NDArray[np.float64]) -> Spots:
        """Spots of the surface at places of parameter polygons."""
        found = self.find_triangles(bases, uv)
        sides = self.sound.cut.uv[found]
        first, second, rest = sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0], uv - sides[:, 0]
        b, c = _cross(rest, second) / _cross(first, second), _cross(first, rest) / _cross(first, second)
        return Spots(found.astype(np.int32), np.clip(np.stack([1 - b - c, b, c], axis=1), 0, 1))

    def find_triangles(self, bases: NDArray[np.int64], uv: NDArray[np.float64]) -> NDArray[np.int64]:
        """The triangle of the surface at places of parameter polygons, int64, shape (n,)."""
        from tilewright.kernels.dual_laying import find_triangles

        found = np.empty(len(bases), np.int64)
        cut = self.sound.cut
        find_triangles(len(bases), bases, uv, cut.starts, cut.uv, found)
        return found


@dataclass(frozen=True, eq=False)
class Rings:
    """The half-edges that begin at each vertex, counter-clockwise.

    Attributes
    ----------
    places : int64 array, shape (H,)
        The place of each half-edge in the ring of its origin.
    counts : int64 array, shape (V,)
        How many begin there.
    open : bool array, shape (V,)
        Whether the vertex lies on the boundary: then its ring begins where the surface does.
    lasts : int64 array, shape (V,)
        The last half-edge of the ring.
    """

    places: NDArray[np.int64]
    counts: NDArray[np.int64]
    open: NDArray[np.bool_]
    lasts: NDArray[np.int64]

    @classmethod
    def of(cls, half_edges: HalfEdges, vertices: int) -> "Rings":
        """Walk around all vertices at once, from the boundary or from the first half-edge."""
        origins, around = half_edges.origins, half_edges.around
        counts = np.bincount(origins, minlength=vertices)
        at = np.unique(origins, return_index=True)[1].astype(np.int64)
        bounds = np.flatnonzero(half_edges.twins < 0)
        at[origins[bounds]] = bounds
        open = np.zeros(vertices, bool)
        open[origins[bounds]] = True
        places, lasts = np.zeros(len(origins), np.int64), at.copy()
        active, step = np.arange(vertices), 0
        while len(active):
            places[at[active]] = step
            lasts[active] = at[active]
            step += 1
            active = active[counts[active] > step]
            at[active] = around[at[active]]
        return cls(places, counts, open, lasts)


def mix(words: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """SplitMix64's output function (Steele, Lea & Flood 2014) of many words."""
    words = words + np.uint64(0x9E3779B97F4A7C15)
    words = (words ^ words >> np.uint64(30)) * np.uint64(0xBF58476D1CE4E5B9)
    words = (words ^ words >> np.uint64(27)) * np.uint64(0x94D049BB133111EB)
    return words ^ words >> np.uint64(31)


def _face_means(values: NDArray[np.float64], half_edges: HalfEdges) -> NDArray[np.float64]:
    """The mean over the corners of every face."""
    sums = np.add.reduceat(values, half_edges.starts[:-1], axis=0)
    means: NDArray[np.float64] = sums / np.diff(half_edges.starts)[:, np.newaxis]
    return means


def _cross(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    crossed: NDArray[np.float64] = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return crossed
