"""The command ``aperiodic``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Force, Json, Quiet, argument, option
from tilewright.cli.performing import perform


def command(
    name: Annotated[
        str | None,
        argument(
            help="Name of a set, or FILE.csv or FILE.npy with a set of your own; without it, the known sets "
            "are listed."
        ),
    ] = None,
    output: Annotated[
        Path | None,
        option(
            "-o", "--output", help="FILE.svg, .pdf, .dxf, .png or .npy; default an SVG named after the set."
        ),
    ] = None,
    width: Annotated[int, option(help="Width of the window in cells; default 40.")] = 40,
    height: Annotated[int, option(help="Height of the window in cells; default 30.")] = 30,
    x: Annotated[int, option(help="West-most cell of the window, anywhere on the plane; default 0.")] = 0,
    y: Annotated[int, option(help="North-most cell of the window; default 0.")] = 0,
    set: Annotated[bool, option("--set", help="Draw the tiles themselves instead of a tiling.")] = False,
    to: Annotated[
        str | None,
        option(
            help="Convert the set first: to a corner set by diagonal, horizontal, vertical, rotation or "
            "subdivision, or to a Wang set by wang; default not."
        ),
    ] = None,
    period: Annotated[
        tuple[int, int] | None,
        option(
            metavar="W H",
            help="Look for the smallest torus that the set tiles, up to W x H cells; default not.",
        ),
    ] = None,
    shape: Annotated[
        str, option(help="What the colors of your own set are on: wang (default), corner or corner-coded.")
    ] = "wang",
    seed: Annotated[int, option("--seed", help="Which of the tilings, from 0 on; default 0.")] = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Tile the plane with an aperiodic set and draw it, or draw the set; or list the sets.

    An aperiodic set tiles the plane, but no tiling by it repeats. A set of your own has a row for each tile,
    with columns N, E, S, W for Wang tiles and NE, SE, SW, NW for corner tiles; it tiles a rectangle. A .npy
    output holds tile indices, shape (height, width), or with --set the colors of each tile.

    Example: tilewright aperiodic

    Example: tilewright aperiodic jeandel-rao-11-5 -o tiling.svg --x 1000000 --width 60

    Example: tilewright aperiodic kari-14 --to vertical --set

    Example: tilewright aperiodic lagae-44 --period 5 5

    Calls tilewright.jobs.AperiodicJob(...).run(). That lays
    tilewright.aperiodic_tiling(tilewright.aperiodic_tiles(name), seed), with --to its
    translated_tiling(tiling, to), with --period periodic_tiling(tiles, ...), and a set of your own by
    filled_tiling(tiles, width, height, seed=seed); then draw_tiling(...) draws it, or paint_tiling(...) for
    a PNG, and with --set draw_tiles(...) or paint_tiles(...).
    """
    perform("AperiodicJob", locals())
