"""Averages over rings of a centered plane of frequencies."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel(inline=True)
def find_annulus(fy, fx):
    """Index of the ring of width 1 around radius 0, 1, 2 ... that holds a frequency."""
    return np.int64(np.sqrt(fy * fy + fx * fx) + 0.5)


@kernel()
def average_annuli(power, step_y, step_x, counts, means, variances):
    """Mean and sample variance of ``power`` in rings of width 1 (Lagae 2007, eq. 6.3 and 6.5).

    power : float64 (h, w), frequency 0 at [h // 2, w // 2]. step_y, step_x : frequency from one row, one
    column, to the next. counts : int64 (n,), means, variances : float64 (n,), filled with the samples of
    each ring and their figures; NaN where a ring has too few.
    """
    h, w = power.shape
    n = counts.size
    counts[:] = 0
    means[:] = 0.0
    variances[:] = 0.0
    for i in range(h):
        for j in range(w):
            ring = find_annulus((i - h // 2) * step_y, (j - w // 2) * step_x)
            if ring < n:
                counts[ring] += 1
                means[ring] += power[i, j]
    for ring in range(n):
        means[ring] = means[ring] / counts[ring] if counts[ring] > 0 else np.nan
    for i in range(h):
        for j in range(w):
            ring = find_annulus((i - h // 2) * step_y, (j - w // 2) * step_x)
            if ring < n:
                off = power[i, j] - means[ring]
                variances[ring] += off * off
    for ring in range(n):
        variances[ring] = variances[ring] / (counts[ring] - 1) if counts[ring] > 1 else np.nan
