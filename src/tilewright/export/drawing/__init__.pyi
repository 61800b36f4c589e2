from .cells import (
    draw_cells as draw_cells,
)
from .cells import (
    paint_cells as paint_cells,
)
from .flows import (
    draw_density as draw_density,
)
from .flows import (
    draw_trails as draw_trails,
)
from .flows import (
    save_animation as save_animation,
)
from .jigsaw import (
    Jigsaw as Jigsaw,
)
from .jigsaw import (
    draw_jigsaw as draw_jigsaw,
)
from .svg import (
    save_svg as save_svg,
)
from .tiles import (
    draw_tiles as draw_tiles,
)
from .tiles import (
    draw_tiling as draw_tiling,
)
from .tiles import (
    paint_tiles as paint_tiles,
)
from .tiles import (
    paint_tiling as paint_tiling,
)
from .walls import (
    draw_wall as draw_wall,
)
