"""Which tiling a command lays a tile set with."""

from tilewright.signals.textures import TextureTiles
from tilewright.tilings import Tiling, direct, scanline
from tilewright.tilings.direct import recognize


def lay(material: TextureTiles, seed: int, right: int, bottom: int) -> Tiling:
    """The direct tiling of a set, or a scanline tiling that covers the pixels up to a corner."""
    if recognize(material.tiles) is not None:
        return direct(material.tiles, seed)
    size = material.tile_size
    return scanline(material.tiles, max(1, -(-right // size)), max(1, -(-bottom // size)), seed)
