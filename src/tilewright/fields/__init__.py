"""Signals on tilings, evaluated anywhere."""

from typing import TYPE_CHECKING

from tilewright.lazy import load_lazily

if TYPE_CHECKING:
    from tilewright.fields.brick_bonds import BondBricks
    from tilewright.fields.brick_field import BrickField
    from tilewright.fields.contenders import SideBySide, side_by_side
    from tilewright.fields.photo_fields import HexField, NoiseField, RepeatField
    from tilewright.fields.point_field import PointField
    from tilewright.fields.point_window import PointWindow
    from tilewright.fields.texture_field import TextureField

_HOME = {
    "BondBricks": "brick_bonds",
    "BrickField": "brick_field",
    "HexField": "photo_fields",
    "NoiseField": "photo_fields",
    "PointField": "point_field",
    "PointWindow": "point_window",
    "RepeatField": "photo_fields",
    "SideBySide": "contenders",
    "TextureField": "texture_field",
    "side_by_side": "contenders",
}

__all__ = [
    "BondBricks",
    "BrickField",
    "HexField",
    "NoiseField",
    "PointField",
    "PointWindow",
    "RepeatField",
    "SideBySide",
    "TextureField",
    "side_by_side",
]
__getattr__, __dir__ = load_lazily(__name__, _HOME)
