"""The job of the command ``info``: what a tile-set folder holds, or what the program knows by name."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tilewright import __version__
from tilewright.errors import Progress
from tilewright.jobs.job import Done, Job

if TYPE_CHECKING:
    from tilewright.signals.points import PointTiles
    from tilewright.signals.textures import TextureTiles


@dataclass(frozen=True, kw_only=True)
class InfoJob(Job):
    """Say what a tile-set folder holds; without one, what can be asked for by name.

    Attributes
    ----------
    folder : Path, optional
        A tile-set folder; default none.

    Raises
    ------
    TilewrightError
        By `run`, a folder that cannot be read.
    """

    folder: Path | None = None

    def _run(self, progress: Progress | None) -> Done:
        """Read, or list."""
        if self.folder is None:
            figures = {"version": __version__, **_known_names()}
        else:
            figures = _describe(self.folder)
        lines = [f"{name.replace('_', ' ')}: {_in_words(value)}" for name, value in figures.items()]
        return Done((), figures, "\n".join(lines))


def _known_names() -> dict[str, Any]:
    """Names by what they are given to."""
    from tilewright.export.engines import TARGETS
    from tilewright.fields.bricks.bonds import BONDS
    from tilewright.samplers import METHODS as SAMPLERS
    from tilewright.signals.points import TILE_METHODS
    from tilewright.signals.textures import METHODS
    from tilewright.tiles.aperiodic import APERIODIC_SETS

    return {
        "methods_of_texture": list(METHODS),
        "methods_of_points_with_tiles": list(TILE_METHODS),
        "methods_of_points_without": list(SAMPLERS),
        "targets_of_export": list(TARGETS),
        "patterns_of_bricks": ["wang", *BONDS],
        "sets_of_aperiodic": list(APERIODIC_SETS),
    }


def _describe(folder: Path) -> dict[str, Any]:
    from tilewright.files import load
    from tilewright.signals.textures import TextureTiles

    held = load(folder)
    tiles = held.tiles
    common = {
        "folder": str(folder),
        "tiles": len(tiles),
        "shape": tiles.shape.name,
        "set": tiles.family,
        "colors": max(tiles.colors),
        "pictures" if isinstance(held, TextureTiles) else "variants": len(held.variants),
    }
    return common | (_of_texture(held) if isinstance(held, TextureTiles) else _of_points(held))


def _of_texture(held: "TextureTiles") -> dict[str, Any]:
    names = ("method", "seed", "treatment", "rejected", "picked")
    asked: dict[str, Any] = {name: held.recipe[name] for name in names if name in held.recipe}
    return {
        "tile_size": held.tile_size,
        "maps": {name: f"{held.kinds[name]}, {pixels.dtype}" for name, pixels in held.maps.items()},
        "photographs": [list(next(iter(source.values())).shape[1::-1]) for source in held.sources],
        "tone": held.tone is not None,
        **asked,
    }


def _of_points(held: "PointTiles") -> dict[str, Any]:
    return {
        "density": held.density,
        "distance": held.distance,
        "method": held.method,
        **{name: value for name, value in held.recipe.items() if name in ("seed", "rho", "points")},
    }


def _in_words(value: Any) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{name} ({said})" for name, said in value.items()) or "none"
    if isinstance(value, list):
        return ", ".join(" x ".join(map(str, v)) if isinstance(v, list) else str(v) for v in value) or "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:g}" if isinstance(value, float) else str(value)
