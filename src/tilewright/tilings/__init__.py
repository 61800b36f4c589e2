"""Which tile goes where: direct, scanline and stored tilings, and the hashes behind them."""

from tilewright.tilings.density import DensityTiling, density_tiling
from tilewright.tilings.direct import DirectTiling, direct
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, LongPeriodHash, MixerHash, PermutationHash
from tilewright.tilings.packing import Packing, packing
from tilewright.tilings.scanline import scanline
from tilewright.tilings.stochastic import stochastic
from tilewright.tilings.tiling import ArrayTiling, Tiling, array_tiling, first_mismatch

__all__ = [
    "ArrayTiling",
    "DensityTiling",
    "DirectTiling",
    "Domain",
    "LatticeHash",
    "LongPeriodHash",
    "MixerHash",
    "Packing",
    "PermutationHash",
    "Tiling",
    "array_tiling",
    "density_tiling",
    "direct",
    "first_mismatch",
    "packing",
    "scanline",
    "stochastic",
]
