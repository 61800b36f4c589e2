"""Points in texts: columns between commas, semicolons, tabs or blanks, as many programs write them."""

import codecs
import csv
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.files.point_columns import (
    choose_columns,
    not_a_number,
    note_height,
    plain_name,
    unnamed_points,
)
from tilewright.files.point_notes import MARK, PointNote

_ROWS = 2**16
"""Rows that are turned into text at once."""
_HEAD = 2**16
"""Bytes by which a file's way of writing is told."""
_COMMENTS = ("#", "%", "//")
_NUMBER = re.compile(r"[+-]?(\d+[.,]?\d*|[.,]\d+)([eE][+-]?\d+)?|[+-]?(nan|inf|infinity)", re.IGNORECASE)
_DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+([eE][+-]?\d+)?")
_MARKS = ((b"\xef\xbb\xbf", "utf-8-sig"), (b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16"))


def write_text(
    path: Path, blocks: Iterable[NDArray[np.float64]], between: str, header: str, note: PointNote | None
) -> None:
    """Rows of x and y, each number as short as it can be to come back the same."""
    encode, joint = msgspec.json.Encoder().encode, between.encode()
    with path.open("wb") as stream:
        if note is not None:
            stream.write(f"# {MARK} {note.text()}\n".encode())
        stream.write(header.encode())
        for block in blocks:
            for first in range(0, len(block), _ROWS):
                rows = encode(block[first : first + _ROWS].tolist())[2:-2].replace(b".0,", b",")
                rows = (rows.replace(b".0]", b"]") + b"\n").replace(b".0\n", b"\n").replace(b"],[", b"\n")
                stream.write(rows if joint == b"," else rows.replace(b",", joint))


@dataclass(frozen=True)
class Dialect:
    """How a text is written.

    Attributes
    ----------
    encoding : str
        Of its letters.
    skipped : int
        Lines before the first row of numbers.
    delimiter : str or None
        What lies between columns; None for blanks.
    names : tuple of str
        Of the columns; empty where there is no header.
    sample : tuple of str
        The first row of numbers.
    decimal_comma : bool
        Whether fractions begin with a comma.
    note : str
        What tilewright has said of the points, as JSON; mostly nothing.
    """

    encoding: str
    skipped: int
    delimiter: str | None
    names: tuple[str, ...]
    sample: tuple[str, ...]
    decimal_comma: bool
    note: str

    @classmethod
    def of(cls, path: Path) -> "Dialect":
        """By the first lines of a file; a ValueError where they hold no numbers."""
        with path.open("rb") as stream:
            head = stream.read(_HEAD)
        encoding = next((name for mark, name in _MARKS if head.startswith(mark)), "utf-8")
        # The head may end within a letter.
        lines = codecs.getincrementaldecoder(encoding)("replace").decode(head).splitlines()
        at, delimiter, remark, note = _skip_remarks(lines)
        if at == len(lines):
            raise ValueError("it holds no rows")
        first = lines[at]
        delimiter = _find_delimiter(first) if delimiter is None else delimiter
        names: tuple[str, ...] = ()
        if _is_header(_split(first, delimiter)):
            names, at = _split(first, delimiter), at + 1
            while at < len(lines) and not lines[at].strip():
                at += 1
            if at == len(lines):
                raise TilewrightValueError("no points")
        sample = _split(lines[at], delimiter)
        if not names and remark:
            told = _split(remark, _find_delimiter(remark))
            names = told if len(told) == len(sample) and _is_header(told) else ()
        if len(sample) == len(names) + 1 and sample[-1]:  # R leaves out the name of its row names
            names = ("", *names) if names else ()
        decimal_comma = delimiter != "," and any(map(_DECIMAL_COMMA.fullmatch, sample))
        return cls(encoding, at, delimiter or None, names, sample, decimal_comma, note)

    def lines(self, stream: IO[str]) -> "IO[str] | Iterator[str]":
        """The lines of a file, fractions with a point."""
        return (line.replace(",", ".") for line in stream) if self.decimal_comma else stream


def read_text(path: Path) -> tuple[NDArray[np.float64], PointNote | None]:
    """The points of a text, and what is said of them."""
    dialect = Dialect.of(path)
    note = PointNote.parse(dialect.note) if dialect.note else None
    numeric = [bool(_NUMBER.fullmatch(word)) for word in dialect.sample]
    if dialect.names:
        names = list(dialect.names) + [""] * (len(dialect.sample) - len(dialect.names))
        chosen = choose_columns(names, numeric + [False] * (len(names) - len(numeric)))
        for k, name in enumerate(names):
            if plain_name(name) == "z" and k not in chosen:
                note_height(name)
        return _load(path, dialect, chosen, names), note
    columns = [k for k, yes in enumerate(numeric) if yes][:3]
    if len(columns) < 2:
        raise TilewrightValueError("has one column; points need x and y")
    table = _load(path, dialect, columns, [str(k + 1) for k in range(len(numeric))])
    return unnamed_points(table) if len(columns) > 2 else table, note


def _load(path: Path, dialect: Dialect, columns: Any, names: list[str]) -> NDArray[np.float64]:
    """Some columns of a text, shape (rows, columns)."""
    with path.open(encoding=dialect.encoding, errors="replace") as stream:
        try:
            return np.loadtxt(
                dialect.lines(stream), delimiter=dialect.delimiter, skiprows=dialect.skipped,
                usecols=columns, ndmin=2, quotechar='"',
            )  # fmt: skip
        except ValueError as error:
            found = re.search(
                r"could not convert string '(.*)' to float64 at row (\d+), column (\d+)", str(error)
            )
            if found is None:
                raise
            column = int(found[3]) - 1
            name = names[column] if column < len(names) and names[column] else str(column + 1)
            raise not_a_number(found[1], int(found[2]) + 1, name) from None


def _skip_remarks(lines: list[str]) -> tuple[int, str | None, str, str]:
    """The first line that is no remark; what a spreadsheet says of its delimiter; the last remark; a note."""
    delimiter, remark, note = None, "", ""
    for at, line in enumerate(lines):
        words = line.strip()
        mark = next((mark for mark in _COMMENTS if words.startswith(mark)), "")
        if mark:
            remark = words.removeprefix(mark).strip()
            if remark.startswith(f"{MARK} {{"):
                note, remark = remark.removeprefix(MARK), ""
        elif words.lower().startswith("sep=") and at == 0:
            delimiter = line[4:5]
        elif words:
            return at, delimiter, remark, note
    return len(lines), delimiter, remark, note


def _find_delimiter(line: str) -> str:
    """What lies between the columns of a line; nothing stands for blanks."""
    for mark in ";\t":
        if mark in line:
            return mark
    words = line.split()
    if len(words) > 1 and all(map(_DECIMAL_COMMA.fullmatch, words)):
        return ""
    return next((mark for mark in ",|" if mark in line), "")


def _split(line: str, delimiter: str) -> tuple[str, ...]:
    words = (
        next(csv.reader([line], delimiter=delimiter, skipinitialspace=True)) if delimiter else line.split()
    )
    return tuple(word.strip().strip("\"'") for word in words)


def _is_header(words: tuple[str, ...]) -> bool:
    """Whether fewer than two words are numbers, and one is a name."""
    numbers = sum(bool(_NUMBER.fullmatch(word)) for word in words)
    return numbers < min(2, len(words)) and any(word and not _NUMBER.fullmatch(word) for word in words)
