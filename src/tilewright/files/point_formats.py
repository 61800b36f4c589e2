"""Points in binary files: NPY, NPZ, PLY and Parquet, each written and read."""

import json
import zipfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.files.archives import list_briefly, read_archive
from tilewright.files.point_columns import named_points, unnamed_points
from tilewright.files.point_notes import MARK, PointNote

Blocks = Iterable[NDArray[np.float64]]
Found = tuple[NDArray[Any], PointNote | None]
"""The points of a file, and what it says of them."""

PLY_KINDS = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2",
    "ushort": "u2", "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
}  # fmt: skip
PLY_ORDERS = {"binary_little_endian": "<", "binary_big_endian": ">", "ascii": ""}
_LONGEST_HEADER = 2**16


def write_npy(path: Path, blocks: Blocks, count: int, note: PointNote | None) -> None:
    """An array, which has no room for a note."""
    with path.open("wb") as stream:
        _write_array(stream, blocks, count)


def _write_array(stream: IO[bytes], blocks: Blocks, count: int) -> None:
    header = {"descr": "<f8", "fortran_order": False, "shape": (count, 2)}
    np.lib.format.write_array_header_1_0(stream, header)  # type: ignore[arg-type]
    for block in blocks:
        stream.write(np.ascontiguousarray(block, "<f8").data)


def read_npy(path: Path) -> Found:
    """An array of points, or a table with columns x and y."""
    return unnamed_points(np.load(path, allow_pickle=False)), None


def write_npz(path: Path, blocks: Blocks, count: int, note: PointNote | None) -> None:
    """The array ``points``, and one for each part of the note; the figures as JSON."""
    parts = {} if note is None else note.fields()
    if note is not None:
        parts["figures"] = json.dumps(json.loads(note.text())["figures"])
    # Members of a fixed date, so that the same points give the same bytes.
    with zipfile.ZipFile(path, "w", allowZip64=True) as archive:
        with archive.open(zipfile.ZipInfo("points.npy"), "w", force_zip64=True) as member:
            _write_array(member, blocks, count)
        for name, value in parts.items():
            with archive.open(zipfile.ZipInfo(f"{name}.npy"), "w") as member:
                np.lib.format.write_array(member, np.asarray(value), allow_pickle=False)


def read_npz(path: Path) -> Found:
    """The array called points, arrays x and y, or the only array; and the note."""

    def choose(names: list[str]) -> list[str]:
        noted = [name for name in _NOTED if name in names] if {"extent", "torus"} <= set(names) else []
        if "points" in names:
            return ["points", *noted]
        if {"x", "y"} <= set(names):
            return ["x", "y"]
        if len(names) != 1:
            raise TilewrightValueError(f"holds {list_briefly(names)}; expected an array called points")
        return names

    found = read_archive(path, choose)
    note = _note_of({name: found.pop(name) for name in _NOTED if name in found and len(found) > 1})
    if {"x", "y"} <= set(found):
        return named_points({name: found[name].ravel() for name in ("x", "y")}), note
    return unnamed_points(next(iter(found.values()))), note


_NOTED = ("program", "extent", "torus", "corner", "method", "distance", "figures")


def _note_of(parts: dict[str, NDArray[Any]]) -> PointNote | None:
    if not parts:
        return None
    said = {name: value.tolist() for name, value in parts.items()}
    said["figures"] = json.loads(said.get("figures", "{}"))
    return PointNote.parse(json.dumps(said))


def write_ply(path: Path, blocks: Blocks, count: int, note: PointNote | None) -> None:
    """Binary vertices, z = 0; the note as a comment."""
    kind = np.dtype([("x", "<f8"), ("y", "<f8"), ("z", "<f8")])
    with path.open("wb") as stream:
        lines = ["ply", "format binary_little_endian 1.0"]
        lines += [] if note is None else [f"comment {MARK} {note.text()}"]
        lines += [f"element vertex {count}", *(f"property double {axis}" for axis in "xyz")]
        stream.write("\n".join([*lines, "end_header", ""]).encode())
        for block in blocks:
            vertices = np.zeros(len(block), kind)
            vertices["x"], vertices["y"] = block.T
            stream.write(vertices.tobytes())


def read_ply(path: Path) -> Found:
    """x and y of the vertices, which come first; ASCII, or binary of either order."""
    with path.open("rb") as stream:
        order, count, columns, note = _read_ply_header(stream)
        if order:
            kind = np.dtype([(name, order + code) for name, code in columns])
            data = stream.read(count * kind.itemsize)
            if len(data) < count * kind.itemsize:
                raise ValueError(f"it ends before the last of {count} vertices")
            vertices = np.frombuffer(data, kind)
            return named_points({name: vertices[name] for name, _ in columns}), note
        table = np.loadtxt(stream, max_rows=count, ndmin=2, encoding="latin-1") if count else np.empty((0, 3))
        if len(table) < count or table.shape[1] < len(columns):
            raise ValueError(f"it ends before the last of {count} vertices")
        return named_points({name: table[:, k] for k, (name, _) in enumerate(columns)}), note


def _read_ply_header(stream: IO[bytes]) -> tuple[str, int, list[tuple[str, str]], PointNote | None]:
    """Byte order, number of vertices, their columns and kinds, and the note."""
    head = stream.read(_LONGEST_HEADER)
    text, end, _ = head.partition(b"end_header")
    if not head.startswith(b"ply") or not end:
        raise ValueError("it does not begin as a PLY file does")
    stream.seek(head.index(b"\n", len(text)) + 1)
    order, count, columns, note, element = "", -1, [], None, ""
    for line in text.decode("latin-1").splitlines():
        match line.split():
            case ["format", kind, *_]:
                order = PLY_ORDERS[kind]
            case ["element", element, number]:
                if count < 0 and element != "vertex":
                    raise ValueError(f"its first element is {element}, not vertex")
                count = int(number) if count < 0 else count
            case ["property", kind, name] if element == "vertex":
                columns.append((name, PLY_KINDS[kind]))
            case ["property", "list", *_] if element == "vertex":
                raise ValueError("its vertices hold lists")
            case ["comment", word, *_] if word == MARK:
                note = PointNote.parse(line.partition(MARK)[2])
    if count < 0:
        raise ValueError("it has no vertices")
    return order, count, columns, note


def write_parquet(path: Path, blocks: Blocks, count: int, note: PointNote | None) -> None:
    """Columns x and y, the note in the metadata."""
    import pyarrow
    import pyarrow.parquet

    said = {} if note is None else {MARK.encode(): note.text()}
    schema = pyarrow.schema([("x", pyarrow.float64()), ("y", pyarrow.float64())], said)
    with pyarrow.parquet.ParquetWriter(path, schema) as writer:
        for block in blocks:
            x, y = np.ascontiguousarray(block.T)
            writer.write_table(pyarrow.table({"x": x, "y": y}).cast(schema))


def read_parquet(path: Path) -> Found:
    """x and y of a table, and the note of its metadata."""
    import pyarrow.parquet

    table: pyarrow.Table = pyarrow.parquet.read_table(path)
    said = (table.schema.metadata or {}).get(MARK.encode())
    columns = {name: table.column(name).to_numpy() for name in table.column_names}
    return named_points(columns), None if said is None else PointNote.parse(said)


Write = Callable[[Path, Blocks, int, PointNote | None], None]
Read = Callable[[Path], Found]
