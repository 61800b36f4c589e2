"""Tile-set folders, and the pictures people bring."""

from tilewright.files.images import read_image, write_image
from tilewright.files.materials import open_exemplar, texture_tiles
from tilewright.files.tileset_folder import load, save

__all__ = ["load", "open_exemplar", "read_image", "save", "texture_tiles", "write_image"]
