from .cells import (
    draw_cells as draw_cells,
    paint_cells as paint_cells,
)
from .flows import (
    draw_density as draw_density,
    draw_trails as draw_trails,
    save_animation as save_animation,
)
from .formats import (
    save_drawing as save_drawing,
)
from .jigsaw import (
    Jigsaw as Jigsaw,
    draw_jigsaw as draw_jigsaw,
)
from .sheets import (
    draw_jigsaw_sheets as draw_jigsaw_sheets,
)
from .svg import (
    save_svg as save_svg,
)
from .tiles import (
    draw_tiles as draw_tiles,
    draw_tiling as draw_tiling,
    paint_tiles as paint_tiles,
    paint_tiling as paint_tiling,
)
from .walls import (
    draw_wall as draw_wall,
)
