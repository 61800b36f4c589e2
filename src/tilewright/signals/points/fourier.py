"""Fourier sums of points that lie anywhere: by finufft where it is installed, else by our own transform.

Both spread the points over a fine grid, transform that, and divide by the transform of what they were spread
with (Barnett, Magland & af Klinteberg 2019). Ours is here so that everything can be measured without finufft;
tiles are made with finufft only, for the same tiles must come out everywhere.
"""

import numpy as np
from numpy.typing import NDArray

from tilewright.extras import has_package

_NODES = 12
"""Nodes along a side over which a point is spread: about 1e-10 of the sum of the strengths is lost."""
_BETA = 2.30 * _NODES
_QUADRATURE = 64


def fourier_sums(
    y: NDArray[np.floating], x: NDArray[np.floating], strengths: NDArray[np.complexfloating],
    shape: tuple[int, int], tolerance: float, upsampling: float = 0.0,
) -> NDArray[np.complexfloating]:  # fmt: skip
    """sum_j strengths[j] exp(-i (ky y[j] + kx x[j])), shape (rows, columns), ky = -(rows // 2) and on.

    y, x : radians. tolerance : relative to the sum of the strengths. upsampling : finufft's, 0 for its own
    choice. One thread, so that sums have one order.
    """
    if not has_package("finufft"):
        return _own_sums(y, x, strengths, shape)
    import finufft

    sums: NDArray[np.complexfloating] = finufft.nufft2d1(
        y, x, strengths, shape, eps=tolerance, isign=-1, nthreads=1, upsampfac=upsampling
    )
    return sums


def _own_sums(
    y: NDArray[np.floating],
    x: NDArray[np.floating],
    strengths: NDArray[np.complexfloating],
    shape: tuple[int, int],
) -> NDArray[np.complex128]:
    from scipy.fft import fft2, next_fast_len

    from tilewright.kernels.nufft import spread_points

    sizes = [next_fast_len(max(2 * modes, 2 * _NODES)) for modes in shape]
    grid = np.zeros(sizes, np.complex128)
    rows, columns = (
        np.ascontiguousarray(np.mod(angle / (2 * np.pi), 1.0) * size, np.float64)
        for angle, size in zip((y, x), sizes, strict=True)
    )
    spread_points(columns, rows, np.ascontiguousarray(strengths, np.complex128), _NODES, _BETA, grid)
    full = fft2(grid, overwrite_x=True, workers=1)
    ky, kx = (np.arange(modes) - modes // 2 for modes in shape)
    found = full[np.ix_(ky, kx)]
    found /= _bump(ky, sizes[0])[:, np.newaxis]
    found /= _bump(kx, sizes[1])
    return found


def _bump(frequencies: NDArray[np.int64], size: int) -> NDArray[np.float64]:
    """The transform of what points are spread with, by Gauss-Legendre quadrature."""
    z, weights = np.polynomial.legendre.leggauss(_QUADRATURE)
    bump = weights * np.exp(_BETA * (np.sqrt(1 - z * z) - 1)) * _NODES / 2
    turns = np.cos(np.pi * _NODES / size * np.outer(frequencies, z))
    total: NDArray[np.float64] = (turns * bump).sum(axis=1)
    return total
