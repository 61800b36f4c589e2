"""All figures of a method's point sets, and sheets to judge methods by eye (Lagae 2007, chapter 6)."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf, sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.points.checks import check_set, check_sets
from tilewright.analysis.points.plates import DOMAIN, ZonePlate, zone_plate
from tilewright.analysis.points.spacing import (
    RadialDistribution,
    measure_neighborhood,
    nearest_mean,
    radial_distribution,
)
from tilewright.analysis.points.spectrum import Spectrum, power_spectrum
from tilewright.analysis.sheets import check_sheet
from tilewright.errors import Progress, TilewrightTypeError, TilewrightValueError
from tilewright.files.atomic import AnyPath, whole_file
from tilewright.samplers.point_set import PointSet
from tilewright.showing import describe_record

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

POINT_MEANING = {
    "sets": "sets that were averaged, K",
    "count": "points of a set, mean",
    "rho": "least distance over 2 r_max, least of the sets",
    "nearest_mean": "mean nearest distance over 2 r_max",
    "coverage": "largest empty circle's radius over r_max, largest of the sets",
    "bond_order": "sixfold order of neighbors; 0.36 for white noise, 1 for hexagons",
    "radial_peak": "highest radially averaged power; 1 for white noise",
    "largest_bin": "highest power of a single frequency",
    "anisotropy_max": "highest anisotropy, dB",
    "anisotropy_p99": "its 99th percentile, dB",
    "anisotropy_median": "its median, dB; -10 log10 K for a symmetric spectrum",
    "effective_nyquist": "frequencies sampled cleanly, over sqrt(N) / 2",
    "oscillation": "10 x RMS of the radial power less 1, beyond the first rise",
    "zone_plate_error": "RMS error of the zone plate, 0 to 1",
    "zone_plate_near": "the same where pixels are fine enough for the function",
    "tiles": "tiles of the set, variants counted",
    "points_per_tile": "mean of the set",
    "promised_rho": "least rho over all pairs of tiles that may be neighbors",
    "intra_rho": "least rho of points of one tile",
    "spike_window": "highest spike of the tile lattice, for each tile of the plane",
    "spike_doubled": "the same within twice the width of the spectrum",
    "spike_height": "its height in a set of 16,384 points",
}

_SHOWN_POINTS = 1024
_BRIGHTEST = 12.0
"""Power that is shown white; black is 0, log(1 + 4 power) between: the same for all sheets."""
_TALLEST, _LOUDEST = 6.0, 25.0
"""Where comparisons cut off radial power, and anisotropy in dB."""
_INK = "#1a3f6f"
_MARK = "#c23b22"


@dataclass(frozen=True, eq=False)
class PointReport:
    """What was measured of a method of making points.

    Attributes
    ----------
    name : str
        What the sheet calls the method.
    figures : dict of str to float
        Every figure by name; ``str(report)`` lists them, each with its meaning.
    spectrum : Spectrum
        The mean power spectrum.
    distribution : RadialDistribution
        How many points there are at each distance.
    plate : ZonePlate or None
        The zone plate sampled with a large set, None where there was none.
    """

    name: str
    figures: dict[str, float]
    spectrum: Spectrum
    distribution: RadialDistribution
    plate: ZonePlate | None

    __repr__ = describe_record

    def __str__(self) -> str:
        lines = []
        for name, value in self.figures.items():
            shown = f"{value:10.0f}" if abs(value) >= 1000 else f"{value:10.4g}"
            lines.append(f"{name:<18} {shown}  {POINT_MEANING[name]}")
        return "\n".join(lines)

    def sheet(self) -> "Figure":
        """Draw points, power spectrum, zone plate, radial power, anisotropy and distances beside the figures.

        Returns
        -------
        matplotlib.figure.Figure
            A sheet of 15 x 11 inches.
        """
        from matplotlib.figure import Figure

        figure = Figure(figsize=(15, 11), layout="constrained")
        figure.suptitle(_title(self), fontsize=14)
        lines = str(self).splitlines()
        half = (len(lines) + 1) // 2
        heights = (5, 3.6, 0.2 * half)
        upper, lower, words = figure.subfigures(3, 1, squeeze=False, height_ratios=heights)[:, 0]
        for axis, draw in zip(upper.subplots(1, 3), (_points, _spectrum, _plate), strict=True):
            draw(axis, self)
        for axis, draw in zip(lower.subplots(1, 3), (_radial, _anisotropy, _distances), strict=True):
            draw(axis, self)
        for place, part in ((0.02, lines[:half]), (0.52, lines[half:])):
            words.text(place, 0.95, "\n".join(part), family="monospace", fontsize=9, va="top")
        return figure

    def save_sheet(self, path: AnyPath) -> None:
        """Write the sheet as a picture.

        Parameters
        ----------
        path : str or path-like
            ``.png``, ``.jpg``, ``.svg`` or ``.pdf``.

        Raises
        ------
        TilewrightTypeError
            Something else than a path.
        TilewrightValueError
            Another suffix.
        TilewrightFileError
            The file cannot be written.
        """
        _save(path, self.sheet)


def analyze_points(
    sets: PointSet | Sequence[PointSet],
    *,
    plate: PointSet | None = None,
    name: str | None = None,
    size: int | None = None,
    progress: Progress | None = None,
) -> PointReport:
    """Measure the point sets that a method makes: spacing, spectrum, sampling (Lagae 2007, section 6.2).

    Parameters
    ----------
    sets : PointSet or list of PointSet
        Sets of one plane box, at least 3 points each; ten sets of about 16,384 points in the thesis.
    plate : PointSet, optional
        A set by the same method of about 262,144 points, for the zone plate; by default there is no plate.
    name : str, optional
        What to call the method; by default the first set's own word for it.
    size : int, optional
        Width of the periodograms, see `power_spectrum`.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    PointReport
        The figures, the spectrum and the distances.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        Something that is no PointSet; too few points; sets of different boxes.
    """
    given = check_sets(sets)
    large = None if plate is None else check_set(plate, "plate")

    def step(done: int, what: str) -> None:
        if progress is not None:
            progress(done, len(given) + 3, what)

    step(0, "spectrum")
    spectrum = power_spectrum(given, size)
    measured = spectrum.figures
    around = []
    for k, one in enumerate(given):
        step(1 + k, "spacing")
        around.append(measure_neighborhood(one))
    distribution = radial_distribution(given)
    figures = {
        "sets": float(len(given)),
        "count": spectrum.count,
        "rho": min(one.rho for one in given),
        "nearest_mean": float(np.mean([nearest_mean(one) for one in given])),
        "coverage": max(a.coverage for a in around),
        "bond_order": float(np.mean([a.bond_order for a in around])),
        **measured,
    }
    shown = None
    if large is not None:
        step(len(given) + 1, "zone plate")
        shown = zone_plate(large)
        figures["zone_plate_error"] = shown.error
        figures["zone_plate_near"] = shown.error_near
    step(len(given) + 3, "done")
    return PointReport(name or given[0].method, figures, spectrum, distribution, shown)


def comparison_sheet(reports: Sequence[PointReport]) -> "Figure":
    """Draw a row for each method at the same scales: points, spectrum, power, anisotropy, zone plate.

    Radial power is cut off at 6 and anisotropy at 25 dB, so that one lattice does not flatten the others.

    Parameters
    ----------
    reports : sequence of PointReport
        At least one report.

    Returns
    -------
    matplotlib.figure.Figure
        A sheet 21 inches wide and 4.9 inches high for each method.
    """
    from matplotlib.figure import Figure

    given = _check_reports(reports)
    figure = Figure(figsize=(21, 4.9 * len(given)), layout="constrained")
    rows = figure.subfigures(len(given), 1, squeeze=False)[:, 0]
    highest = min(max(_highest(r.spectrum.radial) for r in given), _TALLEST)
    loudest = min(max(_highest(r.spectrum.anisotropy) for r in given), _LOUDEST)
    for row, report in zip(rows, given, strict=True):
        axes = row.subplots(1, 5, width_ratios=(1, 1.05, 1, 1, 1))
        for axis, draw in zip(axes, (_points, _spectrum, _radial, _anisotropy, _plate), strict=True):
            draw(axis, report)
            axis.set_box_aspect(1)
        row.suptitle(f"{_title(report)}, $\\rho$ = {report.figures['rho']:.3f}", x=0.01, ha="left")
        _limit_radial(axes[2], highest)
        _limit_anisotropy(axes[3], report.spectrum.reference, loudest)
    return figure


def save_comparison(reports: Sequence[PointReport], path: AnyPath) -> None:
    """Write the sheet of `comparison_sheet` as a picture.

    Parameters
    ----------
    reports : sequence of PointReport
        At least one report.
    path : str or path-like
        ``.png``, ``.jpg``, ``.svg`` or ``.pdf``.
    """
    given = _check_reports(reports)
    _save(path, lambda: comparison_sheet(given))


def _check_reports(reports: Sequence[PointReport]) -> list[PointReport]:
    if not isinstance(reports, (list, tuple)) or not all(isinstance(r, PointReport) for r in reports):
        raise TilewrightTypeError(
            "must be a list of PointReport",
            argument="reports",
            allowed="a list of PointReport",
            advice="analyze_points makes one",
        )
    if not reports:
        raise TilewrightValueError("is empty; at least one PointReport is needed", argument="reports")
    return list(reports)


def _save(path: AnyPath, make: Callable[[], "Figure"]) -> None:
    target = check_sheet(path)
    with whole_file(target) as unfinished:
        make().savefig(unfinished, dpi=160, format=target.suffix[1:].lower())


def _title(report: PointReport) -> str:
    sets, count = len(report.spectrum.sets), report.spectrum.count
    box = report.spectrum.sets[0].box
    kind = "torus" if box.torus else "plain box"
    shape = "unit" if box.extent == (1.0, 1.0) else "{:g} x {:g}".format(*box.extent)
    many = f"{sets} sets of {count:,.0f} points" if sets > 1 else f"1 set of {count:,.0f} points"
    return f"{report.name}: {many}, {shape} {kind}"


def _highest(values: NDArray[np.float64]) -> float:
    """The largest that is not NaN; minus infinity if all are."""
    return float(np.max(values, where=~np.isnan(values), initial=-inf))


def _points(axis: "Axes", report: PointReport) -> None:
    """The first set's corner at the origin, y downwards."""
    shown = report.spectrum.sets[0]
    side = min(*shown.box.extent, sqrt(_SHOWN_POINTS * shown.box.volume / len(shown)))
    x, y = shown.points[(shown.points < side).all(axis=1)].T
    # Dots about a quarter of the mean spacing wide on a panel of 4 inches, in square points.
    spacing = min(0.1, sqrt(shown.box.volume / len(shown)) / side)
    axis.scatter(x, y, s=(4 * 72 * spacing / 4) ** 2, c="black", linewidths=0)
    axis.set(xlim=(0, side), ylim=(side, 0), xticks=(0, side), yticks=(0, side), xlabel="x", ylabel="y")
    axis.set_xticklabels(("0", f"{side:.3g}"))
    axis.set_yticklabels(("0", f"{side:.3g}"))
    axis.set_box_aspect(1)
    axis.set_title(f"points ({len(x):,} of {len(shown):,})", fontsize=11)


def _spectrum(axis: "Axes", report: PointReport) -> None:
    from matplotlib.colors import FuncNorm

    spectrum = report.spectrum
    rows, columns = spectrum.power.shape
    step_y, step_x = (s / sqrt(spectrum.count) for s in spectrum.steps)
    left, top = (columns / 2 + 0.5) * step_x, (rows / 2 + 0.5) * step_y
    image = axis.imshow(
        spectrum.power,
        norm=FuncNorm((lambda p: np.log1p(4 * p), lambda v: np.expm1(v) / 4), 0, _BRIGHTEST, clip=True),
        cmap="gray",
        extent=(-left, left - step_x, top - step_y, -top),
        interpolation="antialiased",
    )
    # Single frequencies would be lost where the picture has fewer pixels than the spectrum.
    spikes = np.argwhere(spectrum.power > _BRIGHTEST) - (rows // 2, columns // 2)
    heights = spectrum.power[spectrum.power > _BRIGHTEST] / _BRIGHTEST
    sizes = 1 + 2 * np.log2(heights)
    axis.scatter(spikes[:, 1] * step_x, spikes[:, 0] * step_y, s=sizes, c="white", linewidths=0)
    bar = axis.figure.colorbar(image, ax=axis, fraction=0.046, pad=0.02, ticks=(0, 0.2, 0.5, 1, 2, 4, 8, 12))
    bar.ax.set_yticklabels(("0", "0.2", "0.5", "1", "2", "4", "8", "12"))
    ticks = np.arange(-int(left - 0.2), int(left - 0.2) + 1)
    axis.set(xticks=ticks, yticks=ticks)
    axis.set_xlabel("frequency in x / $\\sqrt{N}$")
    axis.set_ylabel("frequency in y / $\\sqrt{N}$")
    dotted = f" ({len(spikes):,} bins over {_BRIGHTEST:.0f} dotted)" if len(spikes) else ""
    axis.set_title(f"power spectrum{dotted}", fontsize=11)


def _radial(axis: "Axes", report: PointReport) -> None:
    spectrum = report.spectrum
    frequency = np.arange(1, len(spectrum.radial)) / sqrt(spectrum.count)
    axis.plot(frequency, spectrum.radial[1:], color=_INK, lw=1)
    axis.axhline(1, color="0.6", lw=0.8, ls="--", zorder=0)
    nyquist = spectrum.effective_nyquist
    if nyquist > 0:
        axis.axvline(nyquist, color=_MARK, lw=0.8)
        words = f" $2\\nu_{{eff}} = {nyquist:.2f}\\sqrt{{N}}$"
        at = axis.get_xaxis_transform()
        axis.text(nyquist, 0.97, words, color=_MARK, fontsize=9, va="top", transform=at)
    axis.set_xlim(0, frequency[-1])
    _limit_radial(axis, _highest(spectrum.radial))
    axis.set_xlabel("frequency / $\\sqrt{N}$")
    axis.set_ylabel("power (white noise = 1)")
    axis.set_title("radially averaged power", fontsize=11)


def _limit_radial(axis: "Axes", highest: float) -> None:
    axis.set_ylim(0, max(2.0, 1.15 * highest))


def _anisotropy(axis: "Axes", report: PointReport) -> None:
    spectrum = report.spectrum
    frequency = np.arange(1, len(spectrum.anisotropy)) / sqrt(spectrum.count)
    label = f"$-10\\,\\log_{{10}} {len(spectrum.sets)} = {spectrum.reference:.0f}$ dB"
    # Markers, for rings whose neighbors have no power.
    axis.plot(frequency, spectrum.anisotropy[1:], color=_INK, lw=0.8, marker=".", ms=1.5)
    axis.axhline(spectrum.reference, color=_MARK, lw=1, ls="--", label=label)
    axis.set_xlim(0, frequency[-1])
    _limit_anisotropy(axis, spectrum.reference, _highest(spectrum.anisotropy))
    axis.set_xlabel("frequency / $\\sqrt{N}$")
    axis.set_ylabel("anisotropy / dB")
    axis.set_title("anisotropy", fontsize=11)
    axis.legend(loc="upper right", fontsize=9, frameon=False)


def _limit_anisotropy(axis: "Axes", reference: float, highest: float) -> None:
    from matplotlib.ticker import MultipleLocator

    top = max(reference + 10, highest + 6)
    axis.set_ylim(reference - 10, top)
    axis.yaxis.set_major_locator(MultipleLocator(5 if top < 15 else 10))


def _distances(axis: "Axes", report: PointReport) -> None:
    distribution = report.distribution
    axis.plot(distribution.distance, distribution.density, color=_INK, lw=1)
    axis.axhline(1, color="0.6", lw=0.8, ls="--", zorder=0)
    axis.set_xlim(0, distribution.distance[-1])
    axis.set_ylim(0, max(2.0, 1.15 * _highest(distribution.density)))
    axis.set_xlabel("distance / $2\\,r_{max}$")
    axis.set_ylabel("density (white noise = 1)")
    axis.set_title("radial distribution", fontsize=11)


def _plate(axis: "Axes", report: PointReport) -> None:
    """Origin at the lower left, as in the thesis."""
    if report.plate is None:
        axis.set_axis_off()
        axis.text(0.5, 0.5, "no set for the zone plate", ha="center", color="0.5", transform=axis.transAxes)
        return
    whole = (0, DOMAIN, 0, DOMAIN)
    axis.imshow(report.plate.picture, cmap="gray", vmin=0, vmax=1, origin="lower", extent=whole)
    axis.set(xticks=(0, 16, 32, 48), yticks=(0, 16, 32, 48), xlabel="x", ylabel="y")
    axis.set_title(f"zone plate, RMS error {report.plate.error:.3f}", fontsize=11)
