"""Points of dual tiles keep their distance wherever tiles fit, and only there."""

import numpy as np
import pytest
from scipy.spatial import KDTree

from meshes import cube
from tilewright.domains.medial import MedialDomain
from tilewright.domains.repair import make_sound
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.kernels.cones import fill_cone, measure, rank_cone
from tilewright.samplers import Box, max_radius
from tilewright.signals.points.dual import dual_point_tiles
from tilewright.signals.points.dual.places import rotate, to_cone, to_sectors
from tilewright.tiles.dual import canonical_slots, list_dual_tiles
from tilewright.tilings.surface_tiling import SurfaceTiling

CORNERS = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])


def lay_on_a_torus(tiles, side, see):
    """Points of tiles of four corners on a torus, whose corners ``see`` shows to their quadrants."""
    values = np.random.default_rng(3).integers(0, 4 * tiles.colors, (side, side))
    made = []
    for y, x in np.ndindex(side, side):
        around = [values[(y + dy) % side, (x + dx) % side] for dx, dy in CORNERS]
        word, turn = canonical_slots([[4 * (v // 4) + see(int(v) % 4, q) % 4 for q, v in enumerate(around)]])
        rows = tiles.rows(word)
        sectors = (rows.sectors + turn[0]) % 4
        for k in range(4):
            mine = rows.points[sectors == k].astype(np.float64)
            made.append(rotate(mine, k) + CORNERS[k] + (x, y))
    return np.concatenate(made) % side


@pytest.mark.parametrize(("points", "rho"), [(12, 0.7), (32, 0.7), (64, 0.75)])
def test_distances_hold_on_a_torus_and_nowhere_else_but_by_the_rule(points, rho):
    tiles = dual_point_tiles(2, points, rho)
    least = {}
    for name, see in {
        "right": lambda o, q: o - q,
        "wrong sign": lambda o, q: o + q,
        "wrong quadrant": lambda o, q: o - (2 if q == 1 else q),
    }.items():
        made = lay_on_a_torus(tiles, 8, see)
        assert len(made) == 64 * points
        least[name] = KDTree(made, boxsize=8).query(made, 2)[0][:, 1].min()
    assert least["right"] >= tiles.distance - 1e-6
    assert tiles.distance == pytest.approx(2 * rho * max_radius(points, Box()))
    assert max(least["wrong sign"], least["wrong quadrant"]) < 0.6 * tiles.distance


def test_distances_hold_around_the_corners_of_a_cube():
    """Its corners are tiles of three corners: the surface is flat but there, so all can be unfolded."""
    tiles = dual_point_tiles(2, 32, 0.7)
    domain = MedialDomain.of(make_sound(cube())).subdivide().subdivide()
    starts, slots = domain.tile_starts, SurfaceTiling(domain, 2, 5).slots
    spots, owners = [], []
    for t in range(len(starts) - 1):
        n = starts[t + 1] - starts[t]
        words, turns = canonical_slots(slots[starts[t] : starts[t + 1]][np.newaxis])
        rows = tiles.rows(words)
        assert len(rows.points) == 8 * n
        sectors = domain.sectors[starts[t] + (rows.sectors + turns[0]) % n]
        x, y = rows.points.T.astype(np.float64)
        weights = np.stack([2 * y, 1 - x - y, x - y], axis=1)
        uv = np.einsum("pk,pkd->pd", weights, domain.triangles[sectors])
        spots.append(domain.lift(domain.sector_bases[sectors], uv).positions(domain.sound.cut.surface))
        owners.append(np.full(len(x), n))
    places, corners = np.concatenate(spots), np.concatenate(owners)
    # Sides of medial tiles join the middles of sides of squares, which are a quarter long.
    side = np.sqrt(2) / 8
    within = np.all((places > 0.02) & (places < 0.98), axis=1)
    assert not within.any()
    # Pairs on one face lie in its plane; those around an edge are measured unfolded.
    pairs = KDTree(places).query_pairs(tiles.distance * side, output_type="ndarray")
    apart = [unfolded(places[i], places[j]) for i, j in pairs]
    assert len(pairs) > 10
    assert min(apart) >= tiles.distance * side - 1e-6
    assert (corners == 3).sum() == 8 * 24


def unfolded(one, other):
    """The shortest way between near places of the unit cube, around an edge or two."""
    faces = [{(a, round(p[a])) for a in range(3) if abs(p[a] - round(p[a])) < 1e-9} for p in (one, other)]
    if faces[0] & faces[1]:
        return np.linalg.norm(one - other)
    (a, u), (b, v) = next(iter(faces[0])), next(iter(faces[1]))
    direct = around(one, other, (a, u), (b, v))
    c = 3 - a - b
    w = round(one[c])
    # By way of the third face that meets both.
    ways = [np.hypot(abs(one[c] - w) + abs(other[a] - u), abs(one[b] - v) + abs(other[c] - w))]
    return min(direct, *ways)


def around(one, other, first, second):
    """The way over the common edge of two faces."""
    (a, u), (b, v) = first, second
    c = 3 - a - b
    return np.hypot(abs(one[b] - v) + abs(other[a] - u), one[c] - other[c])


@pytest.mark.parametrize("corners", [1, 2, 3, 5, 6, 9, 24])
def test_points_keep_apart_on_the_cone_of_every_number_of_corners(corners):
    tiles = dual_point_tiles(1, 16, 0.7, seed=2)
    words = canonical_slots(np.random.default_rng(4).integers(0, 4, (6, corners)))[0]
    rows = tiles.rows(words)
    assert np.diff(rows.starts).tolist() == [4 * corners] * 6
    for first, last in zip(rows.starts[:-1], rows.starts[1:], strict=True):
        made = rows.points[first:last].astype(np.float64)
        cone = np.concatenate(
            [to_cone(made[[p]], int(rows.sectors[first + p]), corners) for p in range(len(made))]
        )
        least = min(on_cone(a, b, corners) for i, a in enumerate(cone) for b in cone[:i])
        assert least >= tiles.distance - 1e-6
        sectors, again = to_sectors(cone, corners)
        assert np.array_equal(sectors, rows.sectors[first:last])
        assert again == pytest.approx(made, abs=1e-6)


def on_cone(a, b, corners):
    """The law of cosines, or over the apex."""
    turn = corners * np.pi / 2
    apart = abs(a[1] - b[1])
    apart = min(apart, turn - apart)
    if apart >= np.pi:
        return a[0] + b[0]
    return abs(a[0] - b[0] * np.exp(1j * apart))


def test_the_kernels_agree_with_plain_formulas():
    rng = np.random.default_rng(5)
    for corners in (1, 3, 4, 7):
        for _ in range(50):
            a, b = rng.random((2, 2)) * (1, corners * np.pi / 2)
            assert measure(*a, *b, corners * np.pi / 2) == pytest.approx(on_cone(a, b, corners), abs=1e-9)
    places = np.zeros((6, 2))
    assert fill_cone(np.uint64(1), 2 * np.pi, (0.5, 0.5, 0.0, 0.0), 0, 6, True, 0.2, places)
    plane = places[:, 0] * np.exp(1j * places[:, 1])
    assert plane[::2] == pytest.approx(-plane[1::2])
    assert not fill_cone(np.uint64(1), 2 * np.pi, (0.2, 0.2, 0.0, 0.0), 0, 6, False, 0.4, places)


def test_ranks_leave_the_most_crowded_point_out_first():
    corners = np.array([(0.4, 0.2), (0.4, 1.8), (0.4, 3.3), (0.4, 3.35), (0.4, 4.9)])
    order = np.empty(5, np.int64)
    rank_cone(2 * np.pi, 5, 0, corners, order)
    assert sorted(order.tolist()) == list(range(5))
    assert order[-1] in (2, 3)
    crowd = np.concatenate([corners, [(0.4, 0.25), (0.4, 0.15), (0.45, 0.2)]])
    rank_cone(2 * np.pi, 5, 3, crowd, order)
    assert order[-1] == 0


def test_a_smaller_share_of_a_tile_is_spread_as_well():
    tiles = dual_point_tiles(1, 64, 0.7)
    rows = tiles.rows(list_dual_tiles(4, 1)[:20])
    means = {}
    for share in (16, 32):
        least = []
        for first in rows.starts[:-1]:
            for order in (np.arange(64), np.random.default_rng(first).permutation(64)):
                kept = first + order[:share]
                made = np.concatenate(
                    [to_cone(rows.points[[p]].astype(float), int(rows.sectors[p]), 4) for p in kept]
                )
                plane = made[:, 0] * np.exp(1j * made[:, 1])
                apart = np.abs(plane[:, None] - plane) + 9 * np.eye(share)
                least.append(apart.min(axis=1).mean())
        means[share] = np.mean(least[::2]) / np.mean(least[1::2])
    assert means[16] > 1.15
    assert means[32] > 1.04


def test_tiles_are_the_same_whatever_was_asked_before():
    words = list_dual_tiles(3, 2)[5:25]
    one, other = (dual_point_tiles(2, 16, 0.7, seed=9) for _ in range(2))
    other.rows(words[::-1])
    a, b = one.rows(words), other.rows(words)
    assert all(np.array_equal(getattr(a, f), getattr(b, f)) for f in ("starts", "sectors", "points"))
    assert not np.array_equal(a.points, dual_point_tiles(2, 16, 0.7, seed=8).rows(words).points)


def test_what_no_set_has_is_refused():
    with pytest.raises(TilewrightValueError, match=r"rho is 0\.8"):
        dual_point_tiles(2, 32, 0.8)
    with pytest.raises(TilewrightTypeError, match="points"):
        dual_point_tiles(2, 32.5)
    tiles = dual_point_tiles(1, 16)
    for words in ([(1, 0, 0)], [(0, 0, 4)], [0, 1], [()]):
        with pytest.raises(TilewrightValueError, match="words"):
            tiles.rows(words)
    with pytest.raises(TilewrightTypeError, match="words"):
        tiles.rows([(0.5, 1)])
    assert tiles.rows(np.zeros((0, 3), int)).starts.tolist() == [0]
