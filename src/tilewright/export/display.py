"""What pixels mean to the eye: bytes for a screen."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.pixels import without_alpha
from tilewright.signals.textures.kinds import to_encoded


class Shown(NamedTuple):
    """What a screen shows of pixels.

    Attributes
    ----------
    pixels : uint8 array, with 1 to 4 channels
    note : str
        What was done to them.
    span : float
        How much lies between black and white in their own numbers, as a share of their type's white.
    """

    pixels: NDArray[np.uint8]
    note: str
    span: float


def screen_bytes(pixels: NDArray[Any], light: bool, *, room: tuple[float, float] = (0.0, 0.0)) -> Shown:
    """8-bit pixels for a screen.

    uint8 is kept; uint16 is rounded. Float light is encoded as sRGB, brighter light than 1 scaled so that
    all but the brightest thousandth fits; other floats outside 0 to 1 are stretched between their lowest
    and highest thousandths, and as much farther as ``room`` says. Of four channels of data the
    first three are shown; two get a third of zeros.
    """
    note, span = "", 1.0
    if pixels.dtype == np.uint16:
        pixels = ((pixels.astype(np.uint32) * 255 + 32767) // 65535).astype(np.uint8)
        note = "16 bit, shown in 8"
    elif pixels.dtype == np.float32:
        pixels, note, span = _float_bytes(pixels, light, room)
    if pixels.shape[-1] == 4 and not light:
        pixels, note = pixels[..., :3], ", ".join(filter(None, [note, "fourth channel not shown"]))
    if pixels.shape[-1] == 2 and not light:
        pixels = np.concatenate([pixels, np.zeros_like(pixels[..., :1])], axis=-1)
    return Shown(pixels, note, span)


def _float_bytes(pixels: NDArray[np.float32], light: bool, room: tuple[float, float]) -> Shown:
    values = pixels.astype(np.float64)
    color = without_alpha(values) if light else values
    low, high = 0.0, 1.0
    if light and color.max() > 1:
        high = float(np.quantile(color, 0.999))
    elif not light and (color.min() < 0 or color.max() > 1):
        low, high = (float(q + r) for q, r in zip(np.quantile(color, (0.001, 0.999)), room, strict=True))
    color -= low
    color /= max(high - low, 1e-12)
    np.clip(values, 0, 1, out=values)
    if light:
        color[...] = to_encoded(color)
    shown = np.rint(values * 255).astype(np.uint8)
    return Shown(
        shown, f"float, shown from {low:.4g} to {high:.4g}", high ** (1 / 2.4) if light else high - low
    )
