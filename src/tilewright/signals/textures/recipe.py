"""What is needed to make a set again: method, seed, settings, and the place of every patch."""

from typing import Any

import msgspec

from tilewright.checks import check_type
from tilewright.errors import TilewrightValueError
from tilewright.signals.textures.texture_tiles import TextureTiles

Spot = tuple[int, int, int]
"""(source, y, x): a pixel of a source."""


class Recipe(msgspec.Struct, omit_defaults=True):
    """How a texture was made; ``TextureTiles.recipe`` is this as a plain dict.

    Attributes
    ----------
    patches : the place each named patch was taken from.
    picked, rejected : what an artist asked for; see `tilewright.synthesize`.
    variants : pictures of each tile; left out where there is one.
    tone : whether tone lies outside the tiles.
    treatment : what was decided for the photograph, see `Treatment`.
    lone : where things pop out that no corner patch and no edge patch shows.
    """

    method: str
    seed: int
    tile_size: int
    weights: dict[str, float]
    patches: dict[str, Spot]
    picked: dict[str, Spot]
    rejected: dict[str, list[Spot]]
    variants: int = 1
    tone: bool = False
    treatment: str = ""
    lone: list[Spot] = []

    @classmethod
    def of(cls, material: TextureTiles) -> "Recipe":
        """The recipe of a material; an error where it has none that can be replayed."""
        check_type("material", material, TextureTiles, "TextureTiles")
        try:
            return msgspec.convert(material.recipe, cls)
        except msgspec.ValidationError as error:
            reason = str(error)[:1].lower() + str(error)[1:]
            raise TilewrightValueError(f"the material's recipe cannot be replayed: {reason}") from None

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values."""
        plain: dict[str, Any] = msgspec.json.decode(msgspec.json.encode(self))
        return plain
