"""The job of the command ``bricks``: walls of bricks, drawn, as maps or as tiles."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.checks import check_choice, check_int
from tilewright.errors import Progress, TilewrightFileError, TilewrightValueError
from tilewright.jobs.job import Clash, Done, Rule, WritingJob, useless
from tilewright.jobs.outputs import DRAWINGS, save_array
from tilewright.kernels.compiling import Clock
from tilewright.seeds import check_seed

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tilewright.fields import BrickField
    from tilewright.fields.bricks.patterns import BrickPattern
    from tilewright.tilings import Tiling
    from tilewright.tilings.bricks import BrickRegion

    Wall = Tiling | BrickRegion | BrickPattern

_MOST_CELLS = 2**24
_LOOK = ("colors", "mortar", "bevel", "map")
_CLASH = "ask for different walls; give one of them"


@dataclass(frozen=True, kw_only=True)
class BricksJob(WritingJob):
    """Lay a wall of bricks and draw it; or write its maps, or its tiles.

    Attributes
    ----------
    output : Path, optional
        ``.png``, ``.tif``: a picture of ``map``; ``.svg``, ``.pdf``, ``.dxf``: bricks, or joints with
        ``lines``; ``.npy``: tiles; without a suffix: a folder of all maps. Default ``wall.png``.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    width, height : int, optional
        Size in cells; default 12 x 20, or that of the region.
    x, y : int, optional
        First cell, of walls that go on; default (0, 0).
    pattern : str, optional
        ``"wang"`` (default), ``"running-bond"``, ``"flemish-bond"``, ``"herringbone"`` or ``"basket-weave"``,
        or another name of these that `BondBricks` takes.
    positions : int, optional
        Number of places where joints may meet an edge, 2 to 16; default 3.
    longest : tuple of (int, int), optional
        The most cells that a joint runs along x and along y; default (3, 3).
    input : Path, optional
        A picture to follow: joints run along x where it is dark.
    cyclic : bool, optional
        Whether the wall closes, so that it can be repeated; default False.
    mask : Path, optional
        A picture of a region, light inside.
    boundary : Path, optional
        A ``.npz`` file of positions asked for at the sides: ``horizontal``, ``vertical``.
    size : tuple of (int, int), optional
        Width and height of a cell in pixels; default (144, 48).
    colors : str, optional
        Colors of `BrickStyle`, a palette or a text such as ``"#aa3333,#884422"``; default ``"red"``.
    mortar : int, optional
        Pixels between bricks; default by the size.
    bevel : float, optional
        Pixels of the rounded edge of a brick; default by the size.
    map : str, optional
        What a picture shows: ``"preview"`` (default) or a map of `BrickField`.
    lines : bool, optional
        Whether a drawing shows the joints as lines; default False.
    seed : int, optional
        Seed of the wall and of how bricks look; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    width: int | None = None
    height: int | None = None
    x: int = 0
    y: int = 0
    pattern: str = "wang"
    positions: int = 3
    longest: tuple[int, int] = (3, 3)
    input: Path | None = None
    cyclic: bool = False
    mask: Path | None = None
    boundary: Path | None = None
    size: tuple[int, int] = (144, 48)
    colors: str = "red"
    mortar: int | None = None
    bevel: float | None = None
    map: str | None = None
    lines: bool = False
    seed: int = 0

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        Rule(lambda job: job.is_region and job.input, f"a region and {{input}} {_CLASH}"),
        Rule(lambda job: job.is_region and job.cyclic, f"a region and {{cyclic}} {_CLASH}"),
        Rule(lambda job: job.is_region and job.given("pattern"), f"a region and {{pattern}} {_CLASH}"),
        Rule(lambda job: job.given("pattern") and job.input, f"{{pattern}} and {{input}} {_CLASH}"),
        *useless(lambda job: job.given("pattern"), "a bond ({pattern})", "positions", "longest"),
        *useless(lambda job: job.kind == ".npy", "a .npy file, which holds tiles", *_LOOK),
        *useless(
            lambda job: job.kind in ("", *DRAWINGS), "a folder of all maps or a drawing of lines", "map"
        ),
        Rule(
            lambda job: job.lines and job.kind not in DRAWINGS,
            "{lines} is about drawings; name a FILE.svg, .pdf or .dxf",
        ),
        Rule(
            lambda job: job.is_region and job.kind == ".dxf" and not job.lines,
            "a DXF cannot cut bricks at the sides of a region; give {lines}, or name a FILE.pdf",
        ),
    )

    @property
    def usual(self) -> str | None:
        """A picture."""
        return "wall.png"

    @property
    def kind(self) -> str:
        """The suffix of the file; nothing for a folder."""
        return self.target.suffix.lower()

    @property
    def is_region(self) -> bool:
        """Whether the wall has a shape of its own."""
        return self.mask is not None or self.boundary is not None

    def _run(self, progress: Progress | None) -> Done:
        """Lay and draw."""
        from tilewright.fields import BondBricks, BrickField
        from tilewright.signals.bricks import BrickStyle

        clock = Clock()
        self._check()
        style = BrickStyle(self.colors, mortar=self.mortar, bevel=self.bevel)
        wall, (width, height) = self._lay()
        self._check_inside(wall, width * height)
        if self.kind == ".npy":
            save_array(self.target, _indices(wall, (self.x, self.y, width, height)))
        else:
            size = None if isinstance(wall, BondBricks) else self.size
            field = BrickField(wall, style, size=size, seed=self.seed)
            across, down = self.size
            self._draw(field, (self.x * across, self.y * down, width * across, height * down), progress)
        seconds = clock.seconds
        figures = {
            "file": str(self.target), "width": width, "height": height, "seconds": round(seconds, 3)
        }  # fmt: skip
        return Done((self.target,), figures, f"{self.target}: {width} x {height} cells in {seconds:.1f} s")

    def _check(self) -> None:
        """Numbers that the library would name otherwise, or not see."""
        from tilewright.fields.bricks.bonds import check_bond
        from tilewright.fields.bricks.field import MAPS
        from tilewright.tilings.domain import LARGEST_CELL

        check_bond("pattern", self.pattern, "wang")
        self._check_kind()
        if self.map is not None:
            check_choice("map", self.map, ("preview", *MAPS))
        for name, values, low, high in (
            ("size", self.size, 1, 4096),
            ("longest", self.longest, 1, 2**30),
            ("x", (self.x,), -LARGEST_CELL, LARGEST_CELL),
            ("y", (self.y,), -LARGEST_CELL, LARGEST_CELL),
            ("width", (self.width,), 1, _MOST_CELLS),
            ("height", (self.height,), 1, _MOST_CELLS),
        ):
            for value in values:
                if value is not None:
                    check_int(name, value, low, high)
        check_seed(self.seed)

    def _check_kind(self) -> None:
        """Refuse an ending that no wall is written with."""
        from tilewright.files.picture_forms import FORMATS

        known = (*FORMATS, *DRAWINGS, ".npy")
        if self.kind not in ("", *known):
            allowed = f"{', '.join(known)}, and none for a folder of all maps"
            raise TilewrightValueError(
                f"is {self.target}, which ends in {self.kind!r}; allowed are {allowed}",
                argument="output", value=self.target, allowed=allowed,
            )  # fmt: skip

    def _lay(self) -> "tuple[Wall, tuple[int, int]]":
        """The wall, and its size in cells."""
        from tilewright.fields import BondBricks
        from tilewright.tilings.bricks import endless_brick_tiling

        if self.is_region:
            region = self._region()
            height, width = region.cells.shape
            if self.width not in (None, width) or self.height not in (None, height):
                raise Clash(
                    f"{{boundary}} is of {width} x {height} cells; leave {{width}} and {{height}} out"
                )
            return region, (width, height)
        extent = self.width or 12, self.height or 20
        if self.pattern != "wang":
            return BondBricks(self.pattern, self.size, extent if self.cyclic else (None, None)), extent
        if self.input is not None or self.cyclic:
            return self._dappled(extent), extent
        return endless_brick_tiling(self.positions, self.seed, longest=self.longest), extent

    def _region(self) -> "BrickRegion":
        """A wall in a region of light pixels, or in the rectangle of a boundary."""
        import numpy as np

        from tilewright.files import read_image
        from tilewright.tilings.bricks import brick_region
        from tilewright.tilings.dappled import start_from_image

        asked = {} if self.boundary is None else _read_boundary(self.boundary)
        if self.mask is None:
            inside = np.ones((len(asked["vertical"]), asked["horizontal"].shape[-1]), np.uint8)
        else:
            picture = read_image(self.mask, color=False)
            inside = start_from_image(
                picture, self.width or picture.shape[1], self.height or picture.shape[0]
            )
        return brick_region(inside, self.positions, **asked, seed=self.seed, longest=self.longest)

    def _dappled(self, extent: tuple[int, int]) -> "Tiling":
        """A wall whose lines follow a picture, or chance."""
        from tilewright.files import read_image
        from tilewright.tilings.bricks import brick_tiling
        from tilewright.tilings.dappled import dapple, random_start, start_from_image

        if self.input is None:
            start = random_start(*extent, seed=self.seed)
        else:
            start = start_from_image(read_image(self.input), *extent)
        along, down = self.longest
        if self.cyclic:  # a ring of one V tile among H tiles does not close
            along, down = max(1, min(along, extent[0] - 2)), max(1, min(down, extent[1] - 2))
        classes = dapple(start, {"H0": along, "V1": down}, cyclic=self.cyclic, seed=self.seed)
        return brick_tiling(classes, self.positions, self.seed, torus=self.cyclic)

    def _check_inside(self, wall: "Wall", cells: int) -> None:
        """Refuse a window that leaves a wall which ends, and one that no picture holds."""
        from tilewright.tilings.bricks import BrickRegion

        ends = isinstance(wall, BrickRegion) or wall.domain.kind == "rectangle"
        if ends and self.given("x", "y"):
            raise Clash("{x} and {y} are about walls that go on; this one ends at its sides")
        check_int("width times height", cells, 1, _MOST_CELLS)

    def _draw(
        self, field: "BrickField", window: tuple[int, int, int, int], progress: Progress | None
    ) -> None:
        from tilewright.export.drawing import draw_wall, save_drawing

        if self.kind in DRAWINGS:
            save_drawing(self.target, draw_wall(field, *window, mode="lines" if self.lines else "bricks"))
        else:
            field.save(self.target, *window, map=self.map or "preview", progress=progress)


def _read_boundary(path: Path) -> "dict[str, NDArray[Any]]":
    """The arrays ``horizontal`` and ``vertical`` of an .npz file."""
    from tilewright.files.tables import read_arrays

    what = "two arrays, horizontal (h + 1, w) and vertical (h, w + 1), as a .npz file does"
    found = read_arrays(path, ("horizontal", "vertical"), what)
    if any(array.ndim != 2 for array in found.values()):
        raise TilewrightFileError(f"{path} does not hold {what}", value=path)
    return found


def _indices(wall: "Wall", window: tuple[int, int, int, int]) -> "NDArray[Any]":
    """Tile indices, shape (height, width); -1 outside a region."""
    from tilewright.tilings import Tiling
    from tilewright.tilings.bricks import BrickRegion

    if isinstance(wall, BrickRegion):
        return wall.cells
    if isinstance(wall, Tiling):
        return wall.indices(*window)
    raise Clash(".npy holds tiles, and bonds have none; take {pattern} wang")
