"""Sheets of pictures, by which results are judged by eye."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tilewright.checks import check_choice
from tilewright.extras import need_package
from tilewright.files.atomic import AnyPath, as_path, check_file, whole_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_UNDATED = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
"""What matplotlib would write of the moment."""
_SALT: Any = {"svg.hashsalt": "tilewright"}
"""By default the identifiers in SVG are drawn by chance."""


def check_sheet(path: AnyPath) -> Path:
    """Where a sheet can be written; an error where not, before the work is done."""
    path = as_path(path)
    check_choice("the sheet's suffix", path.suffix.lower(), (".png", ".jpg", ".jpeg", ".svg", ".pdf"))
    need_plots()
    check_file(path)
    return path


def need_plots() -> None:
    """Refuse to begin where there is nothing to draw sheets with."""
    need_package("matplotlib", "a sheet of pictures")


def save_figure(path: AnyPath, make: Callable[[], "Figure"], dpi: int) -> None:
    """Write a figure; the same figure gives the same bytes."""
    target = check_sheet(path)
    import matplotlib

    with whole_file(target) as unfinished, matplotlib.rc_context(_SALT):
        suffix = target.suffix.lower()
        make().savefig(unfinished, dpi=dpi, format=suffix[1:], metadata=_UNDATED.get(suffix))
