"""Repetition: how much of the picture comes back at whole tiles, and how much of the exemplar is used."""

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.sample import Blur, Gray, Sample, as_sample
from tilewright.signals.textures import TextureTiles

REGULAR = 0.1
"""Autocorrelation at whole tiles from which an exemplar's own is subtracted; less may be chance."""


def measure_repetition(
    material: TextureTiles | Sample, *, cells: int = 12, seed: int = 0
) -> dict[str, float]:
    """Autocorrelation of a tiling at whole tiles, and shared origins.

    The picture is the mean of the channels less its Gaussian low-pass of half a tile. Lags are all
    (i, j) tiles up to half the tiling, without (0, 0).

    Returns
    -------
    dict of str to float
        ``repetition_raw``: mean correlation over the lags; 1 is one tile repeated, 1/C what patches shared
        by color alone give. ``repetition_zero``: the same at lags half a tile off, where tiles do not
        repeat. ``repetition_own``: the exemplar's own at whole tiles, as far as it reaches.
        ``repetition``: raw less own where own is at least 0.1, else raw.
        ``same_place``: share of pixels at one place of two cells that were copied from one pixel, over
        all pairs of cells; needs no picture, so it also holds for periodic exemplars.
    """
    sample = as_sample(material, cells, seed)
    picture = high_passed(sample.gray, sample.size)
    raw = mean_at_lags(picture, sample.size)
    zero = mean_at_lags(picture, sample.size, off=True)
    own = [
        mean_at_lags(high_passed(e.mean(axis=2), sample.size), sample.size)
        for e in sample.exemplars
        if min(e.shape[:2]) >= 2 * sample.size
    ]
    regular = float(np.mean(own)) if own else 0.0
    return {
        "repetition": raw - regular if regular >= REGULAR else raw,
        "repetition_raw": raw,
        "repetition_zero": zero,
        "repetition_own": regular,
        "same_place": _same_place(sample),
    }


def measure_diversity(material: TextureTiles | Sample, *, cells: int = 12, seed: int = 0) -> dict[str, float]:
    """How much of the exemplar the tile set holds.

    Returns
    -------
    dict of str to float
        ``used_share``: share of the exemplar's usable pixels that occur in the set.
        ``distinct_share``: distinct exemplar pixels in the set over all its pixels.
    """
    sample = as_sample(material, cells, seed)
    masks = sample.material.masks
    usable = sum(int(m.sum()) for m in masks) or sum(e[..., 0].size for e in sample.exemplars)
    distinct = len(np.unique(sample.places))
    return {"used_share": distinct / usable, "distinct_share": distinct / sample.places.size}


def high_passed(gray: Gray, size: int) -> Gray:
    """Less the low-pass of half a tile."""
    return gray - Blur(gray).low(size / 2)


def mean_at_lags(picture: Gray, size: int, off: bool = False) -> float:
    """Mean of `correlations` over all lags but none."""
    lags = correlations(picture, size, off)
    if not off:
        lags[0, lags.shape[1] // 2] = np.nan
        lags[0, : lags.shape[1] // 2] = np.nan  # the mirror image of the rest of the row
    return float(np.nanmean(lags))


def correlations(picture: Gray, size: int, off: bool = False) -> NDArray[np.float64]:
    """Correlation of a picture with itself at whole tiles; half a tile off along both axes if ``off``.

    Returns
    -------
    float64 array, shape (m + 1, 2 m + 1)
        Element (i, m + j) is the lag of i tiles south and j tiles east, m half the tiles a side.
    """
    fixed = _cells(picture, size)
    shift = size // 2 if off else 0
    moved = _cells(picture[shift:, shift:], size)
    rows, columns = moved.shape[:2]
    products = np.tensordot(fixed, moved, axes=(2, 2))  # [y, x, y', x']
    power, moved_power = (np.einsum("yxp,yxp->yx", c, c, dtype=float) for c in (fixed, moved))
    reach = len(fixed) // 2
    lags = np.full((reach + 1, 2 * reach + 1), np.nan)
    for i in range(reach + 1):
        for j in range(-reach, reach + 1):
            y, x = (
                np.arange(min(rows - i, len(fixed))),
                np.arange(max(0, -j), min(columns - j, fixed.shape[1])),
            )
            if not len(y) or not len(x):
                continue
            y, x = np.ix_(y, x)
            scale = power[y, x].sum() * moved_power[y + i, x + j].sum()
            lags[i, reach + j] = products[y, x, y + i, x + j].sum() / np.sqrt(scale) if scale > 0 else 0.0
    return lags


def _cells(picture: Gray, size: int) -> NDArray[np.float32]:
    """Whole cells as rows of pixels, shape (rows, columns, size^2)."""
    rows, columns = (n // size for n in picture.shape)
    whole = picture[: rows * size, : columns * size].reshape(rows, size, columns, size)
    return whole.swapaxes(1, 2).reshape(rows, columns, size * size)


def _same_place(sample: Sample) -> float:
    """Equal origins among all pairs of cells, from the lengths of runs in each sorted column."""
    places = np.sort(sample.places.reshape(len(sample.places), -1)[sample.indices.ravel()], axis=0)
    count = np.arange(len(places))[:, np.newaxis]
    starts = np.where(np.diff(places, axis=0, prepend=-1) != 0, count, 0)
    before = count - np.maximum.accumulate(starts, axis=0)  # earlier cells with the same origin
    pairs = len(places) * (len(places) - 1) / 2 * places.shape[1]
    return float(before.sum() / pairs)
