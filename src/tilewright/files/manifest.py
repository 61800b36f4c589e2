"""What every tile-set folder has: ``tileset.json`` with the tile set, and files with checksums.

The format is described in ``docs/tileset-folder.md``.
"""

import hashlib
import os
import re
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import TypeVar

import msgspec
import numpy as np

from tilewright.errors import TilewrightFileError
from tilewright.files.atomic import MANIFEST
from tilewright.tiles import ListedTileSet, TileSet, tile_set
from tilewright.tiles.shape import Shape
from tilewright.tiles.variants import NUMBER_BITS, Variants, check_variants

SCHEMA, VARIANTS_SCHEMA, TONE_SCHEMA, NEWEST_SCHEMA = 2, 3, 4, 5
"""What is written; where variants ask for it, of a texture any, of points those with weights; where there is
tone; where tone is a factor below a mean, or lies over other maps than color."""
_DROPPED_BY_SYSTEMS = {".DS_Store", "Thumbs.db", "desktop.ini"}


class Tiles(msgspec.Struct, forbid_unknown_fields=True):
    """The tile set: shape name, slot names, colors of each slot, and the slots of every tile."""

    shape: str
    name: str
    slot_names: list[str]
    colors: list[int]
    slots: list[list[int]]

    @classmethod
    def of(cls, tiles: TileSet) -> "Tiles":
        """The description of a tile set."""
        names = list(tiles.shape.slots)
        return cls(tiles.shape.name, tiles.name, names, list(tiles.colors), tiles.slots.tolist())

    def make(self) -> TileSet:
        """The tile set that is described."""
        plain = tile_set([[0] * len(self.slot_names)], self.shape)
        shape: Shape = plain.shape
        if list(shape.slots) != self.slot_names:
            raise TilewrightFileError(
                f"slot_names is {self.slot_names}; {shape.name} tiles have {list(shape.slots)}"
            )
        if any(len(row) != len(shape.slots) for row in self.slots):
            raise TilewrightFileError(f"every row of slots must have {len(shape.slots)} colors")
        return ListedTileSet(shape, np.array(self.slots), tuple(self.colors), self.name)


StoredVariants = int | list[list[int]]
"""Variants of every tile, all drawn alike; or for each tile the shares of its variants, in 2^24ths."""


def store_variants(variants: Variants) -> StoredVariants:
    """Variants as a manifest has them."""
    return variants.even or [row.tolist() for row in np.split(variants.shares, variants.starts[1:-1])]


def restore_variants(stored: StoredVariants, tiles: TileSet) -> Variants:
    """The variants that a manifest tells."""
    if isinstance(stored, int):
        return Variants.uniform(tiles, stored)
    if wrong := [t for t, row in enumerate(stored) if sum(row) != 2**NUMBER_BITS]:
        raise TilewrightFileError(f"the shares of the variants of tile {wrong[0]} do not add up to 2^24")
    return check_variants(Variants.weighted(stored), tiles)


class Head(msgspec.Struct):
    """What is looked at before the rest, so that a newer file is told from a broken one."""

    schema: int
    signal: str = ""
    checksums: dict[str, str] = {}


M = TypeVar("M", bound=msgspec.Struct)


def read_head(path: Path) -> Head:
    """Schema, signal and checksums of a manifest that this program knows."""
    try:
        head = msgspec.json.decode(_read_text(path), type=Head)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        raise TilewrightFileError(f"{path} is damaged: {error}", value=path) from None
    if head.schema > NEWEST_SCHEMA:
        raise TilewrightFileError(
            f"{path} has schema {head.schema}; this version of tilewright reads up to {NEWEST_SCHEMA}: "
            "update it",
            value=path,
        )
    if head.schema < 1:
        raise TilewrightFileError(
            f"{path} has schema {head.schema}; expected 1 to {NEWEST_SCHEMA}", value=path
        )
    return head


def read_manifest(path: Path, kind: type[M]) -> M:
    """The whole manifest."""
    try:
        return msgspec.json.decode(_read_text(path), type=kind)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        raise TilewrightFileError(f"{path} is damaged: {error}", value=path) from None


def _read_text(path: Path) -> bytes:
    if path.exists() and not path.is_file():
        raise TilewrightFileError(f"{path} is not a plain file", value=path)
    try:
        return path.read_bytes()
    except OSError as error:
        raise TilewrightFileError(
            f"{path} cannot be read: {(error.strerror or '').lower()}", value=path
        ) from None


def find_objection(folder: Path, signal: str) -> str:
    """Why a folder must not be replaced by a tile set of that signal; nothing where it may."""
    try:
        head = read_head(folder / MANIFEST)
    except TilewrightFileError:
        return f"holds other things and no {MANIFEST} of this program"
    if head.signal != signal:
        return f"holds tiles of signal {head.signal!r}, which tiles of signal {signal!r} never replace"
    ours = {MANIFEST, *head.checksums}
    for path in sorted(folder.rglob("*")):
        if path.is_dir() and not os.access(path, os.R_OK | os.W_OK | os.X_OK):
            return f"holds {path.relative_to(folder).as_posix()}, which cannot be read and replaced"
        name = path.relative_to(folder).as_posix()
        is_folder = path.is_dir() and not path.is_symlink()
        if not (is_folder or name in ours or path.name in _DROPPED_BY_SYSTEMS):
            return f"holds {name}, which is not part of its tile set"
    return ""


class Writer:
    """Finds names for the files of a new folder and keeps their checksums."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.checksums: dict[str, str] = {}
        self._taken: set[str] = set()

    def free(self, name: str) -> tuple[str, Path]:
        """A name like this that no file has yet, on any system, and where the file goes."""
        path = PurePosixPath(name)
        while name.casefold() in self._taken:
            path = path.with_stem(path.stem + "_")
            name = str(path)
        self._taken.add(name.casefold())
        target = self.folder / name
        target.parent.mkdir(exist_ok=True)
        return name, target

    def seal(self, name: str) -> str:
        """Note the checksum of a file that is written; its name."""
        self.checksums[name] = hashlib.sha256((self.folder / name).read_bytes()).hexdigest()
        return name

    def finish(self, manifest: msgspec.Struct) -> None:
        """Write the manifest, a row of numbers on a line."""
        text = msgspec.json.format(msgspec.json.encode(manifest), indent=1)
        # A line break cannot lie in a name, so only lists are met.
        rows = re.sub(rb"\[\n[\d,.\s-]+\]", lambda row: b"".join(row[0].split()).replace(b",", b", "), text)
        (self.folder / MANIFEST).write_bytes(rows)


class Reader:
    """Finds the files a manifest names, if they lie in its folder and are what was written."""

    def __init__(self, folder: Path, checksums: dict[str, str]) -> None:
        self.folder = folder
        self.checksums = checksums

    def path(self, name: str) -> Path:
        """Where a file lies that the manifest names."""
        path = self.folder / name
        if not self._is_inside(name):
            raise TilewrightFileError(f"{name[:200]!r} leaves the folder; only files inside it may be named")
        if not path.is_file():
            raise TilewrightFileError(f"{path} is missing", value=path)
        if name not in self.checksums:
            raise TilewrightFileError(f"{name!r} has no checksum")
        if hashlib.sha256(path.read_bytes()).hexdigest() != self.checksums[name]:
            raise TilewrightFileError(
                f"{path} was changed since the set was made: its checksum is wrong", value=path
            )
        return path

    def _is_inside(self, name: str) -> bool:
        """Whether a name, links followed, is that of a file in the folder on any system."""
        posix, windows = PurePosixPath(name), PureWindowsPath(name)
        if posix.is_absolute() or windows.anchor or ".." in posix.parts or "\\" in name or "\0" in name:
            return False
        return os.path.realpath(self.folder / name).startswith(os.path.realpath(self.folder) + os.sep)
