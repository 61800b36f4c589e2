"""All tiles of a complete set in one picture that is itself a toroidal tiling."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice
from tilewright.export.array import warn_of_tone
from tilewright.files.atomic import AnyPath
from tilewright.files.images import write_image
from tilewright.shaders.layouts import packed_rows
from tilewright.signals.textures import TextureTiles
from tilewright.tilings import Packing, packing


def make_atlas(material: TextureTiles, *, map: str | None = None) -> tuple[NDArray[Any], Packing]:
    """Make the packed picture of a map, and the packing that says where each tile lies.

    Neighbors match, also around the border, so bilinear filtering across tile borders and mip levels down to
    one texel per tile mix only pixels that may meet (Lagae & Dutré 2006, section 6.2).

    Parameters
    ----------
    material : TextureTiles
        Texture tiles over a complete set.
    map : str, optional
        Which map of the material; by default the main one.

    Returns
    -------
    pixels : array, shape (rows * tile_size, columns * tile_size, channels)
        The picture, of the map's type. Where tiles have variants, a packing for each, from west to east.
    packed : Packing
        ``packed.place(tile)`` is the column and row of a tile; its variant v lies v times
        ``packed.size[0]`` columns further east.

    Raises
    ------
    TilewrightValueError
        The set is not complete, so it has no packing, its tiles have not as many variants each, drawn alike,
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
    name = material.main if map is None else check_choice("map", map, tuple(material.maps))
    warn_of_tone(material, name)
    cells, n = packed_rows(material), material.tile_size
    rows, columns = cells.shape
    picture = material.maps[name][cells].swapaxes(1, 2)
    return np.ascontiguousarray(picture.reshape(rows * n, columns * n, -1)), packing(material.tiles)


def save_atlas(material: TextureTiles, path: AnyPath, *, map: str | None = None) -> None:
    """Write the packed picture of a map to a file; see `make_atlas`.

    Parameters
    ----------
    material : TextureTiles
        Texture tiles over a complete set.
    path : str or path-like
        ``.png`` or ``.tif``; ``.exr`` for float maps.
    map : str, optional
        Which map of the material; by default the main one.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightValueError
        The set is not complete, so it has no packing, there is no such map, or the suffix does not go with
        it.
    TilewrightFileError
        The file cannot be written.
    """
    write_image(path, make_atlas(material, map=map)[0])
