"""The methods by name: what goes with each, and the function that lays its tiles."""

from collections.abc import Callable

import numpy as np

from tilewright.checks import check_choice, check_int
from tilewright.errors import TilewrightValueError
from tilewright.signals.textures.diamonds import lay_burke, lay_diamonds, lay_diamonds_with_centers
from tilewright.signals.textures.manner import Manner
from tilewright.signals.textures.nested import lay_nested
from tilewright.signals.textures.patchwork import Patchwork
from tilewright.signals.textures.plan import make_plan
from tilewright.signals.textures.search import PatchSearch
from tilewright.signals.textures.squares import lay_ng, lay_squares
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tiles.variants import MOST_SHADED

CORNER_METHODS = ("faithful", "nested", "ng", "squares")
EDGE_METHODS = ("centered-diamonds", "diamonds", "burke")
METHODS = CORNER_METHODS + EDGE_METHODS
WITH_CENTERS = ("faithful", "nested", "ng", "centered-diamonds")
"""Methods that lay a patch of its own in each tile."""

Lay = Callable[[PatchSearch, np.random.Generator], Patchwork]


def find_method(method: str, tiles: TileSet, sources: int, variants: int, manner: Manner) -> tuple[Lay, int]:
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
    if method in ("faithful", "nested"):
        edges = 0 if manner.plain_edges else len(plan.edges)
        total = len(plan.corner_sources) + edges + centers
        return lambda search, rng: lay_nested(search, plan, rng, variants), total
    if method == "ng":
        return lambda search, rng: lay_ng(search, plan, rng, variants), len(plan.corner_sources) + centers
    return lambda search, rng: lay_squares(search, plan, rng), len(plan.corner_sources)


def check_method(method: str | None, tiles: TileSet | None, variants: int) -> str:
    """A method that goes with the set and with variants."""
    corners = tiles is None or "NE" in check_tiles("tiles", tiles).shape.slots
    if tiles is not None and tiles.shape.dimension != 2:
        raise TilewrightValueError(f"texture tiles are square; {tiles.shape.name} tiles are not")
    usual = "faithful" if tiles is None else "nested" if corners else "centered-diamonds"
    method = check_choice("method", usual if method is None else method, METHODS)
    allowed = ("faithful",) if tiles is None else CORNER_METHODS if corners else EDGE_METHODS
    if method not in allowed:
        raise TilewrightValueError(
            f"{method!r} {_why(tiles)}; allowed are {', '.join(allowed)}",
            argument="method",
            value=method,
            allowed=", ".join(allowed),
        )
    if check_int("variants", variants, 1, MOST_SHADED) > 1 and method not in WITH_CENTERS:
        raise TilewrightValueError(
            f"is {variants}, and method {method!r} lays no patch of its own in each tile",
            argument="variants",
            value=variants,
            allowed="1",
            advice=f"use {' or '.join(m for m in allowed if m in WITH_CENTERS)}",
        )
    return method


def _why(tiles: TileSet | None) -> str:
    return "chooses no tiles by itself" if tiles is None else f"does not go with {tiles.shape.name} tiles"
