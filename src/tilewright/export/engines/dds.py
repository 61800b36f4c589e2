"""DDS files: textures and texture arrays with their mip levels, as Direct3D programs and Unreal read them.

Written from Microsoft's programming guide for DDS: the structures DDS_HEADER and DDS_HEADER_DXT10.
"""

import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError

_FORMATS = {
    ("u1", 1): 61,  # R8_UNORM
    ("u1", 2): 49,  # R8G8_UNORM
    ("u1", 4): 28,  # R8G8B8A8_UNORM; 29 is _SRGB
    ("f2", 1): 54,  # R16_FLOAT
    ("f2", 2): 34,  # R16G16_FLOAT
    ("f2", 4): 10,  # R16G16B16A16_FLOAT
}
"""Numbers of DXGI_FORMAT by type and channels."""
# CAPS, HEIGHT, WIDTH, PITCH, PIXELFORMAT, MIPMAPCOUNT; and COMPLEX, TEXTURE, MIPMAP.
_FLAGS, _CAPS = 0x1 | 0x2 | 0x4 | 0x8 | 0x1000 | 0x20000, 0x8 | 0x1000 | 0x400000


def write_dds(path: Path, levels: list[NDArray[Any]], *, srgb: bool = False, old: bool = False) -> None:
    """Write a texture or a texture array with its mip levels.

    Parameters
    ----------
    levels : list of array, shape (layers, rows, columns, 1, 2 or 4), uint8 or float16
        The largest first.
    srgb : bool
        Whether the numbers are sRGB-encoded light; for four channels of uint8.
    old : bool
        The header from before Direct3D 10, for one layer of four channels of uint8, which go into the file
        as blue, green, red, alpha: what Unreal reads.
    """
    layers, rows, columns, channels = levels[0].shape
    kind = levels[0].dtype.str[1:]
    if (kind, channels) not in _FORMATS or (old and (kind, channels, layers) != ("u1", 4, 1)):
        raise TilewrightValueError(
            f"are {levels[0].dtype} {levels[0].shape}; expected uint8 or float16, 1, 2 or 4 channels",
            argument="levels",
            allowed="uint8 or float16, 1, 2 or 4 channels",
        )
    pitch = columns * channels * levels[0].itemsize
    if old:
        # RGB with ALPHAPIXELS, 32 bits, and the masks of red, green, blue and alpha.
        pixels = struct.pack("<8I", 32, 0x41, 0, 32, 0xFF0000, 0xFF00, 0xFF, 0xFF000000)
        more = b""
    else:
        pixels = struct.pack("<2I4s5I", 32, 0x4, b"DX10", 0, 0, 0, 0, 0)
        format = _FORMATS[kind, channels] + (srgb and (kind, channels) == ("u1", 4))
        more = struct.pack("<5I", format, 3, 0, layers, 0)  # 3: a 2D texture
    head = struct.pack("<4s7I44x", b"DDS ", 124, _FLAGS, rows, columns, pitch, 0, len(levels))
    with open(path, "wb") as file:
        file.write(head + pixels + struct.pack("<I16x", _CAPS) + more)
        for layer in range(layers):
            for level in levels:
                texels = level[layer][..., [2, 1, 0, 3]] if old else level[layer]
                file.write(np.ascontiguousarray(texels).tobytes())
