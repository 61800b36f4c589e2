"""Points walk on surfaces, and are spread as far as asked; kernels do what plain loops do."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import KDTree

from meshes import CLOSED, OPEN, band, cube, fan, square, torus
from tilewright.domains import Spots
from tilewright.domains.nearest import nearest_spots
from tilewright.domains.repair import make_sound
from tilewright.kernels.threads import at_most
from tilewright.samplers.surfaces import RECIPES, Recipe, refine_spots
from tilewright.samplers.surfaces.ground import Ground, Lists, Walkers, walk_spots
from tilewright.samplers.surfaces.refining import _Crowd, _measure_cells

FINE = {"square": square(8), "torus": torus(), "cube": cube(), "fan": fan(24), "band": band(twist=2)}


def surface_of(mesh):
    return make_sound(mesh).cut.surface


def throw(surface, count, seed=0):
    """Spots by chance, even by area."""
    rng = np.random.default_rng(seed)
    slices = (np.arange(count) + rng.random(count)) / count * surface.area
    triangles = np.minimum(np.searchsorted(np.cumsum(surface.areas), slices), len(surface.areas) - 1)
    return Spots(triangles.astype(np.int32), rng.dirichlet([1, 1, 1], count))


def cover(surface, places):
    """The greatest distance of any place from the nearest of ``places``, over the radius of a packing."""
    dense = throw(surface, 60_000, 9).positions(surface)
    return KDTree(places).query(dense)[0].max() / np.sqrt(surface.area / (2 * np.sqrt(3) * len(places)))


@pytest.mark.parametrize("name", {**CLOSED, **OPEN})
def test_walks_stay_on_the_surface_and_go_as_far_as_they_should(name):
    surface = surface_of({**CLOSED, **OPEN}[name])
    spots = throw(surface, 300)
    ground, walkers = Ground.of(surface), Walkers.of(spots, surface)
    rng = np.random.default_rng(2)
    moves = rng.normal(0, 0.4, (300, 3))
    normals = spots.normals(surface)
    moves -= (moves * normals).sum(axis=1, keepdims=True) * normals
    before = walkers.places.copy()
    ground.walk(walkers, np.arange(0, 300, 2, dtype=np.int32), moves)
    assert walkers.weights.min() >= 0
    assert walkers.weights.sum(axis=1) == pytest.approx(1)
    assert walkers.places == pytest.approx(walkers.spots.positions(surface))
    assert np.array_equal(walkers.places[1::2], before[1::2])
    gone, length = np.linalg.norm(walkers.places - before, axis=1)[::2], np.linalg.norm(moves, axis=1)[::2]
    assert (gone <= length * (1 + 1e-9) + 1e-12).all()
    assert np.median(gone / length) > 0.7


def test_walks_in_the_plane_are_straight_and_slide_along_the_boundary():
    surface = surface_of(square(5))
    spots = throw(surface, 200)
    walkers = Walkers.of(spots, surface)
    moves = np.random.default_rng(3).normal(0, 0.3, (200, 3)) * (1, 1, 0)
    straight = walkers.places + moves
    Ground.of(surface).walk(walkers, np.arange(200, dtype=np.int32), moves.copy())
    inside = ((straight > 0) & (straight < 1))[:, :2].all(axis=1)
    assert 20 < inside.sum() < 180
    assert walkers.places[inside] == pytest.approx(straight[inside], abs=1e-9)
    assert walkers.places[~inside] == pytest.approx(np.clip(straight[~inside], 0, 1), abs=1e-9)


def test_a_walk_around_a_cube_comes_back():
    surface = surface_of(cube())
    walkers = Walkers.of(Spots(np.array([4], np.int32), np.array([(0.5, 0.25, 0.25)])), surface)
    before = walkers.places.copy()
    along = surface.vertices[surface.triangles[4, 1]] - surface.vertices[surface.triangles[4, 0]]
    Ground.of(surface).walk(walkers, np.zeros(1, np.int32), 4 * along[np.newaxis])
    assert walkers.places == pytest.approx(before)


@pytest.mark.parametrize("reach", [0.05, 0.3])
def test_lists_hold_the_nearest_in_order(reach):
    rng = np.random.default_rng(4)
    places, queries = rng.random((300, 3)), rng.random((40, 3)) * 1.4 - 0.2
    places[7] = places[8]
    apart = np.linalg.norm(places[:, None] - places, axis=2) + 9 * np.eye(300)
    lists = Lists.of(places, places, np.full(300, reach), 6)
    others = Lists.of(queries, places, np.full(40, reach), 6)
    for i in range(300):
        wanted = [j for j in np.lexsort((np.arange(300), apart[i])) if apart[i, j] <= reach][:6]
        assert lists.numbers[i, : lists.counts[i]].tolist() == wanted
    away = np.linalg.norm(queries[:, None] - places, axis=2)
    for i in range(40):
        wanted = [j for j in np.argsort(away[i], kind="stable") if away[i, j] <= reach][:6]
        assert others.numbers[i, : others.counts[i]].tolist() == wanted
    assert Lists.of(queries, np.zeros((0, 3)), np.full(40, reach), 6).counts.sum() == 0


def test_cells_of_a_flat_square_are_those_of_voronoi():
    """Their middles, and their farthest corners, by a fine grid."""
    surface = surface_of(square(3))
    crowd = _Crowd(surface, throw(surface, 60), None)
    moves, far, reach = _measure_cells(crowd, 1.0)
    fine = (np.stack(np.meshgrid(*[np.arange(400)] * 2), axis=-1).reshape(-1, 2) + 0.5) / 400
    places = crowd.walkers.places[:, :2]
    apart, owner = KDTree(places).query(fine)
    for i in range(60):
        mine = owner == i
        if reach[i] < 2.3 * crowd.radius:  # else the cell is cut off
            assert places[i] + moves[i, :2] == pytest.approx(fine[mine].mean(axis=0), abs=4e-3)
            assert reach[i] == pytest.approx(apart[mine].max(), abs=6e-3)
            assert np.linalg.norm(far[i]) == pytest.approx(reach[i])


@pytest.mark.parametrize("kind", RECIPES)
@pytest.mark.parametrize("name", FINE)
def test_points_come_as_far_apart_as_asked_and_leave_no_holes(name, kind):
    surface = surface_of(FINE[name])
    made = refine_spots(surface, throw(surface, 1500), RECIPES[kind])
    places = made.spots.positions(surface)
    radius = np.sqrt(surface.area / (2 * np.sqrt(3) * 1500))
    least = KDTree(places).query(places, 2)[0][:, 1].min() / 2 / radius
    assert made.pairs_left == 0
    assert made.rho == pytest.approx(least, abs=1e-6)
    assert least >= 0.765 - 1e-6
    assert cover(surface, places) < {"even": 1.9, "poisson": 2.2}[kind]
    assert made.moved.any() == (kind == "poisson") or kind == "even"


def test_what_cannot_be_reached_is_told():
    surface = surface_of(square(2))
    made = refine_spots(surface, throw(surface, 400), Recipe(rho=1.1, lloyd=0, fill=0, sweeps=20))
    assert made.pairs_left > 100
    assert made.rho < 1
    assert made.sweeps == 20


def test_spacing_follows_a_scale():
    """Eight times as dense on one half: points there keep a smaller distance, and all keep theirs."""
    surface = surface_of(square(8))

    def scale(spots):
        return np.where(spots.positions(surface)[:, 0] < 0.5, np.sqrt(4.5 / 8), np.sqrt(4.5))

    rng = np.random.default_rng(5)
    spots = throw(surface, 4000)
    spots = spots[rng.random(4000) < 1 / 8 * scale(spots) ** -2 * 4.5 / 8 * 8]
    made = refine_spots(surface, spots, replace(RECIPES["even"], fill=0, rho=0.7), scale=scale)
    places, factors = made.spots.positions(surface), scale(made.spots)
    radius = np.sqrt(surface.area / (2 * np.sqrt(3) * len(spots)))
    near, who = KDTree(places).query(places, 2)
    assert (near[:, 1] / (factors + factors[who[:, 1]]) / radius).min() >= 0.7 * (1 - 0.05)
    left = near[(places[:, 0] < 0.45), 1].mean()
    assert near[(places[:, 0] > 0.55), 1].mean() / left == pytest.approx(np.sqrt(8), rel=0.15)


def test_the_number_of_threads_makes_no_difference():
    surface = surface_of(torus())
    spots = throw(surface, 3000)
    made = []
    for count in (1, 2):
        with at_most(count):
            made.append(refine_spots(surface, spots, RECIPES["even"]).spots)
    assert made[0] == made[1]


def test_steps_are_laid_into_the_surface_and_go_around_edges():
    """In the plane as far as they point; around the edge of a cube; to the boundary, and no farther."""
    sheet = surface_of(square(5))
    spots = throw(sheet, 200)
    rng = np.random.default_rng(1)
    start = spots.positions(sheet)
    end = rng.random((200, 2))
    steps = np.column_stack([end - start[:, :2], rng.random(200)])
    at = walk_spots(Ground.of(sheet), spots, steps).positions(sheet)
    assert at[:, :2] == pytest.approx(end, abs=1e-9)
    box = surface_of(cube())
    start = nearest_spots(box, np.array([(0.9, 0.5, 1), (0.9, 0.5, 1)]))[0]
    ends = walk_spots(Ground.of(box), start, np.array([(0.3, 0.1, 0), (1.3, 0.0, 0)])).positions(box)
    assert ends == pytest.approx(np.array([(1, 0.6, 0.8), (0.8, 0.5, 0)]))
    start = nearest_spots(sheet, np.array([(0.5, 0.43, 0)]))[0]
    ends = walk_spots(Ground.of(sheet), start, np.array([(2.0, 0, 0)])).positions(sheet)
    assert ends == pytest.approx(np.array([(1, 0.43, 0)]))
