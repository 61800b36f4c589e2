"""What a mesh file holds, before it is checked."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError


@dataclass
class RawMesh:
    """Vertices and faces as a file gives them, and what it states besides.

    Attributes
    ----------
    vertices : float64 array, shape (V, 3)
        Places of the vertices.
    corners : int64 array, shape (H,)
        The vertices of all faces one after another, numbered from 0.
    starts : int64 array, shape (F + 1,)
        Where the corners of each face start and end.
    texcoords : float64 array, shape (H, 2), or None
        Texture coordinates of every corner.
    notes : list of str
        What the file states and is not heeded, each a part of a sentence.
    """

    vertices: NDArray[np.float64]
    corners: NDArray[np.int64]
    starts: NDArray[np.int64]
    texcoords: NDArray[np.float64] | None = None
    notes: list[str] = field(default_factory=list)


def starts_of(sizes: Iterable[int]) -> NDArray[np.int64]:
    """Where each of several runs of these lengths starts, and where the last ends."""
    return np.array(list(accumulate(sizes, initial=0)), np.int64)


def ends_early(what: str, count: int) -> TilewrightValueError:
    """The error of a file that says it holds more than it does."""
    return TilewrightValueError(f"ends before the last of {count} {what}")


def has_no_faces(vertices: int, readable: bool = False) -> TilewrightValueError:
    """The error of a file of points; ``readable`` says whether `read_points` reads such files."""
    advice = "read_points reads them" if readable else ""
    kind = "points" if readable else "vertices"
    return TilewrightValueError(f"holds {vertices} {kind} and no faces", advice=advice)
