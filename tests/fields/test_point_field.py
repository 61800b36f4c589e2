"""Point fields: windows agree, identities stay, exact numbers, nearest points, far places."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.spatial import cKDTree

import tilewright as tw
from cores import cores
from tilewright.errors import TilewrightTypeError, TilewrightValueError

SETS = {
    "corner": lambda: tw.ready_tiles(),
    "template": lambda: tw.poisson_tiles(tw.corner_tiles(1), 24, 0.7, method="relaxed", variants=9),
    "uneven": lambda: tw.make_point_tiles("shade", 12),
}
NAMES = [*SETS, "edge"]
_MADE = {}


@pytest.fixture(scope="module", autouse=True)
def _keep_edge(crossed_points):
    _MADE["edge"] = crossed_points


def field_of(name, seed=7, period=None):
    if name not in _MADE:
        _MADE[name] = SETS[name]()
    tiles = _MADE[name]
    return tw.PointField(tiles, tw.direct(tiles.tiles, seed, period=period))


def as_set(points):
    return {tuple(p) for p in points.tolist()}


@pytest.mark.parametrize("name", NAMES)
def test_points_are_those_of_the_tiles(name):
    """Against laying tile after tile by hand."""
    field = field_of(name)
    x, y, width, height = -5, 3, 9, 7
    rows = field.rows_at(x, y, width, height)
    variants = field.tiles.variants.even
    by_hand = [
        field.tiles.tile(*divmod(int(rows[i, j]), variants)).astype(float) + (x + j, y + i)  # noqa: RUF005
        for i in range(height)
        for j in range(width)
    ]
    np.testing.assert_array_equal(field.points(x, y, width, height), np.concatenate(by_hand))


@pytest.mark.parametrize("hash", ["mixer", "permutation"])
def test_variants_are_drawn_as_ever(hash):
    """As when every tile had the same number of variants: stream 6 of the tiling's hash, or of seed 0's."""
    field_of("template")
    tiles = _MADE["template"]
    x, y = np.arange(-3, 9), np.arange(4, 14)[:, np.newaxis]
    direct = tw.direct(tiles.tiles, 11, hash=hash, period=(5, None))
    stored = tw.array_tiling(tiles.tiles, np.zeros((10, 12), int), torus=True)
    for tiling, drawn_by, columns, lines in (
        (direct, direct.hash, x % 5, y),
        (stored, tw.MixerHash(0), x % 12, y % 10),
    ):
        expected = drawn_by.numbers(6, columns, lines) * 9 >> 24
        np.testing.assert_array_equal(tw.PointField(tiles, tiling).rows_at(-3, 4, 12, 10), expected)


@settings(max_examples=40, deadline=None)
@given(
    st.sampled_from(sorted(SETS)),
    st.floats(-30, 30),
    st.floats(-30, 30),
    st.floats(0.05, 12),
    st.floats(0.05, 12),
)
def test_any_window_is_a_part_of_a_larger_one(name, x, y, width, height):
    field = field_of(name)
    window = field.points(x, y, width, height)
    low = np.floor([x, y]) - 1
    large = field.points(*low.tolist(), width + 3, height + 3)
    # In the coordinates that the window itself is cut in: seen from its first cell.
    seen = large - np.floor([x, y])
    left, top = x - np.floor(x), y - np.floor(y)
    inside = (seen >= (left, top)).all(axis=1) & (seen < (left + width, top + height)).all(axis=1)
    assert as_set(window) == as_set(large[inside])
    assert len(window) == field.count(x, y, width, height)


def test_windows_side_by_side_share_no_point_and_miss_none():
    field = field_of("corner")
    parts = [field.points(x, 0.3, 2.5, 5) for x in (0, 2.5, 5, 7.5)]
    whole = field.points(0, 0.3, 10, 5)
    assert as_set(np.concatenate(parts)) == as_set(whole)
    assert sum(map(len, parts)) == len(whole)


@pytest.mark.parametrize("name", NAMES)
def test_identities_are_unique_and_the_same_in_every_window(name):
    field = field_of(name)
    large, small = field.window(-4, -4, 12, 12), field.window(-1.5, 0.25, 3.3, 4.1)
    known = dict(zip(large.ids.tolist(), large.points.tolist(), strict=True))
    assert len(known) == len(large.points)
    assert [known[i] for i in small.ids.tolist()] == small.points.tolist()
    np.testing.assert_array_equal(np.floor(small.points), small.cells)
    assert (small.numbers < field.tiles.counts.max()).all()
    assert ((small.ranks >= 0) & (small.ranks < 1)).all()


def test_ids_that_do_not_fit_are_an_error():
    field = field_of("corner")
    far = field.window(2**40, 0, 2, 2, local=True)
    with pytest.raises(TilewrightValueError, match="use cells and numbers"):
        _ = far.ids


def test_far_windows_are_exact_where_they_are_local():
    field = field_of("corner")
    far = 2**60 + 5
    local = field.points(far, -far, 3, 3, local=True)
    assert cKDTree(local).query(local, k=2)[0][:, 1].min() >= field.tiles.distance
    with pytest.raises(TilewrightValueError, match="local=True"):
        field.points(far, -far, 3, 3)
    with pytest.raises(TilewrightValueError, match="float64"):
        field.points(10**6, 0, 3, 3, out=np.zeros((1000, 2), np.float32))
    np.testing.assert_array_equal(
        field.points(1000.5, 7, 4, 4, local=True), field.points(1000.5, 7, 4, 4) - (1000.5, 7)
    )


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_out_is_filled_from_its_first_row_on(kind):
    field = field_of("corner")
    out = np.full((4000, 2), -1, kind)
    for window in ((0, 0, 10, 10), (0.5, 0, 10, 10)):
        made = field.points(*window, out=out)
        assert made.base is out
        np.testing.assert_allclose(made, field.points(*window), atol=2e-6)
    with pytest.raises(TilewrightValueError, match="at least 3200"):
        field.points(0, 0, 10, 10, out=np.zeros((100, 2), kind))
    with pytest.raises(TilewrightValueError, match="float32 or float64"):
        field.points(0, 0, 10, 10, out=np.zeros((4000, 2), np.int64))
    with pytest.raises(TilewrightTypeError, match="out must be an array"):
        field.points(0, 0, 10, 10, out=[1])


@pytest.mark.parametrize("name", NAMES)
def test_exactly_as_many_as_asked_and_always_those_of_lowest_rank(name):
    field = field_of(name)
    for count in (1, 31, 1000, 12345):
        points = field.sample(count)
        assert len(as_set(points)) == count
        np.testing.assert_array_equal(points, np.concatenate(list(field.sample_blocks(count))))
    window = (0.5, -3.25, 20, 11.5)
    everything, some = field.window(*window), field.sample(2000, *window)
    drawn = as_set(some)
    assert drawn <= as_set(everything.points)
    kept = np.array([p in drawn for p in map(tuple, everything.points.tolist())])
    assert everything.ranks[kept].max() <= everything.ranks[~kept].min()
    with pytest.raises(TilewrightValueError, match="the window holds"):
        field.sample(10**6, 0, 0, 3, 3)


def test_more_points_include_fewer():
    field = field_of("corner")
    fewer, more = (field.sample(n, 0, 0, 20, 20) for n in (5000, 9000))
    assert as_set(fewer) <= as_set(more)


@pytest.mark.parametrize("local", [False, True])
def test_blocks_hold_what_the_window_holds(local, monkeypatch):
    monkeypatch.setattr(tw.PointField, "_block_points", 700)
    field = field_of("corner")

    def share(x, y):
        return np.clip(x / 30, 0, 1)

    for window in ((0, 0, 30, 9), (0.25, -2.5, 31.1, 8.2)):
        for density in (1.0, 0.4, share):
            pieces = list(field.blocks(*window, density=density, local=local))
            whole = field.points(*window, density=density, local=local)
            assert len(pieces) > 5
            assert sum(map(len, pieces)) == len(whole)
            joined = np.concatenate(pieces)
            order = [np.lexsort(p.round(9).T) for p in (joined, whole)]
            np.testing.assert_allclose(joined[order[0]], whole[order[1]], atol=1e-9)


def test_a_density_function_thins_by_rank():
    field = field_of("corner")
    points = field.points(0, 0, 40, 40, density=lambda x, y: x / 40)
    counts = np.histogram(points[:, 0], 8, (0, 40))[0]
    expected = 32 * 40 * 5 * (np.arange(8) + 0.5) / 8
    np.testing.assert_allclose(counts, expected, rtol=0.12)
    assert as_set(points) <= as_set(field.points(0, 0, 40, 40))
    with pytest.raises(TilewrightValueError, match=r"density function is 2\.0"):
        field.points(density=lambda x, y: np.full(len(x), 2.0))
    with pytest.raises(TilewrightValueError, match="expected one"):
        field.points(density=lambda x, y: np.zeros(3))


def test_a_density_function_may_give_one_share_for_all():
    field = field_of("corner")
    assert np.array_equal(field.points(density=lambda x, y: 0.4), field.points(density=0.4))


def test_a_density_is_the_same_function_for_points_and_tilings():
    def density(x, y):
        assert x.shape == y.shape
        return (x > y).astype(float)

    x, y = field_of("corner").points(-5, -5, 10, 10, density=density).T
    assert len(x)
    assert (x > y).all()
    tiles = tw.corner_tiles(2)
    cells = tw.density_tiling(tiles, density).indices(-5, -5, 10, 10)
    rows, columns = np.mgrid[-5:5, -5:5]
    assert np.array_equal(tiles.slots[cells][..., 3], columns > rows)


@pytest.mark.parametrize("density", [lambda p: p, lambda x, y, z: x, lambda: 1])
def test_a_density_of_other_arguments_gets_one_clear_line(density):
    for make in (
        lambda: field_of("corner").points(density=density),
        lambda: tw.density_tiling(tw.corner_tiles(2), density),
        lambda: tw.Conditions({"H0": density}),
        lambda: tw.endless_dappled_tiling({"H0": 3}, start=density),
    ):
        with pytest.raises(TilewrightTypeError, match="must be a function of two arrays, x and y; this one"):
            make()


@pytest.mark.parametrize("name", NAMES)
def test_nearest_points_are_those_of_an_exhaustive_search(name):
    field = field_of(name)
    positions = np.random.default_rng(1).uniform(-20, 20, (500, 2))
    distances, found = field.nearest(positions)
    points = field.points(-24, -24, 48, 48)
    expected, at = cKDTree(points).query(positions)
    np.testing.assert_allclose(distances, expected, atol=1e-12)
    np.testing.assert_allclose(found.points, points[at], atol=1e-12)
    window = field.window(-24, -24, 48, 48)
    assert set(found.ids.tolist()) <= set(window.ids.tolist())


@pytest.mark.parametrize("name", ["corner", "edge", "template"])
def test_a_torus_keeps_the_distance_around_its_sides(name):
    field = field_of(name, period=(9, 7))
    made = field.torus()
    assert made.box == tw.Box((9.0, 7.0))
    assert made.rho >= 0.7
    assert cKDTree(made.points, boxsize=(9, 7)).query(made.points, k=2)[0][:, 1].min() >= made.distance > 0
    again = field.points(9, -7, 9, 7) - (9, -7)
    np.testing.assert_allclose(again, made.points, atol=1e-12)
    with pytest.raises(TilewrightValueError, match="torus"):
        field_of(name).torus()


def test_seeds_and_threads():
    a, b = field_of("corner", 1).points(), field_of("corner", 2).points()
    assert not np.array_equal(a, b)
    for count in (1, 3):
        with cores(count):
            np.testing.assert_array_equal(field_of("corner", 1).points(), a)


REFUSALS = {
    "width 0": ({"width": 0}, "width is 0; a window needs more than 0"),
    "width nan": ({"width": float("nan")}, "width is nan"),
    "x nan": ({"x": float("nan")}, "x is nan"),
    "x too far": ({"x": 2**62}, "x is 4611686018427387904"),
    "too many": ({"width": 1e6, "height": 1e6}, "blocks() gives them a piece at a time"),
    "density 2": ({"density": 2.0}, "density is 2.0"),
}


@pytest.mark.parametrize("case", REFUSALS)
def test_refusals(case):
    settings, message = REFUSALS[case]
    with pytest.raises(TilewrightValueError) as refusal:
        field_of("corner").points(**settings)
    assert message in str(refusal.value)


def test_points_and_tiling_must_be_of_one_set():
    tiles = tw.ready_tiles()
    with pytest.raises(TilewrightValueError, match="must be the same set"):
        tw.PointField(tiles, tw.direct(tw.corner_tiles(2)))
    with pytest.raises(TilewrightTypeError, match="PointTiles and a Tiling"):
        tw.PointField(tiles, None)


@pytest.mark.parametrize(
    ("window", "local"),
    [
        ((2**60, 0, 10.0, 10.0), True),
        ((2**55 + 1, 0, 9.5, 1), True),
        ((2.0**61 - 4096, 0, 9, 9), True),
        ((np.uint8(250), 0, 9, 9), False),
        ((np.int8(120), np.int8(-128), 9, 9), False),
        ((np.float32(0.1), -0.3, 3000.3, 2), False),
    ],
)
def test_blocks_miss_nothing_far_out_and_in_small_numbers(window, local, monkeypatch):
    monkeypatch.setattr(tw.PointField, "_block_points", 500)
    field = field_of("corner")
    pieces = np.concatenate(list(field.blocks(*window, local=local)))
    whole = field.points(*window, local=local)
    assert len(pieces) == len(whole) > 0
    orders = [np.lexsort(p.round(6).T) for p in (pieces, whole)]
    np.testing.assert_allclose(pieces[orders[0]], whole[orders[1]], atol=1e-6)


def test_blocks_and_samples_refuse_places_too_far_out():
    field = field_of("corner")
    with pytest.raises(TilewrightValueError, match="too coarse"):
        next(field.blocks(1e17, 0, 3, 3))
    with pytest.raises(TilewrightValueError, match="too coarse"):
        field.sample(1000, 2**60, 0)
    assert len(np.unique(field.sample(1000, 2**60, 0, local=True), axis=0)) == 1000
    with pytest.raises(TilewrightValueError, match="too coarse"):
        field.points(2**24, 0, 3, 3, out=np.empty((288, 2), np.float32), density=lambda x, y: np.ones(len(x)))


def test_samples_from_places_between_cells():
    field = field_of("corner")
    for x in np.linspace(0.05, 0.95, 12):
        assert len(field.sample(3200, x, x)) == 3200
    with pytest.raises(TilewrightTypeError, match="go together"):
        field.sample(200, width=1)
    with pytest.raises(TilewrightTypeError, match="x must be an integer"):
        next(field.sample_blocks(320, 0.5, 0.5))
    with pytest.raises(TilewrightTypeError, match="count must be an integer"):
        field.side_for("a")


def test_a_density_function_cannot_change_the_points():
    def overwrite(x, y):
        x[:] = 0
        return np.ones(len(x))

    with pytest.raises(TilewrightValueError, match="writes into the arrays"):
        field_of("corner").points(density=overwrite)
    with pytest.raises(TilewrightTypeError, match="expected numbers"):
        field_of("corner").points(density=lambda x, y: np.array(["1"] * len(x)))
