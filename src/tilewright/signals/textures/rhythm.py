"""Rhythm: the courses of a photograph, which follow one another evenly or nearly so.

Paving, masonry and cloth are periodic as a whole even where no stone equals another: what repeats is the
profile, the mean of every row of pixels. Patches of such a photograph go together where their courses are in
step, and nowhere else. An even rhythm shows in the profile's correlation with itself; one whose courses
differ in height does not, and is found by following the thin lines between courses.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

Profile = NDArray[np.float64]

EVEN = 0.6
"""Correlation of a profile with itself one period farther from which it has that period. Of nine photographs
it was 0.71 and more where there is one to see, and at most 0.44 elsewhere; 0.55 for the columns of a wall
whose stones are of about one width."""
CLEAR = 2.5
"""How high all but the lowest tenth of the lines between courses stand above the profile elsewhere, in its
standard deviations, where the eye sees courses: 3.2 and 4.2 on paving and a wall; at most 1.9 elsewhere."""
TREND = 0.75
"""Standard deviation of what is taken off a profile before it is compared, in periods."""
SHORTEST, SHARE = 12, 4
"""Courses are at least this high, in pixels, and at least this many lie in the photograph."""
UNEVEN = 0.15
"""Share by which courses may be lower or higher than they are on the whole."""
HARMONICS = 4
"""Of a period, that tell it exactly."""
LINE = 1 / 12
"""Half the width of the lines between courses, in courses."""


@dataclass(frozen=True, eq=False)
class Rhythm:
    """Where courses begin along one axis of a photograph.

    Attributes
    ----------
    period : float
        Mean pixels from course to course.
    phase : float64 array, shape (n,)
        How many courses lie before every row of pixels; a whole number where one begins.
    even : bool
        Whether all courses are alike in height.
    """

    period: float
    phase: Profile
    even: bool

    def enlarged(self, step: int, count: int) -> "Rhythm":
        """The rhythm of the ``count`` rows of a photograph of which ``step`` were seen as one."""
        rows = (np.arange(count) + 0.5) / step - 0.5
        slope = 1 / self.period
        phase: Profile = np.interp(rows, np.arange(len(self.phase)), self.phase)
        # Beyond the middles of the outer rows it goes on evenly.
        phase = phase + slope * (np.minimum(rows, 0) + np.maximum(rows - len(self.phase) + 1, 0))
        return Rhythm(self.period * step, np.asarray(phase, np.float64), self.even)

    def reduced(self, step: int, count: int) -> "Rhythm":
        """The rhythm of ``count`` rows, each the mean of ``step`` rows of the photograph."""
        middles = (np.arange(count) + 0.5) * step - 0.5
        phase = np.interp(middles, np.arange(len(self.phase)), self.phase)
        return Rhythm(self.period / step, np.asarray(phase, np.float64), self.even)

    def misfit(self, length: int, line: float) -> Profile:
        """Pixels by which windows of ``length`` rows are out of step with tiles of that size.

        Tiles have courses of one height, and one begins at row ``line`` of the window. Element y is of the
        window that begins at row y.
        """
        off = self._courses_before(length, line)
        return np.abs(off - np.rint(off)).max(axis=1, initial=0) * self.period

    def course_at(self, length: int, line: int) -> NDArray[np.int64]:
        """Which course begins at row ``line`` of such windows, element y of the one from row y."""
        return np.rint(self._courses_before(length, line).mean(axis=1)).astype(np.int64)

    def _courses_before(self, length: int, line: float) -> NDArray[np.float64]:
        """Courses before row ``line`` of every window, as told by each of its rows, shape (windows, rows)."""
        count = max(0, len(self.phase) - length + 1)
        rows = np.arange(0, length, max(1, length // 64))
        courses = round(length / self.period)
        before = self.phase[np.arange(count)[:, np.newaxis] + rows] - (rows - line) * (courses / length)
        return np.asarray(before, np.float64)


def find_rhythm(gray: NDArray[np.float32], period: float | None) -> Rhythm | None:
    """The rhythm of the rows of a photograph, None where there is none.

    Parameters
    ----------
    gray : float32 array, shape (h, w)
        Its brightness, as the eye sees it.
    period : float or None
        Spacing of rows in pixels, where the profile's correlation shows one.
    """
    if period is not None and _evenness(gray, period) >= EVEN:
        return _even_rhythm(gray, _refined(gray, period))
    return _follow_lines(gray)


def _evenness(gray: NDArray[np.float32], period: float) -> float:
    """Correlation of the profile with itself one period farther, trends taken off."""
    profile = gray.mean(axis=1, dtype=np.float64)
    profile -= gaussian_filter1d(profile, TREND * period, mode="nearest")
    lag = round(period)
    if not 0 < lag < len(profile) - 2:
        return 0.0
    return max(float(np.corrcoef(profile[:-n], profile[n:])[0, 1]) for n in (lag - 1, lag, lag + 1) if n > 0)


def _refined(gray: NDArray[np.float32], period: float) -> float:
    """The period near this one at which the profile has most power, in its first harmonics together."""
    profile = gray.mean(axis=1, dtype=np.float64)
    profile = (profile - profile.mean()) * np.hanning(len(profile))
    near = period * np.linspace(0.95, 1.05, 201)
    harmonics = np.arange(1, HARMONICS + 1)[:, np.newaxis, np.newaxis] / near[:, np.newaxis]
    waves = np.exp(-2j * np.pi * harmonics * np.arange(len(profile)))
    return float(near[np.argmax((np.abs(waves @ profile) ** 2).sum(axis=0))])


def _even_rhythm(gray: NDArray[np.float32], period: float) -> Rhythm:
    """Courses begin where the profile, folded, differs most from its mean: there are the joints."""
    profile = gray.mean(axis=1, dtype=np.float64)
    profile -= gaussian_filter1d(profile, TREND * period, mode="nearest")
    rows = np.arange(len(profile))
    bins = max(4, round(period))
    slot = np.floor(rows / period % 1 * bins).astype(int)
    folded = np.bincount(slot, profile, bins) / np.maximum(np.bincount(slot, minlength=bins), 1)
    first = (int(np.argmax(np.abs(folded - folded.mean()))) + 0.5) / bins * period
    return Rhythm(period, np.asarray((rows - first) / period, np.float64), even=True)


def _follow_lines(gray: NDArray[np.float32]) -> Rhythm | None:
    """Courses between thin lines, lighter or darker than what lies beside them."""
    found: tuple[float, NDArray[np.int64]] | None = None
    longest = len(gray) / SHARE
    periods = SHORTEST * 1.12 ** np.arange(max(0, np.log(max(longest, 1) / SHORTEST)) // np.log(1.12) + 1)
    for period in periods[periods <= longest]:
        reach = max(2, round(LINE * period))
        ridge = _ridge_profile(gray, reach)
        for sign in (1.0, -1.0):
            lines = _best_chain(sign * ridge, period)
            clear = _clearness(sign * ridge, lines, reach)
            if len(lines) > SHARE and (found is None or clear > found[0]):
                found = clear, lines
    if found is None or found[0] < CLEAR:
        return None
    lines = found[1]
    period = float(np.diff(lines).mean())
    # Before the first line and after the last, courses of the mean height.
    before = lines[0] - period * np.arange(np.ceil(lines[0] / period) + 1, 0, -1)
    after = lines[-1] + period * np.arange(1, np.ceil((len(gray) - lines[-1]) / period) + 2)
    begins = np.concatenate([before, lines, after])
    phase = np.interp(np.arange(len(gray)), begins, np.arange(len(begins)))
    return Rhythm(period, phase, even=False)


def _ridge_profile(gray: NDArray[np.float32], reach: int) -> Profile:
    """How much every row differs from those ``reach`` above and below, on the mean; 0 near the ends."""
    smooth = gaussian_filter1d(gray, max(1, reach / 4), axis=0, mode="nearest").mean(axis=1, dtype=np.float64)
    ridge = np.zeros(len(smooth))
    if len(smooth) > 2 * reach:
        ridge[reach:-reach] = smooth[reach:-reach] - (smooth[: -2 * reach] + smooth[2 * reach :]) / 2
        ridge[reach:-reach] -= np.median(ridge[reach:-reach])
    return ridge


def _best_chain(ridge: Profile, period: float) -> NDArray[np.int64]:
    """Rows about a period apart whose ridges add up to most, by dynamic programming."""
    least, most = max(1, round(period * (1 - UNEVEN))), max(2, round(period * (1 + UNEVEN)))
    total, previous = ridge.copy(), np.full(len(ridge), -1)
    for row in range(least, len(ridge)):
        first = max(0, row - most)
        nearest = first + int(np.argmax(total[first : row - least + 1]))
        # A chain may begin in the first course only.
        if row >= most or total[nearest] > 0:
            total[row] += total[nearest]
            previous[row] = nearest
    row = len(ridge) - most + int(np.argmax(total[-most:]))
    chain = []
    while row >= 0:
        chain.append(row)
        row = int(previous[row])
    return np.array(chain[::-1])


def _clearness(ridge: Profile, lines: NDArray[np.int64], reach: int) -> float:
    """The lowest tenth of the lines over the standard deviation elsewhere."""
    inner = lines[(lines >= reach) & (lines < len(ridge) - reach)]
    elsewhere = np.ones(len(ridge), bool)
    elsewhere[:reach] = elsewhere[-reach:] = False
    for line in inner:
        elsewhere[line - reach : line + reach + 1] = False
    if not len(inner) or not elsewhere.any():
        return 0.0
    return float(np.quantile(ridge[inner], 0.1) / max(float(ridge[elsewhere].std()), 1e-9))
