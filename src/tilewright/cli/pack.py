"""tilewright pack"""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed, report
from tilewright.errors import TilewrightValueError, check_choice


def command(
    output: Annotated[Path, typer.Option("-o", "--output", help="FILE.npy", show_default=False)],
    tiles: Annotated[str, typer.Option(help="corner or wang.")] = "corner",
    colors: Annotated[int, typer.Option(help="1 to 16.")] = 2,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write a tile packing: every tile of the complete set once, on a torus, neighbors matching.

    The file holds tile indices, shape (C^2, C^2).

    Example: tilewright pack --tiles corner --colors 4 -o packing.npy

    Calls tilewright.packing(tilewright.corner_tiles(colors)).indices(0, 0, C^2, C^2). The packing is in
    closed form: nothing depends on --seed.
    """
    import numpy as np

    from tilewright.files.whole import whole_file
    from tilewright.tiles import corner_tiles, wang_tiles
    from tilewright.tilings import packing

    make = {"corner": corner_tiles, "wang": wang_tiles}[check_choice("--tiles", tiles, ("corner", "wang"))]
    if output.suffix != ".npy":
        raise TilewrightValueError(f"{output} ends in {output.suffix or 'nothing'!r}; expected .npy")
    packed = packing(make(colors))
    with whole_file(output) as unfinished:
        np.save(unfinished, packed.indices(0, 0, *packed.size))
    report(
        {"file": str(output), "tiles": len(packed.tiles), "size": list(packed.size)},
        json,
        f"{output}: {len(packed.tiles)} tiles, {packed.size[0]} x {packed.size[1]}",
    )
