"""A tile set on disk: a folder with ``tileset.json`` beside plain files.

The format is described in ``docs/tileset-folder.md``.
"""

import os
from functools import partial

from tilewright.checks import check_type
from tilewright.errors import TilewrightError, TilewrightFileError
from tilewright.files.atomic import MANIFEST, AnyPath, as_path, check_folder, whole_folder
from tilewright.files.manifest import find_objection, read_head, read_manifest
from tilewright.files.points_folder import PointManifest, read_point_tiles, write_point_tiles
from tilewright.files.texture_folder import TextureManifest, read_texture, write_texture
from tilewright.signals.points import PointTiles
from tilewright.signals.textures import TextureTiles


def save(material: TextureTiles | PointTiles, folder: AnyPath) -> None:
    """Write texture tiles or point tiles to a folder, whole or not at all.

    A folder that holds a tile set of the same signal and nothing else is replaced; any other one that is not
    empty is refused. Folders above that are missing are made.

    Parameters
    ----------
    material : TextureTiles or PointTiles
        What is to be stored.
    folder : str or path-like
        Where it is to be stored.

    Raises
    ------
    TilewrightTypeError
        Something else than texture tiles or point tiles, or no path.
    TilewrightFileError
        The folder cannot be written, or the disk is full; nothing half-written is left.

    Examples
    --------
    >>> import tempfile
    >>> import tilewright as tw
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.save(tw.ready_tiles(), f"{folder}/blue")
    ...     blue = tw.load(f"{folder}/blue")
    >>> len(blue.tiles), blue.density
    (256, 32.0)
    """
    check_type("material", material, (TextureTiles, PointTiles), "TextureTiles or PointTiles")
    signal = "texture" if isinstance(material, TextureTiles) else "points"
    with whole_folder(folder, partial(find_objection, signal=signal)) as unfinished:
        if isinstance(material, TextureTiles):
            write_texture(unfinished, material)
        else:
            write_point_tiles(unfinished, material)


def check_savable(folder: AnyPath, signal: str) -> None:
    """Raise what `save` would raise before it writes anything, so that it is known before long work."""
    check_folder(as_path(folder), partial(find_objection, signal=signal))


def load(folder: AnyPath) -> TextureTiles | PointTiles:
    """Read a tile set from a folder, every file checked against its checksum.

    Parameters
    ----------
    folder : str or path-like
        A folder that `save` or a command wrote.

    Returns
    -------
    TextureTiles or PointTiles
        What the folder holds.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightFileError
        There is no such folder, a file is missing or was changed, the manifest is damaged, newer than
        this program, or names a file outside the folder.

    Examples
    --------
    >>> import tempfile
    >>> import tilewright as tw
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.save(tw.ready_tiles(), f"{folder}/blue")
    ...     blue = tw.load(f"{folder}/blue")
    >>> blue.density
    32.0
    """
    folder = as_path(folder)
    if not os.path.isdir(folder):
        raise TilewrightFileError(
            f"{folder} is not a folder; a tile-set folder with {MANIFEST} is expected", value=folder
        )
    manifest = folder / MANIFEST
    signal = read_head(manifest).signal
    try:
        if signal == "texture":
            return read_texture(folder, read_manifest(manifest, TextureManifest))
        if signal == "points":
            return read_point_tiles(folder, read_manifest(manifest, PointManifest))
        raise TilewrightFileError(
            f"{manifest} has signal {signal!r}; expected 'texture' or 'points'", value=manifest
        )
    except TilewrightError as error:
        message = str(error)
        prefix = "" if message.startswith(str(folder)) else f"{manifest}: "
        raise TilewrightFileError(prefix + message, value=folder) from None
    except OSError as error:
        raise TilewrightFileError(
            f"{folder} cannot be read: {(error.strerror or str(error)).lower()}", value=folder
        ) from None


def load_texture(folder: AnyPath) -> TextureTiles:
    """Read texture tiles from a folder.

    Parameters
    ----------
    folder : str or path-like
        A folder that `save` or a command wrote.

    Returns
    -------
    TextureTiles
        What the folder holds.

    Raises
    ------
    TilewrightFileError
        The folder cannot be read, as `load` tells, or holds points.
    """
    material = load(folder)
    if not isinstance(material, TextureTiles):
        raise TilewrightFileError(
            f"{folder} holds points; a folder of texture tiles is expected", value=folder
        )
    return material


def load_points(folder: AnyPath) -> PointTiles:
    """Read point tiles from a folder.

    Parameters
    ----------
    folder : str or path-like
        A folder that `save` or a command wrote.

    Returns
    -------
    PointTiles
        What the folder holds.

    Raises
    ------
    TilewrightFileError
        The folder cannot be read, as `load` tells, or holds a texture.
    """
    tiles = load(folder)
    if not isinstance(tiles, PointTiles):
        raise TilewrightFileError(
            f"{folder} holds a texture; a folder of point tiles is expected", value=folder
        )
    return tiles
