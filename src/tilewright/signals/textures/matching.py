"""Where in the exemplar is a patch that would fit here? Weighted squared distance at every place."""

from collections.abc import Iterable, Sequence
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, next_fast_len, rfft2
from scipy.ndimage import minimum_filter

from tilewright.signals.textures.patchwork import Patchwork
from tilewright.signals.textures.sheet import Sheet, reduce_blocks

BLOCK_SIDE = 1280
"""Pixels along the parts in which a large exemplar is searched: each patch in one of them."""
BLOCKS_HELD = 16
"""Parts that are kept ready."""


class Matcher:
    """Compares a canvas with every window of a sheet: in color around the patch, in tone all over.

    Tone is the low-passed color. It is compared where the patch will lie as well, so that a patch of
    another tone than its surroundings is not laid among them, however well its border fits.
    """

    def __init__(self, sheet: Sheet, size: int, tone_sigma: float) -> None:
        self.sheet = sheet
        self.size = size
        # Tone varies slowly: one pixel in `step` is enough.
        self.step = max(1, size // 32)
        self._tone_sigma = tone_sigma
        self.blocks = cut_into_blocks(sheet.usable.shape, size)
        self._held: dict[int, tuple[WindowDistance, WindowDistance]] = {}
        self._places: dict[tuple[int, ...], NDArray[np.bool_]] = {}

    @cached_property
    def tone_pixels(self) -> NDArray[np.float32]:
        """The tone of every pixel, of variance 1."""
        low, usable = self.sheet.low_pass(self._tone_sigma), self.sheet.usable
        spread = float(low[usable].var(axis=0, dtype=np.float64).sum())
        return (low - low[usable].mean(axis=0)) / np.float32(np.sqrt(max(spread, 1e-12)))

    def places(self, sources: Sequence[int]) -> NDArray[np.bool_]:
        """Where a window of a tile's size lies in usable pixels of one of the sources."""
        return self.places_of_size(self.size, sources)

    def places_of_size(self, n: int, sources: Sequence[int]) -> NDArray[np.bool_]:
        """Where a window of n x n pixels lies in usable pixels, one pixel off a source's border."""
        key = (n, *sources)
        if key not in self._places:
            blocked = np.ones((self.sheet.usable.shape[0] + 1, self.sheet.usable.shape[1] + 1), np.int64)
            blocked[0] = blocked[:, 0] = 0
            for s in sources:
                top, (h, w) = self.sheet.tops[s], self.sheet.sizes[s]
                inner = self.sheet.usable[top + 1 : top + h - 1, 1 : w - 1]
                blocked[top + 2 : top + h, 2:w] = ~inner
            total = blocked.cumsum(0).cumsum(1)
            self._places[key] = (total[n:, n:] - total[:-n, n:] - total[n:, :-n] + total[:-n, :-n]) == 0
        return self._places[key]

    def holds(self, y: int, x: int, n: int) -> bool:
        """Whether one of the `places_of_size` is (y, x)."""
        window = self.sheet.usable[max(y, 0) : max(y + n, 0), max(x, 0) : max(x + n, 0)]
        within = (
            top < y and y + n < top + h and x > 0 and x + n < w
            for top, (h, w) in zip(self.sheet.tops, self.sheet.sizes, strict=True)
        )
        return any(within) and bool(window.all())

    def inside(self, block: int) -> tuple[slice, slice]:
        """The places whose windows lie in a block."""
        top, left, height, width = self.blocks[block]
        return slice(top, top + height - self.size + 1), slice(left, left + width - self.size + 1)

    def _block(self, block: int) -> tuple["WindowDistance", "WindowDistance"]:
        """What compares with the windows of a block; of those used last a few are kept."""
        # A cache of functools would hold this object in a circle, and the sheet until that is collected.
        ready = self._held.pop(block, None)
        if ready is None:
            if len(self._held) == BLOCKS_HELD:
                del self._held[next(iter(self._held))]
            top, left, height, width = self.blocks[block]
            part = slice(top, top + height), slice(left, left + width)
            tone = reduce_blocks(self.tone_pixels[part], self.step)
            ready = WindowDistance(self.sheet.features[part]), WindowDistance(tone)
        self._held[block] = ready
        return ready

    def distances(
        self, block: int, canvas: Patchwork, weight: NDArray[np.float32]
    ) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Mean squared distance of the canvas to each window of a block, in color (weighted) and in tone."""
        color_distance, tone_distance = self._block(block)
        color = color_distance(canvas.pixels(self.sheet.features), weight)
        tone_canvas = reduce_blocks(canvas.pixels(self.tone_pixels), self.step)
        coarse = tone_distance(tone_canvas, np.ones(tone_canvas.shape[:2], np.float32))
        rows = np.minimum(np.arange(color.shape[0]) // self.step, coarse.shape[0] - 1)
        columns = np.minimum(np.arange(color.shape[1]) // self.step, coarse.shape[1] - 1)
        return color, coarse[rows][:, columns]


def cut_into_blocks(shape: tuple[int, ...], size: int) -> list[tuple[int, int, int, int]]:
    """Parts (top, left, height, width) of a sheet, small enough to search; every window lies in one."""
    spans = []
    for length in shape:
        # Windows of a part begin in it; the part goes on until the last of them ends.
        starts = max(1, length - size + 1)
        count = -(-starts // max(1, BLOCK_SIDE - size))
        edges = np.linspace(0, starts, count + 1).astype(int)
        spans.append([(int(a), int(b - a) + min(size, length) - 1) for a, b in pairwise(edges)])
    return [(top, left, height, width) for top, height in spans[0] for left, width in spans[1]]


class WindowDistance:
    """Weighted mean squared distance of a target to every window of an image, by FFT."""

    def __init__(self, image: NDArray[np.float32]) -> None:
        rows, columns, _ = image.shape
        self.shape = (rows, columns)
        self.size = (next_fast_len(rows, real=True), next_fast_len(columns, real=True))
        planes = np.ascontiguousarray(np.moveaxis(image, 2, 0))
        self.spectra = rfft2(planes, self.size)
        self.power = rfft2((planes * planes).sum(axis=0), self.size)

    def __call__(self, target: NDArray[np.float32], weight: NDArray[np.float32]) -> NDArray[np.float32]:
        """Distances of ``target`` (h, w, k); element (y, x) is the window that starts there."""
        height, width = weight.shape
        share = (weight / weight.sum()).astype(np.float32)
        planes = np.moveaxis(target, 2, 0)
        product = (np.conj(rfft2(planes * share, self.size)) * self.spectra).sum(axis=0)
        spectrum = np.conj(rfft2(share, self.size)) * self.power - 2 * product
        rows, columns = self.shape
        found = irfft2(spectrum, self.size)[: rows - height + 1, : columns - width + 1]
        return np.maximum(found + np.float32((planes * planes * share).sum()), 0)


def best_places(score: NDArray[np.float32], count: int, apart: int) -> list[tuple[int, int]]:
    """The ``count`` lowest places of a score map, at least ``apart`` from each other; never infinite ones."""
    lowest = minimum_filter(score, size=2 * apart + 1, mode="constant", cval=np.inf)
    y, x = ((score == lowest) & np.isfinite(score)).nonzero()
    order = np.argsort(score[y, x], kind="stable")[:count]
    return [(int(y[o]), int(x[o])) for o in order]


def bar_places(score: NDArray[np.float32], places: Iterable[tuple[int, int]], radius: float) -> None:
    """Make every place nearer than ``radius`` to one of the given infinitely bad."""
    reach = int(np.ceil(radius))
    away = np.arange(-reach, reach + 1) ** 2
    disk = away[:, np.newaxis] + away < radius**2
    for y, x in places:
        top, left = max(0, y - reach), max(0, x - reach)
        part = score[top : max(0, y + reach + 1), left : max(0, x + reach + 1)]
        inside = disk[top - y + reach :, left - x + reach :]
        part[inside[: part.shape[0], : part.shape[1]]] = np.inf
