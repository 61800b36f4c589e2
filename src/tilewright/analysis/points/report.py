"""All figures of a method's point sets, and sheets to judge methods by eye (Lagae 2007, chapter 6)."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import isnan
from typing import TYPE_CHECKING

import numpy as np

from tilewright.analysis.points.checks import check_set, check_sets, check_shape
from tilewright.analysis.points.meanings import POINT_MEANING, POINT_UNITS
from tilewright.analysis.points.panels import (
    draw_anisotropy,
    draw_distances,
    draw_plate,
    draw_points,
    draw_radial,
    draw_spectrum,
    find_highest,
    limit_anisotropy,
    limit_radial,
)
from tilewright.analysis.points.plates import ZonePlate, zone_plate
from tilewright.analysis.points.spacing import (
    RadialDistribution,
    measure_neighborhood,
    nearest_mean_within,
    radial_distribution,
)
from tilewright.analysis.points.spectrum import Spectrum, power_spectrum
from tilewright.analysis.points.verdict import judge_points
from tilewright.analysis.sheets import need_plots, save_figure
from tilewright.errors import Progress, TilewrightTypeError, TilewrightValueError
from tilewright.files.atomic import AnyPath
from tilewright.samplers.point_set import PointSet
from tilewright.showing import describe_record

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_OPEN = ("coverage", "bond_order")
"""Figures that a plain box may have no room for."""
_TALLEST, _LOUDEST = 6.0, 25.0
"""Where comparisons cut off radial power, and anisotropy in dB."""


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
        return "\n".join([*self._lines(), *self.verdict, *self.notes])

    def _lines(self) -> list[str]:
        """Each figure with its unit and meaning."""
        lines = []
        for name, value in self.figures.items():
            shown = f"{value:10.0f}" if abs(value) >= 1000 else f"{value:10.4g}"
            lines.append(f"{name:<18} {shown} {POINT_UNITS[name]:<8} {POINT_MEANING[name]}")
        return lines

    @property
    def verdict(self) -> list[str]:
        """One to three sentences: whether this is good blue noise, what to object to, what to change.

        The limits are those of Lagae 2007, section 4.2.3, and for what Heck, Schlömer & Deussen 2013
        define, dart throwing's own figures.
        """
        tiled = "tiles" in self.figures or "tiles" in self.spectrum.sets[0].method
        return judge_points(self.figures, self.spectrum, tiled)

    @property
    def notes(self) -> tuple[str, ...]:
        """What the figures assume, and which are left out, in sentences; nothing on a torus."""
        box = self.spectrum.sets[0].box
        if box.torus:
            return ()
        said = [
            "The {:g} x {:g} box has open sides: coverage counts circles within it, nearest_mean points away "
            "from its sides, and the spectrum weighs points less towards them.".format(*box.extent)
        ]
        missing = [name for name in _OPEN if name not in self.figures]
        if missing:
            said.append(f"Left out: {', '.join(missing)}; no circle between the points lies within the box.")
        return tuple(said)

    def sheet(self) -> "Figure":
        """Draw points, power spectrum, zone plate, radial power, anisotropy and distances beside the figures.

        Returns
        -------
        matplotlib.figure.Figure
            A sheet of 15 x 11 inches.
        """
        need_plots()
        from matplotlib.figure import Figure

        figure = Figure(figsize=(15, 11), layout="constrained")
        figure.suptitle(_title(self), fontsize=14)
        lines = self._lines()
        half = (len(lines) + 1) // 2
        heights = (5, 3.6, 0.2 * half)
        upper, lower, words = figure.subfigures(3, 1, squeeze=False, height_ratios=heights)[:, 0]
        for axis, draw in zip(upper.subplots(1, 3), (draw_points, draw_spectrum, draw_plate), strict=True):
            draw(axis, self)
        for axis, draw in zip(
            lower.subplots(1, 3), (draw_radial, draw_anisotropy, draw_distances), strict=True
        ):
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

    A plain box is taken for a part of a larger plane: no figure counts its sides as a border of the points.
    The largest empty circle is one that lies within the box, the mean nearest distance is taken away from its
    sides, and the spectrum is tapered towards them (see `power_spectrum`); what cannot be told so is left
    out. `coverage_radius`, `nearest_mean` and `power_spectrum` by themselves measure the box as it is.

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
    check_shape(given[0].box)
    spectrum = power_spectrum(given, size, tapered=not given[0].box.torus)
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
        "nearest_mean": float(np.mean([nearest_mean_within(one) for one in given])),
        "coverage": max(a.coverage for a in around),
        "bond_order": float(np.mean([a.bond_order for a in around])),
        **measured,
    }
    figures = {name: value for name, value in figures.items() if name not in _OPEN or not isnan(value)}
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
    need_plots()
    from matplotlib.figure import Figure

    given = _check_reports(reports)
    figure = Figure(figsize=(21, 4.9 * len(given)), layout="constrained")
    rows = figure.subfigures(len(given), 1, squeeze=False)[:, 0]
    highest = min(max(find_highest(r.spectrum.radial) for r in given), _TALLEST)
    loudest = min(max(find_highest(r.spectrum.anisotropy) for r in given), _LOUDEST)
    for row, report in zip(rows, given, strict=True):
        axes = row.subplots(1, 5, width_ratios=(1, 1.05, 1, 1, 1))
        for axis, draw in zip(
            axes, (draw_points, draw_spectrum, draw_radial, draw_anisotropy, draw_plate), strict=True
        ):
            draw(axis, report)
            axis.set_box_aspect(1)
        row.suptitle(f"{_title(report)}, $\\rho$ = {report.figures['rho']:.3f}", x=0.01, ha="left")
        limit_radial(axes[2], highest)
        limit_anisotropy(axes[3], report.spectrum.reference, loudest)
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
    save_figure(path, make, dpi=160)


def _title(report: PointReport) -> str:
    sets, count = len(report.spectrum.sets), report.spectrum.count
    box = report.spectrum.sets[0].box
    kind = "torus" if box.torus else "plain box"
    shape = "unit" if box.extent == (1.0, 1.0) else "{:g} x {:g}".format(*box.extent)
    many = f"{sets} sets of {count:,.0f} points" if sets > 1 else f"1 set of {count:,.0f} points"
    return f"{report.name}: {many}, {shape} {kind}"
