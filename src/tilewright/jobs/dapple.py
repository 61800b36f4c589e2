"""The job of the command ``dapple``: dappled tilings, their number, or their clauses."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.checks import check_int, check_real
from tilewright.errors import Progress, TilewrightFileError, TilewrightValueError
from tilewright.jobs.job import Done, Rule, WritingJob, useless
from tilewright.jobs.outputs import DRAWINGS, check_output, save_by_suffix
from tilewright.kernels.compiling import Clock

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tilewright.tilings.dappled import Conditions

    Cells = NDArray[Any]

_SUFFIXES = (".png", *DRAWINGS, ".npy", ".cnf")
_MOST_CELLS = 2**24
_INK, _PAPER = (29, 29, 38), (250, 245, 232)
_START = ("input", "dither", "share")
_LOOK = ("cell", "colors", "motif")


@dataclass(frozen=True, kw_only=True)
class DappleJob(WritingJob):
    """Make a dappled tiling and draw it; or count them, or write their clauses.

    Attributes
    ----------
    output : Path, optional
        ``.png``, ``.svg``, ``.pdf``, ``.dxf`` (outlines), ``.npy`` (tiles) or ``.cnf`` (clauses); default
        ``dapple.png``.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    width, height : int, optional
        Size in cells; default 64 x 40, or the proportions of ``input``.
    limit : dict of str to number, optional
        Longest runs, as `Conditions` takes them; default ``{"H0": 2, "V1": 2}``.
    tiles : int, optional
        Number of tiles; default as many as are named.
    share : sequence of float, optional
        How much of each tile the random start holds; default equally much.
    input : Path, optional
        A picture to follow: tile 0 where it is dark.
    dither : bool, optional
        Whether its grays are mixtures, as far as limits allow; default False.
    cyclic : bool, optional
        Whether rows and columns are rings; default False.
    closest : bool, optional
        Change as few cells as can be, with a proof; default False.
    endless : bool, optional
        Make a window of an endless tiling; default False.
    x, y : int, optional
        The first cell of that window; default (0, 0).
    pins : Path, optional
        A ``.npy`` or ``.csv`` file of tiles to keep, -1 where any may be.
    count : bool, optional
        Only count the tilings; default False.
    seconds : float, optional
        When the searches of ``closest`` and ``pins`` stop; default never.
    cell : int, optional
        Pixels along a cell; default by the size.
    colors : sequence of str, optional
        Colors of the tiles, as ``#rrggbb``; of lines and ground for other motifs than ``"fill"``.
    motif : str, optional
        What each tile shows: ``"fill"`` (default), ``"strokes"`` or ``"arcs"``.
    seed : int, optional
        Where chance begins; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    width: int | None = None
    height: int | None = None
    limit: Mapping[str, float] | None = None
    tiles: int | None = None
    share: Sequence[float] | None = None
    input: Path | None = None
    dither: bool = False
    cyclic: bool = False
    closest: bool = False
    endless: bool = False
    x: int | None = None
    y: int | None = None
    pins: Path | None = None
    count: bool = False
    seconds: float | None = None
    cell: int | None = None
    colors: Sequence[str] | None = None
    motif: str | None = None
    seed: int = 0

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        *useless(
            lambda job: job.count, "{count}",
            *_START, *_LOOK, "output", "x", "y", "seconds", "closest", "endless", "pins",
        ),
        *useless(
            lambda job: job.endless, "{endless}",
            "input", "dither", "cyclic", "tiles", "seconds", "closest", "pins",
        ),
        *useless(lambda job: job.pins, "{pins}", *_START, "width", "height", "x", "y", "closest"),
        *useless(lambda job: job.closest, "{closest}", "x", "y"),
        *useless(lambda job: job.suffix == ".cnf", "a .cnf file",
                 *_START, *_LOOK, "closest", "endless", "seconds"),
        *useless(lambda job: job.suffix == ".npy", "a .npy file, which holds tiles", *_LOOK),
        Rule(lambda job: job.given("x") and not job.endless, "{x} is about {endless}"),
        Rule(lambda job: job.given("y") and not job.endless, "{y} is about {endless}"),
        Rule(
            lambda job: job.given("seconds") and not (job.closest or job.pins),
            "{seconds} is about {closest} and {pins}",
        ),
        Rule(
            lambda job: job.dither and job.input is None,
            "{dither} is about a picture to follow; give {input}",
        ),
        Rule(
            lambda job: job.input and job.share,
            "{input} and {share} make different starts; give one of them",
        ),
    )  # fmt: skip

    @property
    def usual(self) -> str | None:
        """A picture; nothing where tilings are only counted."""
        return None if self.count else "dapple.png"

    @property
    def suffix(self) -> str:
        """What the file is to hold."""
        return "" if self.count else self.target.suffix.lower()

    def _run(self, progress: Progress | None) -> Done:
        """Make, write and measure."""
        clock = Clock()
        conditions = self._conditions()
        if self.count:
            return self._count(conditions, progress)
        check_output(self.target, _SUFFIXES)
        if self.suffix == ".cnf":
            figures, text = self._write_clauses(conditions)
        else:
            cells, figures = self._make(conditions, progress)
            self._draw(cells, conditions)
            text = _sentence(self.target, figures)
        spent = clock.seconds
        figures = {"file": str(self.target), **figures, "seconds": round(spent, 3)}
        return Done((self.target,), figures, f"{text}; {spent:.1f} s")

    def _conditions(self) -> "Conditions":
        """Limits on as many tiles as are named anywhere."""
        from tilewright.tilings.dappled import Conditions

        shares = len(self.share) if self.share else None
        if self.tiles is not None and shares not in (None, self.tiles):
            raise TilewrightValueError(
                f"was given {shares} times; there are {self.tiles} tiles", argument="share", value=self.share
            )
        return Conditions(self.limit or {"H0": 2, "V1": 2}, shares if self.tiles is None else self.tiles)

    def _make(self, conditions: "Conditions", progress: Progress | None) -> "tuple[Cells, dict[str, Any]]":
        """The tiling, and what is said of it."""
        if self.endless:
            return self._make_endless(conditions)
        if self.pins is not None:
            return self._complete(self.pins, conditions, progress)
        return self._dapple(self._start(conditions), conditions, progress)

    def _count(self, conditions: "Conditions", progress: Progress | None) -> Done:
        from tilewright.tilings.dappled import count_dappled

        width, height = _or(self.width, 64), _or(self.height, 40)
        number = count_dappled(width, height, conditions, cyclic=self.cyclic, progress=progress)
        return Done((), {"width": width, "height": height, "count": number}, str(number))

    def _shares(self, conditions: "Conditions") -> list[float]:
        return list(self.share or [1.0] * conditions.tiles)

    def _start(self, conditions: "Conditions") -> "Cells":
        """The tiling to follow: a picture, in its own proportions where these are not given, or chance."""
        from tilewright.files import read_image
        from tilewright.tilings.dappled import random_start, start_from_image

        if self.input is None:
            extent = _checked(_or(self.width, 64), _or(self.height, 40))
            return random_start(*extent, self._shares(conditions), self.seed)
        pixels = read_image(self.input)
        high, wide = pixels.shape[:2]
        width, height = self.width, self.height
        if width is None:
            width = 64 if height is None else max(1, round(height * wide / high))
        if height is None:
            height = max(1, round(width * high / wide))
        return start_from_image(
            pixels, *_checked(width, height), conditions.tiles,
            dither=self.dither, limits=conditions if self.dither else None,
        )  # fmt: skip

    def _dapple(
        self, start: "Cells", conditions: "Conditions", progress: Progress | None
    ) -> "tuple[Cells, dict[str, Any]]":
        """The start made dappled, with few changes or with the fewest."""
        from tilewright.tilings.dappled import closest_dapple, dapple, find_violations

        violated = find_violations(start, conditions, cyclic=self.cyclic)
        figures: dict[str, Any] = {"violations": sum(int(bad.sum()) for bad in violated.values())}
        if self.closest:
            best = closest_dapple(
                start, conditions, cyclic=self.cyclic, seconds=self.seconds, progress=progress
            )
            cells = best.tiling
            figures |= {"distance": best.distance, "bound": best.bound, "gap": best.gap}
        else:
            cells = dapple(start, conditions, cyclic=self.cyclic, seed=self.seed)
        figures["changed"] = int((cells != start).sum())
        return cells, _measure(cells, conditions) | figures

    def _make_endless(self, conditions: "Conditions") -> "tuple[Cells, dict[str, Any]]":
        from tilewright.tilings.dappled import endless_dappled_tiling

        shares = [check_real("share", given, 0, 1e9) for given in self._shares(conditions)]
        if len(shares) != 2 or sum(shares) <= 0:
            raise TilewrightValueError(
                f"is {shares}; an endless tiling has two, from 0 on, not both 0",
                argument="share",
                value=shares,
            )
        tiling = endless_dappled_tiling(conditions, start=shares[1] / sum(shares), seed=self.seed)
        x, y = _or(self.x, 0), _or(self.y, 0)
        cells = tiling.cells(x, y, *_checked(_or(self.width, 64), _or(self.height, 40)))
        return cells, {"x": x, "y": y, **_measure(cells, conditions)}

    def _complete(
        self, pins: Path, conditions: "Conditions", progress: Progress | None
    ) -> "tuple[Cells, dict[str, Any]]":
        from tilewright.tilings.dappled import complete_dapple

        partial = _read_pins(pins)
        cells = complete_dapple(
            partial, conditions,
            cyclic=self.cyclic, seed=self.seed, seconds=self.seconds, progress=progress,
        )  # fmt: skip
        return cells, _measure(cells, conditions) | {"pinned": int((partial >= 0).sum())}

    def _write_clauses(self, conditions: "Conditions") -> tuple[dict[str, Any], str]:
        """Write the conditions, and pins, for a SAT solver."""
        import numpy as np

        from tilewright.files.atomic import whole_file
        from tilewright.files.texts import write_text
        from tilewright.tilings.dappled import dapple_formula

        partial = None if self.pins is None else _read_pins(self.pins)
        if partial is None:
            width, height = _checked(_or(self.width, 64), _or(self.height, 40))
        else:
            height, width = partial.shape
        clauses = dapple_formula((height, width), conditions, cyclic=self.cyclic, partial=partial)
        limits = ", ".join(f"{limit}={np.asarray(limit.most).item()}" for limit in conditions.limits)
        ring = "cyclic " if self.cyclic else ""
        with whole_file(self.target) as unfinished:
            said = f"{ring}dappled tilings of {width} x {height} cells: {limits}"
            write_text(unfinished, clauses.dimacs((said,)))
        figures = {"width": width, "height": height, "variables": clauses.count, "clauses": len(clauses)}
        return figures, f"{self.target}: {clauses.count} variables, {len(clauses)} clauses"

    def _draw(self, cells: "Cells", conditions: "Conditions") -> None:
        from tilewright.export.drawing import draw_cells, paint_cells

        colors = self.colors
        if colors is None and self.input is not None and self.motif in (None, "fill"):
            colors = _ramp(conditions.tiles)
        look: dict[str, Any] = {"colors": colors, "motif": self.motif or "fill", "size": self.cell}
        save_by_suffix(
            self.target,
            {
                ".svg": lambda: draw_cells(cells, **look),
                ".png": lambda: paint_cells(cells, **look),
                ".npy": lambda: cells,
            },
        )


def _or(given: int | None, default: int) -> int:
    return default if given is None else given


def _checked(width: int, height: int) -> tuple[int, int]:
    for name, cells in (("width", width), ("height", height)):
        check_int(name, cells, 1, 65536)
    check_int("width times height", width * height, 1, _MOST_CELLS)
    return width, height


def _read_pins(path: Path) -> "Cells":
    """A partial tiling from a .npy or .csv file."""
    from tilewright.files.tables import read_table

    what = f"tiles, -1 where any may be, shape (height, width), up to {_MOST_CELLS:,} cells"
    pins = read_table(path, what)
    if pins.ndim != 2 or not 0 < pins.size <= _MOST_CELLS or pins.dtype.kind not in "iu":
        raise TilewrightFileError(f"{path} does not hold {what}", value=path)
    return pins


def _measure(cells: "Cells", conditions: "Conditions") -> dict[str, Any]:
    import numpy as np

    shares = np.bincount(cells.ravel(), minlength=conditions.tiles) / cells.size
    height, width = cells.shape
    return {"width": width, "height": height, "tiles": len(shares), "shares": np.round(shares, 4).tolist()}


def _ramp(tiles: int) -> list[str]:
    """Colors from dark to light, as the tiles of a picture are."""
    steps = (n / (tiles - 1) for n in range(tiles))
    return [
        "#" + "".join(f"{round(a + (b - a) * step):02x}" for a, b in zip(_INK, _PAPER, strict=True))
        for step in steps
    ]


def _sentence(file: Path, figures: dict[str, Any]) -> str:
    f = figures
    shares = ", ".join(f"{share:.1%} of tile {tile}" for tile, share in enumerate(f["shares"]))
    text = f"{file}: {f['width']} x {f['height']} cells, {shares}"
    if "pinned" in f:
        text += f", {f['pinned']} pinned"
    if "changed" in f:
        text += f", {f['violations']} runs were too long, {f['changed']} cells changed"
    if "gap" in f:
        text += "; no fewer would do" if f["gap"] == 0 else f"; at least {f['bound']} must"
    return text
