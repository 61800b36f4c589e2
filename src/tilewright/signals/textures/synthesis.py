"""From an exemplar to texture tiles: the methods by name, and the record that makes a set again."""

import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np

from tilewright.checks import check_choice, check_int, check_type, type_error
from tilewright.errors import Progress, TilewrightTypeError, TilewrightValueError, TilewrightWarning
from tilewright.seeds import check_seed
from tilewright.signals.textures.diamonds import lay_burke, lay_diamonds, lay_diamonds_with_centers
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.nested import lay_nested
from tilewright.signals.textures.patchwork import Patchwork
from tilewright.signals.textures.plan import make_plan
from tilewright.signals.textures.recipe import Recipe, Spot
from tilewright.signals.textures.regularity import (
    Regularity,
    find_regularity,
    misfit_of_size,
    suited_tile_size,
)
from tilewright.signals.textures.seams import copy_maps
from tilewright.signals.textures.search import Ledger, PatchSearch
from tilewright.signals.textures.sheet import Sheet, make_sheet
from tilewright.signals.textures.squares import lay_ng, lay_squares
from tilewright.signals.textures.texture_tiles import TextureTiles
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tiles.variants import MOST_SHADED, Variants

CORNER_METHODS = ("nested", "ng", "squares")
EDGE_METHODS = ("centered-diamonds", "diamonds", "burke")
METHODS = CORNER_METHODS + EDGE_METHODS
_WITH_CENTERS = ("nested", "ng", "centered-diamonds")
"""Methods that lay a patch of its own in each tile."""
SMALLEST_TILE, LARGEST_TILE = 16, 1024
MOST_PIXELS = 2**28
"""Of all tiles together: about 5 GB of memory while they are made."""
_SECONDS = 0.15
"""What a tile of 128 x 128 pixels takes on two cores."""


def synthesize(
    exemplar: Exemplar,
    tiles: TileSet,
    *,
    tile_size: int | str = 128,
    seed: int = 0,
    method: str | None = None,
    variants: int = 1,
    pick: Mapping[str, Spot] | None = None,
    reject: Mapping[str, Sequence[Spot]] | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TextureTiles:
    """Synthesize a texture over a tile set, from an exemplar in memory.

    Parameters
    ----------
    exemplar : Exemplar
        One source, or two for an inhomogeneous set: then the upper half of the corner colors is taken from
        the second (Cohen et al. 2003, section 3.5).
    tiles : TileSet
        Corner, corner-coded or Wang tiles.
    tile_size : int or "auto", optional
        Pixels along a tile, even, 16 to 1,024; default 128. ``"auto"`` takes a size near 128 that is a whole
        number of the exemplar's periods.
    seed : int, optional
        The same seed gives the same bytes, whatever the number of threads; 0 to 2^64 - 1, default 0.
    method : str, optional
        For corner tiles ``"nested"`` (default), ``"ng"`` (Ng et al. 2005: one patch per corner color, cut
        in the inscribed circle by one patch per tile; Lagae & Dutré 2006, figure 6d) or ``"squares"``
        (figure 6c); for Wang tiles ``"centered-diamonds"`` (default), ``"diamonds"`` (Cohen et al. 2003;
        figure 6a) or ``"burke"`` (figure 6b).
    variants : int, optional
        Pictures of every tile, 1 to 256; default 1. They are patches of their own over the same borders, so
        any of them may lie beside any neighbor. They hide repetition with fewer tiles than more colors. Only
        methods with a patch of its own for each tile have them: ``"nested"``, ``"ng"`` and
        ``"centered-diamonds"``.
    pick : dict of str to (source, y, x), optional
        Places for named patches, instead of a search; see ``recipe["patches"]`` for names and places. By
        default every place is searched for.
    reject : dict of str to list of (source, y, x), optional
        Places that named patches must not be taken from, nor within a quarter of a tile; by default none.
    threads : int, optional
        Number of threads, 1 to 1,024; by default one for each processor.
    progress : callable, optional
        Called as ``progress(done, total, what)`` after each patch; raise `Cancelled` in it to stop.

    Returns
    -------
    TextureTiles
        Pictures for each tile of the set, and where each of their pixels was copied from.

    Raises
    ------
    TilewrightTypeError
        An argument of another type.
    TilewrightValueError
        The exemplar or its mask is too small for the tile size, the tiles have more than 2^28 pixels
        together, the method does not go with the set or with variants, or too much was rejected.

    Warns
    -----
    TilewrightWarning
        The exemplar holds a copy of itself, or is periodic and the tile size is off its period; the set
        will take minutes.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.synthesize(tw.Exemplar([{"albedo": photo}]), tw.corner_tiles(2), tile_size=16)
    >>> material.pixels.shape
    (16, 16, 16, 3)
    """
    check_seed(seed)
    workers = os.cpu_count() or 1 if threads is None else check_int("threads", threads, 1, 1024)
    check_type("exemplar", exemplar, Exemplar, "an Exemplar")
    pick, reject = _check_choices(pick, reject)
    corners = "NE" in check_tiles("tiles", tiles).shape.slots
    if tiles.shape.dimension != 2:
        raise TilewrightValueError(f"texture tiles are square; {tiles.shape.name} tiles are not")
    method = check_choice(
        "method", ("nested" if corners else "centered-diamonds") if method is None else method, METHODS
    )
    allowed = CORNER_METHODS if corners else EDGE_METHODS
    if method not in allowed:
        raise TilewrightValueError(
            f"{method!r} does not go with {tiles.shape.name} tiles; allowed are {', '.join(allowed)}",
            argument="method",
            value=method,
            allowed=", ".join(allowed),
        )
    if check_int("variants", variants, 1, MOST_SHADED) > 1 and method not in _WITH_CENTERS:
        raise TilewrightValueError(
            f"is {variants}, and method {method!r} lays no patch of its own in each tile",
            argument="variants",
            value=variants,
            allowed="1",
            advice=f"use {' or '.join(m for m in allowed if m in _WITH_CENTERS)}",
        )
    regularity = find_regularity(next(iter(exemplar.sources[0].values())))
    size = _tile_size(tile_size, regularity)
    _warn(regularity, size)
    _check_cost(len(tiles) * variants, size)
    sheet = make_sheet(exemplar)
    ledger = Ledger(
        {name: _to_sheet(sheet, name, spot) for name, spot in pick.items()},
        {name: [_to_sheet(sheet, name, s) for s in spots] for name, spots in reject.items()},
    )
    rng = np.random.default_rng(seed)
    with ThreadPoolExecutor(workers) as pool:
        lay, total = _method(method, tiles, len(exemplar.sources), variants)
        search = PatchSearch(sheet, size, ledger, regularity.shortest_period, pool, progress, total, rng)
        canvas = lay(search, rng)
    unknown = (set(ledger.picked) | set(ledger.rejected)) - set(ledger.laid)
    if unknown:
        raise TilewrightValueError(
            f"no patch is called {min(unknown)!r}; this set has {', '.join(sorted(ledger.laid)[:6])}, ..."
        )
    origins = sheet.to_origins(canvas.rows, canvas.columns)
    recipe = Recipe(
        method,
        seed,
        size,
        exemplar.weights,
        {name: _to_source(sheet, place) for name, place in ledger.laid.items()},
        {name: _to_source(sheet, place) for name, place in ledger.picked.items()},
        {n: [_to_source(sheet, p) for p in ps] for n, ps in ledger.rejected.items()},
        variants,
    )
    rows = Variants.uniform(tiles, variants)
    maps = copy_maps(exemplar.sources, origins, exemplar.kinds, tiles, rows, progress)
    return TextureTiles(
        tiles, maps, exemplar.sources, origins, recipe.to_dict(), exemplar.masks, exemplar.kinds, rows
    )


def resynthesize(
    material: TextureTiles,
    *,
    reject: Iterable[str] = (),
    pick: Mapping[str, Spot] | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TextureTiles:
    """Make a set again with some of its patches rejected ("not this one") or picked by hand.

    What was rejected and picked before stays so, and so do the weights of variants.

    Parameters
    ----------
    material : TextureTiles
        A set that `synthesize` or `texture_tiles` made.
    reject : iterable of str, optional
        Names of patches in ``material.recipe["patches"]``: the place each was taken from is barred for it
        from now on. By default none.
    pick : dict of str to (source, y, x), optional
        Places for named patches, instead of a search; by default none.
    threads : int, optional
        Number of threads, 1 to 1,024; by default one for each processor.
    progress : callable, optional
        Called as ``progress(done, total, what)`` after each patch; raise `Cancelled` in it to stop.

    Returns
    -------
    TextureTiles
        The set made anew; its recipe remembers what was rejected and picked.

    Raises
    ------
    TilewrightTypeError
        An argument of another type.
    TilewrightValueError
        A patch that the set does not have, a set without a recipe, or too much was rejected.
    """
    recipe = Recipe.of(material)
    if isinstance(reject, str) or not isinstance(reject, Iterable):
        raise type_error("reject", reject, "a list of patch names")
    if pick is not None and not isinstance(pick, Mapping):
        raise type_error("pick", pick, "a dict of patch name to (source, y, x)")
    rejected = {name: list(spots) for name, spots in recipe.rejected.items()}
    picked = recipe.picked | dict(pick or {})
    for name in reject:
        if name not in recipe.patches:
            raise TilewrightValueError(
                f"no patch is called {name!r}; this set has {', '.join(sorted(recipe.patches)[:6])}, ..."
            )
        rejected.setdefault(name, []).append(recipe.patches[name])
        picked.pop(name, None)
    made = synthesize(
        Exemplar(material.sources, material.masks or None, recipe.weights, material.kinds),
        material.tiles,
        tile_size=recipe.tile_size,
        seed=recipe.seed,
        method=recipe.method,
        variants=recipe.variants,
        pick=picked,
        reject=rejected,
        threads=threads,
        progress=progress,
    )
    return replace(made, variants=material.variants)


def _check_choices(
    pick: Mapping[str, Spot] | None, reject: Mapping[str, Sequence[Spot]] | None
) -> tuple[Mapping[str, Spot], Mapping[str, Sequence[Spot]]]:
    """An artist's choices, well formed."""
    for what, given in (("pick", pick), ("reject", reject)):
        if given is not None and not isinstance(given, Mapping):
            raise type_error(what, given, "a dict by patch name")
    pick, reject = pick or {}, reject or {}
    spots = [(f"pick[{name!r}]", spot) for name, spot in pick.items()]
    for name, rejected in reject.items():
        if not isinstance(rejected, (list, tuple)):
            raise type_error(f"reject[{name!r}]", rejected, "a list of (source, y, x)")
        spots += [(f"reject[{name!r}]", spot) for spot in rejected]
    for what, spot in spots:
        if not isinstance(spot, (list, tuple)) or len(spot) != 3:
            raise TilewrightTypeError(
                f"must hold (source, y, x), not {spot!r}", argument=what, value=spot, allowed="(source, y, x)"
            )
    return pick, reject


Lay = Callable[[PatchSearch, np.random.Generator], Patchwork]


def _method(method: str, tiles: TileSet, sources: int, variants: int) -> tuple[Lay, int]:
    """The function that lays all tiles, and the number of patches it lays."""
    centers = len(tiles) * variants
    if method in EDGE_METHODS:
        if sources > 1:
            raise TilewrightValueError(
                "two sources need corner colors", advice="use corner or corner-coded tiles"
            )
        colors = tiles.colors[0] + tiles.colors[1]
        if method == "centered-diamonds":
            return lambda search, rng: lay_diamonds_with_centers(
                search, tiles, rng, variants
            ), colors + centers
        lay = lay_diamonds if method == "diamonds" else lay_burke
        return lambda search, rng: lay(search, tiles, rng), colors
    plan = make_plan(tiles, sources)
    if method == "nested":
        total = len(plan.corner_sources) + len(plan.edges) + centers
        return lambda search, rng: lay_nested(search, plan, rng, variants), total
    if method == "ng":
        return lambda search, rng: lay_ng(search, plan, rng, variants), len(plan.corner_sources) + centers
    return lambda search, rng: lay_squares(search, plan, rng), len(plan.corner_sources)


def _tile_size(given: int | str, regularity: Regularity) -> int:
    if isinstance(given, str) and given == "auto":
        return suited_tile_size(regularity)
    size = check_int("tile_size", given, SMALLEST_TILE, LARGEST_TILE)
    if size % 2:
        raise TilewrightValueError(
            f"is {size}; it must be even, for example {size + 1}",
            argument="tile_size",
            value=size,
            allowed=f"even, for example {size + 1}",
        )
    return size


def _warn(regularity: Regularity, size: int) -> None:
    if regularity.clone is not None:
        y, x = regularity.clone
        warnings.warn(
            f"the exemplar shows itself again {x} pixels to the right and {y} down (made seamless by "
            "offset?); crop it to one copy, or twins will be visible",
            TilewrightWarning,
            stacklevel=3,
        )
    off = misfit_of_size(regularity, size)
    if off > 2:
        better = suited_tile_size(regularity, size)
        warnings.warn(
            f"the exemplar repeats every {_periods(regularity)} pixels and tile_size {size} is {off:.0f} "
            f"pixels off; {better} fits",
            TilewrightWarning,
            stacklevel=3,
        )


def _check_cost(count: int, size: int) -> None:
    """Refuse what cannot be held, and say what will take long."""
    if count * size * size > MOST_PIXELS:
        raise TilewrightValueError(
            f"{count} tiles of {size} x {size} pixels are {count * size * size} pixels; allowed are "
            f"{MOST_PIXELS}: choose fewer colors or a smaller tile size"
        )
    minutes = count * _SECONDS * (size / 128) ** 2 / 60
    if minutes > 2:
        warnings.warn(
            f"{count} tiles of {size} x {size} pixels take about {minutes:.0f} minutes on two cores",
            TilewrightWarning,
            stacklevel=3,
        )


def _periods(regularity: Regularity) -> str:
    y, x = (f"{p:.1f}" if p else "-" for p in regularity.period)
    return f"{x} x {y}"


def _to_sheet(sheet: Sheet, name: str, spot: Spot) -> tuple[int, int]:
    source, y, x = (check_int(f"place of {name}", v, -(2**16), 2**16) for v in spot)
    check_int(f"source of {name}", source, 0, len(sheet.tops) - 1)
    return sheet.tops[source] + y, x


def _to_source(sheet: Sheet, place: tuple[int, int]) -> Spot:
    source = int(np.searchsorted(np.array(sheet.tops), place[0], side="right")) - 1
    return source, int(place[0]) - sheet.tops[source], int(place[1])
