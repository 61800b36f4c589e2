"""Point sets in files that other programs read: NPY, CSV, Parquet and PLY."""

import json
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightError, TilewrightFileError, TilewrightTypeError, TilewrightValueError
from tilewright.files.atomic import AnyPath, as_path, check_file, whole_file
from tilewright.samplers.box import Box, as_points
from tilewright.samplers.feasibility import check_box
from tilewright.samplers.point_set import PointSet

if TYPE_CHECKING:
    import pyarrow

Blocks = Iterable[NDArray[np.float64]]

_NOTE = b"tilewright"
"""Key of the Parquet metadata that says which box the points lie in."""


def write_points(path: AnyPath, points: PointSet | ArrayLike | Blocks, count: int | None = None) -> None:
    """Write points to a file, a block at a time where they come so.

    The file appears when it is complete.

    Parameters
    ----------
    path : str or path-like
        ``.npy``: float64, shape (n, 2). ``.csv``: columns x, y under a header. ``.parquet``: columns x, y,
        and the box of a PointSet. ``.ply``: binary vertices, z = 0.
    points : PointSet, array-like of shape (n, 2), or iterable of such arrays
        The points, x first; an iterable gives them block by block.
    count : int, optional
        How many points an iterable gives, 0 to 2^40, which ``.npy`` and ``.ply`` need to say before the
        first; not needed otherwise.

    Raises
    ------
    TilewrightTypeError
        Something else than points, or an iterable without its ``count`` where it is needed.
    TilewrightFileError
        A name of another kind; a file that cannot be written.
    TilewrightValueError
        Points that are not finite pairs of numbers, or another number of them than ``count``.
    """
    target = check_point_file(path)
    box, blocks, number = None, points, count
    if isinstance(points, PointSet):
        box, blocks, number = points.box, [as_points(points.points)], len(points)
    elif isinstance(points, np.ndarray) or _is_table(points):
        table = as_points(points)  # type: ignore[arg-type]
        blocks, number = [table], len(table)
    elif not isinstance(points, Iterable):
        raise TilewrightTypeError(
            f"must be a PointSet or points, not {type(points).__name__}",
            argument="points",
            value=points,
            allowed="a PointSet or points",
        )
    elif count is not None:
        number = check_int("count", count, 0, 2**40)
    elif target.suffix.lower() in (".npy", ".ply"):
        raise TilewrightTypeError(
            f"is needed: {target.suffix} says how many points come before the first", argument="count"
        )
    with whole_file(target) as unfinished:
        written = _Counted(blocks)  # type: ignore[arg-type]
        _WRITERS[target.suffix.lower()](unfinished, written, number or 0, box)
        if number is not None and written.rows != number:
            raise TilewrightValueError(
                f"is {number} and {written.rows} points came", argument="count", value=number
            )


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
    if target.suffix.lower() not in _WRITERS:
        raise TilewrightFileError(
            f"{target} is not the name of a point file", value=target, advice=f"use {', '.join(_WRITERS)}"
        )
    check_file(target)
    return target


def read_points(path: AnyPath, box: Box | None = None) -> PointSet:
    """Read points from a file: its first two columns, or those called x and y.

    Parameters
    ----------
    path : str or path-like
        ``.npy``, ``.npz`` (an array called points, or the only one), ``.csv``, ``.txt`` or ``.parquet``.
    box : Box, optional
        Where the points lie. By default the one that a Parquet file names, else the smallest plain box around
        them, half a mean spacing wider on every side, to whose corner they are moved.

    Returns
    -------
    PointSet
        The points in their box; its method is the name of the file without suffix.

    Raises
    ------
    TilewrightTypeError
        Something else than a path, or a box that is no `Box`.
    TilewrightFileError
        No such file, one of another kind, damaged, with fewer than two columns, text, or NaN.

    Examples
    --------
    >>> import tempfile
    >>> import tilewright as tw
    >>> points = tw.sample_points("dart", 100, seed=1)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.write_points(f"{folder}/dart.parquet", points)
    ...     print(len(tw.read_points(f"{folder}/dart.parquet")))
    100
    """
    if box is not None:
        check_box(box)
    source = as_path(path)
    if source.suffix.lower() not in _READERS:
        raise TilewrightFileError(
            f"{source} is not a point file; {', '.join(_READERS)} can be read", value=source
        )
    if not source.is_file():
        raise TilewrightFileError(f"{source} is not a file", value=source)
    try:
        table, noted = _READERS[source.suffix.lower()](source)
        points = as_points(_two_columns(table))
        if not len(points):
            raise TilewrightFileError("no points")
        if box is None and noted is None:
            points, box = _put_in_box(points)
        found = box or noted or Box()
        return PointSet(found.check_points(points), found, source.stem)
    except TilewrightError as error:
        raise TilewrightFileError(f"{source}: {error}", value=source) from None
    except OSError as error:
        raise TilewrightFileError(
            f"{source} cannot be read: {(error.strerror or str(error)).lower()}", value=source
        ) from None
    except Exception as error:  # of parsers of three libraries
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise TilewrightFileError(
            f"{source} is damaged or not what its name says: {reason}", value=source
        ) from None


def _write_npy(path: Path, blocks: Blocks, count: int, box: Box | None) -> None:
    with path.open("wb") as stream:
        header = {"descr": "<f8", "fortran_order": False, "shape": (count, 2)}
        np.lib.format.write_array_header_1_0(stream, header)
        for block in blocks:
            stream.write(np.ascontiguousarray(block, "<f8").data)


def _write_ply(path: Path, blocks: Blocks, count: int, box: Box | None) -> None:
    kind = np.dtype([("x", "<f8"), ("y", "<f8"), ("z", "<f8")])
    with path.open("wb") as stream:
        lines = ["ply", "format binary_little_endian 1.0", f"element vertex {count}"]
        lines += [f"property double {axis}" for axis in "xyz"]
        stream.write("\n".join([*lines, "end_header", ""]).encode())
        for block in blocks:
            vertices = np.zeros(len(block), kind)
            vertices["x"], vertices["y"] = block.T
            stream.write(vertices.tobytes())


def _write_csv(path: Path, blocks: Blocks, count: int, box: Box | None) -> None:
    import pyarrow.csv

    plain = pyarrow.csv.WriteOptions(quoting_style="none")
    with pyarrow.csv.CSVWriter(path, _schema(None), write_options=plain) as writer:
        for block in blocks:
            writer.write(_table(block))


def _write_parquet(path: Path, blocks: Blocks, count: int, box: Box | None) -> None:
    import pyarrow.parquet

    with pyarrow.parquet.ParquetWriter(path, _schema(box)) as writer:
        for block in blocks:
            writer.write_table(_table(block).cast(_schema(box)))


def _schema(box: Box | None) -> "pyarrow.Schema":
    import pyarrow

    note = {} if box is None else {_NOTE: json.dumps({"extent": box.extent, "torus": box.torus})}
    return pyarrow.schema([("x", pyarrow.float64()), ("y", pyarrow.float64())], note)


def _table(block: NDArray[np.float64]) -> "pyarrow.Table":
    import pyarrow

    x, y = np.ascontiguousarray(block.T)
    return pyarrow.table({"x": x, "y": y})


_WRITERS: dict[str, Callable[[Path, Blocks, int, Box | None], None]] = {
    ".npy": _write_npy,
    ".csv": _write_csv,
    ".parquet": _write_parquet,
    ".ply": _write_ply,
}


def _read_npy(path: Path) -> tuple[Any, None]:
    return np.load(path, allow_pickle=False), None


def _read_npz(path: Path) -> tuple[Any, None]:
    with np.load(path, allow_pickle=False) as stored:
        names = list(stored)
        if "points" not in names and len(names) != 1:
            raise TilewrightValueError(
                f"holds {', '.join(names) or 'nothing'}; expected an array called points"
            )
        return stored["points" if "points" in names else names[0]], None


def _read_csv(path: Path) -> tuple[Any, None]:
    import pyarrow.csv

    with path.open("rb") as stream:
        first = stream.readline(4096).decode("utf-8", "replace").strip()
    delimiter = next((d for d in ",;\t" if d in first), " ")
    words = first.lower().replace("e", "").replace("nan", "").replace("inf", "")
    has_header = any(c.isalpha() for c in words)
    if delimiter == " " or first.startswith("#"):
        skipped = int(has_header and not first.startswith("#"))
        return np.loadtxt(path, delimiter=delimiter.strip() or None, skiprows=skipped, ndmin=2), None
    table = pyarrow.csv.read_csv(
        path,
        read_options=pyarrow.csv.ReadOptions(autogenerate_column_names=not has_header),
        parse_options=pyarrow.csv.ParseOptions(delimiter=delimiter),
    )
    return {name: table.column(name).to_numpy() for name in table.column_names}, None


def _read_parquet(path: Path) -> tuple[Any, Box | None]:
    import pyarrow.parquet

    table = pyarrow.parquet.read_table(path)
    note = (table.schema.metadata or {}).get(_NOTE)
    box = None
    if note is not None:
        known = json.loads(note)
        box = Box(tuple(known["extent"]), known["torus"])
    return {name: table.column(name).to_numpy() for name in table.column_names}, box


_READERS: dict[str, Callable[[Path], tuple[Any, Box | None]]] = {
    ".npy": _read_npy,
    ".npz": _read_npz,
    ".csv": _read_csv,
    ".txt": _read_csv,
    ".parquet": _read_parquet,
}


def _two_columns(table: Any) -> NDArray[Any]:
    """x and y of a table with named columns, or of an array."""
    if isinstance(table, dict):
        names = ["x", "y"] if {"x", "y"} <= set(table) else list(table)[:2]
        if len(names) < 2:
            raise TilewrightValueError(f"has one column, {', '.join(table)}; points need x and y")
        if not len(table[names[0]]):
            raise TilewrightValueError("no points")
        for name in names:
            if table[name].dtype.kind not in "iuf":
                raise TilewrightValueError(f"column {name} holds {table[name].dtype}, not numbers")
        return np.stack([table[name] for name in names], axis=1)
    if table.ndim == 2 and table.shape[1] == 1:
        raise TilewrightValueError("has one column; points need x and y")
    if table.dtype.kind not in "iuf" or table.ndim != 2 or table.shape[1] < 2:
        raise TilewrightValueError(f"holds {table.dtype} {table.shape}; points are numbers, shape (n, 2)")
    two: NDArray[Any] = table[:, :2]
    return two


def _put_in_box(points: NDArray[np.float64]) -> tuple[NDArray[np.float64], Box]:
    low, high = points.min(axis=0), points.max(axis=0)
    size = high - low
    if not (size > 0).all():
        raise TilewrightValueError(
            "all points lie on a line along an axis", advice="give the box they are meant to fill"
        )
    margin = 0.5 * np.sqrt(size.prod() / len(points))
    box = Box(tuple((size + 2 * margin).tolist()), torus=False)
    return points - low + margin, box
