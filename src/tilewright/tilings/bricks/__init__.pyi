from .boundary import (
    BrickRegion as BrickRegion,
)
from .boundary import (
    brick_region as brick_region,
)
from .endless import (
    EndlessBrickTiling as EndlessBrickTiling,
)
from .endless import (
    endless_brick_tiling as endless_brick_tiling,
)
from .from_dappled import (
    brick_tiling as brick_tiling,
)
