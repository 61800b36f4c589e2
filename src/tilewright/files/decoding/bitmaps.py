"""BMP files whose channels lie where bit masks say: no decoder at hand reads all orders.

Microsoft, BITMAPINFOHEADER and BITMAPV5HEADER: BI_BITFIELDS and BI_ALPHABITFIELDS with 16 or 32 bits.
"""

import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

_BITFIELDS = (3, 6)
_FILE_HEADER, _INFO_HEADER = 14, 40
_WITH_ALPHA_MASK = 56
"""The shortest header that holds a mask of alpha."""


def read_masked_bitmap(path: Path) -> NDArray[np.uint8] | None:
    """Pixels with 3 channels, or 4 where a mask names alpha; None for other and for damaged files."""
    data = path.read_bytes()
    if len(data) < _FILE_HEADER + _INFO_HEADER:
        return None
    start, header, width, height, _, bits, compression = struct.unpack_from("<IIiiHHI", data, 10)
    if compression not in _BITFIELDS or bits not in (16, 32) or min(width, abs(height)) < 1:
        return None
    stride = (width * bits // 8 + 3) // 4 * 4
    if len(data) < start + stride * abs(height):
        return None
    rows = np.frombuffer(data, np.uint8, stride * abs(height), start).reshape(abs(height), stride)
    texels = rows[:, : width * bits // 8].copy().view("<u2" if bits == 16 else "<u4")
    pixels = np.stack([_channel(texels, mask) for mask in _masks(data, header, compression)], axis=-1)
    return pixels if height < 0 else pixels[::-1]


def _masks(data: bytes, header: int, compression: int) -> list[int]:
    """The masks of red, green, blue, and of alpha where there is one."""
    with_alpha = header >= _WITH_ALPHA_MASK or compression == 6
    masks = struct.unpack_from(f"<{4 if with_alpha else 3}I", data, _FILE_HEADER + _INFO_HEADER)
    return [mask for number, mask in enumerate(masks) if mask or number < 3]


def _channel(texels: NDArray[Any], mask: int) -> NDArray[np.uint8]:
    """The bits under a mask, from 0 to 255."""
    if not mask:
        return np.zeros(texels.shape, np.uint8)
    shift = (mask & -mask).bit_length() - 1
    most = mask >> shift
    found = (texels.astype(np.uint64) & np.uint64(mask)) >> np.uint64(shift)
    return np.asarray((found * 255 + most // 2) // most, np.uint8)
