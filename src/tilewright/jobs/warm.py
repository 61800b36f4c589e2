"""The job of the command ``warm``: compiles all loops, so that no later command waits for that."""

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

from tilewright.errors import Progress, TilewrightWarning
from tilewright.jobs.job import Done, Job
from tilewright.kernels.compiling import Clock, Compiling


@dataclass(frozen=True, kw_only=True)
class WarmJob(Job):
    """Do small work of every kind, so that all loops are compiled and kept on disk.

    Raises
    ------
    TilewrightError
        The disk is full.
    """

    def _run(self, progress: Progress | None) -> Done:
        """Compile."""
        clock, compiled = Clock(), Compiling.seconds
        with TemporaryDirectory() as folder:
            works = list(_small_works(Path(folder)))
            for number, (what, work) in enumerate(works):
                if progress is not None:
                    progress(number, len(works), what)
                with warnings.catch_warnings():  # of photographs that nobody brought
                    warnings.simplefilter("ignore", TilewrightWarning)
                    work()
        seconds = Compiling.seconds - compiled
        figures = {"compiling_seconds": round(seconds, 3), "seconds": round(clock.seconds, 3)}
        words = f"compiled in {seconds:.1f} s" if seconds else "all was compiled already"
        return Done((), figures, f"{words}; the small work for it took {clock.seconds:.1f} s")


def _small_works(folder: Path) -> Iterator[tuple[str, Callable[[], object]]]:
    """One small piece of work for each way through the program, by name."""
    import numpy as np

    from tilewright import jobs
    from tilewright.files import write_image
    from tilewright.files.texts import write_text

    rng = np.random.default_rng(1)
    photo, ramp, tiles = folder / "photo.png", folder / "ramp.png", folder / "tiles"
    noise = rng.integers(0, 256, (200, 200, 3), np.uint8)
    write_image(photo, noise)
    write_image(ramp, noise[:32, :32, :1])
    walls = np.kron(rng.integers(0, 200, (10, 5, 3)), np.ones((18, 38, 1))) + 40.0
    rows = np.pad(walls, ((1, 1), (1, 1), (0, 0)))[:180, :190].astype(np.uint8)
    write_image(folder / "bricks.png", rows)
    write_image(folder / "deep.tif", noise.astype(np.uint16) * 257)

    sheet = folder / "sheet.off"
    write_text(sheet, "OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")

    texture = jobs.TextureJob(photo=photo, tile_size=16, threads=1)
    made: list[tuple[str, jobs.Job]] = [
        ("texture", replace(texture, output=tiles)),
        ("courses", jobs.TextureJob(photo=folder / "bricks.png", output=folder / "courses")),
        ("16 bits", replace(texture, photo=folder / "deep.tif", output=folder / "deep")),
        ("material", replace(texture, map={"height": str(photo)}, output=folder / "maps", flatten=True)),
        ("Wang tiles", replace(texture, tiles="wang", output=folder / "wang")),
        ("corner tiles", replace(texture, tiles="corner", output=folder / "corner")),
        ("render", jobs.RenderJob(folder=tiles, width=50, height=50, output=folder / "a.png")),
        ("export", jobs.ExportJob(folder=tiles, to="ktx2", output=folder / "ktx2")),
        ("analyze", jobs.AnalyzeJob(source=tiles)),
        ("points", jobs.PointsJob(count=50, output=folder / "p.npy")),
        ("torus", jobs.PointsJob(width=3, height=3, torus=True, output=folder / "t.npy")),
        (
            "point tiles",
            jobs.PointsJob(count=9, colors=2, points=8, rho=0.5, output=folder / "q.npy"),
        ),
        ("lloyd", jobs.PointsJob(method="lloyd", count=30, output=folder / "l.npy")),
        ("dart", jobs.PointsJob(method="dart", count=30, output=folder / "d.npy")),
        ("analyze points", jobs.AnalyzeJob(source=folder / "d.npy", width=1, height=1)),
        ("surface", jobs.SurfaceJob(mesh=sheet, count=40, output=folder / "s.npy")),
        ("bricks", jobs.BricksJob(width=4, height=4, output=folder / "b.png")),
        ("bond", jobs.BricksJob(width=4, height=4, pattern="herringbone", output=folder / "h.png")),
        ("dapple", jobs.DappleJob(width=9, height=9, output=folder / "dapple.png")),
        ("endless", jobs.DappleJob(width=9, height=9, endless=True, output=folder / "e.npy")),
        ("picture", jobs.DappleJob(input=ramp, dither=True, width=9, height=9, output=folder / "i.npy")),
        ("flow", jobs.FlowJob(width=5, height=4, particles=9, steps=9, output=folder / "f.gif")),
        ("aperiodic", jobs.AperiodicJob(name="ammann-16", width=5, height=5, output=folder / "a.svg")),
        ("pack", jobs.PackJob(method="search", output=folder / "p.png")),
    ]
    for what, job in made:
        yield what, job.run
