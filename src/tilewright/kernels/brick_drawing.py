"""Walls drawn pixel by pixel: which brick lies where, how its surface looks, and in what light."""

import numba
import numpy as np

from tilewright.kernels.compiled import kernel
from tilewright.kernels.lattice import finish_word, mix, start_row


@kernel()
def fill_lattice_words(x_low, runs, x_high, y, z, stream, seed, out):
    """The hash of every lattice point of the grid ``y`` x ``x`` at depth ``z``.

    x_low, runs, x_high : as in `color_row`. y : int64 (h,). out : uint32 (h, w), filled.
    """
    for i in range(y.size):
        for k in range(x_high.size):
            a, b = start_row(stream, seed, z, x_high[k], y[i])
            # Slices count from 0, which lets the loop be vectorized.
            low, row = x_low[runs[k] : runs[k + 1]], out[i, runs[k] : runs[k + 1]]
            for j in range(row.size):
                row[j] = finish_word(a, b, low[j])


@kernel()
def fill_rectangles(rectangles, out):
    """Number the pixels that each of several rectangles covers.

    rectangles : int64 (n, 4), west, north, east and south sides in pixels of ``out``, which they may leave;
    they do not overlap. out : int32 (h, w), filled where a rectangle lies.
    """
    height, width = out.shape
    for k in range(len(rectangles)):
        west, north, east, south = rectangles[k]
        out[max(north, 0) : max(min(south, height), 0), max(west, 0) : max(min(east, width), 0)] = k


@kernel()
def read_slope(word, shift):
    """A slope along x and y, each -1 to 1, from ten bits of a word."""
    step, five = np.float32(1 / 15.5), np.uint32(31)
    x = np.float32((word >> np.uint32(shift)) & five) * step - np.float32(1)
    return x, np.float32((word >> np.uint32(shift + 5)) & five) * step - np.float32(1)


@kernel()
def blend_column(north, south, shift, dy, ease_y, weight):
    """Gradient noise along a row near a column of lattice points: value at the column, change per step."""
    x, y = read_slope(north, shift)
    u, v = read_slope(south, shift)
    at = y * dy
    return (at + (v * (dy - np.float32(1)) - at) * ease_y) * weight, (x + (u - x) * ease_y) * weight


@kernel()
def roughen_span(first, last, key, noise, out):
    """Gradient noise (Perlin 1985, 2002) of pixels ``first`` up to ``last`` of a row: three sums of octaves.

    key : uint32, what tells one brick's noise from another's. noise : words : uint32, the lattice points of
    all octaves; places : int64 (octaves, 2), where an octave begins there, and its columns.
    columns, until : int32 (octaves, w), lattice column west of each pixel, and the first pixel of the next.
    east : float32 (octaves, 2, w), how far east of it the pixel lies, 0 to 1, and the same eased.
    rows, south : (octaves,), (octaves, 2), the same for this row. weights : float32 (octaves, 3).
    out : float32 (3, w), filled from ``first`` to ``last``.
    """
    words, places, columns, until, east, rows, south, weights = noise
    out[:, first:last] = 0
    one = np.float32(1)
    for o in range(len(places)):
        above = places[o, 0] + rows[o] * places[o, 1]
        below = above + places[o, 1]
        dy, ey = south[o]
        w0, w1, w2 = weights[o]
        j = first
        while j < last:
            # The pixels between two columns of lattice points share much.
            stop = min(until[o, j], last)
            west, next_west = above + columns[o, j], below + columns[o, j]
            p, q = mix(words[west] ^ key), mix(words[next_west] ^ key)
            a0, b0 = blend_column(p, q, 0, dy, ey, w0)
            a1, b1 = blend_column(p, q, 10, dy, ey, w1)
            a2, b2 = blend_column(p, q, 20, dy, ey, w2)
            p, q = mix(words[west + 1] ^ key), mix(words[next_west + 1] ^ key)
            c0, d0 = blend_column(p, q, 0, dy, ey, w0)
            c1, d1 = blend_column(p, q, 10, dy, ey, w1)
            c2, d2 = blend_column(p, q, 20, dy, ey, w2)
            for i in range(j, stop):
                f, t = east[o, 0, i], east[o, 1, i]
                g = f - one
                v = a0 + b0 * f
                out[0, i] += v + (c0 + d0 * g - v) * t
                v = a1 + b1 * f
                out[1, i] += v + (c1 + d1 * g - v) * t
                v = a2 + b2 * f
                out[2, i] += v + (c2 + d2 * g - v) * t
            j = stop


@kernel()
def clip_unit(value):
    """A number brought into 0 to 1."""
    return min(max(value, np.float32(0)), np.float32(1))


@kernel()
def ease_unit(value):
    """0 to 1, level at both ends; beyond them it stays."""
    t = clip_unit(value)
    return t * t * (np.float32(3) - np.float32(2) * t)


@kernel()
def measure_depths(first, last, y, sides, rounding, out):
    """Pixels from those of a row to the rim of a brick with round corners; negative outside.

    sides : float32, west, north, east and south. out : float32 (w,), filled from ``first`` to ``last``.
    """
    half, zero = np.float32(0.5), np.float32(0)
    middle, reach = (sides[0] + sides[2]) * half, (sides[2] - sides[0]) * half - rounding
    far_y = abs(y - (sides[1] + sides[3]) * half) - (sides[3] - sides[1]) * half + rounding
    over_y = max(far_y, zero)
    for j in range(first, last):
        far_x = abs(np.float32(j) + half - middle) - reach
        over_x = max(far_x, zero)
        rim = rounding - np.float32(np.sqrt(over_x * over_x + over_y * over_y))
        out[j] = rim - min(max(far_x, far_y), zero)


@kernel()
def paint_span(first, last, y, brick, inside, own, bed, noise, look, mortar, surface):
    """Paint pixels of one brick in a row; see `paint_bricks`.

    own, bed : float32 (3, w), noise of brick and mortar. surface : rows of what is painted, filled.
    """
    f = np.float32
    height, color, roughness, joints = surface
    words, places, columns, _, east, rows, south, _ = noise
    lattice = words[places[0, 0] + rows[0] * places[0, 1] :]
    down = np.uint32(south[0, 0] * f(65536)) << np.uint32(16)
    half_joint, bevel, wobble, grain = look[0], look[1], look[3], look[4]
    middle = (brick[0] + brick[2]) * f(0.5)
    level = brick[4] + brick[6] * (y - (brick[1] + brick[3]) * f(0.5))
    slope, matt, smeared = brick[5], brick[7], brick[8]
    for j in range(first, last):
        edge, stain, sand = own[0, j], own[1, j], own[2, j] * grain
        edge_0, stain_0, sand_0 = bed[0, j], bed[1, j], bed[2, j] * grain
        # A pixel's own grain: the word of the lattice point before it, and where it lies from there.
        speck = mix(lattice[columns[0, j]] ^ np.uint32(east[0, 0, j] * f(65536)) ^ down)
        speck = (f(speck >> np.uint32(8)) * f(1 / 2**23) - f(1)) * grain
        worn = inside[j] + wobble * (edge + f(0.35) * own[2, j])
        cover = clip_unit(worn + f(0.5))
        # Mortar: sandy and hollow between bricks. It knows no brick, but how far the next one is.
        hollow = ease_unit(-inside[j] / half_joint)
        joint = f(0.30) + f(0.10) * edge_0 + f(0.16) * sand_0 - f(0.12) * hollow
        # Brick: from a worn edge it rises to a face of its own height and tilt, which has pits.
        t = clip_unit(worn / bevel)
        rise = t * (f(2) - t)
        pit = ease_unit(sand * f(3) - f(1.65))
        face = level + slope * (f(j) + f(0.5) - middle) + f(0.07) * sand + f(0.05) * stain - f(0.16) * pit
        rim = f(0.50) + f(0.10) * edge
        height[j] = clip_unit(joint + (rim + (face - rim) * rise - joint) * cover)
        # Stains run from one color of the clay to the other; mortar is smeared over edges.
        second = ease_unit(f(0.5) + f(0.9) * stain)
        smear = smeared * ease_unit((edge + f(0.5) * sand - f(0.05) - worn / bevel * f(0.45)) * f(1.6))
        part = cover * (f(1) - smear)
        shade = (f(1) + f(0.14) * sand + f(0.05) * speck - f(0.35) * pit) * (f(0.9) + f(0.1) * rise)
        shade_0 = f(0.80) + f(0.20) * sand_0 + f(0.10) * stain_0 + f(0.08) * speck + f(0.20) * hollow
        for c in range(3):
            clay = (brick[9 + c] + (brick[12 + c] - brick[9 + c]) * second) * shade
            lime = mortar[c] * shade_0
            color[j, c] = np.uint8(clip_unit(lime + (clay - lime) * part) * f(255) + f(0.5))
        rough = mortar[3] + (matt + f(0.06) * sand - mortar[3]) * part
        roughness[j] = np.uint8(clip_unit(rough) * f(255) + f(0.5))
        joints[j] = np.uint8(255) if worn <= f(0) else np.uint8(0)


@kernel()
def list_runs(row, ends):
    """How many runs of equal numbers a row has; where each ends is filled in."""
    count = 0
    for j in range(1, row.size + 1):
        if j == row.size or row[j] != row[j - 1]:
            ends[count] = j
            count += 1
    return count


@kernel()
def paint_row(y, index, bricks, keys, noise, look, mortar, surface):
    """Paint a row of pixels, run by run of those that one brick holds; see `paint_bricks`."""
    w = index.size
    own, bed = np.empty((3, w), np.float32), np.zeros((3, w), np.float32)
    inside, ends = np.empty(w, np.float32), np.empty(w, np.int32)
    count = list_runs(index, ends)
    first = 0
    for r in range(count):
        k = index[first]
        measure_depths(first, ends[r], y, bricks[k], look[2], inside)
        roughen_span(first, ends[r], keys[k], noise, own)
        first = ends[r]
    # Mortar is there where it can show through.
    reach = np.float32(2) * look[3] + np.float32(0.5)
    first = 0
    for j in range(w + 1):
        if j == w or inside[j] > reach:
            if first < j:
                roughen_span(first, j, np.uint32(0), noise, bed)
            first = j + 1
    first = 0
    for r in range(count):
        paint_span(first, ends[r], y, bricks[index[first]], inside, own, bed, noise, look, mortar, surface)
        first = ends[r]


@kernel(parallel=True)
def paint_bricks(
    index, bricks, keys, words, places, columns, until, east, rows, south, weights, look, mortar,
    height, color, roughness, joints,
):  # fmt: skip
    """Paint a window of a wall.

    index : int32 (h, w), the brick of each pixel. bricks : float32 (n, 15): west, north, east and south side
    in pixels; height of the middle of its face and the slopes along x and y; roughness; mortar smeared on
    it; two colors. keys : uint32 (n,), not 0: whose noise it has; mortar has 0.
    words to weights : as in `roughen_span`, rows and south with a row for each row of pixels.
    look : half the mortar, bevel, rounding and wobble of edges in pixels, grain. mortar : color, roughness.
    height : float32 (h, w), 0 to 1. color : uint8 (h, w, 3). roughness : uint8 (h, w). joints : uint8 (h, w),
    255 where mortar is. All four are filled.
    """
    for i in numba.prange(len(index)):
        y = np.float32(i) + np.float32(0.5)
        noise = words, places, columns, until, east, rows[i], south[i], weights
        surface = height[i], color[i], roughness[i], joints[i]
        paint_row(y, index[i], bricks, keys, noise, look, mortar, surface)


@kernel(parallel=True)
def fill_relief(height, depth, levels, out):
    """Heights as 16-bit levels, and normals of the surface, green up (OpenGL).

    height : float32 (h + 2, w + 2), 0 to 1, 1 being ``depth`` pixels; one pixel more lies around.
    levels : uint16 (h, w). out : uint8 (h, w, 3). Both are filled.
    """
    scale = np.float32(depth * 0.5)
    for i in numba.prange(out.shape[0]):
        for j in range(out.shape[1]):
            levels[i, j] = np.uint16(height[i + 1, j + 1] * np.float32(65535) + np.float32(0.5))
            x = (height[i + 1, j] - height[i + 1, j + 2]) * scale
            y = (height[i + 2, j + 1] - height[i, j + 1]) * scale
            length = np.float32(127.5) / np.float32(np.sqrt(x * x + y * y + np.float32(1)))
            out[i, j, 0] = np.uint8(x * length + np.float32(128))
            out[i, j, 1] = np.uint8(y * length + np.float32(128))
            out[i, j, 2] = np.uint8(length + np.float32(128))


@kernel(parallel=True)
def light_surface(height, normal, color, sun, path, ring, lights, linear, encoded, out):
    """A surface in sunlight, with the shadows it casts on itself, under a gray sky.

    height : float32 (h + 2m, w + 2m) in pixels; ``m`` more lie around. normal : uint8 (h, w, 3), green up.
    color : uint8 (h, w, 3). sun : float32 (4,), unit vector to it, x east, y south, z up; its rise per
    step of path : int64 (steps, 2), pixels (x, y) on the way to it. ring : int64 (n, 2), pixels around one
    that hide the sky from it. lights : float32 (2, 3), colors of sun and sky. linear : float32 (256,), light
    of encoded values; encoded : uint8, values of light from 0 to 1. out : uint8 (h, w, 3), filled.
    """
    m = (height.shape[0] - out.shape[0]) // 2
    f = np.float32
    for i in numba.prange(out.shape[0]):
        for j in range(out.shape[1]):
            here = height[i + m, j + m]
            hidden = f(0)
            for k in range(len(path)):
                over = height[i + m + path[k, 1], j + m + path[k, 0]] - here - sun[3] * f(k + 1)
                hidden = max(hidden, over)
            x, y = f(normal[i, j, 0]) - f(127.5), f(127.5) - f(normal[i, j, 1])
            facing = (x * sun[0] + y * sun[1] + (f(normal[i, j, 2]) - f(127.5)) * sun[2]) * f(1 / 127.5)
            bright = clip_unit(facing) * (f(1) - clip_unit(hidden * f(1.5)))
            walls = f(0)
            for k in range(len(ring)):
                walls += max(height[i + m + ring[k, 1], j + m + ring[k, 0]] - here, f(0))
            open_sky = f(1) - clip_unit(f(0.16) * walls / f(len(ring)))
            for c in range(3):
                light = linear[color[i, j, c]] * (lights[0, c] * bright + lights[1, c] * open_sky)
                out[i, j, c] = encoded[int(clip_unit(light) * f(len(encoded) - 1) + f(0.5))]
