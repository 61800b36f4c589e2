"""The command ``analyze``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Force, Json, Quiet, argument, option
from tilewright.cli.performing import perform


def command(
    source: Annotated[
        Path,
        argument(help="A tile-set folder, or a file of points: .npy, .npz, .csv, .txt, .ply or .parquet."),
    ],
    output: Annotated[
        Path | None,
        option(
            "-o",
            "--output",
            help="Sheet of pictures beside the figures: FILE.png, .jpg, .svg or .pdf; default none.",
        ),
    ] = None,
    width: Annotated[
        float | None,
        option(
            help="Width of the box that a file's points lie in, in their units; default as the file says."
        ),
    ] = None,
    height: Annotated[
        float | None, option(help="Height of that box in the same units; default as the file says.")
    ] = None,
    torus: Annotated[bool, option(help="Let opposite sides of that box meet; default no.")] = False,
    seed: Annotated[
        int, option("--seed", help="Seed of the tilings that are measured, from 0 on; default 0.")
    ] = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Measure a tile set or a file of points: seams and repetition, or spacing and spectrum.

    Example: tilewright analyze moss -o moss-sheet.png

    Points that end at the sides of a plain box are measured so that the sides do not show. Without a box, in
    the file or by --width and --height, the one around the points is taken.

    Example: tilewright analyze points.npy --width 100 --height 100 --torus -o sheet.png

    Calls tilewright.jobs.AnalyzeJob(...).run(). That analyzes, by tilewright.analyze(..., seed=seed), the
    set tilewright.load(folder) or the points tilewright.read_points(file, box); the report's
    save_sheet(path) draws the sheet.
    """
    perform("AnalyzeJob", locals())
