"""Texts with places to fill: shaders in any dialect, pages, scripts."""

import re
from importlib.resources import files


def read_text(package: str, name: str) -> str:
    """A text file that comes with ``package``."""
    return (files(package) / name).read_text(encoding="utf-8")


def fill(text: str, **values: str | bool) -> str:
    """A text with its placeholders filled, in one pass.

    ``{{name}}`` becomes the value; lines between ``{{#name}}`` and ``{{/name}}``, each on a line of its own
    (in a comment), stay where the value is true and go where it is not; those between ``{{^name}}`` and
    ``{{/name}}`` the other way round. Such sections may lie in others.
    """
    section = r"^[^\S\n]*(?://|#) \{\{([#^])(\w+)\}\}\n(.*?)^[^\S\n]*(?://|#) \{\{/\2\}\}\n"

    def kept(found: re.Match[str]) -> str:
        return found[3] if bool(values[found[2]]) == (found[1] == "#") else ""

    found = 1
    while found:
        text, found = re.subn(section, kept, text, flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"\{\{(\w+)\}\}", lambda m: str(values[m[1]]), text)
