"""The job of the command ``aperiodic``: tilings that never repeat, and the sets that force them."""

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.errors import Progress, TilewrightWarning
from tilewright.jobs.job import Done, Rule, WritingJob
from tilewright.jobs.outputs import DRAWINGS, check_suffix, save_by_suffix
from tilewright.kernels.compiling import Clock

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tilewright.tiles import TileSet
    from tilewright.tilings import Tiling

_SUFFIXES = (*DRAWINGS, ".png", ".npy")


@dataclass(frozen=True, kw_only=True)
class AperiodicJob(WritingJob):
    """Tile the plane with an aperiodic set and draw it, or draw the set; or list the sets.

    Attributes
    ----------
    output : Path, optional
        ``.svg``, ``.pdf``, ``.dxf`` (outlines), ``.png`` or ``.npy`` (tile indices, or with ``set``
        the colors of the tiles); default an SVG named after the set.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    name : str, optional
        Name of a set, or a ``.csv`` or ``.npy`` file of your own; by default the sets are listed.
    width, height : int, optional
        Size of the window in cells; default 40 x 30.
    x, y : int, optional
        Its first cell; default (0, 0).
    set : bool, optional
        Draw the tiles themselves instead of a tiling; default False.
    to : str, optional
        Make a corner set by ``"diagonal"``, ``"horizontal"``, ``"vertical"``, ``"rotation"`` or
        ``"subdivision"``; or a Wang set by ``"wang"``.
    period : tuple of (int, int), optional
        Look for the smallest torus up to this number of cells along x and y.
    shape : str, optional
        Of a set of your own: ``"wang"`` (default), ``"corner"`` or ``"corner-coded"``.
    seed : int, optional
        Which of the tilings; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    name: str | None = None
    width: int = 40
    height: int = 30
    x: int = 0
    y: int = 0
    set: bool = False
    to: str | None = None
    period: tuple[int, int] | None = None
    shape: str = "wang"
    seed: int = 0

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        Rule(
            lambda job: job.name is None and job.given("output", "set", "to", "period"),
            "name a set to draw; without one, the sets are listed",
        ),
    )

    @property
    def usual(self) -> str | None:
        """Named after the set; nothing where sets are only listed."""
        if self.name is None:
            return None
        parts = (Path(self.name).stem, self.to, "tiles" if self.set else None)
        return f"{'-'.join(part for part in parts if part)}.svg"

    @property
    def is_own(self) -> bool:
        """Whether the set comes from a file."""
        return self.name is not None and Path(self.name).suffix.lower() in (".csv", ".npy")

    def _run(self, progress: Progress | None) -> Done:
        """List, or make the set, lay it and draw it."""
        clock = Clock()
        if self.name is None:
            return _list_sets()
        if self.output is not None:
            check_suffix(self.output, _SUFFIXES)
        tiles, figures = _own_set(Path(self.name), self.shape) if self.is_own else _named_set(self.name)
        if self.to is not None:
            figures |= {"construction": self.to, "sound": _is_sound(tiles, self.to)}
        tiles, tiling = self._lay(tiles, progress)
        figures |= {"shape": tiles.shape.name, "tiles": len(tiles), "colors": max(tiles.colors)}
        said = f"{len(tiles)} {tiles.shape.name} tiles"
        files: tuple[Path, ...] = ()
        if self.period is not None:
            figures["period"] = None if tiling is None else list(tiling.domain.periods)
        if self.period is not None and tiling is None:
            said += f" tile no torus of up to {self.period[0]} x {self.period[1]} cells; this is proven"
        else:
            files = (self.target,)
            figures |= self._draw(files[0], tiles, tiling)
            said = f"{files[0]}: {said}{_remark(figures)}"
        return Done(files, figures | {"seconds": round(clock.seconds, 3)}, said)

    def _lay(self, tiles: "TileSet", progress: Progress | None) -> "tuple[TileSet, Tiling | None]":
        """The set that is drawn, and its tiling where one is asked for."""
        from tilewright.tilings import filled_tiling, periodic_tiling
        from tilewright.tilings.aperiodic import aperiodic_tiling, translated_tiling

        if not (self.set or self.is_own or self.period is not None):
            tiling = aperiodic_tiling(tiles, self.seed)
            tiling = tiling if self.to is None else translated_tiling(tiling, self.to)
            return tiling.tiles, tiling
        tiles = _translate(tiles, self.to)
        if self.period is not None:
            return tiles, periodic_tiling(tiles, *self.period, seed=self.seed, progress=progress)
        if self.set:
            return tiles, None
        return tiles, filled_tiling(tiles, self.width, self.height, seed=self.seed, progress=progress)

    def _draw(self, file: Path, tiles: "TileSet", tiling: "Tiling | None") -> dict[str, Any]:
        from tilewright.export.drawing import draw_tiles, draw_tiling, paint_tiles, paint_tiling

        if self.set or tiling is None:
            save_by_suffix(
                file,
                {
                    ".svg": lambda: draw_tiles(tiles),
                    ".png": lambda: paint_tiles(tiles),
                    ".npy": lambda: tiles.slots,
                },
            )
            return {"file": str(file)}
        window = (self.x, self.y, self.width, self.height)
        save_by_suffix(
            file,
            {
                ".svg": lambda: draw_tiling(tiling, *window),
                ".png": lambda: paint_tiling(tiling, *window),
                ".npy": lambda: tiling.indices(*window),
            },
        )
        return {"width": self.width, "height": self.height, "file": str(file)}


def _remark(figures: dict[str, Any]) -> str:
    if "period" in figures:
        return ", period {} x {}".format(*figures["period"])
    if "status" in figures and figures.get("sound", True):
        return f"; {figures['name']} is {figures['status']}"
    return ""


def _is_sound(tiles: "TileSet", to: str) -> bool:
    """Whether a construction keeps a set aperiodic."""
    from tilewright.tiles.translations import translation_is_sound

    return to not in ("horizontal", "vertical") or translation_is_sound(tiles, to)


def _list_sets() -> Done:
    from tilewright.tiles.aperiodic import APERIODIC_SETS, aperiodic_tiles

    listed = []
    for name, known in APERIODIC_SETS.items():
        tiles = aperiodic_tiles(name)
        size = {"shape": tiles.shape.name, "tiles": len(tiles), "colors": max(tiles.colors)}
        listed.append({"name": name, **size, "status": known.status, "source": known.source})
    lines = (f"{s['name']:18}{s['tiles']}/{s['colors']} {s['shape']:8}{s['status']}" for s in listed)
    return Done((), {"sets": listed}, "\n".join(lines))


def _named_set(name: str) -> "tuple[TileSet, dict[str, Any]]":
    from tilewright.tiles.aperiodic import APERIODIC_SETS, aperiodic_tiles

    tiles = aperiodic_tiles(name)
    known = APERIODIC_SETS[name]
    return tiles, {"name": name, "status": known.status, "source": known.source}


def _own_set(path: Path, shape: str) -> "tuple[TileSet, dict[str, Any]]":
    from tilewright.files.tables import read_table
    from tilewright.tiles import tile_set

    slots = read_table(path, "a table of whole numbers, a row of colors with commas for every tile")
    return tile_set(_small_colors(slots), shape, name=path.stem), {"name": str(path)}


def _small_colors(slots: "NDArray[Any]") -> "NDArray[Any]":
    """Colors numbered from 0 in their order, where those of a file are larger than those of tile sets.

    Only which of them are equal matters, and some papers give colors long names.
    """
    import numpy as np

    from tilewright.tiles.tileset import MOST_COLORS

    if not slots.size or slots.dtype.kind not in "iu" or 0 <= slots.min() <= slots.max() < MOST_COLORS:
        return slots
    names, numbers = np.unique(slots, return_inverse=True)
    warnings.warn(
        f"colors {names[0]} to {names[-1]} are called 0 to {len(names) - 1}, in their order",
        TilewrightWarning,
        stacklevel=4,
    )
    return numbers.reshape(slots.shape)


def _translate(tiles: "TileSet", to: str | None) -> "TileSet":
    from tilewright.tiles import as_wang_tiles
    from tilewright.tiles.translations import as_corner_tiles

    if to is None:
        return tiles
    return as_wang_tiles(tiles) if to == "wang" else as_corner_tiles(tiles, to)
