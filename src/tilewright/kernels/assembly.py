"""Pictures put together from tiles: nothing but copies of rows."""

import numba

from tilewright.kernels.compiled import kernel


@kernel(parallel=True)
def copy_tiles(tiles, indices, top, left, size, pixel, out):
    """Fill a picture from tiles.

    tiles : uint8 (T, size, size * pixel), the bytes of every tile's rows.
    indices : int32 (rows, columns), tile of each cell; the picture starts ``top`` rows and ``left``
    columns of pixels inside the first cell.
    out : uint8 (h, w * pixel), filled.
    """
    height, width = out.shape[0], out.shape[1] // pixel
    for i in numba.prange(height):
        cell_row, row = divmod(i + top, size)
        done = 0
        cell = 0
        column = left
        while done < width:
            count = min(size - column, width - done)
            tile = tiles[indices[cell_row, cell], row]
            out[i, done * pixel : (done + count) * pixel] = tile[column * pixel : (column + count) * pixel]
            done += count
            cell += 1
            column = 0
