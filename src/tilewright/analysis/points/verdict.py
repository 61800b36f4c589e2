"""Whether points are good blue noise, in words: compared to what, what to object to, and what to change.

Lagae & Dutré 2006, section 7.2.1, and Lagae 2007, section 4.2.3, ask for a relative radius of 0.65 to 0.85.
Heck, Schlömer & Deussen 2013 ("Blue Noise Sampling with Controlled Aliasing", ACM TOG 32 (3)) define
effective Nyquist frequency and oscillation without limits; Ulichney 1987 ("Digital Halftoning") has the
floor of the anisotropy. Where the literature names no limit, dart throwing sets it, which the other methods
are measured by.
"""

from math import log10, nan, sqrt
from typing import NamedTuple

import numpy as np

from tilewright.analysis.points.spectrum import Spectrum

GOOD_RHO = (0.65, 0.85)
"""Relative radius: below, points clump; above, they lie as a lattice (Lagae 2007, section 4.2.3)."""
CLEAN = 0.4
"""Least effective Nyquist frequency: dart throwing at rho 0.70 has 0.42 to 0.48 as Heck et al. define it."""
QUIET = 0.15
"""Mean power up to there: dart throwing has 0.09 to 0.13, a jittered grid 0.2. The effective Nyquist
frequency of one periodogram of a thin box varies by chance; this does not."""
SWINGS = 2.0
"""Most oscillation: dart throwing at rho 0.70 to 0.75 has 1.0 to 1.4, a square grid 63."""
HOLE = 2.3
"""Most coverage in r_max: dart throwing at rho 0.70 leaves 1.8 to 2.2, a maximal set at most 2 rho."""
UNEVEN = 1.5
"""Median anisotropy above its floor of -10 log10 K, dB (Ulichney 1987): darts stay within 0.4 of it."""
DIRECTED = 6.0
"""99th percentile of the anisotropy above that floor, dB: darts stay within 4 of it."""
BY_CHANCE = 0.001
"""Chance with which an even spectrum has a frequency as high as a spike."""
FEWEST = 1000
"""Points of all sets below which a spectrum varies by chance too much to be judged."""


class Objection(NamedTuple):
    """What a picky user would object to, and what to change."""

    says: str
    advice: str


def judge_points(figures: dict[str, float], spectrum: Spectrum, tiled: bool) -> list[str]:
    """Say in one to three sentences whether points are good blue noise.

    Parameters
    ----------
    figures : dict of str to float
        As in `PointReport.figures`; what is missing or NaN is not judged.
    spectrum : Spectrum
        Where the figures of the spectrum come from.
    tiled : bool
        Whether the points come from tiles, which leave a lattice of their own.

    Returns
    -------
    list of str
        What the points are, what to object to, what to change.
    """
    judged = sum(map(len, spectrum.sets)) >= FEWEST
    found = [*_spacing(figures), *(_spectral(figures, spectrum, tiled) if judged else ())]
    said = [_summary(figures, spectrum, found, judged)]
    if found:
        advice = dict.fromkeys(objection.advice for objection in found)
        said.append(f"To object to: {'; '.join(objection.says for objection in found)}.")
        said.append(f"To change: {'; '.join(advice)}.")
    return said


def spike_limit(figures: dict[str, float], spectrum: Spectrum) -> float:
    """Highest power of a frequency that chance explains in a mean of K periodograms of even power."""
    from scipy.stats import gamma

    sets = len(spectrum.sets)
    share = BY_CHANCE / max(1, spectrum.power.size // 2)  # half are mirror images
    return float(gamma.isf(share, sets) / sets * figures["radial_peak"])


def low_power(spectrum: Spectrum) -> float:
    """Mean power of the frequencies that dart throwing leaves clean."""
    rings = slice(1, max(2, int(CLEAN * sqrt(spectrum.count)) + 1))
    samples = spectrum.samples[rings]
    return float(np.nansum(spectrum.radial[rings] * samples) / max(1, samples.sum()))


def _spacing(figures: dict[str, float]) -> list[Objection]:
    """What distances show."""
    rho, found = figures["rho"], []
    least, most = GOOD_RHO
    if rho < least and figures.get("nearest_mean", 0) >= least:
        says = f"some points lie closer than the rest: the closest {rho:.2f}, {least} and more is good"
        found.append(Objection(says, "dart, maximal or corner, which keep every pair apart"))
    elif rho < least:
        says = f"points clump: the closest {rho:.2f} of the densest packing's distance, {least} is good"
        found.append(Objection(says, "a larger rho, 0.7 to 0.75, by dart, maximal or corner"))
    elif rho > most:
        says = f"points lie as on a lattice: least distance {rho:.2f}, up to {most} is irregular"
        found.append(Objection(says, "a smaller rho, 0.7 to 0.8, by dart, maximal or lloyd"))
    if figures.get("coverage", nan) > HOLE:
        says = f"holes: an empty circle of {figures['coverage']:.1f} r_max, dart throwing leaves up to 2.2"
        found.append(Objection(says, "maximal or lloyd, which leave none, or a larger rho"))
    return found


def _spectral(figures: dict[str, float], spectrum: Spectrum, tiled: bool) -> list[Objection]:
    """What the spectrum shows."""
    found = []
    clean, swings = figures["effective_nyquist"], figures["oscillation"]
    if clean < CLEAN and low_power(spectrum) > QUIET:
        says = f"low frequencies are noisy: clean up to {clean:.2f} of a grid's, dart throwing up to 0.44"
        found.append(Objection(says, "a larger rho, 0.7 to 0.75, by dart, maximal or corner"))
    if swings > SWINGS:
        says = f"the power swings by {swings:.1f}, dart throwing's by 1.4: fine detail shows as rings"
        found.append(Objection(says, "points less even: dart or maximal, fewer iterations, or corner tiles"))
    return [*found, *_uneven(figures, spectrum, tiled)]


def _uneven(figures: dict[str, float], spectrum: Spectrum, tiled: bool) -> list[Objection]:
    """Lattices and directions."""
    floor = -10 * log10(len(spectrum.sets))
    spike, limit = figures["largest_bin"], spike_limit(figures, spectrum)
    if spike > limit:
        where = "the lattice of tiles shows" if tiled else "a lattice shows"
        says = f"{where}: a frequency of {spike:,.0f} x white noise, chance explains {limit:.0f}"
        return [Objection(says, _other(tiled))]
    over = figures["anisotropy_p99"] - floor
    if figures["anisotropy_median"] - floor > UNEVEN or over > DIRECTED:
        says = f"directions: anisotropy up to {over:.0f} dB above an even spectrum's"
        return [Objection(says, _other(tiled))]
    return []


def _other(tiled: bool) -> str:
    if tiled:
        return "more colors or more points per tile (corner 6 64), or a method without tiles such as maximal"
    return "another method: dart, maximal or corner"


def _summary(figures: dict[str, float], spectrum: Spectrum, found: list[Objection], judged: bool) -> str:
    """What the points are, and compared to what."""
    rho = figures["rho"]
    if found:
        kept = GOOD_RHO[0] <= rho <= GOOD_RHO[1] and not (judged and low_power(spectrum) > QUIET)
        return "Blue noise, with faults." if kept else "Not good blue noise."
    said = f"Good blue noise: least distance {rho:.2f}, where {GOOD_RHO[0]} to {GOOD_RHO[1]} is good"
    if figures.get("coverage", nan) <= 2 * rho:
        said += ", no room for another point"
    if not judged:
        return f"{said}; the spectrum of fewer than {FEWEST:,} points is not judged."
    clean = figures["effective_nyquist"]
    told = (
        f"; clean up to {clean:.2f} of a grid's frequencies, dart throwing up to 0.44"
        if clean >= CLEAN
        else ""
    )
    return f"{said}{told}; no lattice shows."
