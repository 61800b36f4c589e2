"""The kernels of samplers against slow twins."""

from itertools import product

import numpy as np
import pytest
from scipy.spatial import Voronoi, cKDTree

from boxes import ALMOST, CUBE, LONG, LOW, PLAIN, TORUS
from tilewright import samplers
from tilewright.samplers import Box, max_radius, nearest_distances, sample_points
from tilewright.samplers.lloyd import centroids
from tilewright.seeds import make_key

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
    cells, gaps = candidates._sort_points(TORUS, points, 400, 401)
    far = candidates._find_far(TORUS, cells, gaps, 400, 800)
    won = []
    for seed in range(1500):
        left = far._replace(live=far.live.copy(), places=far.places.copy())
        filled = cells._replace(heads=cells.heads.copy(), after=cells.after.copy())
        _, placed, _, hits = add_farthest(
            make_key(seed), 0, 2, 400, 401, 0, len(far.live), left, filled, gaps
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
    cells, gaps = candidates._sort_points(TORUS, points, 400, 430)
    far = candidates._find_far(TORUS, cells, gaps, 400, 1000)
    live, places, sizes = far.live, far.places, far.sizes
    *_, living, _ = add_farthest(make_key(1), 0, 2, 400, 430, 0, len(live), far, cells, gaps)
    assert living < len(live)
    assert np.array_equal(np.sort(np.flatnonzero(places >= 0)), np.sort(live[:living]))
    seen = np.random.default_rng(2).random((200_000, 2))
    far = cKDTree(points, boxsize=1).query(seen)[0] > far.threshold
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
    from tilewright.kernels.gaps import Diagram, fill_gaps

    distance, most, extent = 2 * 0.7 * max_radius(60, box), 60, np.array(box.extent)
    points, rows, tree = np.empty((most, 2)), np.empty((8, 3)), np.zeros(128)
    diagram = Diagram(points, extent, box.torus, *np.zeros((3, most), np.int64), tree)
    got, *_ = fill_gaps(make_key(3), 0, 0, placed, distance, diagram, rows, 0)
    assert got == placed
    assert tree[1] / box.volume == pytest.approx(free_share(points[:placed], box, distance), abs=2e-3)


def test_jones_draws_evenly_from_a_gap():
    """One point, a cell of the whole torus: the next one is anywhere outside the disk."""
    from tilewright.kernels.gaps import Diagram, fill_gaps

    seen = np.empty((4000, 2))
    for seed in range(len(seen)):
        points, rows, tree = np.empty((2, 2)), np.empty((16, 3)), np.zeros(4)
        diagram = Diagram(points, np.ones(2), True, *np.zeros((3, 2), np.int64), tree)
        fill_gaps(make_key(seed), 0, 0, 2, 0.15, diagram, rows, 0)
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
    from tilewright.kernels.scallops import Regions, grow_by_area
    from tilewright.samplers.grid import Grid

    distance = 2 * 0.7 * max_radius(60, box)
    points, rows, tree = np.empty((60, 2)), np.empty((8, 11)), np.zeros(128)
    cells = Grid.of(box, 60, distance, reach=4 * distance, images=True).over(points)
    regions = Regions(*np.zeros((3, 60), np.int64), tree)
    got, *_ = grow_by_area(make_key(1), 0, placed, distance, cells, rows, 0, regions)
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
