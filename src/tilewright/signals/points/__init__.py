"""Point tiles: Poisson disk distributions over a tile set."""

from typing import TYPE_CHECKING

from tilewright.lazy import load_lazily

if TYPE_CHECKING:
    from tilewright.signals.points.catalog import TILE_METHODS, make_point_tiles
    from tilewright.signals.points.point_tiles import PointTiles
    from tilewright.signals.points.promise import Closeness, find_closeness
    from tilewright.signals.points.recursion import recursive_points
    from tilewright.signals.points.spikes import Spikes, find_spikes
    from tilewright.signals.points.synthesis import METHODS, poisson_tiles

# Construction needs finufft; laying what was made does not.
_HOME = {
    "METHODS": "synthesis",
    "TILE_METHODS": "catalog",
    "Closeness": "promise",
    "PointTiles": "point_tiles",
    "Spikes": "spikes",
    "find_closeness": "promise",
    "find_spikes": "spikes",
    "make_point_tiles": "catalog",
    "poisson_tiles": "synthesis",
    "recursive_points": "recursion",
}

__all__ = [
    "METHODS",
    "TILE_METHODS",
    "Closeness",
    "PointTiles",
    "Spikes",
    "find_closeness",
    "find_spikes",
    "make_point_tiles",
    "poisson_tiles",
    "recursive_points",
]
__getattr__, __dir__ = load_lazily(__name__, _HOME)
