"""A canvas of copied pixels, and the one move that changes it: lay a patch over it and cut.

A seam that is already there counts in the cut, so a new patch covers old seams where that pays
(Kwatra et al. 2003, section 3.2; the energy is in ``kernels/seams.py``).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from tilewright.kernels.mincut import cut_grid
from tilewright.kernels.seams import FORCED_NEW, FORCED_OLD, OPEN, fill_grid, measure_overlap, sum_seams
from tilewright.signals.textures.sheet import Sheet, blur

__all__ = ["FORCED_NEW", "FORCED_OLD", "OPEN", "Patchwork", "stack"]

# Integer capacity of a seam whose squared distance is the variance of the exemplar.
_SCALE = 4096.0


@dataclass(frozen=True, eq=False)
class Patchwork:
    """Sheet coordinates of every pixel of a canvas, shape (h, w) each; -1 where nothing lies."""

    rows: NDArray[np.int32]
    columns: NDArray[np.int32]

    @classmethod
    def of_patch(cls, height: int, width: int, shift: tuple[int, int]) -> "Patchwork":
        """A canvas that shows sheet pixel (i, j) + shift everywhere."""
        i, j = np.indices((height, width), np.int32)
        return cls(i + np.int32(shift[0]), j + np.int32(shift[1]))

    def pixels(self, image: NDArray[np.float32]) -> NDArray[np.float32]:
        """What the canvas shows of an image the size of the sheet, shape (h, w, k)."""
        rows, columns = image.shape[:2]
        return image[np.clip(self.rows, 0, rows - 1), np.clip(self.columns, 0, columns - 1)]

    def reduced(self, step: int) -> "Patchwork":
        """The canvas seen through one pixel in ``step``, in coordinates of the sheet reduced likewise."""
        return Patchwork(
            thinned(self.rows, step) // np.int32(step), thinned(self.columns, step) // np.int32(step)
        )

    def with_patch(self, shift: tuple[int, int], where: NDArray[np.bool_]) -> "Patchwork":
        """The canvas with a patch copied over it where told."""
        new = Patchwork.of_patch(self.rows.shape[0], self.rows.shape[1], shift)
        return Patchwork(np.where(where, new.rows, self.rows), np.where(where, new.columns, self.columns))

    def overlay(
        self,
        sheet: Sheet,
        shift: tuple[int, int],
        state: NDArray[np.uint8],
        weight: NDArray[np.float32],
        context: float = 0.0,
        reach: float = 0.0,
        keep: NDArray[np.float32] | None = None,
        settled: NDArray[np.uint8] | None = None,
        ease: float = 0.0,
    ) -> tuple[float, NDArray[np.bool_]]:
        """Cut a patch into the canvas: the energy of the best cut, and where the patch then lies.

        Parameters
        ----------
        shift : the patch shows sheet pixel (i, j) + shift at canvas pixel (i, j).
        state : uint8 (h, w), FORCED_OLD, OPEN or FORCED_NEW for each pixel.
        weight : float32 (h, w), what a seam counts there.
        context : how much the difference around a seam counts beside that at the seam.
        reach : radius (sigma, pixels) of that neighborhood.
        keep : float32 (h, w), what each open pixel costs that stays old; nothing by default.
        settled : uint8 (h, w), the state with more of it forced, for the cut alone; by default no more is.
        ease : how much less a seam counts along outlines that both contents have, in place of the gradients
            of Kwatra et al. 2003, "Adapting the Cost Function".
        """
        if ease:
            weight = weight / (1 + np.float32(ease) * self._shared_outlines(sheet, shift))
        height, width = state.shape
        around = np.zeros(state.shape, np.float32)
        if context > 0:
            measure_overlap(sheet.features, self.rows, self.columns, *shift, around)
            if settled is None:
                around = gaussian_filter(around, reach, mode="nearest")
            else:  # of large canvases
                around = blur(around[..., np.newaxis], reach)[..., 0]
            around *= np.float32(context)
        kept = np.zeros(state.shape, np.float32) if keep is None else np.where(state == OPEN, keep, 0)
        state = state if settled is None else settled
        capacity = np.zeros((4, (height + 2) * (width + 2)), np.int32)
        terminal = np.zeros((height + 2) * (width + 2), np.int32)
        fill_grid(
            sheet.features,
            self.rows,
            self.columns,
            *shift,
            state,
            weight,
            around,
            np.float32(_SCALE),
            capacity,
            terminal,
        )
        inner = terminal.reshape(height + 2, width + 2)[1:-1, 1:-1]
        inner -= np.rint(kept * _SCALE).astype(np.int32)
        in_sink = np.zeros(terminal.shape, np.uint8)
        cut_grid(capacity, terminal, width + 2, in_sink)
        chosen = in_sink.reshape(height + 2, width + 2)[1:-1, 1:-1] == 1
        where = (state == FORCED_NEW) | ((state == OPEN) & chosen)
        energy = sum_seams(sheet.features, self.rows, self.columns, *shift, where, weight, around)
        return float(energy) + float(kept[~where].sum(dtype=np.float64)), where

    def _shared_outlines(self, sheet: Sheet, shift: tuple[int, int]) -> NDArray[np.float32]:
        """The outlines that lie here and in a patch alike."""
        height, width = self.rows.shape
        patch = Patchwork.of_patch(height, width, shift)
        ours, theirs = (c.pixels(sheet.outlines[..., np.newaxis])[..., 0] for c in (self, patch))
        return np.minimum(ours, theirs)

    def with_cut(
        self,
        sheet: Sheet,
        shift: tuple[int, int],
        state: NDArray[np.uint8],
        weight: NDArray[np.float32],
        context: float = 0.0,
        reach: float = 0.0,
    ) -> "Patchwork":
        """The canvas with a patch cut into it; parameters as in `overlay`."""
        return self.with_patch(shift, self.overlay(sheet, shift, state, weight, context, reach)[1])


def thinned(pixels: NDArray[Any], step: int) -> NDArray[Any]:
    """One pixel in ``step`` along both axes."""
    return pixels[step // 2 :: step, step // 2 :: step]


def stack(canvases: Sequence[Patchwork]) -> Patchwork:
    """All tiles in one: coordinates of shape (T, h, w)."""
    return Patchwork(np.stack([c.rows for c in canvases]), np.stack([c.columns for c in canvases]))
