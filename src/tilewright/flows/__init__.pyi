from .flow import (
    FLOW_TILES as FLOW_TILES,
)
from .flow import (
    Flow as Flow,
)
from .flow import (
    FlowTile as FlowTile,
)
from .flow import (
    simulate_flow as simulate_flow,
)
from .flow import (
    strew_tiles as strew_tiles,
)
