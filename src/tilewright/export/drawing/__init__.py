"""Tile sets, tilings, walls and puzzles as line drawings, SVG, and as pixels."""

from tilewright.export.drawing.cells import draw_cells, paint_cells
from tilewright.export.drawing.jigsaw import Jigsaw, draw_jigsaw
from tilewright.export.drawing.svg import save_svg
from tilewright.export.drawing.tiles import draw_tiles, draw_tiling, paint_tiles, paint_tiling
from tilewright.export.drawing.walls import draw_wall

__all__ = [
    "Jigsaw",
    "draw_cells",
    "draw_jigsaw",
    "draw_tiles",
    "draw_tiling",
    "draw_wall",
    "paint_cells",
    "paint_tiles",
    "paint_tiling",
    "save_svg",
]
