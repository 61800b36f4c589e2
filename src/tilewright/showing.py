"""How things say what they are: in one line of text, with a small picture, and on disk.

Pictures are painted and folders written by rooms far above the things themselves. So nothing here knows them:
the package sets `painter`, `saver` and `loader` when it is imported; each loads its room when first called.
"""

import io
import os
import sys
from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import Any, Self

from tilewright.errors import TilewrightFileError, TilewrightValueError

painter: Callable[[Any], bytes | None] | None = None
"""Gives the PNG of a thing, or None where there is nothing to see."""
saver: Callable[[Any, Any], None] | None = None
"""Writes a thing to a folder; set whenever the package is imported."""
loader: Callable[[Any], Any] | None = None
"""Reads the thing that a folder holds; set whenever the package is imported."""


class Shown:
    """Something of which there is a picture."""

    def _repr_png_(self) -> bytes | None:
        return None if painter is None else painter(self)

    def show(self) -> None:
        """Show the picture of the thing: below the cell of a notebook, else by the system's viewer.

        Raises
        ------
        TilewrightValueError
            There is nothing to see, as of sets of more than 256 tiles and of volumes.
        """
        png = self._repr_png_()
        if png is None:
            raise TilewrightValueError("has no picture", argument=type(self).__name__)
        if _in_notebook():
            from IPython.display import Image as Cell, display

            display(Cell(data=png))
            return
        from PIL import Image

        Image.open(io.BytesIO(png)).show(title=repr(self))


def _in_notebook() -> bool:
    """Whether IPython shows what it is given below a cell."""
    ipython = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    return shell is not None and hasattr(shell, "kernel")


class Stored(Shown):
    """Something that a tile-set folder holds."""

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the thing to a folder, as `tilewright.save` does.

        Parameters
        ----------
        folder : str or path-like
            Where it is to be stored. A tile set of the same kind that is there is replaced.

        Raises
        ------
        TilewrightFileError
            The folder holds other things or cannot be written.
        """
        if saver is not None:
            saver(self, folder)

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> Self:
        """Read what `save` wrote.

        Parameters
        ----------
        folder : str or path-like
            A tile-set folder.

        Returns
        -------
        TextureTiles or PointTiles
            As the class is.

        Raises
        ------
        TilewrightFileError
            There is no such folder, it is damaged, or it holds another kind of tiles.
        """
        found = None if loader is None else loader(folder)
        if not isinstance(found, cls):
            raise TilewrightFileError(
                f"{folder} holds {type(found).__name__}; {cls.__name__} were asked for", value=folder
            )
        return found


def describe(thing: object, *words: str) -> str:
    """``<Kind: words, more words>``."""
    return f"<{type(thing).__name__}: {', '.join(words)}>"


def describe_record(record: Any) -> str:
    """The line of a dataclass: its numbers and short texts, and of arrays their type and shape."""
    return describe(record, *(f"{f.name} {_brief(getattr(record, f.name))}" for f in fields(record)))


def many(count: float, one: str, more: str = "") -> str:
    """``1 tile``, ``16 tiles``, ``1,048,576 points``; ``more``: the plural, if not made with an s."""
    number = f"{int(count):,}" if count == int(count) else f"{count:,}"
    return f"{number} {one if count == 1 else more or one + 's'}"


def _brief(value: Any) -> str:
    if hasattr(value, "dtype") and hasattr(value, "shape"):
        return f"{value:.6g}" if value.shape == () else f"{value.dtype} {value.shape}"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        return f"of {', '.join(map(str, value))}" if 0 < len(value) <= 6 else f"of {len(value)} names"
    if isinstance(value, (list, tuple)) and len(repr(value)) > 60:
        return f"({len(value)})"
    words = " ".join(repr(value).split())
    return words if len(words) <= 120 else f"{words[:117]}..."
