"""Whole jobs: what a person asks for, from what they bring to the files they get."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
