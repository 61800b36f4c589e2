"""Points on a surface beside pymeshlab's, in CPU seconds of one process and in what the same judge says.

pymeshlab is under the GPL: it is a peer here, and nothing of the package depends on it.
"""

import time

import numpy as np
import pytest

import tilewright as tw
from small_surfaces import shared_mesh, shared_surface
from tilewright.domains import Spots
from tilewright.kernels.threads import at_most

COUNT, SEEDS = 40_000, 3
MESH = "bunny_quads_1878.obj"
PEER_RHO = 0.757
"""What its radius has to be, in r_max, for about so many points."""


def cpu_seconds(job, repeats=SEEDS):
    """The least CPU seconds of several runs, numbered from 0, and what the last made."""
    took, made = [], None
    for number in range(repeats):
        started = time.process_time()
        made = job(number)
        took.append(time.process_time() - started)
    return min(took), made


def spots_of(surface, places):
    """The spots of places that lie on the surface: the nearest of the triangles whose middles are near."""
    from scipy.spatial import cKDTree

    corners = surface.vertices[surface.triangles]
    near = cKDTree(corners.mean(axis=1)).query(places, 16)[1]
    a, b, c = (corners[near, k] for k in range(3))
    p, normals, doubled = places[:, None], surface.normals[near], 2 * surface.areas[near]
    parts = [
        np.einsum("nkd,nkd->nk", np.cross(v - u, p - u), normals) / doubled
        for u, v in ((b, c), (c, a), (a, b))
    ]
    weights = np.stack(parts, axis=-1)
    height = abs(np.einsum("nkd,nkd->nk", p - a, normals)) / np.sqrt(doubled)
    best = (height + np.maximum(-weights, 0).sum(axis=-1)).argmin(axis=1)
    rows = np.arange(len(places))
    inside = np.maximum(weights[rows, best], 0)
    return Spots(near[rows, best].astype(np.int32), inside / inside.sum(axis=1, keepdims=True))


@pytest.fixture(scope="module")
def surface():
    found = shared_surface(MESH)
    if found is None:
        pytest.skip("the shared meshes are not here")
    return found


@pytest.fixture(scope="module")
def peer(surface):
    """CPU seconds of pymeshlab, and what the judge says of its points."""
    pymeshlab = pytest.importorskip("pymeshlab")
    r_max = 1 / np.sqrt(2 * np.sqrt(3) * COUNT / surface.area)
    radius = pymeshlab.PureValue(2 * PEER_RHO * r_max)

    def sample(number):
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(surface.vertices, surface.triangles))
        meshes.generate_sampling_poisson_disk(radius=radius)
        return meshes.current_mesh().vertex_matrix()

    seconds, places = cpu_seconds(sample)
    report = tw.analyze_surface(surface, spots_of(surface, places))
    print(f"\npymeshlab, {seconds:.2f} CPU s\n{report}")
    return seconds, report


def test_forty_thousand_points_on_a_bunny(peer, record_ratio):
    mesh = shared_mesh(MESH)
    with at_most(1):
        tw.surface_points(mesh, COUNT, seed=100)
        seconds, points = cpu_seconds(lambda number: tw.surface_points(mesh, COUNT, seed=number))
    report = tw.analyze_surface(points.surface, points.spots)
    print(f"\ntilewright, {seconds:.2f} CPU s, {peer[0] / seconds:.1f} times pymeshlab\n{report}")
    name, theirs = f"{COUNT:,} points on a bunny", peer[1]
    record_ratio(f"{name}: times pymeshlab", peer[0], seconds)
    record_ratio(f"{name}: rho over pymeshlab's", report.rho_surface, theirs.rho_surface)
    record_ratio(f"{name}: pymeshlab's coverage over ours", theirs.coverage, report.coverage)
    record_ratio(f"{name}: pymeshlab's chi2 over ours", theirs.chi2, report.chi2)
    assert report.count == COUNT
    assert report.rho_surface >= PEER_RHO


def test_the_judge_is_quick(surface):
    rng = np.random.default_rng(0)
    triangles = rng.choice(len(surface.triangles), COUNT, p=surface.areas / surface.area).astype(np.int32)
    spots = Spots(triangles, rng.dirichlet((1, 1, 1), COUNT))
    tw.analyze_surface(surface, spots[:100])
    seconds, report = cpu_seconds(lambda number: tw.analyze_surface(surface, spots))
    print(f"\n{COUNT} points judged in {seconds:.2f} CPU s")
    assert report.certain
    assert seconds <= 2
