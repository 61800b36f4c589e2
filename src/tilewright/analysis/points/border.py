"""How evenly points fill their tiles: density by the distance from the tile's border."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, check_type
from tilewright.errors import TilewrightValueError
from tilewright.signals.points.point_tiles import PointTiles


@dataclass(frozen=True, eq=False)
class BorderDensity:
    """Density near the border of a tile over the mean density; 1 everywhere for an even set.

    Attributes
    ----------
    distance : float64 array, shape (bins + 1,)
        Ends of the bins, 0 to 0.5 tile lengths.
    edge : float64 array, shape (bins,)
        Density at these distances from the nearest edge.
    corner : float64 array, shape (bins,)
        Density at these distances from the nearest corner.
    """

    distance: NDArray[np.float64]
    edge: NDArray[np.float64]
    corner: NDArray[np.float64]


def border_density(tiles: PointTiles, bins: int = 10) -> BorderDensity:
    """Measure density as a function of the distance from the border, mean over all tiles.

    Shows what is wrong with sets whose borders leave less room (Cohen et al. 2003, figure 9), and with any
    other. All tiles count alike, as in the random tilings of most sets. n points in a bin have a standard
    error of sqrt(n) or less; take means over seeds where that matters.

    Parameters
    ----------
    tiles : PointTiles
        A set that holds points.
    bins : int, optional
        Number of bins of equal width, 1 to 10,000; default 10.

    Returns
    -------
    BorderDensity
        ``distance``, the ends of the bins in tile lengths, and the density ``edge`` and ``corner`` in each,
        over the mean density.

    Raises
    ------
    TilewrightTypeError
        Something else than point tiles.
    TilewrightValueError
        The tiles hold no points, or the number of bins is out of range.
    """
    check_type("tiles", tiles, PointTiles, "PointTiles")
    if not len(tiles.points):
        raise TilewrightValueError("has no points; there is no density to measure", argument="tiles")
    distance = np.linspace(0, 0.5, check_int("bins", bins, 1, 10_000) + 1)
    # How far each point is from the nearest lattice line in x and in y.
    gaps = np.minimum(tiles.points, 1 - tiles.points).astype(np.float64)
    edge_areas = np.diff(1 - (1 - 2 * distance) ** 2)
    corner_areas = np.diff(np.pi * distance**2)
    edge, corner = (
        np.histogram(d, distance)[0] / (len(gaps) * areas)
        for d, areas in ((gaps.min(axis=1), edge_areas), (np.hypot(*gaps.T), corner_areas))
    )
    return BorderDensity(distance, edge, corner)
