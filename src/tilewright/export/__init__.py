"""Bytes for other programs: the viewer page, texture arrays, packed atlases."""

from tilewright.export.array import save_array
from tilewright.export.atlas import make_atlas, save_atlas
from tilewright.export.viewer import save_viewer

__all__ = ["make_atlas", "save_array", "save_atlas", "save_viewer"]
