"""Periodograms: the powers of the frequencies of a box, by a nonuniform FFT."""

import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from math import pi, sqrt

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet
from tilewright.signals.points.fourier import fourier_sums

_TOLERANCE = 1e-9
_MEMORY = 2**31
"""Bytes that the transforms under way at once may take, about."""
_HANN = np.array([-0.25, 0.5, -0.25])
"""The transform of sin^2 over its interval at frequencies -1, 0 and 1; it is 0 at all other whole ones."""


def frequency_steps(box: Box) -> tuple[float, float]:
    """Frequency from one row, and from one column, to the next, in periods in the square root of the area."""
    unit = sqrt(box.volume)
    return unit / box.extent[1], unit / box.extent[0]


def spectrum_shape(box: Box, size: int) -> tuple[int, int]:
    """Rows and columns, both even, that reach frequency size / 2."""
    rows, columns = (2 * max(1, round(size / step / 2)) for step in frequency_steps(box))
    return rows, columns


def half_periodogram(shape: tuple[int, int], points: PointSet, tapered: bool = False) -> NDArray[np.float64]:
    """The half of a periodogram that holds all of it, since points have no imaginary parts.

    Rows have the frequencies -rows / 2 to 0, columns -columns / 2 to columns / 2, both ends included.
    ``tapered``: points weigh less towards the sides of the box, see `power_spectrum`.
    """
    rows, columns = shape[0] // 2 + 1, shape[1] + 1
    x, y = np.ascontiguousarray((points.points * (2 * pi / np.array(points.box.extent))).T)
    # The transform has its frequency 0 in the middle row; turning the points puts it in the last one.
    turned = np.exp(1j * ((rows - 1) // 2) * y)
    weights = _taper(points) if tapered else np.ones(len(points))
    transform = fourier_sums(y, x, weights * turned, (rows, columns), _TOLERANCE, 1.25)
    if tapered:
        # What an even density would have: all of it lies at the lowest frequencies.
        middle = shape[1] // 2
        even = weights.sum() * np.outer(_HANN[:2], _HANN) / _HANN[1] ** 2
        transform[-2:, middle - 1 : middle + 2] -= even
    power: NDArray[np.float64] = (transform.real**2 + transform.imag**2) / (weights**2).sum()
    return power


def _taper(points: PointSet) -> NDArray[np.float64]:
    """Hann's window over the box at each point."""
    waves = np.sin(points.points * (pi / np.array(points.box.extent)))
    weights: NDArray[np.float64] = (waves**2).prod(axis=1)
    return weights


def _half_periodograms(
    sets: tuple[PointSet, ...], shape: tuple[int, int], tapered: bool
) -> Iterator[NDArray[np.float64]]:
    """The half periodogram of each set in turn, several at a time."""
    transform = partial(half_periodogram, shape, tapered=tapered)
    bytes_each = 40 * shape[0] * shape[1]
    workers = max(1, min(os.cpu_count() or 1, len(sets), _MEMORY // bytes_each))
    with ThreadPoolExecutor(workers) as pool:
        for first in range(0, len(sets), workers):
            yield from pool.map(transform, sets[first : first + workers])


def mean_half_periodogram(
    sets: tuple[PointSet, ...], size: int, progress: Progress | None, tapered: bool = False
) -> NDArray[np.float64]:
    """The mean of the half periodograms of several sets of one box."""
    shape = spectrum_shape(sets[0].box, size)
    total = np.zeros((shape[0] // 2 + 1, shape[1] + 1))
    if progress is not None:
        progress(0, len(sets), "periodograms")
    for done, power in enumerate(_half_periodograms(sets, shape, tapered), 1):
        total += power
        if progress is not None:
            progress(done, len(sets), "periodograms")
    return total / len(sets)


def unfold(half: NDArray[np.float64]) -> NDArray[np.float64]:
    """The whole plane from its half, P(-f) = P(f), without the highest row and column."""
    middle, columns = half.shape[0] - 1, half.shape[1] - 1
    whole = np.empty((2 * middle, columns))
    whole[: middle + 1] = half[:, :-1]
    whole[middle + 1 :] = half[middle - 1 : 0 : -1, :0:-1]
    return whole
