"""The page that tells what became of every section of the papers."""

import ast
import inspect
import json
import re
from pathlib import Path

import pytest

import tilewright as tw

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs/papers.md").read_text("utf-8")
SECTIONS = json.loads((ROOT / "tests/docs/papers_sections.json").read_text("utf-8"))
"""Number and title of every section of each document; headings without a number have a letter."""
LINK = re.compile(r"\[`([^`]+)`\]\[([^\]]+)\]")
WITHOUT_A_FUNCTION = ("No method: ", "Not done, because ", "Planned")


def rows_of(document):
    """Number, title and text of each row below a document's heading."""
    (table,) = re.findall(rf"^## {re.escape(document)}\n(.*?)(?=^## |\Z)", PAGE, re.DOTALL | re.MULTILINE)
    rows = [line.strip("|").split(" | ") for line in table.splitlines() if line.startswith("| ")]
    return [tuple(cell.strip() for cell in row) for row in rows[1:]]


ROWS = [pytest.param(*row, id=f"{document}-{row[0]}") for document in SECTIONS for row in rows_of(document)]


@pytest.mark.parametrize("document", SECTIONS)
def test_every_section_has_one_row_and_every_row_a_section(document):
    assert [[number, title] for number, title, _ in rows_of(document)] == SECTIONS[document]


def test_there_are_no_other_documents():
    assert re.findall(r"^## (.*)$", PAGE, re.MULTILINE) == list(SECTIONS)


@pytest.mark.parametrize(("number", "title", "text"), ROWS)
def test_a_row_names_public_functions_or_says_why_there_are_none(number, title, text):
    links = LINK.findall(text)
    for shown, target in links:
        package, _, name = target.partition(".")
        assert package == "tilewright"
        assert name in tw.__all__, f"{target} is not public"
        assert re.match(rf"{name}\b", shown), f"{shown} leads to {target}"
        check_call(shown)
    assert text.startswith(WITHOUT_A_FUNCTION) != bool(links)
    assert not (links and "not done" in text.lower())


def check_call(shown):
    """What is shown, such as ``direct(period=)``, exists and takes the arguments it is shown with."""
    path, _, arguments = shown.partition("(")
    shown_object = tw
    for name in path.split("."):
        shown_object = getattr(shown_object, name)
    named = ast.parse(f"f({re.sub(r'=(?=[,)])', '=0', arguments)}").body[0].value if arguments else None
    if named is not None:
        known = inspect.signature(shown_object)
        known.bind_partial(*named.args, **{keyword.arg: keyword.value for keyword in named.keywords})
