"""Signals on tilings, evaluated anywhere."""

from tilewright.fields.point_field import PointField
from tilewright.fields.point_window import PointWindow
from tilewright.fields.texture_field import TextureField

__all__ = ["PointField", "PointWindow", "TextureField"]
