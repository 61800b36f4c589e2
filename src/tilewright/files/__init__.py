"""Tile-set folders, and the pictures and points people bring."""

from tilewright.files.images import read_image, write_image
from tilewright.files.map_stack import find_maps
from tilewright.files.materials import add_maps, open_exemplar, texture_tiles
from tilewright.files.point_files import read_points, write_points
from tilewright.files.ready import ready_tiles
from tilewright.files.tileset_folder import load, load_points, load_texture, save

__all__ = [
    "add_maps",
    "find_maps",
    "load",
    "load_points",
    "load_texture",
    "open_exemplar",
    "read_image",
    "read_points",
    "ready_tiles",
    "save",
    "texture_tiles",
    "write_image",
    "write_points",
]
