"""Pictures of triangles: which one is seen at every pixel, and where in it."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel(parallel=True)
def rasterize(first, last, corners, depths, numbers, weights):
    """At every pixel of some rows keep the triangle whose place at its middle is nearest to the eye.

    corners : float64 (T, 3, 3), of each triangle's corners x and y in pixels, y downwards, and height towards
    the eye. depths : float64 (rows, columns), the greatest height so far, -inf at first. numbers : int32
    (rows, columns), the triangle, left as it is where there is none. weights : float64 (rows, columns, 3), of
    its corners. Where two are as near, the first is kept.
    """
    columns = depths.shape[1]
    for t in range(corners.shape[0]):
        ax, ay, az = corners[t, 0]
        bx, by, bz = corners[t, 1]
        cx, cy, cz = corners[t, 2]
        top = max(first, np.int64(np.ceil(min(ay, by, cy) - 0.5)))
        bottom = min(last - 1, np.int64(np.floor(max(ay, by, cy) - 0.5)))
        doubled = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if top > bottom or doubled == 0:
            continue
        left = max(0, np.int64(np.ceil(min(ax, bx, cx) - 0.5)))
        right = min(columns - 1, np.int64(np.floor(max(ax, bx, cx) - 0.5)))
        for i in range(top, bottom + 1):
            y = i + 0.5
            for j in range(left, right + 1):
                x = j + 0.5
                a = ((bx - x) * (cy - y) - (cx - x) * (by - y)) / doubled
                b = ((cx - x) * (ay - y) - (ax - x) * (cy - y)) / doubled
                c = 1 - a - b
                if a >= 0 and b >= 0 and c >= -1e-12:
                    height = a * az + b * bz + c * cz
                    if height > depths[i, j]:
                        depths[i, j], numbers[i, j] = height, t
                        weights[i, j, 0], weights[i, j, 1], weights[i, j, 2] = a, b, c
