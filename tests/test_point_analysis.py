"""Figures of point sets against theory, exact sums and slow twins."""

import os
from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tilewright.analysis.plates import DOMAIN, PIXELS, zone_plate, zone_plate_reference
from tilewright.analysis.point_report import (
    POINT_MEANING,
    PointReport,
    analyze_points,
    comparison_sheet,
    save_comparison,
)
from tilewright.analysis.spacing import (
    bond_order,
    coverage_radius,
    discrepancy,
    nearest_mean,
    radial_distribution,
)
from tilewright.analysis.spectrum import (
    effective_nyquist,
    lattice_spikes,
    oscillation,
    oscillation_start,
    periodogram,
    power_spectrum,
    spectrum_size,
)
from tilewright.errors import Cancelled, TilewrightError, TilewrightTypeError, TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.darts import dart_throwing
from tilewright.samplers.point_set import PointSet

PLAIN = Box(torus=False)
BOXES = [Box(), Box((2.0, 0.5)), Box((3.0, 1.7), torus=False), Box((46, 46))]


def white(count, seed=0, box=None):
    domain = box or Box()
    return PointSet(np.random.default_rng(seed).random((count, domain.dimension)) * domain.extent, domain)


def square_grid(n, place=0.5, box=None):
    domain = box or Box()
    cells = np.stack(np.meshgrid(np.arange(n), np.arange(n)), axis=-1).reshape(-1, 2)
    return PointSet((cells + place) / n * domain.extent, domain, "square grid")


def hexagons(columns, rows, torus=True):
    """A hexagonal lattice of nearest distance 1; ``rows`` must be even."""
    height = sqrt(3) / 2
    points = [((i + j % 2 / 2), j * height) for j in range(rows) for i in range(columns)]
    return PointSet(np.array(points), Box((columns, rows * height), torus), "hexagons")


@pytest.fixture(scope="module")
def white_spectrum():
    return power_spectrum([white(4096, seed) for seed in range(10)])


@pytest.fixture(scope="module")
def darts():
    return [dart_throwing(4096, 0.7, seed=seed) for seed in range(10)]


@pytest.fixture(scope="module")
def dart_report(darts):
    return analyze_points(darts, plate=dart_throwing(2**18, 0.7, seed=10), name="darts")


# --- periodograms ---


def exact_periodogram(points, shape):
    """The sums themselves, which fall apart into a product for the whole grid of frequencies."""
    ky, kx = (np.arange(n) - n // 2 for n in shape)
    x, y = (points.points / np.array(points.box.extent)).T
    sums = np.exp(-2j * pi * np.outer(ky, y)) @ np.exp(-2j * pi * np.outer(kx, x)).T
    return abs(sums) ** 2 / len(points)


@pytest.mark.parametrize("box", BOXES)
@pytest.mark.parametrize(("count", "size"), [(3, 8), (57, 30), (600, 128)])
def test_a_periodogram_is_the_sum_it_stands_for(box, count, size):
    points = white(count, 1, box)
    power = periodogram(points, size)
    np.testing.assert_allclose(power, exact_periodogram(points, power.shape), rtol=0, atol=1e-6)


def test_frequency_zero_has_the_power_n_in_the_middle():
    power = periodogram(white(100), 32)
    assert power.shape == (32, 32)
    assert power[16, 16] == pytest.approx(100)


@settings(deadline=None, max_examples=20)
@given(st.integers(0, 10**6), st.floats(0, 1), st.floats(0, 1))
def test_a_periodogram_does_not_see_a_torus_turn(seed, dx, dy):
    points = white(50, seed)
    moved = PointSet((points.points + np.array([dx, dy])) % 1 % 1)
    np.testing.assert_allclose(periodogram(moved, 16), periodogram(points, 16), atol=1e-6)


def test_power_adds_up():
    """Parseval: points on n x n places have the mean power 1 over n x n frequencies."""
    chosen = np.random.default_rng(3).choice(32 * 32, 200, replace=False)
    points = PointSet(np.stack([chosen % 32, chosen // 32], axis=1) / 32)
    assert periodogram(points, 32).mean() == pytest.approx(1)


def test_the_default_size_is_that_of_the_thesis():
    assert spectrum_size(16384) == 1024
    # 2 / (0.75 r_max) is 256.000..., and more, on both sides of this number of points.
    exact = 0.75**2 * 128**2 / (2 * sqrt(3))
    assert [spectrum_size(int(exact) + k) for k in (0, 1)] == [256, 512]


# --- spectra ---


def test_white_noise_is_flat(white_spectrum):
    rings = white_spectrum.radial[1:]
    deviations = (rings - 1) / np.sqrt(2 / (10 * white_spectrum.samples[1:]))
    assert abs(deviations).max() < 5
    assert deviations.std() == pytest.approx(1, abs=0.15)
    figures = white_spectrum.figures
    assert figures["anisotropy_median"] == pytest.approx(-10, abs=0.05)
    assert figures["anisotropy_max"] < -7.5
    # The largest of 2^17 means of ten exponentials.
    assert 2.8 < figures["largest_bin"] < 4.2
    assert figures["effective_nyquist"] < 0.03
    assert figures["oscillation"] < 0.25
    assert white_spectrum.reference == pytest.approx(-10)


def test_the_square_grid_has_its_spikes_alone():
    spectrum = power_spectrum(square_grid(16))
    power = spectrum.power.copy()
    middle = power.shape[0] // 2
    spikes = power[middle % 16 :: 16, middle % 16 :: 16]
    assert np.count_nonzero(spikes > 255.99) == spikes.size - 1
    spikes[:] = 0
    assert power.max() < 1e-9
    assert spectrum.figures["effective_nyquist"] == pytest.approx(1, abs=0.5 / 16)


def test_the_effective_nyquist_frequency_of_the_hexagonal_lattice():
    spectrum = power_spectrum(hexagons(64, 74))
    expected = sqrt(2 / sqrt(3))
    assert spectrum.effective_nyquist == pytest.approx(expected, abs=0.7 / sqrt(64 * 74))


def test_nyquist_and_oscillation_of_given_spectra():
    frequency = np.arange(2000)
    samples = np.rint(2 * pi * frequency).astype(np.int64)
    count = 10000.0
    step = (frequency >= sqrt(count / pi)).astype(float)
    # Mean power 1 - f0^2 / f^2 within f; the highest step there can be has f0 = sqrt(N / pi).
    assert effective_nyquist(step, samples, count) == pytest.approx(sqrt(1 / pi / 0.9), abs=0.01)
    assert oscillation_start(step) == 57
    assert oscillation(step, samples, 57, 557) == 0
    assert oscillation_start(np.linspace(0, 2, 201)) == 98
    assert oscillation_start(np.array([0, 0.2, 0.9, 0.4])) == 2
    wave = 1 + 0.2 * np.cos(frequency)
    assert oscillation(wave, samples, 100, 1500) == pytest.approx(10 * 0.2 / sqrt(2), rel=0.01)
    assert np.isnan(effective_nyquist(step[:50], samples[:50], count))
    assert effective_nyquist(np.ones(2000), samples, count) == 0


def test_dart_throwing_has_the_known_figures(dart_report):
    """The measured reference of 16,384 points: peak 1.60, largest bin 4.1, anisotropy up to -8.8 dB."""
    figures = dart_report.figures
    assert figures["rho"] >= 0.7
    assert figures["radial_peak"] == pytest.approx(1.6, abs=0.12)
    assert 3.4 < figures["largest_bin"] < 5.2
    assert figures["anisotropy_max"] < -7.5
    assert figures["anisotropy_median"] == pytest.approx(-10, abs=0.1)
    assert 0.35 < figures["effective_nyquist"] < 0.55
    assert figures["oscillation"] == pytest.approx(1.0, abs=0.1)


def test_the_shape_of_a_torus_does_not_change_the_spectrum(darts):
    wide = [dart_throwing(4096, 0.7, seed=seed, box=Box((6.0, 1.5))) for seed in range(10)]
    ours, theirs = power_spectrum(wide), power_spectrum(darts)
    assert ours.power.shape == (256, 1024)
    rings = slice(20, 250)
    assert abs(ours.radial[rings] - theirs.radial[rings]).max() < 0.2
    assert ours.effective_nyquist == pytest.approx(theirs.effective_nyquist, abs=0.04)


def test_a_spectrum_has_the_same_bytes_whatever_the_threads(monkeypatch):
    sets = [white(500, seed) for seed in range(7)]
    spectra = []
    for threads in (1, 2, 5):
        monkeypatch.setattr(os, "cpu_count", lambda threads=threads: threads)
        spectra.append(power_spectrum(sets))
    for other in spectra[1:]:
        assert spectra[0].power.tobytes() == other.power.tobytes()
        assert spectra[0].anisotropy.tobytes() == other.anisotropy.tobytes()


def test_sets_of_different_sizes_are_averaged_as_they_are():
    sets = [white(300, 1), white(500, 2)]
    spectrum = power_spectrum(sets, 64)
    expected = (periodogram(sets[0], 64) + periodogram(sets[1], 64)) / 2
    expected[32, 32] = 0
    np.testing.assert_allclose(spectrum.power, expected, atol=1e-9)
    assert spectrum.count == 400


@pytest.mark.parametrize("steps", [(1.0, 1.0), (0.5, 2.0), (3.0, 1 / 3)])
def test_rings_are_those_of_a_slow_twin(steps):
    from tilewright.kernels.spectra import average_annuli

    power = np.random.default_rng(5).exponential(size=(20, 34))
    counts, means, variances = np.empty(12, np.int64), np.empty(12), np.empty(12)
    average_annuli(power, *steps, counts, means, variances)
    fy, fx = (np.arange(20) - 10) * steps[0], (np.arange(34) - 17) * steps[1]
    ring = np.floor(np.hypot(fy[:, None], fx) + 0.5)
    for k in range(12):
        inside = power[ring == k]
        assert counts[k] == len(inside)
        if len(inside) > 1:
            assert means[k] == pytest.approx(inside.mean())
            assert variances[k] == pytest.approx(inside.var(ddof=1))
        else:
            assert np.isnan(variances[k])


def test_spikes_of_tiles_are_those_that_the_tiles_predict():
    rng = np.random.default_rng(8)
    content, along_x, along_y = rng.random((5, 40, 2)), 25, 16
    cells = np.stack(np.meshgrid(np.arange(along_x), np.arange(along_y)), axis=-1)
    sets = [
        PointSet(
            (cells[:, :, None] + content[rng.integers(0, 5, (along_y, along_x))]).reshape(-1, 2),
            Box((along_x, along_y)),
        )
        for _ in range(10)
    ]
    spectrum = power_spectrum(sets)
    spikes = lattice_spikes(spectrum, (along_x, along_y))
    k = np.array(spikes.at) / (along_x, along_y)
    assert (k == np.rint(k)).all()
    mean = np.exp(-2j * pi * content @ k).sum(axis=1).mean()
    assert spikes.on == pytest.approx(along_x * along_y * abs(mean) ** 2 / 40, rel=0.1)
    assert spikes.on == spectrum.power.max() > 10 * spikes.off
    # Told about another lattice, the same spikes are elsewhere.
    assert lattice_spikes(spectrum, 7).off == spikes.on
    assert lattice_spikes(spectrum, (along_y, along_x)).off == spikes.on


# --- zone plate ---


def naive_filter(t):
    """Mitchell & Netravali 1988, eq. 8, with B and C written out."""
    b = c = 1 / 3
    t = abs(t)
    if t < 1:
        return ((12 - 9 * b - 6 * c) * t**3 + (-18 + 12 * b + 6 * c) * t**2 + (6 - 2 * b)) / 6
    if t < 2:
        return ((-b - 6 * c) * t**3 + (6 * b + 30 * c) * t**2 + (-12 * b - 48 * c) * t + (8 * b + 24 * c)) / 6
    return 0.0


def test_samples_are_spread_as_by_a_slow_twin():
    from tilewright.kernels.zone_plate import splat_samples

    rng = np.random.default_rng(2)
    x, y, values = rng.random((3, 60)) * [[11], [9], [1]] - [[2], [2], [0]]
    x[:3], y[:3] = (0.5, 1.0, 6.99), (3.5, 0.0, 2.0)
    sums, weights = np.zeros((5, 7)), np.zeros((5, 7))
    splat_samples(x, y, values, sums, weights)
    spread = [
        [[naive_filter(i + 0.5 - b) * naive_filter(j + 0.5 - a) for a, b in zip(x, y, strict=True)]
         for j in range(7)] for i in range(5)
    ]  # fmt: skip
    np.testing.assert_allclose(weights, np.sum(spread, axis=2), atol=1e-13)
    np.testing.assert_allclose(sums, np.array(spread) @ values, atol=1e-13)


def test_the_reference_is_what_many_samples_come_to():
    """4,096 stratified samples for each pixel, at pixels before, at and beyond the Nyquist frequency."""
    rng = np.random.default_rng(4)
    cells = (np.arange(256) / 64)[:, None]
    for i, j in ((0, 0), (3, 170), (178, 20), (300, 511), (511, 511)):
        u, v = np.broadcast_arrays(cells, cells.T)
        u, v = (a + rng.random((256, 256)) / 64 - 2 for a in (u, v))
        f = np.vectorize(naive_filter)
        weight = f(u) * f(v)
        x, y = ((c + 0.5 + d) * DOMAIN / PIXELS for c, d in ((j, u), (i, v)))
        expected = (weight * (1 + np.sin(x**2 + y**2)) / 2).sum() / weight.sum()
        assert zone_plate_reference()[i, j] == pytest.approx(expected, abs=2e-3)


def test_better_sets_have_a_smaller_error(dart_report):
    regular, fine = zone_plate(square_grid(512)), zone_plate(square_grid(1024))
    assert regular.rate == 1
    assert fine.rate == 4
    assert fine.error < 0.1 < 0.2 < regular.error
    # What one sample for each pixel cannot show beyond the Nyquist frequency, at x = 16.8, it makes up.
    reference = zone_plate_reference()
    low, high = (slice(0, 80), slice(0, 80)), (slice(400, 512), slice(400, 512))
    assert abs(regular.picture[low] - reference[low]).max() < 0.1
    assert abs(regular.picture[high] - reference[high]).mean() > 0.2
    assert dart_report.plate.holes == 0
    assert dart_report.plate.error < regular.error


def test_the_plate_goes_on_over_the_border_of_a_torus():
    points = square_grid(512)
    whole, cut = zone_plate(points), zone_plate(PointSet(points.points, PLAIN))
    inner = (slice(2, 510), slice(2, 510))
    np.testing.assert_allclose(whole.picture[inner], cut.picture[inner], atol=1e-12)
    # Samples at pixel centers, and so at whole distances from each of them, without end.
    at = np.arange(-2, PIXELS + 2) + 0.5
    samples = (1 + np.sin((at[:, None] ** 2 + at**2) * (DOMAIN / PIXELS) ** 2)) / 2
    expected = np.zeros((PIXELS, PIXELS))
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            weight = naive_filter(i) * naive_filter(j)
            expected += weight * samples[2 + i : 514 + i, 2 + j : 514 + j]
    np.testing.assert_allclose(whole.picture, expected, atol=1e-9)
    assert abs(cut.picture - expected).max() > 0.05


def test_a_long_box_shows_its_first_square():
    rng = np.random.default_rng(6)
    square = rng.random((2**17, 2))
    beyond = rng.random((2**16, 2)) + np.array([1, 0])
    long = zone_plate(PointSet(np.concatenate([square, beyond]), Box((2, 1), torus=False)))
    alone = zone_plate(PointSet(square, PLAIN))
    assert long.rate == alone.rate == 0.5
    np.testing.assert_array_equal(long.picture[:, :509], alone.picture[:, :509])


def test_a_plate_needs_enough_points():
    with pytest.raises(TilewrightValueError, match="points has 1000 points in the square; at least 65536"):
        zone_plate(white(1000))


# --- spacing ---


@pytest.mark.parametrize("torus", [True, False])
def test_the_hexagonal_lattice_has_the_figures_of_theory(torus):
    points = hexagons(24, 28, torus)
    assert points.rho == pytest.approx(1)
    assert nearest_mean(points) == pytest.approx(1)
    assert bond_order(points) == pytest.approx(1)
    # A plain box leaves a gap of half a distance at its upper ends.
    assert coverage_radius(points) == pytest.approx(2 / sqrt(3) if torus else 2, abs=1e-6 if torus else 0.4)
    inside = radial_distribution(points, reach=1.3, bins=13).density
    assert inside[:9].sum() == 0
    assert inside[9:11].sum() > 1
    assert inside[11:].sum() == 0


def test_white_noise_has_the_figures_of_theory():
    points = white(4000)
    assert nearest_mean(points) == pytest.approx(0.4653, abs=0.01)
    assert bond_order(points) == pytest.approx(0.361, abs=0.01)
    assert bond_order(square_grid(20)) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("box", [Box(), PLAIN, Box((4, 0.3)), Box((4, 0.3), torus=False)])
def test_the_largest_empty_circle_is_the_one_that_a_fine_grid_finds(box):
    from scipy.spatial import cKDTree

    points = white(12, 7, box)
    tree = cKDTree(points.points, boxsize=box.extent if box.torus else None)
    along = np.linspace(0, 1, 400, endpoint=not box.torus)
    places = np.stack(np.meshgrid(along, along), axis=-1).reshape(-1, 2) * box.extent
    found = tree.query(places)[0].max()
    exact = coverage_radius(points) * points.max_radius
    assert found <= exact + 1e-9
    assert found == pytest.approx(exact, abs=max(box.extent) / 400)


@pytest.mark.parametrize("torus", [True, False])
def test_holes_larger_than_the_first_margin_are_measured(torus):
    """Points in one quarter: the farthest place lies in the middle of the rest, or in the far corner."""
    points = PointSet(white(2000).points / 2, Box(torus=torus))
    expected = sqrt(0.25**2 + 0.25**2) if torus else sqrt(0.5**2 + 0.5**2)
    assert coverage_radius(points) * points.max_radius == pytest.approx(expected, abs=0.03)


def test_empty_balls_are_measured_too():
    n = 4
    corners = np.stack(np.meshgrid(*[np.arange(n)] * 3), axis=-1).reshape(-1, 3).astype(float)
    points = PointSet(corners, Box((n, n, n)))
    assert coverage_radius(points) * points.max_radius == pytest.approx(sqrt(3) / 2)
    assert nearest_mean(points) == pytest.approx(1 / (2 * points.max_radius))


@pytest.mark.parametrize(
    "box", [Box((2, 1)), Box((2, 1), torus=False), Box((1, 2, 1)), Box((1, 2, 1), False)]
)
def test_white_noise_has_density_one_at_every_distance(box):
    sets = [white(400, seed, box) for seed in range(30)]
    distribution = radial_distribution(sets, bins=12)
    assert distribution.density[3:] == pytest.approx(1, abs=0.04)


def test_pairs_are_counted_one_by_one():
    points = white(60, 9, Box((1, 2)))
    distribution = radial_distribution(points, bins=20)
    gaps = abs(points.points[:, None] - points.points)
    gaps = np.minimum(gaps, np.array([1, 2]) - gaps)
    apart = np.sqrt((gaps**2).sum(axis=2))[~np.eye(60, dtype=bool)] / (2 * points.max_radius)
    width = distribution.distance[1] - distribution.distance[0]
    edges = np.arange(21) * width
    found = np.histogram(apart, edges)[0]
    area = pi * np.diff((edges * 2 * points.max_radius) ** 2)
    np.testing.assert_allclose(distribution.density, found / (60 * 59 * area / 2), rtol=1e-9)


def test_darts_keep_their_distance(dart_report):
    distribution = dart_report.distribution
    assert (distribution.density[distribution.distance < 0.69] == 0).all()
    assert distribution.density[distribution.distance > 0.7].max() > 1.8
    assert distribution.density[-50:].mean() == pytest.approx(1, abs=0.01)


def test_the_star_discrepancy_is_warnocks_sum():
    points = white(40, 2, Box((3, 0.5)))
    x = points.points / np.array(points.box.extent)
    pairs = np.prod(1 - np.maximum(x[:, None], x), axis=2).sum() / 40**2
    expected = 3.0**-2 - 2 ** (1 - 2) * np.prod(1 - x**2, axis=1).sum() / 40 + pairs
    assert discrepancy(points, "star") == pytest.approx(sqrt(expected))


def test_the_wrapped_discrepancy_does_not_see_a_torus_turn():
    points = white(200)
    moved = PointSet((points.points + 0.3) % 1)
    assert discrepancy(moved, "wrapped") == pytest.approx(discrepancy(points, "wrapped"))
    assert discrepancy(moved, "star") != pytest.approx(discrepancy(points, "star"))
    assert discrepancy(square_grid(14), "centered") < discrepancy(points, "centered")


# --- reports ---


def test_a_report_has_every_figure(dart_report):
    of_tiles = list(POINT_MEANING).index("tiles")
    assert list(dart_report.figures) == list(POINT_MEANING)[:of_tiles]
    assert all(name in str(dart_report) for name in dart_report.figures)
    pair = analyze_points([square_grid(16), square_grid(16, np.random.default_rng(0).random((256, 2)))])
    assert pair.figures["rho"] == min(one.rho for one in pair.spectrum.sets) < 0.5
    assert pair.figures["coverage"] > 1.05 * coverage_radius(square_grid(16))
    without = analyze_points(white(200))
    assert list(without.figures) == [n for n in dart_report.figures if "zone_plate" not in n]
    assert without.name == "given"


@pytest.mark.parametrize("suffix", ["png", "pdf"])
def test_sheets_are_written_whole(dart_report, tmp_path, suffix):
    dart_report.save_sheet(tmp_path / f"sheet.{suffix}")
    assert [p.name for p in tmp_path.iterdir()] == [f"sheet.{suffix}"]
    start = (tmp_path / f"sheet.{suffix}").read_bytes()[:4]
    assert start == {"png": b"\x89PNG", "pdf": b"%PDF"}[suffix]


def test_lattices_and_few_points_can_be_drawn(dart_report, tmp_path):
    """Rings without power, a spectrum without rings, a box of another shape."""
    reports = [
        analyze_points(hexagons(12, 14)),
        analyze_points(white(3)),
        analyze_points([white(300, seed, Box((2, 0.5), torus=False)) for seed in range(2)]),
    ]
    save_comparison(reports, tmp_path / "all.png")
    assert (tmp_path / "all.png").stat().st_size > 10_000
    axes = comparison_sheet([dart_report, *reports]).axes
    assert len({axis.get_ylim() for axis in axes if axis.get_title() == "radially averaged power"}) == 1


def test_a_report_can_be_cancelled():
    told = []

    def stop(done, total, what):
        told.append((done, total, what))
        if what == "spacing":
            raise Cancelled

    with pytest.raises(Cancelled):
        analyze_points([white(50), white(50, 1)], progress=stop)
    assert told == [(0, 5, "spectrum"), (1, 5, "spacing")]

    told.clear()
    power_spectrum([white(50), white(50, 1)], progress=lambda *news: told.append(news))
    assert told == [(0, 2, "periodograms"), (1, 2, "periodograms"), (2, 2, "periodograms")]


# --- bad input ---

TAKERS = [
    periodogram, power_spectrum, zone_plate, nearest_mean, radial_distribution, coverage_radius, bond_order,
    discrepancy, analyze_points,
]  # fmt: skip


@pytest.mark.parametrize("take", TAKERS)
@pytest.mark.parametrize(
    ("points", "words"),
    [
        (np.zeros((9, 2)), "must be a PointSet"),
        (None, "must be a PointSet"),
        ("points.npy", "must be a PointSet"),
        (white(1), "has 1 points; at least 3"),
        (white(2), "has 2 points; at least 3"),
        (PointSet(np.empty((0, 2))), "has 0 points; at least 3"),
        (PointSet(np.full((9, 2), np.nan)), "must be finite"),
        (PointSet(np.full((9, 2), np.inf)), "must be finite"),
        (PointSet(np.full((9, 2), 1.0)), "outside the domain"),
        (PointSet(np.zeros((9, 1))), "shape"),
        (PointSet(np.zeros(9)), "shape"),
        (PointSet([["a", "b"]] * 9), "must be numbers"),
    ],
)
def test_what_cannot_be_measured_is_refused_in_one_line(take, points, words):
    with pytest.raises(TilewrightError, match=words) as caught:
        take(points)
    assert "\n" not in str(caught.value)


def one_line(error, match, call):
    with pytest.raises(error, match=match) as caught:
        call()
    assert "\n" not in str(caught.value)


def test_volumes_have_no_plane_spectrum():
    volume = white(50, box=Box((1, 1, 1)))
    for take in (periodogram, power_spectrum, zone_plate, bond_order, analyze_points):
        one_line(TilewrightValueError, "has 3 dimensions", lambda take=take: take(volume))


def test_settings_are_checked():
    points, spectrum = white(50), power_spectrum(white(50))
    value, kind = TilewrightValueError, TilewrightTypeError
    one_line(value, "size is 7", lambda: periodogram(points, 7))
    one_line(value, "size is 33; it must be even", lambda: periodogram(points, 33))
    one_line(value, "size is 8194", lambda: power_spectrum(points, 8194))
    one_line(kind, "size must be an integer", lambda: periodogram(points, 64.5))
    one_line(value, "sets is empty", lambda: power_spectrum([]))
    one_line(kind, r"sets\[1\] must be a PointSet", lambda: power_spectrum([points, 3]))
    one_line(value, r"sets\[1\] lies in", lambda: power_spectrum([points, white(50, box=Box((2, 1)))]))
    one_line(value, "kind is 'moon'", lambda: discrepancy(points, "moon"))
    one_line(value, "limited to 32768", lambda: discrepancy(white(40000)))
    one_line(value, "reach is 50", lambda: radial_distribution(points, reach=50))
    one_line(value, "bins is 0", lambda: radial_distribution(points, bins=0))
    one_line(kind, "spectrum must be a Spectrum", lambda: lattice_spikes(points, 4))
    one_line(value, "tiles_along is 0", lambda: lattice_spikes(spectrum, 0))
    one_line(value, "tiles_along is 4000; the spectrum ends", lambda: lattice_spikes(spectrum, 4000))
    one_line(kind, "tiles_along must be", lambda: lattice_spikes(spectrum, (1, 2, 3)))
    one_line(kind, "plate must be a PointSet", lambda: analyze_points(points, plate=7))
    one_line(kind, "reports must be a list of PointReport", lambda: comparison_sheet([points]))
    one_line(value, "reports is empty", lambda: comparison_sheet([]))


def test_a_sheet_needs_a_place(tmp_path):
    report = analyze_points(white(50))
    assert isinstance(report, PointReport)
    one_line(TilewrightValueError, "suffix", lambda: report.save_sheet(tmp_path / "sheet.gif"))
    one_line(TilewrightError, "does not exist", lambda: report.save_sheet(tmp_path / "no" / "sheet.png"))


def test_coincident_points_are_measured():
    points = PointSet(np.concatenate([white(40).points, white(40).points[:5]]))
    figures = analyze_points(points).figures
    assert figures["rho"] == 0
    assert 0 < figures["bond_order"] < 1
