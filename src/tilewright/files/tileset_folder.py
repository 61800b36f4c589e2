"""A tile set on disk: a folder with ``tileset.json`` beside plain images.

The format is described in ``docs/tileset-folder.md``.
"""

import hashlib
import os
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from tilewright import __version__
from tilewright.errors import TilewrightError, TilewrightFileError, TilewrightTypeError
from tilewright.files.images import lossless_suffix, read_image, write_image
from tilewright.files.whole import MANIFEST, as_path, check_folder, whole_folder
from tilewright.signals.textures import TextureTiles
from tilewright.tiles import TileSet, tile_set
from tilewright.tiles.shape import Shape

SCHEMA = 1
_DROPPED_BY_SYSTEMS = {".DS_Store", "Thumbs.db", "desktop.ini"}


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

    A folder that holds a tile set and nothing else is replaced; any other one that is not empty is
    refused.

    Raises
    ------
    TilewrightFileError
        The folder cannot be written, or the disk is full; nothing half-written is left.
    """
    if not isinstance(material, TextureTiles):
        raise TilewrightTypeError(f"material must be TextureTiles, not {type(material).__name__}")
    with whole_folder(folder, _objection) as unfinished:
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


def check_savable(folder: str | Path) -> None:
    """Raise what `save` would raise before it writes anything, so that it is known before long work."""
    check_folder(as_path(folder), _objection)


def load(folder: str | Path) -> TextureTiles:
    """Read texture tiles from a folder, every file checked against its checksum.

    Raises
    ------
    TilewrightFileError
        There is no such folder, a file is missing or was changed, the manifest is damaged, newer than
        this program, or names a file outside the folder.
    """
    folder = as_path(folder)
    if not os.path.isdir(folder):
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
        _check_sources(sources, masks, maps)
        _check_origins(origins, sources)
        return TextureTiles(tiles, maps, sources, origins, manifest.recipe, masks)
    except TilewrightError as error:
        message = str(error)
        prefix = "" if message.startswith(str(folder)) else f"{folder / MANIFEST}: "
        raise TilewrightFileError(prefix + message) from None
    except OSError as error:
        raise TilewrightFileError(
            f"{folder} cannot be read: {(error.strerror or str(error)).lower()}"
        ) from None


def _read_manifest(path: Path) -> Manifest:
    if path.exists() and not path.is_file():
        raise TilewrightFileError(f"{path} is not a plain file")
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
        manifest = msgspec.json.decode(text, type=Manifest)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        raise TilewrightFileError(f"{path} is damaged: {error}") from None
    if schema < 1 or manifest.signal != "texture":
        raise TilewrightFileError(
            f"{path} has schema {schema} and signal {manifest.signal!r}; expected 1 to {SCHEMA} and 'texture'"
        )
    return manifest


def _objection(folder: Path) -> str:
    """Why a folder must not be replaced by a tile set; nothing where it may."""
    try:
        ours = {MANIFEST, *_read_manifest(folder / MANIFEST).checksums}
    except TilewrightFileError:
        return f"holds other things and no {MANIFEST} of this program"
    for path in sorted(folder.rglob("*")):
        if path.is_dir() and not os.access(path, os.R_OK | os.W_OK | os.X_OK):
            return f"holds {path.relative_to(folder).as_posix()}, which cannot be read and replaced"
        name = path.relative_to(folder).as_posix()
        is_folder = path.is_dir() and not path.is_symlink()
        if not (is_folder or name in ours or path.name in _DROPPED_BY_SYSTEMS):
            return f"holds {name}, which is not part of its tile set"
    return ""


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


def _check_sources(
    sources: tuple[dict[str, NDArray[Any]], ...],
    masks: tuple[NDArray[np.bool_], ...],
    maps: dict[str, NDArray[Any]],
) -> None:
    """Raise unless every source has all maps, of one size, and masks, if any, fit."""
    if not sources or len(masks) not in (0, len(sources)):
        raise TilewrightFileError(
            f"there are {len(sources)} sources and {len(masks)} masks; expected as many"
        )
    for number, source in enumerate(sources):
        if list(source) != list(maps):
            raise TilewrightFileError(f"source {number} has maps {list(source)}; the tiles have {list(maps)}")
        sizes = [pixels.shape[:2] for pixels in (*source.values(), *masks[number : number + 1])]
        if len(set(sizes)) > 1:
            raise TilewrightFileError(f"the maps and mask of source {number} differ in size: {sizes}")
        for name, pixels in source.items():
            if (pixels.dtype, pixels.shape[2]) != (maps[name].dtype, maps[name].shape[3]):
                raise TilewrightFileError(
                    f"map {name!r} of source {number} is {pixels.dtype} with {pixels.shape[2]} channels; its "
                    f"tiles are {maps[name].dtype} with {maps[name].shape[3]}"
                )


def _check_origins(origins: NDArray[Any], sources: tuple[dict[str, NDArray[Any]], ...]) -> None:
    """Raise unless every origin is a pixel of a source."""
    if origins.dtype != np.uint16 or origins.shape[3] != 3:
        raise TilewrightFileError("origins must be 16-bit images with three channels")
    sizes = np.array([next(iter(source.values())).shape[:2] for source in sources])
    for t, spots in enumerate(origins):
        number = spots[..., 0]
        if number.max() >= len(sources) or (spots[..., 1:] >= sizes[number]).any():
            raise TilewrightFileError(f"tile {t} of origins names a pixel outside its source")


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
        """The pixels of a file the manifest names."""
        path = self.folder / name
        if not self._is_inside(name):
            raise TilewrightFileError(f"{name[:200]!r} leaves the folder; only files inside it may be named")
        if not path.is_file():
            raise TilewrightFileError(f"{path} is missing")
        if name not in self.checksums:
            raise TilewrightFileError(f"{name!r} has no checksum")
        if hashlib.sha256(path.read_bytes()).hexdigest() != self.checksums[name]:
            raise TilewrightFileError(f"{path} was changed since the set was made: its checksum is wrong")
        return read_image(path)

    def _is_inside(self, name: str) -> bool:
        """Whether a name, links followed, is that of a file in the folder on any system."""
        posix, windows = PurePosixPath(name), PureWindowsPath(name)
        if posix.is_absolute() or windows.anchor or ".." in posix.parts or "\\" in name or "\0" in name:
            return False
        return os.path.realpath(self.folder / name).startswith(os.path.realpath(self.folder) + os.sep)
