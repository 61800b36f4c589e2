"""Figures of points on surfaces against theory, plain oracles and hand-made faults."""

from math import sqrt

import numpy as np
import pytest

import tilewright as tw
from small_surfaces import grid, random_spots, spots_at, torus
from tilewright.analysis.surfaces.geodesics import Ways
from tilewright.analysis.surfaces.holes import Holes, count_evenness, look_around
from tilewright.analysis.surfaces.neighbors import share_of_six
from tilewright.analysis.surfaces.report import analyze_surface
from tilewright.domains import Spots
from tilewright.errors import TilewrightTypeError, TilewrightValueError


def sheet_spots(surface, places):
    """Spots of a flat sheet of 0 to 1 at (x, y)."""
    return spots_at(surface, np.column_stack([places, np.zeros(len(places))]))


def hexagons(columns):
    """The densest packing of a square of side 1, as far as it fits."""
    step = 1 / columns
    rows = int(columns / (sqrt(3) / 2))
    y, x = np.mgrid[:rows, :columns].astype(float)
    return np.stack([(x + 0.25 + (y % 2) / 2) * step, (y + 0.5) * step * sqrt(3) / 2], axis=-1).reshape(-1, 2)


def test_a_hexagonal_lattice_has_the_figures_of_theory():
    report = analyze_surface(grid(3, 3), sheet_spots(grid(3, 3), hexagons(20)))
    assert report.rho_space == pytest.approx(1, abs=0.02)
    assert report.mean == pytest.approx(1, abs=0.02)
    assert report.six_neighbors > 0.93
    # The rows end a little before the upper side.
    assert 2 / sqrt(3) < report.coverage < 1.9
    assert report.chi2 < 0.5
    assert "lattice" in str(report)


def test_points_thrown_as_darts_are_evenly_spread():
    sheet = grid(2, 2)
    darts = tw.sample_points("dart", 1500, 0.7, seed=1, box=tw.Box((1, 1), torus=False))
    report = analyze_surface(sheet, sheet_spots(sheet, darts.points))
    assert report.certain
    assert report.rho_surface == report.rho_space == pytest.approx(darts.rho)
    assert 1.8 < report.coverage < 2.3
    assert report.six_neighbors == pytest.approx(0.48, abs=0.04)
    assert report.verdict[0].startswith("Evenly spread: least distance 0.70")
    assert len(report.verdict) == 1


def test_random_points_have_the_figures_of_chance():
    surface = torus()
    reports = [analyze_surface(surface, random_spots(surface, 2000, seed)) for seed in range(3)]
    assert np.mean([r.mean for r in reports]) == pytest.approx(0.465, abs=0.015)
    assert np.mean([r.chi2 for r in reports]) == pytest.approx(1, abs=0.25)
    assert np.mean([r.six_neighbors for r in reports]) == pytest.approx(0.29, abs=0.03)
    assert all("clump" in " ".join(r.verdict) for r in reports)


def test_the_hole_is_the_one_that_many_places_find():
    from scipy.spatial import cKDTree

    surface = torus(20, 9)
    spots = random_spots(surface, 300, 4)
    tree = cKDTree(spots.positions(surface))
    found = Holes(surface, spots, tree, Ways(surface, spots)).widest(look_around(surface, 300))
    plain = tree.query(random_spots(surface, 200_000, 1).positions(surface))[0].max()
    assert plain <= found <= plain * 1.02


def test_the_hole_beside_a_missing_point_is_found():
    places = hexagons(20)
    middle = np.linalg.norm(places - 0.5, axis=1).argmin()
    surface = grid(3, 3)
    whole = analyze_surface(surface, sheet_spots(surface, places))
    report = analyze_surface(surface, sheet_spots(surface, np.delete(places, middle, axis=0)))
    assert report.coverage * report.r_max == pytest.approx(2 * whole.r_max, rel=0.03)


def test_points_that_follow_triangles_rather_than_area_are_told():
    surface = grid(12, 12, lambda x, y: (x**3, y, 0 * x))
    rng = np.random.default_rng(0)
    triangles = rng.integers(0, len(surface.triangles), 3000).astype(np.int32)
    report = analyze_surface(surface, Spots(triangles, rng.dirichlet((1, 1, 1), 3000)))
    assert report.chi2 > 10
    assert "area" in " ".join(report.verdict)


def test_counts_are_compared_with_areas():
    places = np.stack(np.meshgrid(*[np.arange(64) / 64] * 2, [0.0]), -1).reshape(-1, 3)
    assert count_evenness(places, places) == 0
    rng = np.random.default_rng(5)
    left = rng.random((5000, 3)) * (0.5, 1, 0)
    # Half of 64 cells hold nothing, the others twice as many as expected.
    # Cells lie aslant, so that some are cut in two, which takes a tenth of the figure.
    assert 0.8 * 5000 / 64 < count_evenness(places, left) < 5000 / 64
    # A wall across an axis is halved as well: no cell is left empty.
    wall = np.concatenate([places * (0, 1, 1), places * (1, 0, 1)])
    assert count_evenness(wall, wall) == 0


def test_neighbors_are_those_of_a_voronoi_diagram():
    from scipy.spatial import Delaunay, cKDTree

    flat = np.random.default_rng(2).random((1500, 2))
    points = np.column_stack([flat, np.zeros(1500)])
    indices = Delaunay(flat).vertex_neighbor_vertices[0]
    inside = ((flat > 0.1) & (flat < 0.9)).all(axis=1)
    expected = (np.diff(indices)[inside] == 6).mean()
    up = np.tile([0.0, 0.0, 1.0], (1500, 1))
    assert share_of_six(cKDTree(points), points, up) == pytest.approx(expected, abs=0.02)


def test_faults_are_counted():
    surface = torus()
    spots = random_spots(surface, 500)
    spots.triangles[1], spots.weights[1] = spots.triangles[0], spots.weights[0]
    spots.weights[7] *= 1.1
    spots.weights[8] = (-0.1, 0.6, 0.5)
    report = analyze_surface(surface, spots)
    assert (report.duplicates, report.off_surface) == (2, 2)
    assert report.rho_space == 0
    assert "2 lie where another does" in " ".join(report.verdict)
    assert "2 with weights" in " ".join(report.verdict)


def test_what_cannot_be_measured_is_refused():
    surface = torus()
    spots = random_spots(surface, 50)
    with pytest.raises(TilewrightTypeError, match="surface must be a Surface"):
        analyze_surface(spots, spots)
    with pytest.raises(TilewrightTypeError, match="spots must be Spots"):
        analyze_surface(surface, spots.positions(surface))
    with pytest.raises(TilewrightValueError, match="are 3; at least 4"):
        analyze_surface(surface, spots[:3])
    with pytest.raises(TilewrightValueError, match=r"weights\[3\] is .*nan"):
        analyze_surface(
            surface, Spots(spots.triangles, spots.weights * np.where(np.arange(50) == 3, np.nan, 1)[:, None])
        )
    with pytest.raises(TilewrightValueError, match="numbered from 0"):
        analyze_surface(surface, Spots(spots.triangles + 5000, spots.weights))
    with pytest.raises(TilewrightValueError, match="has shape"):
        analyze_surface(surface, Spots(spots.triangles, spots.weights[:, :2]))
