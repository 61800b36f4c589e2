"""Bytes for other programs: the viewer page, texture arrays, packed atlases, folders for engines."""

from tilewright.export.array import save_array
from tilewright.export.atlas import make_atlas, save_atlas
from tilewright.export.engines import TARGETS, save_for_engine
from tilewright.export.ktx2 import write_ktx2
from tilewright.export.viewer import save_viewer

__all__ = [
    "TARGETS",
    "make_atlas",
    "save_array",
    "save_atlas",
    "save_for_engine",
    "save_viewer",
    "write_ktx2",
]
