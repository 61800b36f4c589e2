"""tilewright view"""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Folder, Json, LatticeSeed, Seed, progress_bar, report


def command(
    folder: Folder,
    output: Annotated[Path, typer.Option("-o", "--output", help="FILE.html", show_default=False)],
    compare: Annotated[
        bool,
        typer.Option(
            "--compare",
            help="Beside plain repeat, hex-tiling, by-example noise, and the other of Wang and corner tiles.",
        ),
    ] = False,
    lattice_seed: LatticeSeed = 0,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write a page to pan, zoom and tilt over the endless plane; it works offline.

    Example: tilewright view moss -o moss.html

    Example: tilewright view moss --compare -o moss-compared.html

    Calls tilewright.save_viewer(material, path, seed=lattice_seed); with --compare, and with compare=
    tilewright.compare_textures(material, seed=lattice_seed), whose figures --json prints.
    """
    from tilewright.analysis import compare_textures
    from tilewright.export import save_viewer
    from tilewright.export.viewer.page import check_page
    from tilewright.files import load_texture

    check_page(output)
    material = load_texture(folder)
    with progress_bar() as progress:
        compared = compare_textures(material, seed=lattice_seed, progress=progress) if compare else None
    save_viewer(material, output, seed=lattice_seed, compare=compared)
    size = output.stat().st_size
    figures = {"file": str(output), "bytes": size} | ({"methods": compared.figures} if compared else {})
    report(figures, json, f"{output}: {size / 1e6:.1f} MB")
