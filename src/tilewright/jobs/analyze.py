"""The job of the command ``analyze``: figures of a tile set or of points."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from tilewright.errors import Progress
from tilewright.jobs.job import Done, Rule, WritingJob


@dataclass(frozen=True, kw_only=True)
class AnalyzeJob(WritingJob):
    """Measure a tile-set folder, or the points of a file.

    Attributes
    ----------
    output : Path, optional
        A sheet of pictures: ``.png``, ``.jpg``, ``.svg`` or ``.pdf``.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    source : Path
        A tile-set folder, or points in ``.npy``, ``.csv``, ``.parquet`` or ``.ply``.
    width, height : float, optional
        Sides of the box that the points of a file lie in; default as the file says.
    torus : bool, optional
        Whether opposite sides of the box meet; default False.
    seed : int, optional
        Seed of the tilings that are measured; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    source: Path
    width: float | None = None
    height: float | None = None
    torus: bool = False
    seed: int = 0

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        Rule(lambda job: (job.width is None) != (job.height is None), "{width} and {height} go together"),
    )

    def _run(self, progress: Progress | None) -> Done:
        """Measure and draw."""
        from tilewright.analysis import analyze
        from tilewright.analysis.sheets import check_sheet

        if self.output is not None:
            check_sheet(self.output)
        found = analyze(self._open(), seed=self.seed, progress=progress)
        if self.output is not None:
            found.save_sheet(self.output)
        files = () if self.output is None else (self.output,)
        return Done(files, found.figures, str(found))

    def _open(self) -> Any:
        from tilewright.files import load, read_points
        from tilewright.samplers import Box

        if self.source.is_dir() or not self.source.suffix:
            return load(self.source)
        box = Box() if self.torus else None
        if self.width is not None and self.height is not None:
            box = Box((self.width, self.height), self.torus)
        return read_points(self.source, box)
