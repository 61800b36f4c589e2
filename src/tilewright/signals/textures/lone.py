"""Lone things: what pops out of a photograph and is seldom there, so that seeing it twice is seen at once."""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, label, maximum_filter

from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.kinds import to_lab
from tilewright.signals.textures.sheet import blur, sum_channels

SCALES = (1 / 64, 1 / 32, 1 / 16)
"""Sizes of things, in tiles: standard deviations of the inner of two Gaussians, the outer 4 times as wide."""
FLOOR = 0.25
"""Contrast in units of L*a*b* that is no contrast: even photographs have nothing that pops out."""
STANDING_OUT = (4.0, 4.0, 3.0)
"""Salience from which a thing of each size pops out, in standard deviations of what is usual: large ones are
seen from farther."""
LIKE = 0.75
"""Things of at least this share of a thing's salience are as good as it; one in a tile's area is too many."""
BODY = 0.45
"""Share of a thing's salience down to which pixels around its peak belong to it."""
RIM = 3
"""Pixels around a thing that go with it."""


def find_lone_things(
    lab: NDArray[np.float32], usable: NDArray[np.bool_], tile_size: int
) -> tuple[NDArray[np.bool_], list[tuple[int, int]]]:
    """Things that pop out and are seldom, of any of three sizes.

    Parameters
    ----------
    lab : float32 array, shape (h, w, channels)
        The photograph in numbers whose differences are what the eye sees, as CIE L*a*b*.
    usable : bool array, shape (h, w)
        Pixels that count.
    tile_size : int
        Pixels along a tile.

    Returns
    -------
    bool array, shape (h, w)
        Their pixels.
    list of (y, x)
        Where each pops out most.
    """
    lone, spots = np.zeros(usable.shape, bool), []
    for scale, least in zip(SCALES, STANDING_OUT, strict=True):
        offset = stand_out(lab, usable, scale * tile_size)
        body, found = _lone_of_a_size(offset, tile_size, least)
        lone |= body
        spots += [spot for spot in found if spot not in spots]
    return lone, spots


def stand_out(
    lab: NDArray[np.float32], usable: NDArray[np.bool_], sigma: float, floor: float = FLOOR
) -> NDArray[np.float32]:
    """How far every pixel is off what is usual, as a vector in robust standard deviations.

    Seen through a band of sizes around ``sigma`` pixels. Channels are made independent first: a gray flake
    among yellow needles is as light as they are, and yet like none of them. Vectors are as long as the root
    of the mean square of their parts.
    """
    band = blur(lab, sigma) - blur(lab, 4 * sigma)
    middle = np.median(band[usable], axis=0)
    band -= middle
    # Step 1: the axes along which colors vary apart from each other.
    seen = [plane[usable].astype(np.float64) for plane in np.moveaxis(band, 2, 0)]
    covariance = [[(a * b).mean() for b in seen] for a in seen]
    _, axes = np.linalg.eigh(np.array(covariance))
    offset = np.stack([sum_channels(band * axis) for axis in axes.T.astype(np.float32)], axis=2)
    # Step 2: what is usual along each of them.
    spread = 1.48 * np.median(np.abs(offset[usable]), axis=0) + floor
    offset /= spread * np.sqrt(np.float32(lab.shape[2]))
    offset[~usable] = 0
    return np.asarray(offset, np.float32)


def _lone_of_a_size(
    offset: NDArray[np.float32], tile_size: int, least: float
) -> tuple[NDArray[np.bool_], list[tuple[int, int]]]:
    """A thing is seldom where at most as many are like it as a photograph of this size has tiles.

    Those are like it that go as far as it does in the direction in which it is off what is usual.
    """
    reach, half = max(1, round(tile_size / 10)), tile_size // 2
    salience = np.sqrt(sum_channels(offset**2))
    peaks = np.argwhere((salience == maximum_filter(salience, 2 * reach + 1)) & (salience > 0))
    vectors = offset[tuple(peaks.T)]
    most = salience.size / tile_size**2
    lone, spots = np.zeros(salience.shape, bool), []
    for y, x in peaks.tolist():
        height = salience[y, x]
        if height < least or (vectors @ offset[y, x] >= LIKE * height**2).sum() > most:
            continue
        top, left = max(0, y - half), max(0, x - half)
        parts, _ = label(salience[top : y + half + 1, left : x + half + 1] > BODY * height)
        lone[top : y + half + 1, left : x + half + 1] |= parts == parts[y - top, x - left]
        spots.append((y, x))
    return binary_dilation(lone, iterations=RIM) if spots else lone, spots


def lone_things_of(
    exemplar: Exemplar, tile_size: int
) -> tuple[list[NDArray[np.bool_]], list[tuple[int, int, int]]]:
    """Pixels of lone things in the main map of each source, and their places (source, y, x)."""
    masks, spots = [], []
    name = next(iter(exemplar.kinds))
    for number, (maps, usable) in enumerate(zip(exemplar.sources, exemplar.masks, strict=True)):
        lab = to_lab(maps[name], exemplar.kinds[name])
        mask, found = find_lone_things(lab, usable, tile_size)
        masks.append(mask)
        spots += [(number, y, x) for y, x in found]
    return masks, spots
