"""The command ``compare``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Force, Json, Quiet, Seed, option, parse_list
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path | None,
        option("-o", "--output", help="Folder for the table, the figures and the pictures; default none."),
    ] = None,
    methods: Annotated[
        str | None,
        option(help="Names with commas between, as --list gives them; default those of moderate cost."),
    ] = None,
    full: Annotated[bool, option(help="Measure all methods, however long they take; default no.")] = False,
    list_methods: Annotated[bool, option("--list", help="Only list the methods.")] = False,
    sets: Annotated[int, option(help="Number of point sets of each method; default 10.")] = 10,
    seed: Seed = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Compare methods for blue-noise points: radius, spectrum, zone plate and time.

    Example: tilewright compare -o comparison

    Example: tilewright compare --methods "dart 0.75,corner 4 32,corner-relaxed 4 32" --json

    The settings are those of Lagae 2007, chapter 6: ten sets of about 16,384 points of each method, and one
    of about 262,144 for the zone plate.

    Calls tilewright.jobs.CompareJob(...).run(). That measures by tilewright.compare(methods, full=full, ...)
    and saves by its save(folder).
    """
    perform("CompareJob", locals() | {"methods": parse_list(methods), "list": list_methods})
