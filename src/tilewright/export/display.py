"""What pixels mean to the eye: bytes for a screen."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.pixels import without_alpha
from tilewright.signals.textures.kinds import to_encoded


def screen_bytes(pixels: NDArray[Any], light: bool) -> tuple[NDArray[np.uint8], str]:
    """8-bit pixels for a screen, with 1 to 4 channels, and a note on what was done to them.

    uint8 is kept; uint16 is rounded. Float light is encoded as sRGB, brighter light than 1 scaled so that
    all but the brightest thousandth fits; other floats outside 0 to 1 are stretched between their lowest
    and highest thousandths. Of four channels of data the
    first three are shown; two get a third of zeros.
    """
    note = ""
    if pixels.dtype == np.uint16:
        pixels = ((pixels.astype(np.uint32) * 255 + 32767) // 65535).astype(np.uint8)
        note = "16 bit, shown in 8"
    elif pixels.dtype == np.float32:
        pixels, note = _float_bytes(pixels, light)
    if pixels.shape[-1] == 4 and not light:
        pixels, note = pixels[..., :3], ", ".join(filter(None, [note, "fourth channel not shown"]))
    if pixels.shape[-1] == 2 and not light:
        pixels = np.concatenate([pixels, np.zeros_like(pixels[..., :1])], axis=-1)
    return pixels, note


def _float_bytes(pixels: NDArray[np.float32], light: bool) -> tuple[NDArray[np.uint8], str]:
    values = pixels.astype(np.float64)
    color = without_alpha(values) if light else values
    low, high = 0.0, 1.0
    if light and color.max() > 1:
        high = float(np.quantile(color, 0.999))
    elif not light and (color.min() < 0 or color.max() > 1):
        low, high = (float(q) for q in np.quantile(color, (0.001, 0.999)))
    color -= low
    color /= max(high - low, 1e-12)
    np.clip(values, 0, 1, out=values)
    if light:
        color[...] = to_encoded(color)
    return np.rint(values * 255).astype(np.uint8), f"float, shown from {low:.4g} to {high:.4g}"
