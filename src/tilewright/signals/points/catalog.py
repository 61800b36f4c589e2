"""Every kind of point tiles by name: one way to make them all."""

from collections.abc import Callable
from dataclasses import asdict, dataclass
from importlib import import_module
from typing import Any

from tilewright.checks import check_choice
from tilewright.errors import Progress, TilewrightTypeError
from tilewright.extras import need_package
from tilewright.seeds import Seed
from tilewright.signals.points.point_tiles import PointTiles
from tilewright.signals.points.spikes import find_spikes
from tilewright.tiles import TileSet, corner_tiles, crossed_wang_tiles


@dataclass(frozen=True)
class TileMethod:
    """A kind of point tiles.

    Attributes
    ----------
    home : str
        "module.function" below this package.
    settings : dict
        What the function is called with beside points, rho, seed and progress.
    tiles : callable or None
        The tile set, from a number of colors; None where the function has its own.
    rho : float or None
        Usual relative radius; None where it cannot be asked for.
    source : str
    """

    home: str
    settings: dict[str, Any]
    tiles: Callable[[int], TileSet] | None
    rho: float | None
    source: str


TILE_METHODS: dict[str, TileMethod] = {
    "corner": TileMethod("synthesis.poisson_tiles", {"method": "balanced"}, corner_tiles, 0.75, "tilewright"),
    "corner-relaxed": TileMethod(
        "synthesis.poisson_tiles",
        {"method": "relaxed"},
        corner_tiles,
        0.75,
        "Lagae & Dutré 2006, section 7; Lagae 2007, section 4.5",
    ),
    "edge": TileMethod(
        "synthesis.poisson_tiles",
        {"method": "relaxed"},
        lambda colors: crossed_wang_tiles(2),
        0.75,
        "Lagae & Dutré 2005a; Lagae 2007, section 4.3",
    ),
    "template": TileMethod(
        "synthesis.poisson_tiles",
        {"method": "relaxed", "variants": 128},
        lambda colors: corner_tiles(1),
        0.75,
        "Lagae & Dutré 2005b; Lagae 2007, section 4.4",
    ),
    "shade": TileMethod("shade.shade_tiles", {}, None, 0.70, "Shade et al. 2000; Lagae 2007, section 6.6"),
    "hiller": TileMethod(
        "hiller.hiller_tiles", {}, None, None, "Hiller et al. 2001; Lagae 2007, section 6.7"
    ),
    "kopf": TileMethod("kopf.kopf_tiles", {}, None, None, "Kopf et al. 2006; Lagae 2007, section 6.14"),
}


def make_point_tiles(
    method: str = "corner",
    points: int | None = None,
    rho: float | None = None,
    *,
    colors: int = 4,
    seed: Seed = 0,
    progress: Progress | None = None,
    **settings: Any,
) -> PointTiles:
    """Make point tiles of any kind, by name.

    Parameters
    ----------
    method : str, optional
        ``"corner"`` (default): balanced tiles with colored corners. ``"corner-relaxed"``: the same as Lagae &
        Dutré 2006 made them. ``"edge"``: Wang tiles (Lagae & Dutré 2005a). ``"template"``: one tile with 128
        interiors (Lagae & Dutré 2005b). ``"shade"``: Shade et al. 2000. ``"hiller"``: Hiller et al. 2001.
        ``"kopf"``: tiles that subdivide (Kopf et al. 2006).
    points : int, optional
        Points per tile; by default the method's usual number.
    rho : float, optional
        Relative radius; by default the method's usual one. ``"hiller"`` and ``"kopf"`` take none.
    colors : int, optional
        Colors of corner tiles; default 4.
    seed : int or numpy Generator, optional
        The same seed gives the same points; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.
    **settings : int, float or str
        Further parameters of the method's own function, such as ``variants`` of `poisson_tiles`.

    Returns
    -------
    PointTiles
        The set; its ``figures`` hold the spikes, see `find_spikes`.

    Raises
    ------
    TilewrightTypeError
        A relative radius for a method that takes none, or an argument of another type.
    TilewrightValueError
        An unknown method, or a number that the method cannot use.
    MissingExtra
        The package finufft is not installed.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiles = tw.make_point_tiles("corner-relaxed", points=16, colors=2, seed=1)
    >>> len(tiles.tiles), tiles.density
    (16, 16.0)
    """
    known = TILE_METHODS[check_choice("method", method, tuple(TILE_METHODS))]
    given: dict[str, Any] = {"seed": seed, "progress": progress, **known.settings}
    if known.tiles is not None:
        given["tiles"] = known.tiles(colors)
    if points is not None:
        given["points"] = points
    if rho is not None and known.rho is None:
        raise TilewrightTypeError(f"the method {method!r} does not take rho; its points have their own")
    radius = known.rho if rho is None else rho
    if radius is not None:
        given["rho"] = radius
    need_package("finufft", "making point tiles")
    module, function = known.home.split(".")
    run = getattr(import_module(f"tilewright.signals.points.{module}"), function)
    made: PointTiles = run(**{**given, **settings})
    if "doubled" not in made.figures:
        made.figures.update(asdict(find_spikes(made)))
    return made
