"""Dappled tilings: no long runs of a tile along rows or columns (Kaji et al. 2016)."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
