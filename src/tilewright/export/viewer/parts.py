"""The files the page is put together from."""

import re
from importlib.resources import files


def part(name: str) -> str:
    """The text of a part."""
    return (files(__package__) / name).read_text(encoding="utf-8").strip()


def fill(name: str, **values: str) -> str:
    """A part with each ``{{name}}`` replaced, in one pass."""
    return re.sub(r"\{\{(\w+)\}\}", lambda match: values[match[1]], part(name))
