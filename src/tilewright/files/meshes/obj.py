"""Meshes in OBJ files: texts of lines that each begin with a word."""

from collections.abc import Callable, Iterable
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, brief_text
from tilewright.files.meshes.raw import RawMesh, has_no_faces, starts_of
from tilewright.showing import many

_SILENT = {
    b"vn", b"s", b"mtllib", b"maplib", b"usemap", b"bevel", b"c_interp", b"d_interp", b"lod",
    b"shadow_obj", b"trace_obj", b"mg",
}  # fmt: skip
"""Words of lines that say nothing of shapes: normals, smoothing, looks."""
_GROUPS = {b"g": "group", b"o": "object", b"usemtl": "material"}
_SHAPES = {b"l": "line", b"p": "free point", b"curv": "curve", b"curv2": "curve", b"surf": "curved surface"}
_FREE_FORM = {
    b"vp", b"cstype", b"deg", b"bmat", b"step", b"parm", b"trim", b"hole", b"scrv", b"sp", b"end", b"con",
    b"ctech", b"stech",
}  # fmt: skip
"""Words that belong to curves and curved surfaces."""


class _Lines:
    """The lines of a file by their first words, each with its number."""

    def __init__(self, data: bytes) -> None:
        if b"\0" in data:
            raise TilewrightValueError("is no text, as an OBJ file is")
        data = data.removeprefix(b"\xef\xbb\xbf").replace(b"\r\n", b"\n").replace(b"\r", b"\n")
        self.joined = b"\\\n" in data
        self.texts: dict[bytes, list[bytes]] = {}
        self.numbers: dict[bytes, list[int]] = {}
        for number, line in enumerate(data.replace(b"\\\n", b" ").split(b"\n"), 1):
            if b"#" in line:
                line = line.partition(b"#")[0]
            word, _, text = line.replace(b"\t", b" ").strip().partition(b" ")
            if not word:
                continue
            if word not in self.texts:
                self.texts[word], self.numbers[word] = [], []
            self.texts[word].append(text)
            self.numbers[word].append(number)

    def of(self, word: bytes) -> list[bytes]:
        """What follows a word, of each line that begins with it."""
        return self.texts.get(word, [])

    def before(self, word: bytes, other: bytes) -> NDArray[np.int64]:
        """How many lines of a word come before each line of another."""
        at = np.array(self.numbers.get(other, []), np.int64)
        return np.searchsorted(np.array(self.numbers.get(word, []), np.int64), at).astype(np.int64)

    def error(self, word: bytes, row: int, problem: str) -> TilewrightValueError:
        """The error of a line."""
        where = "" if self.joined else f"line {self.numbers[word][row]}, "
        shown = brief_text((word + b" " + self.texts[word][row]).decode("latin-1"))
        return TilewrightValueError(f"{where}'{shown}', {problem}")


def read_obj(data: bytes) -> RawMesh:
    """The mesh of an OBJ file: v, vt and f; what else it holds is noted."""
    lines = _Lines(data)
    if not {b"v", b"f"} & set(lines.texts):
        raise TilewrightValueError("holds no vertices and faces as an OBJ file does")
    vertices = _numbers(lines, b"v", 3, 3)
    if not lines.of(b"f"):
        raise has_no_faces(len(vertices))
    sizes = [len(text.split()) for text in lines.of(b"f")]
    named = _corners(lines, sizes)
    corners = _resolve(lines, named[:, 0], sizes, b"v", len(vertices))
    notes = _notes(lines)
    coords = None
    if named.shape[1] > 1 and named[:, 1].any():
        if named[:, 1].all():
            texcoords = _numbers(lines, b"vt", 2, 1)
            coords = texcoords[_resolve(lines, named[:, 1], sizes, b"vt", len(texcoords))]
        else:
            notes.append("texture coordinates, which some of its faces lack")
    return RawMesh(vertices, corners, starts_of(sizes), coords, notes)


def _numbers(lines: _Lines, word: bytes, columns: int, least: int) -> NDArray[np.float64]:
    """The first numbers of all lines of a word; those that may be left out are 0."""
    texts = lines.of(word)
    rows = [text.split(None, columns)[:columns] for text in texts]
    if short := [row for row, words in enumerate(rows) if len(words) < columns]:
        for row in short:
            if len(rows[row]) < least:
                raise lines.error(word, row, f"has fewer than {many(least, 'number')}")
            rows[row] += [b"0"] * (columns - len(rows[row]))
    flat = _parse(float, chain.from_iterable(rows), np.float64)
    if flat is None:
        bad = next(row for row, words in enumerate(rows) if _parse(float, words, np.float64) is None)
        raise lines.error(word, bad, "holds something else than numbers")
    return flat.reshape(-1, columns)


def _corners(lines: _Lines, sizes: list[int]) -> NDArray[np.int64]:
    """What every corner of every face names: a vertex, and texture coordinates, 0 where there are none."""
    text = b" ".join(lines.of(b"f"))
    slashes = _slashes(text)
    parts = int(slashes.max(initial=0)) + 1
    if parts <= 3 and (slashes == parts - 1).all() and text.count(b"//") in (0, len(slashes)):
        words: Iterable[bytes] = text.replace(b"//", b"/0/").replace(b"/", b" ").split()
    else:
        parts = 3
        split = ([*word.split(b"/"), b"", b""][:3] for word in text.split())
        words = (part or b"0" for word in split for part in word)
    flat = _parse(int, words, np.int64)
    if flat is None:
        bad = next(row for row, words in enumerate(lines.of(b"f")) if not _is_face(words))
        raise lines.error(b"f", bad, "names corners by something else than whole numbers")
    named = flat.reshape(-1, parts)[:, :2]
    if not named[:, 0].all():
        row = _row(sizes, int(np.argmin(named[:, 0] != 0)))
        raise lines.error(b"f", row, "names vertex 0; they count from 1")
    return named


def _slashes(text: bytes) -> NDArray[np.int64]:
    """How many slashes each word of a text holds."""
    signs = np.frombuffer(text, np.uint8)
    blank = signs <= ord(" ")
    first = np.flatnonzero(~blank & np.concatenate([[True], blank[:-1]]))
    return np.add.reduceat(signs == ord("/"), first, dtype=np.int64) if len(first) else first


def _is_face(text: bytes) -> bool:
    return all(
        _parse(int, [part or b"0" for part in word.split(b"/")], np.int64) is not None
        for word in text.split()
    )


def _resolve(
    lines: _Lines, named: NDArray[np.int64], sizes: list[int], word: bytes, count: int
) -> NDArray[np.int64]:
    """Numbers from 0 for those that count from 1, or backwards from the line they stand in."""
    found = named - 1
    if (named < 0).any():
        known = np.repeat(lines.before(word, b"f"), sizes)
        found = np.where(named < 0, known + named, found)
    wrong = (found < 0) | (found >= count)
    if wrong.any():
        at = int(np.argmax(wrong))
        what = "vertex" if word == b"v" else "texture coordinates"
        raise lines.error(b"f", _row(sizes, at), f"names {what} {named[at]}; there are {count}")
    return found


def _row(sizes: list[int], corner: int) -> int:
    """The face of a corner."""
    return int(np.searchsorted(np.cumsum(sizes), corner, side="right"))


def _parse(kind: Callable[[bytes], Any], words: Iterable[bytes], dtype: type) -> NDArray[Any] | None:
    """Words as numbers; None where one is something else."""
    try:
        return np.fromiter(map(kind, words), dtype)
    except (ValueError, OverflowError):
        return None


def _notes(lines: _Lines) -> list[str]:
    """What the file states and is not heeded."""
    notes = [many(len(lines.of(word)), noun) for word, noun in _SHAPES.items() if lines.of(word)]
    for word, noun in _GROUPS.items():
        names = {text.strip() for text in lines.of(word)}
        if len(names) > 1:
            notes.append(many(len(names), noun))
    known = {b"v", b"vt", b"f"} | _SILENT | set(_GROUPS) | set(_SHAPES) | _FREE_FORM
    if strange := [word for word in lines.texts if word not in known]:
        shown = brief_text(strange[0].decode("latin-1"))
        count = sum(len(lines.of(word)) for word in strange)
        notes.append(f"{many(count, 'line')} that no one knows, such as '{shown}'")
    return notes
