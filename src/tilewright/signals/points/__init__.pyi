from .catalog import (
    TILE_METHODS as TILE_METHODS,
    make_point_tiles as make_point_tiles,
)
from .point_tiles import (
    PointTiles as PointTiles,
)
from .promise import (
    Closeness as Closeness,
    find_closeness as find_closeness,
)
from .recursion import (
    recursive_points as recursive_points,
)
from .spikes import (
    Spikes as Spikes,
    find_spikes as find_spikes,
)
from .synthesis import (
    METHODS as METHODS,
    poisson_tiles as poisson_tiles,
)
