"""One word for measuring whatever there is: texture tiles, point tiles, point sets."""

from collections.abc import Sequence

from tilewright.analysis.points.laid_tiles import analyze_point_tiles
from tilewright.analysis.points.report import PointReport, analyze_points
from tilewright.analysis.textures.report import Report, analyze_texture
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
        See `analyze_texture`, `analyze_point_tiles` and `analyze_points`.
    cells : int
        Of textures, how many cells along a side are looked at, 4 to 64.
    seed : int
        Seed of the tilings, and of the patches that are compared.
    """
    if isinstance(material, PointTiles):
        return analyze_point_tiles(material, seed=seed, progress=progress)
    if isinstance(material, TextureTiles) or not isinstance(material, (PointSet, list, tuple)):
        return analyze_texture(material, cells=cells, seed=seed, progress=progress)  # type: ignore[arg-type]
    return analyze_points(material, progress=progress)
