from .targets import (
    TARGETS as TARGETS,
    save_for_engine as save_for_engine,
)
