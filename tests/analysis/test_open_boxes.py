"""Points cut out of a plane have the figures of the plane, whatever box they are given; thin boxes end."""

import time
from math import isnan

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightTypeError, TilewrightValueError


@pytest.fixture(scope="module")
def closed():
    """A torus of tiles, which has no sides."""
    blue = tw.ready_tiles()
    return tw.PointField(blue, tw.direct(blue.tiles, seed=0, period=(22, 22))).torus()


@pytest.fixture(scope="module")
def whole(closed):
    return tw.analyze(closed).figures


def cut(points, corner, size):
    """Those of a rectangle, in the smallest plain box around them."""
    inside = ((points >= corner) & (points < np.add(corner, size))).all(axis=1)
    kept = points[inside] - points[inside].min(axis=0)
    return tw.PointSet(kept, tw.Box(tuple((kept.max(axis=0) + 1e-9).tolist()), torus=False))


def test_a_window_has_the_figures_of_its_plane(closed, whole):
    window = cut(closed.points, (2.3, 1.7), (14, 12))
    found = tw.analyze(window).figures
    assert tw.coverage_radius(window) > 1.1 * whole["coverage"]
    assert found["coverage"] == pytest.approx(whole["coverage"], rel=0.06)
    assert found["effective_nyquist"] == pytest.approx(whole["effective_nyquist"], rel=0.06)
    for name, close in (("nearest_mean", 0.02), ("bond_order", 0.02), ("radial_peak", 0.12), ("rho", 0.02)):
        assert found[name] == pytest.approx(whole[name], rel=close), name
    assert found["oscillation"] == pytest.approx(whole["oscillation"], rel=0.15)
    assert tw.analyze(window).notes[0].startswith("The ")


def test_a_torus_has_nothing_to_note(closed):
    assert tw.analyze(closed).notes == ()


def test_a_tapered_spectrum_of_white_noise_is_one():
    noise = tw.sample_points("uniform", 4000, seed=2, box=tw.Box((2, 1), torus=False))
    spectrum = tw.power_spectrum(noise, 256, tapered=True)
    assert spectrum.radial[20:].mean() == pytest.approx(1, abs=0.03)
    rows, columns = spectrum.power.shape
    assert spectrum.power[rows // 2 - 1 : rows // 2 + 2, columns // 2 - 1 : columns // 2 + 2].max() < 12


def test_a_grid_cut_out_of_its_plane_is_clean_below_its_frequency():
    grid = np.stack(np.meshgrid(np.arange(30.0), np.arange(30.0)), -1).reshape(-1, 2) + 0.5
    spectrum = tw.power_spectrum(tw.PointSet(grid, tw.Box((30, 30), torus=False)), tapered=True)
    assert spectrum.radial[1:25].max() < 1e-9


def test_what_a_box_has_no_room_for_is_left_out_with_a_sentence():
    line = tw.PointSet([[1, 0.25], [500, 0.75], [900, 0.5]], tw.Box((1000, 1), torus=False))
    report = tw.analyze(line)
    assert not {"coverage", "bond_order"} & set(report.figures)
    assert not any(isnan(report.figures[name]) for name in ("rho", "nearest_mean"))
    assert report.notes[-1].startswith("Left out: coverage, bond_order")
    assert str(report).endswith(report.notes[-1])


@pytest.mark.parametrize("torus", [True, False])
@pytest.mark.parametrize("extent", [(1e9, 1), (2.0**63, 3), (1, 1e6)])
def test_thin_boxes_end(torus, extent):
    points = tw.PointSet(np.random.default_rng(1).random((1000, 2)) * extent, tw.Box(extent, torus=torus))
    started = time.perf_counter()
    for measure in (tw.analyze, tw.power_spectrum, tw.periodogram):
        with pytest.raises(TilewrightValueError, match="too thin"):
            measure(points)
    if torus or max(extent) > 1e9:
        with pytest.raises(TilewrightValueError, match="too thin"):
            tw.coverage_radius(points)
    else:
        assert tw.coverage_radius(points) > 0
    assert time.perf_counter() - started < 20


def test_what_is_no_box_and_no_function_is_said_at_once():
    points = tw.sample_points("dart", 10)
    for call in (
        lambda: tw.max_radius(10, 7),
        lambda: tw.relative_radius(points, box=7),
        lambda: tw.PointSet(points.points, 3).max_radius,
        lambda: tw.sample_points("dart", 10, progress=3),
        lambda: tw.analyze(points, progress=3),
        lambda: tw.power_spectrum(points, progress=3),
    ):
        with pytest.raises(TilewrightTypeError):
            call()
