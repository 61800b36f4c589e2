"""Recursive tiles (Kopf et al. 2006): merging, subdivision, self-similarity."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from laying import lay, nearest, random_cells
from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet
from tilewright.samplers.relaxation import relaxation_darts
from tilewright.signals.points.kopf import kopf_tiles
from tilewright.signals.points.merging import merge
from tilewright.signals.points.recursion import children_of, find_children, recursive_points, subdivide
from tilewright.signals.points.shade import shade_tiles
from tilewright.tiles import (
    cohen_tiles,
    wang_tiles,
)
from tilewright.tilings import first_mismatch


@pytest.fixture(scope="module")
def kopf():
    return kopf_tiles(512, seed=1)


# Merging


def test_merging_a_set_with_itself_changes_nothing():
    points = np.column_stack([relaxation_darts(400, seed=1).points, np.arange(400) / 400])
    depth = points[:, 0] * 3 - 1
    left, right = merge(points, points + np.array([1e-9, 0, 0]), depth, depth, 0.05)
    assert (left ^ right).all()


def test_merging_keeps_to_the_sides_that_are_given():
    one, other = (
        np.column_stack([relaxation_darts(400, seed=s).points, np.arange(400) / 400]) for s in (1, 2)
    )
    depths = [p[:, 0] * 3 - 1 for p in (one, other)]
    left, right = merge(one, other, *depths, 0.05)
    assert left[depths[0] <= 0].all()
    assert not left[depths[0] >= 1].any()
    assert right[depths[1] >= 1].all()
    assert not right[depths[1] <= 0].any()
    merged = np.concatenate([one[left], other[right]])
    assert 370 < len(merged) < 430
    # Straight cuts leave points closer together than the seam does.
    straight = [
        nearest(np.concatenate([one[one[:, 0] < cut], other[other[:, 0] >= cut]])[:, :2])
        for cut in np.linspace(0.35, 0.65, 20)
    ]
    assert nearest(merged[:, :2]) > 1.2 * np.mean(straight)


# Kopf


@pytest.mark.parametrize(
    ("tiles", "n"), [(cohen_tiles(8), 2), (cohen_tiles(8), 4), (cohen_tiles(18), 3), (wang_tiles(2), 3)]
)
def test_subdivided_tilings_are_tilings(tiles, n):
    for seed in range(3):
        children = find_children(tiles, n, np.random.default_rng(seed))
        cells = random_cells(tiles, 12, seed)
        for _ in range(2):
            cells = subdivide(children, cells)
            assert first_mismatch(tiles, cells, torus=False) is None


def test_arrangements_are_drawn_from_all_there_are():
    tiles = cohen_tiles(8)
    seen = {find_children(tiles, 2, np.random.default_rng(s))[0].tobytes() for s in range(60)}
    assert len(seen) > 10


def test_kopf_tiles_are_made_of_smaller_ones(kopf):
    children, each = children_of(kopf), 512 // 16
    for t, arrangement in enumerate(children):
        parts = np.concatenate(
            [(kopf.tile(c)[:each] + np.array([x, y])) / 4 for (y, x), c in np.ndenumerate(arrangement)]
        )
        gaps, match = cKDTree(parts).query(kopf.tile(t))
        assert gaps.max() < 1e-6
        assert len(set(match.tolist())) == 512
    assert (kopf.counts == 512).all()


def test_kopf_density_grows_by_adding_points(kopf):
    cells = random_cells(kopf.tiles, 5)
    before = np.zeros((0, 2))
    for density in (1, 7.5, 32, 100, 512, 513, 1000, 8192, 9000):
        points = recursive_points(kopf, cells, density)
        assert ((points >= 0) & (points < 5)).all()
        assert len(points) == pytest.approx(25 * density, rel=0.15, abs=25)
        if len(before):
            assert cKDTree(points).query(before)[0].max() < 1e-6
        before = points


def test_kopf_looks_the_same_at_every_level(kopf):
    cells = random_cells(kopf.tiles, 6)
    coarse = recursive_points(kopf, cells, 512)
    fine = recursive_points(kopf, cells, 512 * 16)
    again = np.concatenate(
        [
            (kopf.tile(t) + np.array([x, y])) / 4
            for (y, x), t in np.ndenumerate(subdivide(children_of(kopf), cells))
        ]
    )
    np.testing.assert_allclose(fine, again, atol=1e-6)
    assert len(coarse) == 36 * 512


def test_kopf_distance_holds_and_is_short(kopf):
    assert nearest(lay(kopf, random_cells(kopf.tiles, 20))) >= kopf.distance * (1 - 1e-6)
    radii = []
    cells = random_cells(kopf.tiles, 12)
    for density in (8, 32, 128, 512):
        points = recursive_points(kopf, cells, density)
        radii.append(PointSet(points, Box((12, 12), torus=False)).rho)
    assert min(radii) > 0.1
    assert max(radii) < 0.5


def test_kopf_ranks_spread_points_better_than_chance(kopf):
    cells = random_cells(kopf.tiles, 12)
    for density in (32, 128):
        points = recursive_points(kopf, cells, density)
        mean = cKDTree(points).query(points, k=2)[0][:, 1].mean() * density**0.5
        assert mean > 0.68  # points by chance have 0.5, dart throwing 0.75


def test_other_tiles_do_not_subdivide():
    with pytest.raises(TilewrightValueError, match="kopf_tiles"):
        recursive_points(shade_tiles(points=2, failures=10), [[0]], 1)


@pytest.mark.parametrize(
    ("cells", "density", "words"),
    [
        ([[9]], 1, "cells"),
        ([0], 1, "cells"),
        ([[0]], -1, "density"),
        ([[0]], np.inf, "density"),
        ([[0]], 1e12, "density"),
    ],
)
def test_bad_recursion(kopf, cells, density, words):
    with pytest.raises(TilewrightValueError, match=words):
        recursive_points(kopf, cells, density)
