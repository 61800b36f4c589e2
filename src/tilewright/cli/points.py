"""The command ``points``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, LatticeSeed, Seed
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path, typer.Option("-o", "--output", help="FILE.npy, .csv, .parquet or .ply.", show_default=False)
    ],
    method: Annotated[
        str,
        typer.Option(
            help="Tiles: corner, corner-relaxed, edge, template, shade, hiller, kopf. Or a sampler."
        ),
    ] = "corner",
    tiles: Annotated[
        Path | None,
        typer.Option(help="A tile-set folder of points, instead of --method.", show_default=False),
    ] = None,
    save: Annotated[
        Path | None, typer.Option(help="Also keep the point tiles in this folder.", show_default=False)
    ] = None,
    colors: Annotated[int, typer.Option(help="Colors of corner tiles, 2 to 8.")] = 4,
    points: Annotated[int | None, typer.Option(help="Points per tile; usually 32.")] = None,
    rho: Annotated[float | None, typer.Option(help="Relative radius; usually 0.75.")] = None,
    count: Annotated[int | None, typer.Option(help="Exactly so many points.", show_default=False)] = None,
    width: Annotated[float | None, typer.Option(help="Of the window, in tiles.", show_default=False)] = None,
    height: Annotated[float | None, typer.Option(help="In tiles.", show_default=False)] = None,
    x: Annotated[float, typer.Option(help="West side of the window, in tiles.")] = 0,
    y: Annotated[float, typer.Option(help="North side.")] = 0,
    torus: Annotated[bool, typer.Option(help="Let opposite sides of the window meet.")] = False,
    lattice_seed: LatticeSeed = 0,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write blue-noise points: of tiles, as many as you like, or of a method without tiles.

    Example: tilewright points --count 1000000 -o points.npy

    Example: tilewright points --width 500 --height 300 --rho 0.7 --colors 6 -o points.parquet

    Example: tilewright points --method lloyd --count 4096 --torus -o lloyd.csv

    With tiles, --count alone fills the smallest square of whole tiles and leaves out points by rank; samplers
    fill a square of side 1, or --width by --height. Calls tilewright.PointField(tiles,
    tilewright.direct(...)) and its sample_blocks(count), sample(...), blocks(...) or torus(); the tiles are
    tilewright.ready_tiles(...) where such a set comes with the package, else
    tilewright.make_point_tiles(method, ...).
    Samplers are tilewright.sample_points(method, ...).
    """
    perform("PointsJob", locals())
