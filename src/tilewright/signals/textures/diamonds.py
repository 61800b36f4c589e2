"""Texture tiles with colored edges: one sample of the exemplar for each edge color (Cohen et al. 2003)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.signals.textures.corners import SHOWN, integer_features, squared_distances
from tilewright.signals.textures.frame import Frame
from tilewright.signals.textures.nested import center_opening, even, inside_border, lay_centers
from tilewright.signals.textures.patchwork import FORCED_NEW, FORCED_OLD, OPEN, Patchwork, stack
from tilewright.signals.textures.search import CONTEXT, CONTEXT_SIGMA, PatchSearch, Place
from tilewright.tiles import TileSet

OVERLAP = 0.11
"""Half the width in which two samples are cut, in tiles."""
SAMPLES = 500
"""Places among which the samples are chosen."""
STARTS = 64
"""Sets of samples the search starts from."""
_NORTH, _EAST, _SOUTH, _WEST = range(4)


def lay_diamonds(search: PatchSearch, tiles: TileSet, rng: np.random.Generator) -> Patchwork:
    """Cohen et al. 2003, section 3.2: diamonds that meet in cuts along the tile's diagonals."""
    frame = Frame(search.size)
    # Step 1: a diamond-shaped sample of the photograph for each edge color (section 3.2).
    samples = choose_samples(search, tiles, rng)
    # Step 2: the four samples of a tile's edges, combined along the best cuts (same section).
    return stack([_join(search, frame, samples, slots, _near_diagonals(frame)) for slots in tiles.slots])


def lay_burke(search: PatchSearch, tiles: TileSet, rng: np.random.Generator) -> Patchwork:
    """Lagae & Dutré 2006, figure 6b: samples fill halves of the tile.

    The north and south samples fill the halves, and the east and west samples are cut over them anywhere in
    their halves. The figure is all that the papers tell of Burke's variant, and no text of it was found:
    this is a reading of its caption.
    """
    frame = Frame(search.size)
    samples = choose_samples(search, tiles, rng)
    return stack([_join(search, frame, samples, slots, inside_border(frame)) for slots in tiles.slots])


def lay_diamonds_with_centers(
    search: PatchSearch, tiles: TileSet, rng: np.random.Generator, variants: int = 1
) -> Patchwork:
    """Cohen's diamonds under a patch of its own in the middle of each variant of each tile."""
    frame = Frame(search.size)
    # Step 1: a sample for each edge color, plain ones first.
    samples = choose_samples(search, tiles, rng, search.manner.plainness[0])
    openings = []
    for slots in tiles.slots:
        # Step 2: the four samples of the tile's edges, combined as in Cohen et al. 2003, section 3.2.
        canvas = _join(search, frame, samples, slots, _near_diagonals(frame))
        # Step 3: a patch of the tile's own over their seams, as corner tiles have (Lagae & Dutré 2006, 5.1).
        shown = [samples.in_tile(frame, side, slots) for side in range(4)]
        openings.append(center_opening(search, frame, canvas, (0,), shown))
    return lay_centers(search, openings.__getitem__, len(openings), variants)


@dataclass(frozen=True)
class Samples:
    """A place for each color of the horizontal and of the vertical edges, in the canvas of the edge."""

    horizontal: list[Place]
    vertical: list[Place]

    def in_tile(self, frame: Frame, side: int, slots: NDArray[np.uint8]) -> Place:
        """The place of the sample at a side of a tile, in the canvas of the tile."""
        y, x = (self.horizontal, self.vertical)[side % 2][slots[side]]
        dy, dx = frame.edge_offset(side)
        return y + dy, x + dx


def choose_samples(
    search: PatchSearch, tiles: TileSet, rng: np.random.Generator, plainness: float = 0.0
) -> Samples:
    """Sets of samples are improved one sample at a time until the total misfit no longer falls.

    The misfit of a horizontal and a vertical sample is their squared distance along the four
    half-diagonals where they can meet; every pair meets in a complete set and in Cohen's sets. With
    ``plainness``, conspicuous samples are marked down.
    """
    # Step 1: candidates, some at random, and those that were picked by hand.
    y, x = search.matcher.places((0,)).nonzero()
    if not len(y):
        raise TilewrightValueError(
            f"has no usable square of {search.size + 2} pixels, which tiles of {search.size} pixels need",
            argument="source 0",
            advice="choose a smaller tile size or a larger photograph",
        )
    pick = np.sort(rng.choice(len(y), min(SAMPLES, len(y)), replace=False))
    y, x = y[pick], x[pick]
    counts = (tiles.colors[0], tiles.colors[1])
    names = [f"edge-h:{c}" for c in range(counts[0])] + [f"edge-v:{c}" for c in range(counts[1])]
    y = np.concatenate([y, [search.ledger.picked[n][0] for n in names if n in search.ledger.picked]]).astype(
        int
    )
    x = np.concatenate([x, [search.ledger.picked[n][1] for n in names if n in search.ledger.picked]]).astype(
        int
    )
    fixed, nth = {}, len(pick)
    for slot, name in enumerate(names):
        if name in search.ledger.picked:
            search.checked_pick(name)
            fixed[slot], nth = nth, nth + 1
    # Step 2: what may not be chosen: places rejected for a color, and places too near each other.
    barred = np.zeros((len(names), len(y)), bool)
    for slot, name in enumerate(names):
        for ry, rx in search.ledger.rejected.get(name, ()):
            barred[slot] |= (y - ry) ** 2 + (x - rx) ** 2 < (search.size / 4) ** 2
    near = (y[:, None] - y) ** 2 + (x[:, None] - x) ** 2 < (search.size / 2) ** 2
    # Step 3: how badly every two of them meet along a tile's diagonals.
    misfit = _misfit(search, y, x)
    if plainness and search.period is None:
        half, side = search.size // 2, round(SHOWN * search.size)
        penalty = 1 + plainness * search.conspicuous_at(y + half, x + half, side)
        misfit *= (penalty[:, None] + penalty) / 2
    # Step 4: the set of samples that meet best.
    chosen = _improve(misfit, near, barred, counts, fixed, rng)
    for name, sample in zip(names, chosen, strict=True):
        search.ledger.laid[name] = (int(y[sample]), int(x[sample]))
        search.step(name)
    places = [search.ledger.laid[n] for n in names]
    return Samples(places[: counts[0]], places[counts[0] :])


def _misfit(search: PatchSearch, y: NDArray[np.int64], x: NDArray[np.int64]) -> NDArray[np.float64]:
    """misfit[a, b] of sample a on horizontal edges and sample b on vertical ones."""
    frame = Frame(search.size)
    features = integer_features(search.sheet)
    band = _near_diagonals(frame) & (np.hypot(frame.u, frame.v) < frame.half)
    total = np.zeros((len(y), len(y)))
    for horizontal in (_NORTH, _SOUTH):
        for vertical in (_EAST, _WEST):
            quadrant = (frame.v < 0) == (horizontal == _NORTH)
            quadrant &= (frame.u < 0) == (vertical == _WEST)
            i, j = (c[:: max(1, search.size // 24)] for c in (band & quadrant).nonzero())
            pixels = []
            for side in (horizontal, vertical):
                dy, dx = frame.edge_offset(side)
                pixels.append(features[y[:, None] + i + dy, x[:, None] + j + dx].reshape(len(y), -1))
            total += squared_distances(*pixels)
    return total


def _improve(
    misfit: NDArray[np.float64],
    near: NDArray[np.bool_],
    barred: NDArray[np.bool_],
    counts: tuple[int, int],
    fixed: dict[int, int],
    rng: np.random.Generator,
) -> list[int]:
    """The best set of samples over several random starts."""
    slots = sum(counts)
    best, best_error = None, np.inf
    for _ in range(STARTS):
        chosen = [fixed.get(s, int(rng.integers(len(misfit)))) for s in range(slots)]
        error = np.inf
        for _ in range(8):
            for slot in range(slots):
                if slot in fixed:
                    continue
                others = chosen[counts[0] :] if slot < counts[0] else chosen[: counts[0]]
                total = misfit[:, others].sum(axis=1) if slot < counts[0] else misfit[others].sum(axis=0)
                rest = [c for s, c in enumerate(chosen) if s != slot]
                total = np.where(near[rest].any(axis=0) | barred[slot], np.inf, total)
                if np.isfinite(total.min()):
                    chosen[slot] = int(np.argmin(total))
            crowded = any(near[a, b] for s, a in enumerate(chosen) for b in chosen[:s])
            crowded |= any(barred[s, c] for s, c in enumerate(chosen))
            after = np.inf if crowded else misfit[np.ix_(chosen[: counts[0]], chosen[counts[0] :])].sum()
            if after >= error:
                break
            error = after
        if error < best_error:
            best, best_error = list(chosen), error
    if best is None:
        raise TilewrightValueError(
            f"the exemplar is too small for {slots} samples that lie half a tile apart",
            advice="choose a smaller tile size, fewer colors or a larger photograph",
        )
    return best


def _near_diagonals(frame: Frame) -> NDArray[np.bool_]:
    """Where the cut between a horizontal and a vertical sample may run."""
    off = np.abs(np.abs(frame.u) - np.abs(frame.v))
    return (off < OVERLAP * frame.size * np.sqrt(2)) & inside_border(frame)


def _join(
    search: PatchSearch,
    frame: Frame,
    samples: Samples,
    slots: NDArray[np.uint8],
    cuttable: NDArray[np.bool_],
) -> Patchwork:
    """A tile: north over south, then west and east cut in, each in its own half."""
    place = [samples.in_tile(frame, side, slots) for side in range(4)]
    # Step 1: the south half of the north edge's sample above the north half of the south edge's.
    canvas = Patchwork.of_patch(frame.size, frame.size, place[_SOUTH]).with_patch(place[_NORTH], frame.v < 0)
    # Step 2: the west and east samples in their triangles, as far as the best cut lets them.
    for side in (_WEST, _EAST):
        half = (frame.u < 0) == (side == _WEST)
        state = np.where(frame.triangles[side], FORCED_NEW, FORCED_OLD).astype(np.uint8)
        state[half & cuttable] = OPEN
        state[half & (np.abs(frame.u) > 0.9 * frame.half) & frame.triangles[side]] = FORCED_NEW
        canvas = canvas.with_cut(
            search.sheet, place[side], state, even(frame), CONTEXT, CONTEXT_SIGMA * frame.size
        )
    return canvas
