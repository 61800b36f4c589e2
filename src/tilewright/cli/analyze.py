"""The command ``analyze``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed
from tilewright.cli.performing import perform


def command(
    source: Annotated[
        Path,
        typer.Argument(help="A tile-set folder, or points in .npy, .csv or .parquet.", show_default=False),
    ],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="SHEET.png: pictures beside figures.")
    ] = None,
    width: Annotated[float | None, typer.Option(help="Of the box a file's points lie in.")] = None,
    height: Annotated[float | None, typer.Option(help="Of that box.")] = None,
    torus: Annotated[bool, typer.Option(help="Opposite sides of that box meet.")] = False,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Measure a tile set, or points: spacing, spectrum, anisotropy.

    Example: tilewright analyze moss -o moss-sheet.png

    Example: tilewright analyze points.npy --width 100 --height 100 --torus -o sheet.png

    Calls tilewright.analyze(tilewright.load(folder), seed=seed), or of tilewright.read_points(file, box), and
    its save_sheet(path).
    """
    perform("AnalyzeJob", locals())
