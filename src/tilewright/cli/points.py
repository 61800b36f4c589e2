"""The command ``points``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Force, Json, LatticeSeed, Quiet, option
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path | None,
        option(
            "-o",
            "--output",
            help="FILE.npy, .npz, .csv, .txt, .ply or .parquet; default METHOD-points.npy.",
        ),
    ] = None,
    count: Annotated[
        int | None, option(help="Exact number of points; default as many as the window holds.")
    ] = None,
    width: Annotated[
        float | None,
        option(
            help="Width of the window in tiles, or of a sampler's box; default by --count, or a box of 1."
        ),
    ] = None,
    height: Annotated[float | None, option(help="Height of the same; default as for --width.")] = None,
    x: Annotated[float, option(help="West side of the window in tiles; default 0.")] = 0,
    y: Annotated[float, option(help="North side of the window in tiles; default 0.")] = 0,
    torus: Annotated[bool, option(help="Let opposite sides of the window meet; default no.")] = False,
    method: Annotated[
        str,
        option(
            help="Kind of point tiles: corner (default), corner-relaxed, edge, template, shade, hiller or "
            "kopf; or the name of a sampler, such as dart or lloyd."
        ),
    ] = "corner",
    tiles: Annotated[
        Path | None, option(help="Tile-set folder of points to take instead of --method; default none.")
    ] = None,
    save: Annotated[
        Path | None, option(help="Folder in which the point tiles are kept too; default none.")
    ] = None,
    colors: Annotated[int, option(help="Number of colors of corner tiles, 2 to 8; default 4.")] = 4,
    points: Annotated[
        int | None, option(help="Number of points in each tile; default the method's own, 32 for corner.")
    ] = None,
    rho: Annotated[
        float | None,
        option(
            help="Relative radius: the least distance of two points over that of the densest packing, 0 "
            "to 1; default the method's own, 0.75 for corner."
        ),
    ] = None,
    lattice_seed: LatticeSeed = 0,
    seed: Annotated[
        int, option("--seed", help="Seed of the point tiles, or of a sampler, from 0 on; default 0.")
    ] = 0,
    note: Annotated[
        bool,
        option(
            help="Begin a .csv or .txt with a line # tilewright {...} of box, seeds and promise; default no. "
            ".npz, .ply and .parquet always hold them."
        ),
    ] = False,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Write blue-noise points: any window of an endless plane by tiles, or a set by a sampler without tiles.

    Give --count, or --width and --height, or all three. With tiles, --count alone fills the smallest square
    of whole tiles and leaves out the points that come last by rank. A sampler needs --count.

    Example: tilewright points --count 1000000 -o points.npy

    Example: tilewright points --width 500 --height 300 --rho 0.7 --colors 6 -o points.parquet

    Example: tilewright points --method lloyd --count 4096 --torus -o lloyd.csv

    Calls tilewright.jobs.PointsJob(...).run(). That lays tilewright.PointField(tiles, tilewright.direct(...))
    and takes its sample_blocks(count), sample(...), blocks(...) or torus(). The tiles are ready_tiles(...)
    where such a set comes with the package, else make_point_tiles(method, ...). Samplers are
    sample_points(method, ...). The file is written by write_points(...).
    """
    perform("PointsJob", locals())
