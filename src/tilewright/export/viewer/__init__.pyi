from .page import (
    save_viewer as save_viewer,
)
