"""Which columns of a table are x and y: by their names, else the first two that hold numbers."""

import re
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, TilewrightWarning, brief, brief_text

_PAIRS = (
    ("x", "y"),
    ("lon", "lat"), ("long", "lat"), ("lng", "lat"), ("longitude", "latitude"),
    ("easting", "northing"), ("east", "north"), ("e", "n"),
    ("xcoord", "ycoord"), ("coordx", "coordy"), ("xcoordinate", "ycoordinate"),
    ("pointx", "pointy"), ("posx", "posy"), ("positionx", "positiony"),
)  # fmt: skip
"""Names of x and y, the first that a table has."""
_NO_COORDINATES = {
    "", "id", "ids", "fid", "gid", "oid", "uid", "objectid", "pointid", "index", "idx", "no", "nr", "number",
    "row", "unnamed:0", "z", "name", "label", "rank", "time", "date", "weight",
}  # fmt: skip
"""Names of columns that hold something else."""


def plain_name(name: str) -> str:
    """A column's name without case, blanks, quotes, joints and a unit in brackets."""
    without_unit = re.sub(r"[\[(][^\])]*[\])]\s*$", "", name.strip().strip("\"'").lstrip("\ufeff"))
    return re.sub(r"[\s_.\-]", "", without_unit).casefold()


def choose_columns(names: Sequence[str], numeric: Sequence[bool]) -> tuple[int, int]:
    """Indices of x and y among named columns; ``numeric`` says which hold numbers."""
    plain = [plain_name(name) for name in names]
    for x, y in _PAIRS:
        if x in plain and y in plain:
            return plain.index(x), plain.index(y)
    if len(names) == 2:
        return 0, 1
    left = [k for k, name in enumerate(plain) if numeric[k] and name not in _NO_COORDINATES]
    if len(left) < 2:
        has = "one column" if len(names) == 1 else f"the columns {brief_text(', '.join(names))}"
        raise TilewrightValueError(f"has {has}; points need x and y")
    _note(f"no columns are called x and y; {names[left[0]]} and {names[left[1]]} were taken")
    return left[0], left[1]


def named_points(table: Mapping[str, NDArray[Any]]) -> NDArray[Any]:
    """x and y of a table with named columns."""
    names = list(table)
    numeric = [values.dtype.kind in "iuf" for values in table.values()]
    chosen = [names[k] for k in choose_columns(names, numeric)]
    for name in chosen:
        if table[name].dtype.kind not in "iuf":
            raise TilewrightValueError(f"column {name} holds {table[name].dtype}, not numbers")
    for name in set(names) - set(chosen):
        if plain_name(name) == "z" and _varies(table[name]):
            note_height(name)
    return np.stack([table[name] for name in chosen], axis=1)


def unnamed_points(table: NDArray[Any]) -> NDArray[Any]:
    """x and y of a table without names: its first two columns, after one that counts the rows."""
    if table.dtype.names is not None:
        return named_points({name: table[name] for name in table.dtype.names})
    if table.dtype.kind not in "iuf" or table.ndim != 2:
        raise TilewrightValueError(f"holds {table.dtype} {table.shape}; points are numbers, shape (n, 2)")
    rows, columns = table.shape
    if rows == 2 and columns > 3:
        _note(f"holds two rows of {columns} numbers; they were taken for x and y")
        return np.ascontiguousarray(table.T)
    if columns < 2:
        raise TilewrightValueError("has one column; points need x and y")
    first = 0
    if columns > 2 and rows > 2 and _counts(table[:, 0]):
        _note("the first of its columns counts the rows; the next two were taken")
        first = 1
    if columns == first + 3 and _varies(table[:, -1]):
        note_height("the third column")
    two: NDArray[Any] = table[:, first : first + 2]
    return two


def _varies(column: NDArray[Any]) -> bool:
    """Whether numbers are not all the same."""
    return column.dtype.kind in "iuf" and bool((column != column[:1]).any())


def _counts(column: NDArray[Any]) -> bool:
    """Whether a column is 0, 1, 2 ... or 1, 2, 3 ..."""
    return bool(column[0] in (0, 1) and (np.diff(column) == 1).all())


def note_height(name: str) -> None:
    """Say that points in space were taken for points of the plane."""
    _note(f"{name} was left out, since points lie in a plane here; x and y were taken")


def _note(text: str) -> None:
    warnings.warn(f"of the table of points: {text}", TilewrightWarning, stacklevel=5)


def not_a_number(word: str, row: int, column: str) -> TilewrightValueError:
    """The error of a cell that holds a text."""
    return TilewrightValueError(f"column {column} holds {brief(word)} in row {row}, not numbers")
