"""Alpha that is multiplied in (associated) and alpha that is not (straight, unassociated).

Porter & Duff 1984, section 3; TIFF 6.0, section 18; OpenEXR Technical Introduction, "Premultiplied vs.
un-premultiplied color".
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.pixels import white


def to_straight(pixels: NDArray[Any]) -> NDArray[Any]:
    """Colors divided by the alpha that was multiplied in; where alpha is 0 they stay as they are.

    Integers are rounded, and end at white.
    """
    most = white(pixels.dtype)
    straight = pixels.copy()
    changed = (pixels[..., -1] != most) & (pixels[..., -1] != 0)
    part = pixels[changed].astype(np.float64)
    colors = part[:, :-1] * most / part[:, -1:]
    if pixels.dtype.kind == "u":
        colors = np.minimum(np.rint(colors), most)
    straight[changed, :-1] = colors
    return straight


def to_associated(pixels: NDArray[np.float32]) -> NDArray[np.float32]:
    """Colors multiplied by alpha; where alpha is 0, nothing is left of them."""
    associated = pixels.copy()
    associated[..., :-1] *= pixels[..., -1:]
    return associated


def glows(pixels: NDArray[Any]) -> bool:
    """Whether associated pixels give light where alpha is 0, which straight alpha cannot say."""
    return bool(pixels[pixels[..., -1] == 0][:, :-1].any())
