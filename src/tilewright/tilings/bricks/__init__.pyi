from .boundary import (
    BrickRegion as BrickRegion,
    brick_region as brick_region,
)
from .endless import (
    EndlessBrickTiling as EndlessBrickTiling,
    endless_brick_tiling as endless_brick_tiling,
)
from .from_dappled import (
    brick_tiling as brick_tiling,
)
