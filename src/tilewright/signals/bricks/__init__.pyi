from .style import (
    BrickStyle as BrickStyle,
)
from .texture import (
    brick_texture_tiles as brick_texture_tiles,
)
