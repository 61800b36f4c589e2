from .classes import (
    classed_corner_tiles as classed_corner_tiles,
)
from .coded import (
    corner_coded_tiles as corner_coded_tiles,
    crossed_wang_tiles as crossed_wang_tiles,
)
from .cubes import (
    compact_corner_cubes as compact_corner_cubes,
    compact_wang_cubes as compact_wang_cubes,
    corner_cubes as corner_cubes,
    wang_cubes as wang_cubes,
)
from .dual import (
    canonical_slots as canonical_slots,
    count_dual_tiles as count_dual_tiles,
    list_dual_tiles as list_dual_tiles,
)
from .families import (
    cohen_tiles as cohen_tiles,
    column_corner_tiles as column_corner_tiles,
    compact_wang_tiles as compact_wang_tiles,
    corner_tiles as corner_tiles,
    dominoes as dominoes,
    free_tiles as free_tiles,
    shifted_wang_tiles as shifted_wang_tiles,
    summed_wang_tiles as summed_wang_tiles,
    tile_set as tile_set,
    wang_tiles as wang_tiles,
)
from .listed import (
    ListedTileSet as ListedTileSet,
)
from .shape import (
    CORNER as CORNER,
    CORNER_CODED as CORNER_CODED,
    CORNER_CUBE as CORNER_CUBE,
    DOMINO as DOMINO,
    FREE as FREE,
    WANG as WANG,
    WANG_CUBE as WANG_CUBE,
    Shape as Shape,
)
from .tileset import (
    TileSet as TileSet,
    decode as decode,
    encode as encode,
)
from .translations import (
    as_wang_tiles as as_wang_tiles,
)
from .variants import (
    Variants as Variants,
)
