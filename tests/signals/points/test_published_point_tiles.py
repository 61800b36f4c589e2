"""Published point tiles (Shade, Hiller, Kopf): what they promise in every neighborhood, and their flaws."""

from itertools import product

import numpy as np
import pytest
from scipy.spatial import Delaunay, Voronoi

from cores import cores
from laying import SIDE, fits_all_around, lay, nearest, random_cells
from tilewright.analysis.points.border import border_density
from tilewright.errors import Cancelled, TilewrightTypeError, TilewrightValueError
from tilewright.kernels.chance import draw_unit
from tilewright.kernels.wang_points import average_moves
from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius
from tilewright.signals.points.hiller import Surroundings, hiller_tiles
from tilewright.signals.points.kopf import kopf_tiles
from tilewright.signals.points.neighborhood import NORTH, OFFSETS, Neighbors
from tilewright.signals.points.point_tiles import PointTiles
from tilewright.signals.points.promise import find_closeness
from tilewright.signals.points.recursion import children_of
from tilewright.signals.points.shade import shade_tiles
from tilewright.tiles import (
    cohen_tiles,
    compact_wang_tiles,
    corner_coded_tiles,
    corner_tiles,
    dominoes,
    tile_set,
    wang_tiles,
)
from tilewright.tiles.variants import Variants

# Neighborhoods


@pytest.mark.parametrize("tiles", [cohen_tiles(8), corner_tiles(2), wang_tiles(2)])
def test_neighbors_are_those_of_blocks_of_four(tiles):
    count = len(tiles)
    east, south = (
        np.all([tiles.slots[:, a, None] == tiles.slots[:, b] for a, b in joint], axis=0)
        for joint in tiles.shape.joints
    )
    nw, ne, sw, se = np.indices((count,) * 4).reshape(4, -1)
    laid = east[nw, ne] & east[sw, se] & south[nw, sw] & south[ne, se]
    seen = np.zeros((8, count, count), bool)
    for d, (a, b) in enumerate([(nw, ne), (nw, sw), (nw, se), (ne, sw)]):
        seen[d, a[laid], b[laid]] = seen[d + 4, b[laid], a[laid]] = True
    fits = Neighbors.of(tiles).fits
    # A pair across an edge counts even if no block holds it; in these sets one always does.
    assert (fits == seen).all()
    assert (OFFSETS[4:] == -OFFSETS[:4]).all()


def test_neighbors_take_marks_at_corners_into_account():
    coded = corner_coded_tiles()
    fits = Neighbors.of(coded).fits
    a, b = np.nonzero(fits[2])
    assert (coded.slots[a, coded.shape.slot("SE")] == coded.slots[b, coded.shape.slot("NW")]).all()


def test_a_tile_across_a_corner_needs_both_tiles_between():
    # The last tile goes with the second, which goes with the first; nothing goes below the first.
    tiles = tile_set([[0, 1, 0, 0], [3, 3, 2, 1], [2, 4, 4, 5]])
    assert not Neighbors.of(tiles).fits[2, 0, 2]
    fourth = tile_set([[0, 1, 0, 0], [3, 3, 2, 1], [2, 4, 4, 5], [0, 5, 0, 0]])
    assert Neighbors.of(fourth).fits[2, 0, 2]


def test_lists_hold_the_tiles_that_fit():
    neighbors = Neighbors.of(cohen_tiles(12))
    starts, members = neighbors.lists()
    for d, t in product(range(8), range(12)):
        assert (
            members[starts[d, t] : starts[d, t + 1]].tolist() == np.flatnonzero(neighbors.fits[d, t]).tolist()
        )


def test_closeness_against_all_pairs():
    rng = np.random.default_rng(4)
    tiles = cohen_tiles(8)
    rows = [rng.random((rng.integers(0, 6), 2)) for _ in range(16)]
    made = PointTiles.of(tiles, rows, variants=Variants.uniform(tiles, 2))
    within, across = [], []
    for row in range(16):
        own = made.tile(*divmod(row, 2)).astype(float)
        within += [np.hypot(*(a - b)) for i, a in enumerate(own) for b in own[:i]]
        for d, other in product(range(8), range(16)):
            if Neighbors.of(tiles).fits[d, row // 2, other // 2]:
                there = made.tile(*divmod(other, 2)) + OFFSETS[d]
                across += [np.hypot(*(a - b)) for a in own for b in there]
    close = find_closeness(made)
    assert (close.within, close.across) == pytest.approx((min(within), min(across)), abs=1e-12)


@pytest.mark.parametrize("spots", [[(0.9, 0.9), (0.05, 0.05)], [(0.05, 0.9), (0.9, 0.05)]])
def test_closeness_across_corners(spots):
    tiles = tile_set([[0, 0, 0, 0]])
    assert find_closeness(PointTiles.of(tiles, [np.array(spots)])).across == pytest.approx(
        0.15 * 2**0.5, abs=1e-6
    )


def test_closeness_of_next_to_nothing():
    tiles = tile_set([[0, 0, 0, 0]])
    assert find_closeness(PointTiles.of(tiles, [np.array([[0.2, 0.7]])])).across == 1.0
    assert find_closeness(PointTiles.of(tiles, [np.zeros((0, 2))])).across == np.inf


# Shade


@pytest.mark.parametrize(
    "tiles", [None, wang_tiles(2), cohen_tiles(18), corner_tiles(2), tile_set([[0, 0, 0, 0]])]
)
def test_shade_keeps_its_distance_in_every_tiling(tiles):
    made = shade_tiles(tiles, points=24, failures=5000, seed=3)
    assert find_closeness(made).distance >= made.distance
    assert made.distance == pytest.approx(2 * 0.7 * max_radius(24, Box()))
    for seed in range(3):
        assert nearest(lay(made, random_cells(made.tiles, SIDE, seed))) >= made.distance * (1 - 1e-12)


def test_shade_against_darts_one_by_one():
    tiles, key, distance = cohen_tiles(8), np.uint64(11), 2 * 0.7 * max_radius(6, Box())
    fits = Neighbors.of(tiles).fits
    placed = [[] for _ in tiles.slots]
    counter = missed = 0
    while missed < 200:
        t = int(draw_unit(key, 3 * counter) * 8)
        dart = np.float32([draw_unit(key, 3 * counter + 1), draw_unit(key, 3 * counter + 2)]).astype(float)
        near = list(placed[t])
        for d, other in product(range(8), range(8)):
            near += [p + OFFSETS[d] for p in placed[other]] if fits[d, t, other] else []
        counter, missed = counter + 1, missed + 1
        if all(np.hypot(*(dart - p)) >= distance for p in near):
            placed[t].append(dart)
            missed = 0
    made = shade_tiles(tiles, points=6, failures=200, seed=11)
    assert made.figures["darts"] == counter
    for t in range(8):
        assert (made.tile(t) == np.array(placed[t], np.float32).reshape(-1, 2)).all()


def test_shade_leaves_room_at_edges_and_more_at_corners():
    sets = [shade_tiles(points=32, failures=20_000, seed=s) for s in range(30)]
    edge, corner = (
        np.mean([getattr(border_density(s), name) for s in sets], axis=0) for name in ("edge", "corner")
    )
    assert 0.65 < edge[0] < 0.85
    assert 0.35 < corner[0] < 0.65
    assert edge[2:].mean() > 1.02
    shortfall = np.mean([s.figures["points"] / s.figures["plane"] for s in sets])
    assert 0.88 < shortfall < 0.97


def test_shade_is_full_at_a_smaller_radius_than_darts_in_a_plane():
    made = shade_tiles(points=32, seed=0)
    assert made.figures["rho"] == pytest.approx(0.756, abs=0.01)
    assert made.figures["rho"] == pytest.approx(made.distance / 2 / max_radius(1, Box()) * made.density**0.5)


# Density near borders


def test_border_density_of_an_even_set_is_one():
    rng = np.random.default_rng(0)
    even = PointTiles.of(cohen_tiles(8), [rng.random((20_000, 2)) for _ in range(8)])
    found = border_density(even, 5)
    assert found.distance == pytest.approx([0, 0.1, 0.2, 0.3, 0.4, 0.5])
    np.testing.assert_allclose(found.edge, 1, atol=0.03)
    np.testing.assert_allclose(found.corner, 1, atol=0.03)


def test_border_density_tells_edges_from_corners():
    rng = np.random.default_rng(0)
    points = rng.random((50_000, 2))
    gaps = np.minimum(points, 1 - points)
    no_edges, no_corners = points[gaps.min(axis=1) > 0.1], points[np.hypot(*gaps.T) > 0.1]
    tiles = tile_set([[0, 0, 0, 0]])
    assert border_density(PointTiles.of(tiles, [no_edges]), 5).edge[0] == 0
    found = border_density(PointTiles.of(tiles, [no_corners]), 5)
    assert found.corner[0] == 0
    assert 0.85 < found.edge[0] < 0.97


# Hiller


@pytest.mark.parametrize(
    "tiles", [cohen_tiles(8), tile_set([[0, 0, 0, 0], [1, 0, 1, 0], [0, 1, 1, 1], [1, 1, 0, 1]])]
)
def test_surroundings_are_all_that_fit(tiles):
    neighbors = Neighbors.of(tiles)
    for t in range(len(tiles)):
        around = Surroundings.of(neighbors, t)
        found = around.find(np.arange(around.count))
        assert len(np.unique(found, axis=0)) == around.count
        assert all(fits_all_around(tiles, t, ring) for ring in found[:: max(1, around.count // 50)])
        slow = 0
        north, east, south, west = (np.flatnonzero(neighbors.fits[d, t]) for d in (5, 0, 1, 4))
        for n, e, s, w in product(north, east, south, west):
            corners = [((n, 0), (e, 5)), ((s, 0), (e, 1)), ((s, 4), (w, 1)), ((n, 4), (w, 5))]
            slow += np.prod(
                [(neighbors.fits[i, a] & neighbors.fits[j, b]).sum() for (a, i), (b, j) in corners]
            )
        assert slow == around.count
    if len(tiles) == 8:
        assert around.count == 4096
        assert NORTH == 5


def test_drawn_surroundings_are_different_ones():
    around = Surroundings.of(Neighbors.of(wang_tiles(2)), 5)
    drawn = around.draw(300, np.random.default_rng(0))
    assert len(np.unique(drawn, axis=0)) == 300
    assert all(fits_all_around(wang_tiles(2), 5, ring) for ring in drawn)
    single = Surroundings.of(Neighbors.of(tile_set([[0, 0, 0, 0]])), 0)
    assert single.draw(3, np.random.default_rng(0)).tolist() == [[0] * 8] * 3


def test_average_moves_against_qhull():
    rng = np.random.default_rng(2)
    tiles, n = cohen_tiles(8), 5
    points = rng.random((8, n, 2))
    rings = np.stack([Surroundings.of(Neighbors.of(tiles), t).draw(3, rng) for t in range(8)])
    moves = np.empty_like(points)
    average_moves(8 * n, points, OFFSETS, rings, moves)
    slow = np.zeros_like(points)
    for t, ring in product(range(8), range(3)):
        blocks = [points[t]] + [points[u] + o for u, o in zip(rings[t, ring], OFFSETS, strict=True)]
        everything = np.concatenate(blocks)
        # Mirror images make the block's border part of the diagram.
        mirrored = [everything]
        for axis, wall in product((0, 1), (-1, 2)):
            image = everything.copy()
            image[:, axis] = 2 * wall - image[:, axis]
            mirrored.append(image)
        diagram = Voronoi(np.concatenate(mirrored))
        for i in range(n):
            corners = diagram.vertices[diagram.regions[diagram.point_region[i]]]
            fan = corners[Delaunay(corners).simplices]
            areas = np.abs(np.linalg.det(fan[:, 1:] - fan[:, :1]))
            slow[t, i] += (np.average(fan.mean(axis=1), axis=0, weights=areas) - points[t, i]) / 3
    np.testing.assert_allclose(moves, slow, atol=1e-9)


def test_hiller_distance_holds_in_every_tiling():
    made = hiller_tiles(points=20, iterations=20, configurations=64, seed=2)
    assert (made.counts == 20).all()
    assert made.distance == find_closeness(made).distance
    found = nearest(lay(made, random_cells(made.tiles)))
    assert made.distance * (1 - 1e-9) <= found
    assert found < made.distance * 1.3  # the promise is no shorter than need be


def test_hiller_comes_far_within_tiles_and_less_far_between_them():
    intra, inter = [], []
    for seed in range(4):
        made = hiller_tiles(points=32, iterations=30, configurations=64, seed=seed)
        assert made.figures["configurations"] == [4096] * 8
        assert len(made.figures["intra"]) == len(made.figures["inter"]) == 31
        assert made.figures["inter"][-1] == pytest.approx(made.distance / 2 / max_radius(32, Box()))
        intra.append(made.figures["intra"])
        inter.append(made.figures["inter"])
    assert (np.array(intra)[:, 0] < 0.15).all()
    assert 0.7 < np.mean(intra, axis=0)[-1] < 0.82
    assert 0.5 < np.mean(inter, axis=0)[-1] < 0.7


def test_hiller_takes_all_configurations_where_they_are_few():
    one = tile_set([[0, 0, 0, 0]])
    few, many = (hiller_tiles(one, 9, 10, configurations=c, seed=1) for c in (1, 50))
    assert few.figures["configurations"] == [1]
    assert few.points.tobytes() == many.points.tobytes()
    # The only tile is a torus: Lloyd's relaxation of it leaves nothing close.
    assert many.figures["inter"][-1] > 0.6


def test_hiller_refuses_a_tile_that_nothing_fits_around():
    with pytest.raises(TilewrightValueError, match="tile 1"):
        hiller_tiles(tile_set([[0, 0, 0, 0], [0, 1, 0, 0]]), 4, 1)


def test_hiller_is_the_same_for_any_number_of_threads():
    made = []
    for count in (1, 3):
        with cores(count):
            made.append(hiller_tiles(points=8, iterations=5, configurations=16, seed=4).points.tobytes())
    assert made[0] == made[1]


# All


@pytest.mark.parametrize(
    "make",
    [
        lambda **k: shade_tiles(points=8, failures=500, **k),
        lambda **k: hiller_tiles(points=6, iterations=3, configurations=8, **k),
        lambda **k: kopf_tiles(64, subdivision=2, **k),
    ],
)
def test_seeds_and_progress(make):
    one, same, other = (make(seed=s) for s in (5, 5, 6))
    assert one.points.tobytes() == same.points.tobytes()
    assert one.points.tobytes() != other.points.tobytes()
    assert ((one.points >= 0) & (one.points < 1)).all()
    again = make(seed=np.random.default_rng(1))
    assert make(seed=again.recipe["seed"]).points.tobytes() == again.points.tobytes()

    calls = []
    make(progress=lambda *call: calls.append(call))
    assert all(0 <= done <= total and isinstance(what, str) for done, total, what in calls)
    assert calls

    def stop(done, total, what):
        raise Cancelled("enough")

    with pytest.raises(Cancelled):
        make(progress=stop)


@pytest.mark.parametrize(
    ("make", "error", "words"),
    [
        (lambda: shade_tiles(dominoes(2)), TilewrightValueError, "square"),
        (lambda: shade_tiles("wang"), TilewrightTypeError, "tiles"),
        (lambda: shade_tiles(points=0), TilewrightValueError, "points"),
        (lambda: shade_tiles(points=1, rho=1), TilewrightValueError, "rho"),
        (lambda: shade_tiles(rho=np.nan), TilewrightValueError, "rho"),
        (lambda: shade_tiles(failures=0), TilewrightValueError, "failures"),
        (lambda: shade_tiles(seed=-1), TilewrightValueError, "seed"),
        (lambda: hiller_tiles(points=1.5), TilewrightTypeError, "points"),
        (lambda: hiller_tiles(iterations=-1), TilewrightValueError, "iterations"),
        (lambda: hiller_tiles(configurations=0), TilewrightValueError, "configurations"),
        (lambda: kopf_tiles(100), TilewrightValueError, "points"),
        (lambda: kopf_tiles(260), TilewrightValueError, "multiple"),
        (lambda: kopf_tiles(colors=5), TilewrightValueError, "colors"),
        (lambda: kopf_tiles(subdivision=1), TilewrightValueError, "subdivision"),
        (lambda: kopf_tiles(64, 3, 2), TilewrightValueError, "no rule"),
        (lambda: border_density(3), TilewrightTypeError, "PointTiles"),
        (lambda: find_closeness(None), TilewrightTypeError, "PointTiles"),
        (lambda: children_of(None), TilewrightTypeError, "PointTiles"),
    ],
)
def test_bad_input(make, error, words):
    with pytest.raises(error, match=words):
        make()


def test_compact_set_of_two_colors_is_cohens():
    assert (compact_wang_tiles(2).slots == cohen_tiles(8).slots).all()
