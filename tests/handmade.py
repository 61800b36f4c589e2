"""Texture tiles made by rule, so that tests need no synthesis: borders match, interiors are noise."""

import numpy as np

from tilewright.signals.textures import TextureTiles, copy_from_sources
from tilewright.tiles import TileSet


def handmade(
    tiles: TileSet, size: int = 16, kind: type = np.uint8, channels: int = 3, maps: int = 1
) -> TextureTiles:
    """Tiles that copy random pixels from one random source."""
    rng = np.random.default_rng([len(tiles), size, channels])
    most = 1 if kind is np.float32 else np.iinfo(kind).max
    sources = tuple(
        {f"map{m}": (rng.random((64, 80, channels)) * most).astype(kind) for m in range(maps)}
        for _ in range(2)
    )
    origins = np.empty((len(tiles), size, size, 3), np.uint16)
    for axis, top in enumerate((2, 64, 80)):
        origins[..., axis] = rng.integers(0, top, origins.shape[:3])
    masks = (rng.random((64, 80)) < 0.9, np.ones((64, 80), bool))
    recipe = {"method": "by hand", "seed": 3, "weights": {"map0": 1.0}, "patches": {"center:0": [0, 1, 2]}}
    return TextureTiles(tiles, copy_from_sources(sources, origins), sources, origins, recipe, masks)
