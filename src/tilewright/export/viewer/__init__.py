"""The viewer: one HTML file that shows an endless texture in a browser."""

from tilewright.export.viewer.page import save_viewer

__all__ = ["save_viewer"]
