"""The command ``flow``."""

from pathlib import Path
from typing import Annotated

from tilewright.cli.options import DryRun, Force, Json, Quiet, option, parse_limits
from tilewright.cli.performing import perform


def command(
    output: Annotated[
        Path | None,
        option(
            "-o",
            "--output",
            help="Animation FILE.gif, .webp or .mp4, map FILE.png, or all arrays FILE.npz; default flow.gif.",
        ),
    ] = None,
    width: Annotated[int, option(help="Width in cells; default 40.")] = 40,
    height: Annotated[int, option(help="Height in cells; default 25.")] = 25,
    limit: Annotated[
        list[str] | None,
        option(
            metavar="LIMIT=CELLS",
            help="Longest run in cells of - (tile 0) and | (tile 1), once for each limit: H0=2, V1=inf; "
            "default H0=3, V0=3, H1=3 and V1=3.",
        ),
    ] = None,
    input: Annotated[
        Path | None, option(help="Picture to follow: - where it is dark; default none, a random tiling.")
    ] = None,
    dither: Annotated[
        bool,
        option("--dither", help="Show the grays of --input as mixtures of tiles, as far as limits allow."),
    ] = False,
    cyclic: Annotated[
        bool, option("--cyclic", help="Join opposite borders; otherwise particles turn back there.")
    ] = False,
    leave: Annotated[
        bool, option("--leave", help="Let particles go at borders instead of turning them back.")
    ] = False,
    onward: Annotated[
        bool, option("--onward", help="Let no particle turn straight back; the paper lets them.")
    ] = False,
    particles: Annotated[int, option(help="Number of particles at the start; default 250.")] = 250,
    steps: Annotated[int, option(help="Number of time steps; default 200.")] = 200,
    speed: Annotated[float, option(help="Speed in cells per step, 0.001 to 8; default 0.125.")] = 0.125,
    emit: Annotated[float, option(help="Share of cells that give birth, 0 to 1; default 0.")] = 0.0,
    births: Annotated[
        float | None, option(help="Births per step in each of those cells, on average; default 0.02.")
    ] = None,
    kill: Annotated[
        float, option(help="Share of cells in whose center particles die, 0 to 1; default 0.")
    ] = 0.0,
    slow: Annotated[float, option(help="Share of cells with 0.4 times the speed, 0 to 1; default 0.")] = 0.0,
    fast: Annotated[float, option(help="Share of cells with 2.5 times the speed, 0 to 1; default 0.")] = 0.0,
    every: Annotated[int | None, option(help="Steps from frame to frame; default 1.")] = None,
    map: Annotated[str | None, option(help="What a .png shows: density (default) or trails.")] = None,
    size: Annotated[
        int | None, option(help="Size of a cell in pixels; default by the size of the tiling, at most 48.")
    ] = None,
    color: Annotated[
        str | None, option(help="What the color of a particle tells: direction (default) or particle.")
    ] = None,
    trail: Annotated[
        float | None, option(help="Frames in which a trail loses half its light; default 8.")
    ] = None,
    fps: Annotated[
        int | None, option("--fps", help="Frames per second of an animation, 1 to 50; default 25.")
    ] = None,
    seed: Annotated[
        int, option("--seed", help="Seed of the tiling and of the particles, from 0 on; default 0.")
    ] = 0,
    force: Force = False,
    dry_run: DryRun = False,
    quiet: Quiet = False,
    json: Json = False,
) -> None:
    """Let particles walk over a dappled tiling of - and |, and make an animation or a map of them.

    On - a particle goes on west or east, on | north or south; in a dappled tiling neither has long runs.

    Example: tilewright flow

    Example: tilewright flow -o crowd.webp --cyclic --emit 0.05 --kill 0.05 --slow 0.1 --fast 0.1

    Example: tilewright flow -o density.png --width 100 --height 60 --particles 5000 --steps 20000

    Calls tilewright.jobs.FlowJob(...).run(). That runs tilewright.simulate_flow(cells, tiles, particles=...,
    steps=...) on the dapple(...) of random_start(...) or start_from_image(...), with strew_tiles(cells, ...)
    for --emit, --kill, --slow and --fast; then it writes by save_animation(FILE, flow), draw_density(flow),
    draw_trails(flow) or save_flow(FILE, flow).
    """
    perform("FlowJob", locals() | {"limit": parse_limits(limit)})
