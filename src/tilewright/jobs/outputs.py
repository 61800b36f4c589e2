"""Files of jobs: their names, what they hold by their suffix, and that none is lost."""

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from tilewright.errors import TilewrightValueError
from tilewright.files.atomic import check_file

Maker = Callable[[], Any]
"""Makes what a file is to hold: the text of an SVG, the pixels of a picture, an array."""

DRAWINGS = (".svg", ".pdf", ".dxf")
"""Suffixes of drawings made of lines."""


def find_free(name: str) -> Path:
    """The first of ``wall.png``, ``wall-2.png``, ``wall-3.png`` and so on that is not there yet."""
    path, number = Path(name), 2
    while os.path.lexists(path):
        path = Path(name).with_stem(f"{Path(name).stem}-{number}")
        number += 1
    return path


def check_suffix(path: Path, allowed: Sequence[str]) -> str:
    """The suffix of ``path`` in lower case, if it is one of those allowed."""
    suffix = path.suffix.lower()
    if suffix not in allowed:
        names = ", ".join(allowed)
        raise TilewrightValueError(
            f"is {path}, which ends in {suffix or 'nothing'!r}; allowed are {names}",
            argument="output", value=path, allowed=names,
        )  # fmt: skip
    return suffix


def check_output(path: Path, allowed: Sequence[str]) -> str:
    """As `check_suffix`, and the file can be written; before the work begins."""
    suffix = check_suffix(path, allowed)
    check_file(path)
    return suffix


def save_by_suffix(path: Path, makers: Mapping[str, Maker]) -> None:
    """Write the one that the file's suffix asks for: a drawing, .png pixels or a .npy array.

    A .pdf or .dxf holds what is made for an .svg.
    """
    allowed = [name for maker in makers for name in (DRAWINGS if maker == ".svg" else (maker,))]
    suffix = check_suffix(path, allowed)
    made = makers[".svg" if suffix in DRAWINGS else suffix]()
    if suffix in DRAWINGS:
        from tilewright.export.drawing import save_drawing

        save_drawing(path, made)
    elif suffix == ".npy":
        save_array(path, made)
    else:
        from tilewright.files import write_image

        write_image(path, made)


def save_array(path: Path, array: Any) -> None:
    """Write an array as a .npy file."""
    import numpy as np

    from tilewright.files.atomic import whole_file

    with whole_file(path) as unfinished:
        np.save(unfinished, array)
