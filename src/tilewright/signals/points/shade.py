"""Dart throwing over a set of Wang tiles, with the flaw it has (Shade, Cohen & Mitchell 2000)."""

from math import pi, sqrt

import numpy as np

from tilewright.checks import check_int, check_real
from tilewright.errors import Progress, TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import most_points
from tilewright.samplers.radius import max_radius
from tilewright.seeds import Seed, make_key
from tilewright.signals.points.neighborhood import OFFSETS, Neighbors
from tilewright.signals.points.point_tiles import PointTiles
from tilewright.tiles import TileSet, cohen_tiles

_FULL_COVER = 0.547
"""Share of a plane that disks cover when darts find no more room: random sequential adsorption."""
_BATCH = 2**16
_MOST_POINTS = 2**16


def shade_tiles(
    tiles: TileSet | None = None,
    points: int = 32,
    rho: float = 0.7,
    *,
    failures: int = 100_000,
    seed: Seed = 0,
    progress: Progress | None = None,
) -> PointTiles:
    """Poisson disk tiles by dart throwing (Shade, Cohen & Mitchell 2000; Lagae 2007, section 6.6).

    A dart that hits a tile stays if it keeps its distance from all points of the tile and of every tile that
    can lie beside it, across an edge or a corner. So it does in every tiling. But points near a border rule
    out places in many tiles at once, and a gap beside one neighbor cannot be filled for the sake of another:
    fewer points come to lie near edges, and fewest near corners (Cohen et al. 2003, figure 9; measure it with
    `border_density`). A full set of 8 tiles has a relative radius of 0.756 for the points that it has, where
    darts in a plane come to 0.777, that is 5 % more points; sets of more tiles are worse.

    Parameters
    ----------
    tiles : TileSet, optional
        Square tiles; Cohen's 8 Wang tiles by default.
    points : int
        Number of points in each tile for which the distance is made. Tiles are filled until there is no room,
        which at ``rho`` 0.756 is at about this number.
    rho : float
        Relative radius for this number of points, 0 up to 1.
    failures : int
        Darts missing in a row after which a set counts as full.
    seed : int or numpy Generator
    progress : callable, optional
        Called with the misses in a row.

    Returns
    -------
    PointTiles
        Tiles differ in how many points they have. Ranks are in the order of the darts. Figures: ``points``,
        the mean number of them; ``plane``, how many of the darts in a plane would stay at the same distance;
        ``rho``, the relative radius for the mean number; ``darts`` thrown.

    Raises
    ------
    TilewrightValueError
        A distance of more than a tile, or tiles that are not square.
    """
    # Step 1: for each tile, all tiles that can lie beside it, across an edge or a corner.
    given = cohen_tiles(8) if tiles is None else tiles
    neighbors = Neighbors.of(given)
    asked = check_int("points", points, 1, _MOST_POINTS)
    fraction = check_real("rho", rho, 1e-3, 1.0)
    patience = check_int("failures", failures, 1, 10**9)
    distance = 2 * fraction * max_radius(asked, Box())
    if distance > 1:
        raise TilewrightValueError(
            f"is {rho}; the distance for {asked} points would be more than a tile",
            argument="rho",
            value=rho,
            advice="ask for more points",
        )
    from tilewright.kernels.wang_points import throw_tile_darts

    # Step 2: throw darts at all tiles; one stays if it keeps its distance from the points of its own tile and
    # of every possible neighbor (Lagae 2007, section 6.6), until none has stayed for long.
    key, (starts, members) = make_key(seed), neighbors.lists()
    placed = np.empty((len(given), most_points(distance, Box(torus=False), 16 * len(given)), 2))
    counts = np.zeros(len(given), np.int64)
    thrown = missed = 0
    while missed < patience:
        if progress is not None:
            progress(missed, patience, "throwing darts at tiles")
        thrown, missed = throw_tile_darts(
            key, _BATCH, thrown, missed, patience, distance, OFFSETS, starts, members, placed, counts
        )
    # Step 3: tiles have as many points as their neighbors left room for.
    mean = float(counts.mean())
    return PointTiles.of(
        given,
        [row[:count] for row, count in zip(placed, counts, strict=True)],
        distance=distance,
        method="shade",
        recipe={"points": asked, "rho": fraction, "failures": patience, "seed": int(key)},
        figures={
            "points": mean,
            "plane": _FULL_COVER / (pi * (distance / 2) ** 2),
            "rho": distance / 2 / max_radius(1, Box()) * sqrt(mean),
            "darts": thrown,
        },
    )
