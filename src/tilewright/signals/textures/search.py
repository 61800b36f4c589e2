"""Choose a patch by search, not by luck, and lay it.

Every place of the exemplar is scored by how well it continues what is already there (color around the
patch, tone over the whole tile), multiplied by how conspicuous and how used it is; the best places that
lie apart are cut in, and the cheapest of them wins, its cut counted together with its score. What a patch
leaves of the older content comes back in more tiles than the patch does, so leaving it has a price too.
"""

from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, gaussian_filter, uniform_filter

from tilewright.errors import Progress, TilewrightValueError
from tilewright.signals.textures.bars import FEWEST_OPEN, Bars
from tilewright.signals.textures.keeping import Kept
from tilewright.signals.textures.manner import NESTED, Manner
from tilewright.signals.textures.matching import Matcher, bar_places, best_places
from tilewright.signals.textures.patchwork import FORCED_NEW, FORCED_OLD, OPEN, Patchwork, thinned
from tilewright.signals.textures.sheet import Sheet, sum_channels

Place = tuple[int, int]

FURTHER_CANDIDATES = 0.75
"""Share of them for further variants of a tile, which are seen less often; all took a tenth longer."""
SMALL, FINALISTS = 128, 3
"""Pixels along a canvas above which candidates are cut at a smaller scale first, and how many then stay."""
DRAFT, BEST_DRAFTS = 96, 2
"""The same for the default, at half size or less. With one left cuts were 1 % dearer; with cuts in a band of
6 pixels around their drafts 4 %."""
DRAFTED_AT, BAND = 128, 4
"""Pixels along a canvas at which it is cut first where places are known, and how many of these the cut may
move then. For 80 tiles of 512 pixels this takes a third of the time of cuts anywhere."""
CLOSER = 4
"""From scale to scale where places are known. A band of 4 pixels is 32 at a scale 8 times as large, and most
of the time of tiles of 1,024 pixels went into cutting that."""
APART = 1 / 16
"""Least distance between candidates, in tiles."""
TONE_SIGMA = 1 / 5
"""Low-pass that leaves the tone, in tiles."""
TONE = 2.0
"""What a difference of one standard deviation in tone counts, in variances of the exemplar."""
RECURRENCE_BAND = 0.15
"""Towards a canvas's border the price of recurrence falls to nothing over this width, in tiles: a cut that
hurries to the border would show the tile's square."""
BLAND = 0.5
"""What too little contrast counts when a place is judged for conspicuousness, beside too much."""
MEANS = 4
"""Means of conspicuousness that are kept: enough for corners, edges and centers of a sheet of one block."""
USAGE = 0.5
"""How much a place is marked down for each time it was used."""
CONTEXT, CONTEXT_SIGMA = 1.0, 1 / 24
"""How much a seam costs more where the two contents differ around it, and how far that looks."""


@dataclass(eq=False)
class Ledger:
    """Which patch lies where, and what an artist said about it.

    A patch is named for what it fills (``corner:0``, ``edge-h:0-1``, ``center:7``); a place is the sheet
    pixel shown at the canvas's north-west pixel (for corners: at the lattice point).
    """

    picked: dict[str, Place] = field(default_factory=dict)
    rejected: dict[str, list[Place]] = field(default_factory=dict)
    laid: dict[str, Place] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Opening:
    """A canvas that waits for a patch.

    Attributes
    ----------
    canvas : Patchwork
        What lies there already.
    state : uint8 (h, w)
        FORCED_OLD, OPEN or FORCED_NEW for each pixel.
    weight : float32 (h, w)
        What a seam counts at each pixel.
    sources : the sources the patch may come from.
    shown : places that show on the canvas; those near them are not taken.
    earlier : places of patches of the same kind; as far as the exemplar has others, those are taken.
    plainness : how much a conspicuous place is marked down: more where the patch will recur more often.
    recurrence : what every old pixel that stays costs, over the root mean square step between neighboring
        pixels of the exemplar: old content shows in more tiles than the patch.
    candidates : places that are cut in before the cheapest is kept, as a share of what the manner says.
    spacing : how far from earlier patches this one is kept, over what is usual; less where there are many of
        them, as else only conspicuous places are left.
    lines : the row and the column of the canvas that lie on lines of the lattice, beside its border.
    barred : of every place, whether a patch from there would show what it must not; None where all do.
    """

    canvas: Patchwork
    state: NDArray[np.uint8]
    weight: NDArray[np.float32]
    sources: Sequence[int]
    shown: Sequence[Place] = ()
    earlier: Sequence[Place] = ()
    plainness: float = 0.0
    recurrence: float = 0.0
    candidates: float = 1.0
    spacing: float = 1.0
    lines: tuple[int, int] = (0, 0)
    barred: NDArray[np.bool_] | None = None


class Cut(NamedTuple):
    """Where a patch would lie, and what that costs."""

    place: Place
    where: NDArray[np.bool_]
    cost: float


class Scale:
    """Cuts patches into openings, seen through one pixel in ``step``."""

    def __init__(self, sheet: Sheet, size: int, step: int, ease: float) -> None:
        self.step = step
        self.ease = ease
        self.sheet = sheet if step == 1 else sheet.reduced(step)
        self.reach = CONTEXT_SIGMA * size / step
        # 0 at the border of a canvas, 1 from the band on.
        steps = np.arange(size) + 0.5
        rise = np.minimum(1, np.minimum(steps, size - steps) / (RECURRENCE_BAND * size))
        self.inwards = thinned(np.minimum.outer(rise, rise).astype(np.float32), step)

    def cut(
        self, opening: Opening, place: Place, draft: NDArray[np.bool_] | None = None
    ) -> tuple[float, NDArray[np.bool_]]:
        """The energy of the best cut of a patch into an opening, and where the patch then lies.

        ``draft`` says where it would lie at a smaller scale: the cut stays near the border of that.
        """
        step = self.step
        state, weight = thinned(opening.state, step), thinned(opening.weight, step)
        settled = None if draft is None else settle_far(state, draft)
        canvas = opening.canvas if step == 1 else opening.canvas.reduced(step)
        y, x = ((c + step // 2) // step for c in place)
        keep = np.float32(opening.recurrence * np.sqrt(self.sheet.grain)) * weight * self.inwards
        return canvas.overlay(
            self.sheet, (y, x), state, weight, CONTEXT, self.reach, keep, settled, self.ease
        )


def settle_far(state: NDArray[np.uint8], draft: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """The state with all forced that is not within a band around the border of a draft."""
    rows, columns = (
        np.minimum(np.arange(n) * m // n, m - 1) for n, m in zip(state.shape, draft.shape, strict=True)
    )
    new, old = (binary_dilation(side, iterations=BAND)[rows][:, columns] for side in (draft, ~draft))
    settled = state.copy()
    settled[(state == OPEN) & ~old] = FORCED_NEW
    settled[(state == OPEN) & ~new] = FORCED_OLD
    return settled


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
        rng: np.random.Generator,
        manner: Manner = NESTED,
        kept: Kept | None = None,
    ) -> None:
        self.sheet = sheet
        self.manner = manner
        self.kept = kept
        self.places_known = False
        self.size = size
        self.ledger = ledger
        self.period = period
        self.pool = pool
        self.progress = progress
        self.total = total
        self.rng = rng
        self.full = Scale(sheet, size, 1, manner.ease)
        self.matcher = Matcher(sheet, size, TONE_SIGMA * size)
        self._means: dict[tuple[int, int], NDArray[np.float32]] = {}
        self.used = np.zeros(sheet.usable.shape, np.float32)
        self.bars = Bars(sheet, size, manner)

    @cached_property
    def small(self) -> Scale:
        """What large canvases are cut at first; the full scale for others."""
        if self.places_known:
            step = self.size // DRAFTED_AT
        elif self.manner.jointly:
            step = max(2, self.size // DRAFT) if self.size > DRAFT else 1
        else:
            step = self.size // SMALL
        return Scale(self.sheet, self.size, step, self.manner.ease) if step > 1 else self.full

    @cached_property
    def between(self) -> list[Scale]:
        """Scales between the small one and the full one."""
        steps = [self.small.step // CLOSER]
        while steps[-1] > 1:
            steps.append(steps[-1] // CLOSER)
        return [Scale(self.sheet, self.size, step, self.manner.ease) for step in steps[:-1]]

    @cached_property
    def conspicuous(self) -> NDArray[np.float32]:
        """How much each place stands out."""
        return conspicuousness(self.sheet, self.size)

    @property
    def exclusion(self) -> float:
        """Radius around shown places that is barred, in pixels.

        In a periodic exemplar the right phase recurs once a period, so the radius stays below a third.
        """
        radius = self.manner.exclusion * self.size
        return radius if self.period is None else min(radius, self.period / 3)

    def step(self, what: str) -> None:
        """Report that one more patch lies."""
        if self.progress is not None:
            self.progress(len(self.ledger.laid), self.total, what)

    def lay(self, name: str, opening: Opening) -> tuple[Patchwork, Place]:
        """Find a patch for an opening, cut it in, and return the new canvas and its place."""
        # Step 1: the places that promise most, and how good each looks before it is cut in.
        # Blocks are drawn for picked patches too: a pick must not move the others.
        blocks = self.rng.permutation(len(self.matcher.blocks))
        picked = name in self.ledger.picked
        promise = {self.checked_pick(name): 1.0} if picked else self._find(name, opening, blocks)
        if not promise:
            raise TilewrightValueError(
                f"no place is left for patch {name}: the exemplar or its mask is too small for tiles of "
                f"{self.size} pixels, or too many patches were rejected"
            )
        # Step 2: cut each of them in; the least cut, counted with the promise, wins. Large canvases are cut
        # on a small scale first, and only the best of those at full size: near their drafts where much is
        # open, which takes half of the time, and cuts are no worse.
        drafts: dict[Place, NDArray[np.bool_]] = {}
        if len(promise) > 1 and self.small.step > 1:
            best = self._cut_all(self.small, opening, promise, drafts)
            finalists = best[: BEST_DRAFTS if self.manner.jointly else FINALISTS]
            promise = {cut.place: promise[cut.place] for cut in finalists}
            if self.manner.ease:
                drafts = {cut.place: cut.where for cut in finalists}
        if self.places_known:
            (place,) = promise
            where = self.cut(opening, place)
        else:
            place, where, _ = self._cut_all(self.full, opening, promise, drafts)[0]
        self.record(name, place, where & (opening.state != FORCED_OLD))
        return opening.canvas.with_patch(place, where), place

    def record(self, name: str, place: Place, shown: NDArray[np.bool_]) -> None:
        """Note that a patch lies, and what of its window shows."""
        y, x = place
        self.used[y : y + self.size, x : x + self.size] += shown
        self.bars.bar_shown(place, shown)
        self.ledger.laid[name] = place
        self.step(name)

    def cut(self, opening: Opening, place: Place) -> NDArray[np.bool_]:
        """Where a patch lies that is cut in at a place; if places are known, near cuts at smaller scales."""
        draft = None
        if self.places_known:
            for scale in (self.small, *self.between):
                draft = scale.cut(opening, place, draft)[1]
        return self.full.cut(opening, place, draft)[1]

    def _find(self, name: str, opening: Opening, blocks: NDArray[np.int64]) -> dict[Place, float]:
        """The best places for a patch and their scores, in the first block of the sheet that has any."""
        for block in blocks:
            top, left = self.matcher.blocks[block][:2]
            score = self._score(int(block), opening)

            def inside(places: Iterable[Place], top: int = top, left: int = left) -> list[Place]:
                return [(y - top, x - left) for y, x in places]

            if self.manner.jointly:
                self._bar_if_others_are_left(score, inside(opening.shown), self.exclusion)
            else:
                bar_places(score, inside(opening.shown), self.exclusion)
            bar_places(score, inside(self.ledger.rejected.get(name, ())), self.size / 4)
            self._bar_if_others_are_left(score, inside(opening.earlier), opening.spacing * self.exclusion)
            count = round(opening.candidates * self.manner.candidates)
            found = best_places(score, count, max(1, round(APART * self.size)))
            if found:
                return {(y + top, x + left): float(score[y, x]) for y, x in found}
        return {}

    def _bar_if_others_are_left(
        self, score: NDArray[np.float32], earlier: Sequence[Place], radius: float
    ) -> None:
        """Bar places near earlier patches, in a radius up to this one and so small that some places stay."""
        while radius >= 1:
            trial = score.copy()
            bar_places(trial, earlier, radius)
            if np.isfinite(trial).any():
                score[...] = trial
                return
            radius /= 2

    def _cut_all(
        self,
        scale: Scale,
        opening: Opening,
        promise: dict[Place, float],
        drafts: Mapping[Place, NDArray[np.bool_]],
    ) -> list[Cut]:
        """The cuts of several places, best first; near their drafts, if there are any."""
        cuts = self.pool.map(lambda place: scale.cut(opening, place, drafts.get(place)), promise)
        found = [
            Cut(place, where, energy * promise[place])
            for place, (energy, where) in zip(promise, cuts, strict=True)
        ]
        return sorted(found, key=lambda cut: cut.cost)

    def _score(self, block: int, opening: Opening) -> NDArray[np.float32]:
        """Lower is better, for every place of a block; infinite where the patch would leave the sources."""
        free = self._free(opening)[self.matcher.inside(block)]
        if not free.any():
            return np.full(free.shape, np.inf, np.float32)
        state = opening.state
        weight = np.where(state == OPEN, opening.weight, 0)
        color, tone = self.matcher.distances(block, opening.canvas, weight)
        score = color + np.float32(TONE) * tone
        # What stays of the patch is about its core: a box as large, around the window's middle.
        side = max(1, round(float(np.sqrt((state == FORCED_NEW).sum()))))
        score *= 1 + np.float32(USAGE) * self._around(self.used, side, block)
        if opening.plainness and self.period is None:
            score *= 1 + np.float32(opening.plainness) * self._conspicuous_around(side, block)
        score[~free] = np.inf
        return score

    def _free(self, opening: Opening) -> NDArray[np.bool_]:
        """Places whose windows lie in the sources, in step with the lattice, and show nothing barred."""
        kept = self.bars.in_step(self.matcher.places(opening.sources), *opening.lines)
        if opening.barred is None:
            return kept
        open_ = kept & ~opening.barred
        return open_ if open_.sum() > FEWEST_OPEN * kept.sum() else kept

    def _around(self, field: NDArray[np.float32], side: int, block: int) -> NDArray[np.float32]:
        """Mean of a field of the sheet over a box in the middle of each window of a block."""
        half = self.size // 2
        top, left, height, width = self.matcher.blocks[block]
        mean = uniform_filter(field[top : top + height, left : left + width], side, mode="nearest")
        return mean[half : height - self.size + half + 1, half : width - self.size + half + 1]

    def _conspicuous_around(self, side: int, block: int) -> NDArray[np.float32]:
        """`_around` of what stands out, kept: patches of a kind ask for boxes of one size."""
        if (block, side) not in self._means:
            if len(self._means) == MEANS:
                self._means.clear()
            self._means[block, side] = self._around(self.conspicuous, side, block)
        return self._means[block, side]

    def conspicuous_at(
        self, rows: NDArray[np.int64], columns: NDArray[np.int64], side: int
    ) -> NDArray[np.float32]:
        """How much boxes around the given sheet pixels stand out."""
        return uniform_filter(self.conspicuous, side, mode="nearest")[rows, columns]

    def checked_pick(self, name: str) -> Place:
        """The place picked for a patch, if a window fits there."""
        y, x = self.ledger.picked[name]
        if not self.matcher.holds(y, x, self.size):
            raise TilewrightValueError(
                f"the place picked for {name} does not leave room for a tile of {self.size} pixels "
                "inside its source and mask"
            )
        return y, x


def conspicuousness(sheet: Sheet, size: int) -> NDArray[np.float32]:
    """How much each place stands out: tone away from the mean, contrast away from the usual; mean 1."""
    mean = sheet.features[sheet.usable].mean(axis=0)
    low = sheet.low_pass(size / 8)
    tone = sum_channels((low - mean) ** 2)
    fine = sum_channels((sheet.low_pass(2.0) - low) ** 2)
    contrast = gaussian_filter(fine, size / 16)
    contrast -= contrast[sheet.usable].mean()
    contrast = np.maximum(contrast, -np.float32(BLAND) * contrast)
    tone, contrast = (
        (0.5 * part / max(float(part[sheet.usable].mean()), 1e-9)).astype(np.float32)
        for part in (tone, contrast)
    )
    return tone + contrast
