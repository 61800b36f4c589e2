"""Points of surfaces in files that other programs read: NPY, PLY, CSV, Parquet and USD as text."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tilewright import __version__
from tilewright.errors import TilewrightFileError, TilewrightTypeError
from tilewright.extras import need_package
from tilewright.files.atomic import AnyPath, as_path, check_file, whole_file
from tilewright.files.texts import write_text

Columns = dict[str, NDArray[Any]]
_PLY_NAMES = {"f8": "double", "f4": "float", "i4": "int", "u1": "uchar"}


class _Noted(Protocol):
    """Points with columns and a note, such as `SurfacePoints`."""

    def columns(self) -> Columns: ...

    def note(self) -> dict[str, Any]: ...


def write_surface_points(path: AnyPath, points: _Noted) -> None:
    """Write points of a surface to a file, with who they are and how they were made where it has room.

    Parameters
    ----------
    path : str or path-like
        ``.npy``: positions, float64, shape (n, 3), and nothing else. ``.csv``: all columns, named in its
        first line. ``.ply``: binary vertices with all columns, and a comment. ``.parquet``: all columns, and
        metadata, by the package pyarrow of the extra ``points``. ``.usda``: a ``Points`` prim with normals,
        ids, and widths of the least distance where one is promised, at which equal disks touch.
    points : SurfacePoints
        What to write.

    Raises
    ------
    TilewrightTypeError
        Something else than points of a surface.
    TilewrightFileError
        A name of another kind; a file that cannot be written.
    MissingExtra
        Parquet without the package pyarrow.

    Examples
    --------
    >>> import tempfile
    >>> import numpy as np
    >>> import tilewright as tw
    >>> square = tw.Mesh.of([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
    >>> points = tw.surface_points(square, 50, kind="tiles")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.write_surface_points(f"{folder}/points.npy", points)
    ...     np.load(f"{folder}/points.npy").shape
    (50, 3)
    """
    target = check_surface_file(path)
    if not (hasattr(points, "columns") and hasattr(points, "note")):
        raise TilewrightTypeError(
            f"must be points of a surface, not {type(points).__name__}",
            argument="points",
            value=points,
            allowed="SurfacePoints",
        )
    note = {**points.note(), "program": f"tilewright {__version__}"}
    with whole_file(target) as unfinished:
        _WRITERS[target.suffix.lower()](unfinished, points.columns(), note)


def check_surface_file(path: AnyPath) -> Path:
    """A path `write_surface_points` can write to, told before long work."""
    target = as_path(path)
    suffix = target.suffix.lower()
    if suffix not in _WRITERS:
        raise TilewrightFileError(
            f"{target} is not the name of a file for points of surfaces",
            value=target,
            advice=f"use {', '.join(_WRITERS)}",
        )
    if suffix == ".parquet":
        need_package("pyarrow", "a .parquet file")
    check_file(target)
    return target


def _stack(columns: Columns, names: str) -> NDArray[np.float64]:
    return np.stack([columns[name] for name in names.split()], axis=1)


def _write_npy(path: Path, columns: Columns, note: dict[str, Any]) -> None:
    with path.open("wb") as stream:
        np.save(stream, _stack(columns, "x y z"))


def _write_csv(path: Path, columns: Columns, note: dict[str, Any]) -> None:
    words = [[_spell(value) for value in values.tolist()] for values in columns.values()]
    rows = [",".join(row) for row in zip(*words, strict=True)]
    write_text(path, "\n".join([",".join(columns), *rows, ""]))


def _spell(value: Any) -> str:
    """The shortest text that reads back as the same number."""
    return str(int(value)) if isinstance(value, bool) else repr(value)


def _write_ply(path: Path, columns: Columns, note: dict[str, Any]) -> None:
    kinds = {name: _ply_kind(values.dtype) for name, values in columns.items()}
    table = np.empty(len(columns["x"]), [(name, f"<{kind}") for name, kind in kinds.items()])
    for name, values in columns.items():
        table[name] = values
    lines = ["ply", "format binary_little_endian 1.0", f"comment points of a surface {json.dumps(note)}"]
    lines += [f"element vertex {len(table)}"]
    lines += [f"property {_PLY_NAMES[kind]} {name}" for name, kind in kinds.items()]
    with path.open("wb") as stream:
        stream.write("\n".join([*lines, "end_header", ""]).encode())
        stream.write(table.tobytes())


def _ply_kind(kind: np.dtype[Any]) -> str:
    """PLY has whole numbers of up to 32 bits."""
    return {"f": f"f{kind.itemsize}", "b": "u1"}.get(kind.kind, "i4")


def _write_parquet(path: Path, columns: Columns, note: dict[str, Any]) -> None:
    import pyarrow
    import pyarrow.parquet

    table = pyarrow.table({name: np.ascontiguousarray(values) for name, values in columns.items()})
    said = {"points of a surface": json.dumps(note)}
    pyarrow.parquet.write_table(table.replace_schema_metadata(said), path)


def _write_usda(path: Path, columns: Columns, note: dict[str, Any]) -> None:
    places, normals = _stack(columns, "x y z"), _stack(columns, "nx ny nz")
    lines = ["#usda 1.0", "(", f"    doc = {_quote(json.dumps(note))}", '    defaultPrim = "points"', ")", ""]
    lines += ['def Points "points"', "{", f"    point3f[] points = [{_tuples(places)}]"]
    lines += [f"    normal3f[] normals = [{_tuples(normals)}] (", '        interpolation = "vertex"', "    )"]
    if note["distance"] > 0:
        lines += [
            f"    float[] widths = [{note['distance']:.9g}] (",
            '        interpolation = "constant"',
            "    )",
        ]
    lines += [f"    int64[] ids = [{', '.join(map(str, range(len(places))))}]", "}", ""]
    write_text(path, "\n".join(lines))


def _quote(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _tuples(rows: NDArray[np.float64]) -> str:
    """Rows as USD writes them, to the nine digits that its floats hold."""
    return ", ".join(f"({x:.9g}, {y:.9g}, {z:.9g})" for x, y, z in rows.tolist())


_WRITERS: dict[str, Callable[[Path, Columns, dict[str, Any]], None]] = {
    ".npy": _write_npy,
    ".csv": _write_csv,
    ".ply": _write_ply,
    ".parquet": _write_parquet,
    ".usda": _write_usda,
}
