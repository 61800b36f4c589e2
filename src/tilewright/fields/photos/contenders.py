"""One photograph by five methods: repeated, blended in two ways, on Wang tiles and on corner tiles."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_progress, check_type
from tilewright.errors import Progress, TilewrightValueError
from tilewright.fields.photos.methods import HexField, NoiseField, PhotoField, RepeatField
from tilewright.fields.plane import PixelField
from tilewright.fields.textures import TextureField
from tilewright.showing import describe
from tilewright.signals.textures import TextureTiles
from tilewright.tiles import corner_tiles, wang_tiles
from tilewright.tilings import stochastic

_CELLS = 256
"""Side of the patch that sets without a direct tiling are laid on."""


@dataclass(frozen=True, eq=False)
class Contender:
    """A method with its plane.

    Attributes
    ----------
    name : str
        ``"repeat"``, ``"hex"``, ``"noise"``, ``"wang"`` or ``"corner"``.
    label : str
        What a person calls it.
    field : PixelField
        The plane; its ``render`` gives pixels.
    lattice : int64 array, shape (2, 2)
        Two vectors (x, y), in pixels, of the lattice that the method works on.
    fetches : int
        Texture fetches that a sample takes.
    table_fetches : int
        Fetches from a table that fits in a cache.
    texels : int
        Texels of the finest level of what it fetches from, the table among them.
    """

    name: str
    label: str
    field: PixelField
    lattice: NDArray[np.int64]
    fetches: int
    table_fetches: int
    texels: int


@dataclass(frozen=True, eq=False)
class SideBySide:
    """The main map of a material's photograph by five methods.

    Attributes
    ----------
    material : TextureTiles
        The material whose photograph it is.
    seed : int
        Seed of all tilings and blends.
    contenders : dict of str to Contender
        The methods by name, in the order they are shown: ``"repeat"``, ``"hex"``, ``"noise"``, ``"wang"``,
        ``"corner"``. Each has a ``label`` and a ``field`` with ``render``.
    figures : dict of str to dict of str to float
        What `compare_textures` measured of each; empty where nothing was measured.
    """

    material: TextureTiles
    seed: int
    contenders: dict[str, Contender]
    figures: dict[str, dict[str, float]] = field(default_factory=dict)

    def __repr__(self) -> str:
        return describe(self, *self.contenders, f"seed {self.seed}", repr(self.material))

    @property
    def photo(self) -> NDArray[Any]:
        """The main map of the photograph, shape (h, w, channels)."""
        return self.material.sources[0][self.material.main]


def side_by_side(material: TextureTiles, *, seed: int = 0, progress: Progress | None = None) -> SideBySide:
    """Set five methods on one photograph beside each other.

    Parameters
    ----------
    material : TextureTiles
        Made from one photograph. The other of Wang and corner tiles is made from the same exemplar, with the
        same tile size, seed, number of colors and of variants.
    seed : int, optional
        Seed of all tilings and blends, 0 to 2^64 - 1; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)`` while the other set is made; raise `Cancelled` in it to
        stop.

    Returns
    -------
    SideBySide
        The five planes, without figures; `compare_textures` measures them too.

    Raises
    ------
    TilewrightTypeError
        Something else than texture tiles.
    TilewrightValueError
        The material was made from several photographs.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16)
    >>> planes = tw.side_by_side(material, seed=7)
    >>> list(planes.contenders)
    ['repeat', 'hex', 'noise', 'wang', 'corner']
    >>> planes.contenders["hex"].field.render(0, 0, 40, 30).shape
    (30, 40, 3)
    """
    check_type("material", material, TextureTiles, "TextureTiles")
    check_progress(progress)
    if len(material.sources) != 1:
        raise TilewrightValueError(
            f"was made from {len(material.sources)} photographs; a comparison takes one", argument="material"
        )
    other = _other_kind(material, progress)
    wang, corner = (material, other) if "N" in material.tiles.shape.slots else (other, material)
    photo, kind = material.sources[0][material.main], material.kinds[material.main]
    noise = NoiseField(photo, kind, seed=seed)
    table = noise.gaussian.table
    contenders = (
        _photographic("repeat", "Plain repeat", RepeatField(photo, kind), 1),
        _photographic("hex", "Hex-tiling", HexField(photo, kind, seed=seed), 3),
        _photographic("noise", "By-example noise", noise, 3, table.shape[2], table[..., 0].size),
        _tiled("wang", "Wang tiles", wang, seed),
        _tiled("corner", "Corner tiles", corner, seed),
    )
    return SideBySide(material, seed, {one.name: one for one in contenders})


def _other_kind(material: TextureTiles, progress: Progress | None) -> TextureTiles:
    """Corner tiles for edge colors, Wang tiles for corner colors; of equal size, seed and colors."""
    from tilewright.signals.textures import Exemplar, synthesize

    shape, tiles = material.tiles.shape, material.tiles
    colors = tiles.parameters["colors"] if tiles.family == "classed" else max(tiles.colors)
    return synthesize(
        Exemplar(material.sources, material.masks or None, material.recipe.get("weights"), material.kinds),
        corner_tiles(colors) if "N" in shape.slots else wang_tiles(colors),
        tile_size=material.tile_size,
        seed=material.recipe.get("seed", 0),
        variants=material.recipe.get("variants", 1),
        progress=progress,
    )


def _photographic(
    name: str, label: str, plane: PhotoField, fetches: int, table_fetches: int = 0, table: int = 0
) -> Contender:
    texels = plane.photo.shape[0] * plane.photo.shape[1] + table
    return Contender(name, label, plane, plane.lattice, fetches, table_fetches, texels)


def _tiled(name: str, label: str, material: TextureTiles, seed: int) -> Contender:
    """Tiles; those of incomplete sets are looked up."""
    n, tiles = material.tile_size, material.tiles
    plane = TextureField(material, stochastic(tiles, _CELLS, _CELLS, seed))
    lookups = 0 if tiles.is_complete else 1
    texels = len(material.variants) * n * n
    fetches = 1 if material.tone is None else 4
    return Contender(name, label, plane, np.eye(2, dtype=np.int64) * n, fetches, lookups, texels)
