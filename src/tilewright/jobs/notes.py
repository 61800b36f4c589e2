"""What an output does not do that its material may have been made for, said once."""

import warnings
from typing import TYPE_CHECKING

from tilewright.errors import TilewrightWarning

if TYPE_CHECKING:
    from tilewright.signals.textures import TextureTiles


def note_chance(material: "TextureTiles", where: str) -> None:
    """Say that two photographs lie by chance where nothing steers them."""
    if len(material.sources) > 1:
        warnings.warn(
            f"the two photographs lie by chance in {where}; a picture steers them in renders alone "
            "(density_tiling)",
            TilewrightWarning,
            stacklevel=3,
        )
