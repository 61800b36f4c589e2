"""Which patch a tile shows at each pixel, by the names that `pick` and `reject` take."""

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures.texture_tiles import TextureTiles

UNKNOWN = -1
"""Index of pixels of which no patch is known."""


class PatchNames:
    """The names of the patches that pictures of a material show.

    A patch shows the photograph moved by one amount, and lies half a tile or a whole one off where its canvas
    is that of an edge or a corner; the recipe tells where each was taken.

    Parameters
    ----------
    material : TextureTiles
        Tiles with a recipe; without one no name is known.
    """

    def __init__(self, material: TextureTiles) -> None:
        self._material = material
        self._places: dict[tuple[int, ...], list[str]] = {}
        size = material.tile_size
        for name, (source, y, x) in material.recipe.get("patches", {}).items():
            for dy in range(-size, size + 1, size // 2):
                for dx in range(-size, size + 1, size // 2):
                    self._places.setdefault((source, y + dy, x + dx), []).append(name)

    def __bool__(self) -> bool:
        """Whether any name is known."""
        return bool(self._places)

    def of_picture(self, row: int) -> tuple[NDArray[np.int64], list[str]]:
        """Find the patch of each pixel of a picture.

        Parameters
        ----------
        row : int
            The picture's row in the material's maps.

        Returns
        -------
        patches : int64 array, shape (tile_size, tile_size)
            Index of a name, or `UNKNOWN`.
        names : list of str
            Names of the patches that the picture shows.
        """
        material, size = self._material, self._material.tile_size
        source, y, x = np.moveaxis(material.origins[row].astype(np.int64), -1, 0)
        moved = np.stack([source, y - np.arange(size)[:, np.newaxis], x - np.arange(size)], axis=-1)
        keys = moved @ (1 << 40, 1 << 20, 1)
        _, first, which = np.unique(keys, return_index=True, return_inverse=True)
        moves = moved.reshape(-1, 3)[first]
        tile = int(material.variants.tiles[row])
        variant = row - int(material.variants.starts[tile])
        own = f"center:{tile}:{variant}" if variant else f"center:{tile}"
        found = [_choose(self._places.get(tuple(int(v) for v in move), []), own) for move in moves]
        names = sorted({name for name in found if name})
        index = np.array([names.index(name) if name else UNKNOWN for name in found])
        return index[which.reshape(size, size)], names


def _choose(names: list[str], own: str) -> str:
    """The tile's own patch, or else one that is shared by several tiles."""
    return own if own in names else next((name for name in names if not name.startswith("center")), "")
