from .box import (
    Box as Box,
)
from .bridson import (
    bridson_darts as bridson_darts,
)
from .candidates import (
    best_candidate as best_candidate,
)
from .catalog import (
    METHODS as METHODS,
    Method as Method,
    sample_points as sample_points,
)
from .darts import (
    dart_throwing as dart_throwing,
)
from .elimination import (
    sample_elimination as sample_elimination,
)
from .jones import (
    jones_darts as jones_darts,
)
from .lloyd import (
    lloyd_relaxation as lloyd_relaxation,
)
from .maximal import (
    maximal_darts as maximal_darts,
)
from .penrose import (
    penrose_points as penrose_points,
)
from .point_set import (
    PointSet as PointSet,
)
from .radius import (
    max_radius as max_radius,
    nearest_distances as nearest_distances,
    relative_radius as relative_radius,
)
from .relaxation import (
    relaxation_darts as relaxation_darts,
)
from .scallops import (
    scallop_boundary as scallop_boundary,
    scallop_linear as scallop_linear,
    scallop_log as scallop_log,
)
from .yardsticks import (
    hexagonal as hexagonal,
    jittered as jittered,
    regular as regular,
    sobol as sobol,
    uniform as uniform,
)
