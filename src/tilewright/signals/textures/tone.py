"""Tone: what varies over more than a tile, kept out of the tiles and laid over them as noise.

A tile cannot hold what is larger than itself: tiles of different tone stand in squares, and tiles that all
have the mean tone make a plane without any. So tone is taken out of the photograph before tiles are cut, and
a field lays it over them again from a small picture of it (`tilewright.fields.tone`). Roughness and heights
have tone beside the colors', laid from the same places, as bright things may be high or smooth ones.

Over colors below the photograph's mean, tone is a factor; from the mean on it is an offset. As an offset
alone it would take more from dark pixels than they have, and turn them blue in a brown photograph.
"""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, gaussian_filter

from tilewright.pixels import has_alpha
from tilewright.signals.textures.exemplar import Exemplar, Maps
from tilewright.signals.textures.kinds import to_encoded, to_linear
from tilewright.signals.textures.sheet import ROWS, enlarged

Texels = NDArray[np.float32]

TONED = ("color", "roughness", "height")
"""Kinds of maps that have tone. Normals and other numbers, which may be names, keep what tiles hold."""
SIGMA = 1 / 5
"""Standard deviation of the Gaussian of what is taken, in tiles."""
TEXELS = 16
"""Texels of tone along a tile: a Gaussian of an eighth of a tile needs no more."""
STRENGTH = 0.85
"""Share of tone that leaves the tiles; the rest stays with its things."""
LEAST = 0.1
"""Share of the mean that is left where tone is darkest."""
LAID = 0.6
"""Standard deviation of the Gaussian of what is laid, over that of what is taken. What is laid comes from
elsewhere in the photograph than what stays, and of independent parts the powers add: where a Gaussian passes
a share g, so that 1 - 0.85 g stays, sqrt(1 - (1 - 0.85 g)^2) must be laid. A Gaussian of 0.6 of the width
passes that to within 0.06; laid as wide as it is taken, a fifth of the contrast of things of half a tile was
missing."""
TINY = np.float32(1e-6)
"""In place of a mean of 0, where that would divide."""
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
        For each map that has any, its tone around 0, in the map's numbers, or in sRGB from 0 to 1 for colors
        of float, which are linear light; a texel is `texel` pixels wide.
    means : dict of str to float32 array, shape (channels,)
        For each of these that is color, the mean below which tone is a factor, in the same numbers. Channels
        of mean 0, and maps without, take tone as an offset alone.
    """

    tile_size: int
    span: int
    maps: dict[str, Texels]
    means: dict[str, NDArray[np.float32]] = field(default_factory=dict)

    @property
    def texel(self) -> int:
        """Pixels along a texel; a tile is a whole number of them."""
        return texel_of(self.tile_size)

    def mean(self, map: str) -> NDArray[np.float32]:
        """The mean below which a map's tone is a factor, a number for each channel."""
        return self.means.get(map, np.zeros(self.maps[map].shape[2], np.float32))


def texel_of(tile_size: int) -> int:
    """Pixels along a texel of tone: the largest that divide a tile and are at most a 16th of it."""
    return next(t for t in range(max(1, tile_size // TEXELS), 0, -1) if tile_size % t == 0)


def take_tone(exemplar: Exemplar, tile_size: int) -> tuple[Tone, Exemplar]:
    """Take the tone out of a photograph's maps of the kinds in `TONED`.

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
    means: dict[str, NDArray[np.float32]] = {}
    rest: Maps = {}
    for name, pixels in source.items():
        rest[name], kind = pixels, exemplar.kinds[name]
        if kind not in TONED:
            continue
        total = _sum_blocks(encoded(pixels, kind), usable, texel)
        mean = _find_mean(total, kind)
        # A factor moves the mean by less than an offset does.
        share = _mean_share(pixels, kind, usable, mean)
        taken, tones[name] = (
            _find_tone(total, texel, sigma * tile_size) / share for sigma in (SIGMA, LAID * SIGMA)
        )
        rest[name] = _without(taken, mean, pixels, kind, texel)
        if kind == "color":
            means[name] = mean
    side = min(usable.shape)
    span = max(1, round(side / SPREAD / tile_size))
    return Tone(tile_size, span, tones, means), Exemplar(
        [rest], exemplar.masks, exemplar.weights, exemplar.kinds
    )


def take_more_tone(tone: Tone | None, exemplar: Exemplar) -> tuple[Tone | None, Exemplar]:
    """The same for further maps of a photograph whose tone has been taken; nothing where it was not.

    A map that replaces another leaves its own tone in place of that one's.
    """
    if tone is None:
        return None, exemplar
    taken, held = take_tone(exemplar, tone.tile_size)
    maps, means = (
        {name: values for name, values in old.items() if name not in exemplar.kinds} | new
        for old, new in ((tone.maps, taken.maps), (tone.means, taken.means))
    )
    return replace(tone, maps=maps, means=means), held


def _sum_blocks(pixels: NDArray[Any], usable: NDArray[np.bool_], texel: int) -> NDArray[np.float64]:
    """Sums over the usable pixels of every block of ``texel`` x ``texel``, and their number."""
    from tilewright.kernels.reduction import sum_usable_blocks

    rows, columns = (-(-n // texel) for n in pixels.shape[:2])
    total = np.zeros((rows, columns, pixels.shape[2] + 1))
    sum_usable_blocks(rows, pixels, usable, texel, total)
    return total


def _find_mean(total: NDArray[np.float64], kind: str) -> NDArray[np.float32]:
    """The mean of a map of color by its `_sum_blocks`; 0 for alpha and for other maps."""
    mean = total[..., :-1].sum(axis=(0, 1)) / total[..., -1].sum()
    if kind != "color":
        mean[:] = 0
    elif has_alpha(len(mean)):
        mean[-1] = 0
    return mean.astype(np.float32)


def _mean_share(
    pixels: NDArray[Any], kind: str, usable: NDArray[np.bool_], mean: NDArray[np.float32]
) -> NDArray[np.float32]:
    """How much of tone usable pixels take on average, for each channel."""
    taken = np.zeros(len(mean))
    for top in range(0, len(pixels), ROWS):
        rows = slice(top, top + ROWS)
        taken += share_of_tone(encoded(pixels[rows], kind), mean)[usable[rows]].sum(axis=0)
    return (taken / np.count_nonzero(usable)).astype(np.float32)


def share_of_tone(shown: NDArray[Any], mean: NDArray[np.float32]) -> NDArray[np.float32]:
    """How much of tone each value takes: as much as it has of the mean, and all from there on."""
    dark = (mean > 0) & (shown < mean)
    return np.where(dark, shown / np.maximum(mean, TINY), 1).astype(np.float32)


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


def _without(
    texels: Texels, mean: NDArray[np.float32], pixels: NDArray[Any], kind: str, texel: int
) -> NDArray[Any]:
    """Pixels less their tone, a few rows at a time: those that are the photograph's once it is laid again."""
    texels = np.where(mean > 0, np.maximum(texels, (LEAST - 1) / STRENGTH * mean), texels)
    rest = np.empty_like(pixels)
    texels = enlarged(texels, texel, pixels.shape[0], 0)
    for top in range(0, len(rest), ROWS):
        rows = slice(top, top + ROWS)
        tone = enlarged(texels[rows], texel, pixels.shape[1], 1)
        bare = _bare(encoded(pixels[rows], kind), np.float32(STRENGTH) * tone, mean)
        rest[rows] = _as_stored(bare, pixels, kind)
    return rest


def is_linear_light(pixels: NDArray[Any], kind: str) -> bool:
    """Whether pixels are light that sRGB does not encode yet."""
    return kind == "color" and pixels.dtype.kind == "f"


def encoded(pixels: NDArray[Any], kind: str) -> NDArray[Any]:
    """Numbers that tone is added to: sRGB, which linear light is turned into; below 0 there is no light."""
    return np.maximum(to_encoded(pixels), 0) if is_linear_light(pixels, kind) else pixels


def _bare(shown: NDArray[Any], tone: Texels, mean: NDArray[np.float32]) -> NDArray[np.float32]:
    """Values that are those shown once tone is laid over them."""
    toned_mean = mean + tone
    factor = mean / np.maximum(toned_mean, TINY)
    dark = (mean > 0) & (shown < toned_mean)
    return np.where(dark, shown * factor, shown - tone).astype(np.float32)


def _as_stored(shown: NDArray[np.float32], pixels: NDArray[Any], kind: str) -> NDArray[Any]:
    """Encoded numbers as a map stores them."""
    if is_linear_light(pixels, kind):
        return to_linear(np.maximum(shown, 0))
    if pixels.dtype.kind == "f":
        return shown
    return np.clip(np.rint(shown), 0, np.iinfo(pixels.dtype).max).astype(pixels.dtype)
