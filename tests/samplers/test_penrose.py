"""Penrose points: the parts tile, the codes number the vertices, the vectors keep points apart."""

import os
import subprocess
import sys
from math import log

import numpy as np
import pytest
from scipy.spatial import cKDTree

from penrose_relaxation import relax_index
from tilewright.analysis.points.spectrum import periodogram
from tilewright.errors import Cancelled, TilewrightTypeError, TilewrightValueError
from tilewright.samplers import penrose as tiling
from tilewright.samplers.box import Box
from tilewright.samplers.darts import dart_throwing
from tilewright.samplers.penrose import PHI, TURNS, Window, find_samples, load_vectors, penrose_points
from tilewright.samplers.point_set import PointSet

PLAIN = Box(torus=False)


def inside(triangle, points):
    """Whether points lie in a triangle, by the signs of cross products."""
    signs = []
    for a, b in zip(triangle, np.roll(triangle, -1), strict=True):
        signs.append(((b - a).conjugate() * (points - a)).imag > 0)
    return np.all(signs, axis=0) | ~np.any(signs, axis=0)


@pytest.mark.parametrize("tile", [tiling.C, tiling.D, tiling.E, tiling.F])
def test_parts_of_a_tile_cover_it_once(tile):
    whole = np.array(tiling._VERTICES[tile])
    a, b = np.sort(np.random.default_rng(0).random((2, 2000)), axis=0)
    points = whole[0] + a * (whole[1] - whole[0]) + (b - a) * (whole[2] - whole[0])
    times = np.zeros(len(points), int)
    for part, at, turn, _ in tiling._PLACED[tile]:
        if part > tiling.B:
            times += inside(at + TURNS[turn] * np.array(tiling._VERTICES[part]) / PHI, points)
    assert (times == 1).all()


def test_codes_are_numbers_of_the_fibonacci_system_and_no_two_the_same():
    types, points, directions, codes = (
        np.array([tiling.F]),
        np.zeros(1, complex),
        np.zeros(1, int),
        np.zeros(1, int),
    )
    for level in range(1, 10):
        types, points, directions, codes = tiling._subdivide(
            types, points, directions, codes, PHI ** (1 - level)
        )
        own = types <= tiling.B
        assert not (codes[own] & codes[own] >> 1).any()  # no two digits in a row
        values = tiling.code_values(codes[own], 2 * level)
        slow = [
            sum(tiling.fibonacci(i + 2) for i, digit in enumerate(f"{code:0{2 * level}b}") if digit == "1")
            for code in codes[own].tolist()
        ]
        assert values.tolist() == slow
        assert len(set(slow)) == len(slow)
        assert tiling.fibonacci(2 * level) <= max(slow) + 1 <= tiling.fibonacci(2 * level + 2)
        assert tiling.importance_level(max(slow)) == level or level == 1
        places = np.stack([points[own].real, points[own].imag], axis=1)
        if len(places) > 1:
            assert cKDTree(places).query(places, k=2)[0][:, 1].min() > 0.5 * PHI**-level


def test_a_deeper_level_keeps_every_vertex():
    window = Window.choose(PLAIN, 3)
    coarse, fine = find_samples(window, 14), find_samples(window, 15)
    gaps = cKDTree(fine.points.view(float).reshape(-1, 2)).query(coarse.points.view(float).reshape(-1, 2))[0]
    close = np.abs(coarse.points - (0.5 + 0.5j)) < 0.5
    assert gaps[close].max() < 1e-9


def test_windows_lie_in_the_first_tile():
    for seed in range(200):
        for extent in ((1.0, 1.0), (9.0, 0.1)):
            window = Window.choose(Box(extent, torus=False), seed)
            corners = window.corner + np.array([0, extent[0], extent[1] * 1j, complex(*extent)])
            assert inside(window.scale * np.array(tiling._FAT), corners).all()


@pytest.mark.parametrize("count", [1, 10, 100, 1000, 5000, 16384])
@pytest.mark.parametrize("box", [PLAIN, Box((3.0, 0.5), torus=False)])
def test_count_is_met_about(count, box):
    made = penrose_points(count, seed=count, box=box)
    assert abs(len(made) - count) <= 1 + 0.03 * count**0.5 * 3
    assert box.check_points(made.points).shape == (len(made), 2)
    assert made.distance == 0


def test_radius_at_every_density():
    reached = [penrose_points(round(3000 * PHI ** (2 * i / 15)), seed=i).rho for i in range(15)]
    assert min(reached) > 0.75
    assert max(reached) < 0.83


def test_without_vectors_the_radius_is_that_of_the_tiling():
    window = Window.choose(PLAIN, 0)
    reached = []
    for index in range(0, 21, 2):
        importance = int(PHI ** (2 * (18 + (index + 0.5) / 21)) / 5**0.5)
        samples = find_samples(window, tiling.importance_level(importance))
        points = samples.points[: samples.kept(importance)]
        reached.append(PointSet(tiling.keep_inside(points, PLAIN), PLAIN).rho)
    assert min(reached) == pytest.approx(0.51, abs=0.02)
    assert max(reached) == pytest.approx(0.81, abs=0.02)


def test_density_is_even():
    made = penrose_points(20000, seed=5)
    counts = np.histogram2d(*made.points.T, bins=10, range=[[0, 1], [0, 1]])[0]
    assert counts.std() / counts.mean() < 0.02  # chance alone has 0.07


def test_spectrum_has_a_star_of_ten():
    def ratio(points):
        power = periodogram(points, 512)
        middle = len(power) // 2
        y, x = np.indices(power.shape) - middle
        far = np.hypot(x, y)
        # Without the cross that the border of the box makes.
        off = (np.abs(x) > 3) & (np.abs(y) > 3) & (far < 0.9 * middle)
        peak = np.unravel_index(np.argmax(power * off), power.shape)
        around = []
        for turn in range(1, 5):
            at = complex(peak[1] - middle, peak[0] - middle) * np.exp(1j * np.pi / 5 * turn)
            row, column = round(at.imag) + middle, round(at.real) + middle
            around.append(power[row - 2 : row + 3, column - 2 : column + 3].max())
        return power[peak], min(around)

    peak, turned = ratio(penrose_points(4096, seed=1))
    assert peak > 100
    assert turned > 0.3 * peak
    assert ratio(dart_throwing(4096, 0.7, box=PLAIN))[0] < 30


def test_same_seed_same_bytes():
    one, same, other = (penrose_points(1000, seed=s).points for s in (7, 7, 8))
    assert one.tobytes() == same.tobytes()
    assert one.tobytes() != other.tobytes()
    drawn = [penrose_points(500, seed=np.random.default_rng(3)).points.tobytes() for _ in range(2)]
    assert drawn[0] == drawn[1]


def test_stored_vectors_are_made_by_this_code():
    index = 1  # the one that takes least time
    np.testing.assert_allclose(relax_index(index) @ np.array([1, 1j]), load_vectors()[index], atol=1e-3)


def test_importance_index_runs_once_through_every_level():
    at = [int(PHI ** (2 * (10 + (i + 0.5) / 21)) / 5**0.5) for i in range(21)]
    assert [tiling.importance_index(v) for v in at] == list(range(21))
    assert len({round(log(v)) for v in at}) > 1


@pytest.mark.parametrize(
    ("error", "words", "settings"),
    [
        (TilewrightValueError, "torus", {"box": Box()}),
        (TilewrightValueError, "dimensions", {"box": Box((1, 1, 1), torus=False)}),
        (TilewrightTypeError, "box", {"box": 3}),
        (TilewrightValueError, "seed", {"seed": -1}),
        (TilewrightValueError, "count", {"count": 0}),
        (TilewrightTypeError, "count", {"count": 1.5}),
    ],
)
def test_bad_input(error, words, settings):
    with pytest.raises(error, match=words):
        penrose_points(**{"count": 10, **settings})


def test_progress_can_stop_it():
    def stop(done, total, what):
        raise Cancelled("enough")

    with pytest.raises(Cancelled):
        penrose_points(100, progress=stop)


def test_points_do_not_depend_on_the_library_for_matrices():
    """OpenBLAS has other code for other processors."""
    made = "tw.sample_points('penrose', 500, box=tw.Box(torus=False)).points.tobytes()"
    code = f"import tilewright as tw; print({made})"
    made = [
        subprocess.run(
            [sys.executable, "-c", code], check=True, capture_output=True, env={**os.environ, **core}
        ).stdout
        for core in ({}, {"OPENBLAS_CORETYPE": "Prescott"})
    ]
    assert made[0] == made[1]
