"""The job of the command ``view``: a page to pan, zoom and tilt."""

from dataclasses import dataclass
from pathlib import Path

from tilewright.errors import Progress
from tilewright.jobs.job import Done, WritingJob
from tilewright.jobs.notes import note_chance


@dataclass(frozen=True, kw_only=True)
class ViewJob(WritingJob):
    """Write a page that shows the endless plane of a tile-set folder.

    Attributes
    ----------
    output : Path, optional
        The ``.html`` file; default one named after the set.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    folder : Path
        A tile-set folder of textures.
    compare : bool, optional
        Show plain repetition, hex-tiling, by-example noise, and the other of Wang and corner tiles too;
        default False.
    lattice_seed : int, optional
        Seed of the tiling that the page begins with; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    folder: Path
    compare: bool = False
    lattice_seed: int = 0

    @property
    def usual(self) -> str | None:
        """Named after what it is made from."""
        return f"{self.folder.resolve().name}.html"

    def _run(self, progress: Progress | None) -> Done:
        """Compare where that is asked for, and write."""
        from tilewright.analysis import compare_textures
        from tilewright.export import save_viewer
        from tilewright.export.viewer.page import check_page
        from tilewright.files import load_texture

        check_page(self.target)
        material = load_texture(self.folder)
        note_chance(material, "the page")
        compared = None
        if self.compare:
            compared = compare_textures(material, seed=self.lattice_seed, progress=progress)
        save_viewer(material, self.target, seed=self.lattice_seed, compare=compared)
        size = self.target.stat().st_size
        figures = {"file": str(self.target), "bytes": size}
        figures |= {} if compared is None else {"methods": compared.figures}
        return Done((self.target,), figures, f"{self.target}: {size / 1e6:.1f} MB")
