from .reading import (
    read_mesh as read_mesh,
)
