"""The command ``render``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Folder, Json, LatticeSeed, Map, Seed
from tilewright.cli.performing import perform


def command(
    folder: Folder,
    output: Annotated[
        Path, typer.Option("-o", "--output", help="FILE.png, .tif or .exr.", show_default=False)
    ],
    width: Annotated[int, typer.Option(help="Pixels.", show_default=False)],
    height: Annotated[int, typer.Option(help="Pixels.", show_default=False)],
    x: Annotated[int, typer.Option(help="West pixel; any place of the endless plane.")] = 0,
    y: Annotated[int, typer.Option(help="North pixel.")] = 0,
    map: Map = None,
    density: Annotated[
        Path | None, typer.Option(help="Gray picture that steers where a two-source set shows the second.")
    ] = None,
    cells_per_pixel: Annotated[float, typer.Option(help="Tiles along a pixel of --density.")] = 1.0,
    lattice_seed: LatticeSeed = 0,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Render a window of the endless plane.

    Example: tilewright render moss -o wall.tif --x -1000 --width 65536 --height 65536

    Example: tilewright render both -o path.png --density path-map.png --width 8192 --height 8192

    Calls tilewright.TextureField(material, tiling).save(...); the tiling is
    tilewright.stochastic(material.tiles, ...): the plane is endless where the set has a direct tiling, and
    starts at cell (0, 0) where it has not. With --density it is tilewright.density_tiling(material.tiles,
    gray, ...). Nothing here depends on --seed: it is the seed of construction.
    """
    perform("RenderJob", locals())
