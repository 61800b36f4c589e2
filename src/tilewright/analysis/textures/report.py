"""All figures of a tile set, and a sheet of pictures to judge it by eye."""

from dataclasses import dataclass
from textwrap import wrap
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.sheets import need_plots, save_figure
from tilewright.analysis.textures.looks import measure_looks
from tilewright.analysis.textures.meanings import ANY, MEANING, WITHOUT_LIMIT
from tilewright.analysis.textures.patches import named_pieces
from tilewright.analysis.textures.repetition import lattice_share, same_place_share, tile_lag_autocorrelation
from tilewright.analysis.textures.sample import Sample, lay_sample
from tilewright.analysis.textures.seams import (
    cut_color_ratio,
    cut_line_ratio,
    edge_cut_share,
    tone_step_ratio,
    worst_tile_ratio,
)
from tilewright.analysis.textures.structure import seam_novelty, used_share
from tilewright.checks import check_type
from tilewright.errors import Progress
from tilewright.files.atomic import AnyPath
from tilewright.pixels import as_rgb
from tilewright.seeds import check_seed
from tilewright.showing import describe_record
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.kinds import to_lab

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MOST_SHOWN = 81
"""Tiles that a sheet has room for."""


@dataclass(frozen=True, eq=False)
class Report:
    """What was measured of texture tiles.

    Attributes
    ----------
    figures : dict of str to float
        Every figure by name; ``str(report)`` lists them, each with its meaning.
    sample : Sample
        The piece of the plane that was measured.
    """

    figures: dict[str, float]
    sample: Sample

    __repr__ = describe_record

    def __str__(self) -> str:
        return "\n".join([*self._lines(), *self.verdict])

    def _lines(self) -> list[str]:
        """Each figure with its unit, what limit it is beyond, and its meaning."""
        lines = []
        for name, value in self.figures.items():
            least, most = self._limits(name)
            mark = f"over {most:g}" if value > most else f"below {least:g}" if value < least else ""
            meaning = MEANING[name]
            lines.append(f"{name:<18} {value:6.3f} {meaning.unit:<5}  {mark:<10}  {meaning.says}")
        return lines

    @property
    def objections(self) -> list[str]:
        """What figures beyond their limits say, in words."""
        return [MEANING[name].objection.format(value=value) for name, value in self._beyond()]

    @property
    def verdict(self) -> list[str]:
        """One or two sentences: what a picky eye objects to, and what to change."""
        if not self.objections:
            return ["No figure is beyond its limit; look at the sheet all the same."]
        advice = dict.fromkeys(MEANING[name].advice for name, _ in self._beyond())
        return [f"To object to: {'; '.join(self.objections)}.", f"To change: {'; '.join(advice)}."]

    def _beyond(self) -> list[tuple[str, float]]:
        """Figures beyond their limits."""
        limits = {name: self._limits(name) for name in self.figures}
        return [(n, v) for n, v in self.figures.items() if not limits[n][0] <= v <= limits[n][1]]

    def _limits(self, name: str) -> tuple[float, float]:
        treatment = str(self.sample.material.recipe.get("treatment"))
        return ANY if name in WITHOUT_LIMIT.get(treatment, ()) else MEANING[name].limits

    def sheet(self) -> "Figure":
        """Draw photograph, tiles, plane near and far, and cut lines with names of patches beside the figures.

        Returns
        -------
        matplotlib.figure.Figure
            A sheet of 16 x 10 inches.
        """
        need_plots()
        from matplotlib.figure import Figure

        sample, n = self.sample, self.sample.size
        picture = _shown(sample.shown.astype(np.float32), sample.material)
        photo = _shown(sample.material.sources[0][sample.material.main].astype(np.float32), sample.material)
        figure = Figure(figsize=(16, 10), layout="constrained")
        axes = figure.subplots(2, 3, width_ratios=(1, 1, 1.2)).ravel()
        near = picture[: 4 * n, : 4 * n]
        lines = near.copy()
        east, south = sample.cuts
        marked = np.zeros(picture.shape[:2], bool)
        marked[:, :-1] |= east
        marked[:-1] |= south
        lines[marked[: 4 * n, : 4 * n]] = (1, 0, 0.4)
        step = max(1, picture.shape[0] // 1024)
        contents = (
            ("the photograph, as large as the plane beside it", photo[: 4 * n, : 4 * n]),
            ("the endless plane, 4 x 4 tiles", near),
            ("its cut lines, tiles and patches", lines),
            (f"from afar, {sample.cells.shape[0]} x {sample.cells.shape[1]} tiles", _reduce(picture, step)),
            ("the tiles", _tiles(sample)),
        )
        for axis, (title, image) in zip(axes, contents, strict=False):
            axis.imshow(image, interpolation="antialiased")
            axis.set_title(title, fontsize=10)
            axis.set_axis_off()
        for axis in axes[:3]:
            axis.set(xlim=(-0.5, 4 * n - 0.5), ylim=(4 * n - 0.5, -0.5))
        for row, column in np.ndindex(4, 4):
            tile = int(sample.material.variants.tiles[sample.cells[row, column]])
            _write(axes[2], str(tile), row * n, column * n, weight="bold", ha="left", va="top")
        for piece in named_pieces(sample, 4):
            _write(axes[2], piece.name, piece.y, piece.x, ha="center", va="center")
        for tile, (y, x) in enumerate(_squares(sample)):
            _write(axes[4], str(tile), y, x, weight="bold", ha="left", va="top")
        axes[-1].set_axis_off()
        told = "\n".join(line for long in str(self).splitlines() for line in wrap(long, 105))
        text = axes[-1].text(
            0, 1, told, family="monospace", fontsize=6, va="top", transform=axes[-1].transAxes
        )
        text.set_in_layout(False)
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
        save_figure(path, self.sheet, dpi=110)


def analyze_texture(
    material: TextureTiles, *, cells: int = 12, seed: int = 0, progress: Progress | None = None
) -> Report:
    """Measure seams, repetition, structure and looks of texture tiles on a random piece of the plane.

    Parameters
    ----------
    material : TextureTiles
        The tiles to be measured.
    cells : int, optional
        Cells of the piece along a side, 4 to 64; default 12.
    seed : int, optional
        Seed of the tiling and of the patches that are compared, 0 to 2^64 - 1; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    Report
        The figures, and the piece that they were taken from.

    Raises
    ------
    TilewrightTypeError
        Something else than texture tiles.
    TilewrightValueError
        A number out of range.
    """
    check_type("material", material, TextureTiles, "TextureTiles, PointTiles or a PointSet")
    seed = check_seed(seed)
    sample = lay_sample(material, cells, seed)
    figures: dict[str, float] = {}

    def step(done: int, what: str) -> None:
        if progress is not None:
            progress(done, 5, what)

    step(0, "seams")
    figures["cut_line_ratio"] = cut_line_ratio(sample)
    figures["worst_tile_ratio"] = worst_tile_ratio(sample)
    figures["cut_color_ratio"] = cut_color_ratio(sample)
    figures["edge_cut_share"] = edge_cut_share(sample)
    step(1, "repetition")
    raw, own = tile_lag_autocorrelation(sample)
    figures |= {"repetition": raw - max(0.0, own), "repetition_raw": raw, "photograph_own": own}
    figures["same_place_share"] = same_place_share(sample)
    figures["lattice_share"] = lattice_share(sample)
    step(2, "tone")
    figures["tone_step_ratio"] = tone_step_ratio(sample)
    step(3, "structure")
    figures["seam_novelty"], figures["seam_novelty_p95"] = seam_novelty(sample, seed=seed)
    figures["used_share"] = used_share(sample)
    step(4, "looks")
    kind = material.kinds[material.main]
    plane, photo = (to_lab(p, kind) for p in (sample.shown, material.sources[0][material.main]))
    figures |= measure_looks(plane, photo, sample.size, seed)
    step(5, "done")
    return Report({name: round(float(value), 4) for name, value in figures.items()}, sample)


def _shown(pixels: NDArray[np.float32], material: TextureTiles) -> NDArray[np.float32]:
    """Pixels as RGB, 0 to 1; float maps are scaled to what they hold."""
    kind = material.pixels.dtype
    white = np.iinfo(kind).max if kind.kind == "u" else max(float(material.pixels.max()), 1e-9)
    return np.clip(as_rgb(pixels) / white, 0, 1)


def _reduce(picture: NDArray[np.float32], step: int) -> NDArray[np.float32]:
    h, w = (s // step * step for s in picture.shape[:2])
    return picture[:h, :w].reshape(h // step, step, w // step, step, 3).mean(axis=(1, 3))


def _write(axis: "Axes", text: str, y: float, x: float, **how: Any) -> None:
    """A small label that is read on any picture."""
    label = axis.text(x, y, text, fontsize=4.5, color="black", **how)
    label.set_bbox({"facecolor": "white", "alpha": 0.6, "edgecolor": "none", "pad": 0.4})


def _squares(sample: Sample) -> list[tuple[int, int]]:
    """Where the sheet shows the first tiles of the set: (y, x) of their north-west corners, with gaps."""
    count = min(len(sample.material.tiles), MOST_SHOWN)
    step = sample.size + max(2, sample.size // 16)
    side = int(np.ceil(np.sqrt(count)))
    return [(t // side * step, t % side * step) for t in range(count)]


def _tiles(sample: Sample) -> NDArray[np.float32]:
    """The first picture of each of the first tiles, with gaps between them."""
    n, places = sample.size, _squares(sample)
    sheet = np.ones((places[-1][0] + n, max(x for _, x in places) + n, 3), np.float32)
    for (y, x), row in zip(places, sample.material.variants.starts, strict=False):
        sheet[y : y + n, x : x + n] = _shown(sample.material.pixels[row].astype(np.float32), sample.material)
    return sheet
