"""tilewright compare"""

import time
from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed, progress_bar, report


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
    from tilewright.analysis.points.comparison import check_comparison_folder, compare
    from tilewright.analysis.points.contenders import list_contenders

    if list_methods:
        known = list_contenders()
        report(
            {name: c.source for name, c in known.items()},
            json,
            "\n".join(f"{name:<22} {c.source}" for name, c in known.items()),
        )
        return
    started = time.perf_counter()
    if output is not None:
        check_comparison_folder(output)
    names = None if methods is None else [name.strip() for name in methods.split(",")]
    with progress_bar() as progress:
        found = compare(names, full=full, sets=sets, seed=seed, progress=progress)
    if output is not None:
        found.save(output)
    seconds = round(time.perf_counter() - started, 1)
    report({"methods": found.plain_rows(), "seconds": seconds}, json, found.table() + f"\n{seconds} s")
