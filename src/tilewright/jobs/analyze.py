"""The job of the command ``analyze``: figures of a tile set or of points."""

import warnings
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.errors import Progress, TilewrightWarning
from tilewright.jobs.job import Done, Rule, WritingJob

if TYPE_CHECKING:
    from tilewright.samplers import PointSet


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
        A tile-set folder, or points in ``.npy``, ``.npz``, ``.csv``, ``.txt``, ``.ply`` or ``.parquet``.
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
        material = self._open()
        found = analyze(material, seed=self.seed, progress=progress)
        if self.output is not None:
            found.save_sheet(self.output)
        files = () if self.output is None else (self.output,)
        where, words = _told_box(material)
        figures = {**found.figures, **where, "verdict": found.verdict}
        return Done(files, figures, f"{words}{found}")

    def _open(self) -> Any:
        from tilewright.files import load

        if self.source.is_dir() or not self.source.suffix:
            return load(self.source)
        return self._read()

    def _read(self) -> "PointSet":
        """The points of the file, in the box that is given, else in that of the file, else around them."""
        from tilewright.files import read_points
        from tilewright.files.point_files import ASSUMED
        from tilewright.samplers import Box

        if self.width is not None and self.height is not None:
            return read_points(self.source, Box((self.width, self.height), self.torus))
        found = read_points(self.source)
        if ASSUMED not in found.figures:
            return replace(found, box=replace(found.box, torus=True)) if self.torus else found
        if self.torus:
            return read_points(self.source, Box())
        width, height = found.box.extent
        warnings.warn(
            f"{self.source} names no box; one of {width:.6g} x {height:.6g} around the points, with open "
            "sides, is assumed. Say it by width and height, and torus",
            TilewrightWarning,
            stacklevel=2,
        )
        return found


def _told_box(material: Any) -> tuple[dict[str, Any], str]:
    """Of points, where they lie: as figures, and in a line."""
    from tilewright.samplers import PointSet

    if not isinstance(material, PointSet):
        return {}, ""
    box = material.box
    kind = "torus" if box.torus else "plain box"
    size = " x ".join(f"{side:.6g}" for side in box.extent)
    return {"box": list(box.extent), "torus": box.torus}, f"{len(material):,} points in a {kind} of {size}\n"
