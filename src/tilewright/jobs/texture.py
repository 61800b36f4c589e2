"""The job of the command ``texture``: from photographs to a tile-set folder."""

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from tilewright.checks import check_choice
from tilewright.errors import Progress, TilewrightValueError, TilewrightWarning
from tilewright.jobs.job import Done, Rule, WritingJob, is_there, useless
from tilewright.kernels.compiling import Clock
from tilewright.sameness import same

if TYPE_CHECKING:
    from tilewright.signals.textures import Exemplar, TextureTiles
    from tilewright.tiles import TileSet

_KINDS = ("corner", "wang", "cohen-8", "cohen-12", "cohen-18", "corner-coded")
_SETTINGS = ("tiles", "colors", "tile_size", "weight", "mask", "method", "tone", "variants", "seed", "photo")
_OLD = "{from_}, which makes an old set again with its photograph and settings"
_CUT = "{like}, which cuts as the old set was cut"


def _holds_maps(photo: Path) -> bool:
    from tilewright.files.map_stack import holds_maps

    return holds_maps(photo)


@dataclass(frozen=True, kw_only=True)
class TextureJob(WritingJob):
    """Make texture tiles from a photograph and save them; or make an old set again, or add maps to one.

    Attributes
    ----------
    output : Path, optional
        The folder of the set; default that of ``like``, else one named after the photograph:
        ``moss-tiles``.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.
    photo : Path, optional
        A photograph, a folder of a material's maps, or how the files of one of several materials begin.
    tiles : str, optional
        ``"corner"``, ``"wang"``, ``"cohen-8"``, ``"cohen-12"``, ``"cohen-18"`` or ``"corner-coded"``; default
        what suits the photograph, or ``"corner"`` with an older method.
    colors : int, optional
        Colors of a complete set; default 2, or 4 with ``second``.
    tile_size : int or str, optional
        Pixels along a tile, even, or ``"auto"``; default what suits the photograph, or 128 with an older
        method.
    map : dict of str to path, optional
        Files of maps by name.
    weight : dict of str to float, optional
        What a map counts in the cut; default 1 for color, 0.1 for others.
    kind : dict of str to str, optional
        What maps hold, as in `open_exemplar`; default as their names tell.
    normal : str, optional
        ``"gl"`` or ``"dx"``: green of normal maps points up or down; default found.
    flatten : bool, optional
        Take out light that varies slowly; default False.
    mask : Path, optional
        A picture: white may be copied.
    second : Path, optional
        A second photograph, for marked corners.
    method : str, optional
        How tiles are made, see `synthesize`.
    tone : bool, optional
        Whether tone is laid outside the tiles, see `synthesize`; default where it belongs to no things.
    variants : int, optional
        Pictures of every tile, of which any may lie anywhere; default 1.
    from_ : Path, optional
        A set to make again, with ``reject`` and ``pick``.
    like : Path, optional
        A set that gets the maps of ``map``, cut as it was cut.
    reject : sequence of str, optional
        Names of patches that must come from elsewhere.
    reseed_rest : bool, optional
        Whether a set made again is searched for anew as a whole; default False: all other patches stay.
    pick : dict of str to (int, int, int), optional
        Places (source, y, x) of patches by name.
    threads : int, optional
        Threads; default all processors.
    seed : int, optional
        The same seed gives the same bytes; default 0.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    photo: Path | None = None
    tiles: str | None = None
    colors: int | None = None
    tile_size: int | str | None = None
    map: Mapping[str, str] | None = None
    weight: Mapping[str, float] | None = None
    kind: Mapping[str, str] | None = None
    normal: str | None = None
    flatten: bool = False
    mask: Path | None = None
    second: Path | None = None
    method: str | None = None
    tone: bool | None = None
    variants: int = 1
    from_: Path | None = None
    like: Path | None = None
    reject: Sequence[str] | None = None
    reseed_rest: bool = False
    pick: Mapping[str, tuple[int, int, int]] | None = None
    threads: int | None = None
    seed: int = 0

    RULES: ClassVar[tuple[Rule[Any], ...]] = (
        *useless(
            lambda job: job.from_, _OLD, *_SETTINGS, "map", "kind", "normal", "flatten", "second", "like"
        ),
        *useless(lambda job: job.like, _CUT, *_SETTINGS, "pick", "reject", "threads"),
        Rule(lambda job: job.like and not job.map, "{like} cuts further maps; give them with {map}"),
        Rule(
            lambda job: job.like and job.second and len(job.map) > 1,
            "{second} is the second photograph of one map; give one {map} at a time",
        ),
        Rule(
            lambda job: job.reject and not job.from_,
            "{reject} names patches of a set that exists; give it with {from_}",
        ),
        Rule(
            lambda job: job.reseed_rest and not job.from_,
            "{reseed_rest} is about a set that exists; give it with {from_}",
        ),
        Rule(
            lambda job: not (job.photo or job.map or job.from_ or job.like),
            "{photo} is missing; give a photograph, a folder of maps, or maps by name with {map}",
        ),
        Rule(
            lambda job: job.photo and "albedo" in (job.map or ()) and not _holds_maps(job.photo),
            "albedo is given twice, as {photo} and by {map}; leave one out",
        ),
    )

    @property
    def usual(self) -> str | None:
        """Named after the photograph, its folder, or the set that is made again; the set that gets maps."""
        if self.like is not None:
            return None
        if self.from_ is not None:
            return self.from_.resolve().name
        first = self.photo or Path(next(iter((self.map or {}).values())))
        return f"{first.resolve().name if first.is_dir() else first.stem}-tiles"

    def _keep(self, output: Path) -> None:
        """Refuse to replace another set; one that comes out the same may be there."""
        from tilewright.files.tileset_folder import check_savable

        check_savable(output, "texture")
        if output.is_dir() and any(output.iterdir()) and self._is_other(output):
            raise is_there(output)

    def _is_other(self, output: Path) -> bool:
        """Whether this job surely makes another set than lies there; cheap beside making it."""
        from tilewright.files import load_texture

        if self.from_ is not None or self.like is not None:
            return True
        old = load_texture(output)
        asked = {"seed": self.seed, "method": self.method, "variants": self.variants}
        made = {"variants": 1, **old.recipe}
        if any(value is not None and value != made.get(name) for name, value in asked.items()):
            return True
        if isinstance(self.tile_size, int) and self.tile_size != old.tile_size:
            return True
        tiles = self._tile_set()
        return (tiles is not None and tiles != old.tiles) or not same(self._exemplar().sources, old.sources)

    def _costs(self) -> dict[str, Any]:
        """Tiles, their size, and the time they take, as the photograph decides."""
        from tilewright.signals.textures.synthesis import foresee

        if self.from_ is not None or self.like is not None:
            return super()._costs()
        return super()._costs() | foresee(
            self._exemplar(), self._tile_set(),
            tile_size=self.tile_size, method=self.method, tone=self.tone, variants=self.variants,
        )  # fmt: skip

    def _run(self, progress: Progress | None) -> Done:
        """Synthesize and save."""
        from tilewright.files import load_texture, save
        from tilewright.files.tileset_folder import check_savable

        clock = Clock()
        folder = self.output or self.like or self.target
        check_savable(folder, "texture")
        material = self._make(progress)
        kept = self.output is not None and not self.force and folder.is_dir() and any(folder.iterdir())
        if not kept:
            save(material, folder)
        elif load_texture(folder) != material:
            raise is_there(folder)
        seconds = clock.seconds
        figures = {
            "folder": str(folder),
            "tiles": len(material.tiles),
            "tile_size": material.tile_size,
            "maps": list(material.maps),
            "kinds": material.kinds,
            "method": material.recipe["method"],
            "seed": material.recipe["seed"],
            "seconds": round(seconds, 3),
        }
        if treatment := material.recipe.get("treatment"):
            figures |= {"treatment": treatment, "tone": material.tone is not None}
        size, several = material.tile_size, ""
        if len(material.variants) > len(material.tiles):
            figures["pictures"] = len(material.variants)
            several = f", {len(material.variants)} pictures"
        sentence = (
            f"{folder}: {len(material.tiles)} {material.tiles.shape.name} tiles{several} of {size} x {size} "
            f"pixels in {seconds:.1f} s"
        )
        return Done((folder,), figures, sentence)

    def _make(self, progress: Progress | None) -> "TextureTiles":
        from tilewright.files import load_texture
        from tilewright.jobs.materials import texture_tiles
        from tilewright.signals.textures import resynthesize

        if self.from_ is not None:
            return resynthesize(
                load_texture(self.from_),
                reject=self.reject or [], pick=self.pick, reseed_rest=self.reseed_rest,
                threads=self.threads, progress=progress,
            )  # fmt: skip
        if self.like is not None:
            return self._add(load_texture(self.like))
        return texture_tiles(
            self._pictures(),
            self._tile_set(),
            second=self.second,
            mask=self.mask,
            weights=dict(self.weight or {}),
            tile_size=self.tile_size,
            seed=self.seed,
            method=self.method,
            tone=self.tone,
            variants=self.variants,
            pick=self.pick,
            threads=self.threads,
            progress=progress,
            **self._meaning(),
        )

    def _exemplar(self) -> "Exemplar":
        """The pictures that the set is made of."""
        from tilewright.jobs.materials import open_exemplar

        with warnings.catch_warnings():  # notes come when they are opened for the work
            warnings.simplefilter("ignore", TilewrightWarning)
            return open_exemplar(
                self._pictures(), second=self.second, mask=self.mask, weights=dict(self.weight or {}),
                **self._meaning(),
            )  # fmt: skip

    def _meaning(self) -> dict[str, Any]:
        return {"kinds": dict(self.kind or {}), "normal": self.normal, "flatten": self.flatten}

    def _add(self, material: "TextureTiles") -> "TextureTiles":
        """The material with further maps."""
        from tilewright.jobs.materials import add_maps

        added = dict(self.map or {})
        second = None if self.second is None else dict.fromkeys(added, str(self.second))
        return add_maps(material, added, second=second, **self._meaning())

    def _pictures(self) -> Any:
        """The photograph, its maps by name, or both."""
        from tilewright.files.map_stack import check_color
        from tilewright.jobs.sources import list_maps

        maps = dict(self.map or {})
        if self.photo is None or not maps:
            return maps or self.photo
        found = {name: str(file) for name, file in list_maps(self.photo, "photo", whole=False).items()} | maps
        check_color(self.photo, found)
        return found

    def _tile_set(self) -> "TileSet | None":
        """What was asked for; None where the photograph decides."""
        from tilewright.tiles import cohen_tiles, corner_coded_tiles, corner_tiles, wang_tiles

        if self.method in (None, "faithful") and self.tiles is self.colors is None:
            return None
        kind = check_choice("tiles", "corner" if self.tiles is None else self.tiles, _KINDS)
        colors = self.colors
        if colors is not None and kind not in ("corner", "wang"):
            raise TilewrightValueError(
                f"is for corner and wang tiles; {kind} has its own", argument="colors", value=colors
            )
        if kind == "wang":
            return wang_tiles(2 if colors is None else colors)
        if kind == "corner":
            return corner_tiles((2 if self.second is None else 4) if colors is None else colors)
        if kind == "corner-coded":
            return corner_coded_tiles()
        return cohen_tiles(int(kind.removeprefix("cohen-")))
