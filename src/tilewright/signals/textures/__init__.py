"""Texture tiles: pictures over a tile set, made from photographs."""

from tilewright.signals.textures.texture_tiles import TextureTiles, copy_from_sources

__all__ = ["TextureTiles", "copy_from_sources"]
