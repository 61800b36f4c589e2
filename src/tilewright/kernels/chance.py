"""Numbers by chance, counted rather than remembered: the n-th number of a key is a function of both."""

import numpy as np

from tilewright.kernels.compiled import kernel

_GOLDEN = np.uint64(0x9E3779B97F4A7C15)
_M1 = np.uint64(0xBF58476D1CE4E5B9)
_M2 = np.uint64(0x94D049BB133111EB)


@kernel(inline=True)
def draw_word(key, counter):
    """64 bits: SplitMix64 (Steele, Lea & Flood 2014) at step ``counter`` from a mixed ``key``."""
    z = np.uint64(key * _M2 + (np.uint64(counter) + np.uint64(1)) * _GOLDEN)
    z = np.uint64((z ^ (z >> np.uint64(30))) * _M1)
    z = np.uint64((z ^ (z >> np.uint64(27))) * _M2)
    return np.uint64(z ^ (z >> np.uint64(31)))


@kernel(inline=True)
def draw_unit(key, counter):
    """A number of [0, 1), 53 bits."""
    return np.float64(draw_word(key, counter) >> np.uint64(11)) * (1.0 / 9007199254740992.0)
