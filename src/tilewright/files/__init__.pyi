from .images import (
    read_image as read_image,
)
from .images import (
    write_image as write_image,
)
from .map_stack import (
    find_maps as find_maps,
)
from .point_files import (
    read_points as read_points,
)
from .point_files import (
    write_points as write_points,
)
from .ready import (
    ready_tiles as ready_tiles,
)
from .tileset_folder import (
    load as load,
)
from .tileset_folder import (
    load_points as load_points,
)
from .tileset_folder import (
    load_texture as load_texture,
)
from .tileset_folder import (
    save as save,
)
