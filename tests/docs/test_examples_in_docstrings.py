"""The Examples sections of public names run, and the names that the first page shows have one."""

import doctest
import inspect
import re
from pathlib import Path

import pytest

import tilewright
from public_names import public_objects

ROOT = Path(__file__).parents[2]
OPEN_ROOMS = ("signals", "fields", "files", "analysis", "export", "gpu", "shaders", "jobs")
"""Rooms where names of the first page may lack an example still; these are shown, not refused."""

EXAMPLES = [
    pytest.param(name, thing, id=name.removeprefix("tilewright."))
    for name, thing in public_objects()
    if not isinstance(thing, property) and ">>> " in (inspect.getdoc(thing) or "")
]


def shown_first() -> list[str]:
    """The names on docs/index.md: those of its code, and those in the last column of its table."""
    page = (ROOT / "docs" / "index.md").read_text()
    rows = [line.split("|")[3] for line in page.splitlines() if line.startswith("| ")]
    names = re.findall(r"\btw\.(\w+)", page) + re.findall(r"`(\w+)`", " ".join(rows))
    return list(dict.fromkeys(names))


def in_open_room(thing: object) -> bool:
    """Whether a name's home is in one of the open rooms."""
    home = inspect.getmodule(thing).__name__.removeprefix("tilewright.")
    return home.startswith(OPEN_ROOMS) and not home.startswith("export.drawing")


@pytest.mark.parametrize(("name", "thing"), EXAMPLES)
def test_examples_run(name, thing, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    said: list[str] = []
    for example in doctest.DocTestFinder(recurse=False).find(thing, name):
        doctest.DocTestRunner(verbose=False).run(example, out=said.append)
    assert not said, "".join(said)


def test_first_page_shows_about_forty_names():
    assert 35 <= len(shown_first()) <= 50


@pytest.mark.parametrize("name", shown_first())
def test_names_of_the_first_page_have_examples(name):
    thing = getattr(tilewright, name)
    if "Examples\n--------" in (inspect.getdoc(thing) or ""):
        return
    if in_open_room(thing):
        pytest.skip(f"{name} has no example yet")
    pytest.fail(f"{name} is on the first page and has no Examples section")
