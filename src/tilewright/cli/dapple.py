"""tilewright dapple"""

import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tilewright.checks import check_choice, check_int, check_real
from tilewright.cli.options import Json, Seed, parse_limits, progress_bar, report
from tilewright.errors import TilewrightFileError, TilewrightValueError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tilewright.tilings.dappled import Conditions

    Cells = NDArray[Any]

_SUFFIXES = (".png", ".svg", ".npy", ".cnf")
_MOST_CELLS = 2**24
_INK, _PAPER = (29, 29, 38), (250, 245, 232)
_START = {"--input", "--dither", "--share"}
_LOOK = {"--cell", "--colors", "--motif"}
# What each way of working has no use for.
_UNUSED = {
    "--count": {*_START, *_LOOK, "-o", "--x", "--y", "--seconds", "--closest", "--endless", "--pins"},
    "--endless": {"--input", "--dither", "--cyclic", "--tiles", "--seconds", "--closest", "--pins"},
    "--pins": {*_START, "--width", "--height", "--x", "--y", "--closest"},
    "--closest": {"--x", "--y"},
    "a start": set(),
}
_ONLY = {"--x": "--endless", "--y": "--endless", "--seconds": "--closest and --pins"}
_NOT_FOR_CNF = {*_START, *_LOOK, "--closest", "--endless", "--seconds"}


@dataclass
class _Made:
    """A tiling and what is said about it."""

    cells: "Cells"
    figures: dict[str, Any]


def command(
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", help="FILE.png, .svg, .npy or .cnf; else dapple.png.", show_default=False
        ),
    ] = None,
    width: Annotated[
        int | None, typer.Option(help="Cells; 64, or what suits --input.", show_default=False)
    ] = None,
    height: Annotated[
        int | None, typer.Option(help="Cells; 40, or what suits --input.", show_default=False)
    ] = None,
    limit: Annotated[
        list[str] | None,
        typer.Option(
            help="Longest run, again for each: H0=2, V1=2, H0+2=3, H0=inf; else H0=2 and V1=2.",
            show_default=False,
        ),
    ] = None,
    tiles: Annotated[
        int | None, typer.Option(help="How many; else as many as are named.", show_default=False)
    ] = None,
    share: Annotated[
        list[float] | None,
        typer.Option(help="How much of each tile the random start holds, once for each.", show_default=False),
    ] = None,
    input: Annotated[
        Path | None, typer.Option(help="Picture to follow: tile 0 where it is dark.", show_default=False)
    ] = None,
    dither: Annotated[
        bool, typer.Option("--dither", help="Let grays of --input be mixtures, as far as limits allow.")
    ] = False,
    cyclic: Annotated[bool, typer.Option("--cyclic", help="Close rows and columns to rings.")] = False,
    closest: Annotated[
        bool, typer.Option("--closest", help="Change as few cells as can be, and prove it.")
    ] = False,
    endless: Annotated[bool, typer.Option("--endless", help="A window of an endless tiling.")] = False,
    x: Annotated[
        int | None, typer.Option("--x", "-x", help="West cell of the window.", show_default=False)
    ] = None,
    y: Annotated[int | None, typer.Option("--y", "-y", help="North cell.", show_default=False)] = None,
    pins: Annotated[
        Path | None,
        typer.Option(help="FILE.npy of tiles to keep, -1 where any may be.", show_default=False),
    ] = None,
    count: Annotated[bool, typer.Option("--count", help="Print how many tilings there are.")] = False,
    seconds: Annotated[
        float | None, typer.Option(help="When --closest or --pins stop.", show_default=False)
    ] = None,
    cell: Annotated[int | None, typer.Option(help="Pixels along a cell.", show_default=False)] = None,
    colors: Annotated[
        str | None,
        typer.Option(help="Of the tiles, or of lines and ground: '#27548f,#ecd5a3'.", show_default=False),
    ] = None,
    motif: Annotated[
        str | None, typer.Option(help="fill, strokes or arcs: what each tile shows.", show_default=False)
    ] = None,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Make a dappled tiling, in which no tile has long runs, and draw it; or count them, or write clauses.

    Example: tilewright dapple --width 80 --height 50 --motif arcs

    Example: tilewright dapple -o face.svg --input face.jpg --dither --width 120 --limit H0=3 --limit V1=3

    Example: tilewright dapple -o far.png --endless --x 1000000000000 --share 0.7 --share 0.3

    Example: tilewright dapple --count --width 8 --height 8

    Calls tilewright.dapple(start, limits, ...) of tilewright.random_start(...) or start_from_image(...);
    with --closest closest_dapple(start, limits), with --endless endless_dappled_tiling(limits).cells(x,
    y, width, height), with --pins complete_dapple(pins, limits), with --count count_dappled(width,
    height, limits), for a .cnf dapple_formula((height, width), limits).dimacs().
    """
    from tilewright.files.atomic import check_file

    started = time.perf_counter()
    ways = {"--count": count, "--endless": endless, "--pins": pins is not None, "--closest": closest}
    given: dict[str, Any] = {
        **ways, "-o": output, "--width": width, "--height": height, "--tiles": tiles, "--share": share,
        "--input": input, "--dither": dither, "--cyclic": cyclic, "--x": x, "--y": y, "--seconds": seconds,
        "--cell": cell, "--colors": colors, "--motif": motif,
    }  # fmt: skip
    asked = {
        name for name, value in given.items() if value is not None and value is not False and value != []
    }
    file = Path("dapple.png") if output is None else output
    suffix = check_choice("the ending of -o", file.suffix.lower(), _SUFFIXES)
    way = next((name for name, on in ways.items() if on), "a start")
    _refuse(asked, way, suffix)
    conditions = _conditions(limit or ["H0=2", "V1=2"], tiles, share)
    extent = (_or(width, 64), _or(height, 40))
    if count:
        _count(extent, conditions, cyclic, json)
        return
    check_file(file)
    if suffix == ".cnf":
        made, text = _clauses(file, extent, conditions, cyclic, pins)
    else:
        if endless:
            made = _endless((_or(x, 0), _or(y, 0)), extent, conditions, share, seed)
        elif pins is not None:
            made = _completed(pins, conditions, cyclic, seed, seconds)
        else:
            start = _start(input, dither, width, height, conditions, share, seed)
            made = _dappled(start, conditions, cyclic, seed, closest, seconds)
        shades = None if colors is None else [part.strip() for part in colors.split(",")]
        if shades is None and input is not None and motif in (None, "fill"):
            shades = _ramp(conditions.tiles)
        _save(file, made.cells, shades, motif or "fill", cell)
        text = _sentence(file, made)
    spent = time.perf_counter() - started
    figures = {"file": str(file), **made.figures, "seconds": round(spent, 3)}
    report(figures, json, f"{text}; {spent:.1f} s")


def _refuse(asked: set[str], way: str, suffix: str) -> None:
    """Refuse options that contradict each other or would do nothing."""
    for reason, unused in ((way, _UNUSED[way]), ("a .cnf file", _NOT_FOR_CNF if suffix == ".cnf" else set())):
        for option in sorted(asked & unused):
            raise TilewrightValueError(f"{option} has no use with {reason}; leave one of them out")
    if way == "a start":
        for option, for_which in _ONLY.items():
            if option in asked:
                raise TilewrightValueError(f"{option} is about {for_which}")
    if "--dither" in asked and "--input" not in asked:
        raise TilewrightValueError("--dither is about a picture to follow; give --input")
    if {"--input", "--share"} <= asked:
        raise TilewrightValueError("--input and --share make different starts; give one of them")
    if suffix == ".npy" and asked & _LOOK:
        raise TilewrightValueError(f"{min(asked & _LOOK)} is about pictures; a .npy file holds tiles")


def _conditions(limits: list[str], tiles: int | None, share: list[float] | None) -> "Conditions":
    """Limits as NAME=NUMBER, on as many tiles as are named anywhere."""
    from tilewright.tilings.dappled import Conditions

    if tiles is not None and share and len(share) != tiles:
        raise TilewrightValueError(f"--share was given {len(share)} times; there are {tiles} tiles")
    return Conditions(parse_limits(limits), len(share) if share and tiles is None else tiles)


def _shares(share: list[float] | None, conditions: "Conditions") -> list[float]:
    return share or [1.0] * conditions.tiles


def _start(
    picture: Path | None,
    dither: bool,
    width: int | None,
    height: int | None,
    conditions: "Conditions",
    share: list[float] | None,
    seed: int,
) -> "Cells":
    """The tiling to follow: a picture, in its own proportions where these are not given, or chance."""
    from tilewright.files import read_image
    from tilewright.tilings.dappled import random_start, start_from_image

    if picture is None:
        extent = _checked(_or(width, 64), _or(height, 40))
        return random_start(*extent, _shares(share, conditions), seed)
    pixels = read_image(picture)
    high, wide = pixels.shape[:2]
    if width is None:
        width = 64 if height is None else max(1, round(height * wide / high))
    if height is None:
        height = max(1, round(width * high / wide))
    limits = conditions if dither else None
    return start_from_image(pixels, *_checked(width, height), conditions.tiles, dither=dither, limits=limits)


def _or(given: int | None, default: int) -> int:
    return default if given is None else given


def _checked(width: int, height: int) -> tuple[int, int]:
    for option, cells in (("--width", width), ("--height", height)):
        check_int(option, cells, 1, 65536)
    check_int("--width times --height", width * height, 1, _MOST_CELLS)
    return width, height


def _dappled(
    start: "Cells", conditions: "Conditions", cyclic: bool, seed: int, closest: bool, seconds: float | None
) -> _Made:
    """The start made dappled, with few changes or with the fewest."""
    from tilewright.tilings.dappled import closest_dapple, dapple, find_violations

    violated = find_violations(start, conditions, cyclic=cyclic)
    figures: dict[str, Any] = {"violations": sum(int(bad.sum()) for bad in violated.values())}
    if closest:
        with progress_bar() as progress:
            best = closest_dapple(start, conditions, cyclic=cyclic, seconds=seconds, progress=progress)
        cells = best.tiling
        figures |= {"distance": best.distance, "bound": best.bound, "gap": best.gap}
    else:
        cells = dapple(start, conditions, cyclic=cyclic, seed=seed)
    figures["changed"] = int((cells != start).sum())
    return _Made(cells, _measure(cells, conditions) | figures)


def _endless(
    corner: tuple[int, int],
    extent: tuple[int, int],
    conditions: "Conditions",
    share: list[float] | None,
    seed: int,
) -> _Made:
    from tilewright.tilings.dappled import endless_dappled_tiling

    shares = [check_real("--share", given, 0, 1e9) for given in _shares(share, conditions)]
    if len(shares) != 2 or sum(shares) <= 0:
        raise TilewrightValueError(f"--share is {shares}; an endless tiling has two, from 0 on, not both 0")
    tiling = endless_dappled_tiling(conditions, start=shares[1] / sum(shares), seed=seed)
    cells = tiling.cells(*corner, *_checked(*extent))
    return _Made(cells, {"x": corner[0], "y": corner[1], **_measure(cells, conditions)})


def _completed(path: Path, conditions: "Conditions", cyclic: bool, seed: int, seconds: float | None) -> _Made:
    from tilewright.tilings.dappled import complete_dapple

    partial = _read_pins(path)
    with progress_bar() as progress:
        cells = complete_dapple(
            partial, conditions, cyclic=cyclic, seed=seed, seconds=seconds,
            progress=progress,
        )  # fmt: skip
    return _Made(cells, _measure(cells, conditions) | {"pinned": int((partial >= 0).sum())})


def _read_pins(path: Path) -> "Cells":
    """A partial tiling from a .npy or .csv file."""
    from tilewright.files.tables import read_table

    what = f"tiles, -1 where any may be, shape (height, width), up to {_MOST_CELLS:,} cells"
    pins = read_table(path, what)
    if pins.ndim != 2 or not 0 < pins.size <= _MOST_CELLS or pins.dtype.kind not in "iu":
        raise TilewrightFileError(f"{path} does not hold {what}")
    return pins


def _measure(cells: "Cells", conditions: "Conditions") -> dict[str, Any]:
    import numpy as np

    shares = np.bincount(cells.ravel(), minlength=conditions.tiles) / cells.size
    return {
        "width": cells.shape[1],
        "height": cells.shape[0],
        "tiles": len(shares),
        "shares": np.round(shares, 4).tolist(),
    }


def _count(extent: tuple[int, int], conditions: "Conditions", cyclic: bool, json: bool) -> None:
    from tilewright.tilings.dappled import count_dappled

    with progress_bar() as progress:
        number = count_dappled(*extent, conditions, cyclic=cyclic, progress=progress)
    report({"width": extent[0], "height": extent[1], "count": number}, json, str(number))


def _clauses(
    file: Path, extent: tuple[int, int], conditions: "Conditions", cyclic: bool, pins: Path | None
) -> tuple[_Made, str]:
    """Write the conditions, and pins, for a SAT solver."""
    import numpy as np

    from tilewright.files.atomic import whole_file
    from tilewright.tilings.dappled import dapple_formula

    partial = None if pins is None else _read_pins(pins)
    width, height = _checked(*extent) if partial is None else partial.shape[::-1]
    clauses = dapple_formula((height, width), conditions, cyclic=cyclic, partial=partial)
    limits = ", ".join(f"{limit}={np.asarray(limit.most).item()}" for limit in conditions.limits)
    about = f"{'cyclic ' if cyclic else ''}dappled tilings of {width} x {height} cells: {limits}"
    with whole_file(file) as unfinished:
        unfinished.write_text(clauses.dimacs((about,)))
    figures = {"width": width, "height": height, "variables": clauses.count, "clauses": len(clauses)}
    said = f"{file}: {clauses.count} variables, {len(clauses)} clauses"
    return _Made(np.empty((height, width), np.uint8), figures), said


def _ramp(tiles: int) -> list[str]:
    """Colors from dark to light, as the tiles of a picture are."""
    steps = (n / (tiles - 1) for n in range(tiles))
    return [
        "#" + "".join(f"{round(a + (b - a) * step):02x}" for a, b in zip(_INK, _PAPER, strict=True))
        for step in steps
    ]


def _save(file: Path, cells: "Cells", colors: list[str] | None, motif: str, cell: int | None) -> None:
    import numpy as np

    from tilewright.export.drawing.cells import draw_cells, paint_cells
    from tilewright.export.drawing.svg import save_svg
    from tilewright.files import write_image
    from tilewright.files.atomic import whole_file

    suffix = file.suffix.lower()
    if suffix == ".svg":
        save_svg(file, draw_cells(cells, colors=colors, motif=motif, size=cell))
    elif suffix == ".png":
        write_image(file, paint_cells(cells, colors=colors, motif=motif, size=cell))
    else:
        with whole_file(file) as unfinished:
            np.save(unfinished, cells)


def _sentence(file: Path, made: _Made) -> str:
    f = made.figures
    shares = ", ".join(f"{share:.1%} of tile {tile}" for tile, share in enumerate(f["shares"]))
    text = f"{file}: {f['width']} x {f['height']} cells, {shares}"
    if "pinned" in f:
        text += f", {f['pinned']} pinned"
    if "changed" in f:
        text += f", {f['violations']} runs were too long, {f['changed']} cells changed"
    if "gap" in f:
        text += "; no fewer would do" if f["gap"] == 0 else f"; at least {f['bound']} must"
    return text
