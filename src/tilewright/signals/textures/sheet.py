"""All sources of an exemplar on one sheet of features, the coordinates synthesis works in."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from tilewright.signals.textures.exemplar import Exemplar


@dataclass(frozen=True, eq=False)
class Sheet:
    """Sources stacked from top to bottom, with the features that are compared.

    Attributes
    ----------
    features : float32 array, shape (rows, columns, k)
        All channels of all maps, scaled so that their variances add up to 1.
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
        source = np.searchsorted(np.array(self.tops), rows, side="right") - 1
        origins = np.empty((*rows.shape, 3), np.uint16)
        origins[..., 0] = source
        origins[..., 1] = rows - np.array(self.tops)[source]
        origins[..., 2] = columns
        return origins

    def low_pass(self, sigma: float) -> NDArray[np.float32]:
        """The features of each source, low-passed within it; same shape as ``features``."""
        out = np.zeros_like(self.features)
        for top, (h, w) in zip(self.tops, self.sizes, strict=True):
            part = self.features[top : top + h, :w]
            out[top : top + h, :w] = gaussian_filter(part, (sigma, sigma, 0), mode="nearest")
        return out


def make_sheet(exemplar: Exemplar) -> Sheet:
    """Stack the sources; a map counts by its weight, whatever its range and number of channels."""
    sizes = tuple(next(iter(s.values())).shape[:2] for s in exemplar.sources)
    tops = tuple(int(t) for t in np.cumsum([0, *(h for h, _ in sizes[:-1])]))
    channels = sum(m.shape[2] for m in exemplar.sources[0].values())
    shape = (sum(h for h, _ in sizes), max(w for _, w in sizes))
    features = np.zeros((*shape, channels), np.float32)
    usable = np.zeros(shape, bool)
    for top, (h, w), maps, mask in zip(tops, sizes, exemplar.sources, exemplar.masks, strict=True):
        features[top : top + h, :w] = np.concatenate([m.astype(np.float32) for m in maps.values()], axis=2)
        usable[top : top + h, :w] = mask
    start = 0
    for name, pixels in exemplar.sources[0].items():
        stop = start + pixels.shape[2]
        spread = features[usable][:, start:stop].var(axis=0, dtype=np.float64).sum()
        if spread > 0:
            features[..., start:stop] *= np.sqrt(exemplar.weights[name] / spread)
        start = stop
    total = features[usable].var(axis=0, dtype=np.float64).sum()
    if total > 0:
        features /= np.float32(np.sqrt(total))
    return Sheet(features, usable, tops, sizes)
