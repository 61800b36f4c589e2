"""What may meet: shapes, tile sets, and the named families of them."""

from tilewright.tiles.cubes import compact_corner_cubes, compact_wang_cubes, corner_cubes, wang_cubes
from tilewright.tiles.families import (
    as_wang_tiles,
    cohen_tiles,
    column_corner_tiles,
    compact_wang_tiles,
    corner_coded_tiles,
    corner_tiles,
    crossed_wang_tiles,
    dominoes,
    shifted_wang_tiles,
    summed_wang_tiles,
    tile_set,
    wang_tiles,
)
from tilewright.tiles.shape import CORNER, CORNER_CODED, CORNER_CUBE, DOMINO, WANG, WANG_CUBE, Shape
from tilewright.tiles.tileset import TileSet, decode, encode

__all__ = [
    "CORNER",
    "CORNER_CODED",
    "CORNER_CUBE",
    "DOMINO",
    "WANG",
    "WANG_CUBE",
    "Shape",
    "TileSet",
    "as_wang_tiles",
    "cohen_tiles",
    "column_corner_tiles",
    "compact_corner_cubes",
    "compact_wang_cubes",
    "compact_wang_tiles",
    "corner_coded_tiles",
    "corner_cubes",
    "corner_tiles",
    "crossed_wang_tiles",
    "decode",
    "dominoes",
    "encode",
    "shifted_wang_tiles",
    "summed_wang_tiles",
    "tile_set",
    "wang_cubes",
    "wang_tiles",
]
