from .mesh import (
    Mesh as Mesh,
)
from .spots import (
    Spots as Spots,
)
from .surface import (
    Surface as Surface,
)
