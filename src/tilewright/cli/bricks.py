"""The command ``bricks``."""

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
            help="Picture FILE.png, .tif, .exr, .jpg or .webp, drawing FILE.svg, .pdf or .dxf, tiles "
            "FILE.npy, or a folder of all maps; default wall.png.",
        ),
    ] = None,
    width: Annotated[
        int | None,
        option(help="Width in cells, each as large as a brick is on average; default 12, or the region's."),
    ] = None,
    height: Annotated[int | None, option(help="Height in cells; default 20, or the region's.")] = None,
    x: Annotated[int, option(help="West-most cell, anywhere on an endless wall; default 0.")] = 0,
    y: Annotated[int, option(help="North-most cell; default 0.")] = 0,
    pattern: Annotated[
        str,
        option(
            help="How bricks lie: wang (default) by brick Wang tiles, or running-bond, flemish-bond, "
            "herringbone or basket-weave; also by names such as stretcher-bond, subway or basketweave."
        ),
    ] = "wang",
    positions: Annotated[
        int, option(help="Number of places where joints may meet an edge of a tile, 2 to 16; default 3.")
    ] = 3,
    longest: Annotated[
        tuple[int, int],
        option(
            help="Longest joint along x and along y in cells, 2 to 8 if the wall is endless; default 3 3."
        ),
    ] = (3, 3),
    input: Annotated[
        Path | None, option(help="Picture to follow: joints run along x where it is dark; default none.")
    ] = None,
    cyclic: Annotated[
        bool, option(help="Let the wall close, so that it can be repeated; default no.")
    ] = False,
    mask: Annotated[
        Path | None, option(help="Picture of a region to fill, light inside; default a rectangle.")
    ] = None,
    boundary: Annotated[
        Path | None,
        option(
            help="FILE.npz with the positions at which joints meet the sides: arrays horizontal and "
            "vertical; default free."
        ),
    ] = None,
    size: Annotated[tuple[int, int], option(help="Width and height of a cell in pixels; default 144 48.")] = (
        144,
        48,
    ),
    colors: Annotated[
        str,
        option(
            help="Colors of the bricks: red (default), yellow, sandstone or gray, or your own, as "
            "'#aa3333,#884422'."
        ),
    ] = "red",
    mortar: Annotated[
        int | None,
        option(help="Width of the mortar in pixels; default an eighth of the height of a brick, or less."),
    ] = None,
    bevel: Annotated[
        float | None,
        option(help="Width of a brick's rounded edge in pixels; default 0.8 times the mortar."),
    ] = None,
    map: Annotated[
        str | None,
        option(
            help="What a picture shows: preview (default), color, height, normal, roughness, mortar or id."
        ),
    ] = None,
    lines: Annotated[
        bool, option(help="In a drawing, draw the joints as lines instead of bricks; default no.")
    ] = False,
    seed: Annotated[
        int, option("--seed", help="Seed of the wall and of how bricks look, from 0 on; default 0.")
    ] = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Lay a wall of bricks and draw it: lit, as a folder of maps, or as SVG; or write its tiles.

    Example: tilewright bricks -o wall.png --width 12 --height 20

    Example: tilewright bricks -o wall --width 16 --height 48 --cyclic --colors sandstone

    Example: tilewright bricks -o face.svg --input face.png --width 60 --height 90 --longest 4 4

    Calls tilewright.jobs.BricksJob(...).run(). That draws by tilewright.BrickField(wall,
    tilewright.BrickStyle(...), size=size).save(output, ...), or for an SVG by draw_wall(...). The wall is
    endless_brick_tiling(positions, ...); with --input or --cyclic it is brick_tiling(classes, ...) over
    dapple(start, ...), with --mask or --boundary brick_region(mask, ...), and with another --pattern
    BondBricks(pattern, size).
    """
    perform("BricksJob", locals())
