"""Where cells and points lie when that is more than the plane: meshes, surfaces, places on them."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
