"""Tone: colors that vary over more than a tile, kept out of the tiles and laid over them as noise.

A tile cannot hold what is larger than itself: tiles of different tone stand in squares, and tiles that all
have the mean tone make a plane without any. So tone is taken out of the photograph before tiles are cut, and
a field lays it over them again from a small picture of it (`tilewright.fields.tone`).
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, gaussian_filter

from tilewright.pixels import has_alpha
from tilewright.signals.textures.exemplar import Exemplar, Maps
from tilewright.signals.textures.kinds import to_encoded, to_linear

Texels = NDArray[np.float32]

SIGMA = 1 / 5
"""Standard deviation of the Gaussian of what is taken, in tiles."""
TEXELS = 16
"""Texels of tone along a tile: a Gaussian of an eighth of a tile needs no more."""
STRENGTH = 0.85
"""Share of tone that leaves the tiles; the rest stays with its things."""
LAID = 0.6
"""Standard deviation of the Gaussian of what is laid, over that of what is taken. What is laid comes from
elsewhere in the photograph than what stays, and of independent parts the powers add: where a Gaussian passes
a share g, so that 1 - 0.85 g stays, sqrt(1 - (1 - 0.85 g)^2) must be laid. A Gaussian of 0.6 of the width
passes that to within 0.06; laid as wide as it is taken, a fifth of the contrast of things of half a tile was
missing."""
ROWS = 64
"""Rows of a photograph that lose their tone at once, for memory."""
SPREAD = 4
"""Grid points along the shorter side of a photograph: a patch is half as wide as that."""


@dataclass(frozen=True, eq=False)
class Tone:
    """What is laid over tiles that lack it, and how.

    Attributes
    ----------
    tile_size : int
        Pixels along a tile.
    span : int
        Tiles from grid point to grid point.
    maps : dict of str to float32 array, shape (h, w, channels)
        For each map that has any, its tone around 0, in the map's numbers, or in sRGB from 0 to 1 for maps of
        float, which hold linear light; a texel is `texel` pixels wide.
    """

    tile_size: int
    span: int
    maps: dict[str, Texels]

    @property
    def texel(self) -> int:
        """Pixels along a texel; a tile is a whole number of them."""
        return texel_of(self.tile_size)


def texel_of(tile_size: int) -> int:
    """Pixels along a texel of tone: the largest that divide a tile and are at most a 16th of it."""
    return next(t for t in range(max(1, tile_size // TEXELS), 0, -1) if tile_size % t == 0)


def take_tone(exemplar: Exemplar, tile_size: int) -> tuple[Tone, Exemplar]:
    """Take the tone out of a photograph's maps of color.

    Parameters
    ----------
    exemplar : Exemplar
        One source.
    tile_size : int
        Pixels along a tile.

    Returns
    -------
    Tone
        What is to be laid over tiles of what is left.
    Exemplar
        What is left, of the same type.
    """
    (source,), (usable,) = exemplar.sources, exemplar.masks
    texel = texel_of(tile_size)
    tones: dict[str, Texels] = {}
    rest: Maps = {}
    for name, pixels in source.items():
        rest[name] = pixels
        if exemplar.kinds[name] == "color":
            total = _sum_blocks(encoded(pixels), usable, texel)
            taken, tones[name] = (
                _find_tone(total, texel, sigma * tile_size) for sigma in (SIGMA, LAID * SIGMA)
            )
            rest[name] = _without(taken, pixels, texel)
    side = min(usable.shape)
    span = max(1, round(side / SPREAD / tile_size))
    return Tone(tile_size, span, tones), Exemplar([rest], exemplar.masks, exemplar.weights, exemplar.kinds)


def take_more_tone(tone: Tone | None, exemplar: Exemplar) -> tuple[Tone | None, Exemplar]:
    """The same for further maps of a photograph whose tone has been taken; nothing where it was not.

    A map that replaces another leaves its own tone in place of that one's.
    """
    if tone is None:
        return None, exemplar
    taken, held = take_tone(exemplar, tone.tile_size)
    kept = {name: texels for name, texels in tone.maps.items() if name not in exemplar.kinds}
    return replace(tone, maps=kept | taken.maps), held


def _sum_blocks(pixels: NDArray[Any], usable: NDArray[np.bool_], texel: int) -> NDArray[np.float64]:
    """Sums over the usable pixels of every block of ``texel`` x ``texel``, and their number."""
    from tilewright.kernels.reduction import sum_usable_blocks

    rows, columns = (-(-n // texel) for n in pixels.shape[:2])
    total = np.zeros((rows, columns, pixels.shape[2] + 1))
    sum_usable_blocks(rows, pixels, usable, texel, total)
    return total


def _find_tone(total: NDArray[np.float64], texel: int, sigma: float) -> Texels:
    """Tone around 0 of a map's `_sum_blocks`, a texel for each; alpha has none."""
    spread = gaussian_filter(total, (sigma / texel, sigma / texel, 0), mode="reflect")
    known = spread[..., -1] > 1e-6 * texel**2
    nearest = distance_transform_edt(~known, return_distances=False, return_indices=True)
    spread = spread[tuple(nearest)]
    low = spread[..., :-1] / spread[..., -1:]
    mean = (low * total[..., -1:]).sum(axis=(0, 1)) / total[..., -1].sum()
    tone = low - mean
    if has_alpha(total.shape[2] - 1):
        tone[..., -1] = 0
    return tone.astype(np.float32)


def _without(texels: Texels, pixels: NDArray[Any], texel: int) -> NDArray[Any]:
    """Pixels less their tone, a few rows at a time."""
    rest = np.empty_like(pixels)
    texels = _enlarged(texels, texel, pixels.shape[0], 0)
    for top in range(0, len(rest), ROWS):
        rows = slice(top, top + ROWS)
        tone = _enlarged(texels[rows], texel, pixels.shape[1], 1)
        rest[rows] = _shifted(pixels[rows], -np.float32(STRENGTH) * tone)
    return rest


def _enlarged(texels: Texels, texel: int, count: int, axis: int) -> NDArray[np.float32]:
    """``count`` pixels along an axis, between the middles of texels, by linear interpolation."""
    at = (np.arange(count) + 0.5) / texel - 0.5
    first = np.floor(at).astype(int)
    share = (at - first).astype(np.float32).reshape((-1, 1, 1) if axis == 0 else (1, -1, 1))
    last = texels.shape[axis] - 1
    low, high = (np.take(texels, np.clip(n, 0, last), axis) for n in (first, first + 1))
    return np.asarray(low + share * (high - low), np.float32)


def encoded(pixels: NDArray[Any]) -> NDArray[Any]:
    """Numbers that tone is added to: sRGB, which linear light is turned into."""
    return to_encoded(pixels) if pixels.dtype.kind == "f" else pixels


def _shifted(pixels: NDArray[Any], by: NDArray[np.float32]) -> NDArray[Any]:
    """Pixels with something added to their encoded numbers, of the same type."""
    moved = encoded(pixels) + by
    if pixels.dtype.kind == "f":
        return to_linear(np.maximum(moved, 0))
    return np.clip(np.rint(moved), 0, np.iinfo(pixels.dtype).max).astype(pixels.dtype)
