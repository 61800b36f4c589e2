"""The command ``surface``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import DryRun, Force, Json, Quiet, option
from tilewright.cli.performing import perform


def command(
    mesh: Annotated[
        Path,
        typer.Argument(
            metavar="MESH",
            help="The mesh: FILE.obj, .off or .ply; by trimesh also .stl, .glb and others.",
        ),
    ],
    output: Annotated[
        Path | None,
        option(
            "-o",
            "--output",
            help="FILE.npy (positions), .ply, .csv, .parquet or .usda; default MESH-points.npy.",
        ),
    ] = None,
    count: Annotated[int | None, option(help="Exact number of points; or give --radius.")] = None,
    radius: Annotated[
        float | None, option(help="Half of the least distance, in the mesh's units; or give --count.")
    ] = None,
    density: Annotated[
        str | None,
        option(
            metavar="NAME|FILE",
            help="Where points lie closer: a picture over the mesh's texture coordinates, dense where it is "
            "bright, or the name of a property that a PLY mesh holds for every vertex or face; default "
            "everywhere alike.",
        ),
    ] = None,
    kind: Annotated[
        str,
        option(
            help="even (default), poisson for more chance, or tiles for the points of the tiles as they are."
        ),
    ] = "even",
    rho: Annotated[
        float | None,
        option(
            help="Relative radius: the least distance over that of the densest packing; default 0.765, of "
            "tiles 0.7."
        ),
    ] = None,
    seed: Annotated[int, option("--seed", help="Seed of the points, from 0 on; default 0.")] = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Spread points over a mesh: exactly so many, evenly, the same for the same seed.

    Faces of any number of corners are taken as they are. What cannot be tiled is mended first: vertices at
    the same place are welded, faces turned alike, and edges of more than two faces cut; a note says so.

    Example: tilewright surface bunny.obj --count 40000 -o points.ply

    Example: tilewright surface bunny.ply --count 5000 --density quality -o points.usda

    Example: tilewright surface bunny.obj --count 5000 --kind poisson --seed 3 -o points.csv

    Calls tilewright.jobs.SurfaceJob(...).run(). That is surface_points(read_mesh(mesh), count, ...), written
    by write_surface_points(...).
    """
    perform("SurfaceJob", locals())
