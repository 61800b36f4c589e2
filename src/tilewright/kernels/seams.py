"""The energy of laying one patch over a patchwork, and the patchwork after the cut.

A patchwork is a grid of origins in a sheet of features. Between neighboring pixels p and q, whatever
their origins, the seam cost is (Kwatra et al. 2003, eq. 1, squared and for any two origins)

    |F(p) - (q's source continued back to p)|^2 + |(p's source continued to q) - F(q)|^2

which is 0 where the two origins continue each other.
"""

import numpy as np

from tilewright.kernels.compiled import kernel

FORCED_OLD, OPEN, FORCED_NEW = 0, 1, 2
STEPS = ((0, 1), (1, 0))


@kernel()
def feature_distance(sheet, y0, x0, y1, x1):
    """Squared distance of two sheet pixels; coordinates outside are moved to the border."""
    rows, columns, channels = sheet.shape
    y0 = min(max(y0, 0), rows - 1)
    y1 = min(max(y1, 0), rows - 1)
    x0 = min(max(x0, 0), columns - 1)
    x1 = min(max(x1, 0), columns - 1)
    total = np.float32(0)
    for c in range(channels):
        difference = sheet[y0, x0, c] - sheet[y1, x1, c]
        total += difference * difference
    return total


@kernel()
def seam_cost(sheet, py, px, qy, qx, dy, dx):
    """Cost of origins p = (py, px) and q = (qy, qx) on neighboring pixels, q at p + (dy, dx)."""
    if qy - py == dy and qx - px == dx:
        return np.float32(0)
    return feature_distance(sheet, py, px, qy - dy, qx - dx) + feature_distance(
        sheet, py + dy, px + dx, qy, qx
    )


@kernel()
def measure_overlap(sheet, origin_y, origin_x, shift_y, shift_x, out):
    """Fill ``out`` with the squared distance of old and new content."""
    height, width = origin_y.shape
    for i in range(height):
        for j in range(width):
            if origin_y[i, j] < 0:
                out[i, j] = 0
            else:
                out[i, j] = feature_distance(sheet, origin_y[i, j], origin_x[i, j], i + shift_y, j + shift_x)


@kernel()
def fill_grid(sheet, origin_y, origin_x, shift_y, shift_x, state, weight, context, scale, capacity, terminal):
    """Write the energy of "old or new at each open pixel" as a grid for `cut_grid`.

    origin_y, origin_x : int32 (h, w), the patchwork; negative where nothing lies yet.
    shift_y, shift_x : the new patch shows sheet pixel (i + shift_y, j + shift_x) at (i, j).
    state : uint8 (h, w), whether a pixel must stay old, may choose, or must become new.
    weight : float32 (h, w), what a seam at a pixel counts; context : float32 (h, w), added to it.
    scale : float, from cost to integer capacity.
    capacity : int32 (4, (h + 2) * (w + 2)) and terminal : int32 ((h + 2) * (w + 2)), zeros, filled.
    """
    height, width = state.shape
    stride = width + 2
    for i in range(height):
        for j in range(width):
            for axis in range(2):
                dy, dx = STEPS[axis]
                k, l = i + dy, j + dx
                if k >= height or l >= width:
                    continue
                if state[i, j] != OPEN and state[k, l] != OPEN:
                    continue
                if origin_y[i, j] < 0 or origin_y[k, l] < 0:
                    continue
                py, px, qy, qx = origin_y[i, j], origin_x[i, j], origin_y[k, l], origin_x[k, l]
                ny, nx = i + shift_y, j + shift_x
                around = context[i, j] + context[k, l]
                factor = np.float32(0.5) * (weight[i, j] + weight[k, l]) * scale
                old_new = seam_cost(sheet, py, px, ny + dy, nx + dx, dy, dx) * (1 + around) * factor
                new_old = seam_cost(sheet, ny, nx, qy, qx, dy, dx) * (1 + around) * factor
                old_old = min(seam_cost(sheet, py, px, qy, qx, dy, dx) * factor, old_new + new_old)
                p = (i + 1) * stride + j + 1
                q = (k + 1) * stride + l + 1
                if state[i, j] == OPEN and state[k, l] == OPEN:
                    # E(old, old) is moved to the terminals, half to each pixel, so that two
                    # non-negative capacities remain.
                    half = np.int32(round(old_old * 0.5))
                    forth = np.int32(round(old_new)) - half
                    back = np.int32(round(new_old)) - half
                    terminal[p] -= half
                    terminal[q] -= half
                    if forth < 0:
                        terminal[q] += forth
                        terminal[p] -= forth
                        back += forth
                        forth = 0
                    elif back < 0:
                        terminal[p] += back
                        terminal[q] -= back
                        forth += back
                        back = 0
                    capacity[axis, p] = forth
                    capacity[axis + 2, q] = max(back, 0)
                elif state[i, j] == OPEN:
                    if state[k, l] == FORCED_NEW:
                        terminal[p] -= np.int32(round(old_new))
                    else:
                        terminal[p] += np.int32(round(new_old)) - np.int32(round(old_old))
                else:
                    if state[i, j] == FORCED_NEW:
                        terminal[q] -= np.int32(round(new_old))
                    else:
                        terminal[q] += np.int32(round(old_new)) - np.int32(round(old_old))


@kernel()
def sum_seams(sheet, origin_y, origin_x, shift_y, shift_x, in_new, weight, context):
    """Energy of the patchwork with the new patch laid where ``in_new`` is 1."""
    height, width = origin_y.shape
    total = 0.0
    for i in range(height):
        for j in range(width):
            for axis in range(2):
                dy, dx = STEPS[axis]
                k, l = i + dy, j + dx
                if k >= height or l >= width:
                    continue
                if (in_new[i, j] and in_new[k, l]) or origin_y[i, j] < 0 or origin_y[k, l] < 0:
                    continue
                py, px, qy, qx = origin_y[i, j], origin_x[i, j], origin_y[k, l], origin_x[k, l]
                around = np.float32(0)
                if in_new[i, j]:
                    py, px = i + shift_y, j + shift_x
                    around = context[i, j] + context[k, l]
                elif in_new[k, l]:
                    qy, qx = k + shift_y, l + shift_x
                    around = context[i, j] + context[k, l]
                cost = seam_cost(sheet, py, px, qy, qx, dy, dx) * (1 + around)
                total += cost * 0.5 * (weight[i, j] + weight[k, l])
    return total
