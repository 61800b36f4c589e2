"""Texture tiles: pictures over a tile set, made from photographs."""

from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.regularity import Regularity, find_regularity
from tilewright.signals.textures.synthesis import METHODS, resynthesize, synthesize
from tilewright.signals.textures.texture_tiles import TextureTiles, copy_from_sources

__all__ = [
    "METHODS",
    "Exemplar",
    "Regularity",
    "TextureTiles",
    "copy_from_sources",
    "find_regularity",
    "resynthesize",
    "synthesize",
]
