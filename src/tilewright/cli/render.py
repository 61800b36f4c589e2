"""The command ``render``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Folder, Force, Json, LatticeSeed, NoSeed, Quiet, option
from tilewright.cli.performing import perform


def command(
    folder: Folder,
    output: Annotated[
        Path | None,
        option("-o", "--output", help="Picture: FILE.png, .tif, .exr, .jpg or .webp; default SET.png."),
    ] = None,
    width: Annotated[int, option(help="Width of the window in pixels; default 2048.")] = 2048,
    height: Annotated[int, option(help="Height of the window in pixels; default 2048.")] = 2048,
    x: Annotated[int, option(help="West-most pixel of the window, anywhere on the plane; default 0.")] = 0,
    y: Annotated[int, option(help="North-most pixel of the window; default 0.")] = 0,
    map: Annotated[
        str | None,
        option("--map", help="Name of the map; default the set's main map; all writes a folder."),
    ] = None,
    scale: Annotated[
        float, option(help="Number of pixels of the picture for each of the window; default 1.")
    ] = 1.0,
    density: Annotated[
        Path | None,
        option(
            help="Gray picture that says where a set of two photographs shows the second; default by chance."
        ),
    ] = None,
    cells_per_pixel: Annotated[
        float, option(help="Number of tiles along a pixel of --density; default 1.")
    ] = 1.0,
    lattice_seed: LatticeSeed = 0,
    seed: NoSeed = None,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Render a window of the endless plane.

    The picture is written in pieces, so it may be larger than memory. Where a set has no direct tiling, which
    knows the tile of any cell at once, the plane starts at pixel (0, 0).

    Example: tilewright render moss -o wall.tif --x -1000 --width 65536 --height 65536

    Example: tilewright render both -o path.png --density path-map.png --width 8192 --height 8192

    Calls tilewright.jobs.RenderJob(...).run(). That saves by
    tilewright.TextureField(material, tiling).save(...). The tiling is stochastic(material.tiles, ...), or
    with --density density_tiling(material.tiles, gray, ...).
    """
    perform("RenderJob", locals())
