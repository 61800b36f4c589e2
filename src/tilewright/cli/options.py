"""What commands share: their common options, and texts that become values."""

from functools import partial
from math import inf
from pathlib import Path
from typing import Annotated

import typer

from tilewright.errors import TilewrightError, TilewrightTypeError, TilewrightValueError

argument = partial(typer.Argument, show_default=False)
option = partial(typer.Option, show_default=False)
"""An option whose help gives the unit and then the default, so that typer need not say it again."""

Folder = Annotated[Path, argument(help="A tile-set folder made by `tilewright texture`.")]
Force = Annotated[
    bool, option("--force", help="Replace what is there already under the output's name; default no.")
]
DryRun = Annotated[
    bool, option("--dry-run", help="Say what would be written, and what it would cost; do nothing.")
]
Quiet = Annotated[bool, option("--quiet", "-q", help="Print no progress and no notes.")]
Json = Annotated[bool, option("--json", help="Print one JSON object of the figures on stdout.")]
Seed = Annotated[int, option("--seed", help="Seed of construction, from 0 on; default 0.")]


def _refuse_seed(given: int | None) -> None:
    if given is not None:
        raise TilewrightValueError(
            "--seed is the seed of construction, and nothing is constructed here; --lattice-seed gives "
            "another arrangement of the tiles"
        )


NoSeed = Annotated[int | None, typer.Option("--seed", hidden=True, callback=_refuse_seed)]
"""Refused where it would do nothing, with the name of the option that is meant."""
LatticeSeed = Annotated[
    int, option("--lattice-seed", help="Seed of the tiling, from 0 on: which tile lies where; default 0.")
]
Map = Annotated[str | None, option("--map", help="Name of the map; default the set's main map.")]


def parse_pairs(option: str, given: list[str] | None) -> dict[str, str] | None:
    """``NAME=VALUE`` pairs as a dict; None where there are none."""
    pairs: dict[str, str] = {}
    for item in given or ():
        name, equals, value = item.partition("=")
        if not (name and equals and value):
            raise TilewrightValueError(f"{option} is {item!r}; expected NAME=VALUE")
        if name in pairs:
            raise TilewrightValueError(f"{option} names {name!r} twice")
        pairs[name] = value
    return pairs or None


def parse_limits(given: list[str] | None) -> dict[str, float] | None:
    """``--limit NAME=NUMBER`` as limits of runs; the number may be inf."""
    limits: dict[str, float] = {}
    for name, most in (parse_pairs("--limit", given) or {}).items():
        if most != "inf" and not (most.isascii() and most.isdigit() and len(most) < 10):
            raise TilewrightValueError(f"--limit {name} is {most!r}; allowed are 0, 1, 2, ... and inf")
        limits[name] = inf if most == "inf" else int(most)
    return limits or None


def parse_weights(given: list[str] | None) -> dict[str, float] | None:
    """``--weight NAME=NUMBER``."""
    pairs = parse_pairs("--weight", given)
    return None if pairs is None else {name: _number(name, text) for name, text in pairs.items()}


def _number(name: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise TilewrightTypeError(f"--weight {name} is {text!r}; expected a number") from None


def parse_spots(given: list[str] | None) -> dict[str, tuple[int, int, int]] | None:
    """``--pick NAME=SOURCE,Y,X``: places in sources by the names of patches."""
    pairs = parse_pairs("--pick", given)
    return None if pairs is None else {name: _spot(name, text) for name, text in pairs.items()}


def _spot(name: str, text: str) -> tuple[int, int, int]:
    try:
        source, y, x = (int(v) for v in text.split(","))
    except ValueError:
        raise TilewrightError(f"--pick {name} is {text!r}; expected SOURCE,Y,X as whole numbers") from None
    return source, y, x


def parse_size(text: str) -> int | str:
    """``--tile-size`` in pixels, or auto."""
    try:
        return text if text == "auto" else int(text)
    except ValueError:
        raise TilewrightTypeError(f"--tile-size is {text!r}; expected a number of pixels or auto") from None


def parse_list(text: str | None) -> list[str] | None:
    """Words with commas between."""
    return None if text is None else [word.strip() for word in text.split(",")]
