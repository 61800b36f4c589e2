from .targets import (
    TARGETS as TARGETS,
)
from .targets import (
    save_for_engine as save_for_engine,
)
