"""Spacing of point sets against theory, and reports about them."""

from math import pi, sqrt

import numpy as np
import pytest

import tilewright as tw
from pointsets import PLAIN, hexagons, square_grid, white
from tilewright.analysis.points.laid_tiles import lay_square
from tilewright.analysis.points.meanings import POINT_MEANING, POINT_UNITS
from tilewright.analysis.points.plates import zone_plate
from tilewright.analysis.points.report import (
    PointReport,
    analyze_points,
    comparison_sheet,
    save_comparison,
)
from tilewright.analysis.points.spacing import (
    bond_order,
    coverage_radius,
    discrepancy,
    nearest_mean,
    radial_distribution,
)
from tilewright.analysis.points.spectrum import lattice_spikes, periodogram, power_spectrum
from tilewright.errors import Cancelled, TilewrightError, TilewrightTypeError, TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet

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


def test_every_figure_of_points_has_a_unit(dart_report):
    assert POINT_UNITS.keys() == POINT_MEANING.keys()
    assert all(POINT_UNITS.values())
    assert " 0.7 2 r_max  least distance" in str(dart_report)


def judged(method, count=1500, sets=1, **settings):
    return analyze_points([tw.sample_points(method, count, seed=k, **settings) for k in range(sets)])


@pytest.mark.parametrize("box", [tw.Box(), tw.Box((4.0, 1.0), torus=False)], ids=["torus", "thin"])
@pytest.mark.parametrize(("method", "rho"), [("dart", 0.7), ("maximal", None)])
def test_good_blue_noise_is_told(method, rho, box):
    (said,) = judged(method, rho=rho, box=box).verdict
    assert said.startswith("Good blue noise: least distance 0.7")
    assert ("no room for another point" in said) == (method == "maximal")


@pytest.mark.parametrize(
    ("method", "settings", "objections"),
    [
        ("uniform", {}, ["points clump", "holes", "low frequencies are noisy"]),
        ("jittered", {"sets": 4}, ["points clump", "low frequencies are noisy"]),
        ("regular", {"count": 2500}, ["as on a lattice", "swings", "a lattice shows"]),
        ("lloyd", {"iterations": 8}, ["swings by 2."]),
        ("sobol", {"count": 1000, "sets": 10}, ["points clump", "directions"]),
    ],
)
def test_what_to_object_to_and_what_to_change(method, settings, objections):
    report = judged(method, **settings)
    first, objected, change = report.verdict
    assert first == ("Blue noise, with faults." if method == "lloyd" else "Not good blue noise.")
    assert objected.startswith("To object to: ")
    assert all(words in objected for words in objections)
    assert change.startswith("To change: ")
    assert all(sentence in str(report) for sentence in report.verdict)


def test_a_spectrum_of_few_points_is_not_judged():
    assert judged("dart", 300, rho=0.7).verdict[0].endswith("of fewer than 1,000 points is not judged.")
    assert "directions" not in " ".join(judged("regular", 400).verdict)


def test_a_lattice_of_tiles_is_told_with_what_changes_it():
    tiles = tw.make_point_tiles("template", seed=1, points=16, rho=0.7, variants=4)
    report = analyze_points([lay_square(tiles, 2000, seed) for seed in range(3)])
    assert report.verdict[1].count("the lattice of tiles shows: a frequency of") == 1
    assert "more colors or more points per tile" in report.verdict[2]


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
    (tmp_path / "no").touch()
    one_line(TilewrightError, "not a folder", lambda: report.save_sheet(tmp_path / "no" / "sheet.png"))


def test_coincident_points_are_measured():
    points = PointSet(np.concatenate([white(40).points, white(40).points[:5]]))
    figures = analyze_points(points).figures
    assert figures["rho"] == 0
    assert 0 < figures["bond_order"] < 1
