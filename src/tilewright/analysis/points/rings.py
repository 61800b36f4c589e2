"""Figures of radial power, ring by ring (Heck, Schloemer & Deussen 2013)."""

from math import nan, sqrt

import numpy as np
from numpy.typing import NDArray


def effective_nyquist(radial: NDArray[np.float64], samples: NDArray[np.int64], count: float) -> float:
    """See `Spectrum.effective_nyquist`; of any radial power, with the samples of each ring."""
    power = np.cumsum(np.where(samples > 0, radial, 0)[1:] * samples[1:])
    within = power / np.maximum(np.cumsum(samples[1:]), 1)
    # Ring k ends at frequency k + 1/2.
    edges = np.arange(1, len(radial)) + 0.5
    risen = np.flatnonzero((within > 0.5) & (edges >= sqrt(count) / 2))
    if not len(risen):
        return nan
    empty = np.flatnonzero(within[: risen[0]] < 0.1)
    return float(edges[empty[-1]] / sqrt(count)) if len(empty) else 0.0


def oscillation_start(radial: NDArray[np.float64]) -> int:
    """The first frequency with a radial power of 0.98, or that of the highest power."""
    full = np.flatnonzero(radial >= 0.98)
    return int(full[0]) if len(full) else int(np.nanargmax(radial))


def oscillation(radial: NDArray[np.float64], samples: NDArray[np.int64], start: int, last: float) -> float:
    """See `Spectrum.oscillation`; of any radial power, from frequency ``start`` up to ``last``."""
    rings = slice(start, int(last) + 1)
    known = samples[rings] > 0
    off = (radial[rings][known] - 1) ** 2
    return 10 * sqrt(float(np.average(off, weights=samples[rings][known])))
