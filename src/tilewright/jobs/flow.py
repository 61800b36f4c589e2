"""The job of the command ``flow``: particles on a dappled tiling, as an animation, a map or arrays."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.checks import check_choice, check_int, check_real
from tilewright.errors import Progress
from tilewright.jobs.job import Done, Rule, WritingJob, useless
from tilewright.jobs.outputs import check_output
from tilewright.kernels.compiling import Clock

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tilewright.flows import Flow

_MOST_CELLS = 2**22
_LIMITS = ("H0", "V0", "H1", "V1")
ANIMATION, DENSITY, TRAILS, ARRAYS = "an animation", "a density", "trails", "a .npz file"


@dataclass(frozen=True, kw_only=True)
class FlowJob(WritingJob):
    """Let particles walk over a dappled tiling of - and |, and write what they did.

    Attributes
    ----------
    output : Path, optional
        ``.gif``, ``.webp``, ``.mp4``: an animation; ``.png``: a ``map``; ``.npz``: all arrays. Default
        ``flow.gif``.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    width, height : int, optional
        Size in cells; default 40 x 25.
    limit : dict of str to number, optional
        Longest runs of - (tile 0) and | (tile 1); default 3 for all.
    input : Path, optional
        A picture to follow: - where it is dark.
    dither : bool, optional
        Whether its grays are mixtures, as far as limits allow; default False.
    cyclic : bool, optional
        Whether opposite borders meet; default False: particles turn back there.
    leave : bool, optional
        Let particles go at borders; default False.
    onward : bool, optional
        Never go back where one came from; default False: particles may turn back, as in the paper.
    particles : int, optional
        Particles at the start; default 250.
    steps : int, optional
        Steps of time; default 200.
    speed : float, optional
        Cells for each step; default 0.125.
    emit : float, optional
        Share of cells that give birth, 0 to 1; default 0.
    births : float, optional
        Births in each of them for each step; default 0.02.
    kill : float, optional
        Share of cells in whose center particles die, 0 to 1; default 0.
    slow, fast : float, optional
        Shares of cells with 0.4 and with 2.5 times the speed, 0 to 1; default 0.
    every : int, optional
        Steps from frame to frame; default 1.
    map : str, optional
        What a picture shows: ``"density"`` (default) or ``"trails"``.
    size : int, optional
        Pixels along a cell; default by the size of the tiling.
    color : str, optional
        What the color of a particle tells: ``"direction"`` (default) or ``"particle"``.
    trail : float, optional
        Frames in which a trail loses half its light; default 8.
    fps : int, optional
        Frames per second; default 25.
    seed : int, optional
        Where chance begins; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    width: int = 40
    height: int = 25
    limit: Mapping[str, float] | None = None
    input: Path | None = None
    dither: bool = False
    cyclic: bool = False
    leave: bool = False
    onward: bool = False
    particles: int = 250
    steps: int = 200
    speed: float = 0.125
    emit: float = 0.0
    births: float | None = None
    kill: float = 0.0
    slow: float = 0.0
    fast: float = 0.0
    every: int | None = None
    map: str | None = None
    size: int | None = None
    color: str | None = None
    trail: float | None = None
    fps: int | None = None
    seed: int = 0

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        *useless(lambda job: job.kind == ANIMATION, ANIMATION, "map"),
        *useless(lambda job: job.kind == DENSITY, DENSITY, "every", "color", "trail", "fps"),
        *useless(lambda job: job.kind == TRAILS, TRAILS, "fps"),
        *useless(lambda job: job.kind == ARRAYS, ARRAYS, "map", "size", "color", "trail", "fps"),
        Rule(
            lambda job: job.dither and job.input is None,
            "{dither} is about a picture to follow; give {input}",
        ),
        Rule(
            lambda job: job.leave and job.cyclic,
            "{leave} is about borders, and {cyclic} joins them; give one of them",
        ),
        Rule(
            lambda job: job.births is not None and not job.emit,
            "{births} is about cells that give birth; give {emit}",
        ),
    )

    @property
    def usual(self) -> str | None:
        """An animation."""
        return "flow.gif"

    @property
    def kind(self) -> str:
        """What is to be written."""
        picture = TRAILS if self.map == "trails" else DENSITY
        return {".npz": ARRAYS, ".png": picture}.get(self.target.suffix.lower(), ANIMATION)

    @property
    def interval(self) -> int:
        """Steps from frame to frame."""
        if self.every is not None:
            return self.every
        return self.steps if self.kind == DENSITY else 1

    def _run(self, progress: Progress | None) -> Done:
        """Dapple, walk and write."""
        from tilewright.flows import FlowTile, simulate_flow, strew_tiles

        clock = Clock()
        self._check()
        cells, tiles = strew_tiles(
            self._dapple(),
            emitting=self.emit, killing=self.kill, slow=self.slow, fast=self.fast,
            rate=0.02 if self.births is None else self.births, seed=self.seed,
            tiles=(FlowTile("-", self.speed), FlowTile("|", self.speed)),
        )  # fmt: skip
        flow = simulate_flow(
            cells, tiles, particles=self.particles, steps=self.steps, torus=self.cyclic, leaves=self.leave,
            turns_back=not self.onward, every=self.interval, seed=self.seed, progress=progress,
        )  # fmt: skip
        self._write(flow, progress)
        seconds = clock.seconds
        figures = {"file": str(self.target), **flow.figures, "seconds": round(seconds, 3)}
        return Done((self.target,), figures, self._sentence(figures, seconds))

    def _sentence(self, figures: dict[str, Any], seconds: float) -> str:
        return (
            f"{self.target}: {self.particles} particles on {self.width} x {self.height} cells, {self.steps} "
            f"steps; born {figures['born']}, killed {figures['killed']}, left {figures['left']}, alive "
            f"{figures['alive']}; {seconds:.1f} s"
        )

    def _check(self) -> None:
        """Refuse before the walk what would be refused only after it."""
        from tilewright.export.drawing.flows import fit_size
        from tilewright.export.drawing.videos import check_videos

        if check_output(self.target, (".gif", ".webp", ".mp4", ".png", ".npz")) == ".mp4":
            check_videos()
        check_choice("map", self.map or "density", ("density", "trails"))
        check_choice("color", self.color or "direction", ("direction", "particle"))
        check_real("speed", self.speed, 0.001, 8)
        check_int("width", self.width, 1, 65536)
        check_int("height", self.height, 1, 65536)
        check_int("width times height", self.width * self.height, 1, _MOST_CELLS)
        check_int("steps", self.steps, 1, 2**20)
        least, most = (1, 64) if self.kind == DENSITY else (4, 128)
        for name, low, high in (("every", 1, 2**20), ("size", least, most), ("fps", 1, 50)):
            if getattr(self, name) is not None:
                check_int(name, getattr(self, name), low, high)
        if self.trail is not None:
            check_real("trail", self.trail, 0, 1000)
        if self.kind == ANIMATION:
            fit_size((self.height, self.width), self.size, -(-self.steps // self.interval) + 1)
        for name in self.limit or ():
            check_choice("limit", name, _LIMITS)

    def _dapple(self) -> "NDArray[Any]":
        """A tiling of - and | that follows a picture, or chance."""
        from tilewright.files import read_image
        from tilewright.tilings.dappled import dapple, random_start, start_from_image

        limits = self.limit or dict.fromkeys(_LIMITS, 3)
        extent = (self.width, self.height)
        if self.input is None:
            start = random_start(*extent, seed=self.seed)
        else:
            start = start_from_image(
                read_image(self.input), *extent, dither=self.dither, limits=limits if self.dither else None
            )
        return dapple(start, limits, cyclic=self.cyclic, seed=self.seed, tiles=2)

    def _write(self, flow: "Flow", progress: Progress | None) -> None:
        """An animation, a map or arrays."""
        from tilewright.export import save_flow
        from tilewright.export.drawing import draw_density, draw_trails, save_animation
        from tilewright.files import write_image

        style = {"size": self.size, "color": self.color, "trail": self.trail, "rate": self.fps}
        given: dict[str, Any] = {name: value for name, value in style.items() if value is not None}
        if self.kind == ANIMATION:
            save_animation(self.target, flow, **given, progress=progress)
        elif self.kind == ARRAYS:
            save_flow(self.target, flow)
        elif self.kind == TRAILS:
            write_image(self.target, draw_trails(flow, **given))
        else:
            size = self.size or max(1, min(48, 960 // max(flow.cells.shape)))
            write_image(self.target, draw_density(flow, size=size))
