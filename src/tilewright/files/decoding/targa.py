"""What a TGA file states of its fourth byte.

Truevision TGA File Format Specification 2.0, fields 5.6 (image descriptor) and 24 (attributes type).
"""

from dataclasses import dataclass
from pathlib import Path

_HEADER = 18
_FOOTER = 26
_SIGNATURE = b"TRUEVISION-XFILE.\0"
_ATTRIBUTES_TYPE = 494
"""Where it lies in the extension area."""
_PREMULTIPLIED = 4


@dataclass(frozen=True)
class TargaAlpha:
    """Whether the last channel is alpha, and whether it is multiplied in."""

    there: bool = True
    associated: bool = False


def read_targa_alpha(path: Path) -> TargaAlpha:
    """What a TGA file says of alpha."""
    with path.open("rb") as file:
        header = file.read(_HEADER)
        if len(header) < _HEADER:
            return TargaAlpha()
        kind = _attributes_type(file.read())
    bits = header[17] & 0x0F
    # Types 0 to 2: none, or to be left alone; 3: alpha. Files of version 1 have no type.
    return TargaAlpha(bits > 0 and kind not in (0, 1, 2), kind == _PREMULTIPLIED)


def _attributes_type(rest: bytes) -> int | None:
    if not rest[-_FOOTER:].endswith(_SIGNATURE):
        return None
    start = int.from_bytes(rest[-_FOOTER : -_FOOTER + 4], "little")
    at = start - _HEADER + _ATTRIBUTES_TYPE
    return rest[at] if start and at < len(rest) else None
