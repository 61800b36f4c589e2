"""The chunks of a PNG file: whether all are there, and what they state of the colors.

Portable Network Graphics (PNG) Specification, Third Edition, section 5 and 11.3.
"""

import struct
import zlib
from dataclasses import dataclass, field
from pathlib import Path

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_KEPT = (b"cICP", b"iCCP", b"sRGB", b"gAMA", b"cHRM", b"acTL")
"""Chunks that say how the numbers are meant, and that there are several pictures."""
_LONGEST_PROFILE = 1 << 24
_DAMAGED = b"?"
"""Stands for a profile that cannot be unpacked."""


@dataclass(frozen=True)
class PngChunks:
    """What the chunks of a file say besides pixels.

    Attributes
    ----------
    fault : str
        What is wrong with them; empty where the file is whole, or no PNG file.
    kept : dict of bytes to bytes
        Those that say how the numbers are meant.
    """

    fault: str = ""
    kept: dict[bytes, bytes] = field(default_factory=dict)

    @property
    def code_points(self) -> tuple[int, int] | None:
        """Primaries and transfer function as numbers of ITU-T H.273."""
        stated = self.kept.get(b"cICP", b"")
        return (stated[0], stated[1]) if len(stated) == 4 else None

    @property
    def profile(self) -> bytes:
        """The ICC profile, as it is; empty where there is none."""
        _, _, stated = self.kept.get(b"iCCP", b"").partition(b"\0")
        try:
            return zlib.decompressobj().decompress(stated[1:], _LONGEST_PROFILE)
        except zlib.error:
            return _DAMAGED if stated else b""

    @property
    def gamma(self) -> float | None:
        """The exponent that made the numbers from light, 0.45455 for sRGB."""
        stated = self.kept.get(b"gAMA", b"")
        return int.from_bytes(stated) / 100_000 or None if len(stated) == 4 else None

    @property
    def chromaticities(self) -> tuple[float, ...] | None:
        """x and y of red, green, blue and white."""
        stated = self.kept.get(b"cHRM", b"")
        if len(stated) != 32:
            return None
        wx, wy, *primaries = (number / 100_000 for number in struct.unpack(">8I", stated))
        return *primaries, wx, wy

    @property
    def pictures(self) -> int:
        """How many pictures an animation has; 1 where the file is none."""
        stated = self.kept.get(b"acTL", b"")
        return max(1, int.from_bytes(stated[:4])) if stated else 1


def read_chunks(path: Path) -> PngChunks:
    """The chunks of a PNG file, checksums compared; nothing for another kind of file."""
    kept: dict[bytes, bytes] = {}
    with path.open("rb") as file:
        if file.read(len(_SIGNATURE)) != _SIGNATURE:
            return PngChunks()
        while len(head := file.read(8)) == 8:
            left, kind = int.from_bytes(head[:4]), head[4:]
            checksum = zlib.crc32(kind)
            first = True
            while left and (piece := file.read(min(left, 1 << 20))):
                if first and kind in _KEPT:
                    kept[kind] = piece
                first = False
                left -= len(piece)
                checksum = zlib.crc32(piece, checksum)
            given = file.read(4)
            if len(given) < 4:
                break
            # A chunk whose name starts with a small letter is not needed for the pixels.
            if int.from_bytes(given) != checksum and kind[:1].isupper():
                return PngChunks(f"the checksum of its chunk {kind.decode('latin-1')!r} is wrong", kept)
            if kind == b"IEND":
                return PngChunks("", kept)
        return PngChunks("it is truncated", kept)
