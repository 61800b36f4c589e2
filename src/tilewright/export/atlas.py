"""All tiles of a set in one picture, which for complete sets is itself a toroidal tiling."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_choice, check_type
from tilewright.export.array import warn_of_tone
from tilewright.files.atomic import AnyPath
from tilewright.files.images import write_image
from tilewright.shaders.layouts import even_variants, packed_rows
from tilewright.shaders.mipmaps import grid_side
from tilewright.signals.textures import TextureTiles
from tilewright.tilings import Packing, packing


@dataclass(frozen=True)
class TileGrid:
    """Squares row by row, for tiles that have no packing: neighbors do not match.

    Attributes
    ----------
    size : tuple of int
        Columns and rows.
    """

    size: tuple[int, int]

    def place(self, tile: ArrayLike) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Column and row of a tile, or of many.

        Parameters
        ----------
        tile : int or array of int
            Tile indices.

        Returns
        -------
        column : int array
            Of the tile's shape.
        row : int array
            The same.
        """
        row, column = np.divmod(np.asarray(tile, np.int64), self.size[0])
        return column, row


def make_atlas(material: TextureTiles, *, map: str | None = None) -> tuple[NDArray[Any], Packing | TileGrid]:
    """Make the packed picture of a map, and the packing that says where each tile lies.

    Neighbors match, also around the border, so bilinear filtering across tile borders and mip levels down to
    one texel per tile mix only pixels that may meet (Lagae & Dutré 2006, section 6.2).

    Tiles in classes (`tilewright.classed_corner_tiles`) have no packing and lie in a grid, for what reads
    texels one by one; `tilewright.save_for_engine` puts gutters between them, for what filters.

    Parameters
    ----------
    material : TextureTiles
        Texture tiles over a complete set, or in classes.
    map : str, optional
        Which map of the material; by default the main one.

    Returns
    -------
    pixels : array, shape (rows * tile_size, columns * tile_size, channels)
        The picture, of the map's type. Where tiles have variants, a packing for each, from west to east.
    packed : Packing or TileGrid
        ``packed.place(tile)`` is the column and row of a tile; its variant v lies v times
        ``packed.size[0]`` columns further east.

    Raises
    ------
    TilewrightValueError
        The set is neither complete nor in classes, its tiles have not as many variants each, drawn alike,
        or there is no such map.

    Warns
    -----
    TilewrightWarning
        The map has tone outside the tiles, which is not in the picture.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16)
    >>> picture, packed = tw.make_atlas(material)
    >>> picture.shape, packed.size
    ((64, 64, 3), (4, 4))
    """
    check_type("material", material, TextureTiles, "TextureTiles")
    name = material.main if map is None else check_choice("map", map, tuple(material.maps))
    warn_of_tone(material, name)
    classed = material.tiles.family == "classed"
    cells, n = _grid_rows(material) if classed else packed_rows(material), material.tile_size
    rows, columns = cells.shape
    picture = material.maps[name][cells].swapaxes(1, 2)
    pixels = np.ascontiguousarray(picture.reshape(rows * n, columns * n, -1))
    return pixels, TileGrid((rows, rows)) if classed else packing(material.tiles)


def _grid_rows(material: TextureTiles) -> NDArray[np.int64]:
    """The picture in each cell of a grid for each variant, side by side; first tiles fill the last row."""
    count, side = even_variants(material), grid_side(len(material.tiles))
    cells = np.arange(side**2).reshape(side, side) % len(material.tiles) * count
    return np.hstack([cells + variant for variant in range(count)])


def save_atlas(material: TextureTiles, path: AnyPath, *, map: str | None = None) -> None:
    """Write the packed picture of a map to a file; see `make_atlas`.

    Parameters
    ----------
    material : TextureTiles
        Texture tiles over a complete set, or in classes.
    path : str or path-like
        ``.png`` or ``.tif``; ``.exr`` for float maps.
    map : str, optional
        Which map of the material; by default the main one.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightValueError
        The set is neither complete nor in classes, there is no such map, or the suffix does not go with
        it.
    TilewrightFileError
        The file cannot be written.
    """
    atlas = make_atlas(material, map=map)[0]
    write_image(path, atlas, color=material.kinds[material.main if map is None else map] == "color")
