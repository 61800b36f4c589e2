"""Object file format: OFF and its kin with colors, normals or texture coordinates, as text."""

import re
from pathlib import Path

import numpy as np

from tilewright.domains import Mesh

_HEAD = re.compile(r"^(ST)?(C)?(N)?OFF$")


def read_off(path: Path) -> tuple[Mesh, list[str]]:
    """The mesh, and what was passed over."""
    lines = path.read_bytes().decode("utf-8", "replace").splitlines()
    words = [word for line in lines for word in line.partition("#")[0].split()]
    head = _HEAD.match(words[0]) if words else None
    if head is None:
        raise ValueError("it does not begin with OFF")
    if len(words) > 1 and words[1] == "BINARY":
        raise ValueError("binary OFF is not read; save it as text")
    count, faces = int(words[1]), int(words[2])
    if count < 0 or faces < 0 or 3 * count + 4 * faces > len(words):
        raise ValueError(f"it ends before its {count} vertices and {faces} faces")
    # Step 1: so many numbers for each vertex, of which the first three are its place.
    each = 3 + 2 * bool(head[1]) + 4 * bool(head[2]) + 3 * bool(head[3])
    first, last = 4, 4 + each * count
    if last > len(words):
        raise ValueError(f"it ends before its {count} vertices")
    table = np.array(words[first:last], np.float64).reshape(count, each)
    # Step 2: faces, each with its number of corners before it and perhaps a color behind.
    rows, passed = _read_faces(lines, words[last:], faces, count)
    texcoords = table[:, -2:][np.concatenate(rows)] if head[1] and rows else None
    starts = np.concatenate([[0], np.cumsum([len(row) for row in rows], dtype=np.int64)])
    corners = np.concatenate(rows) if rows else np.zeros(0, np.int64)
    notes = [name for name, there in (("colors", head[2] or passed), ("normals", head[3])) if there]
    return Mesh(table[:, :3], corners, starts, texcoords), notes


def _read_faces(
    lines: list[str], words: list[str], faces: int, vertices: int
) -> tuple[list[np.ndarray], bool]:
    """The corners of every face, and whether colors stand behind them: then faces have lines of their own."""
    rows, at = [], 0
    for _ in range(faces):
        if at >= len(words):
            raise ValueError(f"it ends before its {faces} faces")
        size = int(words[at])
        if size < 0 or at + 1 + size > len(words):
            raise ValueError(f"it ends before its {faces} faces")
        rows.append(np.array(words[at + 1 : at + 1 + size], np.int64))
        at += 1 + size
    if at == len(words):
        return rows, False
    split = [line.partition("#")[0].split() for line in lines]
    split = [row for row in split if row][-faces:]
    if any(not row[0].isdecimal() or len(row) < int(row[0]) + 1 for row in split):
        raise ValueError("more stands behind its faces than colors")
    return [np.array(row[1 : 1 + int(row[0])], np.int64) for row in split], True
