"""Distances along surfaces against hand-made unfoldings, paths over many points of edges, and edge flips."""

from math import hypot, inf

import numpy as np
import pytest

from small_surfaces import box, grid, random_spots, shared_surface, spots_at, surface_of, torus
from tilewright.analysis.surfaces import geodesics
from tilewright.analysis.surfaces.geodesics import Ways
from tilewright.analysis.surfaces.report import analyze_surface
from tilewright.domains import Spots
from tilewright.kernels.threads import at_most


def straight_nearest(surface, spots):
    from scipy.spatial import cKDTree

    points = spots.positions(surface)
    return cKDTree(points).query(points, 2)[0][:, 1]


def along(surface, spots):
    found, certain = Ways(surface, spots).between_spots(straight_nearest(surface, spots))
    assert certain.all()
    return found


@pytest.mark.parametrize("surface", [grid(1, 1), grid(5, 7), grid(30, 30)], ids=["coarse", "some", "fine"])
def test_on_a_flat_sheet_ways_are_straight(surface):
    spots = random_spots(surface, 300)
    assert along(surface, spots) == pytest.approx(straight_nearest(surface, spots), rel=1e-9)


def test_ways_run_straight_through_vertices_and_along_edges():
    sheet = grid(8, 8)
    places = [(0, 0, 0), (1, 0, 0), (0.25, 0.25, 0), (0.875, 1, 0), (0.3, 0.8, 0), (0.3, 0.55, 0)]
    spots = spots_at(sheet, places)
    assert along(sheet, spots) == pytest.approx(straight_nearest(sheet, spots), rel=1e-9)


def test_around_the_edges_of_a_box_ways_are_those_of_its_net():
    cube = box()
    spots = spots_at(cube, [(0.9, 0.5, 1), (1, 0.6, 0.8)])
    assert along(cube, spots) == pytest.approx(hypot(0.1 + 0.2, 0.1))
    across = spots_at(cube, [(0.5, 0.5, 1), (0.5, 0.5, 0)])
    assert along(cube, across) == pytest.approx(2)
    # The way over two edges is shorter than any other.
    corner = spots_at(cube, [(0.2, 0.9, 1), (0, 0.8, 0.1)])
    assert along(cube, corner) == pytest.approx(hypot(0.4, 1))


def test_the_other_side_of_a_thin_plate_is_far():
    plate = box(1, 1, 0.004)
    spots = spots_at(plate, [(0.3, 0.5, 0.004), (0.3, 0.5, 0)])
    assert along(plate, spots) == pytest.approx(0.604)
    many = random_spots(plate, 3000)
    report = analyze_surface(plate, many)
    assert report.certain
    assert report.rho_surface >= report.rho_space
    assert report.mean == pytest.approx(0.465, abs=0.02)


def test_points_on_one_side_of_a_thin_plate_do_not_cover_the_other():
    plate = box(1, 1, 0.004)
    x, y = np.meshgrid(*[np.arange(0.05, 1, 0.1)] * 2)
    report = analyze_surface(plate, spots_at(plate, np.stack([x, y, 0 * x + 0.004], -1).reshape(-1, 3)))
    # From the middle of the other side to the outermost points.
    assert report.coverage * report.r_max == pytest.approx(hypot(0.5 + 0.004 + 0.05, 0.05), abs=0.003)
    assert "holes" in str(report)


def test_points_that_keep_their_distance_along_the_surface_only_are_told():
    plate = box(1, 1, 0.004)
    x, y = np.meshgrid(*[np.arange(0.025, 1, 0.05)] * 2)
    sides = [np.stack([x, y, 0 * x + z], -1).reshape(-1, 3) for z in (0, 0.004)]
    report = analyze_surface(plate, spots_at(plate, np.concatenate(sides)))
    assert report.rho_space * 2 * report.r_max == pytest.approx(0.004)
    assert report.rho_surface * 2 * report.r_max == pytest.approx(0.05)
    assert "both sides of thin parts" in " ".join(report.verdict)


def test_ways_turn_at_corners_of_the_border():
    """An L: the square of side 2 without its upper right quarter."""
    vertices = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0), (0, 2, 0), (1, 2, 0)]
    triangles = [(0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (3, 4, 7), (3, 7, 6)]
    bent = surface_of(vertices, triangles)
    spots = spots_at(bent, [(1.5, 0.9, 0), (0.9, 1.5, 0)])
    assert along(bent, spots) == pytest.approx(2 * hypot(0.5, 0.1))


def test_on_another_part_nothing_is_reached():
    two = surface_of(np.eye(3).repeat(2, 0) + [[0, 0, 0], [0, 0, 5]] * 3, [(0, 2, 4), (1, 3, 5)])
    weights = np.full((2, 3), 1 / 3)
    assert along(two, Spots(np.array([0, 1], np.int32), weights)).tolist() == [inf, inf]


def wave(x, y):
    return x, y, 0.8 * np.sin(9 * x) * np.cos(7 * y)


def shortest_over_points(surface, spots, each=30):
    """Shortest ways that cross edges only at so many points of each, and turn at them: a little too long."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    twins, at, nodes, links = surface.twins, spots.positions(surface), [], []
    numbers = {}
    for t, row in enumerate(surface.triangles):
        here = []
        for k in range(3):
            edge = min(3 * t + k, twins[t, k]) if twins[t, k] >= 0 else 3 * t + k
            if edge not in numbers:
                numbers[edge] = range(len(nodes), len(nodes) + each)
                a, b = surface.vertices[row[k]], surface.vertices[row[(k + 1) % 3]]
                nodes.extend(a + (b - a) * s for s in np.linspace(0, 1, each))
            here.extend(numbers[edge])
        inside = np.flatnonzero(spots.triangles == t)
        links.append((here, inside))
    points = np.concatenate([nodes, at])
    pairs = []
    for here, inside in links:
        members = np.concatenate([here, len(nodes) + inside]).astype(int)
        pairs.append(np.stack(np.meshgrid(members, members), -1).reshape(-1, 2))
    # Edges end where others start.
    kinds = np.unique(np.round(nodes, 9), axis=0, return_inverse=True)[1].ravel()
    firsts = np.full(kinds.max() + 1, len(nodes))
    np.minimum.at(firsts, kinds, np.arange(len(nodes)))
    number = np.concatenate([firsts[kinds], len(nodes) + np.arange(len(at))])
    i, j = np.unique(number[np.concatenate(pairs)], axis=0).T
    graph = coo_array((np.linalg.norm(points[i] - points[j], axis=1), (i, j)), (len(points),) * 2)
    own = len(nodes) + np.arange(len(at))
    far = dijkstra(graph.tocsr(), indices=own)[:, own]
    np.fill_diagonal(far, inf)
    return far.min(axis=1)


@pytest.mark.parametrize(
    "surface",
    [
        torus(7, 5, 1, 0.5),
        box(1, 1, 0.3),
        grid(4, 4, lambda x, y: (x, y, 0.8 * np.sin(9 * x) * np.cos(7 * y))),
    ],
    ids=["torus", "plate", "waves"],
)
def test_no_way_over_points_of_edges_is_shorter(surface):
    spots = random_spots(surface, 12, 3)
    plain, found = shortest_over_points(surface, spots), along(surface, spots)
    assert (found <= plain * (1 + 1e-9)).all()
    assert found == pytest.approx(plain, rel=0.02)


@pytest.mark.parametrize("name", ["bunny_quads_281.obj", "spot_quads_732.obj", "blub_control_mesh.obj"])
def test_edge_flips_find_no_shorter_way(name):
    edge_flips = pytest.importorskip("potpourri3d").EdgeFlipGeodesicSolver
    surface = shared_surface(name)
    if surface is None:
        pytest.skip("the shared meshes are not here")
    vertices = np.random.default_rng(0).choice(len(surface.vertices), 20, replace=False)
    first = [np.argwhere(surface.triangles == v)[0] for v in vertices]
    spots = Spots(np.array([t for t, _ in first], np.int32), np.eye(3)[[k for _, k in first]])
    solver = edge_flips(surface.vertices, surface.triangles)
    length = np.full((20, 20), inf)
    for a, b in zip(*np.triu_indices(20, 1), strict=True):
        way = solver.find_geodesic_path(int(vertices[a]), int(vertices[b]))
        length[a, b] = length[b, a] = np.linalg.norm(np.diff(way, axis=0), axis=1).sum()
    found = along(surface, spots)
    # Flips find ways that no small change makes shorter, which need not be the shortest.
    assert (found <= length.min(axis=1) * (1 + 1e-9)).all()
    assert np.median(found / length.min(axis=1)) == pytest.approx(1, abs=1e-9)


def test_a_search_that_is_given_up_is_told(monkeypatch):
    monkeypatch.setattr(geodesics, "_MOST", 3)
    surface = torus()
    spots = random_spots(surface, 100)
    report = analyze_surface(surface, spots)
    assert not report.certain
    assert report.rho_surface >= report.rho_space
    assert "lower bounds" in str(report)


def test_threads_do_not_matter():
    surface = torus()
    spots = random_spots(surface, 2000)
    with at_most(1):
        one = along(surface, spots)
    assert along(surface, spots).tobytes() == one.tobytes()
