"""Bytes for other programs: the viewer page, texture arrays, packed atlases, folders for engines."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
