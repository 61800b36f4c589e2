"""The command ``dapple``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed, parse_limits, parse_list
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", help="FILE.png, .svg, .npy or .cnf; else dapple.png.", show_default=False
        ),
    ] = None,
    width: Annotated[
        int | None, typer.Option(help="Cells; 64, or what suits --input.", show_default=False)
    ] = None,
    height: Annotated[
        int | None, typer.Option(help="Cells; 40, or what suits --input.", show_default=False)
    ] = None,
    limit: Annotated[
        list[str] | None,
        typer.Option(
            help="Longest run, again for each: H0=2, V1=2, H0+2=3, H0=inf; else H0=2 and V1=2.",
            show_default=False,
        ),
    ] = None,
    tiles: Annotated[
        int | None, typer.Option(help="How many; else as many as are named.", show_default=False)
    ] = None,
    share: Annotated[
        list[float] | None,
        typer.Option(help="How much of each tile the random start holds, once for each.", show_default=False),
    ] = None,
    input: Annotated[
        Path | None, typer.Option(help="Picture to follow: tile 0 where it is dark.", show_default=False)
    ] = None,
    dither: Annotated[
        bool, typer.Option("--dither", help="Let grays of --input be mixtures, as far as limits allow.")
    ] = False,
    cyclic: Annotated[bool, typer.Option("--cyclic", help="Close rows and columns to rings.")] = False,
    closest: Annotated[
        bool, typer.Option("--closest", help="Change as few cells as can be, and prove it.")
    ] = False,
    endless: Annotated[bool, typer.Option("--endless", help="A window of an endless tiling.")] = False,
    x: Annotated[
        int | None, typer.Option("--x", "-x", help="West cell of the window.", show_default=False)
    ] = None,
    y: Annotated[int | None, typer.Option("--y", "-y", help="North cell.", show_default=False)] = None,
    pins: Annotated[
        Path | None,
        typer.Option(help="FILE.npy of tiles to keep, -1 where any may be.", show_default=False),
    ] = None,
    count: Annotated[bool, typer.Option("--count", help="Print how many tilings there are.")] = False,
    seconds: Annotated[
        float | None, typer.Option(help="When --closest or --pins stop.", show_default=False)
    ] = None,
    cell: Annotated[int | None, typer.Option(help="Pixels along a cell.", show_default=False)] = None,
    colors: Annotated[
        str | None,
        typer.Option(help="Of the tiles, or of lines and ground: '#27548f,#ecd5a3'.", show_default=False),
    ] = None,
    motif: Annotated[
        str | None, typer.Option(help="fill, strokes or arcs: what each tile shows.", show_default=False)
    ] = None,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Make a dappled tiling, in which no tile has long runs, and draw it; or count them, or write clauses.

    Example: tilewright dapple --width 80 --height 50 --motif arcs

    Example: tilewright dapple -o face.svg --input face.jpg --dither --width 120 --limit H0=3 --limit V1=3

    Example: tilewright dapple -o far.png --endless --x 1000000000000 --share 0.7 --share 0.3

    Example: tilewright dapple --count --width 8 --height 8

    Calls tilewright.dapple(start, limits, ...) of tilewright.random_start(...) or start_from_image(...);
    with --closest closest_dapple(start, limits), with --endless endless_dappled_tiling(limits).cells(x,
    y, width, height), with --pins complete_dapple(pins, limits), with --count count_dappled(width,
    height, limits), for a .cnf dapple_formula((height, width), limits).dimacs().
    """
    perform("DappleJob", locals() | {"limit": parse_limits(limit), "colors": parse_list(colors)})
