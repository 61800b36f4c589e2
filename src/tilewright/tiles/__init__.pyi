from .coded import (
    corner_coded_tiles as corner_coded_tiles,
)
from .coded import (
    crossed_wang_tiles as crossed_wang_tiles,
)
from .cubes import (
    compact_corner_cubes as compact_corner_cubes,
)
from .cubes import (
    compact_wang_cubes as compact_wang_cubes,
)
from .cubes import (
    corner_cubes as corner_cubes,
)
from .cubes import (
    wang_cubes as wang_cubes,
)
from .families import (
    as_wang_tiles as as_wang_tiles,
)
from .families import (
    cohen_tiles as cohen_tiles,
)
from .families import (
    column_corner_tiles as column_corner_tiles,
)
from .families import (
    compact_wang_tiles as compact_wang_tiles,
)
from .families import (
    corner_tiles as corner_tiles,
)
from .families import (
    dominoes as dominoes,
)
from .families import (
    free_tiles as free_tiles,
)
from .families import (
    shifted_wang_tiles as shifted_wang_tiles,
)
from .families import (
    summed_wang_tiles as summed_wang_tiles,
)
from .families import (
    tile_set as tile_set,
)
from .families import (
    wang_tiles as wang_tiles,
)
from .listed import (
    ListedTileSet as ListedTileSet,
)
from .shape import (
    CORNER as CORNER,
)
from .shape import (
    CORNER_CODED as CORNER_CODED,
)
from .shape import (
    CORNER_CUBE as CORNER_CUBE,
)
from .shape import (
    DOMINO as DOMINO,
)
from .shape import (
    FREE as FREE,
)
from .shape import (
    WANG as WANG,
)
from .shape import (
    WANG_CUBE as WANG_CUBE,
)
from .shape import (
    Shape as Shape,
)
from .tileset import (
    TileSet as TileSet,
)
from .tileset import (
    decode as decode,
)
from .tileset import (
    encode as encode,
)
from .variants import (
    Variants as Variants,
)
