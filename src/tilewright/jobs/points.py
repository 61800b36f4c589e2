"""The job of the command ``points``: blue-noise points, of tiles or of a method without."""

import warnings
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.checks import check_choice
from tilewright.errors import Progress, TilewrightWarning
from tilewright.extras import need_package
from tilewright.files.ready import READY
from tilewright.jobs.job import Clash, Done, Rule, WritingJob
from tilewright.kernels.compiling import Clock

if TYPE_CHECKING:
    from tilewright.files.point_files import Blocks
    from tilewright.samplers import PointSet
    from tilewright.signals.points import PointTiles


@dataclass(frozen=True, kw_only=True)
class PointsJob(WritingJob):
    """Write points of a tiling, without end, or of a sampler.

    Attributes
    ----------
    output : Path, optional
        ``.npy``, ``.npz``, ``.csv``, ``.txt``, ``.ply`` or ``.parquet``.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    method : str, optional
        A kind of point tiles, default ``"corner"``, or a sampler.
    tiles : Path, optional
        A tile-set folder of points, instead of ``method``.
    save : Path, optional
        A folder in which the point tiles are kept.
    colors : int, optional
        Colors of corner tiles, 2 to 8; default 4.
    points : int, optional
        Points in each tile; default 32.
    rho : float, optional
        Relative radius; default 0.75.
    count : int, optional
        Exactly this number of points.
    width, height : float, optional
        Size of the window in tiles; of a sampler, of the box.
    x, y : float, optional
        West and north side of the window in tiles; default (0, 0).
    torus : bool, optional
        Whether opposite sides of the window meet; default False.
    lattice_seed : int, optional
        Seed of the tiling; default 0.
    seed : int, optional
        Seed of the tiles, or of the sampler; default 0.
    note : bool, optional
        Whether ``.csv`` and ``.txt`` begin with a line that says box, seeds and what is promised; other
        formats with room always do. Default False.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    method: str = "corner"
    tiles: Path | None = None
    save: Path | None = None
    colors: int = 4
    points: int | None = None
    rho: float | None = None
    count: int | None = None
    width: float | None = None
    height: float | None = None
    x: float = 0
    y: float = 0
    torus: bool = False
    lattice_seed: int = 0
    seed: int = 0
    note: bool = False

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        Rule(lambda job: (job.width is None) != (job.height is None), "{width} and {height} go together"),
        Rule(
            lambda job: (
                job.note and (job.output is None or job.output.suffix.lower() not in (".csv", ".txt"))
            ),
            "{note} is about .csv and .txt; other files say it anyway, and .npy has no room for it",
        ),
    )

    @property
    def usual(self) -> str | None:
        """Named after what it is made from."""
        return f"{self.method if self.tiles is None else self.tiles.resolve().name}-points.npy"

    @property
    def size(self) -> tuple[float, float] | None:
        """The window's, where it was given."""
        return None if self.width is None or self.height is None else (self.width, self.height)

    def _costs(self) -> dict[str, Any]:
        known = {} if self.count is None else {"count": self.count}
        return super()._costs() | known | {"builds_tiles": self._builds}

    @property
    def _builds(self) -> bool:
        """Whether point tiles have to be built, which takes seconds to minutes."""
        from tilewright.signals.points import TILE_METHODS

        return self.tiles is None and self.method in TILE_METHODS and not self._is_ready

    @property
    def _is_ready(self) -> bool:
        """Whether the tiles come with the program."""
        return self.method == "corner" and self.seed == 0 and self._settings in READY

    @property
    def _settings(self) -> tuple[int, int, float]:
        """Of corner tiles: colors, points of a tile, relative radius."""
        points = 32 if self.points is None else self.points
        return (self.colors, points, 0.75 if self.rho is None else self.rho)

    def _run(self, progress: Progress | None) -> Done:
        """Make the points and write them, a piece at a time where they are many."""
        from tilewright.files import write_points

        clock = Clock()
        self._check()
        points, total, about = self._sample(progress) if self._is_sampled() else self._lay(progress)
        write_points(self.target, points, total, about=about, note=self.note)
        seconds = clock.seconds
        figures = {
            "file": str(self.target), "count": total, "distance": about.distance, "seconds": round(seconds, 3)
        }  # fmt: skip
        apart = f"{about.distance:.5g}" + ("" if self._is_sampled() else " tiles")
        words = f"{self.target}: {total:,} points, none closer than {apart}, in {seconds:.2f} s"
        files = (self.target,) if self.save is None else (self.target, self.save)
        return Done(files, figures, words)

    def _check(self) -> None:
        """Refuse before the work what would be refused after it."""
        from tilewright.files.point_files import check_point_file
        from tilewright.files.tileset_folder import check_savable
        from tilewright.samplers import METHODS
        from tilewright.signals.points import TILE_METHODS

        check_point_file(self.target)
        check_choice("method", self.method, (*TILE_METHODS, *METHODS))
        if self.save is not None:
            if self.save.resolve() == self.target.resolve():
                raise Clash("{output} and {save} have the same name; one is a file, the other a folder")
            check_savable(self.save, "points")
        if self._is_sampled():
            self._check_sampled()
        elif self.torus:
            self._check_torus()
        elif self.size is None and self.count is None:
            raise Clash("give {count}, or {width} and {height}, or all three")
        elif self.size is None and (self.x % 1 or self.y % 1):
            raise Clash("{x} and {y} are whole tiles where {count} stands alone")
        if self._builds:
            need_package("finufft", "making point tiles")

    def _is_sampled(self) -> bool:
        """Whether a method without tiles is asked for."""
        from tilewright.samplers import METHODS

        return self.tiles is None and self.method in METHODS

    def _check_sampled(self) -> None:
        if self.given("save", "x", "y"):
            raise Clash(f"{{save}}, {{x}} and {{y}} are for tiles; {self.method} has none")
        if self.count is None:
            raise Clash(f"{self.method} needs {{count}}; only tiles fill a window by its size")

    def _check_torus(self) -> None:
        if self.size is None or self.size[0] % 1 or self.size[1] % 1 or self.given("count", "x", "y"):
            raise Clash("{torus} takes {width} and {height} of whole tiles, and no {count}, {x} or {y}")

    def _sample(self, progress: Progress | None) -> "tuple[PointSet, int, PointSet]":
        """The points of a method without tiles, their number, and what is known of them."""
        from tilewright.samplers import Box, sample_points

        assert self.count is not None
        box = Box(self.size or (1.0, 1.0), self.torus)
        made = sample_points(self.method, self.count, self.rho, seed=self.seed, box=box, progress=progress)
        return made, len(made), replace(made, figures={**made.figures, "seed": self.seed})

    def _lay(self, progress: Progress | None) -> "tuple[PointSet | Blocks, int, PointSet]":
        """The points of tiles over a tiling, their number, and what is known of them."""
        from tilewright.files import save

        tiles = self._tiles(progress)
        if self.save is not None:
            save(tiles, self.save)
        return self._torus(tiles) if self.torus else self._window(tiles)

    def _tiles(self, progress: Progress | None) -> "PointTiles":
        from tilewright.files import load_points, ready_tiles
        from tilewright.signals.points import make_point_tiles

        if self.tiles is not None:
            return load_points(self.tiles)
        if self._is_ready:
            return ready_tiles(*self._settings)
        if self.method == "corner" and self.seed != 0 and self._settings in READY:
            warnings.warn(
                "another seed builds a set of point tiles, which takes seconds to minutes; the lattice seed "
                "gives other points of the set that is ready",
                TilewrightWarning,
                stacklevel=2,
            )
        return make_point_tiles(
            self.method, self.points, self.rho, colors=self.colors, seed=self.seed, progress=progress
        )

    def _window(self, tiles: "PointTiles") -> "tuple[PointSet | Blocks, int, PointSet]":
        """The points of the window, their number, and what is known of them."""
        from tilewright.fields import PointField
        from tilewright.tilings import direct

        corner = (self.x, self.y)
        field = PointField(tiles, direct(tiles.tiles, self.lattice_seed))
        if self.size is not None:
            about = self._about(tiles, self.size)
            if self.count is None:
                return field.blocks(*corner, *self.size), field.count(*corner, *self.size), about
            return field.sample(self.count, *corner, *self.size), self.count, about
        assert self.count is not None
        x, y = int(self.x), int(self.y)
        side = field.side_for(self.count, x, y)
        about = self._about(tiles, (float(side), float(side)))
        return field.sample_blocks(self.count, x, y, side), self.count, about

    def _about(self, tiles: "PointTiles", size: tuple[float, float]) -> "PointSet":
        """What is known of the points of a window, without them."""
        import numpy as np

        from tilewright.samplers import Box, PointSet

        figures = {"corner": (self.x, self.y), **self._seeds(tiles)}
        box = Box(size, torus=False)
        return PointSet(np.empty((0, 2)), box, f"{tiles.method} tiles", tiles.distance, figures)

    def _seeds(self, tiles: "PointTiles") -> dict[str, Any]:
        seed = tiles.recipe.get("seed", self.seed if self.tiles is None else None)
        return {"seed": seed, "lattice_seed": self.lattice_seed}

    def _torus(self, tiles: "PointTiles") -> "tuple[PointSet, int, PointSet]":
        from tilewright.fields import PointField
        from tilewright.tilings import direct

        assert self.size is not None
        period = (int(self.size[0]), int(self.size[1]))
        made = PointField(tiles, direct(tiles.tiles, self.lattice_seed, period=period)).torus()
        return made, len(made), replace(made, figures={**made.figures, **self._seeds(tiles)})
