"""The command ``view``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Folder, Force, Json, LatticeSeed, NoSeed, Quiet, option
from tilewright.cli.performing import perform


def command(
    folder: Folder,
    output: Annotated[
        Path | None, option("-o", "--output", help="Page to write: FILE.html; default SET.html.")
    ] = None,
    compare: Annotated[
        bool,
        option(
            "--compare",
            help="Show plain repeat, hex-tiling, by-example noise, and the other of Wang and corner tiles "
            "too.",
        ),
    ] = False,
    lattice_seed: LatticeSeed = 0,
    seed: NoSeed = None,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Write a page to pan, zoom and tilt over the endless plane; it works offline.

    Example: tilewright view moss -o moss.html

    Example: tilewright view moss --compare -o moss-compared.html

    Calls tilewright.jobs.ViewJob(...).run(). That saves tilewright.save_viewer(material, path,
    seed=lattice_seed), with --compare also compare=compare_textures(material, seed=lattice_seed), whose
    figures --json prints.
    """
    perform("ViewJob", locals())
