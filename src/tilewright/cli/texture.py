"""The command ``texture``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import (
    DryRun,
    Force,
    Json,
    Quiet,
    Seed,
    argument,
    option,
    parse_pairs,
    parse_size,
    parse_spots,
    parse_weights,
)
from tilewright.cli.performing import perform


def command(
    photo: Annotated[
        Path | None,
        argument(
            help="The photograph, or a folder of a material's maps (FOLDER/NAME where it holds several); or "
            "give --map, --from or --like."
        ),
    ] = None,
    output: Annotated[
        Path | None,
        option(
            "-o",
            "--output",
            help="Folder for the tile set; default PHOTO-tiles, or with --like the folder named there.",
        ),
    ] = None,
    tiles: Annotated[
        str | None,
        option(
            help="Tile set: corner, wang, cohen-8, cohen-12, cohen-18 or corner-coded; default what suits "
            "the photograph, or corner with an older method."
        ),
    ] = None,
    colors: Annotated[
        int | None,
        option(help="Number of colors of corner or wang, 1 to 16; default 2, or 4 for corner with --second."),
    ] = None,
    tile_size: Annotated[
        str | None,
        option(
            help="Size of a tile in pixels, even, 16 to 1024, or auto; default what suits the photograph, "
            "or 128 with an older method."
        ),
    ] = None,
    method: Annotated[
        str | None,
        option(
            help="How tiles are made: faithful, nested, ng or squares for corners; centered-diamonds "
            "(default), diamonds or burke for Wang tiles. Default faithful, which keeps the tones, courses "
            "and the seldom things of the photograph; nested over a set that is named."
        ),
    ] = None,
    tone: Annotated[
        bool | None,
        option(
            "--tone/--no-tone",
            help="Whether tone larger than a tile is laid outside the tiles, with method faithful; default "
            "where it belongs to no things.",
        ),
    ] = None,
    map: Annotated[
        list[str] | None, option("--map", metavar="NAME=FILE", help="Map of a material, once for each map.")
    ] = None,
    kind: Annotated[
        list[str] | None,
        option(
            metavar="NAME=KIND",
            help="What a map holds: color, data, roughness, height, normal-gl or normal-dx; "
            "default as its name tells.",
        ),
    ] = None,
    weight: Annotated[
        list[str] | None,
        option(
            metavar="NAME=NUMBER", help="What a map counts in the cut; default 1 for color, 0.1 for others."
        ),
    ] = None,
    normal: Annotated[
        str | None,
        option(help="Whether green of normal maps points up (gl) or down (dx); default found from the maps."),
    ] = None,
    flatten: Annotated[
        bool, option("--flatten", help="Take out light that varies slowly, which shows repetition.")
    ] = False,
    mask: Annotated[
        Path | None, option(help="Picture that is white where pixels may be copied; default everywhere.")
    ] = None,
    second: Annotated[
        Path | None,
        option(
            help="Second photograph, shown by the upper half of the corner colors; default none. Over 4 "
            "colors, the default, there are 256 tiles, which take minutes; --colors 2 makes 16."
        ),
    ] = None,
    variants: Annotated[
        int, option(help="Number of pictures of every tile, 1 to 256; default 1. More show less repetition.")
    ] = 1,
    from_: Annotated[
        Path | None,
        option("--from", help="Tile-set folder to make again, with --reject or --pick; default none."),
    ] = None,
    reject: Annotated[
        list[str] | None,
        option(metavar="NAME", help="Name of a patch that must come from elsewhere, such as center:5."),
    ] = None,
    reseed_rest: Annotated[
        bool,
        option(
            "--reseed-rest",
            help="With --from, search for all patches again; default no: the others stay where they are.",
        ),
    ] = False,
    pick: Annotated[
        list[str] | None,
        option(metavar="NAME=SOURCE,Y,X", help="Place in a source, in pixels, for a patch by name."),
    ] = None,
    like: Annotated[
        Path | None,
        option(help="Tile-set folder to which the maps of --map are added, cut as it was; default none."),
    ] = None,
    threads: Annotated[int | None, option(help="Number of threads; default all processors.")] = None,
    seed: Seed = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Make texture tiles from a photograph, or from the maps of a scanned material.

    Example: tilewright texture moss.jpg -o moss --colors 3 --seed 1

    Example: tilewright texture --map albedo=a.png --map normal=n.png --map roughness=r.exr -o moss

    Example: tilewright texture --like moss --map emissive=e.png

    Calls tilewright.jobs.TextureJob(...).run(). That makes tilewright.texture_tiles(photo, tiles, ...), with
    --from resynthesize(material, reject=..., pick=...) or with --like add_maps(material, maps), and saves it
    by save(material, folder).
    """
    perform(
        "TextureJob",
        locals()
        | {
            "tile_size": None if tile_size is None else parse_size(tile_size),
            "map": parse_pairs("--map", map),
            "weight": parse_weights(weight),
            "kind": parse_pairs("--kind", kind),
            "pick": parse_spots(pick),
        },
    )
