"""Courses: even ones by correlation, uneven ones by the lines between them, none where there are none."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from masonry import courses
from tilewright.signals.textures.character import find_character
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.regularity import find_regularity
from tilewright.signals.textures.rhythm import find_rhythm


def test_uneven_courses_are_followed():
    heights = [52, 60, 55, 58, 51, 61, 57, 53, 59]
    rhythm = find_rhythm(courses(heights), None)
    assert rhythm is not None
    assert not rhythm.even
    assert rhythm.period == pytest.approx(np.mean(heights), abs=1.5)
    joints = np.cumsum([0, *heights[:-1]]) + 1
    phase = rhythm.phase[joints[1:]]
    assert np.abs(phase - np.rint(phase)).max() * rhythm.period < 3


def test_windows_in_step_are_those_at_joints():
    heights = [50] * 9
    rhythm = find_rhythm(courses(heights), None)
    misfit = rhythm.misfit(100, 0)
    joints = np.arange(0, len(misfit), 50) + 1
    assert misfit[joints[1:-1]].max() < 3
    assert misfit[joints[1:-1] + 20].min() > 12
    middle = rhythm.misfit(100, 50)
    assert np.abs(middle - misfit).max() < 1e-6


@pytest.mark.parametrize("seed", range(4))
def test_grain_has_no_rhythm(seed):
    rng = np.random.default_rng(seed)
    for sigma in (0.5, 3, 12):
        grain = gaussian_filter(rng.normal(size=(400, 400)), sigma).astype(np.float32)
        assert find_rhythm(grain, None) is None


@pytest.mark.parametrize(
    ("name", "periods"),
    [
        ("cobblestone", (56, None)),
        ("stone_wall", (107, None)),
        ("weave", (64, 42.6)),
        *((name, (None, None)) for name in ("sand", "grass", "pebbles", "straw_dense", "leaves_albedo")),
    ],
)
def test_rhythms_of_photographs(photograph, name, periods):
    exemplar = Exemplar([{"albedo": photograph(name)}])
    found = find_character(exemplar, find_regularity(photograph(name)), 128)
    for rhythm, period in zip(found.rhythm, periods, strict=True):
        assert (rhythm is None) == (period is None)
        if period is not None:
            assert rhythm.period == pytest.approx(period, rel=0.01)
    assert found.has_things == (name in ("cobblestone", "stone_wall"))


def test_a_large_photograph_has_the_rhythm_of_a_small_one():
    small = courses([50] * 9)
    large = np.kron(small[:440], np.ones((4, 4), np.float32))
    exemplar = Exemplar([{"albedo": np.clip(large, 0, 255).astype(np.uint8)[..., np.newaxis]}])
    rows, _ = find_character(exemplar, find_regularity(exemplar.sources[0]["albedo"]), 512).rhythm
    assert rows.period == pytest.approx(200, abs=1)
    assert len(rows.phase) == len(large)
