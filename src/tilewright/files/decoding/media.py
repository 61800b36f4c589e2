"""What headers of JPEG, DDS and AVIF files state that decoders do not pass on."""

import struct
from pathlib import Path

_STANDALONE = (0x01, *range(0xD0, 0xD8))
_START_OF_SCAN = 0xDA
_DDS_COMPRESSED = 0x4
"""Flag of a pixel format that is named by four letters."""


def mended_jpeg(path: Path) -> bytes | None:
    """A JPEG file without the bytes that belong to no header segment; None where there are none.

    ISO/IEC 10918-1, annex B.
    """
    data = path.read_bytes()
    kept = bytearray(data[:2])
    at = 2
    while at + 4 <= len(data):
        marker = data.find(b"\xff", at)
        if marker < 0 or marker + 4 > len(data):
            return None
        kind = data[marker + 1]
        if kind in (0x00, 0xFF):  # no marker, or a byte that fills up
            at = marker + 1
            continue
        end = marker + 2 + (0 if kind in _STANDALONE else int.from_bytes(data[marker + 2 : marker + 4]))
        kept += data[marker:end]
        if kind == _START_OF_SCAN:
            kept += data[end:]
            return bytes(kept) if len(kept) < len(data) else None
        at = end
    return None


def is_compressed_dds(path: Path) -> bool:
    """Whether the texels of a DDS file lie in blocks, or have a format of Direct3D 10 and later."""
    with path.open("rb") as file:
        header = file.read(84)
    return len(header) == 84 and bool(struct.unpack_from("<I", header, 80)[0] & _DDS_COMPRESSED)


def avif_code_points(path: Path) -> tuple[int, int] | None:
    """Primaries and transfer function of an AVIF file, as numbers of ITU-T H.273 (ISO/IEC 23000-22)."""
    with path.open("rb") as file:
        start = file.read(1 << 16)
    at = start.find(b"colrnclx")
    if at < 0 or at + 12 > len(start):
        return None
    primaries, transfer = struct.unpack_from(">HH", start, at + 8)
    return primaries, transfer
