"""Tile-based synthesis: endless, non-repeating textures from Wang tiles and corner tiles.

The public names below load on first use, so that ``import tilewright`` stays fast and pulls in
neither numba nor scipy.
"""

from typing import Any

import lazy_loader

from tilewright import showing

__version__ = "0.1.0"

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def _paint(thing: Any) -> bytes | None:
    """The picture of a thing for notebooks, whose painters load with the first one."""
    png: bytes | None = __getattr__("paint_png")(thing)
    return png


showing.painter = _paint
showing.saver = lambda thing, folder: __getattr__("save")(thing, folder)
showing.loader = lambda folder: __getattr__("load")(folder)
