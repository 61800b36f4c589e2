"""What may meet: shapes, tile sets, and the named families of them."""

from tilewright.tiles.families import corner_tiles, wang_tiles
from tilewright.tiles.shape import CORNER, CORNER_CODED, WANG, Shape
from tilewright.tiles.tileset import TileSet, decode, encode

__all__ = [
    "CORNER",
    "CORNER_CODED",
    "WANG",
    "Shape",
    "TileSet",
    "corner_tiles",
    "decode",
    "encode",
    "wang_tiles",
]
