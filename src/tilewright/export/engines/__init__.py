"""Materials for engines: folders with textures, a shader in the engine's dialect, and a scene."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
