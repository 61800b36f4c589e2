"""A texture array: one layer per tile and variant."""

import warnings

import numpy as np

from tilewright.checks import check_choice, check_type
from tilewright.errors import TilewrightWarning
from tilewright.files.atomic import AnyPath
from tilewright.files.images import write_image
from tilewright.signals.textures import TextureTiles


def save_array(material: TextureTiles, path: AnyPath, *, map: str | None = None) -> None:
    """Write the pictures of a map as layers, one below the other, in order of tile index.

    Engines import such a strip as a 2D texture array of layers of tile_size x tile_size, one for each tile,
    or for each variant of each tile one after another.
    A layer knows nothing of its neighbors: filter it with clamped coordinates, and take gradients from the
    coordinate before it is split into cell and place.

    Parameters
    ----------
    material : TextureTiles
        Texture tiles over any set.
    path : str or path-like
        ``.png`` or ``.tif``; ``.exr`` for float maps.
    map : str, optional
        Which map of the material; by default the main one.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightValueError
        There is no such map, or the suffix does not go with it.
    TilewrightFileError
        The file cannot be written.

    Warns
    -----
    TilewrightWarning
        The map has tone outside the tiles, which is not in the picture.
    """
    check_type("material", material, TextureTiles, "TextureTiles")
    name = material.main if map is None else check_choice("map", map, tuple(material.maps))
    warn_of_tone(material, name)
    tiles = material.maps[name]
    strip = np.ascontiguousarray(tiles.reshape(-1, tiles.shape[2], tiles.shape[3]))
    write_image(path, strip, color=material.kinds[name] == "color")


def warn_of_tone(material: TextureTiles, map: str) -> None:
    """Say that a picture of tiles lacks what lies over them."""
    if material.tone is not None and map in material.tone.maps:
        warnings.warn(
            f"map {map!r} has tone outside its tiles, which is not in the picture; make the texture with "
            "tone=False to keep it in them",
            TilewrightWarning,
            stacklevel=3,
        )
