"""Fourier sums without finufft: the exact sums, at every size, and the same as with it."""

import numpy as np
import pytest

from tilewright.kernels.nufft import spread_points
from tilewright.signals.points import fourier


def exact(y, x, strengths, shape):
    """Each sum by itself."""
    ky, kx = (np.arange(n) - n // 2 for n in shape)
    return np.einsum("aj,bj,j->ab", np.exp(-1j * np.outer(ky, y)), np.exp(-1j * np.outer(kx, x)), strengths)


@pytest.mark.parametrize("shape", [(1, 1), (2, 7), (33, 20), (8, 130)])
def test_own_sums_are_exact(monkeypatch, shape):
    monkeypatch.setattr(fourier, "has_package", lambda module: False)
    rng = np.random.default_rng(3)
    y, x = rng.uniform(-4, 9, (2, 50))
    strengths = rng.normal(size=50) + 1j * rng.normal(size=50)
    found = fourier.fourier_sums(y, x, strengths, shape, 1e-9)
    np.testing.assert_allclose(found, exact(y, x, strengths, shape), atol=2e-9 * np.abs(strengths).sum())


def test_both_transforms_agree(monkeypatch):
    pytest.importorskip("finufft")
    rng = np.random.default_rng(4)
    y, x = rng.uniform(0, 2 * np.pi, (2, 2000))
    with_it = fourier.fourier_sums(y, x, np.ones(2000, complex), (65, 128), 1e-9, 1.25)
    monkeypatch.setattr(fourier, "has_package", lambda module: False)
    own = fourier.fourier_sums(y, x, np.ones(2000, complex), (65, 128), 1e-9)
    np.testing.assert_allclose(own, with_it, atol=1e-5)


def test_points_are_spread_around_themselves():
    grid = np.zeros((20, 24), complex)
    spread_points(np.array([0.25]), np.array([19.5]), np.array([2.0 + 1j]), 4, 9.0, grid)
    expected = np.zeros_like(grid)
    for row in range(18, 22):
        for column in range(-1, 3):
            z = np.array([row - 19.5, column - 0.25]) / 2
            weight = np.exp(9 * (np.sqrt(np.maximum(0, 1 - z * z)) - 1)).prod()
            expected[row % 20, column % 24] += (2 + 1j) * weight
    np.testing.assert_allclose(grid, expected, atol=1e-15)
