"""The job of the command ``render``: a window of the endless plane as a picture."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tilewright.errors import Progress
from tilewright.jobs.job import Done, WritingJob
from tilewright.kernels.compiling import Clock

if TYPE_CHECKING:
    from tilewright.fields import PixelField
    from tilewright.signals.textures import TextureTiles
    from tilewright.tilings import Tiling


@dataclass(frozen=True, kw_only=True)
class RenderJob(WritingJob):
    """Render a window of the plane that a tile-set folder makes.

    Attributes
    ----------
    output : Path, optional
        The picture: ``.png``, ``.tif``, ``.exr``, ``.jpg`` or ``.webp``; default a PNG named after the set.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    folder : Path
        A tile-set folder of textures.
    width, height : int, optional
        Size of the window in pixels; default 2,048.
    x, y : int, optional
        Its north-west pixel; default (0, 0). The plane is endless where the set has a direct tiling.
    map : str, optional
        Which map; default the main one. ``"all"`` writes a folder with a picture of each.
    scale : float, optional
        Pixels of the picture for each of the window; default 1.
    density : Path, optional
        A gray picture that steers where a set of two sources shows the second.
    cells_per_pixel : float, optional
        Tiles along a pixel of ``density``; default 1.
    lattice_seed : int, optional
        Seed of the tiling; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    folder: Path
    width: int = 2048
    height: int = 2048
    x: int = 0
    y: int = 0
    map: str | None = None
    scale: float = 1.0
    density: Path | None = None
    cells_per_pixel: float = 1.0
    lattice_seed: int = 0

    @property
    def usual(self) -> str | None:
        """Named after what it is made from."""
        return f"{self.folder.resolve().name}{'-maps' if self.map == 'all' else '.png'}"

    def _costs(self) -> dict[str, Any]:
        return super()._costs() | {"width": self.width, "height": self.height}

    def _run(self, progress: Progress | None) -> Done:
        """Lay and save."""
        from tilewright.fields import TextureField
        from tilewright.fields.sampling import scaled_sides
        from tilewright.files import load_texture

        clock = Clock()
        material = load_texture(self.folder)
        field = TextureField(material, self._tiling(material))
        window = (self.x, self.y, self.width, self.height)
        if self.map == "all":
            _save_all(field, self.target, window, self.scale, progress)
        else:
            field.save(self.target, *window, map=self.map, scale=self.scale, progress=progress)
        seconds = clock.seconds
        width, height = scaled_sides(self.width, self.height, self.scale)
        figures = {
            "file": str(self.target), "width": width, "height": height,
            "seconds": round(seconds, 3),
        }  # fmt: skip
        sentence = f"{self.target}: {width} x {height} pixels in {seconds:.1f} s"
        return Done((self.target,), figures, sentence)

    def _tiling(self, material: "TextureTiles") -> "Tiling":
        """Steered by a picture, or by chance."""
        from tilewright.files import read_image
        from tilewright.tilings import density_tiling, stochastic

        if self.density is not None:
            return density_tiling(
                material.tiles, read_image(self.density, color=False), self.lattice_seed,
                cells_per_pixel=self.cells_per_pixel,
            )  # fmt: skip
        ends = (self.x + self.width, self.y + self.height)
        right, bottom = (max(1, -(-end // material.tile_size)) for end in ends)
        return stochastic(material.tiles, right, bottom, self.lattice_seed)


def _save_all(
    field: "PixelField",
    target: Path,
    window: tuple[int, int, int, int],
    scale: float,
    progress: Progress | None,
) -> None:
    """Write a folder with a picture of each map, whole or not at all."""
    from tilewright.files.atomic import whole_folder
    from tilewright.files.images import lossless_suffix
    from tilewright.files.texture_folder import safe_stem

    names = {
        name: f"{safe_stem(name)}{lossless_suffix(form.dtype, form.channels)}"
        for name, form in field.maps.items()
    }

    def objection(folder: Path) -> str:
        others = sorted(entry.name for entry in folder.iterdir() if entry.name not in names.values())
        return f"holds {others[0]}, which is no map of this set" if others else ""

    with whole_folder(target, objection) as folder:
        for name, file in names.items():
            field.save(folder / file, *window, map=name, scale=scale, progress=progress)
