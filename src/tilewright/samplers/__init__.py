"""Point sets without tiles: Poisson disks by many methods, what they are compared with, and their radius."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
