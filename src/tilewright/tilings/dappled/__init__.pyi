from .closest import (
    Closest as Closest,
    closest_dapple as closest_dapple,
)
from .completing import (
    Impossible as Impossible,
    complete_dapple as complete_dapple,
    dapple_formula as dapple_formula,
)
from .conditions import (
    Conditions as Conditions,
    find_violations as find_violations,
)
from .counting import (
    count_dappled as count_dappled,
)
from .dappling import (
    dapple as dapple,
)
from .endless import (
    EndlessDappledTiling as EndlessDappledTiling,
    endless_dappled_tiling as endless_dappled_tiling,
)
from .starts import (
    random_start as random_start,
    start_from_image as start_from_image,
)
from .surgery import (
    rectify as rectify,
)
