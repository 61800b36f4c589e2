"""The command ``pack``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", help="FILE.png, .svg or .npy; else corner-2-packing.png.", show_default=False
        ),
    ] = None,
    tiles: Annotated[str, typer.Option(help="corner or wang.")] = "corner",
    colors: Annotated[int, typer.Option(help="1 to 16.")] = 2,
    method: Annotated[
        str, typer.Option(help="closed, search (up to 3 colors; --seed matters) or recursive.")
    ] = "closed",
    count: Annotated[bool, typer.Option("--count", help="Count all packings; 2 colors.")] = False,
    piece_mm: Annotated[float, typer.Option(help="FILE.svg: size of a piece in mm.")] = 30,
    picture: Annotated[
        Path | None, typer.Option(help="FILE.svg: a PNG or JPEG to print on the pieces.")
    ] = None,
    engrave: Annotated[str, typer.Option(help="FILE.svg: none, colors or numbers.")] = "none",
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write a tile packing: every tile of the complete set once, on a torus, neighbors matching.

    FILE.npy holds tile indices, shape (C^2, C^2); FILE.svg is a jigsaw puzzle for a laser cutter, with pieces
    that fit where colors agree; FILE.png shows the packing.

    Example: tilewright pack --tiles corner --colors 4 -o packing.npy

    Example: tilewright pack --colors 3 --method search --seed 7 --picture photo.jpg -o puzzle.svg

    Calls tilewright.packing(tilewright.corner_tiles(colors)).indices(0, 0, C^2, C^2), or random_packing,
    recursive_packing, count_packings and draw_jigsaw. Only what is found by search depends on --seed.
    """
    perform("PackJob", locals())
