from .materials import (
    add_maps as add_maps,
)
from .materials import (
    open_exemplar as open_exemplar,
)
from .materials import (
    texture_tiles as texture_tiles,
)
