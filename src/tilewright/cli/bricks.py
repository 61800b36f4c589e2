"""tilewright bricks"""

import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tilewright.checks import check_choice, check_int
from tilewright.cli.options import Json, Seed, progress_bar, report
from tilewright.errors import TilewrightFileError, TilewrightValueError
from tilewright.seeds import check_seed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tilewright.fields.bricks.field import BrickField
    from tilewright.fields.bricks.patterns import BrickPattern
    from tilewright.tilings import Tiling
    from tilewright.tilings.bricks import BrickRegion

_MOST_CELLS = 2**24


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
    from tilewright.fields.bricks.bonds import BONDS, BondBricks
    from tilewright.fields.bricks.field import BrickField
    from tilewright.signals.bricks.style import BrickStyle
    from tilewright.tilings.bricks import endless_brick_tiling

    started = time.perf_counter()
    check_choice("--pattern", pattern, ("wang", *BONDS))
    kind = output.suffix.lower()
    _check_numbers(size, x, y, seed, longest)
    _refuse_unused(kind, map, lines)
    style = BrickStyle(colors, mortar=mortar, bevel=bevel)
    for option, cells in (("--width", width), ("--height", height)):
        if cells is not None:
            check_int(option, cells, 1, _MOST_CELLS)
    wall: Tiling | BrickRegion | BrickPattern
    if mask is not None or boundary is not None:
        _refuse("a region", {"--input": input, "--cyclic": cyclic, "--pattern": pattern != "wang"})
        asked = width, height
        wall = _region(mask, boundary, asked, positions, longest, seed)
        width, height = wall.cells.shape[::-1]
        if any(given not in (None, there) for given, there in zip(asked, (width, height), strict=True)):
            raise TilewrightValueError(
                f"--boundary is of {width} x {height} cells; leave --width and --height out"
            )
    else:
        width, height = width or 12, height or 20
        if pattern != "wang":
            _refuse("--pattern", {"--input": input})
            wall = BondBricks(pattern, size, (width, height) if cyclic else (None, None))
        elif input is not None or cyclic:
            wall = _dappled(input, (width, height), positions, longest, cyclic, seed)
        else:
            wall = endless_brick_tiling(positions, seed, longest=longest)
    _check_inside(wall, (x, y), (width, height))
    if kind == ".npy":
        _save_cells(output, wall, (x, y, width, height))
    else:
        field = BrickField(wall, style, size=None if isinstance(wall, BondBricks) else size, seed=seed)
        window = (x * size[0], y * size[1], width * size[0], height * size[1])
        _draw(output, field, window, map or "preview", lines)
    seconds = time.perf_counter() - started
    report(
        {"file": str(output), "width": width, "height": height, "seconds": round(seconds, 3)},
        json,
        f"{output}: {width} x {height} cells in {seconds:.1f} s",
    )


def _check_numbers(size: tuple[int, int], x: int, y: int, seed: int, longest: tuple[int, int]) -> None:
    """Numbers that the library would name otherwise, or not see."""
    from tilewright.tilings.domain import LARGEST_CELL

    for given in size:
        check_int("--size", given, 1, 4096)
    for option, first in (("--x", x), ("--y", y)):
        check_int(option, first, -LARGEST_CELL, LARGEST_CELL)
    for most in longest:
        check_int("--longest", most, 1, 2**30)
    check_seed(seed)


def _refuse_unused(kind: str, map: str | None, lines: bool) -> None:
    """Refuse options that would do nothing."""
    from tilewright.fields.bricks.field import MAPS

    if map is not None:
        check_choice("--map", map, ("preview", *MAPS))
        if kind in (".svg", ".npy", ""):
            raise TilewrightValueError(
                f"--map is about a single picture, not {kind or 'a folder of all maps'}"
            )
    if lines and kind != ".svg":
        raise TilewrightValueError("--lines is about an SVG; name a FILE.svg")


def _check_inside(
    wall: "Tiling | BrickRegion | BrickPattern", corner: tuple[int, int], extent: tuple[int, int]
) -> None:
    """Refuse a window that leaves a wall which ends, and one that no picture holds."""
    from tilewright.tilings.bricks import BrickRegion

    ends = isinstance(wall, BrickRegion) or wall.domain.kind == "rectangle"
    if ends and corner != (0, 0):
        raise TilewrightValueError("--x and --y are about walls that go on; this one ends at its sides")
    check_int("--width times --height", extent[0] * extent[1], 1, _MOST_CELLS)


def _refuse(option: str, others: dict[str, Any]) -> None:
    """Raise if one of the other options is there."""
    for other, given in others.items():
        if given:
            raise TilewrightValueError(f"{option} and {other} ask for different walls; give one of them")


def _region(
    mask: Path | None,
    boundary: Path | None,
    extent: tuple[int | None, int | None],
    positions: int,
    longest: tuple[int, int],
    seed: int,
) -> "BrickRegion":
    """A wall in a region of light pixels, or in the rectangle of a boundary."""
    import numpy as np

    from tilewright.files import read_image
    from tilewright.tilings.bricks import brick_region
    from tilewright.tilings.dappled import start_from_image

    asked = {} if boundary is None else _read_boundary(boundary)
    if mask is None:
        inside = np.ones((len(asked["vertical"]), asked["horizontal"].shape[-1]), np.uint8)
    else:
        picture = read_image(mask)
        width, height = (extent[axis] or picture.shape[1 - axis] for axis in (0, 1))
        inside = start_from_image(picture, width, height)
    return brick_region(inside, positions, **asked, seed=seed, longest=longest)


def _read_boundary(path: Path) -> "dict[str, NDArray[Any]]":
    """The arrays ``horizontal`` and ``vertical`` of an .npz file."""
    from tilewright.files.tables import read_arrays

    what = "two arrays, horizontal (h + 1, w) and vertical (h, w + 1), as a .npz file does"
    found = read_arrays(path, ("horizontal", "vertical"), what)
    if any(array.ndim != 2 for array in found.values()):
        raise TilewrightFileError(f"{path} does not hold {what}")
    return found


def _dappled(
    picture: Path | None,
    extent: tuple[int, int],
    positions: int,
    longest: tuple[int, int],
    cyclic: bool,
    seed: int,
) -> "Tiling":
    """A wall whose lines follow a picture, or chance."""
    from tilewright.files import read_image
    from tilewright.tilings.bricks import brick_tiling
    from tilewright.tilings.dappled import dapple, random_start, start_from_image

    if picture is None:
        start = random_start(*extent, seed=seed)
    else:
        start = start_from_image(read_image(picture), *extent)
    if cyclic:  # a ring of one V tile among H tiles does not close
        along, down = (max(1, min(most, side - 2)) for most, side in zip(longest, extent, strict=True))
        longest = along, down
    limits = {"H0": longest[0], "V1": longest[1]}
    classes = dapple(start, limits, cyclic=cyclic, seed=seed)
    return brick_tiling(classes, positions, seed, torus=cyclic)


def _save_cells(
    output: Path, wall: "Tiling | BrickRegion | BrickPattern", window: tuple[int, int, int, int]
) -> None:
    """Write tile indices, shape (height, width); -1 outside a region."""
    import numpy as np

    from tilewright.files.atomic import whole_file
    from tilewright.tilings import Tiling
    from tilewright.tilings.bricks import BrickRegion

    if isinstance(wall, BrickRegion):
        cells = wall.cells
    elif isinstance(wall, Tiling):
        cells = wall.indices(*window)
    else:
        raise TilewrightValueError(f"{output}: .npy holds tiles, and bonds have none; take --pattern wang")
    with whole_file(output) as unfinished:
        np.save(unfinished, cells)


def _draw(
    output: Path, field: "BrickField", window: tuple[int, int, int, int], map: str, lines: bool
) -> None:
    from tilewright.export.drawing.svg import save_svg
    from tilewright.export.drawing.walls import draw_wall

    if output.suffix.lower() == ".svg":
        save_svg(output, draw_wall(field, *window, mode="lines" if lines else "bricks"))
        return
    with progress_bar() as progress:
        field.save(output, *window, map=map, progress=progress)
