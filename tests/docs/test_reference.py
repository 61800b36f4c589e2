"""Every public name has its entry in the reference, and names on the pages lead to it."""

import importlib.util
import re
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

import pytest

ROOT = Path(__file__).parents[2]
PAGES = sorted((ROOT / "docs/reference").glob("*.md"))
STUBS = {
    "tilewright": ROOT / "src/tilewright/__init__.pyi",
    "tilewright.gpu": ROOT / "src/tilewright/gpu/__init__.pyi",
    "tilewright.jobs": ROOT / "src/tilewright/jobs/__init__.pyi",
}

FUNCTIONS = ("texture_tiles", "open_exemplar", "add_maps")
"""Of a room, but shown as names of the package."""


def public_names():
    return [
        f"{package}.{name}"
        for package, stub in STUBS.items()
        for name in re.findall(r" as (\w+)", stub.read_text())
        if package == "tilewright" or name not in FUNCTIONS
    ]


def test_every_public_name_has_one_entry():
    entries = Counter(
        name for page in PAGES for name in re.findall(r"^::: (\S+)$", page.read_text(), re.MULTILINE)
    )
    assert entries == Counter(public_names())


def test_every_page_can_be_found():
    menu = (ROOT / "mkdocs.yml").read_text()
    overview = (ROOT / "docs/reference/index.md").read_text()
    for page in PAGES:
        assert f"reference/{page.name}" in menu
        assert page.name == "index.md" or f"]({page.name})" in overview


def test_names_in_backticks_link_to_their_entry():
    markdown = pytest.importorskip("markdown")
    pytest.importorskip("mkdocs")
    spec = importlib.util.spec_from_file_location("link_names", ROOT / "tools/link_names.py")
    hook = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(hook)

    config = SimpleNamespace(markdown_extensions=["fenced_code"])
    hook.on_config(config)

    def links(text):
        html = markdown.markdown(text, extensions=config.markdown_extensions)
        return re.findall(r'<autoref identifier="(.*?)"', html)

    assert links("`TileSet`, `tw.direct()` and `TileSet.find`") == [
        "tilewright.TileSet",
        "tilewright.direct",
        "tilewright.TileSet.find",
    ]
    assert links("``TileSet`` [`TileSet`](a.md) `TileSets` `direct(1)` TileSet\n\n```\n`TileSet`\n```") == []
