"""All tiles of a complete set in one picture that is itself a toroidal tiling."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice
from tilewright.files.images import write_image
from tilewright.shaders.layouts import packed_rows
from tilewright.signals.textures import TextureTiles
from tilewright.tilings import Packing, packing


def make_atlas(material: TextureTiles, *, map: str | None = None) -> tuple[NDArray[Any], Packing]:
    """The packed picture of a map, and the packing that says where each tile lies.

    Neighbors match, also around the border, so bilinear filtering across tile borders and mip levels down to
    one texel per tile mix only pixels that may meet (Lagae & Dutré 2006, section 6.2).

    Returns
    -------
    pixels : array, shape (rows * tile_size, columns * tile_size, channels)
        Where tiles have variants, a packing for each, from west to east.
    packed : Packing
        ``packed.place(tile)`` is the column and row of a tile; its variant v lies v times
        ``packed.size[0]`` columns further east.

    Raises
    ------
    TilewrightValueError
        The set is not complete, so it has no packing, its tiles have not as many variants each, drawn alike,
        or there is no such map.
    """
    name = material.main if map is None else check_choice("map", map, tuple(material.maps))
    cells, n = packed_rows(material), material.tile_size
    rows, columns = cells.shape
    picture = material.maps[name][cells].swapaxes(1, 2)
    return np.ascontiguousarray(picture.reshape(rows * n, columns * n, -1)), packing(material.tiles)


def save_atlas(material: TextureTiles, path: str | Path, *, map: str | None = None) -> None:
    """Write the packed picture of a map (PNG or TIFF; EXR for float); see `make_atlas`."""
    write_image(path, make_atlas(material, map=map)[0])
