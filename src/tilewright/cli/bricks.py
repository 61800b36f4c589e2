"""The command ``bricks``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path,
        typer.Option("-o", "--output", help="FILE.png, .tif, .svg, .npy, or a folder of maps."),
    ] = Path("wall.png"),
    width: Annotated[int | None, typer.Option(help="Cells, 12; bricks are a cell on average.")] = None,
    height: Annotated[int | None, typer.Option(help="Cells, 20.")] = None,
    x: Annotated[int, typer.Option(help="West cell; any place of an endless wall.")] = 0,
    y: Annotated[int, typer.Option(help="North cell.")] = 0,
    pattern: Annotated[
        str, typer.Option(help="wang, or running-bond, flemish-bond, herringbone, basket-weave.")
    ] = "wang",
    positions: Annotated[int, typer.Option(help="Where joints may meet an edge, 2 to 16.")] = 3,
    longest: Annotated[
        tuple[int, int],
        typer.Option(help="Most cells that a joint runs along x and along y; endless, 2 to 8."),
    ] = (3, 3),
    input: Annotated[
        Path | None, typer.Option(help="Picture to follow: joints run along x where it is dark.")
    ] = None,
    cyclic: Annotated[bool, typer.Option(help="Let the wall close, so that it can be repeated.")] = False,
    mask: Annotated[Path | None, typer.Option(help="Picture of a region, light inside.")] = None,
    boundary: Annotated[
        Path | None, typer.Option(help="FILE.npz of positions asked for: horizontal, vertical.")
    ] = None,
    size: Annotated[tuple[int, int], typer.Option(help="Width and height of a cell in pixels.")] = (144, 48),
    colors: Annotated[str, typer.Option(help="red, yellow, sandstone or gray.")] = "red",
    mortar: Annotated[int | None, typer.Option(help="Pixels between bricks.")] = None,
    bevel: Annotated[float | None, typer.Option(help="Pixels of the rounded edge of a brick.")] = None,
    map: Annotated[
        str | None,
        typer.Option(
            help="Of a picture: preview, the default, color, height, normal, roughness, mortar, id.",
            show_default=False,
        ),
    ] = None,
    lines: Annotated[bool, typer.Option(help="Of an SVG: the joints as lines.")] = False,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Lay a wall of bricks and draw it: lit, as a folder of maps, as SVG; or write its tiles.

    Example: tilewright bricks -o wall.png --width 12 --height 20

    Example: tilewright bricks -o wall --width 16 --height 48 --cyclic --colors sandstone

    Example: tilewright bricks -o face.svg --input face.png --width 60 --height 90 --longest 4 4

    Calls tilewright.BrickField(wall, tilewright.BrickStyle(...), size=size).save(output, ...), for SVG
    tilewright.draw_wall(...). The wall is tilewright.endless_brick_tiling(positions, ...); with --input
    or --cyclic tilewright.brick_tiling(classes, ...) over tilewright.dapple(start, ...); with --mask or
    --boundary tilewright.brick_region(mask, ...); other patterns are tilewright.BondBricks(pattern, size).
    """
    perform("BricksJob", locals())
