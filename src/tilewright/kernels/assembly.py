"""Pictures put together from tiles: nothing but copies of rows."""

from tilewright.kernels.compiled import kernel


@kernel(parallel=True)
def copy_tiles(first, last, tiles, indices, top, left, size, pixel, out):
    """Fill a picture from tiles.

    tiles : uint8 (T, size, size * pixel), the bytes of every tile's rows.
    indices : int32 (rows, columns), tile of each cell; the picture starts ``top`` rows and ``left``
    columns of pixels inside the first cell.
    out : uint8 (h, w * pixel), filled.
    """
    width = out.shape[1] // pixel
    for i in range(first, last):
        cell_row, row = divmod(i + top, size)
        done = 0
        cell = 0
        column = left
        while done < width:
            count = min(size - column, width - done)
            source = tiles[indices[cell_row, cell], row, column * pixel : (column + count) * pixel]
            target = out[i, done * pixel : (done + count) * pixel]
            for k in range(count * pixel):
                target[k] = source[k]
            done += count
            cell += 1
            column = 0
