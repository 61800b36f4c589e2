"""tilewright analyze"""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Folder, Json, Seed, progress_bar, report


def command(
    folder: Folder,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="SHEET.png: pictures beside figures.")
    ] = None,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Measure seams and repetition of a tile set.

    Example: tilewright analyze moss -o moss-sheet.png

    Calls tilewright.analyze(material, seed=seed) and its save_sheet(path).
    """
    from tilewright.analysis import analyze
    from tilewright.analysis.report import check_sheet
    from tilewright.files import load

    if output is not None:
        check_sheet(output)
    with progress_bar() as progress:
        found = analyze(load(folder), seed=seed, progress=progress)
    if output is not None:
        found.save_sheet(output)
    report(found.figures, json, str(found))
