"""Which tile goes where: direct, scanline and stored tilings, and the hashes behind them."""

from tilewright.tilings.density import DensityTiling, density_tiling
from tilewright.tilings.direct import DirectTiling, direct
from tilewright.tilings.domain import Domain
from tilewright.tilings.filling import fill
from tilewright.tilings.hashes import LatticeHash, LongPeriodHash, MixerHash, PermutationHash
from tilewright.tilings.packing import Packing, packing
from tilewright.tilings.packing_search import (
    PackingSearch,
    count_packings,
    find_packing,
)
from tilewright.tilings.packing_symmetries import classify_packings
from tilewright.tilings.periods import periodic_tiling
from tilewright.tilings.recursive_packing import extend_packing, recursive_packing
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
    "PackingSearch",
    "PermutationHash",
    "Tiling",
    "array_tiling",
    "classify_packings",
    "count_packings",
    "density_tiling",
    "direct",
    "extend_packing",
    "fill",
    "find_packing",
    "first_mismatch",
    "packing",
    "periodic_tiling",
    "recursive_packing",
    "scanline",
    "stochastic",
]
