"""Tile-based synthesis: endless, non-repeating textures from Wang tiles and corner tiles.

The public names below load on first use, so that ``import tilewright`` stays fast and pulls in
neither numba nor scipy.
"""

from importlib import import_module
from typing import Any

__version__ = "0.1.0"

# public name -> module that defines it
_HOME = {
    "Cancelled": "errors",
    "TilewrightError": "errors",
    "TileSet": "tiles",
    "corner_tiles": "tiles",
    "wang_tiles": "tiles",
    "TextureTiles": "signals.textures",
}

__all__ = ["__version__", *_HOME]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'tilewright' has no attribute {name!r}")
    value = getattr(import_module(f"tilewright.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
