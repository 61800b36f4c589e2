"""Which variant of its tile lies in each cell."""

import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.lattice import finish_word, start_row


@kernel(parallel=True)
def choose_rows(first, last, x_low, runs, x_high, y, z, stream, seed, starts, thresholds, even, rows):
    """Replace the tile of each cell by the row of one of its variants, drawn by the mixer at the cell.

    x_low, runs, x_high : as in `color_row`. y : int64 (h,). z : int64.
    starts : int64 (T + 1,), thresholds : int64 (rows,), as in ``Variants``.
    even : int64, variants of every tile where all are drawn alike, else 0.
    rows : int32 (h, w), tiles, then rows.
    """
    for i in range(first, last):
        for k in range(x_high.size):
            a, b = start_row(stream, seed, z, x_high[k], y[i])
            for j in range(runs[k], runs[k + 1]):
                number = np.int64(finish_word(a, b, x_low[j]) >> np.uint32(8))
                tile = np.int64(rows[i, j])
                if even > 0:
                    rows[i, j] = tile * even + (number * even >> 24)
                    continue
                row, end = starts[tile], starts[tile + 1] - 1
                while row < end and number >= thresholds[row + 1]:
                    row += 1
                rows[i, j] = row
