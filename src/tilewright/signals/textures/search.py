"""Choose a patch by search, not by luck, and lay it.

Every place of the exemplar is scored by how well it continues what is already there (color around the
patch, tone over the whole tile), multiplied by how conspicuous and how used it is; the best places that
lie apart are cut in, and the cheapest cut wins.
"""

from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter, uniform_filter

from tilewright.errors import Progress, TilewrightValueError
from tilewright.signals.textures.matching import Matcher, bar_places, best_places
from tilewright.signals.textures.patchwork import FORCED_NEW, FORCED_OLD, OPEN, Patchwork
from tilewright.signals.textures.sheet import Sheet

Place = tuple[int, int]

CANDIDATES = 16
"""Places that are cut in before the cheapest is kept."""
APART = 1 / 16
"""Least distance between candidates, in tiles."""
TONE_SIGMA = 1 / 12
"""Low-pass that leaves the tone, in tiles."""
TONE = 0.5
"""What a difference of one standard deviation in tone counts, in variances of the exemplar."""
PLAINNESS = 0.7
"""How much a conspicuous place is marked down where the patch will recur often."""
USAGE = 0.5
"""How much a place is marked down for each time it was used."""
CONTEXT, CONTEXT_SIGMA = 1.0, 1 / 24
"""How much a seam costs more where the two contents differ around it, and how far that looks."""
EXCLUSION = 0.22
"""Places nearer than this to one that shows in the same tile are not taken, in tiles."""


@dataclass(eq=False)
class Ledger:
    """Which patch lies where, and what an artist said about it.

    A patch is named for what it fills (``corner:0``, ``edge-h:0-1``, ``center:7``); a place is the sheet
    pixel shown at the canvas's north-west pixel (for corners: at the lattice point).
    """

    picked: dict[str, Place] = field(default_factory=dict)
    rejected: dict[str, list[Place]] = field(default_factory=dict)
    laid: dict[str, Place] = field(default_factory=dict)


class PatchSearch:
    """Lays patches from one sheet over canvases of one tile size."""

    def __init__(
        self,
        sheet: Sheet,
        size: int,
        ledger: Ledger,
        period: float | None,
        pool: ThreadPoolExecutor,
        progress: Progress | None,
        total: int,
    ) -> None:
        self.sheet = sheet
        self.size = size
        self.ledger = ledger
        self.period = period
        self.pool = pool
        self.progress = progress
        self.total = total
        self.matcher = Matcher(sheet, size, TONE_SIGMA * size)
        self.conspicuous = conspicuousness(sheet, size)
        self.used = np.zeros(sheet.usable.shape, np.float32)

    @property
    def exclusion(self) -> float:
        """Radius around shown places that is barred, in pixels.

        In a periodic exemplar the right phase recurs once a period, so the radius stays below a third.
        """
        radius = EXCLUSION * self.size
        return radius if self.period is None else min(radius, self.period / 3)

    def step(self, what: str) -> None:
        """Report that one more patch lies."""
        if self.progress is not None:
            self.progress(len(self.ledger.laid), self.total, what)

    def lay(
        self,
        name: str,
        canvas: Patchwork,
        state: NDArray[np.uint8],
        weight: NDArray[np.float32],
        sources: Sequence[int],
        shown: Iterable[Place],
        earlier: Sequence[Place],
        plain: bool,
    ) -> tuple[Patchwork, Place]:
        """Find a patch for an open canvas, cut it in, and return the new canvas and its place.

        ``weight`` is what a seam counts at each pixel; places near those ``shown`` on the canvas are not
        taken, nor, as far as the exemplar has others, places near ``earlier`` patches of the same kind;
        ``plain`` asks for an inconspicuous patch.
        """
        if name in self.ledger.picked:
            places = [self.checked_pick(name)]
        else:
            score = self._score(canvas, state, weight, sources, plain)
            bar_places(score, shown, self.exclusion)
            bar_places(score, self.ledger.rejected.get(name, ()), self.size / 4)
            self._bar_if_others_are_left(score, earlier)
            places = best_places(score, CANDIDATES, max(1, round(APART * self.size)))
        if not places:
            raise TilewrightValueError(
                f"no place is left for patch {name}: the exemplar or its mask is too small for tiles of "
                f"{self.size} pixels, or too many patches were rejected"
            )
        cuts = list(self.pool.map(lambda place: self._cut(canvas, place, state, weight), places))
        best = min(range(len(places)), key=lambda k: cuts[k][0])
        place, where = places[best], cuts[best][1]
        self._mark_used(place, where & (state != FORCED_OLD))
        self.ledger.laid[name] = place
        self.step(name)
        return canvas.with_patch(place, where), place

    def _bar_if_others_are_left(self, score: NDArray[np.float32], earlier: Sequence[Place]) -> None:
        """Bar places near earlier patches, in a radius small enough that some places stay."""
        radius = self.exclusion
        while radius >= 1:
            trial = score.copy()
            bar_places(trial, earlier, radius)
            if np.isfinite(trial).any():
                score[...] = trial
                return
            radius /= 2

    def _cut(
        self, canvas: Patchwork, place: Place, state: NDArray[np.uint8], weight: NDArray[np.float32]
    ) -> tuple[float, NDArray[np.bool_]]:
        return canvas.overlay(self.sheet, place, state, weight, CONTEXT, CONTEXT_SIGMA * self.size)

    def _score(
        self,
        canvas: Patchwork,
        state: NDArray[np.uint8],
        weight: NDArray[np.float32],
        sources: Sequence[int],
        plain: bool,
    ) -> NDArray[np.float32]:
        """Lower is better; infinite where the patch would leave the sources."""
        color, tone = self.matcher.distances(canvas, np.where(state == OPEN, weight, 0))
        score = color + np.float32(TONE) * tone
        # What stays of the patch is about its core: a box as large, around the window's middle.
        side = max(1, round(float(np.sqrt((state == FORCED_NEW).sum()))))
        score *= 1 + np.float32(USAGE) * self._around(self.used, side)
        if plain and self.period is None:
            score *= 1 + np.float32(PLAINNESS) * self._around(self.conspicuous, side)
        score[~self.matcher.places(sources)] = np.inf
        return score

    def _around(self, field: NDArray[np.float32], side: int) -> NDArray[np.float32]:
        """Mean of a field of the sheet over a box in the middle of each window."""
        half = self.size // 2
        rows, columns = field.shape
        mean = uniform_filter(field, side, mode="nearest")
        return mean[half : rows - self.size + half + 1, half : columns - self.size + half + 1]

    def conspicuous_at(
        self, rows: NDArray[np.int64], columns: NDArray[np.int64], side: int
    ) -> NDArray[np.float32]:
        """How much boxes around the given sheet pixels stand out."""
        return uniform_filter(self.conspicuous, side, mode="nearest")[rows, columns]

    def _mark_used(self, place: Place, where: NDArray[np.bool_]) -> None:
        y, x = place
        self.used[y : y + self.size, x : x + self.size] += where

    def checked_pick(self, name: str) -> Place:
        """The place picked for a patch, if a window fits there."""
        y, x = self.ledger.picked[name]
        places = self.matcher.places(range(len(self.sheet.tops)))
        if not (0 <= y < places.shape[0] and 0 <= x < places.shape[1] and places[y, x]):
            raise TilewrightValueError(
                f"the place picked for {name} does not leave room for a tile of {self.size} pixels "
                "inside its source and mask"
            )
        return y, x


def conspicuousness(sheet: Sheet, size: int) -> NDArray[np.float32]:
    """How much each place stands out: tone away from the mean, contrast away from the usual; mean 1."""
    mean = sheet.features[sheet.usable].mean(axis=0)
    low = sheet.low_pass(size / 8)
    tone = ((low - mean) ** 2).sum(axis=2)
    fine = ((sheet.low_pass(2.0) - low) ** 2).sum(axis=2)
    contrast = gaussian_filter(fine, size / 16)
    contrast = np.abs(contrast - contrast[sheet.usable].mean())
    return sum(
        (0.5 * part / max(float(part[sheet.usable].mean()), 1e-9)).astype(np.float32)
        for part in (tone, contrast)
    )
