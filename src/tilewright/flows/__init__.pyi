from .flow import (
    FLOW_TILES as FLOW_TILES,
    Flow as Flow,
    FlowTile as FlowTile,
    simulate_flow as simulate_flow,
    strew_tiles as strew_tiles,
)
