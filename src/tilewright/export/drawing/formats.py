"""Drawings as files: SVG as it is drawn, or PDF and DXF made from it."""

from collections.abc import Sequence
from pathlib import Path

from tilewright.checks import check_type, type_error
from tilewright.errors import TilewrightValueError
from tilewright.export.drawing.svg import save_svg
from tilewright.files.atomic import AnyPath, as_path, whole_file
from tilewright.files.texts import write_text

SUFFIXES = (".svg", ".pdf", ".dxf")
_WHAT = "the text of an SVG file, or for a .pdf a list of such"


def save_drawing(path: AnyPath, drawing: str | Sequence[str]) -> Path:
    """Write a drawing as SVG, PDF or DXF, by the file's ending, whole or not at all.

    Parameters
    ----------
    path : str or path-like
        ``FILE.svg``; ``FILE.pdf``, with the layers of the drawing; or ``FILE.dxf`` (R12, in millimeters),
        with outlines only, on layers of the drawing or of its colors.
    drawing : str or sequence of str
        The text that `draw_tiling`, `draw_wall` and the like give; for a PDF it may be several, its pages.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    TilewrightTypeError
        The drawing is not a text.
    TilewrightValueError
        The file has another ending, or the drawing cannot be written so.
    TilewrightFileError
        It cannot be written.

    Notes
    -----
    Drawings that are not in millimeters are as large as browsers show them, 96 pixels to the inch. Circles
    and arcs are exact in a DXF, and within 5 millionths of their radius in a PDF.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> import tilewright as tw
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     drawing = tw.draw_cells([[0, 1], [1, 0]], motif="arcs")
    ...     file = tw.save_drawing(Path(folder) / "arcs.dxf", drawing)
    ...     file.read_text().split()[:4]
    ['0', 'SECTION', '2', 'HEADER']
    """
    target = as_path(path)
    suffix = target.suffix.lower()
    if suffix not in SUFFIXES:
        allowed = ", ".join(SUFFIXES)
        raise TilewrightValueError(
            f"{target} ends in {target.suffix or 'nothing'!r}; allowed are {allowed}",
            value=target,
            allowed=allowed,
        )
    pages = _pages(drawing)
    if suffix != ".pdf" and len(pages) > 1:
        raise TilewrightValueError(
            f"are {len(pages)}; only a .pdf has pages, a {suffix} holds one drawing",
            argument="drawing",
            value=len(pages),
        )
    if suffix == ".svg":
        return save_svg(target, pages[0])
    from tilewright.export.drawing.dxf import dxf_of
    from tilewright.export.drawing.pdf import pdf_of
    from tilewright.export.drawing.shapes import read_drawing

    shapes = [read_drawing(page) for page in pages]
    with whole_file(target) as unfinished:
        if suffix == ".pdf":
            unfinished.write_bytes(pdf_of(shapes))
        else:
            write_text(unfinished, dxf_of(shapes[0]))
    return target


def _pages(drawing: str | Sequence[str]) -> list[str]:
    if isinstance(drawing, str):
        return [drawing]
    if not isinstance(drawing, (list, tuple)) or not drawing:
        raise type_error("drawing", drawing, _WHAT)
    return [check_type("drawing", page, str, _WHAT) for page in drawing]
