"""The command ``export``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Folder, Force, Json, LatticeSeed, NoSeed, Quiet, option
from tilewright.cli.performing import perform


def command(
    folder: Folder,
    output: Annotated[
        Path | None,
        option(
            "-o",
            "--output",
            help="Folder to write, or one picture FILE.png, .tif or .exr; default a folder SET-TARGET.",
        ),
    ] = None,
    to: Annotated[
        str,
        option(
            help="Target: threejs, godot, unity, unreal, blender, glsl, hlsl, wgsl, osl, ktx2, atlas (the "
            "default: all tiles packed into one picture) or array (the tiles one below the other; a picture "
            "only)."
        ),
    ] = "atlas",
    map: Annotated[
        str | None, option("--map", help="Name of the map that a picture shows; default the set's main map.")
    ] = None,
    lattice_seed: LatticeSeed = 0,
    seed: NoSeed = None,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Write a tile set for an engine or another program.

    Example: tilewright export moss --to godot -o moss-godot

    Example: tilewright export moss --to atlas -o moss-atlas.png

    Calls tilewright.jobs.ExportJob(...).run(). That writes tilewright.save_for_engine(material, folder, to,
    seed=lattice_seed), or for a picture save_atlas(material, path, map=map) or
    save_array(material, path, map=map).
    """
    perform("ExportJob", locals())
