"""How things say what they are: in one line of text, and in a notebook with a small picture.

Pictures are painted by rooms far above the things that they show. So nothing here knows a painter: the
package sets `painter` when it is imported (`tilewright.notebook`, loaded with the first picture).
"""

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import Any

painter: Callable[[Any], bytes | None] | None = None
"""Gives the PNG of a thing, or None where there is nothing to see."""


class Shown:
    """Something that notebooks show as a picture."""

    def _repr_png_(self) -> bytes | None:
        return None if painter is None else painter(self)


def describe(thing: object, *words: str) -> str:
    """``<Kind: words, more words>``."""
    return f"<{type(thing).__name__}: {', '.join(words)}>"


def describe_record(record: Any) -> str:
    """The line of a dataclass: its numbers and short texts, and of arrays their type and shape."""
    return describe(record, *(f"{f.name} {_brief(getattr(record, f.name))}" for f in fields(record)))


def many(count: float, one: str) -> str:
    """``1 tile``, ``16 tiles``, ``1,048,576 points``."""
    number = f"{int(count):,}" if count == int(count) else f"{count:,}"
    return f"{number} {one}{'' if count == 1 else 's'}"


def _brief(value: Any) -> str:
    if hasattr(value, "dtype") and hasattr(value, "shape"):
        return f"{value:.6g}" if value.shape == () else f"{value.dtype} {value.shape}"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        return f"of {', '.join(map(str, value))}" if 0 < len(value) <= 6 else f"of {len(value)} names"
    if isinstance(value, (list, tuple)) and len(repr(value)) > 60:
        return f"({len(value)})"
    words = " ".join(repr(value).split())
    return words if len(words) <= 120 else f"{words[:117]}..."
