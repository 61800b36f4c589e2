"""Text as it is written: in UTF-8, its lines ended by a line feed alone, the same bytes on every system."""

from pathlib import Path


def write_text(path: Path, text: str) -> None:
    """Write a text file."""
    path.write_bytes(text.encode())
