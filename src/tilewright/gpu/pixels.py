"""How pixels of a map travel to a GPU and back: texture formats that keep every bit."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.pixels import as_rgba, without_alpha
from tilewright.signals.textures.kinds import to_encoded, to_linear


@dataclass(frozen=True)
class PixelFormat:
    """The formats of a map.

    Attributes
    ----------
    texture, target : str
        Format of the texture, and of the picture that is drawn.
    stored : int
        Channels of the texture.
    """

    dtype: np.dtype[Any]
    channels: int
    color: bool
    """Whether the map holds light, which filters average linearly."""
    texture: str
    target: str
    stored: int

    @classmethod
    def of(cls, pixels: NDArray[Any], kind: str) -> "PixelFormat":
        """Formats for a map: 8 bit as it is, sRGB decoded by the texture unit; others as 32-bit floats."""
        channels = pixels.shape[-1]
        color = kind == "color" and pixels.dtype.kind == "u"
        if pixels.dtype == np.uint8:
            stored = 4 if color else {1: 1, 2: 2}.get(channels, 4)
            ending = "unorm-srgb" if color else "unorm"
            name = "rgba"[:stored] if stored < 4 else "rgba"
            return cls(pixels.dtype, channels, color, f"{name}8{ending}", f"rgba8{ending}", stored)
        stored = {1: 1, 2: 2}.get(channels, 4)
        return cls(pixels.dtype, channels, color, f"{'rgba'[:stored]}32float", "rgba32float", stored)

    @property
    def target_dtype(self) -> np.dtype[Any]:
        """Type of the numbers of the picture that is drawn."""
        return np.dtype(np.uint8 if self.target.startswith("rgba8") else np.float32)

    def upload(self, level: NDArray[Any]) -> NDArray[Any]:
        """Pixels as the texture stores them."""
        if self.target_dtype == np.uint8:
            return self._fit(level)
        values = level.astype(np.float32)
        if self.dtype == np.uint16:
            values /= np.float32(65535)
        if self.color:
            light = without_alpha(values)
            light[...] = to_linear(light)
        return self._fit(values)

    def download(self, picture: NDArray[Any]) -> NDArray[Any]:
        """Pixels of the map from a picture with four channels."""
        if self.target_dtype == np.uint8:
            kept = [0, 3] if self.color and self.channels == 2 else list(range(self.channels))
            return np.ascontiguousarray(picture[..., kept])
        values = picture[..., : self.channels].copy()
        if self.color:
            light = without_alpha(values)
            light[...] = to_encoded(light)
        if self.dtype == np.uint16:
            values = np.rint(np.clip(values, 0, 1) * np.float32(65535))
        return values.astype(self.dtype)

    def _fit(self, level: NDArray[Any]) -> NDArray[Any]:
        """With as many channels as the texture has."""
        return level if level.shape[-1] == self.stored else as_rgba(level)
