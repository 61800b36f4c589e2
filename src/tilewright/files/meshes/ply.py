"""Polygon file format (Turk 1994): text or binary, faces as lists of vertex numbers."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.domains import Mesh
from tilewright.files.point_formats import PLY_KINDS, PLY_ORDERS

_LONGEST_HEADER = 2**16
_PAIRS = (("u", "v"), ("s", "t"), ("texture_u", "texture_v"))
_PLAIN = {"x", "y", "z", "nx", "ny", "nz", "vertex_indices", "vertex_index", "texcoord"} | {
    name for pair in _PAIRS for name in pair
}


@dataclass(frozen=True)
class _Property:
    name: str
    kind: str
    counted: str = ""
    """The type of its number of entries, of lists."""


@dataclass(frozen=True)
class _Element:
    name: str
    count: int
    properties: list[_Property]


def read_ply_mesh(path: Path) -> tuple[Mesh, list[str]]:
    """The mesh, and what was passed over."""
    data = path.read_bytes()
    order, elements, begin = _read_header(data)
    columns: dict[str, dict[str, Any]] = {}
    body = _Text(data[begin:]) if order == "" else _Binary(data, begin, order)
    for element in elements:
        columns[element.name] = body.read(element)
    vertices, faces = columns.get("vertex", {}), columns.get("face", {})
    if not {"x", "y", "z"} <= vertices.keys():
        raise ValueError("it holds no vertices with x, y and z")
    rows = faces.get("vertex_indices", faces.get("vertex_index"))
    if rows is None:
        raise ValueError("it holds points and no faces")
    sizes, corners = rows
    mesh = Mesh(
        np.stack([np.asarray(vertices[axis], np.float64) for axis in "xyz"], axis=1),
        corners.astype(np.int64),
        np.concatenate([[0], np.cumsum(sizes, dtype=np.int64)]),
        _find_texcoords(vertices, faces, sizes, corners),
    )
    passed = [e.name for e in elements if e.name not in ("vertex", "face") and e.count]
    passed += [
        p.name for e in elements if e.name in ("vertex", "face") for p in e.properties if p.name not in _PLAIN
    ]
    return mesh, passed


def _find_texcoords(
    vertices: dict[str, Any], faces: dict[str, Any], sizes: NDArray[Any], corners: NDArray[Any]
) -> NDArray[np.float64] | None:
    """Texture coordinates of the corners: lists of the faces, or of the vertices."""
    if "texcoord" in faces:
        counts, values = faces["texcoord"]
        return values.reshape(-1, 2).astype(np.float64) if np.array_equal(counts, 2 * sizes) else None
    for u, v in _PAIRS:
        if u in vertices and v in vertices and corners.size and corners.max() < len(vertices[u]):
            return np.stack([vertices[u], vertices[v]], axis=1).astype(np.float64)[corners.astype(np.int64)]
    return None


def _read_header(data: bytes) -> tuple[str, list[_Element], int]:
    end = data.find(b"end_header", 0, _LONGEST_HEADER)
    if not data.startswith(b"ply") or end < 0:
        raise ValueError("it does not begin as a PLY file does")
    begin = data.find(b"\n", end) + 1
    if begin == 0:
        raise ValueError("it ends with its header")
    order, elements = None, []
    for line in data[:end].decode("ascii", "replace").splitlines():
        match line.split():
            case ["format", kind, _] if kind in PLY_ORDERS:
                order = PLY_ORDERS[kind]
            case ["element", name, count]:
                elements.append(_Element(name, int(count), []))
            case ["property", "list", counted, kind, name]:
                elements[-1].properties.append(_Property(name, _find_kind(kind), _find_kind(counted)))
            case ["property", kind, name]:
                elements[-1].properties.append(_Property(name, _find_kind(kind)))
    if order is None:
        raise ValueError("its format is none of a PLY file")
    return order, elements, begin


def _find_kind(word: str) -> str:
    if word not in PLY_KINDS:
        raise ValueError(f"its header has a type {word}")
    return PLY_KINDS[word]


def _too_short(element: _Element) -> ValueError:
    return ValueError(f"it ends before its {element.count} of {element.name}")


class _Text:
    """Elements as words."""

    def __init__(self, data: bytes) -> None:
        self.words = data.split()
        self.at = 0

    def read(self, element: _Element) -> dict[str, Any]:
        """The columns of an element: an array each, of lists their sizes and all entries."""
        names = element.properties
        if element.count > len(self.words) - self.at and names:
            raise _too_short(element)
        if not any(p.counted for p in names):
            width = len(names)
            last = self.at + width * element.count
            if last > len(self.words):
                raise _too_short(element)
            table = np.array(self.words[self.at : last], np.float64).reshape(element.count, width)
            self.at = last
            return {p.name: table[:, k] for k, p in enumerate(names)}
        sizes: dict[str, list[int]] = {p.name: [] for p in names}
        values: dict[str, list[float]] = {p.name: [] for p in names}
        for _ in range(element.count):
            for p in names:
                if self.at >= len(self.words):
                    raise _too_short(element)
                size = 1
                if p.counted:
                    size = int(self.words[self.at])
                    self.at += 1
                if size < 0 or self.at + size > len(self.words):
                    raise _too_short(element)
                sizes[p.name].append(size)
                values[p.name].extend(float(word) for word in self.words[self.at : self.at + size])
                self.at += size
        return {
            p.name: (np.array(sizes[p.name]), np.array(values[p.name]))
            if p.counted
            else np.array(values[p.name])
            for p in names
        }


class _Binary:
    """Elements as bytes of one order."""

    def __init__(self, data: bytes, begin: int, order: str) -> None:
        self.data, self.at, self.order = data, begin, order

    def read(self, element: _Element) -> dict[str, Any]:
        """The columns of an element: an array each, of lists their sizes and all entries."""
        if not element.count or not element.properties:
            return {
                p.name: (np.zeros(0, int), np.zeros(0)) if p.counted else np.zeros(0)
                for p in element.properties
            }
        if element.count > len(self.data) - self.at:
            raise _too_short(element)
        found = self._read_alike(element, self._first_sizes(element))
        return self._read_each(element) if found is None else found

    def _first_sizes(self, element: _Element) -> dict[str, int]:
        """How long the lists of the first row are."""
        at, sizes = self.at, {}
        for p in element.properties:
            if p.counted:
                sizes[p.name] = int(self._take(element, p.counted, at, 1)[0])
                at += np.dtype(p.counted).itemsize
            at += np.dtype(p.kind).itemsize * sizes.get(p.name, 1)
        return sizes

    def _take(self, element: _Element, kind: str, at: int, count: int) -> NDArray[Any]:
        if count < 0 or at + count * np.dtype(kind).itemsize > len(self.data):
            raise _too_short(element)
        return np.frombuffer(self.data, self.order + kind, count, at)

    def _read_alike(self, element: _Element, sizes: dict[str, int]) -> dict[str, Any] | None:
        """All rows at once, where their lists are as long as those of the first."""
        fields: list[Any] = []
        for p in element.properties:
            if p.counted:
                fields.append((f"{p.name} count", self.order + p.counted))
                fields.append((p.name, self.order + p.kind, (sizes[p.name],)))
            else:
                fields.append((p.name, self.order + p.kind))
        row = np.dtype(fields)
        if self.at + row.itemsize * element.count > len(self.data):
            if not sizes:
                raise _too_short(element)
            return None
        table = np.frombuffer(self.data, row, element.count, self.at)
        if any((table[f"{name} count"] != size).any() for name, size in sizes.items()):
            return None
        self.at += row.itemsize * element.count
        return {
            p.name: (table[f"{p.name} count"].astype(np.int64), table[p.name].ravel())
            if p.counted
            else table[p.name]
            for p in element.properties
        }

    def _read_each(self, element: _Element) -> dict[str, Any]:
        """Row by row."""
        sizes: dict[str, list[int]] = {p.name: [] for p in element.properties}
        values: dict[str, list[NDArray[Any]]] = {p.name: [] for p in element.properties}
        for _ in range(element.count):
            for p in element.properties:
                size = 1
                if p.counted:
                    size = int(self._take(element, p.counted, self.at, 1)[0])
                    self.at += np.dtype(p.counted).itemsize
                values[p.name].append(self._take(element, p.kind, self.at, size))
                sizes[p.name].append(size)
                self.at += np.dtype(p.kind).itemsize * size
        return {
            p.name: (np.array(sizes[p.name]), np.concatenate(values[p.name]))
            if p.counted
            else np.concatenate(values[p.name])
            for p in element.properties
        }
