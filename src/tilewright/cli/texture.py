"""The command ``texture``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed, parse_pairs, parse_size, parse_spots, parse_weights
from tilewright.cli.performing import perform


def command(
    photo: Annotated[
        Path | None,
        typer.Argument(
            help="The photograph, or a folder of a material's maps; or give --map, or --from.",
            show_default=False,
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="Folder for the tile set: tiles; with --like, that one."),
    ] = None,
    tiles: Annotated[
        str, typer.Option(help="corner, wang, cohen-8, cohen-12, cohen-18 or corner-coded.")
    ] = "corner",
    colors: Annotated[int | None, typer.Option(help="Colors of the complete set.")] = None,
    tile_size: Annotated[str, typer.Option(help="Pixels along a tile (even), or auto.")] = "128",
    map: Annotated[
        list[str] | None, typer.Option("--map", help="NAME=FILE, for each map of a stack.")
    ] = None,
    weight: Annotated[
        list[str] | None, typer.Option(help="NAME=NUMBER: what a map counts in the cut.")
    ] = None,
    kind: Annotated[
        list[str] | None,
        typer.Option(help="NAME=color|data|roughness|height|normal-gl|normal-dx: what a map holds."),
    ] = None,
    normal: Annotated[
        str | None, typer.Option(help="gl or dx: green of normal maps points up or down.")
    ] = None,
    flatten: Annotated[
        bool, typer.Option("--flatten", help="Take out light that varies slowly, which shows repetition.")
    ] = False,
    mask: Annotated[Path | None, typer.Option(help="Picture: white may be copied.")] = None,
    second: Annotated[Path | None, typer.Option(help="Second photograph, for marked corners.")] = None,
    method: Annotated[str | None, typer.Option(help="How tiles are made; see the documentation.")] = None,
    variants: Annotated[int, typer.Option(help="Pictures of every tile: less repetition.")] = 1,
    from_: Annotated[
        Path | None, typer.Option("--from", help="Make this set again, with --reject or --pick.")
    ] = None,
    like: Annotated[
        Path | None, typer.Option(help="Cut the maps given by --map as this set was cut, and add them to it.")
    ] = None,
    reject: Annotated[list[str] | None, typer.Option(help="Name of a patch: not this one.")] = None,
    pick: Annotated[list[str] | None, typer.Option(help="NAME=SOURCE,Y,X: take a patch from there.")] = None,
    threads: Annotated[int | None, typer.Option(help="All processors by default.")] = None,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Make texture tiles from a photograph.

    Example: tilewright texture moss.jpg -o moss --colors 3 --seed 1

    Example: tilewright texture --map albedo=a.png --map normal=n.png --map roughness=r.exr -o moss

    Example: tilewright texture --like moss --map emissive=e.png

    Calls tilewright.texture_tiles(photo, tiles, ...) and tilewright.save(material, folder); with --from
    tilewright.resynthesize(material, reject=..., pick=...); with --like tilewright.add_maps(material, maps).
    """
    perform(
        "TextureJob",
        locals()
        | {
            "tile_size": parse_size(tile_size),
            "map": parse_pairs("--map", map),
            "weight": parse_weights(weight),
            "kind": parse_pairs("--kind", kind),
            "pick": parse_spots(pick),
        },
    )
