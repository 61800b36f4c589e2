"""Which tile goes where: direct, scanline and stored tilings, and the hashes behind them."""

from tilewright.tilings.direct import DirectTiling, direct
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, LongPeriodHash, MixerHash, PermutationHash
from tilewright.tilings.scanline import scanline
from tilewright.tilings.tiling import ArrayTiling, Tiling, array_tiling, first_mismatch

__all__ = [
    "ArrayTiling",
    "DirectTiling",
    "Domain",
    "LatticeHash",
    "LongPeriodHash",
    "MixerHash",
    "PermutationHash",
    "Tiling",
    "array_tiling",
    "direct",
    "first_mismatch",
    "scanline",
]
