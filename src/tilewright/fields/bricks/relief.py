"""Surfaces in sunlight, so that a relief can be seen: shading, cast shadows, what hides the sky."""

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures.kinds import to_encoded, to_linear

MARGIN = 16
"""Pixels of surface around a picture that may throw shadows into it."""
_SUN = (-0.60, -0.62, 0.50)
"""East, south and up: from the north-west, a third of the way up the sky."""
_LIGHTS = ((1.02, 0.97, 0.90), (0.36, 0.39, 0.43))
"""Colors of sun and sky."""
_RING = 4
"""Pixels from a place to those around it that may hide the sky from it."""


def light(maps: dict[str, NDArray[Any]], relief: float) -> NDArray[np.uint8]:
    """A lit picture.

    Parameters
    ----------
    maps : dict of arrays, shape (h + 2 MARGIN, w + 2 MARGIN, channels)
        ``color`` uint8 sRGB, perhaps with alpha, ``height`` uint16 and ``normal`` uint8 with green up.
    relief : float
        Pixels that a height of 65535 stands above 0.

    Returns
    -------
    uint8 array, shape (h, w, 3 or 4)
    """
    from tilewright.kernels.brick_drawing import light_surface

    inner = (slice(MARGIN, -MARGIN), slice(MARGIN, -MARGIN))
    color, alpha, normal = maps["color"][inner][..., :3], maps["color"][inner][..., 3:], maps["normal"][inner]
    height = maps["height"][..., 0] * np.float32(relief / 65535)
    out = np.empty(color.shape, np.uint8)
    sun = np.array(_SUN) / np.linalg.norm(_SUN)
    longest = np.abs(sun[:2]).max()
    steps = np.arange(1, MARGIN)[:, np.newaxis]
    path = np.rint(steps * sun[:2] / longest).astype(np.int64)
    around = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    ring = np.rint(_RING * np.stack([np.cos(around), np.sin(around)], axis=1)).astype(np.int64)
    to_sun = np.append(sun, sun[2] / longest).astype(np.float32)
    lights = np.array(_LIGHTS, np.float32)
    light_surface(len(out), height, normal, color, to_sun, path, ring, lights, *_tables(), out)
    return np.concatenate([out, alpha], axis=2) if alpha.size else out


@cache
def _tables() -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
    """Light of encoded values, and encoded values of light."""
    encoded = to_encoded(np.linspace(0, 1, 2**14, dtype=np.float32))
    return to_linear(np.arange(256) / 255), np.rint(encoded * 255).astype(np.uint8)
