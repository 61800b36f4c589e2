"""The result of texture synthesis: one picture per tile, and where each pixel came from."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import shape_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.showing import Shown, describe, many
from tilewright.signals.textures.kinds import guess_kind
from tilewright.tiles import TileSet


@dataclass(frozen=True, eq=False)
class TextureTiles(Shown):
    """A texture over a tile set: T tiles of H x W pixels, for one or several maps cut alike.

    Attributes
    ----------
    tiles : TileSet
        What may meet; tile t of every map belongs to row t of ``tiles.slots``.
    maps : dict of str to array, shape (T, H, W, channels), uint8, uint16 or float32
        The maps of the material in the order given; the first is the main one.
    sources : tuple of dict of str to array, shape (h, w, channels)
        The exemplars: one dict for each source, with the same map names.
    origins : uint16 array, shape (T, H, W, 3)
        The source pixel that each tile pixel was copied from: (source number, y, x). By construction
        ``maps[name][t, i, j] == sources[s][name][y, x]``, but for normals and heights near cuts, which
        are closed there.
    recipe : dict
        Method, seed, parameters and the places of all patches, plain JSON values: what is needed to make the
        set again.
    masks : tuple of bool array, shape (h, w)
        For each source, the pixels that may be copied; empty where all may.
    kinds : dict of str to str
        What each map holds: ``"color"``, ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``; guessed from its name where not given.

    Raises
    ------
    TilewrightValueError
        No map, maps of different sizes, or another number of pictures than of tiles.

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

    def __post_init__(self) -> None:
        if not self.maps:
            raise TilewrightValueError("is empty; a material needs at least one map", argument="maps")
        object.__setattr__(
            self, "kinds", {name: self.kinds.get(name) or guess_kind(name) for name in self.maps}
        )
        for name, pixels in self.maps.items():
            if pixels.ndim != 4 or pixels.shape[:3] != self.origins.shape[:3]:
                raise shape_error(
                    f"map {name!r}",
                    pixels.shape,
                    f"(tiles, height, width, channels) with the first three {self.origins.shape[:3]}",
                )
        if len(self.tiles) != self.origins.shape[0]:
            raise TilewrightValueError(
                f"{self.origins.shape[0]} pictures were given for a set of {len(self.tiles)} tiles"
            )

    def __repr__(self) -> str:
        side = self.tile_size
        maps = (f"{name} ({m.dtype}, {many(m.shape[3], 'channel')})" for name, m in self.maps.items())
        return describe(self, f"{self.tiles!r} of {side} x {side} pixels", *maps)

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
        """The main map, shape (T, H, W, channels), of its own type."""
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
    s, y, x = origins[..., 0], origins[..., 1], origins[..., 2]
    for name, first in sources[0].items():
        pixels = np.empty(origins.shape[:3] + first.shape[2:], first.dtype)
        for number, source in enumerate(sources):
            here = s == number
            pixels[here] = source[name][y[here], x[here]]
        maps[name] = pixels
    return maps
