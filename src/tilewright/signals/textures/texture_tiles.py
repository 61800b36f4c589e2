"""The result of texture synthesis: pictures of each tile, and where each pixel came from."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_type, shape_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.sameness import Alike
from tilewright.showing import Stored, describe, many
from tilewright.signals.textures.kinds import guess_kind
from tilewright.signals.textures.naming import check_map_names
from tilewright.signals.textures.tone import Tone
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tiles.variants import Variants, check_variants, name_variants


@dataclass(frozen=True, eq=False)
class TextureTiles(Alike, Stored):
    """A texture over a tile set: pictures of H x W pixels, for one or several maps cut alike.

    A tile has one picture or several, its variants, of which any may lie anywhere: their borders are the
    same. Pictures are rows, the variants of a tile one after another; where every tile has one, row t is
    tile t.

    Attributes
    ----------
    tiles : TileSet
        What may meet.
    maps : dict of str to array, shape (rows, H, W, channels), uint8, uint16 or float32
        The maps of the material in the order given; the first is the main one.
    sources : tuple of dict of str to array, shape (h, w, channels)
        The exemplars: one dict for each source, with the same map names.
    origins : uint16 array, shape (rows, H, W, 3)
        The source pixel that each pixel was copied from: (source number, y, x). By construction
        ``maps[name][row, i, j] == sources[s][name][y, x]``, but for normals and heights near cuts, which
        are closed there.
    recipe : dict
        Method, seed, parameters and the places of all patches, plain JSON values: what is needed to make the
        set again.
    masks : tuple of bool array, shape (h, w)
        For each source, the pixels that may be copied; empty where all may.
    kinds : dict of str to str
        What each map holds: ``"color"``, ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``; guessed from its name where not given.
    variants : Variants
        The rows of each tile and how often each is drawn; one row for each tile by default.
    tone : Tone or None
        What lies over the tiles: colors that vary over more than a tile, which the maps do not hold.

    Raises
    ------
    TilewrightValueError
        No map, maps of different sizes, or another number of pictures than of tiles and their variants.

    See Also
    --------
    texture_tiles, synthesize, load
    """

    tiles: TileSet
    maps: dict[str, NDArray[Any]]
    sources: tuple[dict[str, NDArray[Any]], ...]
    origins: NDArray[np.uint16]
    recipe: dict[str, Any] = field(default_factory=dict)
    masks: tuple[NDArray[np.bool_], ...] = ()
    kinds: dict[str, str] = field(default_factory=dict)
    variants: Variants = None  # type: ignore[assignment]  # set below, for the set at hand
    tone: Tone | None = None

    def __post_init__(self) -> None:
        check_tiles("tiles", self.tiles)
        check_type("maps", self.maps, dict, "a dict of arrays")
        for name, pixels in {**self.maps, "origins": self.origins}.items():
            check_type(f"map {name!r}" if name in self.maps else name, pixels, np.ndarray, "an array")
        if not self.maps:
            raise TilewrightValueError("is empty; a material needs at least one map", argument="maps")
        check_map_names(self.maps)
        object.__setattr__(
            self, "kinds", {name: self.kinds.get(name) or guess_kind(name) for name in self.maps}
        )
        for name, pixels in self.maps.items():
            if pixels.ndim != 4 or pixels.shape[:3] != self.origins.shape[:3]:
                raise shape_error(
                    f"map {name!r}",
                    pixels.shape,
                    f"(rows, height, width, channels) with the first three {self.origins.shape[:3]}",
                )
        given = Variants.uniform(self.tiles) if self.variants is None else self.variants
        object.__setattr__(self, "variants", check_variants(given, self.tiles))
        if len(self.variants) != self.origins.shape[0]:
            several = f" with {len(self.variants)} variants" if len(self.variants) > len(self.tiles) else ""
            raise TilewrightValueError(
                f"{self.origins.shape[0]} pictures were given for a set of {len(self.tiles)} tiles{several}"
            )

    def __repr__(self) -> str:
        side = self.tile_size
        maps = (f"{name} ({m.dtype}, {many(m.shape[3], 'channel')})" for name, m in self.maps.items())
        size = f"{self.tiles!r} of {side} x {side} pixels"
        return describe(self, size, *name_variants(self.variants), *maps)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        if len(self.maps) > 1:
            raise TilewrightTypeError(
                f"the tiles have maps {', '.join(self.maps)}",
                advice=f"take one of them, as maps[{self.main!r}]",
            )
        return np.array(self.pixels, dtype, copy=copy)

    @property
    def tile_size(self) -> int:
        """Pixels along one side of a (square) tile."""
        return int(self.origins.shape[1])

    @property
    def main(self) -> str:
        """Name of the main map."""
        return next(iter(self.maps))

    @property
    def pixels(self) -> NDArray[Any]:
        """The main map, shape (rows, H, W, channels), of its own type."""
        return self.maps[self.main]


def copy_from_sources(
    sources: tuple[dict[str, NDArray[Any]], ...], origins: NDArray[np.uint16]
) -> dict[str, NDArray[Any]]:
    """Copy every map of a material pixel by pixel from its sources.

    Parameters
    ----------
    sources : tuple of dict of str to array, shape (h, w, channels)
        The maps of each source.
    origins : uint16 array, shape (T, H, W, 3)
        Where each pixel comes from: (source number, y, x).

    Returns
    -------
    dict of str to array, shape (T, H, W, channels)
        The maps of the tiles.
    """
    maps = {}
    for name, first in sources[0].items():
        pixels = np.empty(origins.shape[:3] + first.shape[2:], first.dtype)
        for tile, (s, y, x) in zip(pixels, np.moveaxis(origins, 3, 1), strict=True):
            for number, source in enumerate(sources):
                here = s == number if len(sources) > 1 else ...
                tile[here] = source[name][y[here], x[here]]
        maps[name] = pixels
    return maps
