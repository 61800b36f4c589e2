"""Point sets in files that other programs read: NPY, NPZ, CSV, TXT, PLY and Parquet."""

from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_flag, check_int, check_type
from tilewright.errors import TilewrightError, TilewrightFileError, TilewrightTypeError, TilewrightValueError
from tilewright.extras import need_package
from tilewright.files.atomic import AnyPath, as_path, check_file, whole_file
from tilewright.files.point_formats import (
    Blocks,
    Read,
    Write,
    read_npy,
    read_npz,
    read_parquet,
    read_ply,
    write_npy,
    write_npz,
    write_parquet,
    write_ply,
)
from tilewright.files.point_notes import PointNote
from tilewright.files.point_text import read_text, write_text
from tilewright.samplers.box import Box, as_points
from tilewright.samplers.feasibility import check_box
from tilewright.samplers.point_set import PointSet

ASSUMED = "assumed_box"
"""Among a set's figures: that its file names no box, and the one around the points was taken."""


def write_points(
    path: AnyPath,
    points: PointSet | ArrayLike | Blocks,
    count: int | None = None,
    *,
    about: PointSet | None = None,
    note: bool = False,
) -> None:
    """Write points to a file, a block at a time where they come so.

    The file appears when it is complete. What a PointSet knows besides (its box, method, promised distance
    and figures), and the program's version, goes with it where the format has room, and `read_points` gives
    it back. A ``corner`` among the figures says where the box begins in the file's coordinates.

    Parameters
    ----------
    path : str or path-like
        ``.npy``: float64, shape (n, 2), and nothing else. ``.npz``: the same as ``points``, beside arrays of
        what is known. ``.csv``: columns x, y under a header. ``.txt``: x and y with a blank between.
        ``.ply``: binary vertices, z = 0, and a comment. ``.parquet``: columns x, y, and metadata, by the
        package pyarrow.
    points : PointSet, array-like of shape (n, 2), or iterable of such arrays
        The points, x first; an iterable gives them block by block.
    count : int, optional
        How many points an iterable gives, 0 to 2^40, which ``.npy``, ``.npz`` and ``.ply`` need to say before
        the first; not needed otherwise.
    about : PointSet, optional
        What is known of points that are no PointSet; its own points do not count. Default nothing.
    note : bool, optional
        Begin ``.csv`` and ``.txt`` with a line ``# tilewright {...}`` that holds what is known. Default
        False: many programs take such a line for the header.

    Raises
    ------
    TilewrightTypeError
        Something else than points, or an iterable without its ``count`` where it is needed.
    TilewrightFileError
        A name of another kind; a file that cannot be written.
    TilewrightValueError
        Points that are not finite pairs of numbers, or another number of them than ``count``.
    MissingExtra
        Parquet without the package pyarrow.

    Examples
    --------
    >>> import tempfile
    >>> import tilewright as tw
    >>> points = tw.sample_points("dart", 100, seed=1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.write_points(f"{folder}/dart.ply", points)
    ...     tw.read_points(f"{folder}/dart.ply").box
    Box(extent=(1.0, 1.0), torus=True)
    """
    target = check_point_file(path)
    check_flag("note", note)
    if about is not None:
        check_type("about", about, PointSet, "a PointSet")
    blocks, number = _as_blocks(points, count, target.suffix.lower())
    known = about if about is not None else points if isinstance(points, PointSet) else None
    said = None if known is None else PointNote.of(known)
    with whole_file(target) as unfinished:
        written = _Counted(blocks)
        _writer(target, note)(unfinished, written, number or 0, said)
        if number is not None and written.rows != number:
            raise TilewrightValueError(
                f"is {number} and {written.rows} points came", argument="count", value=number
            )


def _as_blocks(points: Any, count: int | None, suffix: str) -> tuple[Blocks, int | None]:
    """Points in blocks, and how many there are, as far as that is known."""
    if isinstance(points, PointSet):
        return [as_points(points.points)], len(points)
    if isinstance(points, np.ndarray) or _is_table(points):
        table = as_points(points)
        return [table], len(table)
    if not isinstance(points, Iterable):
        raise TilewrightTypeError(
            f"must be a PointSet or points, not {type(points).__name__}",
            argument="points",
            value=points,
            allowed="a PointSet or points",
        )
    if count is not None:
        return points, check_int("count", count, 0, 2**40)
    if suffix in _COUNTED:
        raise TilewrightTypeError(
            f"is needed: {suffix} says how many points come before the first", argument="count"
        )
    return points, None


def _is_table(points: Any) -> bool:
    """Whether a list holds points, not blocks of them."""
    return isinstance(points, (list, tuple)) and not any(
        isinstance(p, np.ndarray) and p.ndim == 2 for p in points
    )


class _Counted:
    """Blocks of points, each checked, and how many points have come."""

    def __init__(self, blocks: Blocks) -> None:
        self.blocks = blocks
        self.rows = 0

    def __iter__(self) -> Iterator[NDArray[np.float64]]:
        for block in self.blocks:
            checked = as_points(block)
            self.rows += len(checked)
            yield checked


def check_point_file(path: AnyPath) -> Path:
    """A path `write_points` can write to, told before long work."""
    target = as_path(path)
    suffix = target.suffix.lower()
    if suffix not in _SUFFIXES:
        raise TilewrightFileError(
            f"{target} is not the name of a point file", value=target, advice=f"use {', '.join(_SUFFIXES)}"
        )
    _need_package_for(suffix)
    check_file(target)
    return target


def _need_package_for(suffix: str) -> None:
    if suffix == ".parquet":
        need_package("pyarrow", "a .parquet file")


def _write_columns(
    path: Path, blocks: Blocks, count: int, known: PointNote | None, *, note: bool, between: str, header: str
) -> None:
    write_text(path, blocks, between, header, known if note else None)


def _writer(path: Path, note: bool) -> Write:
    match path.suffix.lower():
        case ".csv":
            return partial(_write_columns, note=note, between=",", header='"x","y"\n')
        case ".txt":
            return partial(_write_columns, note=note, between=" ", header="")
        case suffix:
            return _WRITERS[suffix]


_WRITERS: dict[str, Write] = {
    ".npy": write_npy,
    ".npz": write_npz,
    ".ply": write_ply,
    ".parquet": write_parquet,
}
_COUNTED = (".npy", ".npz", ".ply")
_SUFFIXES = (".npy", ".npz", ".csv", ".txt", ".parquet", ".ply")
_READERS: dict[str, Read] = {
    ".npy": read_npy,
    ".npz": read_npz,
    ".csv": read_text,
    ".tsv": read_text,
    ".txt": read_text,
    ".xyz": read_text,
    ".parquet": read_parquet,
    ".ply": read_ply,
}


def read_points(path: AnyPath, box: Box | None = None) -> PointSet:
    """Read points from a file, with what it says of them.

    Of named columns those called x and y are taken, whatever their case, else longitude and latitude,
    easting and northing or the like, else the first two that hold numbers and are no index, with a
    warning. Points of space lose their height, with a warning. Without names the first two are taken,
    after one that counts the rows. Texts may be separated by commas, semicolons, tabs, bars or blanks;
    fractions may begin with a comma where columns do not; lines that begin with ``#``, ``%`` or ``//``
    before the numbers are passed over.

    Parameters
    ----------
    path : str or path-like
        ``.npy``, ``.npz`` (an array called points, arrays x and y, or the only one), ``.csv``, ``.tsv``,
        ``.txt``, ``.xyz``, ``.ply`` or ``.parquet``, which needs the package pyarrow.
    box : Box, optional
        Where the points lie. By default the one that the file names, else the smallest plain box around
        them, half a mean spacing wider on every side, to whose corner they are moved.

    Returns
    -------
    PointSet
        The points in their box, with method, promised distance and figures where the file names them; else
        its method is the name of the file without suffix. The figures say ``"corner"`` where points were
        moved to the origin, and ``"assumed_box"`` where the box is the one around them.

    Raises
    ------
    TilewrightTypeError
        Something else than a path, or a box that is no `Box`.
    TilewrightFileError
        No such file, one of another kind, damaged, with fewer than two columns, text, or NaN.
    MissingExtra
        Parquet without the package pyarrow.

    Examples
    --------
    >>> import tempfile
    >>> import tilewright as tw
    >>> points = tw.sample_points("dart", 100, seed=1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.write_points(f"{folder}/dart.npz", points)
    ...     again = tw.read_points(f"{folder}/dart.npz")
    >>> again.method, again.distance == points.distance
    ('dart', True)
    """
    if box is not None:
        check_box(box)
    source = as_path(path)
    suffix = source.suffix.lower()
    if suffix not in _READERS:
        raise TilewrightFileError(
            f"{source} is not a point file; {', '.join(_READERS)} can be read", value=source
        )
    if not source.is_file():
        raise TilewrightFileError(f"{source} is not a file", value=source)
    _need_package_for(suffix)
    try:
        table, note = _READERS[suffix](source)
        points = as_points(table)
        if not len(points):
            raise TilewrightFileError("no points")
        return _place(points, note, box, source.stem)
    except TilewrightError as error:
        told = str(error).removeprefix(f"{source} ").removeprefix(f"{source}: ")
        raise TilewrightFileError(f"{source}: {told}", value=source) from None
    except OSError as error:
        raise TilewrightFileError(
            f"{source} cannot be read: {(error.strerror or str(error)).lower()}", value=source
        ) from None
    except Exception as error:  # of parsers of three libraries
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise TilewrightFileError(
            f"{source} is damaged or not what its name says: {reason}", value=source
        ) from None


def _place(points: NDArray[np.float64], note: PointNote | None, box: Box | None, name: str) -> PointSet:
    """The points in the box that is given, else in that of their file, else in one around them."""
    if note is not None:
        return note.place(points, box, name)
    if box is not None:
        return PointSet(box.check_points(points), box, name)
    moved, around, corner = _put_in_box(points)
    return PointSet(moved, around, name, figures={"corner": corner, ASSUMED: True})


def _put_in_box(points: NDArray[np.float64]) -> tuple[NDArray[np.float64], Box, tuple[float, ...]]:
    """Points moved to the corner of the box around them, that box, and where its corner was."""
    low, high = points.min(axis=0), points.max(axis=0)
    size = high - low
    if not (size > 0).all():
        raise TilewrightValueError(
            "all points lie on a line along an axis", advice="give the box they are meant to fill"
        )
    margin = 0.5 * np.sqrt(size.prod() / len(points))
    box = Box(tuple((size + 2 * margin).tolist()), torus=False)
    return points - low + margin, box, tuple((low - margin).tolist())
