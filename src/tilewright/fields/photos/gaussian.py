"""A photograph with Gaussian histograms, and the table that undoes it."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

ENTRIES = 256
"""Of the inverse table, along its axis of values."""
SPREAD = 6
"""Standard deviations from 0 to 1: the histograms are normal around 1/2 with a deviation of 1/6."""


@dataclass(frozen=True, eq=False)
class Gaussianized:
    """A photograph in colors that do not correlate, each with a Gaussian histogram.

    Deliot & Heitz 2019 (GPU Zen 2, "Procedural Stochastic Textures by Tiling and Blending"): one histogram
    transformation for each axis of the photograph's colors, in place of the one of all three at once of
    Heitz & Neyret 2018; and an inverse table for each mip level.

    Attributes
    ----------
    pixels : uint8 array, shape (h, w, channels)
    table : float32 array, shape (levels, 256, channels)
        Value along each axis of the colors, from the mean on, of a Gaussian value from 0 to 1. A level's
        mip texels are narrower Gaussians; its table is averaged over what they lost, which keeps the mean
        color of pixels seen from afar.
    axes : float64 array, shape (channels, channels)
        Color from 0 to 1 = ``mean + axes @ value``.
    mean : float64 array, shape (channels,)
    """

    pixels: NDArray[np.uint8]
    table: NDArray[np.float32]
    axes: NDArray[np.float64]
    mean: NDArray[np.float64]

    def restore(self, gauss: NDArray[np.floating[Any]]) -> NDArray[np.float64]:
        """Colors from 0 to 1 of Gaussian values, shape (..., channels), at the finest level."""
        at = np.clip(gauss, 0, 1) * (ENTRIES - 1)
        low = np.minimum(at.astype(np.int64), ENTRIES - 2)
        part, channel, table = at - low, np.arange(self.table.shape[2]), self.table[0]
        value = (1 - part) * table[low, channel] + part * table[low + 1, channel]
        return np.clip(self.mean + value @ self.axes.T, 0, 1)


def gaussianize(color: NDArray[np.floating[Any]]) -> Gaussianized:
    """The photograph, shape (h, w, channels), 0 to 1, with Gaussian histograms."""
    flat = color.reshape(-1, color.shape[2]).astype(np.float64)
    mean = flat.mean(axis=0)
    _, axes = np.linalg.eigh(np.cov(flat.T).reshape(len(mean), -1))
    # An axis has two directions; the one with a positive sum is taken, on every machine.
    axes *= np.where(axes.sum(axis=0) < 0, -1, 1)
    values = (flat - mean) @ axes
    ordered = np.sort(values, axis=0)
    gauss = np.stack([_to_gauss(v, o) for v, o in zip(values.T, ordered.T, strict=True)], axis=1)
    pixels = np.rint(gauss * 255).astype(np.uint8).reshape(color.shape)
    return Gaussianized(pixels, _make_table(ordered, pixels), axes, mean)


def _to_gauss(values: NDArray[np.float64], ordered: NDArray[np.float64]) -> NDArray[np.float64]:
    from scipy.special import ndtri

    # Equal values get their middle rank, so that nothing depends on where they lie.
    rank = np.searchsorted(ordered, values, "left") + np.searchsorted(ordered, values, "right")
    return np.asarray(np.clip(0.5 + ndtri(rank / (2 * len(values))) / SPREAD, 0, 1))


def _make_table(ordered: NDArray[np.float64], pixels: NDArray[np.uint8]) -> NDArray[np.float32]:
    from scipy.special import ndtr

    # Gaussian values reach farther than the table, as filtering mixes what lies beyond its ends.
    reach, step = 2 * ENTRIES, 1 / (ENTRIES - 1)
    places = (np.arange(-reach, ENTRIES + reach) * step - 0.5) * SPREAD
    rank = ndtr(places) * len(ordered) - 0.5
    exact = np.stack([np.interp(rank, np.arange(len(ordered)), column) for column in ordered.T], axis=1)
    levels, mip = [], pixels / 255
    for _ in range(int(np.log2(min(pixels.shape[:2]))) + 1):
        lost = np.maximum(SPREAD**-2 - mip.var(axis=(0, 1)), 0)
        levels.append(_smooth(exact, np.sqrt(lost) / step)[reach : reach + ENTRIES])
        mip = _halve(mip)
    levels[0] = exact[reach : reach + ENTRIES]
    return np.stack(levels).astype(np.float32)


def _smooth(columns: NDArray[np.float64], sigmas: NDArray[np.float64]) -> NDArray[np.float64]:
    from scipy.ndimage import gaussian_filter1d

    pairs = zip(columns.T, sigmas, strict=True)
    return np.stack([gaussian_filter1d(c, s, mode="nearest") if s > 0 else c for c, s in pairs], axis=1)


def _halve(mip: NDArray[np.float64]) -> NDArray[np.float64]:
    h, w = (max(1, s // 2) for s in mip.shape[:2])
    even = mip[: 2 * h if h > 1 or mip.shape[0] > 1 else 1, : 2 * w if w > 1 or mip.shape[1] > 1 else 1]
    return even.reshape(h, even.shape[0] // h, w, even.shape[1] // w, -1).mean(axis=(1, 3))
