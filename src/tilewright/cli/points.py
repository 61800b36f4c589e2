"""tilewright points"""

import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tilewright.checks import check_choice
from tilewright.cli.options import Json, LatticeSeed, Seed, progress_bar, report
from tilewright.errors import Progress, TilewrightValueError

if TYPE_CHECKING:
    from tilewright.files.point_files import Blocks
    from tilewright.samplers import PointSet
    from tilewright.signals.points import PointTiles


def command(
    output: Annotated[
        Path, typer.Option("-o", "--output", help="FILE.npy, .csv, .parquet or .ply.", show_default=False)
    ],
    method: Annotated[
        str,
        typer.Option(
            help="Tiles: corner, corner-relaxed, edge, template, shade, hiller, kopf. Or a sampler."
        ),
    ] = "corner",
    tiles: Annotated[
        Path | None,
        typer.Option(help="A tile-set folder of points, instead of --method.", show_default=False),
    ] = None,
    save: Annotated[
        Path | None, typer.Option(help="Also keep the point tiles in this folder.", show_default=False)
    ] = None,
    colors: Annotated[int, typer.Option(help="Colors of corner tiles, 2 to 8.")] = 4,
    points: Annotated[int | None, typer.Option(help="Points per tile; usually 32.")] = None,
    rho: Annotated[float | None, typer.Option(help="Relative radius; usually 0.75.")] = None,
    count: Annotated[int | None, typer.Option(help="Exactly so many points.", show_default=False)] = None,
    width: Annotated[float | None, typer.Option(help="Of the window, in tiles.", show_default=False)] = None,
    height: Annotated[float | None, typer.Option(help="In tiles.", show_default=False)] = None,
    x: Annotated[float, typer.Option(help="West side of the window, in tiles.")] = 0,
    y: Annotated[float, typer.Option(help="North side.")] = 0,
    torus: Annotated[bool, typer.Option(help="Let opposite sides of the window meet.")] = False,
    lattice_seed: LatticeSeed = 0,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Write blue-noise points: of tiles, as many as you like, or of a method without tiles.

    Example: tilewright points --count 1000000 -o points.npy

    Example: tilewright points --width 500 --height 300 --rho 0.7 --colors 6 -o points.parquet

    Example: tilewright points --method lloyd --count 4096 --torus -o lloyd.csv

    With tiles, --count alone fills the smallest square of whole tiles and leaves out points by rank; samplers
    fill a square of side 1, or --width by --height. Calls tilewright.PointField(tiles,
    tilewright.direct(...)) and its sample_blocks(count), sample(...), blocks(...) or torus(); the tiles are
    tilewright.ready_tiles(...) where such a set comes with the package, else
    tilewright.make_point_tiles(method, ...).
    Samplers are tilewright.sample_points(method, ...).
    """
    from tilewright.files import save as save_tiles
    from tilewright.files import write_points
    from tilewright.files.point_files import check_point_file
    from tilewright.files.tileset_folder import check_savable
    from tilewright.samplers import METHODS
    from tilewright.signals.points import TILE_METHODS

    started = time.perf_counter()
    check_point_file(output)
    check_choice("method", method, (*TILE_METHODS, *METHODS))
    if (width is None) != (height is None):
        raise TilewrightValueError("--width and --height go together")
    size = None if width is None or height is None else (width, height)
    if save is not None:
        check_savable(save)
    with progress_bar() as progress:
        if tiles is None and method in METHODS:
            if save is not None or x or y:
                raise TilewrightValueError(f"--save, --x and --y are for tiles; {method} has none")
            made = _sample(method, count, rho, size, torus, seed, progress)
            result: PointSet | Blocks = made
            total, promised = len(made), made.distance
        else:
            chosen = _tiles(tiles, method, colors, points, rho, seed, progress)
            if save is not None:
                save_tiles(chosen, save)
            result, total = _lay(chosen, count, (x, y), size, torus, lattice_seed)
            promised = getattr(result, "distance", chosen.distance)
        write_points(output, result, total)
    seconds = time.perf_counter() - started
    report(
        {"file": str(output), "count": total, "distance": promised, "seconds": round(seconds, 3)},
        json,
        f"{output}: {total:,} points, none closer than {promised:.5g}, in {seconds:.2f} s",
    )


def _sample(
    method: str,
    count: int | None,
    rho: float | None,
    size: tuple[float, float] | None,
    torus: bool,
    seed: int,
    progress: Progress,
) -> "PointSet":
    from tilewright.samplers import Box, sample_points

    if count is None:
        raise TilewrightValueError(f"{method} needs --count; only tiles fill a window by its size")
    box = Box(size or (1.0, 1.0), torus)
    return sample_points(method, count, rho, seed=seed, box=box, progress=progress)


def _tiles(
    folder: Path | None,
    method: str,
    colors: int,
    points: int | None,
    rho: float | None,
    seed: int,
    progress: Progress,
) -> "PointTiles":
    from tilewright.files import load_points, ready_tiles
    from tilewright.files.ready import READY
    from tilewright.signals.points import make_point_tiles

    if folder is not None:
        return load_points(folder)
    usual = (colors, 32 if points is None else points, 0.75 if rho is None else rho)
    if method == "corner" and seed == 0 and usual in READY:
        return ready_tiles(*usual)
    return make_point_tiles(method, points, rho, colors=colors, seed=seed, progress=progress)


def _lay(
    tiles: "PointTiles",
    count: int | None,
    corner: tuple[float, float],
    size: tuple[float, float] | None,
    torus: bool,
    lattice_seed: int,
) -> "tuple[PointSet | Blocks, int]":
    from tilewright.fields import PointField
    from tilewright.tilings import direct

    if torus:
        if count is not None or size is None or size[0] % 1 or size[1] % 1 or any(corner):
            raise TilewrightValueError(
                "--torus takes --width and --height of whole tiles, and no --count, --x or --y"
            )
        period = (int(size[0]), int(size[1]))
        made = PointField(tiles, direct(tiles.tiles, lattice_seed, period=period)).torus()
        return made, len(made)
    field = PointField(tiles, direct(tiles.tiles, lattice_seed))
    if count is None:
        if size is None:
            raise TilewrightValueError("give --count, or --width and --height, or all three")
        return field.blocks(*corner, *size), field.count(*corner, *size)
    if size is not None:
        return field.sample(count, *corner, *size), count
    if corner[0] % 1 or corner[1] % 1:
        raise TilewrightValueError("--x and --y are whole tiles where --count stands alone")
    return field.sample_blocks(count, int(corner[0]), int(corner[1])), count
