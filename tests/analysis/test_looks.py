"""Figures of what the eye sees, on planes whose answer is known."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from tilewright.analysis.textures import looks
from tilewright.signals.textures.kinds import to_lab

SIZE = 64


@pytest.fixture(scope="module")
def grain():
    """Fine noise, as L*a*b*, 768 x 768."""
    rng = np.random.default_rng(2)
    noise = gaussian_filter(rng.normal(size=(768, 768, 3)), (0.7, 0.7, 0))
    return (50 + 60 * noise).astype(np.float32)


@pytest.fixture(scope="module")
def repeated(grain):
    """One tile of it, again and again."""
    return np.tile(grain[:SIZE, :SIZE], (12, 12, 1))


def test_a_plane_is_like_itself(grain):
    assert looks.mean_difference(grain, grain) == 0
    assert looks.low_contrast(grain, grain) == looks.fine_contrast(grain, grain) == 1
    assert looks.mean_difference(grain + np.float32([3, 0, 4]), grain) == pytest.approx(5, abs=1e-3)


def test_blots_and_grain_are_told_apart(grain):
    calm = grain - 0.5 * (gaussian_filter(grain, (24, 24, 0)) - grain.mean(axis=(0, 1)))
    assert looks.low_contrast(calm, grain) == pytest.approx(0.6, abs=0.15)
    assert looks.fine_contrast(calm, grain) == pytest.approx(1, abs=0.02)


def test_equal_neighbors_are_counted(grain, repeated):
    assert looks.equal_neighbors(repeated, SIZE) == 1
    assert looks.equal_neighbors(grain, SIZE) == 0
    half = np.hstack([repeated[:, :384], grain[:, 384:]])
    assert looks.equal_neighbors(half, SIZE) == pytest.approx(0.5, abs=0.06)


def test_copies_are_counted(grain, repeated):
    assert looks.recurrence(repeated, grain, SIZE) == pytest.approx(144, rel=0.15)
    assert looks.recurrence(grain, grain, SIZE) == 1
    assert looks.salient_copies(repeated, grain, SIZE) == pytest.approx(144, rel=0.15)
    assert looks.salient_copies(grain, grain, SIZE) <= 2


def test_a_lattice_shows_as_spikes(grain, repeated):
    assert looks.lattice_spikes(repeated, SIZE) > 0.5
    assert looks.lattice_spikes(grain, SIZE) < 0.1


@pytest.mark.parametrize(
    ("rgb", "lab"),
    [
        ((255, 255, 255), (100, 0, 0)),
        ((0, 0, 0), (0, 0, 0)),
        ((255, 0, 0), (53.24, 80.09, 67.20)),
        ((18, 120, 60), (44.07, -41.82, 25.23)),
    ],
)
def test_lab_is_that_of_the_cie(rgb, lab):
    """Against scikit-image's values."""
    pixels = np.array(rgb, np.uint8).reshape(1, 1, 3)
    assert to_lab(pixels, "color").ravel() == pytest.approx(lab, abs=0.1)
    assert to_lab(pixels[..., :1], "data").shape == (1, 1, 1)
