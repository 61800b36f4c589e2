"""The command ``compare``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed, parse_list
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="DIR: table, figures and pictures.")
    ] = None,
    methods: Annotated[
        str | None, typer.Option(help="Names with commas between; see --list.", show_default=False)
    ] = None,
    full: Annotated[bool, typer.Option(help="All methods, however long they take.")] = False,
    list_methods: Annotated[bool, typer.Option("--list", help="Name the methods and end.")] = False,
    sets: Annotated[int, typer.Option(help="Sets of each method, K.")] = 10,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Compare methods for blue-noise points: radius, spectrum, zone plate and time.

    Example: tilewright compare -o comparison

    Example: tilewright compare --methods "dart 0.75,corner 4 32,corner-relaxed 4 32" --json

    The settings are those of Lagae 2007, chapter 6: ten sets of 16,384 points of each method, and one of
    262,144 for the zone plate. Calls tilewright.compare(methods, full=full) and its save(folder).
    """
    perform("CompareJob", locals() | {"methods": parse_list(methods), "list": list_methods})
