"""How much is seen of the tiles coming back."""

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, next_fast_len, rfft2
from scipy.ndimage import gaussian_filter

from tilewright.analysis.textures.sample import Sample


def tile_lag_autocorrelation(sample: Sample) -> tuple[float, float]:
    """Mean autocorrelation at whole-tile lags: of the tiling, and of the photograph at those lags.

    High-passed (sigma half a tile), mean over all lags up to half the sample, less the mean at half-tile
    lags. One tile repeated gives 1, tiles without a common pixel 0, C edge colors about 1/C. A regular
    photograph agrees with itself at such lags: subtract the second number.
    """
    n, half = sample.size, sample.cells.shape[0] // 2
    lags = _autocorrelation(sample.gray, n / 2)
    tile = [(i, j) for i in range(half + 1) for j in range(-half, half + 1) if (i, j) > (0, 0)]
    between = [lags[i * n + n // 2, j * n + n // 2] for i in range(half) for j in range(-half, half)]
    value = np.mean([lags[i * n, j * n] for i, j in tile]) - np.mean(between)
    return float(value), float(np.mean([_own(s[sample.material.main], n) for s in sample.material.sources]))


def _own(photo: NDArray[np.generic], n: int) -> float:
    """The same for a photograph, at the lags it reaches; 0 where it is too small."""
    lags = _autocorrelation(photo.astype(np.float32).mean(axis=2), n / 2)
    high, wide = (max(0, (s // 2) // n) for s in photo.shape[:2])
    at = [(i, j) for i in range(high + 1) for j in range(-wide, wide + 1) if (i, j) > (0, 0)]
    if not at:
        return 0.0
    between = [
        lags[i * n + n // 2, j * n + n // 2] for i in range(max(1, high)) for j in range(-wide, max(1, wide))
    ]
    return float(np.mean([lags[i * n, j * n] for i, j in at]) - np.mean(between))


def _autocorrelation(gray: NDArray[np.float32], sigma: float) -> NDArray[np.float64]:
    """Correlation at each lag, negative ones wrapped around; 1 at lag 0."""
    fine = gray - gaussian_filter(gray, sigma)
    size = tuple(next_fast_len(2 * s, real=True) for s in gray.shape)
    count = irfft2(np.abs(rfft2(np.ones_like(gray, dtype=float), size)) ** 2, size)
    lags = irfft2(np.abs(rfft2(fine.astype(float), size)) ** 2, size) / np.maximum(count, 1)
    return lags / lags[0, 0] if lags[0, 0] > 0 else lags


def same_place_share(sample: Sample) -> float:
    """Share of in-tile places with one origin in two different cells, mean over all pairs of cells.

    It needs no correlation, so it is fit for photographs that are periodic themselves.
    """
    tiles, counts = np.unique(sample.cells, return_counts=True)
    origins = sample.material.origins[tiles].astype(np.int64)
    flat = (origins[..., 0] << 40) + (origins[..., 1] << 20) + origins[..., 2]
    flat = flat.reshape(len(tiles), -1)
    total = sample.cells.size
    # At each place: cells with the same origin, counted with how often their tiles occur.
    order = np.argsort(flat, axis=0, kind="stable")
    ranked = np.take_along_axis(flat, order, axis=0)
    weight = counts[order].astype(np.int64)
    running = np.cumsum(weight, axis=0)
    last = np.ones_like(ranked, dtype=bool)
    last[:-1] = ranked[1:] != ranked[:-1]
    pairs = 0.0
    for place in range(flat.shape[1]):
        groups = np.diff(np.concatenate([[0], running[last[:, place], place]]))
        pairs += float((groups * (groups - 1)).sum())
    return pairs / flat.shape[1] / (total * (total - 1))


def lattice_share(sample: Sample) -> float:
    """Share of the low-passed variance (sigma an eighth of a tile) that is the same in every tile.

    This is the lattice seen from afar; 0 is good.
    """
    n = sample.size
    low = gaussian_filter(sample.gray, n / 8, mode="reflect")
    rows, columns = sample.cells.shape
    mean_tile = low.reshape(rows, n, columns, n).mean(axis=(0, 2))
    # The mean of many tiles keeps some chance variance; that part is taken off.
    total = float(low.var())
    chance = total / sample.cells.size
    return max(0.0, float((mean_tile.var() - chance) / total)) if total > 0 else 0.0
