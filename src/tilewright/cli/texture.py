"""tilewright texture"""

import time
from pathlib import Path
from typing import Annotated, Any

import typer

from tilewright.checks import check_choice
from tilewright.cli.options import Json, Seed, parse_pairs, progress_bar, report
from tilewright.errors import TilewrightError, TilewrightTypeError, TilewrightValueError


def command(
    context: typer.Context,
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
    from tilewright.files import load_texture, save
    from tilewright.files.tileset_folder import check_savable
    from tilewright.jobs import add_maps, texture_tiles
    from tilewright.signals.textures import resynthesize

    started = time.perf_counter()
    output = output or like or Path("tiles")
    check_savable(output)
    picked = {name: _spot(name, value) for name, value in parse_pairs("--pick", pick or []).items()}
    meaning: dict[str, Any] = {
        "kinds": parse_pairs("--kind", kind or []),
        "normal": normal,
        "flatten": flatten,
    }
    with progress_bar() as progress:
        if from_ is not None:
            _refuse_others(context, "--from makes the old set again, with its photograph and settings", _FROM)
            material = resynthesize(
                load_texture(from_), reject=reject or [], pick=picked, threads=threads, progress=progress
            )
        elif like is not None:
            _refuse_others(context, "--like cuts as the old set was cut", _LIKE)
            if not map:
                raise TilewrightValueError("--like cuts further maps; give them with --map NAME=FILE")
            added = parse_pairs("--map", map)
            if second is not None and len(added) > 1:
                raise TilewrightValueError(
                    "--second is the second photograph of one map; give one --map at a time"
                )
            seconds_of = None if second is None else dict.fromkeys(added, str(second))
            material = add_maps(load_texture(like), added, second=seconds_of, **meaning)
        else:
            if reject:
                raise TilewrightValueError("--reject names patches of a set that exists; give it with --from")
            material = texture_tiles(
                _maps(photo, map or []),
                _tile_set(tiles, colors, second is not None),
                second=second,
                mask=mask,
                weights={n: _number(n, v) for n, v in parse_pairs("--weight", weight or []).items()},
                tile_size=tile_size if tile_size == "auto" else _size(tile_size),
                seed=seed,
                method=method,
                variants=variants,
                pick=picked,
                threads=threads,
                progress=progress,
                **meaning,
            )
    save(material, output)
    seconds = time.perf_counter() - started
    figures = {
        "folder": str(output),
        "tiles": len(material.tiles),
        "tile_size": material.tile_size,
        "maps": list(material.maps),
        "kinds": material.kinds,
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


_FROM = {"from_", "output", "reject", "pick", "threads", "json"}
_LIKE = {"like", "output", "map", "second", "kind", "normal", "flatten", "json"}


def _refuse_others(context: typer.Context, reason: str, allowed: set[str]) -> None:
    """Refuse options that would not be heard."""
    sources = ((name, context.get_parameter_source(name)) for name in context.params)
    given = {name for name, source in sources if source is not None and source.name == "COMMANDLINE"}
    if others := given - allowed:
        raise TilewrightValueError(f"{reason}; leave out {', '.join(sorted(others))}")


def _maps(photo: Path | None, given: list[str]) -> Any:
    """The photograph, its maps by name, or both."""
    maps = parse_pairs("--map", given)
    if photo is None and not maps:
        raise TilewrightValueError(
            "PHOTO is missing; give a photograph, a folder of maps, or --map NAME=FILE"
        )
    if photo is None or not maps:
        return maps or photo
    if photo.is_dir():
        from tilewright.files import find_maps

        return {name: str(file) for name, file in find_maps(photo).items()} | maps
    if "albedo" in maps:
        raise TilewrightValueError("albedo is given twice, as PHOTO and by --map; leave one out")
    return {"albedo": str(photo)} | maps


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
