"""Poisson disk tiles: points over a tile set that keep their distance in every tiling."""

from dataclasses import asdict

import numpy as np

from tilewright.checks import check_choice, check_int, check_real
from tilewright.errors import Progress, TilewrightValueError
from tilewright.extras import need_package
from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius
from tilewright.seeds import Seed, derive_key, make_key
from tilewright.signals.points.balance import balance, settle
from tilewright.signals.points.frames import grow_frame
from tilewright.signals.points.plan import Parts, Plan, fill_interiors
from tilewright.signals.points.point_tiles import PointTiles
from tilewright.signals.points.promise import find_closeness
from tilewright.signals.points.ranks import rank_points
from tilewright.signals.points.spikes import find_spikes
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tiles.variants import Variants

METHODS = ("balanced", "relaxed")
_FEWEST, _MOST = 8, 256
_LARGEST_RHO = {"balanced": 0.85, "relaxed": 0.87}
_MOST_TILES, _MOST_INTERIORS = 4096, 65536
_LLOYD = 16
_TRIES, _ATTEMPTS = 4, 50


def poisson_tiles(
    tiles: TileSet,
    points: int = 32,
    rho: float = 0.75,
    *,
    method: str = "balanced",
    variants: int = 1,
    seed: Seed = 0,
    progress: Progress | None = None,
) -> PointTiles:
    """Make Poisson disk tiles: N points in every tile, none closer than 2 rho r_max in any tiling.

    Parameters
    ----------
    tiles : TileSet
        `corner_tiles` (Lagae & Dutré 2006, section 7; Lagae 2007, section 4.5), or `crossed_wang_tiles` for
        edge-based tiles (Lagae 2007, section 4.3). ``corner_tiles(1)`` with ``variants`` makes a set of
        template tiles (section 4.4). At most 4,096 tiles.
    points : int, optional
        Points per tile N, 8 to 256; default 32.
    rho : float, optional
        Relative radius, above 0 and up to what the method reaches; default 0.75. The least distance is
        2 rho r_max, with r_max = (2 sqrt(3) N)^(-1/2) tile lengths.
    method : str, optional
        ``"balanced"`` (default): small corner regions, points pushed apart, and all of them moved until no
        frequency of the tile lattice stands out. ``"relaxed"``, the papers' construction: octagonal corner
        regions, relaxation dart throwing, 16 iterations of Lloyd's method; what is then still too close is
        pushed apart rather than made anew.
    variants : int, optional
        Interchangeable interiors of every tile; default 1.
    seed : int or numpy Generator, optional
        The same seed gives the same points; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop, which leaves nothing
        behind.

    Returns
    -------
    PointTiles
        Point tiles with ranks. Their ``figures`` hold the closeness found over all admissible neighborhoods
        (see `find_closeness`) and the spikes (see `find_spikes`).

    Raises
    ------
    TilewrightTypeError
        An argument of another type.
    TilewrightValueError
        The disks are too large for a tile, or rho cannot be reached.
    MissingExtra
        The package finufft is not installed.

    Examples
    --------
    >>> import tilewright as tw
    >>> blue = tw.poisson_tiles(tw.corner_tiles(2), points=16, rho=0.7, method="relaxed", seed=1)
    >>> len(blue.tiles), blue.density
    (16, 16.0)
    >>> blue.tile(0).shape
    (16, 2)
    """
    check_tiles("tiles", tiles)
    if len(tiles) > _MOST_TILES:
        raise TilewrightValueError(
            f"has {len(tiles)} tiles; at most {_MOST_TILES} can be filled, those of 8 corner colors",
            argument="tiles",
            value=len(tiles),
        )
    points = check_int("points", points, _FEWEST, _MOST, "more points lie in more tiles")
    check_choice("method", method, METHODS)
    variants = check_int("variants", variants, 1, max(1, _MOST_INTERIORS // len(tiles)))
    if len(tiles) * variants == 1:
        raise TilewrightValueError(
            "has a single tile, which would repeat", argument="tiles", advice="take more colors, or variants"
        )
    rho = check_real("rho", rho, 0.0, 1.0)
    if not 0 < rho <= _LARGEST_RHO[method]:
        raise TilewrightValueError(
            f"is {rho}; {method} tiles reach more than 0 and up to {_LARGEST_RHO[method]}",
            argument="rho",
            value=rho,
        )
    need_package("finufft", "making point tiles")
    key = make_key(seed)
    for attempt in range(_TRIES):
        tried = derive_key(key, attempt)
        plan = Plan.of(tiles, points, rho, variants, tried, *_STYLES[method])
        parts = _build(plan, method == "balanced", progress)
        if parts is not None:
            return _finish(plan, parts, rho, method, seed, progress)
    raise TilewrightValueError(
        f"is {rho}; some of the {len(tiles)} tiles found no room for {points} points in {_TRIES} "
        "trials; 0.85 can be reached with 16 points and more, 0.80 with 12",
        argument="rho",
        value=rho,
    )


_STYLES = {"balanced": ("cusp", 0), "relaxed": ("octagon", _LLOYD)}


def _build(plan: Plan, is_balanced: bool, progress: Progress | None) -> Parts | None:
    """The points of all parts, or None where a tile found no room for its points."""
    parts = Parts.empty(plan)
    grow_frame(plan, parts, choose=is_balanced, progress=progress)
    if progress is not None:
        progress(0, 1, "filling the tiles")
    if fill_interiors(plan, parts, np.arange(len(parts.inner)), 0, _ATTEMPTS):
        return None
    if is_balanced:
        balance(plan, parts, progress)
        if settle(plan, parts, 1):
            return None
    return parts


def _finish(
    plan: Plan, parts: Parts, rho: float, method: str, seed: Seed, progress: Progress | None
) -> PointTiles:
    """Ranks, the check of the promise, and the figures."""
    if progress is not None:
        progress(0, 1, "ranking and checking")
    rows, numbers = parts.tile_points(plan)
    starts = np.concatenate([[0], np.cumsum([len(row) for row in rows])]).astype(np.int64)
    ranks = rank_points(
        plan.tiles, plan.variants, np.concatenate(rows), starts, np.concatenate(numbers), plan.key
    )
    distance = 2 * rho * max_radius(plan.points, Box())
    recipe = {
        "points": plan.points,
        "rho": rho,
        "variants": plan.variants,
        "seed": None if isinstance(seed, np.random.Generator) else int(seed),
    }
    made = PointTiles.of(
        plan.tiles,
        rows,
        [ranks[n] for n in numbers],
        variants=Variants.uniform(plan.tiles, plan.variants),
        distance=distance,
        method=method,
        recipe=recipe,
    )
    close = find_closeness(made, plan.distance * 1.01)
    if close.distance < distance:
        raise AssertionError(f"points {close.distance} apart where {distance} was built")
    made.figures.update(closest=close.distance, rho=close.rho, **asdict(find_spikes(made)))
    return made
