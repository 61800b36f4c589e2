"""What a field is made of: a signal, and a tiling of the same tile set."""

from typing import Any

import numpy as np

from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tilings import Tiling


def check_agreement(signal: Any, kind: type[Any], tiling: Any) -> None:
    """Raise unless ``signal`` is of a kind and made for the tile set that ``tiling`` lays."""
    if not isinstance(signal, kind) or not isinstance(tiling, Tiling):
        raise TilewrightTypeError(
            f"a field takes {kind.__name__} and a Tiling, not {type(signal).__name__} and "
            f"{type(tiling).__name__}"
        )
    ours, theirs = signal.tiles, tiling.tiles
    if ours.shape is not theirs.shape or not np.array_equal(ours.slots, theirs.slots):
        raise TilewrightValueError(
            f"the {kind.__name__} are made for {ours!r}, the tiling lays {theirs!r}; they must be the "
            "same set"
        )
