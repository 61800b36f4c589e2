"""Tile-based synthesis: endless, non-repeating textures from Wang tiles and corner tiles.

The public names below load on first use, so that ``import tilewright`` stays fast and pulls in
neither numba nor scipy.
"""

import lazy_loader

__version__ = "0.1.0"

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
