"""tilewright pack"""

from pathlib import Path
from typing import Annotated, Any

import typer

from tilewright.checks import check_choice
from tilewright.cli.options import Json, Seed, progress_bar, report
from tilewright.errors import TilewrightValueError
from tilewright.seeds import check_seed

_METHODS = ("closed", "search", "recursive")


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
    from tilewright.tiles import corner_tiles, wang_tiles

    make = {"corner": corner_tiles, "wang": wang_tiles}[check_choice("--tiles", tiles, ("corner", "wang"))]
    check_choice("--method", method, _METHODS)
    if output is None and not count:
        output = Path(f"{tiles}-{colors}-packing.png")
    kind = None if output is None else output.suffix.lower()
    if kind is not None and kind not in (".npy", ".svg", ".png"):
        raise TilewrightValueError(f"{output} ends in {kind or 'nothing'!r}; expected .npy, .svg or .png")
    if picture is not None and kind != ".svg":
        raise TilewrightValueError("--picture is printed on the pieces of a puzzle; give it with -o FILE.svg")
    check_seed(seed)
    if engrave != "none" and kind != ".svg":
        raise TilewrightValueError("--engrave is about the pieces of a puzzle; give it with -o FILE.svg")
    chosen = make(colors)
    figures: dict[str, Any] = {"tiles": len(chosen)}
    words = []
    if count:
        figures["packings"] = _count(chosen)
        words.append(f"{figures['packings']} packings of {len(chosen)} tiles, translations counted")
    if output is not None:
        packed = _pack(chosen, method, seed)
        width, height = (p or 0 for p in packed.domain.periods)
        _save(packed, output, (width, height), piece_mm, picture, engrave)
        figures |= {"file": str(output), "size": [width, height]}
        words.append(f"{output}: {len(chosen)} tiles, {width} x {height}")
    report(figures, json, "\n".join(words))


def _count(tiles: Any) -> int:
    from tilewright.tilings.packings.search import count_packings

    with progress_bar() as progress:
        return count_packings(tiles, progress)


def _pack(tiles: Any, method: str, seed: int) -> Any:
    from tilewright.tilings import packing
    from tilewright.tilings.packings.recursion import recursive_packing
    from tilewright.tilings.packings.search import random_packing

    if method == "search":
        with progress_bar() as progress:
            return random_packing(tiles, seed=seed, progress=progress)
    return {"closed": packing, "recursive": recursive_packing}[method](tiles)


def _save(
    packed: Any, output: Path, size: tuple[int, int], piece: float, picture: Path | None, engrave: str
) -> None:
    import numpy as np

    from tilewright.export.drawing.jigsaw import draw_jigsaw
    from tilewright.export.drawing.svg import save_svg
    from tilewright.export.drawing.tiles import paint_tiling
    from tilewright.files.atomic import whole_file
    from tilewright.files.images import write_image

    kind = output.suffix.lower()
    if kind == ".svg":
        save_svg(output, draw_jigsaw(packed, piece=piece, picture=picture, engrave=engrave))
    elif kind == ".png":
        write_image(output, paint_tiling(packed, 0, 0, *size))
    else:
        with whole_file(output) as unfinished:
            np.save(unfinished, packed.indices(0, 0, *size))
