"""Pictures from scattered samples: each sample is spread over the pixels around it."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel(inline=True)
def weigh_mitchell(t):
    """Cubic filter of Mitchell & Netravali 1988 with B = C = 1/3 at distance ``t``, in pixels."""
    t = abs(t)
    if t < 1.0:
        return ((7.0 * t - 12.0) * t * t + 16.0 / 3.0) / 6.0
    if t < 2.0:
        return (((-7.0 / 3.0 * t + 12.0) * t - 20.0) * t + 32.0 / 3.0) / 6.0
    return 0.0


@kernel()
def splat_samples(x, y, values, sums, weights):
    """Add samples, times the filter's weight, to the pixels within two pixels of each.

    x, y : float64 (n,), in pixels; pixel (i, j) has its center at y = i + 0.5, x = j + 0.5. values :
    float64 (n,). sums, weights : float64 (h, w), added to, in the order of the samples.
    """
    h, w = sums.shape
    across = np.empty(4)
    for p in range(x.size):
        left = np.int64(np.floor(x[p] - 1.5))
        top = np.int64(np.floor(y[p] - 1.5))
        for b in range(4):
            across[b] = weigh_mitchell(left + b + 0.5 - x[p])
        for a in range(4):
            i = top + a
            if i < 0 or i >= h:
                continue
            down = weigh_mitchell(i + 0.5 - y[p])
            for b in range(4):
                j = left + b
                if j < 0 or j >= w:
                    continue
                weight = down * across[b]
                sums[i, j] += weight * values[p]
                weights[i, j] += weight
