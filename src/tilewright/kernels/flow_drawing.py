"""Dots and trails of particles, painted on a canvas of levels and hues."""

import numpy as np

from tilewright.kernels.compiled import kernel


@kernel()
def paint_dot(x, y, radius, level, hue, wraps, levels, hues):
    """A round dot with a soft edge; where a canvas is lighter already, it stays."""
    height, width = levels.shape
    reach = np.int64(np.ceil(radius + 0.5))
    left, top = np.int64(np.floor(x)), np.int64(np.floor(y))
    for row in range(top - reach, top + reach + 1):
        for column in range(left - reach, left + reach + 1):
            away = np.sqrt((column + 0.5 - x) ** 2 + (row + 0.5 - y) ** 2)
            shade = level * min(max(radius + 0.5 - away, 0.0), 1.0)
            if shade <= 0.0:
                continue
            if wraps:
                i, j = row % height, column % width
            elif row < 0 or row >= height or column < 0 or column >= width:
                continue
            else:
                i, j = row, column
            if shade > levels[i, j]:
                levels[i, j], hues[i, j] = shade, hue


@kernel()
def paint_line(x0, y0, x1, y1, radius, level, hue, wraps, levels, hues):
    """Dots half a pixel apart."""
    count = np.int64(np.ceil(2 * (abs(x1 - x0) + abs(y1 - y0)))) + 1
    for k in range(count + 1):
        t = k / count
        paint_dot(x0 + t * (x1 - x0), y0 + t * (y1 - y0), radius, level, hue, wraps, levels, hues)


@kernel()
def paint_dots(places, ways, colors, scale, radius, wraps, levels, hues):
    """Particles: places float32 (n, 2) in cells, where ways uint8 (n,) are below 4."""
    for i in range(ways.size):
        if ways[i] < 4:
            paint_dot(places[i, 0] * scale, places[i, 1] * scale, radius, 1.0, colors[i], wraps, levels, hues)


@kernel()
def paint_trails(before, after, ways_before, ways, colors, scale, radius, level, wraps, levels, hues):
    """From where particles were a frame ago to where they are, around a corner if they turned.

    Those that went farther than a cell in both directions leave no trail, since it is not known how.
    """
    height, width = levels.shape
    for i in range(ways.size):
        if ways_before[i] >= 4 or ways[i] >= 4:
            continue
        x1, y1 = after[i, 0] * scale, after[i, 1] * scale
        dx, dy = x1 - before[i, 0] * scale, y1 - before[i, 1] * scale
        if wraps:
            dx -= width * np.round(dx / width)
            dy -= height * np.round(dy / height)
        x0, y0, hue = x1 - dx, y1 - dy, colors[i]
        if abs(dx) < 0.01 or abs(dy) < 0.01:
            paint_line(x0, y0, x1, y1, radius, level, hue, wraps, levels, hues)
        elif (ways_before[i] ^ ways[i]) & 1 and min(abs(dx), abs(dy)) < scale:
            corner_x, corner_y = (x1, y0) if ways_before[i] & 1 else (x0, y1)
            paint_line(x0, y0, corner_x, corner_y, radius, level, hue, wraps, levels, hues)
            paint_line(corner_x, corner_y, x1, y1, radius, level, hue, wraps, levels, hues)
