"""The command ``dapple``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Force, Json, Quiet, option, parse_limits, parse_list
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path | None,
        option(
            "-o",
            "--output",
            help="Picture FILE.png, drawing FILE.svg, .pdf or .dxf, tiles FILE.npy, or clauses FILE.cnf; "
            "default dapple.png.",
        ),
    ] = None,
    width: Annotated[
        int | None,
        option(help="Width in cells; default 64, or by the proportions of --input where --height is given."),
    ] = None,
    height: Annotated[
        int | None, option(help="Height in cells; default 40, or by the proportions of --input.")
    ] = None,
    limit: Annotated[
        list[str] | None,
        option(
            metavar="LIMIT=CELLS",
            help="Longest run in cells, once for each limit: H0=2 for tile 0 along a row, V1=2 for tile 1 "
            "down a column, H0+2=3 for tiles 0 and 2 together, H0=inf for none; default H0=2 and V1=2.",
        ),
    ] = None,
    tiles: Annotated[
        int | None, option(help="Number of tiles; default as many as limits and shares name.")
    ] = None,
    share: Annotated[
        list[float] | None,
        option(
            metavar="NUMBER",
            help="Share of a tile in the random start, once for each tile; default equal shares.",
        ),
    ] = None,
    input: Annotated[
        Path | None,
        option(help="Picture to follow: tile 0 where it is dark; default none, a random start."),
    ] = None,
    dither: Annotated[
        bool,
        option("--dither", help="Show the grays of --input as mixtures of tiles, as far as limits allow."),
    ] = False,
    cyclic: Annotated[bool, option("--cyclic", help="Close rows and columns to rings.")] = False,
    closest: Annotated[
        bool, option("--closest", help="Change as few cells of the start as possible, and prove it.")
    ] = False,
    endless: Annotated[bool, option("--endless", help="Draw a window of an endless tiling.")] = False,
    x: Annotated[
        int | None, option("--x", "-x", help="West-most cell of that window, anywhere; default 0.")
    ] = None,
    y: Annotated[int | None, option("--y", "-y", help="North-most cell of that window; default 0.")] = None,
    pins: Annotated[
        Path | None,
        option(help="FILE.npy or .csv of tiles to keep, -1 where any tile may lie; default none."),
    ] = None,
    count: Annotated[bool, option("--count", help="Only print how many tilings there are.")] = False,
    seconds: Annotated[
        float | None,
        option(help="Time in seconds after which --closest or --pins stop searching; default never."),
    ] = None,
    motif: Annotated[
        str | None, option(help="What each tile shows: fill (default), strokes or arcs.")
    ] = None,
    cell: Annotated[
        int | None, option(help="Size of a cell in pixels, 1 to 512; default by the size of the tiling.")
    ] = None,
    colors: Annotated[
        str | None,
        option(
            help="Colors of the tiles, or for strokes and arcs of lines and ground, as '#27548f,#ecd5a3'; "
            "default a palette."
        ),
    ] = None,
    seed: Annotated[
        int, option("--seed", help="Seed of the start and of what is left to chance; default 0.")
    ] = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Make a dappled tiling and draw it; or count such tilings, or write their clauses for a SAT solver.

    In a dappled tiling no tile has long runs along rows or columns.

    Example: tilewright dapple --width 80 --height 50 --motif arcs

    Example: tilewright dapple -o face.svg --input face.jpg --dither --width 120 --limit H0=3 --limit V1=3

    Example: tilewright dapple -o far.png --endless --x 1000000000000 --share 0.7 --share 0.3

    Example: tilewright dapple --count --width 8 --height 8

    Calls tilewright.jobs.DappleJob(...).run(). That makes tilewright.dapple(start, limits, ...) of
    random_start(...) or start_from_image(...); with --closest closest_dapple(start, limits), with --endless
    endless_dappled_tiling(limits).cells(x, y, width, height), with --pins complete_dapple(pins, limits), with
    --count count_dappled(width, height, limits), and for a .cnf dapple_formula((height, width),
    limits).dimacs().
    """
    perform("DappleJob", locals() | {"limit": parse_limits(limit), "colors": parse_list(colors)})
