"""Flow: stored runs of particles over a tiling (Kaji et al. 2016, section 5)."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
