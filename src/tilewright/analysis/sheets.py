"""Sheets of pictures on which results are judged by eye."""

from pathlib import Path

from tilewright.checks import check_choice
from tilewright.files.atomic import AnyPath, as_path, check_file


def check_sheet(path: AnyPath) -> Path:
    """Where a sheet can be written; an error where not, before the work is done."""
    path = as_path(path)
    check_choice("the sheet's suffix", path.suffix.lower(), (".png", ".jpg", ".jpeg", ".svg", ".pdf"))
    check_file(path)
    return path
