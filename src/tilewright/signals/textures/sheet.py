"""All sources of an exemplar on one sheet of features, the coordinates synthesis works in."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter, uniform_filter

from tilewright.pixels import has_alpha, white
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.kinds import to_lab

MOST_FEATURES = 4
"""Numbers by which pixels are compared."""
GRAIN = 1 / 64
"""Standard deviation of the Gaussian in which grain is not seen, in tiles."""
SMOOTH = 4.0
"""Variances up to which contrast is grain, over the median of the photograph's."""
COARSE = 4
"""Pixels of a Gaussian's standard deviation that are enough to find a guided filter by."""
ROWS = 64
"""Rows that are worked on at once, for memory."""
FLAT = 0.01
"""Contrast that is none, in standard deviations of the photograph: drawings are flat nearly everywhere."""


@dataclass(frozen=True, eq=False)
class Sheet:
    """Sources stacked from top to bottom, with the features that are compared.

    Attributes
    ----------
    features : float32 array, shape (rows, columns, k)
        What is seen of all maps, scaled so that variances add up to 1; of more than `MOST_FEATURES` channels
        their strongest principal components.
    usable : bool array, shape (rows, columns)
        Pixels that may be copied.
    tops : tuple of int
        First row of each source.
    sizes : tuple of (height, width)
        Size of each source.
    """

    features: NDArray[np.float32]
    usable: NDArray[np.bool_]
    tops: tuple[int, ...]
    sizes: tuple[tuple[int, int], ...]

    def to_origins(self, rows: NDArray[np.int32], columns: NDArray[np.int32]) -> NDArray[np.uint16]:
        """(source, y, x) of sheet pixels, along a new last axis."""
        tops = np.array(self.tops, np.int32)
        origins = np.empty((*rows.shape, 3), np.uint16)
        for out, row, column in zip(origins, rows, columns, strict=True):  # a tile at a time, for memory
            source = np.searchsorted(tops, row, side="right") - 1
            out[..., 0] = source
            out[..., 1] = row - tops[source]
            out[..., 2] = column
        return origins

    def lay(self, pictures: Sequence[NDArray[np.bool_]]) -> NDArray[np.bool_]:
        """Masks of all sources on one sheet, shape (rows, columns)."""
        laid = np.zeros(self.usable.shape, bool)
        for top, (h, w), picture in zip(self.tops, self.sizes, pictures, strict=True):
            laid[top : top + h, :w] = picture
        return laid

    @cached_property
    def grain(self) -> float:
        """Mean squared step from a pixel to its neighbors east and south: what a seam costs at the least."""
        total = 0.0
        for axis in (0, 1):
            step = sum_channels(np.diff(self.features, axis=axis) ** 2)
            both = np.logical_and(*(np.delete(self.usable, end, axis=axis) for end in (0, -1)))
            total += float(step[both].mean(dtype=np.float64)) if both.any() else 0.0
        return total

    @cached_property
    def outlines(self) -> NDArray[np.float32]:
        """How much more contrast there is around each pixel than is usual; 0 within things."""
        contrast = np.sqrt(sum(_variances(self.features, 3), np.zeros((1, 1, 1), np.float32))[..., 0])
        usual = max(float(np.median(contrast[self.usable])), FLAT)
        return np.asarray(np.maximum(contrast / np.float32(usual) - 1, 0), np.float32)

    def low_pass(self, sigma: float) -> NDArray[np.float32]:
        """The features of each source, low-passed within it; same shape as ``features``."""
        out = np.zeros_like(self.features)
        for top, (h, w) in zip(self.tops, self.sizes, strict=True):
            part = self.features[top : top + h, :w]
            out[top : top + h, :w] = blur(part, sigma)
        return out

    def reduced(self, step: int) -> "Sheet":
        """The sheet with ``step`` x ``step`` pixels averaged into one."""
        usable = reduce_blocks(self.usable[..., np.newaxis].astype(np.float32), step)[..., 0] == 1
        return Sheet(
            reduce_blocks(self.features, step),
            usable,
            tuple(top // step for top in self.tops),
            tuple((h // step, w // step) for h, w in self.sizes),
        )


def reduce_blocks(image: NDArray[np.float32], step: int) -> NDArray[np.float32]:
    """Mean over blocks of step x step pixels; what does not fill a block is left out."""
    rows, columns = image.shape[0] // step, image.shape[1] // step
    if image.shape[2] > 1:
        from tilewright.kernels.reduction import average_blocks

        means = np.empty((rows, columns, image.shape[2]), np.float32)
        average_blocks(rows, np.ascontiguousarray(image, np.float32), step, means)
        return means
    blocks = image[: rows * step, : columns * step].reshape(rows, step, columns, step, -1)
    return blocks.mean(axis=(1, 3), dtype=np.float32)


def sum_channels(image: NDArray[np.float32]) -> NDArray[np.float32]:
    """Sums over the few channels of an image, which numpy is slow to make."""
    total = image[..., 0].copy()
    for channel in range(1, image.shape[2]):
        total += image[..., channel]
    return total


def sum_variances(values: NDArray[np.float32]) -> float:
    """Variances of the columns of (n, channels), added up."""
    if values.shape[1] == 1:
        return float(values.var(dtype=np.float64))
    from tilewright.kernels.reduction import add_squares, add_values

    middle, squares = np.zeros(values.shape[1]), np.zeros(values.shape[1])
    add_values(values, middle)
    middle /= len(values)
    add_squares(values, middle, squares)
    return float((squares / len(values)).sum())


def reduce_pixels(pixels: NDArray[Any], step: int) -> NDArray[Any]:
    """Means over blocks of pixels, of their own type."""
    if step == 1:
        return pixels
    mean = reduce_blocks(pixels.astype(np.float32), step)
    return (np.rint(mean) if pixels.dtype.kind == "u" else mean).astype(pixels.dtype)


def blur(image: NDArray[np.float32], sigma: float) -> NDArray[np.float32]:
    """A Gaussian; wide ones as three boxes of that variance, whose cost does not grow with them."""
    side = 2 * round((np.sqrt(4 * sigma**2 + 1) - 1) / 2) + 1
    if side < 9:
        return np.asarray(gaussian_filter(image, (sigma, sigma, 0), mode="nearest"))
    for _ in range(3):
        image = uniform_filter(image, (side, side, 1), mode="nearest")
    return image


def without_grain(image: NDArray[np.float32], sigma: float) -> Iterator[tuple[slice, NDArray[np.float32]]]:
    """An image without what varies within a Gaussian of ``sigma`` pixels, but with its outlines: row by row.

    A guided filter (He, Sun & Tang 2010), the image its own guide. A Gaussian would mix a joint with the
    stones beside it, and a cut along the joint would cost as much as one through them. What it is made of is
    smooth, and where the Gaussian is wide, found on a smaller image (He & Sun 2015).
    """
    step = max(1, int(sigma / COARSE))
    small = reduce_blocks(image, step) if step > 1 else image
    side = 2 * max(1, round(1.5 * sigma / step)) + 1
    variance = np.concatenate(list(_variances(small, side)), axis=2)
    usual = np.median(variance, axis=(0, 1)).astype(np.float32)
    kept = np.asarray(variance / (variance + np.float32(SMOOTH) * usual + np.float32(1e-6)), np.float32)
    rest = (1 - kept) * _mean(small, side)
    factor, offset = (enlarged(_mean(part, side), step, image.shape[0], 0) for part in (kept, rest))
    for top in range(0, image.shape[0], ROWS):
        rows = slice(top, top + ROWS)
        wide, more = (enlarged(part[rows], step, image.shape[1], 1) for part in (factor, offset))
        yield rows, np.asarray(wide * image[rows] + more, np.float32)


def enlarged(image: NDArray[np.float32], step: int, count: int, axis: int) -> NDArray[np.float32]:
    """``count`` pixels along an axis where ``step`` were one: linear interpolation between their middles."""
    if step == 1:
        return image
    at = (np.arange(count) + 0.5) / step - 0.5
    first = np.floor(at).astype(int)
    share = (at - first).astype(np.float32).reshape((-1, 1, 1) if axis == 0 else (1, -1, 1))
    last = image.shape[axis] - 1
    low, high = (np.take(image, np.clip(n, 0, last), axis) for n in (first, first + 1))
    return np.asarray(low + share * (high - low), np.float32)


def _mean(image: NDArray[np.float32], side: int) -> NDArray[np.float32]:
    return np.asarray(uniform_filter(image, (side, side, 1), mode="nearest"))


def _variances(image: NDArray[np.float32], side: int) -> Iterator[NDArray[np.float32]]:
    """Of each channel, in squares of ``side`` pixels; one after the other, for memory."""
    middle = image.mean(axis=(0, 1))  # far from 0, squares would lose their last digits
    for channel, mean in enumerate(middle):
        values = image[..., channel : channel + 1] - mean
        spread = _mean(values * values, side)
        spread -= _mean(values, side) ** 2
        yield np.maximum(spread, 0)


def make_sheet(exemplar: Exemplar, breadth: float = 0.0, size: int = 0) -> Sheet:
    """Stack the sources; a map counts by its weight, whatever its range and number of channels.

    Parameters
    ----------
    breadth : float
        How much more than grain the color counts that is left without it. A cut in the midst of two stones
        changes their color for good, which the eye sees from far, yet from pixel to pixel grain changes it
        more. Colors are compared in L*a*b* then.
    size : int
        Pixels along a tile, which say what is grain.
    """
    sizes = tuple(next(iter(s.values())).shape[:2] for s in exemplar.sources)
    tops = tuple(int(t) for t in np.cumsum([0, *(h for h, _ in sizes[:-1])]))
    shape = (sum(h for h, _ in sizes), max(w for _, w in sizes))
    channels = [pixels.shape[2] for pixels in exemplar.sources[0].values()]
    features = np.zeros((*shape, sum(channels)), np.float32)
    usable = np.zeros(shape, bool)
    for top, (h, w), maps, mask in zip(tops, sizes, exemplar.sources, exemplar.masks, strict=True):
        usable[top : top + h, :w] = mask
        start = 0
        for name, pixels in maps.items():
            stop = start + pixels.shape[2]
            seen = features[top : top + h, :w, start:stop]
            _perceive(pixels, exemplar.kinds[name], breadth, GRAIN * size, seen)
            start = stop
    start = 0
    for name, count in zip(exemplar.sources[0], channels, strict=True):
        stop = start + count
        spread = sum_variances(_usable(features, usable)[:, start:stop])
        if spread > 0:
            features[..., start:stop] *= np.sqrt(exemplar.weights[name] / spread)
        start = stop
    total = sum_variances(_usable(features, usable))
    if total > 0:
        features /= np.float32(np.sqrt(total))
    if sum(channels) > MOST_FEATURES:
        features = _condense(features, usable)
    return Sheet(features, usable, tops, sizes)


def _usable(features: NDArray[np.float32], usable: NDArray[np.bool_]) -> NDArray[np.float32]:
    """The features of usable pixels, shape (n, channels)."""
    return features.reshape(usable.size, -1) if usable.all() else features[usable]


def _perceive(
    pixels: NDArray[Any], kind: str, breadth: float, grain: float, out: NDArray[np.float32]
) -> None:
    """Fill in values whose differences are about what the eye sees, a few rows at a time."""
    for top in range(0, len(out), ROWS):
        rows = slice(top, top + ROWS)
        out[rows] = _bent(pixels[rows], kind, breadth > 0)
    if breadth:
        for rows, broad in without_grain(out, grain):
            out[rows] += np.float32(breadth) * broad


def _bent(pixels: NDArray[Any], kind: str, in_lab: bool) -> NDArray[np.float32]:
    """Linear light is bent as sRGB bends it, or all color as the eye does."""
    if kind == "color" and in_lab:
        alpha = pixels[..., -1:].astype(np.float32) * np.float32(100 / white(pixels.dtype))
        lab = to_lab(pixels, kind)
        return np.concatenate([lab, alpha], axis=2) if has_alpha(pixels.shape[2]) else lab
    values = pixels.astype(np.float32)
    if kind == "color" and pixels.dtype.kind == "f":
        return np.sign(values) * np.abs(values) ** np.float32(1 / 2.2)
    return values


def _condense(features: NDArray[np.float32], usable: NDArray[np.bool_]) -> NDArray[np.float32]:
    """The strongest principal components, in which distances are nearly the same and cost less.

    Sums are taken channel by channel, not by a matrix product, whose order depends on the number of threads.
    """
    count = features.shape[2]
    means = sum(
        (_rows(features, usable, top).sum(axis=0, dtype=np.float64) for top in range(0, len(features), ROWS)),
        np.zeros(count),
    ) / np.count_nonzero(usable)
    covariance = np.zeros((count, count))
    for top in range(0, len(features), ROWS):
        centered = _rows(features, usable, top) - means
        for a in range(count):
            for b in range(a + 1):
                covariance[a, b] += (centered[:, a] * centered[:, b]).sum()
    covariance += np.tril(covariance, -1).T
    _, axes = np.linalg.eigh(covariance)
    out = np.zeros((*features.shape[:2], MOST_FEATURES), np.float32)
    for component in range(MOST_FEATURES):
        for channel, share in enumerate(axes[:, -1 - component]):
            out[..., component] += np.float32(share) * features[..., channel]
    return out


def _rows(features: NDArray[np.float32], usable: NDArray[np.bool_], top: int) -> NDArray[np.float32]:
    """The features of usable pixels in a few rows, shape (n, channels)."""
    rows = slice(top, top + ROWS)
    return features[rows][usable[rows]]
