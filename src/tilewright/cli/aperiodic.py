"""The command ``aperiodic``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed
from tilewright.cli.performing import perform


def command(
    name: Annotated[
        str | None,
        typer.Argument(
            help="Of a set; without one, what there is. Or FILE.csv or .npy: a set of your own.",
            show_default=False,
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="FILE.svg, .png or .npy; else NAME.svg.", show_default=False),
    ] = None,
    width: Annotated[int, typer.Option(help="Cells.")] = 40,
    height: Annotated[int, typer.Option(help="Cells.")] = 30,
    x: Annotated[int, typer.Option(help="West cell; any place of the plane.")] = 0,
    y: Annotated[int, typer.Option(help="North cell.")] = 0,
    set: Annotated[bool, typer.Option("--set", help="The tiles themselves instead of a tiling.")] = False,
    to: Annotated[
        str | None,
        typer.Option(
            help="Make a corner set: diagonal, horizontal, vertical, rotation, subdivision; or wang.",
            show_default=False,
        ),
    ] = None,
    period: Annotated[
        tuple[int, int] | None,
        typer.Option(help="Look for the smallest torus up to so many cells.", show_default=False),
    ] = None,
    shape: Annotated[str, typer.Option(help="Of your own set: wang, corner or corner-coded.")] = "wang",
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Tile the plane with an aperiodic set and draw it, or draw the set; or list the sets.

    Columns of your own set are N, E, S, W for Wang tiles and NE, SE, SW, NW for corner tiles; it tiles a
    rectangle. A .npy holds tile indices, shape (height, width), or with --set the colors of each tile.

    Example: tilewright aperiodic

    Example: tilewright aperiodic jeandel-rao-11-5 -o tiling.svg --x 1000000 --width 60

    Example: tilewright aperiodic kari-14 --to vertical --set

    Example: tilewright aperiodic lagae-44 --period 5 5

    Calls tilewright.aperiodic_tiling(tilewright.aperiodic_tiles(name), seed).indices(x, y, width, height) and
    tilewright.draw_tiling(...) or, for a PNG, paint_tiling(...); with --set draw_tiles(...); with --to
    translated_tiling(tiling, to); with --period periodic_tiling(tiles, ...); for your own set
    filled_tiling(tiles, width, height, seed=seed).
    """
    perform("AperiodicJob", locals())
