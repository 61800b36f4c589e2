"""tilewright flow"""

import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tilewright.checks import check_choice, check_int, check_real
from tilewright.cli.options import Json, Seed, parse_limits, progress_bar, report
from tilewright.errors import TilewrightValueError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tilewright.flows.flow import Flow

_SUFFIXES = (".gif", ".webp", ".png", ".npz")
_MOST_CELLS = 2**22
_LIMITS = ("H0=3", "V0=3", "H1=3", "V1=3")
# What has no use for each kind of picture.
_UNUSED = {
    "an animation": {"--map"},
    "a density": {"--every", "--color", "--trail", "--fps"},
    "trails": {"--fps"},
    "a .npz file": {"--map", "--size", "--color", "--trail", "--fps"},
}


def command(
    output: Annotated[
        Path,
        typer.Option("-o", "--output", help="FILE.gif or .webp: animation; .png: a map; .npz: positions."),
    ] = Path("flow.gif"),
    width: Annotated[int, typer.Option(help="Cells.")] = 40,
    height: Annotated[int, typer.Option(help="Cells.")] = 25,
    limit: Annotated[
        list[str] | None,
        typer.Option(
            help="Longest run of - (0) and | (1), again for each: H0=2, V1=inf; else 3 for all.",
            show_default=False,
        ),
    ] = None,
    input: Annotated[
        Path | None, typer.Option(help="Picture to follow: - where it is dark.", show_default=False)
    ] = None,
    dither: Annotated[
        bool, typer.Option("--dither", help="Let grays of --input be mixtures, as far as limits allow.")
    ] = False,
    cyclic: Annotated[
        bool, typer.Option("--cyclic", help="Join opposite borders; else particles turn back there.")
    ] = False,
    leave: Annotated[
        bool, typer.Option("--leave", help="Let particles go at borders instead of turning them back.")
    ] = False,
    onward: Annotated[
        bool, typer.Option("--onward", help="Never go back where one came from (the paper does).")
    ] = False,
    particles: Annotated[int, typer.Option(help="At the start.")] = 250,
    steps: Annotated[int, typer.Option(help="Of time.")] = 200,
    speed: Annotated[float, typer.Option(help="Cells for each step.")] = 0.125,
    emit: Annotated[float, typer.Option(help="Share of cells that give birth, 0 to 1.")] = 0.0,
    births: Annotated[
        float | None, typer.Option(help="In each of these, for each step; 0.02.", show_default=False)
    ] = None,
    kill: Annotated[float, typer.Option(help="Share of cells in whose center particles die.")] = 0.0,
    slow: Annotated[float, typer.Option(help="Share of cells with 0.4 times the speed.")] = 0.0,
    fast: Annotated[float, typer.Option(help="Share of cells with 2.5 times the speed.")] = 0.0,
    every: Annotated[
        int | None, typer.Option(help="Steps from frame to frame; 1.", show_default=False)
    ] = None,
    map: Annotated[
        str | None, typer.Option(help="Of a .png: density or trails; density.", show_default=False)
    ] = None,
    size: Annotated[
        int | None, typer.Option(help="Pixels along a cell; what suits.", show_default=False)
    ] = None,
    color: Annotated[
        str | None, typer.Option(help="By direction or particle; direction.", show_default=False)
    ] = None,
    trail: Annotated[
        float | None,
        typer.Option(help="Frames in which trails lose half their light; 8.", show_default=False),
    ] = None,
    fps: Annotated[
        int | None, typer.Option("--fps", help="Frames for each second; 25.", show_default=False)
    ] = None,
    seed: Seed = 0,
    json: Json = False,
) -> None:
    """Let particles walk over a dappled tiling of - and |, and make an animation or a map of them.

    Example: tilewright flow

    Example: tilewright flow -o crowd.webp --cyclic --emit 0.05 --kill 0.05 --slow 0.1 --fast 0.1

    Example: tilewright flow -o density.png --width 100 --height 60 --particles 5000 --steps 20000

    Calls tilewright.simulate_flow(cells, tiles, particles=..., steps=...) on the tilewright.dapple(...) of
    tilewright.random_start(...) or start_from_image(...), with tilewright.strew_tiles(cells, ...) for --emit,
    --kill, --slow and --fast; then tilewright.save_animation(FILE, flow), draw_density(flow) or
    draw_trails(flow).
    """
    from tilewright.export.drawing.flows import fit_size
    from tilewright.files.atomic import check_file

    started = time.perf_counter()
    suffix = check_choice("the ending of -o", output.suffix.lower(), _SUFFIXES)
    check_choice("--map", map or "density", ("density", "trails"))
    kind = {".npz": "a .npz file", ".png": "trails" if map == "trails" else "a density"}.get(
        suffix, "an animation"
    )
    looks: dict[str, Any] = {
        "--map": map, "--every": every, "--size": size, "--color": color, "--trail": trail, "--fps": fps
    }  # fmt: skip
    for option in sorted(_UNUSED[kind]):
        if looks[option] is not None:
            raise TilewrightValueError(f"{option} has no use with {kind}; leave it out")
    if dither and input is None:
        raise TilewrightValueError("--dither is about a picture to follow; give --input")
    if leave and cyclic:
        raise TilewrightValueError("--leave is about borders, and --cyclic joins them; give one of them")
    if births is not None and not emit:
        raise TilewrightValueError("--births is about cells that give birth; give --emit")
    births = 0.02 if births is None else births
    check_real("--speed", speed, 0.001, 8)
    for option, side in (("--width", width), ("--height", height)):
        check_int(option, side, 1, 65536)
    check_int("--width times --height", width * height, 1, _MOST_CELLS)
    check_int("--steps", steps, 1, 2**20)
    _check_looks(kind, looks)
    if every is None:
        every = steps if kind == "a density" else 1
    if kind == "an animation":
        fit_size((height, width), size, -(-steps // every) + 1)
    check_file(output)
    limits = parse_limits(limit or [*_LIMITS])
    for name in limits:
        check_choice("--limit", name, ("H0", "V0", "H1", "V1"))
    cells = _dappled(input, dither, (width, height), limits, cyclic, seed)

    from tilewright.flows.flow import FlowTile, simulate_flow, strew_tiles

    cells, tiles = strew_tiles(
        cells, emitting=emit, killing=kill, slow=slow, fast=fast, rate=births, seed=seed,
        tiles=(FlowTile("-", speed), FlowTile("|", speed)),
    )  # fmt: skip
    with progress_bar() as progress:
        flow = simulate_flow(
            cells, tiles, particles=particles, steps=steps, torus=cyclic, leaves=leave, seed=seed,
            turns_back=not onward, every=every, progress=progress,
        )  # fmt: skip
        style = {"size": size, "color": color, "trail": trail, "rate": fps, "progress": progress}
        _save(output, flow, kind, {name: value for name, value in style.items() if value is not None})
    seconds = time.perf_counter() - started
    figures = {"file": str(output), **_measure(flow), "seconds": round(seconds, 3)}
    report(
        figures,
        json,
        f"{output}: {particles} particles on {width} x {height} cells, {steps} steps; born "
        f"{figures['born']}, killed {figures['killed']}, left {figures['left']}, alive {figures['alive']}; "
        f"{seconds:.1f} s",
    )


def _check_looks(kind: str, looks: dict[str, Any]) -> None:
    """What would be refused only after the walk."""
    least, most = (1, 64) if kind == "a density" else (4, 128)
    for option, low, high in (("--every", 1, 2**20), ("--size", least, most), ("--fps", 1, 50)):
        if looks[option] is not None:
            check_int(option, looks[option], low, high)
    if looks["--trail"] is not None:
        check_real("--trail", looks["--trail"], 0, 1000)
    check_choice("--color", looks["--color"] or "direction", ("direction", "particle"))


def _dappled(
    picture: Path | None,
    dither: bool,
    extent: tuple[int, int],
    limits: dict[str, int | float],
    cyclic: bool,
    seed: int,
) -> "NDArray[Any]":
    """A tiling of - and | that follows a picture, or chance."""
    from tilewright.files import read_image
    from tilewright.tilings.dappled import dapple, random_start, start_from_image

    if picture is None:
        start = random_start(*extent, seed=seed)
    else:
        pixels = read_image(picture)
        start = start_from_image(pixels, *extent, dither=dither, limits=limits if dither else None)
    return dapple(start, limits, cyclic=cyclic, seed=seed, tiles=2)


def _save(output: Path, flow: "Flow", kind: str, style: dict[str, Any]) -> None:
    """Write an animation, a map or arrays."""
    from tilewright.export.drawing.flows import draw_density, draw_trails, save_animation
    from tilewright.files import write_image

    if kind == "an animation":
        save_animation(output, flow, **style)
        return
    if kind == "a .npz file":
        _save_arrays(output, flow)
        return
    style.pop("progress")
    if kind == "trails":
        pixels = draw_trails(flow, **style)
    else:
        style.setdefault("size", max(1, min(48, 960 // max(flow.cells.shape))))
        pixels = draw_density(flow, **style)
    write_image(output, pixels)


def _save_arrays(output: Path, flow: "Flow") -> None:
    """The arrays of a flow by their names, and its tiles as columns."""
    import numpy as np

    from tilewright.files.atomic import whole_file

    arrays: dict[str, Any] = {
        f"tile_{name}": np.array([getattr(tile, name) for tile in flow.tiles])
        for name in ("ways", "speed", "emits", "kills")
    }
    names = ("cells", "torus", "times", "positions", "ways", "departures", "born", "killed", "left")
    arrays |= {name: np.asarray(getattr(flow, name)) for name in names}
    with whole_file(output) as unfinished:
        np.savez_compressed(unfinished, **arrays)


def _measure(flow: "Flow") -> dict[str, Any]:
    """What a run is told by."""
    height, width = flow.cells.shape
    visits = flow.visits()
    mean = float(visits.mean())
    return {
        "width": width,
        "height": height,
        "steps": int(flow.times[-1]),
        "frames": len(flow.times),
        "start": int(flow.alive[0].sum()),
        "born": int(flow.born[-1]),
        "killed": int(flow.killed[-1]),
        "left": int(flow.left[-1]),
        "alive": int(flow.alive[-1].sum()),
        "visits": round(mean, 4),
        "variation": round(float(visits.std()) / mean, 4) if mean else None,
        "unvisited": round(float((visits == 0).mean()), 4),
    }
