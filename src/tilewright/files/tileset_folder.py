"""A tile set on disk: a folder with ``tileset.json`` beside plain images.

The format is described in ``docs/tileset-folder.md``.
"""

import hashlib
from pathlib import Path, PurePosixPath
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from tilewright import __version__
from tilewright.errors import TilewrightError, TilewrightFileError
from tilewright.files.images import lossless_suffix, read_image, write_image
from tilewright.files.whole import whole_folder
from tilewright.signals.textures import TextureTiles
from tilewright.tiles import TileSet, tile_set
from tilewright.tiles.shape import Shape

MANIFEST = "tileset.json"
SCHEMA = 1


class Tiles(msgspec.Struct, forbid_unknown_fields=True):
    """The tile set: shape name, slot names, colors of each slot, and the slots of every tile."""

    shape: str
    name: str
    slot_names: list[str]
    colors: list[int]
    slots: list[list[int]]


class Manifest(msgspec.Struct, forbid_unknown_fields=True):
    """What ``tileset.json`` holds."""

    schema: int
    program: str
    signal: str
    tile_size: int
    tiles: Tiles
    maps: dict[str, list[str]]
    origins: list[str]
    sources: list[dict[str, str]]
    masks: list[str]
    recipe: dict[str, Any]
    checksums: dict[str, str]


class _Header(msgspec.Struct):
    """What is looked at before the rest, so that a newer file is told from a broken one."""

    schema: int


def save(material: TextureTiles, folder: str | Path) -> None:
    """Write texture tiles to a folder, whole or not at all.

    A folder that holds a ``tileset.json`` is replaced; any other folder that is not empty is refused.

    Raises
    ------
    TilewrightFileError
        The folder cannot be written, or the disk is full; nothing half-written is left.
    """
    with whole_folder(folder, MANIFEST) as unfinished:
        writer = _Writer(unfinished)
        count = len(material.tiles)
        digits = len(str(count - 1))
        maps = {
            name: [
                writer.image(f"{_safe(name)}/{t:0{digits}d}{lossless_suffix(pixels.dtype)}", pixels[t])
                for t in range(count)
            ]
            for name, pixels in material.maps.items()
        }
        origins = [writer.image(f"origins/{t:0{digits}d}.png", material.origins[t]) for t in range(count)]
        sources = [
            {
                name: writer.image(f"exemplar/{s}-{_safe(name)}{lossless_suffix(pixels.dtype)}", pixels)
                for name, pixels in source.items()
            }
            for s, source in enumerate(material.sources)
        ]
        masks = [
            writer.image(f"exemplar/{s}-mask.png", mask[..., np.newaxis].astype(np.uint8) * 255)
            for s, mask in enumerate(material.masks)
        ]
        tiles = material.tiles
        manifest = Manifest(
            SCHEMA,
            f"tilewright {__version__}",
            "texture",
            material.tile_size,
            Tiles(
                tiles.shape.name,
                tiles.name,
                list(tiles.shape.slots),
                list(tiles.colors),
                tiles.slots.tolist(),
            ),
            maps,
            origins,
            sources,
            masks,
            material.recipe,
            writer.checksums,
        )
        text = msgspec.json.format(msgspec.json.encode(manifest), indent=1)
        (unfinished / MANIFEST).write_bytes(text)


def load(folder: str | Path) -> TextureTiles:
    """Read texture tiles from a folder, every file checked against its checksum.

    Raises
    ------
    TilewrightFileError
        There is no such folder, a file is missing or was changed, the manifest is damaged, newer than
        this program, or names a file outside the folder.
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise TilewrightFileError(f"{folder} is not a folder; a tile-set folder with {MANIFEST} is expected")
    manifest = _read_manifest(folder / MANIFEST)
    read = _Reader(folder, manifest.checksums)
    try:
        tiles = _tiles(manifest.tiles)
        size = manifest.tile_size
        count = len(tiles)
        maps = {
            n: _stack(n, [read.image(f) for f in files], count, size) for n, files in manifest.maps.items()
        }
        origins = _stack("origins", [read.image(f) for f in manifest.origins], count, size)
        sources = tuple({n: read.image(f) for n, f in source.items()} for source in manifest.sources)
        masks = tuple(read.image(f)[..., 0] > 127 for f in manifest.masks)
        if origins.dtype != np.uint16 or origins.shape[3] != 3:
            raise TilewrightFileError("origins must be 16-bit images with three channels")
        return TextureTiles(tiles, maps, sources, origins, manifest.recipe, masks)
    except TilewrightError as error:
        message = str(error)
        prefix = "" if message.startswith(str(folder)) else f"{folder / MANIFEST}: "
        raise TilewrightFileError(prefix + message) from None


def _read_manifest(path: Path) -> Manifest:
    try:
        text = path.read_bytes()
    except OSError as error:
        raise TilewrightFileError(f"{path} cannot be read: {(error.strerror or '').lower()}") from None
    try:
        schema = msgspec.json.decode(text, type=_Header).schema
        if schema > SCHEMA:
            raise TilewrightFileError(
                f"{path} has schema {schema}; this version of tilewright reads up to {SCHEMA}: update it"
            )
        return msgspec.json.decode(text, type=Manifest)
    except msgspec.DecodeError as error:
        raise TilewrightFileError(f"{path} is damaged: {error}") from None


def _tiles(given: Tiles) -> TileSet:
    plain = tile_set([[0] * len(given.slot_names)], given.shape)
    shape: Shape = plain.shape
    if list(shape.slots) != given.slot_names:
        raise TilewrightFileError(
            f"slot_names is {given.slot_names}; {shape.name} tiles have {list(shape.slots)}"
        )
    if any(len(row) != len(shape.slots) for row in given.slots):
        raise TilewrightFileError(f"every row of slots must have {len(shape.slots)} colors")
    return TileSet(shape, np.array(given.slots), tuple(given.colors), given.name)


def _stack(name: str, pictures: list[NDArray[Any]], count: int, size: int) -> NDArray[Any]:
    if len(pictures) != count:
        raise TilewrightFileError(f"{name} lists {len(pictures)} tiles; the set has {count}")
    for t, picture in enumerate(pictures):
        if picture.shape != (size, size, pictures[0].shape[2]) or picture.dtype != pictures[0].dtype:
            raise TilewrightFileError(
                f"tile {t} of {name} is {picture.dtype} {picture.shape}; expected {pictures[0].dtype} "
                f"{(size, size, pictures[0].shape[2])}"
            )
    return np.stack(pictures)


def _safe(name: str) -> str:
    """A map's name as part of a file name."""
    return "".join(c if c.isalnum() or c in "-_" else "_" for c in name) or "map"


class _Writer:
    """Writes images into a new folder and keeps their checksums."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.checksums: dict[str, str] = {}

    def image(self, name: str, pixels: NDArray[Any]) -> str:
        """Write an image; its name, another one where two maps would share a file."""
        path = PurePosixPath(name)
        while name in self.checksums:
            path = path.with_stem(path.stem + "_")
            name = str(path)
        target = self.folder / name
        target.parent.mkdir(exist_ok=True)
        write_image(target, pixels)
        self.checksums[name] = hashlib.sha256(target.read_bytes()).hexdigest()
        return name


class _Reader:
    """Reads the images a manifest names, if they lie in its folder and are what was written."""

    def __init__(self, folder: Path, checksums: dict[str, str]) -> None:
        self.folder = folder
        self.checksums = checksums

    def image(self, name: str) -> NDArray[Any]:
        path = self.folder / name
        parts = PurePosixPath(name).parts
        inside = not PurePosixPath(name).is_absolute() and ".." not in parts and "\\" not in name
        if not inside or not path.resolve().is_relative_to(self.folder.resolve()):
            raise TilewrightFileError(f"{name!r} leaves the folder; only files inside it may be named")
        if not path.is_file():
            raise TilewrightFileError(f"{path} is missing")
        if name not in self.checksums:
            raise TilewrightFileError(f"{name!r} has no checksum")
        if hashlib.sha256(path.read_bytes()).hexdigest() != self.checksums[name]:
            raise TilewrightFileError(f"{path} was changed since the set was made: its checksum is wrong")
        return read_image(path)
