"""The job of the command ``pack``: every tile of a complete set once, on a torus."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.checks import check_choice
from tilewright.errors import Progress
from tilewright.jobs.job import Done, Rule, WritingJob, useless
from tilewright.jobs.outputs import DRAWINGS, check_suffix, save_by_suffix
from tilewright.seeds import check_seed

if TYPE_CHECKING:
    from tilewright.tiles import TileSet
    from tilewright.tilings import Tiling


def _of_a_puzzle(name: str) -> "Rule[PackJob]":
    """A rule for an option that is about the pieces of a puzzle."""
    return Rule(
        lambda job: job.given(name) and (job.file is None or job.file.suffix.lower() not in DRAWINGS),
        f"{{{name}}} is about the pieces of a puzzle; give it with a FILE.svg, .pdf or .dxf",
    )


@dataclass(frozen=True, kw_only=True)
class PackJob(WritingJob):
    """Write a tile packing as indices, as a picture or as a jigsaw puzzle; or count all packings.

    Attributes
    ----------
    output : Path, optional
        ``.svg``, ``.pdf``, ``.dxf``: a puzzle for a laser cutter; ``.png``; or ``.npy``: tile indices, shape
        (C^2, C^2). Default a PNG named after the set.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    tiles : str, optional
        ``"corner"`` (default) or ``"wang"``.
    colors : int, optional
        Number of colors C, 1 to 16; default 2.
    method : str, optional
        ``"closed"`` (default), ``"search"`` (up to 3 colors; ``seed`` matters) or ``"recursive"``.
    count : bool, optional
        Count all packings, which is possible over 2 colors; default False.
    piece_mm : float, optional
        Size of a piece of a puzzle in mm; default 30.
    picture : Path, optional
        A PNG or JPEG to print on the pieces.
    engrave : str, optional
        What is cut into the pieces: ``"none"`` (default), ``"colors"`` or ``"numbers"``.
    kerf : float, optional
        Width of the beam in mm; pieces are then cut apart, each in its nominal size. Default: one cut between
        two pieces.
    sheet : tuple of (int, int), optional
        Width and height in mm of the sheets on which pieces are laid apart: the pages of a ``.pdf``, or files
        with numbers where there are several; default one sheet, as large as it needs to be.
    seed : int, optional
        Which packing the search finds; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    tiles: str = "corner"
    colors: int = 2
    method: str = "closed"
    count: bool = False
    piece_mm: float = 30
    picture: Path | None = None
    engrave: str = "none"
    kerf: float | None = None
    sheet: tuple[int, int] | None = None
    seed: int = 0

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        *(_of_a_puzzle(name) for name in ("picture", "engrave", "kerf", "sheet")),
        *useless(
            lambda job: job.file is not None and job.file.suffix.lower() == ".dxf",
            "a .dxf file, which holds lines",
            "picture",
        ),
        Rule(
            lambda job: job.is_apart and job.file.suffix.lower() == ".dxf" and job.engrave == "colors",
            "{engrave} colors are cut to their pieces, which a .dxf cannot; take numbers, or name a FILE.pdf",
        ),
    )

    @property
    def usual(self) -> str | None:
        """Named after the set; nothing where packings are only counted."""
        return None if self.count else f"{self.tiles}-{self.colors}-packing.png"

    @property
    def file(self) -> Path | None:
        """Where the packing goes; nowhere where only a count is asked for."""
        return self.output if self.count else self.target

    @property
    def is_apart(self) -> bool:
        """Whether the pieces of a puzzle are laid apart."""
        return self.kerf is not None or self.sheet is not None

    def _run(self, progress: Progress | None) -> Done:
        """Count, pack and draw."""
        from tilewright.tiles import corner_tiles, wang_tiles

        makers = {"corner": corner_tiles, "wang": wang_tiles}
        make = makers[check_choice("tiles", self.tiles, tuple(makers))]
        check_choice("method", self.method, ("closed", "search", "recursive"))
        if self.file is not None:
            check_suffix(self.file, (".npy", *DRAWINGS, ".png"))
        check_seed(self.seed)
        tiles = make(self.colors)
        figures: dict[str, Any] = {"tiles": len(tiles)}
        words = []
        files: tuple[Path, ...] = ()
        if self.count:
            from tilewright.tilings import count_packings

            figures["packings"] = count_packings(tiles, progress)
            words.append(f"{figures['packings']} packings of {len(tiles)} tiles, translations counted")
        if self.file is not None:
            packed = self._pack(tiles, progress)
            width, height = (p or 0 for p in packed.domain.periods)
            files = self._save(packed, self.file, (width, height))
            figures |= {"file": str(self.file), "size": [width, height]}
            words.append(f"{self.file}: {len(tiles)} tiles, {width} x {height}")
            if self.is_apart:
                figures["files"] = [str(file) for file in files]
                words[-1] = f"{', '.join(figures['files'])}: {len(tiles)} pieces, {width} x {height}"
        return Done(files, figures, "\n".join(words))

    def _pack(self, tiles: "TileSet", progress: Progress | None) -> "Tiling":
        from tilewright.tilings import packing, random_packing, recursive_packing

        if self.method == "search":
            return random_packing(tiles, seed=self.seed, progress=progress)
        return packing(tiles) if self.method == "closed" else recursive_packing(tiles)

    def _save(self, packed: "Tiling", file: Path, size: tuple[int, int]) -> tuple[Path, ...]:
        """Write the packing; the files that it went to."""
        from tilewright.export.drawing import draw_jigsaw, paint_tiling

        look: dict[str, Any] = {"piece": self.piece_mm, "picture": self.picture, "engrave": self.engrave}
        if self.is_apart:
            return self._save_apart(packed, file, look)
        save_by_suffix(
            file,
            {
                ".svg": lambda: draw_jigsaw(packed, **look),
                ".png": lambda: paint_tiling(packed, 0, 0, *size),
                ".npy": lambda: packed.indices(0, 0, *size),
            },
        )
        return (file,)

    def _save_apart(self, packed: "Tiling", file: Path, look: dict[str, Any]) -> tuple[Path, ...]:
        """The pieces apart: pages of a PDF, or a file for each sheet, numbered where there are several."""
        from tilewright.export.drawing import draw_jigsaw_sheets, save_drawing

        sheets = draw_jigsaw_sheets(packed, kerf=self.kerf or 0, sheet=self.sheet, **look)
        if len(sheets) == 1 or file.suffix.lower() == ".pdf":
            save_drawing(file, sheets)
            return (file,)
        files = tuple(file.with_stem(f"{file.stem}-{number}") for number in range(1, len(sheets) + 1))
        for one in files:
            if not self.force:
                self._keep(one)
        for one, drawing in zip(files, sheets, strict=True):
            save_drawing(one, drawing)
        return files
