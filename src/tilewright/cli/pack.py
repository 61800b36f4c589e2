"""The command ``pack``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Force, Json, Quiet, option
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path | None,
        option(
            "-o",
            "--output",
            help="Picture FILE.png, jigsaw puzzle FILE.svg, .pdf or .dxf, or tile indices FILE.npy; default "
            "a PNG named after the set.",
        ),
    ] = None,
    tiles: Annotated[str, option(help="Kind of tiles: corner (default) or wang.")] = "corner",
    colors: Annotated[int, option(help="Number of colors C, 1 to 16; default 2.")] = 2,
    method: Annotated[
        str,
        option(
            help="How the packing is found: closed (default), in closed form; search, up to 3 colors; or "
            "recursive, with the packings over fewer colors inside."
        ),
    ] = "closed",
    count: Annotated[bool, option("--count", help="Count all packings, over 2 colors.")] = False,
    piece_mm: Annotated[float, option(help="Size of a puzzle piece in millimeters; default 30.")] = 30,
    picture: Annotated[
        Path | None, option(help="PNG or JPEG to print on the pieces of a puzzle; default none.")
    ] = None,
    engrave: Annotated[
        str, option(help="What is engraved on the pieces of a puzzle: none (default), colors or numbers.")
    ] = "none",
    kerf: Annotated[
        float | None,
        option(
            help="Width of the laser's cut in millimeters, up to 2 % of a piece: pieces are cut apart, each "
            "in its nominal size; default one cut between two pieces."
        ),
    ] = None,
    sheet: Annotated[
        tuple[int, int] | None,
        option(
            metavar="W H",
            help="Lay pieces apart on sheets of W x H millimeters: pages of a PDF, or FILE-1, FILE-2 and so "
            "on; default one sheet as large as needed.",
        ),
    ] = None,
    seed: Annotated[
        int, option("--seed", help="Which packing --method search finds, from 0 on; default 0.")
    ] = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Write a tile packing: every tile of the complete set once, on a torus, neighbors matching.

    FILE.npy holds tile indices, shape (C^2, C^2); FILE.svg, .pdf or .dxf is a jigsaw puzzle for a
    laser cutter, with pieces that fit where colors agree; FILE.png shows the packing.

    Example: tilewright pack --tiles corner --colors 4 -o packing.npy

    Example: tilewright pack --colors 3 --method search --seed 7 --picture photo.jpg -o puzzle.svg

    Example: tilewright pack --colors 3 -o puzzle.pdf --kerf 0.15 --sheet 600x400

    Calls tilewright.jobs.PackJob(...).run(). That packs by
    tilewright.packing(tilewright.corner_tiles(colors)), random_packing(...) or recursive_packing(...),
    counts by count_packings(...), and draws by draw_jigsaw(...), draw_jigsaw_sheets(...) or
    paint_tiling(...).
    """
    perform("PackJob", locals())
