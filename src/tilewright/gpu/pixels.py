"""How pixels of a map travel to a GPU and back: texture formats that keep every bit."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

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
            return _spread(level, self.stored, self.color, np.uint8(255))
        values = level.astype(np.float32)
        if self.dtype == np.uint16:
            values /= np.float32(65535)
        if self.color:
            values[..., : self._lights] = to_linear(values[..., : self._lights])
        return _spread(values, self.stored, False, np.float32(1))

    def download(self, picture: NDArray[Any]) -> NDArray[Any]:
        """Pixels of the map from a picture with four channels."""
        if self.target_dtype == np.uint8:
            kept = [0, 3] if self.color and self.channels == 2 else list(range(self.channels))
            return np.ascontiguousarray(picture[..., kept])
        values = picture[..., : self.channels].copy()
        if self.color:
            values[..., : self._lights] = to_encoded(values[..., : self._lights])
        if self.dtype == np.uint16:
            values = np.rint(np.clip(values, 0, 1) * np.float32(65535))
        return values.astype(self.dtype)

    @property
    def _lights(self) -> int:
        """Channels that hold light and not alpha."""
        return self.channels - (self.channels in (2, 4))


def _spread(level: NDArray[Any], stored: int, color: bool, full: Any) -> NDArray[Any]:
    """More channels: gray in all three lights, opaque."""
    channels = level.shape[-1]
    if channels == stored:
        return level
    out = np.full((*level.shape[:-1], stored), full, level.dtype)
    if color and channels <= 2:
        out[..., :3] = level[..., :1]
        if channels == 2:
            out[..., 3] = level[..., 1]
    else:
        out[..., :channels] = level
    return out
