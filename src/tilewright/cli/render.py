"""tilewright render"""

import time
from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Folder, Json, LatticeSeed, Map, Seed, progress_bar, report


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
    lattice_seed: LatticeSeed = 0,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Render a window of the endless plane.

    Example: tilewright render moss -o wall.tif --x -1000 --width 65536 --height 65536

    Calls tilewright.TextureField(material, tilewright.direct(material.tiles, lattice_seed)).save(...). Sets
    without a direct tiling are laid by tilewright.scanline, from cell (0, 0) on. Nothing here depends
    on --seed: it is the seed of construction.
    """
    from tilewright.cli.laying import lay
    from tilewright.fields import TextureField
    from tilewright.files import load

    started = time.perf_counter()
    material = load(folder)
    tiling = lay(material, lattice_seed, x + width, y + height)
    with progress_bar() as progress:
        TextureField(material, tiling).save(output, x, y, width, height, map=map, progress=progress)
    seconds = time.perf_counter() - started
    report(
        {"file": str(output), "width": width, "height": height, "seconds": round(seconds, 3)},
        json,
        f"{output}: {width} x {height} pixels in {seconds:.1f} s",
    )
