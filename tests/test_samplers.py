"""Samplers without tiles: what each promises, their kernels against slow twins, and figures of the papers."""

import re
import subprocess
import sys
from itertools import pairwise, product

import numba
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import Voronoi, cKDTree

from tilewright import samplers
from tilewright.errors import Cancelled, TilewrightError, TilewrightTypeError, TilewrightValueError
from tilewright.samplers import METHODS, Box, PointSet, max_radius, nearest_distances, sample_points
from tilewright.samplers import request as asked
from tilewright.samplers.chance import make_key
from tilewright.samplers.lloyd import centroids

ALMOST = 1 - 1e-9
"""Rounding that a promised distance may lose."""

TORUS, PLAIN = Box(), Box(torus=False)
LONG, LOW = Box((3.0, 0.5)), Box((0.7, 20.0), torus=False)
CUBE, ROOM = Box((1.0, 1.0, 1.0)), Box((1.0, 2.0, 0.5), torus=False)
BOXES = {"torus": TORUS, "plain": PLAIN, "long": LONG, "low": LOW, "cube": CUBE, "room": ROOM}
FILLING = [name for name, method in METHODS.items() if method.fills]


def works_in(method: str, box: Box) -> None:
    if box.dimension not in METHODS[method].dimensions:
        pytest.skip(f"{method} works in planes")
    if box.torus and not METHODS[method].tori:
        pytest.skip(f"{method} does not go around tori")


def least_distance(points: np.ndarray, box: Box) -> float:
    """By comparing all pairs, images and all; of many points by SciPy."""
    if len(points) > 400:
        return float(nearest_distances(points, box).min())
    laps = product((-1, 0, 1), repeat=box.dimension) if box.torus else [(0,) * box.dimension]
    least = np.inf
    for lap in laps:
        apart = np.linalg.norm(points[:, None] - points + np.multiply(lap, box.extent), axis=2)
        if not any(lap):
            np.fill_diagonal(apart, np.inf)
        least = min(least, apart.min())
    return float(least)


def widest_gap(made: PointSet, steps: int) -> float:
    """From a fine grid of places, the farthest from all points; in units of the promised distance."""
    sides = np.array(made.box.extent)
    counts = np.maximum((steps * sides / sides.max()).astype(int), 8)
    axes = [(np.arange(c) + 0.5) / c * side for c, side in zip(counts, sides, strict=True)]
    places = np.stack(np.meshgrid(*axes), -1).reshape(-1, len(sides))
    tree = cKDTree(made.points, boxsize=sides if made.box.torus else None)
    return float(tree.query(places)[0].max()) / made.distance


# Laws over all methods


@pytest.mark.parametrize("box", BOXES.values(), ids=BOXES)
@pytest.mark.parametrize("name", METHODS)
def test_every_method_keeps_its_promises(name, box):
    works_in(name, box)
    method = METHODS[name]
    for count, seed in ((1, 0), (2, 1), (3, 2), (7, 3), (60, 4), (331, 5)):
        if (name, box) == ("dart", LONG) and count < 7:
            continue  # rho 0.7 is out of reach
        made = sample_points(name, count, seed=seed, box=box)
        assert made.box == box
        assert made.method == name
        assert made.points.dtype == np.float64
        assert made.points.flags.c_contiguous
        box.check_points(made.points)
        if method.exact and not method.fills:
            assert len(made) == count
        elif count > 7:
            assert 0.85 * count <= len(made) <= 1.15 * count
        assert least_distance(made.points, box) >= made.distance * ALMOST


@pytest.mark.parametrize("box", BOXES.values(), ids=BOXES)
@pytest.mark.parametrize("name", [name for name, method in METHODS.items() if method.takes_rho])
@pytest.mark.parametrize("rho", [0.3, 0.65])
def test_rho_is_kept(name, box, rho):
    works_in(name, box)
    for count, seed in ((2, 0), (40, 1), (300, 2)):
        if (box, count, rho) == (LONG, 2, 0.65):
            continue  # out of reach
        made = sample_points(name, count, rho, seed=seed, box=box)
        asked = 2 * rho * max_radius(count, box)
        assert made.distance == pytest.approx(asked, rel=1e-12)
        assert least_distance(made.points, box) >= asked * ALMOST
        assert len(made) == count or not METHODS[name].exact


@pytest.mark.parametrize("name", METHODS)
def test_same_seed_same_bytes(name):
    first = sample_points(name, 150, seed=3).points
    assert first.tobytes() == sample_points(name, 150, seed=3).points.tobytes()
    assert first.tobytes() != sample_points(name, 150, seed=4).points.tobytes()
    again = [sample_points(name, 150, seed=np.random.default_rng(8)).points.tobytes() for _ in range(2)]
    assert again[0] == again[1]
    assert first.tobytes() == sample_points(name, np.int32(150), seed=np.uint8(3)).points.tobytes()


@pytest.mark.parametrize("name", FILLING)
@pytest.mark.parametrize("box", [TORUS, PLAIN, LONG, LOW], ids=["torus", "plain", "long", "low"])
def test_full_sets_leave_no_gap(name, box):
    for count, seed in ((1, 0), (4, 1), (30, 2), (400, 3)):
        made = sample_points(name, count, seed=seed, box=box)
        assert made.figures["maximal"]
        assert widest_gap(made, 400) <= 1.0001


def test_full_volumes_leave_no_gap():
    for box in (CUBE, ROOM):
        assert widest_gap(sample_points("maximal", 200, seed=1, box=box), 60) <= 1.0001


def test_sets_that_stop_before_they_are_full_have_gaps():
    for name in ("jones", "maximal"):
        made = sample_points(name, 400, 0.6)
        assert not made.figures["maximal"]
        assert widest_gap(made, 400) > 1.01


@pytest.mark.parametrize("name", [*FILLING, "bridson"])
@pytest.mark.parametrize("torus", [True, False])
def test_full_sets_come_to_about_the_count_asked_for(name, torus):
    counts = [len(sample_points(name, 2000, seed=s, box=Box(torus=torus))) for s in range(6)]
    assert np.mean(counts) == pytest.approx(2000, rel=0.015)


def test_methods_of_dart_throwing_are_as_dense():
    """Jamming limit of random sequential adsorption: disks cover 54.7 % (spheres 38.4 %)."""
    covered = {
        name: np.mean([len(made) * np.pi * made.distance**2 / 4 for made in sets])
        for name, sets in ((n, [sample_points(n, 4000, seed=s) for s in range(4)]) for n in FILLING)
    }
    assert covered["jones"] == pytest.approx(0.547, abs=0.003)
    assert covered["maximal"] == pytest.approx(0.547, abs=0.003)
    assert covered["scallop-log"] == pytest.approx(0.547, abs=0.006)
    assert covered["scallop-boundary"] > covered["scallop-linear"] > covered["jones"] + 0.01
    ball = sample_points("maximal", 4000, box=CUBE)
    assert len(ball) * np.pi * ball.distance**3 / 6 == pytest.approx(0.384, abs=0.005)


def test_distances_are_distributed_alike():
    """Shares of points whose nearest neighbor is within 1.05 and 1.15 of the least distance."""
    shares = {}
    for name in ("dart", "jones", "maximal"):
        near = [nearest_distances(made.points, made.box) / made.distance
                for made in (sample_points(name, 3000, 0.74, seed=s) for s in range(3))]  # fmt: skip
        shares[name] = [np.mean(np.concatenate(near) < limit) for limit in (1.05, 1.15)]
    assert shares["jones"] == pytest.approx(shares["dart"], abs=0.02)
    assert shares["maximal"] == pytest.approx(shares["dart"], abs=0.02)


def test_thread_counts_change_nothing():
    threads = numba.get_num_threads()
    try:
        made = []
        for count in (1, threads):
            numba.set_num_threads(count)
            made.append(sample_points("lloyd", 2000, iterations=3).points.tobytes())
    finally:
        numba.set_num_threads(threads)
    assert made[0] == made[1]


def test_importing_the_samplers_loads_neither_numba_nor_scipy():
    check = "import sys, tilewright.samplers as s; s.METHODS, s.Box, s.sample_points, s.dart_throwing;"
    check += "assert not {'numba', 'scipy'} & set(sys.modules), 'loaded'"
    subprocess.run([sys.executable, "-c", check], check=True)
    assert all(getattr(samplers, name) is not None for name in samplers.__all__)
    assert set(samplers.__all__) == set(dir(samplers))


@pytest.mark.parametrize("name", [n for n, m in METHODS.items() if "yardsticks" not in m.home])
def test_progress_is_told_and_can_stop(name):
    told = []
    sample_points(name, 40, progress=lambda *news: told.append(news))
    assert told
    assert all(0 <= done <= total and isinstance(what, str) for done, total, what in told)

    def stop(done, total, what):
        raise Cancelled

    with pytest.raises(Cancelled):
        sample_points(name, 40, progress=stop)


@settings(max_examples=60, deadline=None)
@given(
    name=st.sampled_from(["dart", "jones", "maximal", "relaxation", "bridson", "lloyd", *FILLING]),
    count=st.integers(1, 40),
    extent=st.tuples(st.floats(0.05, 20), st.floats(0.05, 20)),
    torus=st.booleans(),
    seed=st.integers(0, 2**64 - 1),
)
def test_any_box_is_filled_or_refused(name, count, extent, torus, seed):
    box = Box(extent, torus)
    try:
        made = sample_points(name, count, seed=seed, box=box)
    except TilewrightValueError as error:
        if re.match("rho is .* can be reached", str(error)):
            return
        raise
    box.check_points(made.points)
    assert least_distance(made.points, box) >= made.distance * ALMOST


# Twins of the kernels


class Numbers:
    """The numbers of a key, one after another, from Python."""

    def __init__(self, seed: int) -> None:
        from tilewright.kernels.chance import draw_unit, draw_word

        self.key, self.drawn, self.unit_at, self.word_at = make_key(seed), 0, draw_unit, draw_word

    def unit(self) -> float:
        self.drawn += 1
        return float(self.unit_at(self.key, self.drawn - 1))

    def word(self) -> int:
        self.drawn += 1
        return int(self.word_at(self.key, self.drawn - 1))


def apart(a, b, box: Box) -> float:
    gap = np.abs(np.subtract(a, b))
    return float(np.linalg.norm(np.minimum(gap, np.subtract(box.extent, gap)) if box.torus else gap))


@pytest.mark.parametrize("box", [TORUS, LOW, CUBE])
@pytest.mark.parametrize("rho", [0.0, 0.05, 0.6])
def test_dart_throwing_equals_its_twin(box, rho):
    numbers, points = Numbers(5), []
    while len(points) < 60:
        dart = [numbers.unit() * e for e in box.extent]
        if all(apart(dart, p, box) >= 2 * rho * max_radius(60, box) for p in points):
            points.append(dart)
    assert np.array_equal(sample_points("dart", 60, rho, seed=5, box=box).points, points)


@pytest.mark.parametrize("box", [TORUS, PLAIN, LONG, CUBE])
def test_relaxation_equals_its_twin(box):
    numbers, points, missed = Numbers(6), [], 0
    distance = min(0.3 * box.volume ** (1 / box.dimension), *(box.extent if box.torus else ()), np.inf)
    while len(points) < 50:
        dart = [numbers.unit() * e for e in box.extent]
        if all(apart(dart, p, box) >= distance for p in points):
            points.append(dart)
            missed = 0
        else:
            missed += 1
            if missed == 20:
                distance, missed = distance * 0.9, 0
    made = samplers.relaxation_darts(50, factor=0.9, failures=20, seed=6, box=box)
    assert np.array_equal(made.points, points)
    assert made.distance == distance


def test_bridson_equals_its_twin():
    for box in (TORUS, PLAIN):
        numbers, distance = Numbers(7), 0.16
        points = [[numbers.unit(), numbers.unit()]]
        active = [0]
        while active:
            at = numbers.word() % len(active)
            for _ in range(30):
                while True:
                    step = np.array([4 * numbers.unit() - 2, 4 * numbers.unit() - 2])
                    if 1 <= step @ step < 4:
                        break
                dart = points[active[at]] + step * distance
                if box.torus:
                    dart = dart - np.floor(dart)
                elif ((dart < 0) | (dart >= 1)).any():
                    continue
                if all(apart(dart, p, box) >= distance for p in points):
                    active.append(len(points))
                    points.append(dart)
                    break
            else:
                active[at] = active[-1]
                active.pop()
        rho = distance / 2 / max_radius(30, box)
        made = sample_points("bridson", 30, rho, seed=7, box=box)
        assert np.allclose(made.points, points, rtol=0, atol=1e-12)


@pytest.mark.parametrize("box", [TORUS, LOW, CUBE])
def test_the_best_candidate_equals_its_twin(box):
    numbers, points = Numbers(8), []
    for n in range(60):
        tried = [[numbers.unit() * e for e in box.extent] for _ in range(max(n, 1))]
        points.append(max(tried, key=lambda dart: min((apart(dart, p, box) for p in points), default=0)))
    assert np.array_equal(sample_points("best-candidate", 60, seed=8, box=box).points, points)


def test_few_candidates_are_as_good_as_all():
    """Most of 800 candidates are not drawn; the winner is as far from 400 points as the best of all."""
    from tilewright.kernels.candidates import add_farthest
    from tilewright.samplers import candidates

    start = samplers.uniform(400, seed=3).points
    points = np.concatenate([start, np.empty((1, 2))])
    grid = candidates._sort_points(TORUS, points, 400, 401)
    cells = candidates._find_far(TORUS, grid, 400, 800)
    won = []
    for seed in range(1500):
        live, places = cells[2].copy(), cells[3].copy()
        heads, after = grid[1].copy(), grid[2].copy()
        _, placed, _, hits = add_farthest(
            make_key(seed),
            0,
            2,
            400,
            401,
            0,
            *cells[:2],
            live,
            places,
            *cells[4:],
            points,
            heads,
            after,
            *grid[3:],
        )
        assert placed == 401
        assert hits < 300
        won.append(points[400].copy())
    tree, rng = cKDTree(start, boxsize=1), np.random.default_rng(0)
    best = [tree.query(rng.random((800, 2)))[0].max() for _ in range(1500)]
    far = tree.query(won)[0]
    for share in (0.1, 0.5, 0.9):
        assert np.quantile(far, share) == pytest.approx(np.quantile(best, share), rel=0.01)


def test_no_place_that_counts_is_lost():
    """After 30 more points the cells in the running still hold all places far enough from all points."""
    from tilewright.kernels.candidates import add_farthest
    from tilewright.samplers import candidates

    points = np.concatenate([sample_points("best-candidate", 400).points, np.empty((30, 2))])
    grid = candidates._sort_points(TORUS, points, 400, 430)
    threshold, spread, live, places, living, sizes, around = candidates._find_far(TORUS, grid, 400, 1000)
    cells = threshold, spread, live, places, living, sizes, around
    *_, living, _ = add_farthest(make_key(1), 0, 2, 400, 430, 0, *cells, *grid)
    assert living < len(live)
    assert np.array_equal(np.sort(np.flatnonzero(places >= 0)), np.sort(live[:living]))
    seen = np.random.default_rng(2).random((200_000, 2))
    far = cKDTree(points, boxsize=1).query(seen)[0] > threshold
    assert far.any()
    column, row = (seen[far] * sizes).astype(int).T
    assert (places[column * sizes[1] + row] >= 0).all()


def test_the_best_candidate_is_found_where_no_cell_counts(monkeypatch):
    """With next to no cells in the running, all candidates are drawn instead."""
    from tilewright.samplers import candidates

    monkeypatch.setattr(candidates, "_MANY", 1)
    monkeypatch.setattr(candidates, "_FEW", 1)
    made = samplers.best_candidate(600)
    assert len(made) == 600
    assert made.rho > 0.6


def voronoi(points: np.ndarray, box: Box) -> tuple[np.ndarray, np.ndarray]:
    """Areas and centroids of Voronoi cells, by SciPy from images or, for walls, mirror images."""
    w, h = box.extent
    if box.torus:
        laps = np.array([lap for lap in product((-2, -1, 0, 1, 2), repeat=2) if any(lap)])
        others = [points + lap * (w, h) for lap in laps]
    else:
        across, down = points * (-1, 1), points * (1, -1)
        others = [across, across + np.array([2 * w, 0]), down, down + np.array([0, 2 * h])]
    diagram = Voronoi(np.concatenate([points, *others]))
    areas, centers = [], []
    for i, p in enumerate(points):
        corners = diagram.vertices[diagram.regions[diagram.point_region[i]]] - p
        x, y = corners[np.argsort(np.arctan2(*(corners - corners.mean(axis=0)).T))].T
        cross = np.roll(x, -1) * y - x * np.roll(y, -1)
        areas.append(cross.sum() / 2)
        centers.append([(a + np.roll(a, -1)) @ cross / 6 / areas[-1] for a in (x, y)])
    return np.array(areas), np.array(centers)


@pytest.mark.parametrize("box", [TORUS, PLAIN, LONG, LOW], ids=["torus", "plain", "long", "low"])
def test_voronoi_cells_equal_those_of_scipy(box):
    rng = np.random.default_rng(2)
    sets = [rng.random((n, 2)) * box.extent for n in (6, 40, 300)]
    sets.append(rng.normal(0.5, 0.02, (200, 2)).clip(0.01, 0.99) * box.extent)  # crowded in few cells
    for points in sets:
        moved, areas, nearest = centroids(points, box)
        expected, centers = voronoi(points, box)
        step = moved - points
        if box.torus:
            step -= np.round(step / box.extent) * box.extent
        assert np.allclose(areas, expected, rtol=1e-9, atol=1e-15)
        assert np.allclose(step, centers, rtol=0, atol=1e-9)
        assert np.allclose(nearest, nearest_distances(points, box), rtol=1e-12)


@pytest.mark.parametrize("box", [TORUS, PLAIN, LONG, Box((400.0, 0.01)), Box((400.0, 0.01), torus=False)])
def test_voronoi_cells_of_few_points_fill_the_box(box):
    for n in (1, 2, 3, 4):
        points = np.random.default_rng(n).random((n, 2)) * box.extent
        _, areas, nearest = centroids(points, box)
        assert areas.sum() == pytest.approx(box.volume, rel=1e-12)
        assert np.allclose(nearest, nearest_distances(points, box))


def free_share(points: np.ndarray, box: Box, near: float, far: float = np.inf) -> float:
    """Share of a box between two distances from the nearest point, counted on a grid."""
    steps = 600
    cells = (np.indices((steps, steps)).reshape(2, -1).T + 0.5) / steps * box.extent
    distances = cKDTree(points, boxsize=box.extent if box.torus else None).query(cells)[0]
    return float(np.mean((distances > near) & (distances < far)))


@pytest.mark.parametrize("box", [TORUS, PLAIN, LONG], ids=["torus", "plain", "long"])
@pytest.mark.parametrize("placed", [1, 2, 3, 10, 40])
def test_jones_knows_the_free_area(box, placed):
    from tilewright.kernels.gaps import fill_gaps

    distance, most, extent = 2 * 0.7 * max_radius(60, box), 60, np.array(box.extent)
    points, rows, tree = np.empty((most, 2)), np.empty((8, 3)), np.zeros(128)
    starts, corners, room = np.zeros((3, most), np.int64)
    key = make_key(3)
    got, *_ = fill_gaps(
        key, 0, 0, placed, distance, extent, box.torus, points, rows, 0, starts, corners, room, tree
    )
    assert got == placed
    assert tree[1] / box.volume == pytest.approx(free_share(points[:placed], box, distance), abs=2e-3)


def test_jones_draws_evenly_from_a_gap():
    """One point, a cell of the whole torus: the next one is anywhere outside the disk."""
    from tilewright.kernels.gaps import fill_gaps

    seen = np.empty((4000, 2))
    for seed in range(len(seen)):
        points, rows, tree = np.empty((2, 2)), np.empty((16, 3)), np.zeros(4)
        starts, corners, room = np.zeros((3, 2), np.int64)
        fill_gaps(
            make_key(seed), 0, 0, 2, 0.15, np.ones(2), True, points, rows, 0, starts, corners, room, tree
        )
        seen[seed] = (points[1] - points[0] + 0.5) % 1
    rng = np.random.default_rng(0).random((400_000, 2))
    even = rng[np.linalg.norm(rng - 0.5, axis=1) > 0.15]
    bins = [np.linspace(0, 1, 9)] * 2
    expected = np.histogram2d(*even.T, bins)[0] * len(seen) / len(even)
    counts = np.histogram2d(*seen.T, bins)[0]
    assert (counts[expected < 0.01] == 0).all()
    open_bins = expected > 5
    chi = ((counts - expected)[open_bins] ** 2 / expected[open_bins]).sum()
    assert chi < open_bins.sum() + 4 * np.sqrt(2 * open_bins.sum())


def ring_share(disks: list[tuple[float, float, float]], point=(50.0, 50.0)) -> float:
    """Area of the ring from 1 to 2 around a point outside disks and inside a box, counted on a grid."""
    steps = 800
    places = (np.indices((steps, steps)).reshape(2, -1).T + 0.5) / steps * 4 - 2
    free = (np.linalg.norm(places, axis=1) > 1) & (np.linalg.norm(places, axis=1) < 2)
    free &= ((places + np.array(point) > 0) & (places + np.array(point) < 100)).all(axis=1)
    for x, y, r in disks:
        free &= np.linalg.norm(places - (x, y), axis=1) > r
    return float(free.mean() * 16)


def sectors_of(disks, point=(50.0, 50.0), torus=True):
    from tilewright.kernels import sectors as kernels

    rows, spare = np.empty((32, kernels.FIELDS)), np.empty((32, kernels.FIELDS))
    count = kernels.start_ring(np.array(point), np.array([100.0, 100.0]), 1.0, torus, rows)
    for x, y, r in disks:
        count, rows, spare = kernels.subtract_from_all(rows, count, float(x), float(y), r, spare)
    return rows[:count]


def test_scalloped_sectors_are_the_ring_without_the_disks():
    rng = np.random.default_rng(4)
    touching = [(0, -1, 2.0), (0, 1, 1.0), (0, -2, 2.0), (0, 2, 1.0), (1, 0, 1.0), (-2, 0, 1.0)]
    for disks in (
        [], touching, [(1.5, 0, 1.0)], [(3, 0, 1.0)], [(0.5, 0, 2.0)], [(2.2, 1, 2.0), (1.2, -1, 1.0)],
        *([(*rng.uniform(-2.5, 2.5, 2), rng.choice([1.0, 2.0])) for _ in range(4)] for _ in range(12)),
    ):  # fmt: skip
        assert sectors_of(disks)[:, 10].sum() == pytest.approx(ring_share(disks), abs=0.02)


def test_scalloped_sectors_end_at_walls():
    for x, y in ((50, 0.3), (0.0, 50), (99.2, 99.9), (1.5, 0.4), (0.0, 0.0), (98.5, 50)):
        for disks in ([], [(1.2, 0.6, 1.0), (-0.9, -0.8, 1.0)]):
            area = sectors_of(disks, (x, y), torus=False)[:, 10].sum()
            assert area == pytest.approx(ring_share(disks, (x, y)), abs=0.02)


def test_draws_from_scalloped_sectors_are_even():
    from tilewright.kernels.sectors import draw_from_sectors

    disks = [(1.3, 0.2, 1.0), (-0.8, 1.1, 1.0), (-0.5, -1.9, 2.0)]
    rows = sectors_of(disks)
    rng = np.random.default_rng(5)
    whole = rows[:, 10].sum()
    chances = rng.random((8000, 2))
    drawn = np.array([draw_from_sectors(rows, len(rows), a * whole, b) for a, b in chances])
    assert (np.linalg.norm(drawn, axis=1) >= ALMOST).all()
    assert (np.linalg.norm(drawn, axis=1) <= 2 / ALMOST).all()
    places = rng.uniform(-2, 2, (400_000, 2))
    free = (np.linalg.norm(places, axis=1) > 1) & (np.linalg.norm(places, axis=1) < 2)
    for x, y, r in disks:
        assert (np.linalg.norm(drawn - (x, y), axis=1) >= r * ALMOST).all()
        free &= np.linalg.norm(places - (x, y), axis=1) > r
    bins = [np.linspace(-2, 2, 9)] * 2
    expected = np.histogram2d(*places[free].T, bins)[0] * len(drawn) / free.sum()
    counts = np.histogram2d(*drawn.T, bins)[0]
    many = expected > 5
    assert ((counts - expected)[many] ** 2 / expected[many]).sum() < many.sum() + 4 * np.sqrt(2 * many.sum())


@pytest.mark.parametrize("box", [TORUS, PLAIN, LONG], ids=["torus", "plain", "long"])
@pytest.mark.parametrize("placed", [1, 2, 5, 40])
def test_rings_of_scalloped_sectors_do_not_overlap(box, placed):
    """Their area is that of all places between one and two distances from the nearest point."""
    from tilewright.kernels.scallops import grow_by_area
    from tilewright.samplers.grid import Grid

    distance, extent = 2 * 0.7 * max_radius(60, box), np.array(box.extent)
    grid = Grid.of(box, 60, distance, reach=4 * distance, images=True)
    points, rows, tree = np.empty((60, 2)), np.empty((8, 11)), np.zeros(128)
    starts, sizes, room = np.zeros((3, 60), np.int64)
    got, *_ = grow_by_area(
        make_key(1), 0, placed, distance, points, grid.heads, grid.after, grid.counts, extent, box.torus,
        grid.offsets, rows, 0, starts, sizes, room, tree,
    )  # fmt: skip
    assert got == placed
    share = free_share(points[:placed], box, distance, 2 * distance)
    assert tree[1] * distance**2 / box.volume == pytest.approx(share, abs=4e-3)


def test_disks_of_the_boundary_sampler_touch():
    for box in (TORUS, PLAIN):
        made = sample_points("scallop-boundary", 500, box=box)
        assert np.allclose(nearest_distances(made.points, box), made.distance, rtol=1e-9)


def test_a_tree_of_weights_finds_leaves_by_weight():
    from tilewright.kernels.weights import choose_leaf, set_weight

    rng = np.random.default_rng(6)
    weights, tree = np.zeros(8), np.zeros(16)
    for _ in range(200):
        i, weight = rng.integers(8), rng.choice([0.0, rng.random()])
        weights[i] = weight
        set_weight(tree, i, weight)
        assert tree[1] == pytest.approx(weights.sum())
        if weights.any():
            amount = rng.random() * tree[1]
            leaf, left = choose_leaf(tree, amount)
            expected = int(np.searchsorted(np.cumsum(weights), amount, side="right"))
            assert leaf == expected
            assert left == pytest.approx(amount - weights[:expected].sum(), abs=1e-12)
    assert choose_leaf(tree, 2 * tree[1])[1] <= weights.max()


@pytest.mark.parametrize("box", [TORUS, LOW, CUBE])
def test_elimination_equals_its_twin(box):
    start = samplers.uniform(150, seed=9, box=box).points
    reach = 2 * max_radius(40, box)
    pairs = np.array([[apart(p, q, box) for q in start] for p in start])
    near = np.maximum(pairs, reach * 0.65 * (1 - (40 / 150) ** 1.5)) / reach
    weights = np.where(pairs < reach, (1 - near) ** 8, 0.0)
    np.fill_diagonal(weights, 0)
    kept = list(range(150))
    while len(kept) > 40:
        kept.pop(int(np.argmax(weights[np.ix_(kept, kept)].sum(axis=1))))
    made = samplers.sample_elimination(40, start=start, box=box)
    assert np.array_equal(made.points, start[kept])


def test_owen_scrambling_equals_its_twin():
    from tilewright.kernels.chance import draw_word
    from tilewright.kernels.scatter import scramble_words

    words = np.random.default_rng(10).integers(0, 2**32, (20, 2), np.uint32)
    words[0] = words[1] ^ 1  # same but for the last bit
    expected = words.copy()
    for i, a in np.ndindex(words.shape):
        bits = f"{words[i, a]:032b}"
        flipped = ""
        for b in range(32):
            node = ((32 * a + b) << 32) | (int(bits[:b], 2) if b else 0)
            flipped += str(int(bits[b]) ^ (int(draw_word(make_key(11), np.uint64(node))) & 1))
        expected[i, a] = int(flipped, 2)
    scramble_words(make_key(11), words)
    assert np.array_equal(words, expected)


# What is special about each


def test_relaxation_reaches_the_radii_of_the_thesis():
    """Section 6.4: 0.57 and 0.68; for (0.999, 10,000) 0.73, 5 s, not run here."""
    for factor, failures, rho in ((0.9, 100, 0.57), (0.99, 1000, 0.68)):
        made = samplers.relaxation_darts(16384, factor=factor, failures=failures)
        assert made.rho == pytest.approx(rho, abs=0.025)
        assert made.rho * 2 * made.max_radius >= made.distance * ALMOST


@pytest.mark.parametrize("name", ["relaxation", "best-candidate"])
def test_beginnings_of_hierarchical_sets_are_well_spread(name):
    made = sample_points(name, 2000)
    for n in (20, 100, 500, 1500):
        assert PointSet(made.points[:n], made.box).rho > 0.5


def test_progressive_elimination_begins_with_well_spread_points():
    plain, ordered = (samplers.sample_elimination(1000, progressive=p) for p in (False, True))
    assert sorted(map(tuple, plain.points)) == sorted(map(tuple, ordered.points))
    for n in (31, 125, 500):
        spread = PointSet(ordered.points[:n], ordered.box).rho
        assert spread > 0.5
        assert spread > PointSet(plain.points[:n], plain.box).rho + 0.1


def test_elimination_is_as_good_as_published_code():
    """cySampleElim comes to 0.69 from five times as many points."""
    assert samplers.sample_elimination(5000).rho == pytest.approx(0.69, abs=0.03)
    assert samplers.sample_elimination(1000, oversampling=1).rho < 0.1


def test_lloyd_evens_out():
    start = sample_points("dart", 1024, 0.7)
    made = samplers.lloyd_relaxation(start=start, iterations=32)
    reached = made.figures["rho"]
    assert reached[0] == pytest.approx(start.rho)
    assert reached[-1] == pytest.approx(made.rho)
    assert reached[16] > 0.72
    assert 0.75 < reached[32] < 0.85
    assert made.figures["iterations"] == 32
    # Each move lowers the mean squared distance of places to their nearest point.
    places = np.random.default_rng(0).random((50_000, 2))
    stages = [samplers.lloyd_relaxation(start=start, iterations=k).points for k in (0, 1, 4, 16)]
    energies = [np.mean(cKDTree(points, boxsize=1).query(places)[0] ** 2) for points in stages]
    assert all(after < before for before, after in pairwise(energies))


def test_lloyd_stops_at_rho_or_says_how_far_it_came():
    made = samplers.lloyd_relaxation(500, 0.75, seed=2)
    assert made.rho >= 0.75
    assert made.figures["rho"][-2] < 0.75
    with pytest.raises(TilewrightValueError, match=r"rho is 0.99; 4 iterations came to 0\.[67]"):
        samplers.lloyd_relaxation(500, 0.99, iterations=4)


def test_lloyd_begins_where_it_is_told():
    start = np.random.default_rng(1).random((50, 2)) * 3
    box = Box((3.0, 3.0), torus=False)
    assert np.array_equal(samplers.lloyd_relaxation(start=start, iterations=0, box=box).points, start)
    one = samplers.lloyd_relaxation(start=PointSet(start[:1], box), iterations=1)
    assert one.points[0] == pytest.approx([1.5, 1.5])
    for bad, said in (
        ({"start": [[0.5, 0.5], [0.2, 0.2], [0.5, 0.5]]}, "points 0 and 2 of start are at the same place"),
        ({"start": [[1.5, 0.5]]}, "point 0 is .* outside the domain"),
        ({"start": np.empty((0, 2))}, "start has no points"),
        ({"start": start / 3, "count": 7}, "count is 7 but start has 50 points"),
        ({"start": start / 3, "iterations": -1}, "iterations is -1"),
    ):
        with pytest.raises(TilewrightValueError, match=said):
            samplers.lloyd_relaxation(**bad)


@pytest.mark.parametrize("box", BOXES.values(), ids=BOXES)
def test_jittered_points_have_a_part_of_equal_volume_each(box):
    from tilewright.samplers.yardsticks import _strata

    for count in (1, 2, 7, 100, 1001):
        low, size = _strata(count, box.extent)
        assert size.prod(axis=1) == pytest.approx(np.full(count, box.volume / count))
        made = sample_points("jittered", count, box=box).points
        assert ((made >= low - 1e-12) & (made <= low + size + 1e-12)).all()
        middles = low + size / 2
        inside = (np.abs(middles[:, None] - middles) < (size[:, None] + size) / 2 * (1 - 1e-9)).all(axis=2)
        assert inside.sum() == count  # no two parts overlap


def test_sobol_points_are_in_every_binary_division():
    for seed in (0, 1):
        made = sample_points("sobol", 256, seed=seed).points
        for power in range(9):
            cells = np.floor(made * (2**power, 2 ** (8 - power))).astype(int)
            assert len(np.unique(cells, axis=0)) == 256


def test_lattices_are_regular():
    for count in (1, 50, 1000, 16384):
        hexagons = sample_points("hexagonal", count, seed=1)
        assert least_distance(hexagons.points[:800], TORUS) >= hexagons.distance * ALMOST
        if count >= 50:
            assert len(hexagons) == pytest.approx(count, rel=0.12)
            assert hexagons.rho > 0.93
        squares = sample_points("regular", count, seed=1)
        assert len(squares) == pytest.approx(count, rel=0.12)
    assert len(sample_points("regular", 1024, box=Box((2.0, 2.0)))) == 1024
    assert len(sample_points("regular", 100, box=Box((1e6, 1e-6)))) == 100


# Bad input


@pytest.mark.parametrize("name", METHODS)
@pytest.mark.parametrize(
    ("bad", "error", "said"),
    [
        ({"count": 0}, TilewrightValueError, "count is 0; allowed are 1 to"),
        ({"count": -3}, TilewrightValueError, "count is -3; allowed are 1 to"),
        ({"count": 2**40}, TilewrightValueError, "count is 1099511627776; .*tiles give larger sets"),
        ({"count": 2.5}, TilewrightTypeError, "count must be an integer"),
        ({"count": float("nan")}, TilewrightTypeError, "count must be an integer"),
        ({"count": "9"}, TilewrightTypeError, "count must be an integer"),
        ({"seed": -1}, TilewrightValueError, "seed is -1"),
        ({"seed": 0.5}, TilewrightTypeError, "seed must be an integer"),
        ({"box": (1, 1)}, TilewrightTypeError, "box must be a Box, not"),
        ({"speed": 3}, TilewrightTypeError, "does not take speed"),
    ],
)
def test_bad_input_is_refused_in_one_line(name, bad, error, said):
    with pytest.raises(error, match=said) as caught:
        sample_points(name, **{"count": 5, **bad})
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize("name", METHODS)
@pytest.mark.parametrize("rho", [-0.1, 1.1, float("nan"), float("inf"), "thick"])
def test_bad_radii_are_refused(name, rho):
    with pytest.raises(TilewrightError, match=r"rho (is|must be)|does not take rho"):
        sample_points(name, 5, rho)


@pytest.mark.parametrize("name", ["dart", "jones", "maximal"])
def test_radii_out_of_reach_are_refused_with_what_is_in_reach(name):
    with pytest.raises(TilewrightValueError, match=r"rho is 0\.95; there was room for") as caught:
        sample_points(name, 300, 0.95)
    reached = float(re.search(r"about (0\.\d+) can be reached", str(caught.value))[1])
    assert 0.7 < reached < 0.8
    assert len(sample_points(name, 300, reached - 0.03)) == 300


@pytest.mark.parametrize("name", ["dart", "jones", "maximal", "bridson", "scallop-log"])
def test_a_torus_too_narrow_for_the_radius_is_refused(name):
    with pytest.raises(TilewrightValueError, match=r"rho is 0\.7; .* own images, so 0\.09 can be reached"):
        sample_points(name, 1, 0.7, box=Box((100.0, 1.0)))
    assert len(sample_points(name, 1, 0.09, box=Box((100.0, 1.0)))) >= 1


def test_sets_beyond_memory_are_refused_before_they_are_made(monkeypatch):
    monkeypatch.setattr(asked, "_physical_memory", lambda: 2.0**20)
    for name in METHODS:
        with pytest.raises(TilewrightValueError, match=r"takes about .* GiB and this machine has .* tiles"):
            sample_points(name, 200_000)
    with pytest.raises(TilewrightValueError, match=r"points .* apart may be up to .* takes about"):
        sample_points("bridson", 100, 0.01)


def test_a_little_rho_is_cheap_and_much_too_little_is_refused():
    for name in ("dart", "jones", "maximal"):
        assert len(sample_points(name, 1000, 1e-6)) == 1000
        with pytest.raises(TilewrightTypeError, match="must be a number"):
            sample_points(name, 1000, True)
    for name in FILLING:
        with pytest.raises(TilewrightValueError, match=r"rho is 0\.0; allowed are 1e-06 to 1"):
            sample_points(name, 1000, 0.0)
    assert len(sample_points("dart", 1000, 0.0)) == 1000


def test_settings_are_checked():
    for function, setting, said in (
        (samplers.relaxation_darts, {"factor": 1.0}, "factor is 1.0"),
        (samplers.relaxation_darts, {"failures": 0}, "failures is 0"),
        (samplers.relaxation_darts, {"radius": -1.0}, "radius is -1.0"),
        (samplers.best_candidate, {"multiple": 0}, "multiple is 0"),
        (samplers.bridson_darts, {"tries": 0}, "tries is 0"),
        (samplers.sample_elimination, {"oversampling": 0.5}, "oversampling is 0.5"),
        (samplers.sample_elimination, {"start": [[0.1, 0.1]]}, "count is 9 but start has 1 points"),
    ):
        with pytest.raises(TilewrightValueError, match=said):
            function(9, **setting)
    for name in ("lloyd", "jones", "scallop-log", "hexagonal"):
        with pytest.raises(TilewrightValueError, match="box has 3 dimensions"):
            sample_points(name, 9, box=CUBE)
    with pytest.raises(TilewrightValueError, match="method is 'darts'; allowed are dart"):
        sample_points("darts", 9)


@pytest.mark.parametrize("extent", [(0, 1), (1, float("nan")), (1, float("inf")), (-1, 1)])
def test_boxes_without_a_size_are_refused(extent):
    with pytest.raises(TilewrightValueError, match=r"(width|height) is"):
        Box(extent)


def test_the_radius_of_a_few_points_is_that_to_their_images():
    assert nearest_distances([[0.2, 0.3]], Box((3.0, 2.0))) == pytest.approx([2.0])
    assert nearest_distances([[0.2, 0.3]], PLAIN) == pytest.approx([np.inf])
    assert nearest_distances([[0.0, 0.0], [2.5, 0.0]], Box((5.0, 0.5))) == pytest.approx([0.5, 0.5])
    with pytest.raises(TilewrightValueError, match="point 1 is"):
        nearest_distances([[0.0, 0.0], [1.0, 0.0]], TORUS)
