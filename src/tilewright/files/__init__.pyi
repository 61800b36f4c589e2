from .images import (
    read_image as read_image,
    write_image as write_image,
)
from .map_stack import (
    find_maps as find_maps,
)
from .meshes import (
    read_mesh as read_mesh,
)
from .point_files import (
    read_points as read_points,
    write_points as write_points,
)
from .ready import (
    ready_tiles as ready_tiles,
)
from .surface_files import (
    write_surface_points as write_surface_points,
)
from .tileset_folder import (
    load as load,
    load_points as load_points,
    load_texture as load_texture,
    save as save,
)
