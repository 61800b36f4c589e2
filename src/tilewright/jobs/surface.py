"""The job of the command ``surface``: points over a mesh."""

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tilewright.checks import check_choice
from tilewright.errors import Progress, TilewrightWarning
from tilewright.jobs.job import Done, WritingJob
from tilewright.kernels.compiling import Clock


@dataclass(frozen=True, kw_only=True)
class SurfaceJob(WritingJob):
    """Write points that are spread over a mesh.

    Attributes
    ----------
    output : Path, optional
        ``.npy`` (positions), ``.ply``, ``.csv``, ``.parquet`` or ``.usda``.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    mesh : Path
        ``.obj``, ``.off`` or ``.ply``; by the package trimesh also ``.stl``, ``.glb``, ``.3mf`` and others.
    count : int, optional
        How many points, or give ``radius``.
    radius : float, optional
        Half of the least distance, in the mesh's units.
    kind : str, optional
        ``"even"`` (default), ``"poisson"`` or ``"tiles"``.
    rho : float, optional
        Relative radius; default 0.765, of tiles 0.7.
    seed : int, optional
        The same seed gives the same points; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    mesh: Path
    count: int | None = None
    radius: float | None = None
    kind: str = "even"
    rho: float | None = None
    seed: int = 0

    @property
    def usual(self) -> str | None:
        """Named after the mesh."""
        return f"{self.mesh.stem}-points.npy"

    def _costs(self) -> dict[str, Any]:
        known = {} if self.count is None else {"count": self.count}
        return super()._costs() | known

    def _check(self) -> None:
        """Refuse before the work what would be refused after it."""
        from tilewright.fields.surfaces import KINDS
        from tilewright.files.surface_files import check_surface_file

        check_surface_file(self.target)
        check_choice("kind", self.kind, KINDS)

    def _run(self, progress: Progress | None) -> Done:
        from tilewright.fields.surfaces import surface_points
        from tilewright.files import write_surface_points

        clock = Clock()
        self._check()
        made = surface_points(
            self.mesh,
            self.count,
            radius=self.radius,
            kind=self.kind,
            rho=self.rho,
            seed=self.seed,
            progress=progress,
        )
        for note in made.notes:
            warnings.warn(note, TilewrightWarning, stacklevel=2)
        write_surface_points(self.target, made)
        known = {**made.note(), "seconds": round(clock.seconds, 3), "notes": list(made.notes)}
        figures = {"file": str(self.target), "mesh": str(self.mesh), **known}
        apart = f", none closer than {made.distance:.6g}" if made.distance else ""
        return Done(
            (self.target,), figures, f"{self.target}: {len(made):,} points on {self.mesh.name}{apart}"
        )
