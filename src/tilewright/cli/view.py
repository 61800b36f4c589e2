"""The command ``view``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Folder, Json, LatticeSeed, Seed
from tilewright.cli.performing import perform


def command(
    folder: Folder,
    output: Annotated[Path, typer.Option("-o", "--output", help="FILE.html", show_default=False)],
    compare: Annotated[
        bool,
        typer.Option(
            "--compare",
            help="Beside plain repeat, hex-tiling, by-example noise, and the other of Wang and corner tiles.",
        ),
    ] = False,
    lattice_seed: LatticeSeed = 0,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write a page to pan, zoom and tilt over the endless plane; it works offline.

    Example: tilewright view moss -o moss.html

    Example: tilewright view moss --compare -o moss-compared.html

    Calls tilewright.save_viewer(material, path, seed=lattice_seed); with --compare, and with compare=
    tilewright.compare_textures(material, seed=lattice_seed), whose figures --json prints.
    """
    perform("ViewJob", locals())
