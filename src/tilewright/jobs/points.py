"""The job of the command ``points``: blue-noise points, of tiles or of a method without."""

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.checks import check_choice
from tilewright.errors import Progress, TilewrightWarning
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
        ``.npy``, ``.csv``, ``.parquet`` or ``.ply``.
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

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        Rule(lambda job: (job.width is None) != (job.height is None), "{width} and {height} go together"),
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
        from tilewright.files.point_files import check_point_file
        from tilewright.files.tileset_folder import check_savable
        from tilewright.samplers import METHODS
        from tilewright.signals.points import TILE_METHODS

        clock = Clock()
        check_point_file(self.target)
        check_choice("method", self.method, (*TILE_METHODS, *METHODS))
        if self.save is not None:
            check_savable(self.save, "points")
        sampled = self.tiles is None and self.method in METHODS
        result, total, promised = self._sample(progress) if sampled else self._lay(progress)
        write_points(self.target, result, total)
        seconds = clock.seconds
        figures = {
            "file": str(self.target), "count": total, "distance": promised, "seconds": round(seconds, 3)
        }  # fmt: skip
        words = f"{self.target}: {total:,} points, none closer than {promised:.5g}, in {seconds:.2f} s"
        files = (self.target,) if self.save is None else (self.target, self.save)
        return Done(files, figures, words)

    def _sample(self, progress: Progress | None) -> "tuple[PointSet | Blocks, int, float]":
        """The points of a method without tiles."""
        from tilewright.samplers import Box, sample_points

        if self.given("save", "x", "y"):
            raise Clash(f"{{save}}, {{x}} and {{y}} are for tiles; {self.method} has none")
        if self.count is None:
            raise Clash(f"{self.method} needs {{count}}; only tiles fill a window by its size")
        box = Box(self.size or (1.0, 1.0), self.torus)
        made = sample_points(self.method, self.count, self.rho, seed=self.seed, box=box, progress=progress)
        return made, len(made), made.distance

    def _lay(self, progress: Progress | None) -> "tuple[PointSet | Blocks, int, float]":
        """The points of tiles over a tiling."""
        from tilewright.files import save

        tiles = self._tiles(progress)
        if self.save is not None:
            save(tiles, self.save)
        result, total = self._window(tiles)
        return result, total, getattr(result, "distance", tiles.distance)

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

    def _window(self, tiles: "PointTiles") -> "tuple[PointSet | Blocks, int]":
        """The points of the window, and their number."""
        from tilewright.fields import PointField
        from tilewright.tilings import direct

        corner = (self.x, self.y)
        if self.torus:
            return self._torus(tiles)
        field = PointField(tiles, direct(tiles.tiles, self.lattice_seed))
        if self.count is None:
            if self.size is None:
                raise Clash("give {count}, or {width} and {height}, or all three")
            return field.blocks(*corner, *self.size), field.count(*corner, *self.size)
        if self.size is not None:
            return field.sample(self.count, *corner, *self.size), self.count
        if self.x % 1 or self.y % 1:
            raise Clash("{x} and {y} are whole tiles where {count} stands alone")
        return field.sample_blocks(self.count, int(self.x), int(self.y)), self.count

    def _torus(self, tiles: "PointTiles") -> "tuple[PointSet, int]":
        from tilewright.fields import PointField
        from tilewright.tilings import direct

        if self.size is None or self.size[0] % 1 or self.size[1] % 1 or self.given("count", "x", "y"):
            raise Clash("{torus} takes {width} and {height} of whole tiles, and no {count}, {x} or {y}")
        period = (int(self.size[0]), int(self.size[1]))
        made = PointField(tiles, direct(tiles.tiles, self.lattice_seed, period=period)).torus()
        return made, len(made)
