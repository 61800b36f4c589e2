"""tilewright texture"""

import time
from pathlib import Path
from typing import Annotated, Any

import typer

from tilewright.cli.options import Json, Seed, parse_pairs, progress_bar, report
from tilewright.errors import TilewrightError, TilewrightTypeError, TilewrightValueError, check_choice


def command(
    context: typer.Context,
    photo: Annotated[
        Path | None, typer.Argument(help="The photograph; or give --map, or --from.", show_default=False)
    ] = None,
    output: Annotated[Path, typer.Option("-o", "--output", help="Folder for the tile set.")] = Path("tiles"),
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
    mask: Annotated[Path | None, typer.Option(help="Picture: white may be copied.")] = None,
    second: Annotated[Path | None, typer.Option(help="Second photograph, for marked corners.")] = None,
    method: Annotated[str | None, typer.Option(help="How tiles are made; see the documentation.")] = None,
    from_: Annotated[
        Path | None, typer.Option("--from", help="Make this set again, with --reject or --pick.")
    ] = None,
    reject: Annotated[list[str] | None, typer.Option(help="Name of a patch: not this one.")] = None,
    pick: Annotated[list[str] | None, typer.Option(help="NAME=SOURCE,Y,X: take a patch from there.")] = None,
    threads: Annotated[int | None, typer.Option(help="All processors by default.")] = None,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Make texture tiles from a photograph.

    Example: tilewright texture moss.jpg -o moss --colors 3 --seed 1

    Calls tilewright.texture_tiles(photo, tiles, ...) and tilewright.save(material, folder); with --from
    tilewright.resynthesize(material, reject=..., pick=...).
    """
    from tilewright.files import load_texture, save, texture_tiles
    from tilewright.files.tileset_folder import check_savable
    from tilewright.signals.textures import resynthesize

    started = time.perf_counter()
    check_savable(output)
    picked = {name: _spot(name, value) for name, value in parse_pairs("--pick", pick or []).items()}
    with progress_bar() as progress:
        if from_ is not None:
            if kept := _given(context) - {"output", "from_", "reject", "pick", "threads", "json"}:
                raise TilewrightValueError(
                    f"--from makes the old set again, with its photograph and settings; leave out "
                    f"{', '.join(sorted(kept))}"
                )
            material = resynthesize(
                load_texture(from_), reject=reject or [], pick=picked, threads=threads, progress=progress
            )
        else:
            if reject:
                raise TilewrightValueError("--reject names patches of a set that exists; give it with --from")
            maps: Any = parse_pairs("--map", map or []) or photo
            if maps is None:
                raise TilewrightValueError("PHOTO is missing; give a photograph, or --map NAME=FILE")
            if photo is not None and map:
                if "albedo" in maps:
                    raise TilewrightValueError("albedo is given twice, as PHOTO and by --map; leave one out")
                maps = {"albedo": str(photo)} | maps
            material = texture_tiles(
                maps,
                _tile_set(tiles, colors, second is not None),
                second=second,
                mask=mask,
                weights={n: _number(n, v) for n, v in parse_pairs("--weight", weight or []).items()},
                tile_size=tile_size if tile_size == "auto" else _size(tile_size),
                seed=seed,
                method=method,
                pick=picked,
                threads=threads,
                progress=progress,
            )
    save(material, output)
    seconds = time.perf_counter() - started
    figures = {
        "folder": str(output),
        "tiles": len(material.tiles),
        "tile_size": material.tile_size,
        "maps": list(material.maps),
        "method": material.recipe["method"],
        "seed": material.recipe["seed"],
        "seconds": round(seconds, 3),
    }
    report(
        figures,
        json,
        f"{output}: {len(material.tiles)} {material.tiles.shape.name} tiles of {material.tile_size} x "
        f"{material.tile_size} pixels in {seconds:.1f} s",
    )


def _given(context: typer.Context) -> set[str]:
    """Names of the parameters that came from the command line."""
    sources = ((name, context.get_parameter_source(name)) for name in context.params)
    return {name for name, source in sources if source is not None and source.name == "COMMANDLINE"}


def _tile_set(kind: str, colors: int | None, two_sources: bool) -> Any:
    from tilewright.tiles import cohen_tiles, corner_coded_tiles, corner_tiles, wang_tiles

    kinds = ("corner", "wang", "cohen-8", "cohen-12", "cohen-18", "corner-coded")
    check_choice("--tiles", kind, kinds)
    if colors is not None and kind not in ("corner", "wang"):
        raise TilewrightValueError(f"--colors goes with --tiles corner and wang; {kind} has its own")
    if kind == "wang":
        return wang_tiles(2 if colors is None else colors)
    if kind == "corner":
        return corner_tiles((4 if two_sources else 2) if colors is None else colors)
    return corner_coded_tiles() if kind == "corner-coded" else cohen_tiles(int(kind.removeprefix("cohen-")))


def _size(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise TilewrightTypeError(f"--tile-size is {text!r}; expected a number of pixels or auto") from None


def _number(name: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise TilewrightTypeError(f"--weight {name} is {text!r}; expected a number") from None


def _spot(name: str, text: str) -> tuple[int, int, int]:
    try:
        source, y, x = (int(v) for v in text.split(","))
    except ValueError:
        raise TilewrightError(f"--pick {name} is {text!r}; expected SOURCE,Y,X as whole numbers") from None
    return source, y, x
