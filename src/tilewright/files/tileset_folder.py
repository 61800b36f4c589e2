"""A tile set on disk: a folder with ``tileset.json`` beside plain files.

The format is described in ``docs/tileset-folder.md``.
"""

import os

from tilewright.errors import TilewrightError, TilewrightFileError, TilewrightTypeError
from tilewright.files.atomic import MANIFEST, AnyPath, as_path, check_folder, whole_folder
from tilewright.files.manifest import find_objection, read_head, read_manifest
from tilewright.files.points_folder import PointManifest, read_point_tiles, write_point_tiles
from tilewright.files.texture_folder import TextureManifest, read_texture, write_texture
from tilewright.signals.points import PointTiles
from tilewright.signals.textures import TextureTiles


def save(material: TextureTiles | PointTiles, folder: AnyPath) -> None:
    """Write texture tiles or point tiles to a folder, whole or not at all.

    A folder that holds a tile set and nothing else is replaced; any other one that is not empty is
    refused.

    Raises
    ------
    TilewrightFileError
        The folder cannot be written, or the disk is full; nothing half-written is left.
    """
    if not isinstance(material, (TextureTiles, PointTiles)):
        raise TilewrightTypeError(
            f"material must be TextureTiles or PointTiles, not {type(material).__name__}"
        )
    with whole_folder(folder, find_objection) as unfinished:
        if isinstance(material, TextureTiles):
            write_texture(unfinished, material)
        else:
            write_point_tiles(unfinished, material)


def check_savable(folder: AnyPath) -> None:
    """Raise what `save` would raise before it writes anything, so that it is known before long work."""
    check_folder(as_path(folder), find_objection)


def load(folder: AnyPath) -> TextureTiles | PointTiles:
    """Read a tile set from a folder, every file checked against its checksum.

    Raises
    ------
    TilewrightFileError
        There is no such folder, a file is missing or was changed, the manifest is damaged, newer than
        this program, or names a file outside the folder.
    """
    folder = as_path(folder)
    if not os.path.isdir(folder):
        raise TilewrightFileError(f"{folder} is not a folder; a tile-set folder with {MANIFEST} is expected")
    manifest = folder / MANIFEST
    signal = read_head(manifest).signal
    try:
        if signal == "texture":
            return read_texture(folder, read_manifest(manifest, TextureManifest))
        if signal == "points":
            return read_point_tiles(folder, read_manifest(manifest, PointManifest))
        raise TilewrightFileError(f"{manifest} has signal {signal!r}; expected 'texture' or 'points'")
    except TilewrightError as error:
        message = str(error)
        prefix = "" if message.startswith(str(folder)) else f"{manifest}: "
        raise TilewrightFileError(prefix + message) from None
    except OSError as error:
        raise TilewrightFileError(
            f"{folder} cannot be read: {(error.strerror or str(error)).lower()}"
        ) from None


def load_texture(folder: AnyPath) -> TextureTiles:
    """`load`, if the folder holds texture tiles."""
    material = load(folder)
    if not isinstance(material, TextureTiles):
        raise TilewrightFileError(f"{folder} holds points; a folder of texture tiles is expected")
    return material


def load_points(folder: AnyPath) -> PointTiles:
    """`load`, if the folder holds point tiles."""
    tiles = load(folder)
    if not isinstance(tiles, PointTiles):
        raise TilewrightFileError(f"{folder} holds a texture; a folder of point tiles is expected")
    return tiles
