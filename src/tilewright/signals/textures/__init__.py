"""Texture tiles: pictures over a tile set, made from photographs."""

from typing import TYPE_CHECKING

from tilewright.lazy import load_lazily

if TYPE_CHECKING:
    from tilewright.signals.textures.brick_style import BrickStyle
    from tilewright.signals.textures.brick_tiles import brick_texture_tiles
    from tilewright.signals.textures.exemplar import Exemplar
    from tilewright.signals.textures.regularity import Regularity, find_regularity
    from tilewright.signals.textures.synthesis import METHODS, resynthesize, synthesize
    from tilewright.signals.textures.texture_tiles import TextureTiles, copy_from_sources

# Synthesis needs SciPy; showing what was made does not.
_HOME = {
    "METHODS": "synthesis",
    "BrickStyle": "brick_style",
    "Exemplar": "exemplar",
    "Regularity": "regularity",
    "TextureTiles": "texture_tiles",
    "brick_texture_tiles": "brick_tiles",
    "copy_from_sources": "texture_tiles",
    "find_regularity": "regularity",
    "resynthesize": "synthesis",
    "synthesize": "synthesis",
}

__all__ = [
    "METHODS",
    "BrickStyle",
    "Exemplar",
    "Regularity",
    "TextureTiles",
    "brick_texture_tiles",
    "copy_from_sources",
    "find_regularity",
    "resynthesize",
    "synthesize",
]
__getattr__, __dir__ = load_lazily(__name__, _HOME)
