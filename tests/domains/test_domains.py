"""Meshes are mended as said, and the medial domain has the laws of the paper on every one of them."""

import time

import numpy as np
import pytest

from meshes import CLOSED, CUBE_FACES, CUBE_VERTICES, OPEN, band, cube, fan, mixed, square, torus
from tilewright.domains import Mesh, Spots
from tilewright.domains.curve import morton_numbers
from tilewright.domains.medial import MedialDomain
from tilewright.domains.nearest import nearest_spots
from tilewright.domains.repair import make_sound
from tilewright.domains.spreading import spread_spots
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tilings.surface_tiling import SurfaceTiling

ALL = {**CLOSED, **OPEN}


def test_a_mesh_says_what_it_is():
    assert repr(mixed()) == "<Mesh: 11 vertices, 11 faces, of 3 to 5 corners>"
    assert len(cube()) == 6
    assert [f.tolist() for f in cube().faces] == [list(f) for f in CUBE_FACES]
    assert cube() == cube() != mixed()


@pytest.mark.parametrize(
    ("vertices", "faces", "words"),
    [
        ([(0, 0, np.nan)] * 3, [(0, 1, 2)], r"vertices\[0\]"),
        ([(0, 0, 0)] * 3, [], "no faces"),
        ([(0, 0, 0)] * 3, [(0, 1)], r"faces\[0\]"),
        ([(0, 0, 0)] * 3, [(0, 1, 3)], r"faces\[0\] names vertex 3"),
        ([(0, 0, 0)] * 3, [(0, 1, -1)], "names vertex -1"),
        ([(0, 0)] * 3, [(0, 1, 2)], r"expected \(V, 3\)"),
        ([], [(0, 1, 2)], r"expected \(V, 3\)"),
    ],
)
def test_what_is_no_mesh_is_refused(vertices, faces, words):
    with pytest.raises(TilewrightValueError, match=words):
        Mesh.of(vertices, faces)
    with pytest.raises(TilewrightTypeError):
        Mesh.of(vertices, 7)
    with pytest.raises(TilewrightTypeError, match="numbers"):
        Mesh.of([("a", "b", "c")] * 3, [(0, 1, 2)])


def test_a_mesh_without_area_is_refused():
    with pytest.raises(TilewrightValueError, match="no face with an area"):
        make_sound(Mesh.of([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)]))


def check_twins(surface):
    """Both triangles at an edge name each other, and it has the same ends seen from both."""
    twins, begin, end = surface.twins, surface.triangles, np.roll(surface.triangles, -1, axis=1)
    inner = twins >= 0
    assert np.array_equal(twins.ravel()[twins[inner]], np.flatnonzero(inner))
    assert np.array_equal(begin[inner], end.ravel()[twins[inner]])
    assert np.array_equal(end[inner], begin.ravel()[twins[inner]])


@pytest.mark.parametrize("name", ALL)
def test_a_sound_mesh_is_left_as_it_is(name):
    mesh = ALL[name]
    sound = make_sound(mesh)
    surface = sound.cut.surface
    check_twins(surface)
    if name != "moebius":
        assert sound.notes == ()
        assert np.array_equal(sound.vertices, mesh.vertices)
        assert np.array_equal(sound.corner_numbers, np.arange(len(mesh.corners)))
    assert (surface.twins < 0).any() == (name in OPEN)
    outward = np.einsum(
        "td,td->t", surface.vertices[surface.triangles[:, 0]], surface.normals * surface.areas[:, None]
    )
    if name == "cube":
        assert surface.area == pytest.approx(6)
        assert outward.sum() / 3 == pytest.approx(1)


def test_unwelded_faces_are_welded_and_unused_vertices_told():
    vertices = np.concatenate([np.asarray(CUBE_VERTICES, float)[list(face)] for face in CUBE_FACES])
    vertices[vertices == 0] *= -1  # -0 is 0
    sound = make_sound(Mesh.of([*vertices, (5, 5, 5)], np.arange(24).reshape(6, 4)))
    assert sound.notes == (
        "16 of 24 vertices welded to others at the same place",
        "1 of 25 vertices belong to no face",
    )
    assert len(sound.vertices) == 8
    assert not (sound.half_edges.twins < 0).any()


def test_faces_without_area_and_repeated_corners_go():
    faces = [*CUBE_FACES, (0, 1, 1), (0, 1, 0, 1), (0, 0, 0)]
    faces[0] = (3, 2, 2, 1, 0)
    sound = make_sound(Mesh.of(CUBE_VERTICES, faces))
    assert len(sound.face_numbers) == 6
    assert not (sound.half_edges.twins < 0).any()
    assert "left out" in " ".join(sound.notes)
    assert sound.corner_numbers[:4].tolist() == [0, 2, 3, 4]


def test_faces_turned_against_each_other_are_turned_as_most_are():
    faces = [CUBE_FACES[0][::-1], *CUBE_FACES[1:]]
    sound = make_sound(Mesh.of(CUBE_VERTICES, faces))
    assert sound.notes == ("1 face turned over to agree with the others",)
    assert not (sound.half_edges.twins < 0).any()
    surface = sound.cut.surface
    assert np.einsum("td,td->t", surface.normals, surface.vertices[surface.triangles[:, 0]] - 0.5).min() > 0
    corner = int(sound.half_edges.origins[1])
    assert sound.vertex_numbers[corner] == Mesh.of(CUBE_VERTICES, faces).corners[sound.corner_numbers[1]]


def test_three_faces_at_an_edge_are_cut_and_told():
    vertices = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)]
    sound = make_sound(Mesh.of(vertices, [(0, 1, 2), (1, 0, 3), (0, 1, 4)]))
    assert (sound.half_edges.twins < 0).all()
    assert sound.notes == ("cut open along 1 edge where faces do not meet in twos and turned alike",)
    assert len(sound.vertices) == 9


def test_fans_that_touch_in_a_vertex_are_cut_apart():
    vertices = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (-1, 0, 0), (-1, -1, 0)]
    sound = make_sound(Mesh.of(vertices, [(0, 1, 2), (0, 3, 4)]))
    assert len(sound.vertices) == 6
    assert sound.notes == ("cut apart at 1 vertex where fans of faces touch",)


def test_a_moebius_strip_is_cut_open_once():
    sound = make_sound(band(twist=1))
    assert "cut open along 1 edge" in sound.notes[-1]
    assert (sound.half_edges.twins < 0).sum() == 2 * 24 + 2


def test_concave_faces_are_cut_by_ears():
    star = [
        (np.cos(a) * r, np.sin(a) * r, 0)
        for a, r in zip(np.arange(10) * np.pi / 5, [1, 0.3] * 5, strict=True)
    ]
    surface = make_sound(Mesh.of(star, [range(10)])).cut.surface
    check_twins(surface)
    assert (surface.normals[:, 2] == 1).all()
    assert surface.area == pytest.approx(10 * 0.5 * 0.3 * np.sin(np.pi / 5))
    boomerang = make_sound(
        Mesh.of([(0, 0, 0), (2, 2, 0), (0, 0.5, 0), (-2, 2, 0)], [(1, 2, 3, 0)])
    ).cut.surface
    assert (boomerang.normals[:, 2] == 1).all()


def test_large_concave_faces_take_no_longer_than_their_size_asks():
    """A comb of 1,000 corners, whose ears hide each other."""
    x = np.arange(500)
    teeth = np.stack([x, 1.0 + 9 * (x % 2), 0 * x], axis=1)
    floor = np.stack([x[::-1], 0.1 * np.sin(x[::-1]), 0 * x], axis=1)
    begun = time.process_time()
    surface = make_sound(Mesh.of(np.concatenate([floor[::-1], teeth[::-1]]), [range(1000)])).cut.surface
    check_twins(surface)
    assert len(surface.triangles) == 998
    assert (surface.normals[:, 2] > 0).all()
    assert time.process_time() - begun < 5


@pytest.mark.parametrize("level", [0, 1, 2])
@pytest.mark.parametrize("name", ALL)
def test_every_corner_has_four_tiles_that_see_it_alike(name, level):
    domain = MedialDomain.of(make_sound(ALL[name]))
    for _ in range(level):
        domain = domain.subdivide()
    here = domain.half_edges
    assert np.array_equal(here.twins[here.twins[here.twins >= 0]], np.flatnonzero(here.twins >= 0))
    assert np.array_equal(
        here.origins[here.nexts][here.twins >= 0], here.origins[here.twins[here.twins >= 0]]
    )
    # Every sector belongs to one tile, and their areas fill the parameter polygons.
    sectors = domain.sectors
    assert np.array_equal(np.sort(sectors[sectors >= 0]), np.arange(2 * len(here)))
    whole = np.bincount(domain.sector_bases, domain.flat_areas)
    cut = domain.sound.cut
    first, second = cut.uv[:, 1] - cut.uv[:, 0], cut.uv[:, 2] - cut.uv[:, 0]
    unit = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / 2
    assert whole == pytest.approx(np.bincount(cut.faces, unit))
    # Corners: four tiles within, three on the boundary.
    slots = SurfaceTiling(domain, 3, 5).slots
    ends = [[] for _ in range(here.edges.max() + 1)]
    for t in range(len(domain.tile_starts) - 1):
        first, last = domain.tile_starts[t : t + 2]
        for k in range(first, last):
            sector = sectors[k]
            before = sectors[first + (k - first - 1) % (last - first)]
            if sector >= 0:
                corner = here.edges[sector % len(here)]
            elif before >= 0:
                corner = here.edges[here.prevs[before - len(here)]]
            else:
                continue
            ends[corner].append(slots[k])
    for edge, seen in enumerate(ends):
        boundary = (here.twins[here.edges == edge] < 0).any()
        assert len(seen) == (3 if boundary else 4)
        assert len({s // 4 for s in seen}) == 1
        assert len({s % 4 for s in seen}) == len(seen)  # each quadrant once


def test_quadrants_turn_with_the_surface():
    """Where the surface is flat, what tiles see of a corner tells one direction."""
    mesh = square(6)
    domain = MedialDomain.of(make_sound(mesh))
    slots, here = SurfaceTiling(domain, 1, 3).slots, domain.half_edges
    told = {}
    for t in range(len(domain.tile_starts) - 1):
        first, last = domain.tile_starts[t : t + 2]
        for k in range(first, last):
            sector = domain.sectors[k]
            if sector < 0:
                continue
            spot = domain.lift(domain.sector_bases[[sector]].repeat(2), domain.triangles[sector, 1:])
            here_, there = spot.positions(domain.sound.cut.surface)[:, :2]
            turn = np.arctan2(*(there - here_)[::-1]) / (np.pi / 2)
            corner = tuple(np.round(here_, 6))
            told.setdefault(corner, set()).add(round((slots[k] + turn) * 2) % 8)
    assert len(told) == len(np.unique(here.edges))
    assert {len(s) for s in told.values()} == {1}
    assert len({s for row in told.values() for s in row}) > 1


def test_chance_does_not_depend_on_faces_elsewhere():
    mesh = torus()
    fewer = Mesh.of(mesh.vertices, mesh.faces[: len(mesh) // 2])
    whole, part = (MedialDomain.of(make_sound(m)).subdivide() for m in (mesh, fewer))
    n = len(part.half_edges)
    slots = [SurfaceTiling(d, 2, 9).slots[:n] for d in (whole, part)]
    assert np.array_equal(*slots)
    assert not np.array_equal(slots[0], SurfaceTiling(whole, 2, 10).slots[:n])


def test_the_nearest_spot_is_that_of_a_plain_search():
    surface = make_sound(fan(24)).cut.surface
    rng = np.random.default_rng(1)
    places = rng.uniform(-1.5, 1.5, (40, 3))
    spots, distances = nearest_spots(surface, places)
    w = rng.dirichlet([1, 1, 1], (len(surface.triangles), 400))
    dense = np.einsum("tnk,tkd->tnd", w, surface.vertices[surface.triangles]).reshape(-1, 3)
    near = np.sqrt(((places[:, None] - dense) ** 2).sum(axis=2)).min(axis=1)
    assert (distances <= near + 1e-12).all()
    assert (near - distances).max() < 0.1
    assert np.linalg.norm(spots.positions(surface) - places, axis=1) == pytest.approx(distances)
    assert spots.weights.min() >= 0


def test_a_curve_numbers_places_as_interleaved_bits():
    steps = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (2, 0, 0), (2**20 - 1,) * 3])
    assert morton_numbers(steps / 2**20 + 1e-9).tolist()[:5] == [0, 1, 2, 4, 8]
    assert (morton_numbers(np.zeros((3, 3))) == 0).all()


def test_spots_know_where_they_are():
    surface = make_sound(cube()).cut.surface
    spots = Spots(np.array([0, 3], np.int32), np.array([(1.0, 0, 0), (0, 0.5, 0.5)]))
    assert np.array_equal(spots.positions(surface)[0], surface.vertices[surface.triangles[0, 0]])
    assert np.array_equal(spots[np.array([1])].weights, spots.weights[1:])
    assert np.array_equal(spots.normals(surface)[1], surface.normals[3])


def test_places_are_even_in_area():
    surface = make_sound(fan(24)).cut.surface
    places = spread_spots(surface, 50_000)
    counts = np.bincount(places.triangles, minlength=len(surface.areas))
    assert abs(counts - 50_000 * surface.areas / surface.area).max() <= 1
    assert places.weights.min() >= 0
    assert places.weights.sum(axis=1) == pytest.approx(1)
    quarter = (places.weights[:, 0] > 0.5).mean()
    assert quarter == pytest.approx(0.25, abs=0.002)
