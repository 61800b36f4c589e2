"""The command ``export``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Folder, Json, LatticeSeed, Map, Seed
from tilewright.cli.performing import perform


def command(
    folder: Folder,
    output: Annotated[
        Path,
        typer.Option("-o", "--output", help="Folder to write; or a picture of one map.", show_default=False),
    ],
    to: Annotated[
        str,
        typer.Option(
            help="threejs, godot, unity, unreal, blender, glsl, hlsl, wgsl, osl, ktx2, atlas (a packing) or "
            "array (one layer per tile; a picture only)."
        ),
    ] = "atlas",
    map: Map = None,
    lattice_seed: LatticeSeed = 0,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write a tile set for an engine or another program.

    Example: tilewright export moss --to godot -o moss-godot

    Example: tilewright export moss --to atlas -o moss-atlas.png

    Calls tilewright.save_for_engine(material, folder, to, seed=lattice_seed); with -o FILE.png, .tif or .exr
    tilewright.save_atlas(material, path, map=map) or tilewright.save_array(material, path, map=map).
    Nothing here depends on --seed: it is the seed of construction.
    """
    perform("ExportJob", locals())
