"""Tile-based synthesis: endless, non-repeating textures from Wang tiles and corner tiles.

The public names below load on first use, so that ``import tilewright`` stays fast and pulls in
neither numba nor scipy.
"""

from tilewright.lazy import load_lazily

__version__ = "0.1.0"

# public name -> module that defines it
_HOME = {
    "Cancelled": "errors",
    "TilewrightError": "errors",
    "TilewrightWarning": "errors",
    "TileSet": "tiles",
    "Shape": "tiles",
    "as_wang_tiles": "tiles",
    "cohen_tiles": "tiles",
    "column_corner_tiles": "tiles",
    "compact_corner_cubes": "tiles",
    "compact_wang_cubes": "tiles",
    "compact_wang_tiles": "tiles",
    "corner_coded_tiles": "tiles",
    "corner_cubes": "tiles",
    "corner_tiles": "tiles",
    "decode": "tiles",
    "dominoes": "tiles",
    "encode": "tiles",
    "shifted_wang_tiles": "tiles",
    "summed_wang_tiles": "tiles",
    "tile_set": "tiles",
    "wang_cubes": "tiles",
    "wang_tiles": "tiles",
    "ArrayTiling": "tilings",
    "Domain": "tilings",
    "LatticeHash": "tilings",
    "LongPeriodHash": "tilings",
    "MixerHash": "tilings",
    "Packing": "tilings",
    "PermutationHash": "tilings",
    "Tiling": "tilings",
    "array_tiling": "tilings",
    "density_tiling": "tilings",
    "direct": "tilings",
    "packing": "tilings",
    "scanline": "tilings",
    "stochastic": "tilings",
    "Exemplar": "signals.textures",
    "TextureTiles": "signals.textures",
    "find_regularity": "signals.textures",
    "resynthesize": "signals.textures",
    "synthesize": "signals.textures",
    "load": "files",
    "open_exemplar": "files",
    "read_image": "files",
    "save": "files",
    "texture_tiles": "files",
    "write_image": "files",
    "TextureField": "fields",
    "Report": "analysis",
    "analyze": "analysis",
    "make_atlas": "export",
    "save_array": "export",
    "save_atlas": "export",
    "save_viewer": "export",
}

__all__ = ["__version__", *_HOME]
__getattr__, __dir__ = load_lazily(__name__, _HOME)
