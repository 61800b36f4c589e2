"""A field on a GPU, through wgpu (the extra ``gpu``); nothing here imports wgpu before a field is made."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
