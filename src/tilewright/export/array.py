"""A texture array: one layer per tile and variant."""

from pathlib import Path

import numpy as np

from tilewright.checks import check_choice
from tilewright.files.images import write_image
from tilewright.signals.textures import TextureTiles


def save_array(material: TextureTiles, path: str | Path, *, map: str | None = None) -> None:
    """Write the pictures of a map as layers, one below the other, in order of tile index.

    Engines import such a strip as a 2D texture array of layers of tile_size x tile_size, one for each tile,
    or for each variant of each tile one after another.
    A layer knows nothing of its neighbors: filter it with clamped coordinates, and take gradients from the
    coordinate before it is split into cell and place.

    Parameters
    ----------
    path : str or Path
        PNG or TIFF; EXR for float maps.
    map : str, optional
        The main map by default.
    """
    name = material.main if map is None else check_choice("map", map, tuple(material.maps))
    tiles = material.maps[name]
    write_image(path, np.ascontiguousarray(tiles.reshape(-1, tiles.shape[2], tiles.shape[3])))
