"""KTX 2.0 files: textures and texture arrays with their mip levels, ready to be copied to a GPU.

Written from the Khronos KTX File Format Specification 2.0 and, for the descriptor of the texels, the
Khronos Data Format Specification 1.4, section 5 (basic descriptor block).
"""

import math
import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from tilewright import __version__
from tilewright.checks import check_choice, shape_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.files.atomic import AnyPath, as_path, whole_file
from tilewright.pixels import as_rgba, white

_IDENTIFIER = b"\xabKTX 20\xbb\r\n\x1a\n"
_HEADER = struct.Struct("<12s9I4I2Q")
_LEVEL = struct.Struct("<3Q")

# VkFormat numbers by type and channels (Vulkan specification, "Format Definition").
_VK_FORMATS = {
    ("u1", 1): 9,  # R8_UNORM
    ("u1", 2): 16,  # R8G8_UNORM
    ("u1", 4): 37,  # R8G8B8A8_UNORM
    ("u2", 1): 70,  # R16_UNORM
    ("u2", 2): 77,  # R16G16_UNORM
    ("u2", 4): 91,  # R16G16B16A16_UNORM
    ("f2", 1): 76,  # R16_SFLOAT
    ("f2", 2): 83,  # R16G16_SFLOAT
    ("f2", 4): 97,  # R16G16B16A16_SFLOAT
}
_R8G8B8A8_SRGB = 43

_CHANNELS = (0, 1, 2, 15)  # red, green, blue, alpha
_LINEAR_ALPHA, _SIGNED_FLOAT = 0x10, 0xC0  # qualifiers of a sample
_HALF_LARGEST = float(np.finfo(np.float16).max)

# Pixels across and down and bytes of one block.
_BLOCKS = {
    "R8": (1, 1, 1),
    "RG8": (1, 1, 2),
    "RGBA8": (1, 1, 4),
    "R16": (1, 1, 2),
    "RG16": (1, 1, 4),
    "RGBA16": (1, 1, 8),
    "R16F": (1, 1, 2),
    "RG16F": (1, 1, 4),
    "RGBA16F": (1, 1, 8),
    "BC4": (4, 4, 8),
    "BC5": (4, 4, 16),
    "BC7": (4, 4, 16),
    "ASTC 4x4": (4, 4, 16),
    "ASTC 6x6": (6, 6, 16),
}
GPU_FORMATS = tuple(_BLOCKS)
"""The formats `gpu_bytes` knows."""


@dataclass(frozen=True)
class _Layout:
    """How texels lie in the file."""

    kind: np.dtype[Any]  # of one channel, little-endian
    channels: int
    srgb: bool

    @property
    def texel(self) -> int:
        """Bytes of a texel."""
        return self.kind.itemsize * self.channels

    @property
    def vk_format(self) -> int:
        if self.srgb and self.kind == np.uint8:
            return _R8G8B8A8_SRGB
        return _VK_FORMATS[self.kind.str[1:], self.channels]


def write_ktx2(path: AnyPath, levels: Sequence[NDArray[Any]], *, srgb: bool) -> None:
    """Write a texture, or a texture array, with its mip levels.

    Parameters
    ----------
    path : str or path-like
        The ``.ktx2`` file; it appears when it is complete.
    levels : sequence of array, shape (rows, columns, channels) or (layers, rows, columns, channels)
        The largest first, each half the size of the one before, rounded down but at least 1. With layers it
        is an array texture, also where there is only one layer. 1 to 4 channels of

        - uint8: ``R8``, ``R8G8`` or ``R8G8B8A8``, UNORM or, where ``srgb``, SRGB;
        - uint16: the same with 16 bits, UNORM: exact, but many devices cannot filter it (WebGL 2 has it as
          an extension, core Vulkan makes filtering optional); give float32 where it must load everywhere;
        - float32 or float16: half float, SFLOAT; float32 is rounded to the nearest half.
    srgb : bool
        The numbers are sRGB-encoded light, to be decoded before they are filtered. 16-bit formats have no
        decoding variant, so there the file only says so.

    Raises
    ------
    TilewrightValueError
        Another suffix, no levels, levels that do not halve, floats with ``srgb``, numbers beyond half float.
    TilewrightTypeError
        Pixels of another type.
    TilewrightFileError
        The file cannot be written.

    Notes
    -----
    Three channels become four, as GPUs do not load three; so do one or two channels of sRGB light (gray is
    repeated, a second channel is alpha), as no browser and few drivers offer them. Added alpha is 1. Rows go
    from the top down (``KTXorientation`` "rd"), without padding. There is no supercompression: Zstandard is
    not in Python's library, and three.js does not read zlib.
    """
    path = as_path(path)
    if path.suffix.lower() != ".ktx2":
        raise TilewrightValueError(
            f"{path} ends in {path.suffix or 'nothing'!r}; a KTX 2.0 file ends in .ktx2", value=path
        )
    levels = _check_levels(levels, srgb)
    layout = _choose_layout(levels[0], srgb)
    with whole_file(path) as unfinished, open(unfinished, "wb") as file:
        _write(file, levels, layout)


def gpu_bytes(levels: Sequence[NDArray[Any]], format: str) -> int:
    """Bytes that the levels of a texture or texture array take in a GPU format.

    Parameters
    ----------
    levels : sequence of array, shape (rows, columns, channels) or (layers, rows, columns, channels)
        Only the shapes matter.
    format : str
        One of `GPU_FORMATS`. Compressed formats hold whole blocks, also where a level is smaller than one.
    """
    across, down, size = _BLOCKS[check_choice("format", format, GPU_FORMATS)]
    return sum(
        math.prod(level.shape[:-3]) * -(-level.shape[-3] // down) * -(-level.shape[-2] // across) * size
        for level in levels
    )


def _check_levels(levels: Sequence[NDArray[Any]], srgb: bool) -> list[NDArray[Any]]:
    """The levels, checked; floats as half floats."""
    levels = list(levels)
    if not levels:
        raise TilewrightValueError("is empty; the picture itself is level 0", argument="levels")
    first = levels[0]
    if first.dtype not in (np.uint8, np.uint16, np.float32, np.float16):
        raise TilewrightTypeError(
            f"hold {first.dtype}; KTX 2.0 files are written from uint8, uint16, float32 or float16",
            argument="levels",
            value=first.dtype,
        )
    if first.ndim not in (3, 4) or not 1 <= first.shape[-1] <= 4 or 0 in first.shape:
        raise shape_error(
            "level 0",
            first.shape,
            "(rows, columns, channels) or (layers, rows, columns, channels) with 1 to 4 channels",
        )
    if srgb and first.dtype.kind == "f":
        raise TilewrightValueError(
            "is True but levels hold floats, which are linear", argument="srgb", advice="pass srgb=False"
        )
    for number, level in enumerate(levels):
        sides = (max(1, side >> number) for side in first.shape[-3:-1])
        expected = (*first.shape[:-3], *sides, first.shape[-1])
        if level.shape != expected or level.dtype != first.dtype:
            raise TilewrightValueError(
                f"is {level.dtype} {level.shape}; expected {first.dtype} {expected}, half of the level "
                "before",
                argument=f"level {number}",
                allowed=f"{first.dtype} {expected}, half of the level before",
            )
    most = max(first.shape[-3:-1]).bit_length()
    if len(levels) > most:
        raise TilewrightValueError(
            f"are {len(levels)}; a texture of this size has at most {most}",
            argument="levels",
            value=len(levels),
        )
    return levels if first.dtype.kind == "u" else [_to_half(level) for level in levels]


def _to_half(level: NDArray[Any]) -> NDArray[np.float16]:
    # Written so that NaN fails too.
    if not (np.abs(level) <= _HALF_LARGEST).all():
        worst = level.flat[np.argmax(~(np.abs(level) <= _HALF_LARGEST))]
        raise TilewrightValueError(
            f"hold {worst}; half floats are finite and end at {_HALF_LARGEST:g}",
            argument="levels",
            value=worst,
            advice="scale or mend the map",
        )
    return level.astype(np.float16)


def _choose_layout(level: NDArray[Any], srgb: bool) -> _Layout:
    given = level.shape[-1]
    few = given < 3 and not srgb
    return _Layout(level.dtype.newbyteorder("<"), given if few else 4, srgb)


def _write(file: BinaryIO, levels: list[NDArray[Any]], layout: _Layout) -> None:
    """The file in its order: header, index of levels, descriptor, keys, levels from the smallest on."""
    descriptor = _describe(layout)
    values = _key_values()
    start = _HEADER.size + _LEVEL.size * len(levels)
    places = _place(levels, layout, start + len(descriptor) + len(values))
    rows, columns = levels[0].shape[-3:-1]
    file.write(
        _HEADER.pack(
            _IDENTIFIER,
            layout.vk_format,
            layout.kind.itemsize,
            columns,
            rows,
            0,  # depth
            levels[0].shape[0] if levels[0].ndim == 4 else 0,
            1,  # faces
            len(levels),
            0,  # supercompression
            *(start, len(descriptor)),
            *(start + len(descriptor), len(values)),
            *(0, 0),  # global data of supercompression
        )
    )
    for offset, length in places:
        file.write(_LEVEL.pack(offset, length, length))
    file.write(descriptor + values)
    for level, (offset, _) in reversed(list(zip(levels, places, strict=True))):
        file.write(bytes(offset - file.tell()))
        for layer in level if level.ndim == 4 else [level]:
            file.write(_texels(layer, layout).data)


def _place(levels: list[NDArray[Any]], layout: _Layout, start: int) -> list[tuple[int, int]]:
    """Where each level begins and how many bytes it has: the smallest comes first."""

    def places() -> Iterator[tuple[int, int]]:
        end, step = start, math.lcm(layout.texel, 4)
        for level in reversed(levels):
            offset = -(-end // step) * step
            length = math.prod(level.shape[:-1]) * layout.texel
            end = offset + length
            yield offset, length

    return list(places())[::-1]


def _texels(layer: NDArray[Any], layout: _Layout) -> NDArray[Any]:
    """A layer as it lies in the file."""
    if layer.shape[-1] != layout.channels:
        return as_rgba(layer, layout.kind)
    texels = np.empty(layer.shape, layout.kind)
    texels[...] = layer
    return texels


def _describe(layout: _Layout) -> bytes:
    """The data format descriptor: one basic block that says where the bits of each channel lie."""
    bits = 8 * layout.kind.itemsize
    if layout.kind.kind == "f":
        qualifiers, low, high = _SIGNED_FLOAT, *struct.unpack("<2I", struct.pack("<2f", -1, 1))
    else:
        qualifiers, low, high = 0, 0, white(layout.kind)
    samples = b""
    for number in range(layout.channels):
        channel = _CHANNELS[number] | qualifiers
        if layout.srgb and number == 3:
            channel |= _LINEAR_ALPHA
        samples += struct.pack("<H2BIII", number * bits, bits - 1, channel, 0, low, high)
    size = 24 + len(samples)
    primaries, transfer = (1, 2) if layout.srgb else (0, 1)  # BT.709, sRGB; unspecified, linear
    block = struct.pack("<I2H", 0, 2, size)  # Khronos, basic format; version 1.3 and later
    block += struct.pack("<4B4B8B", 1, primaries, transfer, 0, 0, 0, 0, 0, layout.texel, *bytes(7))
    return struct.pack("<I", 4 + size) + block + samples


def _key_values() -> bytes:
    """Keys in the order of their letters; each pair is padded to four bytes."""
    text = b""
    for key, value in (("KTXorientation", "rd"), ("KTXwriter", f"tilewright {__version__}")):
        pair = f"{key}\0{value}\0".encode()
        text += struct.pack("<I", len(pair)) + pair + bytes(-len(pair) % 4)
    return text
