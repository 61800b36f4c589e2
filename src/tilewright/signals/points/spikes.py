"""Spikes: what repeats from tile to tile shows in the spectrum at the frequencies of the tile lattice.

In a plane of T tiles the power at an integer frequency k, in cycles per tile, is on average
T |m(k)|^2 / N, with m(k) the mean over all tiles of sum exp(-2 pi i k x) over their N points. So the
height of every spike follows from the set alone, and |m(k)|^2 / N tells it for any T.
"""

from dataclasses import dataclass
from math import ceil, sqrt

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_type
from tilewright.errors import TilewrightValueError
from tilewright.signals.points.fourier import fourier_sums
from tilewright.signals.points.point_tiles import PointTiles

_USUAL_POINTS = 16384
"""Points of the sets that the literature compares; their periodograms have 1024 x 1024 frequencies."""
_WINDOW = 4.0
"""Half the width of a periodogram (Lagae 2007, section 6.2.2), in units of the square root of N."""


def window_reach(points: float) -> int:
    """Frequencies of the tile lattice, to either side, within the periodogram of `_USUAL_POINTS` points."""
    return ceil(_WINDOW * sqrt(points))


def mean_spectrum(
    points: NDArray[np.floating], weights: NDArray[np.floating], reach: int
) -> NDArray[np.complex128]:
    """m(k) for |kx|, |ky| <= reach, shape (2 reach + 1, 2 reach + 1), [x, y]; m(0) is set to 0.

    points : shape (P, 2), in tile lengths, modulo 1; weights : shape (P,).
    """
    size = 2 * reach + 2
    if not len(points):
        return np.zeros((size - 1, size - 1), np.complex128)
    angle = (2 * np.pi * (points % 1.0)).astype(np.float32)
    x, y = np.ascontiguousarray(angle[:, 0]), np.ascontiguousarray(angle[:, 1])
    strengths = weights.astype(np.complex64)
    full = fourier_sums(x, y, strengths, (size, size), 1e-5)
    spectrum = full[1:, 1:].astype(np.complex128)
    spectrum[reach, reach] = 0
    return spectrum


def frequencies(reach: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """kx and ky of a spectrum, each shape (2 reach + 1, 2 reach + 1), [x, y]."""
    k = np.arange(-reach, reach + 1)
    return np.broadcast_to(k[:, np.newaxis], (len(k),) * 2), np.broadcast_to(k, (len(k),) * 2)


@dataclass(frozen=True)
class Spikes:
    """The highest spikes in the spectrum of a set of point tiles.

    A spike is told as |m|^2 / N; times the number of tiles of a plane it is the spike's height there.

    Attributes
    ----------
    window : float
        The highest spike within the periodogram of 16,384 points.
    doubled : float
        The highest spike within twice the width of that periodogram.
    floor : float
        The sum of w^2 / N: what a spectrum of these points comes to on average over all frequencies.
    """

    window: float
    doubled: float
    floor: float

    @staticmethod
    def usual_tiles(points: float) -> int:
        """Tell how many tiles, in a square, hold about 16,384 points.

        Parameters
        ----------
        points : float
            Points per tile.

        Returns
        -------
        int
            A square number of tiles: 23^2 = 529 for 32 points per tile, 256 for 64.
        """
        return round(sqrt(_USUAL_POINTS / points)) ** 2


def find_spikes(tiles: PointTiles) -> Spikes:
    """Find the spikes that the spectrum of every tiling with a set has, all its tiles being equally frequent.

    Parameters
    ----------
    tiles : PointTiles
        A set that holds points.

    Returns
    -------
    Spikes
        The highest spikes, for each tile of a plane.

    Raises
    ------
    TilewrightTypeError
        Something else than point tiles.
    TilewrightValueError
        The tiles hold no points.

    Notes
    -----
    In a plane of T tiles the power at an integer frequency k, in cycles per tile, is on average
    T |m(k)|^2 / N, with m(k) the mean over all tiles of the sum of exp(-2 pi i k . x) over their N points.
    So the height of every spike follows from the set alone.
    """
    check_type("tiles", tiles, PointTiles, "PointTiles")
    n = tiles.density
    if n == 0:
        raise TilewrightValueError("the tiles hold no points, so they have no spectrum")
    weights = np.full(len(tiles.points), 1 / (len(tiles.starts) - 1))
    inner = window_reach(n)
    reach = 2 * inner
    power = np.abs(mean_spectrum(tiles.points, weights, reach)) ** 2 / n
    middle = slice(reach - inner, reach + inner + 1)
    _, shared = np.unique(tiles.points, axis=0, return_counts=True)
    floor = float(((shared / (len(tiles.starts) - 1)) ** 2).sum() / n)
    return Spikes(float(power[middle, middle].max()), float(power.max()), floor)
