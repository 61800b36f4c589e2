"""Bytes for other programs: the viewer page, texture arrays, packed atlases."""

from tilewright.export.viewer import save_viewer

__all__ = ["save_viewer"]
