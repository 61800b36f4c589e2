from .dual_tiles import (
    DualPointTiles as DualPointTiles,
    DualRows as DualRows,
    dual_point_tiles as dual_point_tiles,
)
