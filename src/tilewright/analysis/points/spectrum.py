"""Power spectra of point sets by Bartlett's averaged periodograms (Lagae 2007, section 6.2.2)."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil, log10, nan, sqrt

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.points.checks import check_set, check_sets, check_shape
from tilewright.analysis.points.periodograms import (
    frequency_steps,
    half_periodogram,
    mean_half_periodogram,
    spectrum_shape,
    unfold,
)
from tilewright.analysis.points.rings import effective_nyquist, oscillation, oscillation_start
from tilewright.checks import check_flag, check_int, check_progress, check_type, type_error
from tilewright.errors import Progress, TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet
from tilewright.samplers.radius import max_radius
from tilewright.showing import describe_record

LARGEST_SIZE = 8192
_ZERO_POWER = 1e-10
"""Below this, power is what rounding leaves of nothing."""


def spectrum_size(count: int) -> int:
    """Tell the usual width of a periodogram: 2 / (0.75 r_max), up to the next power of two.

    It shows twice the principal frequency of a Poisson disk set of relative radius 0.75 to either side: 634,
    so 1024 for 16,384 points of the unit square. Eq. 6.6 of Lagae 2007 as printed, 1 / (0.75 r_max), is the
    half width.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1.

    Returns
    -------
    int
        Samples along a side.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        A count that is not an integer; a count out of range.
    """
    exact = 2 / (0.75 * max_radius(check_int("count", count, 1, 2**31 - 1), Box()))
    return 1 << (ceil(exact) - 1).bit_length()


def periodogram(points: PointSet, size: int | None = None) -> NDArray[np.float64]:
    """Measure |sum over the points x of exp(-2 pi i f . x)|^2 / N (Lagae 2007, eq. 6.1, times N).

    White noise has the mean power 1, and frequency 0 the power N. The frequencies are whole numbers of
    periods across the box, which is exact on a torus. On a plain box they give an estimate: sparse or
    crowded borders show as a cross along the axes; `power_spectrum` can leave that out.

    Parameters
    ----------
    points : PointSet
        In a plane, at least 3 points.
    size : int, optional
        Samples along a side of a square box, even, 8 to 8,192, which takes about 3 GB; by default 1,024 for
        16,384 points and larger for more, twice the principal frequency of a Poisson disk set of relative
        radius 0.75 to either side. A box of another shape keeps frequencies up to size / 2 periods in the
        square root of its area, so that it has about size h / sqrt(w h) rows and size w / sqrt(w h) columns.

    Returns
    -------
    float64 array, shape (rows, columns)
        Frequency (0, 0) is at [rows // 2, columns // 2], y first; the first row and column have the lowest.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        Something else than a `PointSet` and an integer; too few points, points outside the box, or a size
        that is not allowed.

    Examples
    --------
    >>> import tilewright as tw
    >>> power = tw.periodogram(tw.sample_points("dart", 1000, seed=1), size=64)
    >>> power.shape, round(float(power[32, 32]))
    ((64, 64), 1000)
    """
    given = check_set(points)
    check_shape(given.box)
    shape = spectrum_shape(given.box, _check_size(size, len(given)))
    return unfold(half_periodogram(shape, given))


@dataclass(frozen=True, eq=False)
class Spectrum:
    """The estimated power spectrum of a method of making points (Lagae 2007, section 6.2.2).

    Frequencies are in periods in the square root of the box's area, so whole numbers for the unit square.

    Attributes
    ----------
    sets : tuple of PointSet
        The K sets whose periodograms were averaged.
    power : float64 array, shape (rows, columns)
        Mean periodogram, as in `periodogram`, but 0 at frequency 0.
    radial : float64 array, shape (size // 2,)
        Mean power in the ring of width 1 around each whole frequency (eq. 6.3); 0 at frequency 0.
    anisotropy : float64 array, shape (size // 2,)
        Variance over squared mean in each ring, in dB (eq. 6.4); NaN where a ring has fewer than two samples
        or no power.
    samples : int64 array, shape (size // 2,)
        How many samples each ring has.
    tapered : bool
        Whether points weigh less towards the sides of the box, see `power_spectrum`.
    """

    sets: tuple[PointSet, ...]
    power: NDArray[np.float64]
    radial: NDArray[np.float64]
    anisotropy: NDArray[np.float64]
    samples: NDArray[np.int64]
    tapered: bool = False

    __repr__ = describe_record

    @property
    def count(self) -> float:
        """Mean number of points of a set."""
        return float(np.mean([len(s) for s in self.sets]))

    @property
    def reference(self) -> float:
        """Anisotropy of a radially symmetric spectrum estimated from K sets, -10 log10 K dB (eq. 6.2)."""
        return 10 * log10(1 / len(self.sets))

    @property
    def steps(self) -> tuple[float, float]:
        """Frequency from one row, and from one column, to the next; (1, 1) for squares."""
        return frequency_steps(self.sets[0].box)

    @property
    def effective_nyquist(self) -> float:
        """Of Heck, Schloemer & Deussen 2013, in units of sqrt(N) / 2, the square grid's Nyquist frequency.

        Half the largest frequency within which the mean power is below 0.1, where the spectrum first rises
        (to a mean of 0.5, at sqrt(N) / 2 or above): 1 for the square grid, 1.075 for the hexagonal one,
        0.59 for the highest step a spectrum can have, 0 for white noise. NaN if the spectrum ends before it
        rises. The threshold and the units are those of the authors' program psa.
        """
        return effective_nyquist(self.radial, self.samples, self.count)

    @cached_property
    def oscillation(self) -> float:
        """Omega of Heck, Schloemer & Deussen 2013: 10 times the RMS of the radial power less 1.

        From the first frequency f with a radial power of 0.98 up to f + 5 sqrt(N), each weighted by its
        ring's samples, as the authors' program psa does it; psa takes the radial power from distances, this
        from periodograms, 8192 wide at most. Taking so far a spectrum costs a few times what
        `power_spectrum` does. The noise of the estimate is in it: white noise of 16,384 points gives about
        0.1 for K = 10, 0.3 for K = 1.
        """
        start = oscillation_start(self.radial)
        last = start + 5 * sqrt(self.count)
        wide = min(2 * ceil(last + 1), LARGEST_SIZE)
        radial, samples = self.radial, self.samples
        if wide // 2 > len(radial):
            power = unfold(mean_half_periodogram(self.sets, wide, None, self.tapered))
            radial, _, samples = _average_annuli(power, self.steps, wide // 2)
        return oscillation(radial, samples, start, last)

    @property
    def figures(self) -> dict[str, float]:
        """Figures of the spectrum, by name.

        ``radial_peak`` and ``largest_bin`` are the highest mean of a ring and the highest single frequency;
        white noise has 1 in the mean. ``anisotropy_max``, ``anisotropy_p99`` and ``anisotropy_median`` are
        taken over the rings, in dB, without the lowest 16, which have too few samples to say anything.
        ``effective_nyquist`` and ``oscillation`` are the properties of these names.
        """
        rings = self.anisotropy[ANISOTROPY_FROM:]
        known = rings[~np.isnan(rings)]
        spread = np.percentile(known, (100, 99, 50)) if len(known) else (nan, nan, nan)
        return {
            "radial_peak": float(np.nanmax(self.radial)),
            "largest_bin": float(self.power.max()),
            "anisotropy_max": float(spread[0]),
            "anisotropy_p99": float(spread[1]),
            "anisotropy_median": float(spread[2]),
            "effective_nyquist": self.effective_nyquist,
            "oscillation": self.oscillation,
        }


ANISOTROPY_FROM = 16
"""First ring that counts in the figures of the anisotropy: about 100 samples, half of them mirror images."""


def power_spectrum(
    sets: PointSet | Sequence[PointSet],
    size: int | None = None,
    *,
    tapered: bool = False,
    progress: Progress | None = None,
) -> Spectrum:
    """Average the periodograms of K sets made by one method (Bartlett 1955; Lagae 2007, eq. 6.2 to 6.5).

    The result has the same bytes whatever the number of threads: each periodogram is made by one of them,
    and they are added in order.

    Parameters
    ----------
    sets : PointSet or list of PointSet
        Of one box; 10 sets of about 16,384 points in the thesis. Their numbers of points may differ.
    size : int, optional
        Width of the periodograms, even, 8 to 8,192; by default that of the largest set, as in `periodogram`.
    tapered : bool, optional
        For plain boxes cut out of a larger plane: points weigh less towards the sides, by Hann's window, and
        what an even density would have at the lowest frequencies is taken away, so that the cut does not
        show. Power and noise of white noise stay what they are; the spectrum is blurred by 1.5 samples.
        Default False.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    Spectrum
        The mean power, its radial mean and its anisotropy.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        Something else than point sets and an integer; sets of different boxes, too few points, points
        outside the box or a size that is not allowed.

    Examples
    --------
    >>> import tilewright as tw
    >>> sets = [tw.sample_points("dart", 1000, seed=seed) for seed in range(3)]
    >>> spectrum = tw.power_spectrum(sets, size=128)
    >>> spectrum.power.shape, spectrum.radial.shape
    ((128, 128), (64,))
    """
    given = check_sets(sets)
    check_shape(given[0].box)
    check_flag("tapered", tapered)
    check_progress(progress)
    width = _check_size(size, max(len(s) for s in given))
    power = unfold(mean_half_periodogram(given, width, progress, tapered))
    power[power.shape[0] // 2, power.shape[1] // 2] = 0
    radial, variances, samples = _average_annuli(power, frequency_steps(given[0].box), width // 2)
    with np.errstate(divide="ignore", invalid="ignore"):
        anisotropy = 10 * np.log10(variances / radial**2)
    anisotropy[~(radial > _ZERO_POWER)] = nan
    return Spectrum(given, power, radial, anisotropy, samples, tapered)


@dataclass(frozen=True)
class LatticeSpikes:
    """The largest powers at the frequencies of a lattice of tiles, and elsewhere.

    Attributes
    ----------
    on : float
        The largest power at a whole multiple of the lattice's frequencies.
    off : float
        The largest power at any other frequency.
    at : (int, int)
        Where the first is: periods across the box in x and in y.
    """

    on: float
    off: float
    at: tuple[int, int]


def lattice_spikes(spectrum: Spectrum, tiles_along: int | tuple[int, int]) -> LatticeSpikes:
    """Tell the spikes that come from a lattice of tiles from the rest of a spectrum.

    Parameters
    ----------
    spectrum : Spectrum
        Of points that were laid with tiles; see `power_spectrum`.
    tiles_along : int or (int, int)
        How many tiles the box has along x and along y, from 1 on. T tiles of n points each have, besides
        their noise, the power T |m(k)|^2 / n at the multiple k of the lattice's frequency, with m the mean
        over the tiles of the sum of exp(-2 pi i k . x) over the points of a tile, x in tiles.

    Returns
    -------
    LatticeSpikes
        The largest power on the lattice, elsewhere, and where the first is.

    Raises
    ------
    TilewrightTypeError
        Something else than a spectrum and one or two integers.
    TilewrightValueError
        The spectrum ends before the lattice's first frequency.
    """
    check_type("spectrum", spectrum, Spectrum, "a Spectrum", "power_spectrum makes one")
    pair = tiles_along if isinstance(tiles_along, (tuple, list)) else (tiles_along, tiles_along)
    if len(pair) != 2:
        raise type_error("tiles_along", tiles_along, "an integer or two")
    rows, columns = spectrum.power.shape
    along_x, along_y = (check_int("tiles_along", n, 1, LARGEST_SIZE) for n in pair)
    if along_x > columns // 2 and along_y > rows // 2:
        raise TilewrightValueError(
            f"is {tiles_along}; the spectrum ends at {columns // 2} and {rows // 2} periods, before the "
            "lattice's first frequency",
            argument="tiles_along",
            value=tiles_along,
            advice="give power_spectrum a larger size",
        )
    ky, kx = np.arange(rows) - rows // 2, np.arange(columns) - columns // 2
    on = (ky % along_y == 0)[:, None] & (kx % along_x == 0)
    lattice = np.where(on, spectrum.power, -1)
    at = np.unravel_index(int(np.argmax(lattice)), lattice.shape)
    rest = float(spectrum.power[~on].max()) if not on.all() else 0.0
    return LatticeSpikes(float(lattice[at]), rest, (int(kx[at[1]]), int(ky[at[0]])))


def _check_size(size: int | None, count: int) -> int:
    if size is None:
        width = spectrum_size(count)
        if width <= LARGEST_SIZE:
            return width
        raise TilewrightValueError(
            f"would be {width} for {count} points; allowed are up to {LARGEST_SIZE}",
            argument="size",
            allowed=f"up to {LARGEST_SIZE}",
            advice="give a size",
        )
    width = check_int("size", size, 8, LARGEST_SIZE)
    if width % 2:
        raise TilewrightValueError(
            f"is {width}; it must be even", argument="size", value=width, allowed="even"
        )
    return width


def _average_annuli(
    power: NDArray[np.float64], steps: tuple[float, float], rings: int
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.int64]]:
    """Means, variances and numbers of samples of the rings around whole frequencies."""
    from tilewright.kernels.spectra import average_annuli

    means, variances, samples = np.empty(rings), np.empty(rings), np.empty(rings, np.int64)
    average_annuli(power, *steps, samples, means, variances)
    return means, variances, samples
