"""One word for measuring whatever there is: texture tiles, point tiles, point sets."""

from collections.abc import Sequence

from tilewright.analysis.points.laid_tiles import analyze_point_tiles
from tilewright.analysis.points.report import PointReport, analyze_points
from tilewright.analysis.textures.report import Report, analyze_texture
from tilewright.checks import check_progress
from tilewright.errors import Progress
from tilewright.samplers.point_set import PointSet
from tilewright.signals.points import PointTiles
from tilewright.signals.textures import TextureTiles


def analyze(
    material: TextureTiles | PointTiles | PointSet | Sequence[PointSet],
    *,
    cells: int = 12,
    seed: int = 0,
    progress: Progress | None = None,
) -> Report | PointReport:
    """Measure a set of tiles or of points; the result has ``figures`` and ``save_sheet(path)``.

    Parameters
    ----------
    material : TextureTiles, PointTiles, PointSet or list of PointSet
        Texture tiles are measured for seams, repetition and structure. Point tiles are measured on ten
        tilings of about 16,384 points and one of 262,144. Point sets lie in one plane box and have at least 3
        points.
    cells : int, optional
        Of textures, how many cells along a side are looked at, 4 to 64; default 12.
    seed : int, optional
        Seed of the tilings, and of the patches that are compared; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    Report or PointReport
        A `Report` of texture tiles, a `PointReport` of anything else.

    Raises
    ------
    TilewrightTypeError
        Something that is none of these.
    TilewrightValueError
        A number out of range, too few points, or sets of different boxes.

    Examples
    --------
    >>> import tilewright as tw
    >>> report = tw.analyze(tw.sample_points("dart", 1000, seed=1))
    >>> report.figures["count"], report.figures["rho"] > 0.7
    (1000.0, True)
    """
    check_progress(progress)
    if isinstance(material, PointTiles):
        return analyze_point_tiles(material, seed=seed, progress=progress)
    if isinstance(material, TextureTiles) or not isinstance(material, (PointSet, list, tuple)):
        return analyze_texture(material, cells=cells, seed=seed, progress=progress)  # type: ignore[arg-type]
    return analyze_points(material, progress=progress)
