"""tilewright aperiodic"""

import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tilewright.cli.options import Json, Seed, progress_bar, report
from tilewright.errors import TilewrightValueError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tilewright.tiles import TileSet
    from tilewright.tilings import Tiling


def command(
    name: Annotated[
        str | None,
        typer.Argument(
            help="Of a set; without one, what there is. Or FILE.csv or .npy: a set of your own.",
            show_default=False,
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", help="FILE.svg, .png or .npy; else NAME.svg.", show_default=False),
    ] = None,
    width: Annotated[int, typer.Option(help="Cells.")] = 40,
    height: Annotated[int, typer.Option(help="Cells.")] = 30,
    x: Annotated[int, typer.Option(help="West cell; any place of the plane.")] = 0,
    y: Annotated[int, typer.Option(help="North cell.")] = 0,
    set: Annotated[bool, typer.Option("--set", help="The tiles themselves instead of a tiling.")] = False,
    to: Annotated[
        str | None,
        typer.Option(
            help="Make a corner set: diagonal, horizontal, vertical, rotation, subdivision; or wang.",
            show_default=False,
        ),
    ] = None,
    period: Annotated[
        tuple[int, int] | None,
        typer.Option(help="Look for the smallest torus up to so many cells.", show_default=False),
    ] = None,
    shape: Annotated[str, typer.Option(help="Of your own set: wang, corner or corner-coded.")] = "wang",
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Tile the plane with an aperiodic set and draw it, or draw the set; or list the sets.

    Columns of your own set are N, E, S, W for Wang tiles and NE, SE, SW, NW for corner tiles; it tiles a
    rectangle. A .npy holds tile indices, shape (height, width), or with --set the colors of each tile.

    Example: tilewright aperiodic

    Example: tilewright aperiodic jeandel-rao-11-5 -o tiling.svg --x 1000000 --width 60

    Example: tilewright aperiodic kari-14 --to vertical --set

    Example: tilewright aperiodic lagae-44 --period 5 5

    Calls tilewright.aperiodic_tiling(tilewright.aperiodic_tiles(name), seed).indices(x, y, width, height) and
    tilewright.draw_tiling(...) or, for a PNG, paint_tiling(...); with --set draw_tiles(...); with --to
    translated_tiling(tiling, to); with --period periodic_tiling(tiles, ...); for your own set
    filled_tiling(tiles, width, height, seed=seed).
    """
    started = time.perf_counter()
    if name is None:
        if output is not None or set or to is not None or period is not None:
            raise TilewrightValueError("name a set to draw; without one, the sets are listed")
        _list(json)
        return
    if output is not None and output.suffix.lower() not in (".svg", ".png", ".npy"):
        raise TilewrightValueError(
            f"{output} ends in {output.suffix or 'nothing'!r}; allowed are .svg, .png and .npy"
        )
    own = Path(name).suffix.lower() in (".csv", ".npy")
    tiles, figures = _own_set(Path(name), shape) if own else _named_set(name)
    if to is not None:
        figures |= {"construction": to, "sound": _is_sound(tiles, to)}
    tiling = None
    if set or own or period is not None:
        tiles = _translate(tiles, to)
    if period is not None:
        tiling = _periodic(tiles, period, seed)
        figures["period"] = None if tiling is None else list(tiling.domain.periods)
    elif own and not set:
        tiling = _filled(tiles, width, height, seed)
    elif not set:
        tiling = _endless(tiles, to, seed)
        tiles = tiling.tiles
    figures |= {"shape": tiles.shape.name, "tiles": len(tiles), "colors": max(tiles.colors)}
    said = f"{len(tiles)} {tiles.shape.name} tiles"
    if period is not None and tiling is None:
        said += f" tile no torus of up to {period[0]} x {period[1]} cells; this is proven"
    else:
        stem = "-".join(filter(None, (Path(name).stem, to, "tiles" if set else None)))
        file = Path(f"{stem}.svg") if output is None else output
        if set or tiling is None:
            _save_set(file, tiles)
        else:
            _save_tiling(file, tiling, (x, y, width, height))
            figures |= {"width": width, "height": height}
        figures["file"] = str(file)
        said = f"{file}: {said}{_remark(figures)}"
    report(figures | {"seconds": round(time.perf_counter() - started, 3)}, json, said)


def _remark(figures: dict[str, Any]) -> str:
    if "period" in figures:
        return ", period {} x {}".format(*figures["period"])
    if "status" in figures and figures.get("sound", True):
        return f"; {figures['name']} is {figures['status']}"
    return ""


def _is_sound(tiles: "TileSet", to: str) -> bool:
    """Whether a construction keeps a set aperiodic."""
    from tilewright.tiles.translations import translation_is_sound

    return to not in ("horizontal", "vertical") or translation_is_sound(tiles, to)


def _list(json: bool) -> None:
    from tilewright.tiles.aperiodic import APERIODIC_SETS, aperiodic_tiles

    listed = []
    for name, known in APERIODIC_SETS.items():
        tiles = aperiodic_tiles(name)
        size = {"shape": tiles.shape.name, "tiles": len(tiles), "colors": max(tiles.colors)}
        listed.append({"name": name, **size, "status": known.status, "source": known.source})
    lines = (f"{s['name']:18}{s['tiles']}/{s['colors']} {s['shape']:8}{s['status']}" for s in listed)
    report({"sets": listed}, json, "\n".join(lines))


def _named_set(name: str) -> "tuple[TileSet, dict[str, Any]]":
    from tilewright.tiles.aperiodic import APERIODIC_SETS, aperiodic_tiles

    tiles = aperiodic_tiles(name)
    known = APERIODIC_SETS[name]
    return tiles, {"name": name, "status": known.status, "source": known.source}


def _own_set(path: Path, shape: str) -> "tuple[TileSet, dict[str, Any]]":
    from tilewright.files.tables import read_table
    from tilewright.tiles import tile_set

    slots = read_table(path, "a table of whole numbers, a row of colors with commas for every tile")
    return tile_set(slots, shape, name=path.stem), {"name": str(path)}


def _translate(tiles: "TileSet", to: str | None) -> "TileSet":
    from tilewright.tiles import as_wang_tiles
    from tilewright.tiles.translations import as_corner_tiles

    if to is None:
        return tiles
    return as_wang_tiles(tiles) if to == "wang" else as_corner_tiles(tiles, to)


def _endless(tiles: "TileSet", to: str | None, seed: int) -> "Tiling":
    from tilewright.tilings.aperiodic import aperiodic_tiling, translated_tiling

    tiling = aperiodic_tiling(tiles, seed)
    return tiling if to is None else translated_tiling(tiling, to)


def _periodic(tiles: "TileSet", most: tuple[int, int], seed: int) -> "Tiling | None":
    from tilewright.tilings.periods import periodic_tiling

    with progress_bar() as progress:
        return periodic_tiling(tiles, *most, seed=seed, progress=progress)


def _filled(tiles: "TileSet", width: int, height: int, seed: int) -> "Tiling":
    from tilewright.tilings.filling import filled_tiling

    with progress_bar() as progress:
        return filled_tiling(tiles, width, height, seed=seed, progress=progress)


def _save_set(file: Path, tiles: "TileSet") -> None:
    from tilewright.export.drawing.tiles import draw_tiles, paint_tiles

    _save(file, lambda: draw_tiles(tiles), lambda: paint_tiles(tiles), lambda: tiles.slots)


def _save_tiling(file: Path, tiling: "Tiling", window: tuple[int, int, int, int]) -> None:
    from tilewright.export.drawing.tiles import draw_tiling, paint_tiling

    _save(
        file,
        lambda: draw_tiling(tiling, *window),
        lambda: paint_tiling(tiling, *window),
        lambda: tiling.indices(*window),
    )


def _save(
    file: Path,
    drawing: Callable[[], str],
    pixels: "Callable[[], NDArray[Any]]",
    cells: "Callable[[], NDArray[Any]]",
) -> None:
    """Write the one that the file's suffix asks for."""
    import numpy as np

    from tilewright.export.drawing.svg import save_svg
    from tilewright.files import write_image
    from tilewright.files.atomic import whole_file

    suffix = file.suffix.lower()
    if suffix == ".svg":
        save_svg(file, drawing())
    elif suffix == ".png":
        write_image(file, pixels())
    else:
        with whole_file(file) as unfinished:
            np.save(unfinished, cells())
