"""The command ``info``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Json, Quiet, argument
from tilewright.cli.performing import perform


def command(
    folder: Annotated[
        Path | None, argument(help="A tile-set folder; without one, all names that options take are listed.")
    ] = None,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Say what a tile-set folder holds; or list methods, engine targets, brick patterns and sets by name.

    Example: tilewright info moss-tiles

    Example: tilewright info

    Calls tilewright.jobs.InfoJob(...).run(). That reads the folder by tilewright.load(folder).
    """
    perform("InfoJob", locals())
