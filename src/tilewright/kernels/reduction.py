"""Sums over blocks of pixels and over pictures; numpy makes the same with large arrays in between."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel(parallel=True)
def average_blocks(first, last, image, step, out):
    """Means over blocks of ``step`` x ``step`` pixels, added up row by row.

    image : float32 (h, w, channels). out : float32 (h // step, w // step, channels), filled.
    """
    count = np.float32(step * step)
    for r in range(first, last):
        row = out[r]
        row[:] = np.float32(0)
        for i in range(r * step, (r + 1) * step):
            line = image[i]
            for c in range(row.shape[0]):
                for j in range(c * step, (c + 1) * step):
                    for k in range(row.shape[1]):
                        row[c, k] += line[j, k]
        for c in range(row.shape[0]):
            for k in range(row.shape[1]):
                row[c, k] /= count


@kernel(parallel=True)
def sum_usable_blocks(first, last, pixels, usable, step, out):
    """Sums of the usable pixels of blocks, and their number, which the last channel counts.

    pixels : (h, w, channels). usable : bool (h, w). out : float64 (rows, columns, channels + 1), 0 before;
    blocks at the south and east side may have fewer pixels.
    """
    height, width, channels = pixels.shape
    for r in range(first, last):
        for i in range(r * step, min((r + 1) * step, height)):
            for j in range(width):
                if usable[i, j]:
                    sums = out[r, j // step]
                    for k in range(channels):
                        sums[k] += np.float64(np.float32(pixels[i, j, k]))
                    sums[channels] += 1.0


@kernel()
def add_values(values, out):
    """Sums of the columns of float32 (n, channels), added to float64 (channels,) one by one."""
    for i in range(values.shape[0]):
        for k in range(values.shape[1]):
            out[k] += np.float64(values[i, k])


@kernel()
def add_squares(values, middle, out):
    """The same of squared distances to ``middle``, float64 (channels,)."""
    for i in range(values.shape[0]):
        for k in range(values.shape[1]):
            step = np.float64(values[i, k]) - middle[k]
            out[k] += step * step
