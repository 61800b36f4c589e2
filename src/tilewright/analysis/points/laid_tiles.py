"""Point tiles, measured on tilings by chance (Lagae 2007, sections 6.6 to 6.14)."""

from math import sqrt

from tilewright.analysis.points.report import PointReport, analyze_points
from tilewright.checks import check_type
from tilewright.errors import Progress, TilewrightValueError
from tilewright.fields import PointField
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet
from tilewright.signals.points import PointTiles, Spikes, find_closeness, find_spikes
from tilewright.tilings import stochastic
from tilewright.tilings.algorithms import recognize
from tilewright.tilings.direct_tiling import direct

SPECTRUM_POINTS = 16384
PLATE_POINTS = 262144
_SETS = 10


def lay_square(tiles: PointTiles, points: int, seed: int) -> PointSet:
    """Lay a square of point tiles that holds about ``points`` points.

    Parameters
    ----------
    tiles : PointTiles
        The points of each tile.
    points : int
        Number of points that the square should hold; the nearest square of whole tiles is taken.
    seed : int
        Seed of the tiling.

    Returns
    -------
    PointSet
        Points in tile lengths, on a torus where the set has a direct tiling and on a plain box elsewhere.
    """
    side = max(1, round(sqrt(points / max(tiles.density, 1e-9))))
    if recognize(tiles.tiles) is not None:
        return PointField(tiles, direct(tiles.tiles, seed, period=(side, side))).torus()
    field = PointField(tiles, stochastic(tiles.tiles, side, side, seed))
    box = Box((float(side), float(side)), torus=False)
    return PointSet(field.points(0, 0, side, side), box, f"{tiles.method} tiles", tiles.distance)


def analyze_point_tiles(
    tiles: PointTiles,
    *,
    sets: int = _SETS,
    seed: int = 0,
    name: str | None = None,
    progress: Progress | None = None,
) -> PointReport:
    """Measure a set of point tiles: its promise and spikes, and squares of 16,384 points laid with it.

    The zone plate is sampled with a square of 262,144 points (Lagae 2007, sections 6.6 to 6.14).

    Parameters
    ----------
    tiles : PointTiles
        A set that holds points.
    sets : int, optional
        How many squares are measured; default 10.
    seed : int, optional
        Seed of the first tiling; default 0.
    name : str, optional
        What to call the method; by default the set's own word for it.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    PointReport
        Figures of the points, and of the set itself.

    Raises
    ------
    TilewrightTypeError
        Something else than point tiles.
    TilewrightValueError
        The tiles hold no points.
    """
    check_type("tiles", tiles, PointTiles, "PointTiles")
    if not len(tiles.points):
        raise TilewrightValueError("the tiles hold no points; there is nothing to measure")
    laid = [lay_square(tiles, SPECTRUM_POINTS, seed + k) for k in range(sets)]
    plate = lay_square(tiles, PLATE_POINTS, seed + sets)
    report = analyze_points(laid, plate=plate, name=name, progress=progress)
    close, spikes = find_closeness(tiles), find_spikes(tiles)
    report.figures.update(
        tiles=float(len(tiles.starts) - 1),
        points_per_tile=tiles.density,
        promised_rho=close.rho,
        intra_rho=close.intra_rho,
        spike_window=spikes.window,
        spike_doubled=spikes.doubled,
        spike_height=spikes.window * Spikes.usual_tiles(tiles.density),
    )
    return report
