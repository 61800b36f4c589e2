"""The command ``flow``."""

from pathlib import Path
from typing import Annotated

import typer

from tilewright.cli.options import Json, Seed, parse_limits
from tilewright.cli.performing import perform


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
    perform("FlowJob", locals() | {"limit": parse_limits(limit)})
