"""tilewright export"""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Folder, Json, Map, Seed, report
from tilewright.errors import check_choice


def command(
    folder: Folder,
    output: Annotated[Path, typer.Option("-o", "--output", help="File to write.", show_default=False)],
    to: Annotated[str, typer.Option(help="array (one layer per tile) or atlas (a packing).")] = "atlas",
    map: Map = None,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write a tile set for another program.

    Example: tilewright export moss --to atlas -o moss-atlas.png

    Calls tilewright.save_atlas(material, path, map=map) or tilewright.save_array(material, path, map=map).
    """
    from tilewright.export import save_array, save_atlas
    from tilewright.files import load_texture

    write = {"array": save_array, "atlas": save_atlas}[check_choice("--to", to, ("array", "atlas"))]
    write(load_texture(folder), output, map=map)
    report({"file": str(output), "bytes": output.stat().st_size}, json, f"{output}")
