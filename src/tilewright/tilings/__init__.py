"""Which tile goes where: direct, scanline and stored tilings, and the hashes behind them."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
