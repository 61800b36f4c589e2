"""The few parts of SVG that drawings are made of."""

from collections.abc import Iterable
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from tilewright.checks import check_type
from tilewright.errors import TilewrightValueError
from tilewright.files.atomic import AnyPath, as_path, whole_file
from tilewright.files.texts import write_text


def element(tag: str, *content: str, **attributes: str | float) -> str:
    """One element; ``stroke_width=2`` becomes ``stroke-width="2"``, numbers keep four decimals."""
    written = "".join(
        f" {name.strip('_').replace('_', '-')}={quoteattr(_text(v))}" for name, v in attributes.items()
    )
    return f"<{tag}{written}>{''.join(content)}</{tag}>" if content else f"<{tag}{written}/>"


def text(words: str, **attributes: str | float) -> str:
    """A line of text at ``x``, ``y``."""
    return element("text", escape(words), **attributes)


def path_of(points: Iterable[tuple[float, float]], *, closed: bool = True) -> str:
    """The ``d`` of a path along straight lines."""
    way = "L".join(f"{_text(float(x))} {_text(float(y))}" for x, y in points)
    return f"M{way}{'Z' if closed else ''}"


def document(body: Iterable[str], width: float, height: float, *, unit: str = "", scale: float = 1) -> str:
    """A whole drawing of ``width`` by ``height`` user units, shown ``scale`` times as large, in ``unit``."""
    return (
        element(
            "svg",
            *body,
            xmlns="http://www.w3.org/2000/svg",
            viewBox=f"0 0 {_text(width)} {_text(height)}",
            width=f"{_text(width * scale)}{unit}",
            height=f"{_text(height * scale)}{unit}",
        )
        + "\n"
    )


def save_svg(path: AnyPath, drawing: str) -> Path:
    """Write a drawing to a file that ends in .svg, whole or not at all.

    Parameters
    ----------
    path : str or path-like
        The file.
    drawing : str
        The text that `draw_tiling`, `draw_wall` and the like give.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    TilewrightTypeError
        The drawing is not a text.
    TilewrightValueError
        The file has another ending.
    TilewrightFileError
        It cannot be written.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> import tilewright as tw
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = tw.save_svg(Path(folder) / "tiles.svg", tw.draw_tiles(tw.wang_tiles(2)))
    ...     file.name
    'tiles.svg'
    """
    target = as_path(path)
    check_type("drawing", drawing, str, "the text of an SVG file")
    if target.suffix.lower() != ".svg":
        raise TilewrightValueError(
            f"{target} ends in {target.suffix or 'nothing'!r}; expected .svg", value=target
        )
    with whole_file(target) as unfinished:
        write_text(unfinished, drawing)
    return target


def number(value: float) -> str:
    """A number with up to four decimals."""
    return np.format_float_positional(value, precision=4, trim="-")


def _text(value: str | float) -> str:
    return value if isinstance(value, str) else number(value)
