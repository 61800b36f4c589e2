"""The job of the command ``compare``: methods for blue-noise points side by side."""

from collections.abc import Sequence
from dataclasses import dataclass

from tilewright.errors import Progress
from tilewright.jobs.job import Done, WritingJob
from tilewright.kernels.compiling import Clock


@dataclass(frozen=True, kw_only=True)
class CompareJob(WritingJob):
    """Compare methods for points as Lagae 2007, chapter 6, does.

    Attributes
    ----------
    output : Path, optional
        A folder for the table, the figures and the pictures.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    methods : sequence of str, optional
        Names, as ``list`` gives them; default those of moderate cost.
    full : bool, optional
        All methods, however long they take; default False.
    list : bool, optional
        Only name the methods; default False.
    sets : int, optional
        Sets of each method, K; default 10.
    seed : int, optional
        Where chance begins; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    methods: Sequence[str] | None = None
    full: bool = False
    list: bool = False
    sets: int = 10
    seed: int = 0

    def _run(self, progress: Progress | None) -> Done:
        """Measure every method, and save what is seen."""
        from tilewright.analysis import compare
        from tilewright.analysis.points.comparison import check_comparison_folder
        from tilewright.analysis.points.contenders import list_contenders

        if self.list:
            known = {name: contender.source for name, contender in list_contenders().items()}
            lines = (f"{name:<22} {source}" for name, source in known.items())
            return Done((), dict(known), "\n".join(lines))
        clock = Clock()
        if self.output is not None:
            check_comparison_folder(self.output)
        found = compare(self.methods, full=self.full, sets=self.sets, seed=self.seed, progress=progress)
        if self.output is not None:
            found.save(self.output)
        seconds = round(clock.seconds, 1)
        files = () if self.output is None else (self.output,)
        figures = {"methods": found.plain_rows(), "verdict": found.verdict, "seconds": seconds}
        return Done(files, figures, f"{found.table()}\n{seconds} s")
