"""The job of the command ``surface``: points over a mesh."""

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tilewright.checks import check_choice
from tilewright.errors import Progress, TilewrightFileError, TilewrightWarning
from tilewright.jobs.job import Done, WritingJob
from tilewright.kernels.compiling import Clock

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


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
    density : str, optional
        Where points are to lie closer: the name of a property of a PLY mesh, one number for every vertex or
        face, or else a picture over the mesh's texture coordinates, dense where it is bright.
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
    density: str | None = None
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

    def _density(self) -> "NDArray[np.float64] | None":
        """Weights of vertices or faces, or a picture; None where all places are the same."""
        from tilewright.files.meshes.reading import read_mesh_property

        if self.density is None:
            return None
        if Path(self.density).is_file():
            return self._picture(Path(self.density))
        try:
            return read_mesh_property(self.mesh, self.density)
        except TilewrightFileError as error:
            where = "" if Path(self.density).suffix == "" else f"; {self.density} is no picture file either"
            raise TilewrightFileError(f"{error}{where}", value=self.density) from None

    def _picture(self, path: Path) -> "NDArray[np.float64]":
        """How bright a picture is, nothing where it is transparent."""
        from tilewright.files import read_image
        from tilewright.pixels import has_alpha, mean_gray, white

        pixels = read_image(path, color=False)
        if pixels.ndim == 2:
            return pixels / white(pixels.dtype)
        bright = mean_gray(pixels) / white(pixels.dtype)
        return bright * pixels[..., -1] / white(pixels.dtype) if has_alpha(pixels.shape[2]) else bright

    def _run(self, progress: Progress | None) -> Done:
        from tilewright.fields.surfaces import surface_points
        from tilewright.files import write_surface_points

        clock = Clock()
        self._check()
        made = surface_points(
            self.mesh,
            self.count,
            radius=self.radius,
            density=self._density(),
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
