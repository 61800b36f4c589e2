"""tilewright view"""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Folder, Json, LatticeSeed, Seed, report


def command(
    folder: Folder,
    output: Annotated[Path, typer.Option("-o", "--output", help="FILE.html", show_default=False)],
    lattice_seed: LatticeSeed = 0,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write a page to pan, zoom and tilt over the endless plane; it works offline.

    Example: tilewright view moss -o moss.html

    Calls tilewright.save_viewer(material, path, seed=lattice_seed).
    """
    from tilewright.export import save_viewer
    from tilewright.files import load_texture

    save_viewer(load_texture(folder), output, seed=lattice_seed)
    size = output.stat().st_size
    report({"file": str(output), "bytes": size}, json, f"{output}: {size / 1e6:.1f} MB")
