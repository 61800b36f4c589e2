"""Points spread over a grid, for Fourier sums of points that lie anywhere."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel()
def spread_points(x, y, strengths, width, beta, grid):
    """Add each point to the ``width`` x ``width`` nodes around it, with the weights of a narrow bump.

    x, y : float64 (n,), in steps of the grid, 0 up to its size. strengths : complex128 (n,). width : nodes
    along a side. beta : how narrow the bump is, exp(beta (sqrt(1 - z^2) - 1)) for z from -1 to 1. grid :
    complex128 (rows, columns), periodic; y counts rows, x columns.
    """
    rows, columns = grid.shape
    across = np.empty(width)
    for n in range(x.size):
        left = np.int64(np.ceil(x[n] - width / 2))
        top = np.int64(np.ceil(y[n] - width / 2))
        for k in range(width):
            z = 2 * (left + k - x[n]) / width
            across[k] = np.exp(beta * (np.sqrt(max(0.0, 1 - z * z)) - 1))
        for i in range(width):
            z = 2 * (top + i - y[n]) / width
            along = strengths[n] * np.exp(beta * (np.sqrt(max(0.0, 1 - z * z)) - 1))
            row = grid[(top + i) % rows]
            for k in range(width):
                row[(left + k) % columns] += along * across[k]
