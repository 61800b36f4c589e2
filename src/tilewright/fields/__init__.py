"""Signals on tilings, evaluated anywhere."""

from tilewright.fields.texture_field import TextureField

__all__ = ["TextureField"]
