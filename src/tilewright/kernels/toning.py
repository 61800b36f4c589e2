"""Tone laid over pictures put together from tiles."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel(parallel=True)
def add_texels(first, last, texels, mean, texel, left, top, highest, out):
    """Add tone to a picture, interpolated between the middles of texels.

    texels : float32 (rows, columns, channels).
    mean : float32 (channels,), below which tone is a factor; 0 where it never is.
    left, top : pixels from the north-west corner of the first texel to that of the picture.
    highest : the largest value of an integer type; 0 of floats, which are not rounded.
    out : (h, w, channels), changed.
    """
    _, width, channels = out.shape
    scale, half = np.float32(1 / texel), np.float32(0.5)
    line = np.empty_like(texels[0])
    for i in range(first, last):
        at = (np.float32(i + top) + half) * scale - half
        row = int(at)
        share = at - np.float32(row)
        above, below = texels[row], texels[row + 1]
        for k in range(line.shape[0]):
            for c in range(channels):
                line[k, c] = above[k, c] + share * (below[k, c] - above[k, c])
        for j in range(width):
            at = (np.float32(j + left) + half) * scale - half
            column = int(at)
            share = at - np.float32(column)
            for c in range(channels):
                value = line[column, c] + share * (line[column + 1, c] - line[column, c])
                shown = np.float32(out[i, j, c])
                if mean[c] > 0 and shown < mean[c]:
                    value *= shown / mean[c]
                value += shown
                if highest > 0:
                    value = min(max(np.float32(np.floor(value + half)), np.float32(0)), np.float32(highest))
                out[i, j, c] = value
