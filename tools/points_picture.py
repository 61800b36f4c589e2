"""Make docs/images/points.png: parts of tiles, a density by ranks, and what balancing does to spectra."""

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import tilewright as tw
from tilewright.analysis import lay_square
from tilewright.signals.points.anatomy import Regions

TARGET = Path(__file__).parents[1] / "docs" / "images" / "points.png"
SIZE = 1024
COLORS = ("#c23b22", "#1a6fae", "#1a6fae", "#333333")


def kinds(points: np.ndarray, regions: Regions) -> np.ndarray:
    """0 in corner regions, 1 in strips along x, 2 along y, 3 inside."""
    from tilewright.kernels.growth import kind_at

    return np.array([kind_at(x, y, regions.radius, regions.is_cusp) for x, y in points])


def main() -> None:
    """Draw and save."""
    balanced = tw.ready_tiles()
    relaxed = tw.poisson_tiles(balanced.tiles, 32, 0.75, method="relaxed", seed=1)
    field = tw.PointField(balanced, tw.direct(balanced.tiles, 3))
    figure = Figure(figsize=(14, 4.1), layout="constrained")
    parts, ramp, before, after = figure.subplots(1, 4)

    points = field.points(0, 0, 4, 4)
    found = kinds(points, Regions(balanced.distance / 2))
    parts.scatter(*points.T, s=9, c=[COLORS[k] for k in found], linewidths=0)
    for k in range(5):
        parts.axhline(k, color="0.8", lw=0.8, zorder=0)
        parts.axvline(k, color="0.8", lw=0.8, zorder=0)
    parts.set(xlim=(0, 4), ylim=(4, 0))

    def share(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.clip(1 - np.hypot(x - 12, y - 8) / 14, 0.02, 1) ** 2

    thinned = field.points(0, 0, 16, 16, density=share)
    ramp.scatter(*thinned.T, s=1.5, c="black", linewidths=0)
    ramp.set(xlim=(0, 16), ylim=(16, 0))

    both = ((before, relaxed, "relaxed, as in the papers"), (after, balanced, "balanced, the default"))
    for axis, tiles, name in both:
        spectrum = tw.power_spectrum([lay_square(tiles, 16384, k) for k in range(10)])
        middle = slice(SIZE // 4, 3 * SIZE // 4)
        # The larger of four neighbors, so that single frequencies can be seen.
        power = spectrum.power[middle, middle].reshape(SIZE // 4, 2, SIZE // 4, 2).max(axis=(1, 3))
        reach = SIZE / 4 / np.sqrt(spectrum.count)
        shown = np.log1p(4 * np.minimum(power, 24))
        axis.imshow(shown, cmap="gray", extent=(-reach, reach, reach, -reach), vmin=0, vmax=np.log1p(96))
        highest = spectrum.figures["largest_bin"]
        axis.set_title(f"{name}\nhighest spike {highest:.0f}", fontsize=10)
        axis.set(xticks=[], yticks=[])
    parts.set_title("4 x 4 tiles:\ncorners, edges, interiors", fontsize=10)
    ramp.set_title("a density,\nthinned by ranks", fontsize=10)
    for axis in (parts, ramp):
        axis.set(xticks=[], yticks=[], aspect="equal")
    figure.savefig(TARGET, dpi=100)


if __name__ == "__main__":
    main()
