"""tilewright export"""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.checks import check_choice
from tilewright.cli.options import Folder, Json, LatticeSeed, Map, Seed, report
from tilewright.errors import TilewrightValueError

_PICTURES = (".png", ".tif", ".tiff", ".exr", ".jpg", ".jpeg", ".bmp", ".tga", ".webp")


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
    from tilewright.export import TARGETS, save_array, save_atlas, save_for_engine
    from tilewright.files import load_texture

    if output.suffix.lower() in _PICTURES:
        write = {"array": save_array, "atlas": save_atlas}[check_choice("--to", to, ("array", "atlas"))]
        write(load_texture(folder), output, map=map)
        report({"file": str(output), "bytes": output.stat().st_size}, json, f"{output}")
        return
    if map is not None:
        raise TilewrightValueError("--map is for a picture, -o FILE.png; a folder holds all maps")
    save_for_engine(load_texture(folder), output, check_choice("--to", to, TARGETS), seed=lattice_seed)
    files = [path for path in output.rglob("*") if path.is_file()]
    size = sum(path.stat().st_size for path in files)
    report(
        {"folder": str(output), "files": len(files), "bytes": size},
        json,
        f"{output}: {len(files)} files, {size / 1e6:.1f} MB; begin with {output / 'README.md'}",
    )
