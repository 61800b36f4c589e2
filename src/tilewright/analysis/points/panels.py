"""The pictures that sheets of point sets are made of, each on axes of its own."""

from math import inf, sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.points.plates import DOMAIN

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tilewright.analysis.points.report import PointReport

_SHOWN_POINTS = 1024
_BRIGHTEST = 12.0
"""Power that is shown white; black is 0, log(1 + 4 power) between: the same for all sheets."""
_INK = "#1a3f6f"
_MARK = "#c23b22"


def find_highest(values: NDArray[np.float64]) -> float:
    """The largest that is not NaN; minus infinity if all are."""
    return float(np.max(values, where=~np.isnan(values), initial=-inf))


def draw_points(axis: "Axes", report: "PointReport") -> None:
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


def draw_spectrum(axis: "Axes", report: "PointReport") -> None:
    """The mean power, frequency 0 in the middle."""
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


def draw_radial(axis: "Axes", report: "PointReport") -> None:
    """The radial power, and the effective Nyquist frequency."""
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
    limit_radial(axis, find_highest(spectrum.radial))
    axis.set_xlabel("frequency / $\\sqrt{N}$")
    axis.set_ylabel("power (white noise = 1)")
    axis.set_title("radially averaged power", fontsize=11)


def limit_radial(axis: "Axes", highest: float) -> None:
    """The range of powers, up to ``highest`` at least."""
    axis.set_ylim(0, max(2.0, 1.15 * highest))


def draw_anisotropy(axis: "Axes", report: "PointReport") -> None:
    """The anisotropy of the rings, and what a symmetric spectrum has."""
    spectrum = report.spectrum
    frequency = np.arange(1, len(spectrum.anisotropy)) / sqrt(spectrum.count)
    label = f"$-10\\,\\log_{{10}} {len(spectrum.sets)} = {spectrum.reference:.0f}$ dB"
    # Markers, for rings whose neighbors have no power.
    axis.plot(frequency, spectrum.anisotropy[1:], color=_INK, lw=0.8, marker=".", ms=1.5)
    axis.axhline(spectrum.reference, color=_MARK, lw=1, ls="--", label=label)
    axis.set_xlim(0, frequency[-1])
    limit_anisotropy(axis, spectrum.reference, find_highest(spectrum.anisotropy))
    axis.set_xlabel("frequency / $\\sqrt{N}$")
    axis.set_ylabel("anisotropy / dB")
    axis.set_title("anisotropy", fontsize=11)
    axis.legend(loc="upper right", fontsize=9, frameon=False)


def limit_anisotropy(axis: "Axes", reference: float, highest: float) -> None:
    """The range of anisotropies, up to ``highest`` and a little more."""
    from matplotlib.ticker import MultipleLocator

    top = max(reference + 10, highest + 6)
    axis.set_ylim(reference - 10, top)
    axis.yaxis.set_major_locator(MultipleLocator(5 if top < 15 else 10))


def draw_distances(axis: "Axes", report: "PointReport") -> None:
    """The radial distribution."""
    distribution = report.distribution
    axis.plot(distribution.distance, distribution.density, color=_INK, lw=1)
    axis.axhline(1, color="0.6", lw=0.8, ls="--", zorder=0)
    axis.set_xlim(0, distribution.distance[-1])
    axis.set_ylim(0, max(2.0, 1.15 * find_highest(distribution.density)))
    axis.set_xlabel("distance / $2\\,r_{max}$")
    axis.set_ylabel("density (white noise = 1)")
    axis.set_title("radial distribution", fontsize=11)


def draw_plate(axis: "Axes", report: "PointReport") -> None:
    """Origin at the lower left, as in the thesis."""
    if report.plate is None:
        axis.set_axis_off()
        axis.text(0.5, 0.5, "no set for the zone plate", ha="center", color="0.5", transform=axis.transAxes)
        return
    whole = (0, DOMAIN, 0, DOMAIN)
    axis.imshow(report.plate.picture, cmap="gray", vmin=0, vmax=1, origin="lower", extent=whole)
    axis.set(xticks=(0, 16, 32, 48), yticks=(0, 16, 32, 48), xlabel="x", ylabel="y")
    axis.set_title(f"zone plate, RMS error {report.plate.error:.3f}", fontsize=11)
