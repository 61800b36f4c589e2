"""Choose the corner patches jointly, so that any two of them meet well across an edge."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter

from tilewright.errors import TilewrightValueError
from tilewright.signals.textures.plan import Plan
from tilewright.signals.textures.search import PatchSearch, Place
from tilewright.signals.textures.sheet import Sheet

SAMPLES = 1200
"""Random positions among which the corner patches are chosen."""
ARM = 0.22
"""Half the length of the strips that are compared, in tiles."""
SHOWN, SHOWN_ALONE = 0.35, 0.6
"""Side of what stays of a corner patch, in tiles, and the same where no patches of the edges cover it."""
EVENNESS = 4.0
"""What it counts that all chosen places together are off the photograph's mean, in variances of the mean of
as many places by chance; where corner patches are most of what is seen."""
SWEEPS = 5
"""Times that every corner patch is chosen anew for the others."""


def choose_corners(search: PatchSearch, plan: Plan, overlap: int, rng: np.random.Generator) -> list[Place]:
    """A position for each corner patch: the sheet pixel that lies on the lattice point.

    The strips on either side of an edge's middle are compared for every ordered pair of positions
    (first after second, east and south); positions are added one by one so that the sum over all pairs
    is least. All are at least half a tile apart.
    """
    if search.kept is not None and not search.kept.moves_corners:
        return _record_picked(search, plan)
    # Step 1: places at random, where the papers take one for each color (Lagae & Dutré 2006, section 5.1).
    candidates = _candidates(search, plan, overlap, rng)
    # Step 2: how badly any two of them meet across an edge, and how conspicuous each is.
    misfit = _misfit(search, candidates.rows, candidates.columns, overlap)
    penalty = np.ones(len(candidates.rows))
    if search.period is None:
        side = round(SHOWN * search.size)
        plainness = search.manner.plainness[0]
        penalty += plainness * search.conspicuous_at(candidates.rows, candidates.columns, side)
    # Step 3: one place after the other, each the one that meets those before it best.
    chosen = dict(candidates.picked)
    for corner in range(len(plan.corner_sources)):
        if corner not in chosen:
            chosen[corner] = _next_corner(candidates, misfit, penalty, chosen, corner, search.size)
    return _record(search, [candidates.place(chosen[c]) for c in range(len(plan.corner_sources))])


def choose_meeting_corners(
    search: PatchSearch, plan: Plan, overlap: int, rng: np.random.Generator
) -> list[Place]:
    """A position for each corner patch, so that those meet well that can meet in a tiling.

    As `choose_corners`, but a sum over the pairs at the ends of the plan's edges alone, and made less by
    choosing one patch after the other anew (coordinate descent).
    """
    if search.places_known or (search.kept is not None and not search.kept.moves_corners):
        return _record_picked(search, plan)
    # Step 1: places in step with the lattice, without lone things as far as there are others.
    candidates = _candidates(search, plan, overlap, rng)
    # Step 2: how badly any two of them meet, and how conspicuous each is.
    east, south = _misfits(search, candidates.rows, candidates.columns, overlap)
    penalty = np.ones(len(candidates.rows))
    if search.period is None:
        side = round((SHOWN_ALONE if search.manner.plain_edges else SHOWN) * search.size)
        plainness = search.manner.plainness[0]
        penalty += plainness * search.conspicuous_at(candidates.rows, candidates.columns, side)
    if search.manner.popping:
        penalty += search.manner.popping * search.bars.popping_at(candidates.rows, candidates.columns)
    # Step 3: every patch in turn at the place that meets its neighbors best, far from the others.
    near = ~candidates.apart(search.size)
    offsets = _offsets(search, candidates) if search.manner.plain_edges else None
    chosen = dict(candidates.picked)
    for sweep in range(SWEEPS):
        before = dict(chosen)
        for corner in range(len(plan.corner_sources)):
            if corner in candidates.picked:
                continue
            others = [place for c, place in chosen.items() if c != corner]
            total = np.diag(east) + np.diag(south) if sweep == 0 else np.zeros(len(penalty))
            for edge in plan.edges:
                misfit = (east, south)[edge.axis]
                if edge.first == corner == edge.second:
                    total = total + np.diag(misfit)
                elif edge.first == corner and edge.second in chosen:
                    total = total + misfit[:, chosen[edge.second]]
                elif edge.second == corner and edge.first in chosen:
                    total = total + misfit[chosen[edge.first]]
            if offsets is not None:
                total = total * (1 + EVENNESS * _unevenness(offsets, others))
            total = np.where(candidates.free[corner], total * penalty, np.inf)
            chosen[corner] = _least(total, np.asarray(near[others].any(axis=0)), corner, search.size)
        if chosen == before:
            break
    return _record(search, [candidates.place(chosen[c]) for c in range(len(plan.corner_sources))])


def _offsets(search: PatchSearch, candidates: "_Candidates") -> NDArray[np.float64]:
    """How far the mean of each place's surroundings is off the photograph's, shape (candidates, k)."""
    side = round(SHOWN_ALONE * search.size)
    features = integer_features(search.sheet)
    means = uniform_filter(features, (side, side, 1), mode="nearest")
    return means[candidates.rows, candidates.columns] - features[search.sheet.usable].mean(axis=0)


def _unevenness(offsets: NDArray[np.float64], others: list[int]) -> NDArray[np.float64]:
    """The squared offset of the mean of each place and others, over what it is by chance."""
    count = len(others) + 1
    mean = (offsets + offsets[others].sum(axis=0)) / count
    by_chance = (offsets**2).sum(axis=1).mean() / count
    return np.asarray((mean**2).sum(axis=1) / max(by_chance, 1e-9))


def _least(total: NDArray[np.float64], near: NDArray[np.bool_], corner: int, size: int) -> int:
    """The least of those not near the others, or of all where none is left."""
    apart = np.where(near, np.inf, total)
    best = int(np.argmin(apart if np.isfinite(apart).any() else total))
    if not np.isfinite(total[best]):
        raise TilewrightValueError(
            f"no place is left for corner patch {corner}: the exemplar is too small for tiles of {size} "
            "pixels"
        )
    return best


def random_corners(search: PatchSearch, plan: Plan, rng: np.random.Generator) -> list[Place]:
    """A random position for each corner patch, as in the papers; the artist's choices are kept."""
    candidates = _candidates(search, plan, 0, rng)
    # The next place is the one of least misfit: a number of its own by chance.
    order = rng.permutation(len(candidates.rows)).astype(float)
    chosen = dict(candidates.picked)
    for corner in range(len(plan.corner_sources)):
        if corner not in chosen:
            misfit = np.zeros((len(order), len(order)))
            misfit[np.diag_indices(len(order))] = order
            chosen[corner] = _next_corner(
                candidates, misfit, np.ones(len(order)), chosen, corner, search.size
            )
    return _record(search, [candidates.place(chosen[c]) for c in range(len(plan.corner_sources))])


@dataclass(frozen=True, eq=False)
class _Candidates:
    """Positions a corner patch may be taken from, as sheet coordinates; the picked ones come last."""

    rows: NDArray[np.int64]
    columns: NDArray[np.int64]
    free: dict[int, NDArray[np.bool_]]
    picked: dict[int, int]

    def place(self, number: int) -> Place:
        return int(self.rows[number]), int(self.columns[number])

    def apart(self, size: int) -> NDArray[np.bool_]:
        y, x = self.rows, self.columns
        return (y[:, None] - y) ** 2 + (x[:, None] - x) ** 2 >= (size / 2) ** 2


def _candidates(search: PatchSearch, plan: Plan, overlap: int, rng: np.random.Generator) -> _Candidates:
    """Random positions in each source, less the rejected ones, and the picked ones."""
    samples = {s: _sample(search, s, overlap, rng) for s in sorted(set(plan.corner_sources))}
    named = {c: search.ledger.picked.get(f"corner:{c}") for c in range(len(plan.corner_sources))}
    picked = {c: place for c, place in named.items() if place is not None}
    for corner in picked:
        check_picked_corner(search, f"corner:{corner}", search.size // 2 + overlap)
    rows = np.concatenate([p[0] for p in samples.values()] + [np.array([p[0] for p in picked.values()], int)])
    columns = np.concatenate(
        [p[1] for p in samples.values()] + [np.array([p[1] for p in picked.values()], int)]
    )
    sources = np.concatenate([np.full(len(p[0]), s) for s, p in samples.items()] + [np.full(len(picked), -1)])
    free = {}
    for corner, source in enumerate(plan.corner_sources):
        free[corner] = sources == source
        for y, x in search.ledger.rejected.get(f"corner:{corner}", ()):
            free[corner] &= (rows - y) ** 2 + (columns - x) ** 2 >= (search.size / 4) ** 2
    first = len(rows) - len(picked)
    return _Candidates(rows, columns, free, {c: first + n for n, c in enumerate(picked)})


def check_picked_corner(search: PatchSearch, name: str, reach: int) -> None:
    """Refuse a place picked for a corner patch that has not ``reach`` pixels around it."""
    y, x = search.ledger.picked[name]
    if not search.matcher.holds(y - reach, x - reach, 2 * reach):
        raise TilewrightValueError(
            f"the place picked for {name} is nearer than {reach} pixels to the border of its source or mask"
        )


def _next_corner(
    candidates: _Candidates,
    misfit: NDArray[np.float64],
    penalty: NDArray[np.float64],
    chosen: dict[int, int],
    corner: int,
    size: int,
) -> int:
    """The position that fits itself and those chosen so far best; the first also fits its best partner."""
    apart = candidates.apart(size)
    own = np.diag(misfit)
    open_ = candidates.free[corner].copy()
    if not chosen and len(candidates.free) > 1:
        second = next(c for c in candidates.free if c != corner)
        pairs = (misfit + misfit.T + own[:, None] + own) * (0.5 * (penalty[:, None] + penalty))
        pairs[~apart] = np.inf
        pairs[:, ~candidates.free[second]] = np.inf
        total = pairs.min(axis=1)
    else:
        total = own.copy()
        for other in chosen.values():
            total += misfit[:, other] + misfit[other]
            open_ &= apart[:, other]
        total = total * penalty
    total[~open_] = np.inf
    best = int(np.argmin(total))
    if not np.isfinite(total[best]):
        raise TilewrightValueError(
            f"no place is left for corner patch {corner}: the exemplar is too small for "
            f"{len(candidates.free)} corner colors with tiles of {size} pixels"
        )
    return best


def _record_picked(search: PatchSearch, plan: Plan) -> list[Place]:
    """Corner patches that are all where they were picked."""
    return _record(search, [search.ledger.picked[f"corner:{c}"] for c in range(len(plan.corner_sources))])


def _record(search: PatchSearch, corners: list[Place]) -> list[Place]:
    for number, place in enumerate(corners):
        search.ledger.laid[f"corner:{number}"] = place
        search.step(f"corner:{number}")
    return corners


def _sample(
    search: PatchSearch, source: int, overlap: int, rng: np.random.Generator
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Random positions whose surroundings, half a tile and the overlap, lie inside the source."""
    reach = search.size // 2 + overlap
    places = search.matcher.places_of_size(2 * reach, (source,))
    y, x = search.bars.open_corners(places, reach).nonzero()
    if not len(y):
        raise TilewrightValueError(
            f"has no usable square of {2 * reach + 2} pixels, which tiles of {search.size} pixels need",
            argument=f"source {source}",
            advice="choose a smaller tile size or a larger photograph",
        )
    # Half of them where they are few, as of bonds: else all seeds would choose among the same.
    most = -(-len(y) // 2) if search.manner.jointly else len(y)
    pick = np.sort(rng.choice(len(y), min(SAMPLES, most), replace=False))
    return y[pick] + reach, x[pick] + reach


def _misfit(
    search: PatchSearch, rows: NDArray[np.int64], columns: NDArray[np.int64], overlap: int
) -> NDArray[np.float64]:
    """misfit[a, b]: how badly b continues a towards the east and towards the south."""
    east, south = _misfits(search, rows, columns, overlap)
    return east + south


def _misfits(
    search: PatchSearch, rows: NDArray[np.int64], columns: NDArray[np.int64], overlap: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """[a, b] of each: how badly b continues a towards the east, and towards the south."""
    half, arm = search.size // 2, int(ARM * search.size)
    step = max(2, search.size // 48)
    features = integer_features(search.sheet)

    def strips(dy: tuple[int, int], dx: tuple[int, int]) -> NDArray[np.float64]:
        i, j = np.arange(*dy, step), np.arange(*dx, step)
        y = (rows[:, None] + i)[:, :, None]
        x = (columns[:, None] + j)[:, None, :]
        return features[y, x].reshape(len(rows), -1)

    along, near, far = (-arm, arm), (half - overlap, half + overlap), (-half - overlap, -half + overlap)
    east = squared_distances(strips(along, near), strips(along, far))
    return east, squared_distances(strips(near, along), strips(far, along))


def integer_features(sheet: Sheet) -> NDArray[np.float64]:
    """Features as whole numbers, so that sums of products are exact.

    In whatever order a matrix product adds them up: the choice must not depend on the number of threads.
    """
    return np.round(sheet.features.astype(np.float64) * 64)


def squared_distances(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mean squared distance of every row of ``a`` to every row of ``b``."""
    squares = (a * a).sum(axis=1)[:, None] + (b * b).sum(axis=1)
    return (squares - 2 * (a @ b.T)) / a.shape[1]
