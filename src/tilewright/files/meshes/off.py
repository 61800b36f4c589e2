"""Meshes in OFF files: a head, two counts, a line for every vertex and every face."""

import re
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, brief_text
from tilewright.files.meshes.raw import RawMesh, ends_early, has_no_faces, starts_of
from tilewright.showing import many

_HEAD = re.compile(rb"(ST)?(C)?(N)?(4)?(n)?OFF")


def read_off(data: bytes) -> RawMesh:
    """The mesh of an OFF file; normals and colors are passed over."""
    if b"\0" in data:
        raise TilewrightValueError("is no text; OFF files of numbers in binary are not read")
    rows = _rows(data)
    if not rows:
        raise TilewrightValueError("holds no numbers")
    textured, width, rows = _read_head(rows)
    if not rows:
        raise TilewrightValueError("ends before its counts")
    counts = _whole(rows[0].split()[:3], "its counts")
    if len(counts) < 2 or min(counts) < 0:
        raise TilewrightValueError(f"has the line '{_shown(rows[0])}' where it counts vertices and faces")
    many_vertices, many_faces = counts[:2]
    if len(rows[0].split()) > 3 or len(rows) - 1 < many_vertices + many_faces:
        rows = _in_lines(rows, many_vertices, many_faces, width) or rows
    if len(rows) - 1 < many_vertices:
        raise ends_early("vertices", many_vertices)
    if not many_faces:
        raise has_no_faces(many_vertices)
    if len(rows) - 1 - many_vertices < many_faces:
        raise ends_early("faces", many_faces)
    table = [row.split() for row in rows[1 : 1 + many_vertices]]
    vertices = _columns(table, 0, 3)
    sizes, corners = _faces(rows[1 + many_vertices : 1 + many_vertices + many_faces])
    mesh = RawMesh(vertices, corners, starts_of(sizes))
    if textured and ((corners >= 0) & (corners < many_vertices)).all():
        mesh.texcoords = _columns(table, -2, 2)[corners]
    if left := len(rows) - 1 - many_vertices - many_faces:
        mesh.notes.append(f"{many(left, 'line')} after the last face")
    return mesh


def _rows(data: bytes) -> list[bytes]:
    """The lines that say something, without comments."""
    data = data.removeprefix(b"\xef\xbb\xbf").replace(b"\r", b"\n")
    lines = data.split(b"\n")
    if b"#" in data:
        lines = [line.partition(b"#")[0] for line in lines]
    return [row for line in lines if (row := line.strip())]


def _in_lines(rows: list[bytes], vertices: int, faces: int, width: int) -> list[bytes] | None:
    """A line for each vertex and face of a file that begins none for them; None where it holds other."""
    words = b" ".join(rows).split()
    lines, at = [b" ".join(words[:3])], 3
    while at < len(words) and len(lines) <= vertices + faces:
        step = width
        if len(lines) > vertices:
            if not words[at].isdigit():
                return None
            step = 1 + int(words[at])
        lines.append(b" ".join(words[at : at + step]))
        at += step
    return lines if at == len(words) and len(lines) == 1 + vertices + faces else None


def _read_head(rows: list[bytes]) -> tuple[bool, int, list[bytes]]:
    """Whether vertices have texture coordinates, how many numbers each has, and the lines from the counts."""
    word, *rest = rows[0].split(None, 1)
    if not word[:1].isalpha() and not word.endswith(b"OFF"):  # the head may be left out
        return False, 3, rows
    head = _HEAD.fullmatch(word)
    if head is None:
        raise TilewrightValueError(f"begins with '{_shown(word)}', not with OFF")
    if head[4] or head[5]:
        raise TilewrightValueError(f"is {word.decode()}, not of three dimensions")
    if rest and rest[0].split()[0].upper() == b"BINARY":
        raise TilewrightValueError("is an OFF file of numbers in binary, which are not read")
    width = 3 + 2 * bool(head[1]) + 4 * bool(head[2]) + 3 * bool(head[3])
    return bool(head[1]), width, [*rest, *rows[1:]]


def _columns(table: list[list[bytes]], first: int, count: int) -> NDArray[np.float64]:
    """Some neighboring columns of the vertices."""
    last = first + count or None
    for row, words in enumerate(table):
        if len(words) < (3 if first >= 0 else 3 + count):
            raise TilewrightValueError(f"vertex {row}, '{_shown(b' '.join(words))}', has too few numbers")
    try:
        flat = np.fromiter(map(float, chain.from_iterable(row[first:last] for row in table)), np.float64)
    except ValueError as error:
        raise TilewrightValueError(f"has a vertex that is no number: {error}") from None
    return flat.reshape(-1, count)


def _faces(rows: list[bytes]) -> tuple[list[int], NDArray[np.int64]]:
    """How many corners every face has, and the corners of all."""
    table = [row.split() for row in rows]
    sizes = _whole([words[0] for words in table], "the size of a face")
    for face, (words, size) in enumerate(zip(table, sizes, strict=True)):
        if not 0 <= size < len(words):
            raise TilewrightValueError(
                f"face {face}, '{_shown(b' '.join(words))}', names other than the {size} corners it says"
            )
    named = chain.from_iterable(words[1 : size + 1] for words, size in zip(table, sizes, strict=True))
    return sizes, np.array(_whole(list(named), "a corner"), np.int64)


def _whole(words: list[bytes], what: str) -> list[int]:
    try:
        numbers = [int(word) for word in words]
    except ValueError as error:
        raise TilewrightValueError(f"has something else than a whole number for {what}: {error}") from None
    if any(abs(number) >= 2**63 for number in numbers):
        raise TilewrightValueError(f"has a number beyond 64 bits for {what}")
    return numbers


def _shown(text: bytes) -> str:
    return brief_text(text.decode("latin-1"))
