"""Pictures and their means as the page holds them."""

import base64
import io
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.shaders.mipmaps import tone_levels, tone_mean
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.kinds import to_linear


def describe_map(
    name: str, shown: NDArray[np.uint8], light: bool, tone: dict[str, Any] | None = None
) -> dict[str, Any]:
    """A map's pictures, shape (rows, H, W, channels), as the page holds them; and its `describe_tone`."""
    described: dict[str, Any] = {
        "name": name,
        "light": light,
        "mean": mean_color(shown, light),
        "tiles": [encode_png(tile) for tile in shown],
    }
    if tone:
        described["tone"] = tone
    return described


def describe_tone(material: TextureTiles, map: str, span: float = 1.0) -> dict[str, Any] | None:
    """The tone of a map, if it has any, where ``span`` is shown from black to white.

    Its mip levels one after another, as red, green, blue and 0 in half floats; and the map's mean.
    """
    levels = tone_levels(material, map)
    if not levels:
        return None
    values = b"".join((level / np.float32(span)).astype("<f2").tobytes() for level in levels)
    height, width = levels[0].shape[:2]
    mean = _rounded(value / span for value in tone_mean(material, map))
    return {"width": width, "height": height, "mean": mean, "values": base64.b64encode(values).decode()}


def mean_color(shown: NDArray[np.uint8], light: bool) -> list[float]:
    """Mean of all tiles as the shader adds them up: linear where light, color multiplied by alpha."""
    values = np.arange(256) / 255
    table = to_linear(values) if light else values
    channels = shown.shape[-1]
    if channels in (1, 3):
        color = np.array([table[shown[..., c]].mean() for c in range(channels)])
        return _rounded([*np.resize(color, 3), 1.0])
    alpha = values[shown[..., -1]]
    color = np.array([(table[shown[..., c]] * alpha).mean() for c in range(channels - 1)])
    return _rounded([*np.resize(color, 3), alpha.mean()])


def _rounded(values: Iterable[Any]) -> list[float]:
    return [round(float(value), 6) for value in values]


def encode_png(pixels: NDArray[np.uint8]) -> str:
    """A picture, shape (h, w, channels), as PNG in base64."""
    from PIL import Image

    stream = io.BytesIO()
    picture = Image.fromarray(pixels.squeeze(-1) if pixels.shape[-1] == 1 else pixels)
    picture.save(stream, "PNG", compress_level=9)
    return base64.b64encode(stream.getvalue()).decode()
