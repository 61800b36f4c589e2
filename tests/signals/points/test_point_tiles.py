"""Poisson disk tiles: the promise over every neighborhood, exact counts, spikes, ranks."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import tilewright as tw
from cores import cores
from tilewright.errors import TilewrightValueError
from tilewright.signals.points.anatomy import OFFSETS, anatomy_of
from tilewright.signals.points.plan import Parts, Plan, fill_interiors
from tilewright.signals.points.spikes import mean_spectrum
from tilewright.tiles import WANG, ListedTileSet

R_MAX_OF_ONE = (2 * 3**0.5) ** -0.5


def torus_of(tiles, side, seed=0):
    return tw.PointField(tiles, tw.direct(tiles.tiles, seed, period=(side, side))).torus()


def least_distance(points, side):
    return cKDTree(points, boxsize=side).query(points, k=2)[0][:, 1].min()


@pytest.fixture(scope="module")
def relaxed():
    return tw.poisson_tiles(tw.corner_tiles(3), 32, 0.75, method="relaxed", seed=3)


@pytest.fixture(scope="module")
def balanced():
    return tw.poisson_tiles(tw.corner_tiles(2), 32, 0.7, seed=3)


CASES = {
    "two colors": (lambda: tw.corner_tiles(2), 16, 0.8, {}),
    "five colors": (lambda: tw.corner_tiles(5), 24, 0.7, {}),
    "seven colors": (lambda: tw.corner_tiles(7), 16, 0.75, {}),
    "compact set": (lambda: tw.corner_tiles(3, 2), 32, 0.75, {}),
    "many points": (lambda: tw.corner_tiles(2), 256, 0.75, {}),
    "high rho": (lambda: tw.corner_tiles(4), 32, 0.85, {}),
    "low rho": (lambda: tw.corner_tiles(2), 32, 0.3, {}),
    "template": (lambda: tw.corner_tiles(1), 48, 0.75, {"variants": 32}),
    "variants": (lambda: tw.corner_tiles(2), 32, 0.75, {"variants": 3}),
}


@pytest.mark.parametrize("case", CASES)
def test_every_tiling_keeps_the_distance_and_every_tile_its_number(case):
    make, points, rho, settings = CASES[case]
    tiles = tw.poisson_tiles(make(), points, rho, method="relaxed", seed=5, **settings)
    distance = 2 * rho * R_MAX_OF_ONE / points**0.5
    assert tiles.distance == pytest.approx(distance)
    assert (tiles.counts == points).all()
    assert tiles.figures["rho"] >= rho
    side = 12
    assert least_distance(torus_of(tiles, side).points, side) >= distance


def test_edges_keep_the_distance_too(crossed_points):
    assert (crossed_points.counts == 16).all()
    side = 24
    assert least_distance(torus_of(crossed_points, side).points, side) >= crossed_points.distance


@pytest.mark.parametrize("colors", [2, 3])
def test_balanced_sets_keep_the_promise_too(colors):
    tiles = tw.poisson_tiles(tw.corner_tiles(colors), 32, 0.75, seed=1)
    assert (tiles.counts == 32).all()
    assert tw.find_closeness(tiles).rho >= 0.75
    assert least_distance(torus_of(tiles, 40).points, 40) >= tiles.distance


def test_balancing_lowers_the_spikes_within_twice_the_window(balanced):
    plain = tw.poisson_tiles(balanced.tiles, 32, 0.7, method="relaxed", seed=3)
    spikes = tw.find_spikes(balanced)
    assert spikes.doubled < 3 * spikes.floor
    assert tw.find_spikes(plain).doubled > 4 * spikes.doubled


def test_spikes_are_those_of_a_tiling(balanced):
    """T |m(k)|^2 / N against the mean of periodograms at the tile lattice's frequencies."""
    side, sets = 24, 6
    tilings = [torus_of(balanced, side, seed) for seed in range(sets)]
    spikes = tw.find_spikes(balanced)
    spectrum = tw.power_spectrum(tilings, 1024)
    measured = tw.lattice_spikes(spectrum, side).on
    assert measured == pytest.approx(side**2 * spikes.window, rel=0.3)


def test_mean_spectrum_is_the_exact_sum():
    rng = np.random.default_rng(1)
    points, weights = rng.random((40, 2)), rng.random(40)
    found = mean_spectrum(points, weights, 5)
    k = np.arange(-5, 6)
    phases = k[:, None, None] * points[:, 0] + k[:, None] * points[:, 1]
    exact = (weights * np.exp(-2j * np.pi * phases)).sum(axis=-1)
    exact[5, 5] = 0
    np.testing.assert_allclose(found, exact, atol=1e-3)


def test_the_same_seed_gives_the_same_bytes_on_any_number_of_threads(balanced):
    with cores(3):
        again = tw.poisson_tiles(balanced.tiles, 32, 0.7, seed=3)
    assert again.points.tobytes() == balanced.points.tobytes()
    assert again.ranks.tobytes() == balanced.ranks.tobytes()
    other = tw.poisson_tiles(balanced.tiles, 32, 0.7, method="relaxed", seed=4)
    assert not np.array_equal(other.points, balanced.points)


def closest_pairs_by_hand(tiles):
    """The least distance over all pairs of tiles that fit, found by laying every 2 x 2 block there is."""
    shape, slots = tiles.tiles.shape, tiles.tiles.slots
    n = len(slots)
    beside = np.array(
        [[all(slots[a, f] == slots[b, g] for f, g in shape.joints[0]) for b in range(n)] for a in range(n)]
    )
    below = np.array(
        [[all(slots[a, f] == slots[b, g] for f, g in shape.joints[1]) for b in range(n)] for a in range(n)]
    )
    least = np.inf
    for nw in range(n):
        for ne in np.flatnonzero(beside[nw]):
            for sw in np.flatnonzero(below[nw]):
                for se in np.flatnonzero(beside[sw] & below[ne]):
                    cells = ((nw, 0, 0), (ne, 1, 0), (sw, 0, 1), (se, 1, 1))
                    points = np.concatenate(
                        [tiles.tile(t).astype(float) + np.array((x, y)) for t, x, y in cells]
                    )
                    least = min(least, cKDTree(points).query(points, k=2)[0][:, 1].min())
    return least


@pytest.mark.parametrize("shape", ["corner", "wang"])
def test_closeness_is_what_laying_every_block_finds(shape):
    rng = np.random.default_rng(2)
    base = tw.corner_tiles(2, 2) if shape == "corner" else tw.cohen_tiles(8)
    rows = [rng.random((3, 2)) for _ in range(len(base))]
    tiles = tw.PointTiles.of(base, rows)
    found = tw.find_closeness(tiles)
    assert found.distance == pytest.approx(closest_pairs_by_hand(tiles), rel=1e-6)


def test_closeness_knows_which_tiles_cannot_meet():
    """Two tiles that never share a corner may come as close as they like across it."""
    slots = [[0, 0, 0, 0], [1, 1, 1, 1]]
    tiles = ListedTileSet(WANG, slots)
    close = 1e-3
    rows = [np.array([[1 - close, 1 - close]]), np.array([[close, close]])]
    found = tw.find_closeness(tw.PointTiles.of(tiles, rows))
    assert found.across_corners > 0.9


def test_strips_around_a_corner_are_2r_apart():
    """The proof in `Regions`, on a fine grid: parts that do not touch are at least 2r apart."""
    r = 0.08
    for shape in ("cusp", "octagon"):
        kinds, xy = parts_on_grid(r, shape)
        east = xy[(kinds == 1) & (xy[:, 0] > 0)]
        south = xy[(kinds == 2) & (xy[:, 1] > 0)]
        west = xy[(kinds == 1) & (xy[:, 0] < 0)]
        inside = xy[(kinds == 3) & (xy[:, 0] > 0) & (xy[:, 1] > 0)]
        for a, b in ((east, south), (east, west), (west, inside)):
            assert cKDTree(a).query(b)[0].min() >= 2 * r
        share = 8 * 2**0.5 + (8 if shape == "octagon" else 0)
        assert (kinds == 0).mean() * 0.64 == pytest.approx(share * r**2, rel=0.02)


def parts_on_grid(r, shape):
    """Kinds of the parts on a grid around a lattice point, by the rules as they are written down."""
    axis = np.linspace(-0.4, 0.4, 301)
    xy = np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2)
    x, y = np.abs(xy).T
    s = 2**0.5 * r
    if shape == "cusp":
        corner = ((y <= r) & (x <= s + y)) | ((x <= r) & (y <= s + x))
    else:
        a = r * (1 + 2**0.5)
        corner = (x <= a) & (y <= a) & (x + y <= a + r)
    kinds = np.where(corner, 0, np.where(y <= r, 1, np.where(x <= r, 2, 3)))
    return kinds, xy


@pytest.mark.parametrize("shape", ["cusp", "octagon"])
def test_kernels_tell_parts_as_the_rules_say(shape):
    from tilewright.kernels.growth import kind_at

    kinds, xy = parts_on_grid(0.08, shape)
    found = [kind_at(x, y, 0.08, shape == "cusp") for x, y in xy[::7]]
    assert (np.array(found) == kinds[::7]).all()


@pytest.mark.parametrize("make", [lambda: tw.corner_tiles(2), lambda: tw.crossed_wang_tiles(2)])
def test_neighboring_tiles_share_the_frame_between_them(make):
    """Items of a tile and of the tile east of it agree on the edge and the corners they share."""
    tiles = make()
    anatomy = anatomy_of(tiles)
    rng = np.random.default_rng(1)
    for a in rng.integers(0, len(tiles), 40):
        east = tiles.fitting(
            **{tiles.shape.slots[near]: int(tiles.slots[a, far]) for far, near in tiles.shape.joints[0]}
        )
        ours, theirs = anatomy.items[a], anatomy.items[east]
        assert (theirs[:, [3, 2, 7]] == ours[[0, 1, 6]]).all()
        south = tiles.fitting(
            **{tiles.shape.slots[near]: int(tiles.slots[a, far]) for far, near in tiles.shape.joints[1]}
        )
        assert (anatomy.items[south][:, [3, 0, 4]] == ours[[2, 1, 5]]).all()
    assert OFFSETS.shape == (8, 2)


def test_parts_keep_the_distance_region_by_region():
    """Every frame item against all items that can touch it, in any combination of colors."""
    plan = Plan.of(tw.corner_tiles(3), 32, 0.75, 1, np.uint64(7), "cusp", 0)
    from tilewright.signals.points.frames import grow_frame

    parts = Parts.empty(plan)
    grow_frame(plan, parts, choose=True)
    assert fill_interiors(plan, parts, np.arange(81), 0, 50) == 0
    numbers, places, counts = plan.anatomy.meetings()
    for item in range(len(plan.anatomy.kinds)):
        own = parts.frame[item, : parts.frame_counts[item]]
        for k in range(counts[item]):
            other = parts.frame[numbers[item, k], : parts.frame_counts[numbers[item, k]]] + places[item, k]
            if len(own) and len(other):
                assert cKDTree(own).query(other)[0].min() >= plan.distance
        if len(own) > 1:
            assert cKDTree(own).query(own, k=2)[0][:, 1].min() >= plan.distance


def test_thinning_by_rank_beats_thinning_by_chance(balanced):
    side = 24
    field = tw.PointField(balanced, tw.direct(balanced.tiles, 2, period=(side, side)))
    everything = field.points(0, 0, side, side)
    rng = np.random.default_rng(1)
    for share in (0.75, 0.5, 0.25, 0.1):
        kept = field.points(0, 0, side, side, density=share)
        assert len(kept) == pytest.approx(share * len(everything), rel=0.06)
        by_chance = everything[rng.random(len(everything)) < share]
        spread = [
            cKDTree(p, boxsize=side).query(p, k=2)[0][:, 1].mean() * len(p) ** 0.5 for p in (kept, by_chance)
        ]
        assert spread[0] > 1.06 * spread[1]


def test_ranks_are_shared_by_what_tiles_share(balanced):
    """A frame point has one rank in all tiles that hold it."""
    points, ranks = balanced.points, balanced.ranks
    _, number, times = np.unique(points, axis=0, return_inverse=True, return_counts=True)
    for n in np.flatnonzero(times > 1)[:50]:
        assert len(set(ranks[number.ravel() == n].tolist())) == 1
    for t in range(len(balanced.tiles)):
        own = ranks[balanced.starts[t] : balanced.starts[t + 1]]
        assert (np.diff(own) >= 0).all()


REFUSALS = {
    "rho 0": ({"rho": 0.0}, "rho is 0.0; balanced tiles reach more than 0 and up to 0.85"),
    "rho 1": ({"rho": 1.0}, "up to 0.85"),
    "rho nan": ({"rho": float("nan")}, "rho is nan; allowed are"),
    "no points": ({"points": 0}, "points is 0; allowed are 8 to 256"),
    "too many points": ({"points": 1000}, "allowed are 8 to 256"),
    "too few for the radius": ({"points": 8, "rho": 0.85}, "ask for more points per tile or less rho"),
    "one color": ({"tiles": tw.corner_tiles(1)}, "take more colors, or variants"),
    "wang": ({"tiles": tw.wang_tiles(2)}, "does not say what meets at its corners"),
    "coded": ({"tiles": tw.corner_coded_tiles()}, "do not name the edges that meet there"),
    "method": ({"method": "magic"}, "method is 'magic'; allowed are balanced, relaxed"),
    "variants": ({"variants": 0}, "variants is 0"),
    "seed": ({"seed": -1}, "seed is -1"),
}


@pytest.mark.parametrize("case", REFUSALS)
def test_refusals_say_what_is_allowed(case):
    settings, message = REFUSALS[case]
    with pytest.raises(TilewrightValueError) as refusal:
        tw.poisson_tiles(settings.pop("tiles", tw.corner_tiles(2)), **settings)
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_a_construction_can_be_stopped():
    def stop(done, total, what):
        if "balancing" in what and done > 3:
            raise tw.Cancelled("enough")

    with pytest.raises(tw.Cancelled):
        tw.poisson_tiles(tw.corner_tiles(2), seed=1, progress=stop)


def test_ready_made_sets_are_what_they_promise():
    from tilewright.files.ready import READY

    for colors, points, rho in READY:
        tiles = tw.ready_tiles(colors, points, rho)
        assert len(tiles.tiles) == colors**4
        assert (tiles.counts == points).all()
        found = tw.find_closeness(tiles, tiles.distance * 1.01)
        assert found.rho >= rho
        assert tw.find_spikes(tiles).doubled == pytest.approx(tiles.figures["doubled"], rel=1e-3)
    with pytest.raises(TilewrightValueError, match=r"there are 4, 32, 0\.75"):
        tw.ready_tiles(5, 32, 0.75)
