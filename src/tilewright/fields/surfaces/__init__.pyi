from .points import (
    SurfacePoints as SurfacePoints,
)
from .scattering import (
    KINDS as KINDS,
    refine_points as refine_points,
    surface_points as surface_points,
)
