"""Points by chance alone, and bits scrambled by chance."""

import numpy as np

from tilewright.kernels.chance import draw_unit, draw_word
from tilewright.kernels.compiled import kernel


@kernel()
def fill_units(key, first, out):
    """Numbers of [0, 1): out, float64 (n, d), row by row from the number ``first`` of the key on."""
    n, d = out.shape
    for i in range(n):
        for a in range(d):
            out[i, a] = draw_unit(key, first + i * d + a)


@kernel()
def scramble_words(key, words):
    """Owen's nested scrambling (1995) of 32-bit words, uint32 (n, d), in place.

    Each bit is turned over or not by chance, the same for all words of a column with the same higher bits.
    """
    n, d = words.shape
    for i in range(n):
        for a in range(d):
            word = np.uint64(words[i, a])
            flips = np.uint64(0)
            for bit in range(32):
                branch = word >> np.uint64(32 - bit)
                node = (np.uint64(32 * a + bit) << np.uint64(32)) | branch
                flips = (flips << np.uint64(1)) | (draw_word(key, node) & np.uint64(1))
            words[i, a] = np.uint32(word ^ flips)
