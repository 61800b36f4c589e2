"""Dual tiles laid on a mesh: the points of all tiles, and which of them are kept.

A point of rank q is kept where the share of points that its place needs is more than q. Over the whole
surface that is "the N smallest of q over the share", so that the number of points is exact.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.domains import Spots
from tilewright.domains.curve import morton_numbers
from tilewright.domains.medial import MedialDomain, mix
from tilewright.errors import TilewrightValueError
from tilewright.fields.surfaces.density import Weighting
from tilewright.seeds import derive_key, make_key
from tilewright.tilings.surface_tiling import SurfaceTiling

if TYPE_CHECKING:
    from tilewright.signals.points.dual import DualPointTiles

FEWEST, MOST = 12, 64
"""Points of a tile of four corners: with fewer the frame does not fit, with more the mesh is subdivided."""
_MARGIN = 1.25
"""How much larger than on average the share of a place may be taken before points are compared."""
_OPEN = 1.05
"""How many more points than needed are made where the surface is open."""
_MOST_SIDES = 2**19
"""Sides of faces beyond which a mesh is not subdivided for the sake of a density."""
_SPARSE = 2.0
"""Points a tile, in the median, below which tiles take turns in rounding up rather than throw lots."""


Rows = tuple[NDArray[np.int64], NDArray[np.uint8], NDArray[np.float32]]
"""Where the points of distinct tiles start, their sectors, and where they lie in them."""


@dataclass(frozen=True, eq=False)
class Laid:
    """Points of tiles on a surface.

    Attributes
    ----------
    spots : Spots
    tiles : int64 array, shape (n,)
        The tile each belongs to: faces of the domain, then vertices.
    numbers : int32 array, shape (n,)
        Its number in the tile.
    keys : float64 array, shape (n,)
        Its rank over the share of points that its place needs.
    """

    spots: Spots
    tiles: NDArray[np.int64]
    numbers: NDArray[np.int32]
    keys: NDArray[np.float64]

    def keep(self, count: int) -> "Laid":
        """The points of the smallest keys, in their order."""
        order = np.lexsort((self.numbers, self.tiles, self.keys))[:count]
        return Laid(self.spots[order], self.tiles[order], self.numbers[order], self.keys[order])


def fit_domain(domain: MedialDomain, count: int, weighting: Weighting | None) -> tuple[MedialDomain, int]:
    """The domain subdivided, and points a tile, so that no place needs more points than its tile has."""
    while True:
        loads = _find_loads(domain, weighting)
        # Sectors of equal loads would each need a quarter of the points of a tile.
        full = 4 * count * _almost_all(loads) / max(loads.sum(), 1e-300)
        if (domain.half_edges.twins < 0).any():
            full *= _OPEN  # what tiles on the boundary hold varies with what is cut off
        points = max(FEWEST, int(np.ceil(full / 8 - 1e-9)) * 8)
        if points <= MOST and loads.any():
            return domain, points
        if weighting is not None and len(domain.half_edges) > _MOST_SIDES + count:
            raise TilewrightValueError(
                "lies almost all in so small a part of the surface that it would take too many tiles",
                argument="density",
                advice="use a mesh that is finer there",
            )
        domain = domain.subdivide()


def _almost_all(loads: NDArray[np.float64]) -> float:
    """The load that is passed by sectors of a thousandth of all loads only."""
    order = np.sort(loads)
    return float(order[np.searchsorted(np.cumsum(order), 0.999 * order.sum())])


def _find_loads(domain: MedialDomain, weighting: Weighting | None) -> NDArray[np.float64]:
    """How many points each sector wants, in any unit."""
    areas = domain.sector_areas
    return areas if weighting is None else areas * _scaled(weighting.at(domain.sector_middles))


def _scaled(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Numbers whose largest is 1, so that no sum is too large."""
    most = float(values.max())
    return values / most if most > 0 else values


def lay(tiling: SurfaceTiling, tiles: "DualPointTiles", count: int, weighting: Weighting | None) -> Laid:
    """Points of all tiles of which the ``count`` of the smallest keys are wanted, and some more."""
    domain = tiling.domain
    kinds, turns, rows = _find_rows(tiling, tiles)
    # Points wanted over points there in each sector, were its parameter polygon the surface itself.
    shares = domain.flat_areas * 4 * count / (domain.sound.cut.surface.area * tiles.points)
    spots, owners, numbers, sectors = _place(domain, (kinds, turns, rows), shares, weighting)
    # Step 1: the share of its tile's points that each place needs.
    needs = shares[sectors] * domain.sound.cut.stretches[spots.triangles]
    if weighting is not None:
        dense = _scaled(weighting.at(spots))
        needs *= dense * (needs.sum() / (needs * dense).sum())
    # Step 2: a rank for every point, moved within its tile so that tiles do not round alike.
    held = np.diff(rows[0])[kinds]
    jitter = _jitter(tiling, count, weighting)
    with np.errstate(divide="ignore", over="ignore"):  # where no points are wanted
        keys = (numbers + 0.5 + jitter[owners]) / held[owners] / needs
    if np.isfinite(keys).sum() < count:
        raise TilewrightValueError(
            f"is {count:,}; tiles gave {int(np.isfinite(keys).sum()):,} points where density is above 0",
            argument="count",
            value=count,
        )
    return Laid(spots, owners, numbers, keys)


def _find_rows(
    tiling: SurfaceTiling, tiles: "DualPointTiles"
) -> tuple[NDArray[np.int64], NDArray[np.int64], Rows]:
    """The row and the turn of every tile, and the points of all distinct rows."""
    from tilewright.tiles.dual import canonical_slots

    starts, slots = tiling.domain.tile_starts, tiling.slots
    sizes = np.diff(starts)
    kinds, turns = np.empty(len(sizes), np.int64), np.empty(len(sizes), np.int64)
    made, before = [], 0
    for corners in np.unique(sizes).tolist():
        which = np.flatnonzero(sizes == corners)
        words, turns[which] = canonical_slots(slots[starts[which, np.newaxis] + np.arange(corners)])
        distinct, inverse = np.unique(words, axis=0, return_inverse=True)
        kinds[which] = before + inverse.ravel()
        before += len(distinct)
        made.append(tiles.rows(distinct))
    counts = np.concatenate([np.diff(row.starts) for row in made])
    return (
        kinds,
        turns,
        (
            np.concatenate([[0], np.cumsum(counts)]),
            np.concatenate([row.sectors for row in made]),
            np.concatenate([row.points for row in made]),
        ),
    )


def _place(
    domain: MedialDomain,
    laid: tuple[NDArray[np.int64], NDArray[np.int64], Rows],
    shares: NDArray[np.float64],
    weighting: Weighting | None,
) -> tuple[Spots, NDArray[np.int64], NDArray[np.int32], NDArray[np.int64]]:
    """Spots, tiles, numbers and sectors of all points that may be among the smallest keys."""
    from tilewright.kernels.dual_laying import lay_tiles

    kinds, turns, rows = laid
    cut = domain.sound.cut
    # Step 1: how many of its points a sector may need at most; with densities all of them are looked at.
    most = np.full(len(shares), np.inf)
    if weighting is None:
        stretch = np.maximum.reduceat(cut.stretches, cut.starts[:-1])
        most = _MARGIN * shares * stretch[domain.sector_bases] + 1.0 / FEWEST
    # Step 2: count, then place.
    tiles = (domain.tile_starts, domain.sectors, turns, kinds)
    below = (domain.sector_bases, domain.triangles, cut.starts)
    counts = np.zeros(len(kinds), np.int32)
    places = np.zeros(len(kinds), np.int64)
    for n in (0, 1):
        total = int(places[-1] + counts[-1]) * n
        out = (
            np.empty(total, np.int32),
            np.empty(total, np.int64),
            np.empty(total, np.int32),
            np.empty((total, 3)),
            counts,
        )
        lay_tiles(len(kinds), tiles, rows, below, cut.uv, most, places, out)
        places = np.cumsum(counts, dtype=np.int64) - counts
    numbers, sectors, triangles, weights, _ = out
    return Spots(triangles, weights), np.repeat(np.arange(len(kinds)), counts), numbers, sectors


def _jitter(tiling: SurfaceTiling, count: int, weighting: Weighting | None) -> NDArray[np.float64]:
    """By how much of a point each tile rounds up or down, from -0.5 to 0.5."""
    domain = tiling.domain
    loads = _find_loads(domain, weighting)
    wanted = np.bincount(domain.sector_tiles, loads * (count / loads.sum()), len(domain.tile_names))
    lots = mix(domain.tile_names ^ derive_key(make_key(tiling.seed), 18))
    units = (lots >> np.uint64(11)).astype(np.float64) / 2**53
    if np.median(wanted) >= _SPARSE:
        return units - 0.5
    # Tiles of a point or none take turns along a curve that keeps neighbors together.
    places = np.zeros((len(units), 3))
    places[domain.sector_tiles] = domain.sector_middles.positions(domain.sound.cut.surface)
    order = np.argsort(morton_numbers(places), kind="stable")
    running = np.empty(len(units))
    running[order] = np.cumsum(wanted[order]) - wanted[order]
    return 0.5 - (running + units[0]) % 1.0
