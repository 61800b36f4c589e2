"""The job of the command ``export``: a tile set for an engine or another program."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from tilewright.checks import check_choice
from tilewright.errors import Progress
from tilewright.jobs.job import Done, Rule, WritingJob
from tilewright.jobs.notes import note_chance

_PICTURES = (".png", ".tif", ".tiff", ".exr", ".jpg", ".jpeg", ".bmp", ".tga", ".webp")


@dataclass(frozen=True, kw_only=True)
class ExportJob(WritingJob):
    """Write a tile-set folder for an engine, or one map as a picture.

    Attributes
    ----------
    output : Path, optional
        The folder to write, or a picture of one map; default a folder named after the set and the target.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    folder : Path
        A tile-set folder of textures.
    to : str, optional
        A target of `save_for_engine`; ``"atlas"`` (default) or ``"array"`` for a picture.
    map : str, optional
        Which map a picture shows; default the main one.
    lattice_seed : int, optional
        Seed of the tiling, built into shaders; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    folder: Path
    to: str = "atlas"
    map: str | None = None
    lattice_seed: int = 0

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        Rule(
            lambda job: job.map is not None and not job.is_picture,
            "{map} is for a picture, such as a .png file; a folder holds all maps",
        ),
    )

    @property
    def usual(self) -> str | None:
        """Named after what it is made from."""
        return f"{self.folder.resolve().name}-{self.to}"

    @property
    def is_picture(self) -> bool:
        """Whether one map is asked for."""
        return self.target.suffix.lower() in _PICTURES

    def _run(self, progress: Progress | None) -> Done:
        """Write, and count what was written."""
        from tilewright.export import save_array, save_atlas, save_for_engine
        from tilewright.export.engines import TARGETS
        from tilewright.files import load_texture

        if self.is_picture:
            write = {"array": save_array, "atlas": save_atlas}[
                check_choice("to", self.to, ("array", "atlas"))
            ]
            write(load_texture(self.folder), self.target, map=self.map)
            figures: dict[str, Any] = {"file": str(self.target), "bytes": self.target.stat().st_size}
            return Done((self.target,), figures, str(self.target))
        check_choice("to", self.to, TARGETS)
        material = load_texture(self.folder)
        note_chance(material, "engines")
        save_for_engine(material, self.target, self.to, seed=self.lattice_seed)
        files = tuple(path for path in self.target.rglob("*") if path.is_file())
        size = sum(path.stat().st_size for path in files)
        figures = {"folder": str(self.target), "files": len(files), "bytes": size}
        begin = self.target / "README.md"
        return Done(
            (self.target,), figures,
            f"{self.target}: {len(files)} files, {size / 1e6:.1f} MB; begin with {begin}",
        )  # fmt: skip
