"""Point tiles in a tile-set folder: one NPZ file with the points of all tiles."""

from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from tilewright import __version__
from tilewright.errors import TilewrightFileError
from tilewright.files.archives import read_archive
from tilewright.files.manifest import (
    SCHEMA,
    VARIANTS_SCHEMA,
    Reader,
    StoredVariants,
    Tiles,
    Writer,
    restore_variants,
    store_variants,
)
from tilewright.signals.points import PointTiles

_ARRAYS = {"points": np.float32, "starts": np.int64, "ranks": np.float32}


class PointManifest(msgspec.Struct, forbid_unknown_fields=True):
    """What ``tileset.json`` of a point set holds."""

    schema: int
    program: str
    signal: str
    tiles: Tiles
    variants: StoredVariants
    distance: float
    method: str
    points: str
    recipe: dict[str, Any]
    figures: dict[str, Any]
    checksums: dict[str, str]


def write_point_tiles(folder: Path, tiles: PointTiles) -> None:
    """Fill an empty folder."""
    writer = Writer(folder)
    name, target = writer.free("points.npz")
    np.savez_compressed(target, **{array: getattr(tiles, array) for array in _ARRAYS})
    writer.seal(name)
    writer.finish(
        PointManifest(
            SCHEMA if tiles.variants.even else VARIANTS_SCHEMA,
            f"tilewright {__version__}",
            "points",
            Tiles.of(tiles.tiles),
            store_variants(tiles.variants),
            tiles.distance,
            tiles.method,
            name,
            tiles.recipe,
            tiles.figures,
            writer.checksums,
        )
    )


def read_point_tiles(folder: Path, manifest: PointManifest) -> PointTiles:
    """The point tiles of a folder, every file checked."""
    path = Reader(folder, manifest.checksums).path(manifest.points)
    arrays = read_archive(path, lambda there: list(_ARRAYS))
    for name, kind in _ARRAYS.items():
        if arrays[name].dtype != kind:
            raise TilewrightFileError(
                f"{path}: {name} is {arrays[name].dtype}; expected {np.dtype(kind)}", value=path
            )
    tiles = manifest.tiles.make()
    return PointTiles(
        tiles,
        arrays["points"],
        arrays["starts"],
        arrays["ranks"],
        restore_variants(manifest.variants, tiles),
        manifest.distance,
        manifest.method,
        manifest.recipe,
        manifest.figures,
    )
