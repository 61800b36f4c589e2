"""Walls drawn pixel by pixel: which brick lies where, how its surface looks, and in what light."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.kernels.compiled import kernel
from tilewright.kernels.lattice import finish_word, mix, start_row


class Noise(NamedTuple):
    """Lattices of gradient noise, an octave after the other, and where pixels lie between their points."""

    words: NDArray[np.uint32]
    """Random words of the lattice points of all octaves."""
    places: NDArray[np.int64]
    """(octaves, 2): where an octave begins in these, and its columns."""
    columns: NDArray[np.int32]
    """(octaves, w): lattice column west of each column of pixels."""
    until: NDArray[np.int32]
    """(octaves, w): the first pixel east of the next lattice column."""
    east: NDArray[np.float32]
    """(octaves, 2, w): how far east of its lattice column a pixel lies, 0 to 1, and the same eased."""
    rows: NDArray[np.int32]
    """(h, octaves): lattice row north of each row of pixels; (octaves,) for one row."""
    south: NDArray[np.float32]
    """(h, octaves, 2): as ``east``, along y; (octaves, 2) for one row."""
    weights: NDArray[np.float32]
    """(octaves, 3): how much an octave adds to edges, stains and sand."""


class Edges(NamedTuple):
    """Lengths of a wall in pixels, float32."""

    half_joint: np.float32
    """Half the width of the mortar."""
    bevel: np.float32
    """Over which a brick rises from its edge to its face."""
    rounding: np.float32
    """Radius of the corners of bricks."""
    wobble: np.float32
    """How far edges leave their line."""


class Finish(NamedTuple):
    """How noise becomes heights, colors and roughness, all float32; see signals/bricks/style.py."""

    ragged: np.float32
    joint: np.float32
    joint_edge: np.float32
    joint_sand: np.float32
    joint_hollow: np.float32
    pit_slope: np.float32
    pit_onset: np.float32
    pit_depth: np.float32
    face_sand: np.float32
    face_stain: np.float32
    rim: np.float32
    rim_edge: np.float32
    stain_middle: np.float32
    stain_contrast: np.float32
    smear_sand: np.float32
    smear_onset: np.float32
    smear_reach: np.float32
    smear_slope: np.float32
    clay_sand: np.float32
    clay_speck: np.float32
    clay_pit: np.float32
    clay_rim: np.float32
    clay_rise: np.float32
    lime: np.float32
    lime_sand: np.float32
    lime_stain: np.float32
    lime_speck: np.float32
    lime_hollow: np.float32
    rough_sand: np.float32
    grain: np.float32


class Surface(NamedTuple):
    """What is painted; of one row, without the first axis."""

    height: NDArray[np.float32]
    """(h, w), 0 to 1."""
    color: NDArray[np.uint8]
    """(h, w, 3), sRGB."""
    roughness: NDArray[np.uint8]
    """(h, w)"""
    joints: NDArray[np.uint8]
    """(h, w), 255 where mortar is."""


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

    key : uint32, what tells one brick's noise from another's. noise : `Noise` of the row. out : float32
    (3, w), filled from ``first`` to ``last``.
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
def paint_span(first, last, y, brick, inside, own, bed, noise, edges, finish, mortar, surface):
    """Paint pixels of one brick in a row; see `paint_bricks`.

    own, bed : float32 (3, w), noise of brick and mortar. noise, surface : of the row; surface is filled.
    """
    f, look = np.float32, finish
    height, color, roughness, joints = surface
    words, places, columns, _, east, rows, south, _ = noise
    lattice = words[places[0, 0] + rows[0] * places[0, 1] :]
    down = np.uint32(south[0, 0] * f(65536)) << np.uint32(16)
    half_joint, bevel, wobble, grain = edges.half_joint, edges.bevel, edges.wobble, look.grain
    middle = (brick[0] + brick[2]) * f(0.5)
    level = brick[4] + brick[6] * (y - (brick[1] + brick[3]) * f(0.5))
    slope, matt, smeared = brick[5], brick[7], brick[8]
    for j in range(first, last):
        edge, stain, sand = own[0, j], own[1, j], own[2, j] * grain
        edge_0, stain_0, sand_0 = bed[0, j], bed[1, j], bed[2, j] * grain
        # A pixel's own grain: the word of the lattice point before it, and where it lies from there.
        speck = mix(lattice[columns[0, j]] ^ np.uint32(east[0, 0, j] * f(65536)) ^ down)
        speck = (f(speck >> np.uint32(8)) * f(1 / 2**23) - f(1)) * grain
        worn = inside[j] + wobble * (edge + look.ragged * own[2, j])
        cover = clip_unit(worn + f(0.5))
        # Mortar: sandy and hollow between bricks. It knows no brick, but how far the next one is.
        hollow = ease_unit(-inside[j] / half_joint)
        joint = look.joint + look.joint_edge * edge_0 + look.joint_sand * sand_0 - look.joint_hollow * hollow
        # Brick: from a worn edge it rises to a face of its own height and tilt, which has pits.
        t = clip_unit(worn / bevel)
        rise = t * (f(2) - t)
        pit = ease_unit(sand * look.pit_slope - look.pit_onset)
        face = level + slope * (f(j) + f(0.5) - middle)
        face = face + look.face_sand * sand + look.face_stain * stain - look.pit_depth * pit
        rim = look.rim + look.rim_edge * edge
        height[j] = clip_unit(joint + (rim + (face - rim) * rise - joint) * cover)
        # Stains run from one color of the clay to the other; mortar is smeared over edges.
        second = ease_unit(look.stain_middle + look.stain_contrast * stain)
        lap = edge + look.smear_sand * sand - look.smear_onset - worn / bevel * look.smear_reach
        smear = smeared * ease_unit(lap * look.smear_slope)
        part = cover * (f(1) - smear)
        shade = f(1) + look.clay_sand * sand + look.clay_speck * speck - look.clay_pit * pit
        shade = shade * (look.clay_rim + look.clay_rise * rise)
        shade_0 = look.lime + look.lime_sand * sand_0 + look.lime_stain * stain_0
        shade_0 = shade_0 + look.lime_speck * speck + look.lime_hollow * hollow
        for c in range(3):
            clay = (brick[9 + c] + (brick[12 + c] - brick[9 + c]) * second) * shade
            lime = mortar[c] * shade_0
            color[j, c] = np.uint8(clip_unit(lime + (clay - lime) * part) * f(255) + f(0.5))
        rough = mortar[3] + (matt + look.rough_sand * sand - mortar[3]) * part
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
def paint_row(y, index, bricks, keys, noise, edges, finish, mortar, surface):
    """Paint a row of pixels, run by run of those that one brick holds; see `paint_bricks`."""
    w = index.size
    own, bed = np.empty((3, w), np.float32), np.zeros((3, w), np.float32)
    inside, ends = np.empty(w, np.float32), np.empty(w, np.int64)
    count = list_runs(index, ends)
    first = 0
    for r in range(count):
        k = index[first]
        measure_depths(first, ends[r], y, bricks[k], edges.rounding, inside)
        roughen_span(first, ends[r], keys[k], noise, own)
        first = ends[r]
    # Mortar is there where it can show through.
    reach = np.float32(2) * edges.wobble + np.float32(0.5)
    first = 0
    for j in range(w + 1):
        if j == w or inside[j] > reach:
            if first < j:
                roughen_span(first, j, np.uint32(0), noise, bed)
            first = j + 1
    first = 0
    for r in range(count):
        brick = bricks[index[first]]
        paint_span(first, ends[r], y, brick, inside, own, bed, noise, edges, finish, mortar, surface)
        first = ends[r]


@kernel(parallel=True)
def paint_bricks(first, last, index, bricks, keys, noise, edges, finish, mortar, surface):
    """Paint a window of a wall.

    index : int32 (h, w), the brick of each pixel. bricks : float32 (n, 15): west, north, east and south side
    in pixels; height of the middle of its face and the slopes along x and y; roughness; mortar smeared on
    it; two colors. keys : uint32 (n,), not 0: whose noise it has; mortar has 0.
    noise : `Noise`. edges : `Edges`. finish : `Finish`. mortar : float32 (4,), color and roughness.
    surface : `Surface`, filled.
    """
    words, places, columns, until, east, rows, south, weights = noise
    height, color, roughness, joints = surface
    for i in range(first, last):
        y = np.float32(i) + np.float32(0.5)
        near = Noise(words, places, columns, until, east, rows[i], south[i], weights)
        row = Surface(height[i], color[i], roughness[i], joints[i])
        paint_row(y, index[i], bricks, keys, near, edges, finish, mortar, row)


@kernel(parallel=True)
def fill_relief(first, last, height, depth, levels, out):
    """Heights as 16-bit levels, and normals of the surface, green up (OpenGL).

    height : float32 (h + 2, w + 2), 0 to 1, 1 being ``depth`` pixels; one pixel more lies around.
    levels : uint16 (h, w). out : uint8 (h, w, 3). Both are filled.
    """
    scale = np.float32(depth * 0.5)
    for i in range(first, last):
        for j in range(out.shape[1]):
            levels[i, j] = np.uint16(height[i + 1, j + 1] * np.float32(65535) + np.float32(0.5))
            x = (height[i + 1, j] - height[i + 1, j + 2]) * scale
            y = (height[i + 2, j + 1] - height[i, j + 1]) * scale
            length = np.float32(127.5) / np.float32(np.sqrt(x * x + y * y + np.float32(1)))
            out[i, j, 0] = np.uint8(x * length + np.float32(128))
            out[i, j, 1] = np.uint8(y * length + np.float32(128))
            out[i, j, 2] = np.uint8(length + np.float32(128))


@kernel(parallel=True)
def light_surface(first, last, height, normal, color, sun, path, ring, lights, linear, encoded, out):
    """A surface in sunlight, with the shadows it casts on itself, under a gray sky.

    height : float32 (h + 2m, w + 2m) in pixels; ``m`` more lie around. normal : uint8 (h, w, 3), green up.
    color : uint8 (h, w, 3). sun : float32 (4,), unit vector to it, x east, y south, z up; its rise per
    step of path : int64 (steps, 2), pixels (x, y) on the way to it. ring : int64 (n, 2), pixels around one
    that hide the sky from it. lights : float32 (2, 3), colors of sun and sky. linear : float32 (256,), light
    of encoded values; encoded : uint8, values of light from 0 to 1. out : uint8 (h, w, 3), filled.
    """
    m = (height.shape[0] - out.shape[0]) // 2
    f = np.float32
    for i in range(first, last):
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
