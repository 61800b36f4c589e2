from .points import (
    SurfacePoints as SurfacePoints,
)
from .scattering import (
    refine_points as refine_points,
    surface_points as surface_points,
)
