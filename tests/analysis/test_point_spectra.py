"""Spectra and zone plates of point sets against theory, exact sums and slow twins."""

import os
from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from pointsets import BOXES, PLAIN, hexagons, square_grid, white
from tilewright.analysis.points.plates import DOMAIN, PIXELS, zone_plate, zone_plate_reference
from tilewright.analysis.points.spectrum import (
    effective_nyquist,
    lattice_spikes,
    oscillation,
    oscillation_start,
    periodogram,
    power_spectrum,
    spectrum_size,
)
from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.darts import dart_throwing
from tilewright.samplers.point_set import PointSet


@pytest.fixture(scope="module")
def white_spectrum():
    return power_spectrum([white(4096, seed) for seed in range(10)])


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
