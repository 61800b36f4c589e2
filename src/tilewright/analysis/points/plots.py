"""Points drawn as they lie, with their box."""

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.analysis.sheets import check_sheet, need_plots, save_figure
from tilewright.errors import TilewrightValueError
from tilewright.files.atomic import AnyPath
from tilewright.samplers.box import as_points
from tilewright.samplers.point_set import PointSet

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SIDE = 7.0
"""Inches of the longer side of the box."""
_SHARE = 0.3
"""Width of a dot in mean spacings."""


def plot_points(points: PointSet | ArrayLike, path: AnyPath | None = None) -> "Figure":
    """Draw points in their box, both axes at one scale, y downwards.

    Parameters
    ----------
    points : PointSet, PointWindow or array-like of shape (n, 2)
        The points, x first, at least one. Points without a box get the rectangle around them.
    path : str or path-like, optional
        ``.png``, ``.jpg``, ``.svg`` or ``.pdf``, which is written; by default no file is.

    Returns
    -------
    matplotlib.figure.Figure
        The figure, whose only axes can be drawn on.

    Raises
    ------
    TilewrightTypeError
        Something that is not points.
    TilewrightValueError
        No points, or none in a plane; another suffix.
    TilewrightFileError
        The file cannot be written.
    MissingExtra
        The package matplotlib is not installed; the extra ``plots`` brings it.

    Examples
    --------
    >>> import tilewright as tw
    >>> figure = tw.plot_points(tw.sample_points("dart", 100, seed=1))
    >>> [float(x) for x in figure.axes[0].get_xlim()]
    [0.0, 1.0]
    """
    need_plots()
    if path is not None:
        check_sheet(path)
    given = as_points(np.asarray(points))
    if not len(given):
        raise TilewrightValueError("are none; at least one is needed", argument="points")
    low, high = _frame(points, given)
    figure = _draw(given, low, high, _outline(points))
    if path is not None:
        save_figure(path, lambda: figure, dpi=160)
    return figure


def _frame(points: object, given: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Two corners of what is shown."""
    if isinstance(points, PointSet):
        return np.zeros(2), np.array(points.box.extent)
    low, high = given.min(axis=0), given.max(axis=0)
    margin = 0.02 * max(float((high - low).max()), 1e-12)
    return low - margin, high + margin


def _outline(points: object) -> str:
    """How the sides are drawn: dashed where they are open, or opposite ones meet."""
    return "-" if isinstance(points, PointSet) and not points.box.torus else "--"


def _draw(
    given: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64], outline: str
) -> "Figure":
    from matplotlib.figure import Figure

    extent = high - low
    scale = _SIDE / extent.max()
    figure = Figure(figsize=tuple(np.maximum(extent * scale, 1) + 1), layout="constrained")
    axis = figure.subplots()
    spacing = min(0.1 * _SIDE, scale * sqrt(extent.prod() / len(given)))
    x, y = given.T
    axis.scatter(x, y, s=(72 * _SHARE * spacing) ** 2, c="black", linewidths=0, clip_on=False)
    axis.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]), aspect="equal", xlabel="x", ylabel="y")
    axis.spines[:].set_linestyle(outline)
    axis.set_title(f"{len(given):,} points", fontsize=11)
    return figure
