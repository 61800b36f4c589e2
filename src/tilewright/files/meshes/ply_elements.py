"""PLY files by their elements: what the header says they hold, and their columns and lists of numbers."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, brief_text
from tilewright.files.meshes.raw import ends_early, starts_of
from tilewright.files.point_formats import PLY_KINDS, PLY_ORDERS

KINDS = {**PLY_KINDS, "int64": "i8", "uint64": "u8"}
"""Kinds of numbers by their names, with two that no standard has and some programs write."""


@dataclass(frozen=True)
class Property:
    """One number, or one list of numbers, that each row of an element has.

    Attributes
    ----------
    name : str
        Its name.
    kind : str
        Code of the kind of its numbers, without byte order.
    length : str
        Code of the kind of number that says how long a list is; empty where it is no list.
    """

    name: str
    kind: str
    length: str = ""


@dataclass(frozen=True)
class Lists:
    """A list of numbers in each row: all numbers, and where those of each row start and end."""

    values: NDArray[Any]
    starts: NDArray[np.int64]


Columns = dict[str, NDArray[Any] | Lists]


@dataclass
class Element:
    """What the header says of one element."""

    name: str
    count: int
    properties: list[Property] = field(default_factory=list)

    @property
    def flat(self) -> bool:
        """Whether no row holds a list."""
        return not any(each.length for each in self.properties)


def read_elements(data: bytes) -> tuple[dict[str, Columns], int]:
    """The columns of every element by name, and how many bytes or words are left after the last."""
    order, elements, at = _read_header(data)
    body = _Words(data[at:].split()) if not order else _Bytes(data, at, order)
    found: dict[str, Columns] = {}
    for element in elements:
        found[element.name] = body.read(element)
    return found, body.left


def _read_header(data: bytes) -> tuple[str, list[Element], int]:
    """Byte order, elements, and where the first of them begins."""
    if not data.startswith((b"ply\n", b"ply\r")):
        raise TilewrightValueError("does not begin as a PLY file does")
    ends = b"\r" if data.startswith(b"ply\r") and not data.startswith(b"ply\r\n") else b"\n"
    order, elements, at = None, [], 0
    while True:
        end = data.find(ends, at)
        if end < 0:
            raise TilewrightValueError("ends within its header")
        line, at = data[at:end].decode("latin-1").strip(), end + 1
        match line.split():
            case ["end_header"]:
                break
            case ["format", kind, *_] if kind in PLY_ORDERS:
                order = PLY_ORDERS[kind]
            case ["element", name, number] if number.isascii() and number.isdigit():
                elements.append(Element(name, int(number)))
            case ["property", "list", length, kind, name] if elements and _is_list(length, kind):
                elements[-1].properties.append(Property(name, KINDS[kind], KINDS[length]))
            case ["property", kind, name] if elements and kind in KINDS:
                elements[-1].properties.append(Property(name, KINDS[kind]))
            case ["ply" | "comment" | "obj_info", *_] | []:
                pass
            case _:
                raise TilewrightValueError(f"has '{brief_text(line)}' in its header, which no one knows")
    if order is None:
        raise TilewrightValueError("does not say its format in its header")
    return order, elements, at


def _is_list(length: str, kind: str) -> bool:
    return KINDS.get(length, "f")[0] in "iu" and kind in KINDS


class _Bytes:
    """A body in binary."""

    def __init__(self, data: bytes, at: int, order: str) -> None:
        self._data, self._at, self._order = data, at, order

    @property
    def left(self) -> int:
        return len(self._data) - self._at

    def read(self, element: Element) -> Columns:
        """All rows of an element: at once where they are alike, else each by its lists."""
        if not element.properties or not element.count:
            return {}
        found = self._read_alike(element)
        return self._read_lists(element) if found is None else found

    def _read_alike(self, element: Element) -> Columns | None:
        """The rows, if every list is as long as in the first of them."""
        lengths = [each[0] for each in self._walk(element, 1)[0]]
        fields: list[tuple[Any, ...]] = []
        for k, (one, length) in enumerate(zip(element.properties, lengths, strict=True)):
            if one.length:
                fields.append((f"n{k}", self._order + one.length))
            fields.append((f"v{k}", self._order + one.kind, *([(length,)] if one.length else [])))
        kind = np.dtype(fields)
        if element.count * kind.itemsize > self.left:
            if element.flat:
                raise ends_early(_plural(element.name), element.count)
            return None
        rows = np.frombuffer(self._data, kind, element.count, self._at)
        found: Columns = {}
        for k, (one, length) in enumerate(zip(element.properties, lengths, strict=True)):
            if one.length and (rows[f"n{k}"] != length).any():
                return None
            values = rows[f"v{k}"]
            if one.length:
                starts = np.arange(element.count + 1, dtype=np.int64) * length
                found[one.name] = Lists(values.ravel(), starts)
            else:
                found[one.name] = values
        self._at += element.count * kind.itemsize
        return found

    def _walk(self, element: Element, count: int) -> tuple[list[list[int]], list[list[int]], int]:
        """How long each property is in each of the first rows, where it begins, and where they end."""
        steps = [
            (int(one.length[1:] or 0), one.length[:1] == "i", int(one.kind[1:])) for one in element.properties
        ]
        byteorder: Literal["big", "little"] = "big" if self._order == ">" else "little"
        lengths: list[list[int]] = [[] for _ in steps]
        places: list[list[int]] = [[] for _ in steps]
        data, at, size = self._data, self._at, len(self._data)
        for _ in range(count):
            for k, (head, signed, item) in enumerate(steps):
                length = 1
                if head:
                    length = int.from_bytes(data[at : at + head], byteorder, signed=signed)
                    at += head
                if length < 0:
                    raise _bad_length(length, element)
                lengths[k].append(length)
                places[k].append(at)
                at += length * item
            if at > size:
                raise ends_early(_plural(element.name), element.count)
        return lengths, places, at

    def _read_lists(self, element: Element) -> Columns:
        lengths, places, end = self._walk(element, element.count)
        signs = np.frombuffer(self._data, np.uint8)
        found: Columns = {}
        for k, one in enumerate(element.properties):
            kind = np.dtype(self._order + one.kind)
            starts = starts_of(lengths[k])
            first = np.array(places[k], np.int64) - starts[:-1] * kind.itemsize
            at = np.repeat(first, lengths[k]) + np.arange(starts[-1]) * kind.itemsize
            values = signs[at[:, np.newaxis] + np.arange(kind.itemsize)].view(kind).ravel()
            found[one.name] = Lists(values, starts) if one.length else values
        self._at = end
        return found


class _Words:
    """A body in ASCII."""

    def __init__(self, words: list[bytes]) -> None:
        self._words, self._at = words, 0

    @property
    def left(self) -> int:
        return len(self._words) - self._at

    def read(self, element: Element) -> Columns:
        """All rows of an element."""
        if not element.properties or not element.count:
            return {}
        return self._read_flat(element) if element.flat else self._read_lists(element)

    def _read_flat(self, element: Element) -> Columns:
        width = len(element.properties)
        end = self._at + element.count * width
        if end > len(self._words):
            raise ends_early(_plural(element.name), element.count)
        words = self._words
        found: Columns = {
            one.name: _parse(words[self._at + k : end : width], one)
            for k, one in enumerate(element.properties)
        }
        self._at = end
        return found

    def _read_lists(self, element: Element) -> Columns:
        words, at = self._words, self._at
        found: list[list[list[bytes]]] = [[] for _ in element.properties]
        try:
            for _ in range(element.count):
                for k, one in enumerate(element.properties):
                    length = 1
                    if one.length:
                        length, at = int(words[at]), at + 1
                    if length < 0:
                        raise _bad_length(length, element)
                    found[k].append(words[at : at + length])
                    at += length
                if at > len(words):
                    raise IndexError
        except IndexError:
            raise ends_early(_plural(element.name), element.count) from None
        except TilewrightValueError:
            raise
        except ValueError as error:
            raise TilewrightValueError(f"has something else than the length of a list: {error}") from None
        self._at = at
        columns: Columns = {}
        for one, rows in zip(element.properties, found, strict=True):
            values = _parse(list(chain.from_iterable(rows)), one)
            columns[one.name] = Lists(values, starts_of(map(len, rows))) if one.length else values
        return columns


def _parse(words: Sequence[bytes], one: Property) -> NDArray[Any]:
    whole = one.kind[0] in "iu"
    try:
        return np.fromiter(map(int, words), np.int64) if whole else np.fromiter(map(float, words), np.float64)
    except (ValueError, OverflowError) as error:
        kind = "whole numbers" if whole else "numbers"
        raise TilewrightValueError(f"holds {one.name} that are no {kind}: {error}") from None


def _bad_length(length: int, element: Element) -> TilewrightValueError:
    return TilewrightValueError(f"has a list of {length} numbers among its {_plural(element.name)}")


def _plural(element: str) -> str:
    return {"vertex": "vertices", "face": "faces"}.get(element, f"rows of {element}")
