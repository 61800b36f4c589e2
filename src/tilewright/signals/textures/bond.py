"""Bond: how courses of both directions go together, as in a running bond, a basket weave or a herringbone.

Where rows and columns both have courses, their crossings need not be alike: in a running bond a joint lies
at every second one only, and in a herringbone at every eighth. The crossings at which the photograph has the
same outlines form a lattice of their own, and patches that keep it carry on the pattern.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, rfft2
from scipy.ndimage import gaussian_filter, map_coordinates

from tilewright.signals.textures.rhythm import Rhythm

SAMPLES = 12
"""Samples along a course in which outlines are compared."""
MOST_ROWS, MOST_COLUMNS = 4, 16
"""The largest bonds that are looked for, in courses: `Bond.rows` and `Bond.columns`."""
ALIKE = 0.16
"""Correlation of outlines, what is common to all crossings taken off, from which crossings are alike. It is
0.6 to 0.9 in drawn bonds, whose bricks differ in color, 0.22 with rough bricks of 24 x 8 pixels, and at most
0.11 where there is none."""
FEW = 0.1
"""Share of the distances at which crossings of a bond may be less alike than is counted."""
NEARLY = 0.85
"""Share of the highest correlation from which a bond is as good as another, so that the smallest is taken."""


@dataclass(frozen=True)
class Bond:
    """Which crossings of courses are alike.

    Attributes
    ----------
    rows, columns : int
        Crossing (i, j) is like (0, 0) if i is a whole number of ``rows``, n, and j one of ``columns`` beyond
        n x ``shift``.
    shift : int
        Courses by which like columns move from one of these rows to the next.
    """

    rows: int = 1
    columns: int = 1
    shift: int = 0

    @property
    def size(self) -> int:
        """One crossing in so many is like another."""
        return self.rows * self.columns

    def alike(self, i: NDArray[np.int64], j: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Whether crossings (i, j) are like (0, 0)."""
        return np.asarray((i % self.rows == 0) & ((j - i // self.rows * self.shift) % self.columns == 0))

    def fits(self, i: NDArray[np.int64], j: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Whether tiles of i x j courses are all like one another."""
        none = np.zeros_like(i)
        return self.alike(i, none) & self.alike(none, j)


ALL_ALIKE = Bond()
"""The bond of a photograph whose crossings are all alike."""


def find_bond(gray: NDArray[np.float32], rows: Rhythm, columns: Rhythm) -> Bond:
    """The bond of a photograph whose rows and columns have courses.

    Parameters
    ----------
    gray : float32 array, shape (h, w)
        Its brightness, as the eye sees it.
    rows, columns : Rhythm
        Its courses.

    Returns
    -------
    Bond
        Of one row and one column where all crossings are alike.
    """
    # Step 1: outlines, by crossing.
    outlines = _by_crossing(_outlines(gray), rows, columns)
    # Step 2: what is common to all crossings tells nothing of how they differ.
    outlines -= outlines.mean(axis=(0, 1))
    # Step 3: how alike crossings are, by how far apart they lie.
    likeness = _correlation(outlines)
    # Step 4: the lattice whose crossings are the most alike; of those that hold one another, the densest.
    scores = {bond: _likeness_of(bond, likeness) for bond in _all_bonds(outlines.shape[:2])}
    best = max(scores.values(), default=0.0)
    if best < ALIKE:
        return ALL_ALIKE
    return min((b for b, s in scores.items() if s >= NEARLY * best), key=lambda b: (b.size, b.rows))


def _outlines(gray: NDArray[np.float32]) -> NDArray[np.float32]:
    """How steep the brightness is, so that strong outlines do not outweigh the others."""
    dy, dx = np.gradient(gaussian_filter(gray, 1.0))
    return np.asarray(np.sqrt(np.hypot(dy, dx)), np.float32)


def _by_crossing(picture: NDArray[np.float32], rows: Rhythm, columns: Rhythm) -> NDArray[np.float64]:
    """A picture sampled in step with its courses, shape (courses, courses, `SAMPLES` ** 2)."""
    at = []
    for rhythm in (rows, columns):
        first, last = np.ceil(rhythm.phase[0]), np.floor(rhythm.phase[-1])
        phases = first + (np.arange(int(last - first) * SAMPLES) + 0.5) / SAMPLES
        at.append(np.interp(phases, rhythm.phase, np.arange(len(rhythm.phase))))
    sampled = map_coordinates(picture, np.meshgrid(*at, indexing="ij"), order=1, mode="nearest")
    r, c = (len(places) // SAMPLES for places in at)
    cut = sampled.astype(np.float64).reshape(r, SAMPLES, c, SAMPLES).swapaxes(1, 2)
    return cut.reshape(r, c, SAMPLES * SAMPLES)


def _correlation(crossings: NDArray[np.float64]) -> NDArray[np.float64]:
    """Correlation of crossings (i, j) apart, at [i, j], j from -w/2 wrapping around; 0 where few overlap."""
    r, c, _ = crossings.shape
    size = (2 * r, 2 * c)

    def correlate(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
        """Sums of products over what overlaps."""
        products = np.conj(rfft2(a, size, axes=(0, 1))) * rfft2(b, size, axes=(0, 1))
        return np.asarray(irfft2(products.sum(axis=2), size))

    one, power = np.ones((r, c, 1)), (crossings**2).sum(axis=2, keepdims=True)
    both = np.sqrt(np.maximum(correlate(power, one) * correlate(one, power), 0))
    enough = correlate(one, one) > r * c / 8
    return np.asarray(
        np.where(enough & (both > 1e-9 * power.sum()), correlate(crossings, crossings), 0)
        / np.maximum(both, 1e-300)
    )


def _all_bonds(shape: tuple[int, ...]) -> list[Bond]:
    """Every bond but that of one crossing which a picture of so many courses shows again."""
    most_rows, most_columns = (
        min(most, n * 3 // 4) for most, n in zip((MOST_ROWS, MOST_COLUMNS), shape, strict=True)
    )
    return [
        Bond(rows, columns, shift)
        for rows in range(1, most_rows + 1)
        for columns in range(1, most_columns + 1)
        for shift in range(columns)
        if rows * columns > 1
    ]


def _likeness_of(bond: Bond, likeness: NDArray[np.float64]) -> float:
    """How alike nearly all crossings are that a bond says are, less the mean of all others.

    Those that its own two steps lead to are among them.
    """
    height, width = (n // 2 for n in likeness.shape)
    i, j = np.meshgrid(np.arange(height), np.arange(-width + 1, width), indexing="ij")
    told = likeness[i, j]
    known = (told != 0) & ((i > 0) | (j > 0))
    alike = bond.alike(i, j)
    if not (known & alike).any() or not (known & ~alike).any():
        return 0.0
    least = min(
        np.quantile(told[known & alike], FEW), likeness[0, bond.columns], likeness[bond.rows, bond.shift]
    )
    return float(least - max(0.0, told[known & ~alike].mean()))
