"""The pages of the commands are as the commands are."""

from pathlib import Path

import pytest
import typer

import write_commands
from tilewright.cli.main import COMMANDS, app

ROOT = Path(__file__).parents[2]
MENU = (ROOT / "mkdocs.yml").read_text("utf-8")


def test_no_page_is_old():
    assert not write_commands.old(), "run tools/write_commands.py"


def test_a_page_is_old_where_help_differs(monkeypatch):
    monkeypatch.setattr(write_commands, "COMMON", ("--output",))
    assert "docs/commands/render.md" in write_commands.old()


@pytest.mark.parametrize("name", COMMANDS)
def test_a_page_has_every_option_that_the_program_knows(name):
    page = (ROOT / f"docs/commands/{name}.md").read_text("utf-8")
    known = typer.main.get_command(app).commands[name].params
    rows = "\n".join(line for line in page.splitlines() if line.startswith("| `"))
    for option in known:
        if not getattr(option, "hidden", False) and option.name != "help":
            assert all(f"`{flag}`" in rows for flag in option.opts if flag.startswith("-")), option.name
    assert f"commands/{name}.md" in MENU


def test_calls_in_a_sentence_are_code():
    assert write_commands.as_code("makes a(b, c(...)).d(e), with --to f(x).") == (
        "makes `a(b, c(...)).d(e)`, with `--to` `f(x)`."
    )


def test_what_a_cell_shows_as_code():
    assert write_commands.cell("FILE.png or .tif; --map NAME=FILE | H0=2.") == (
        r"`FILE.png` or `.tif`; `--map` `NAME=FILE` \| `H0=2`."
    )
