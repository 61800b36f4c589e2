"""The page that leads from tasks to names has every public name."""

import re
from pathlib import Path

import tilewright as tw

PAGE = (Path(__file__).parents[2] / "docs/names.md").read_text("utf-8")
NAMES = re.findall(r"(?<!\[)`([A-Za-z_]\w+)`", PAGE)


def test_every_public_name_is_on_the_page():
    assert {name for name in tw.__all__ if not name.startswith("__")} - set(NAMES) == set()


def test_every_name_on_the_page_is_public_or_a_command():
    from tilewright.cli.main import COMMANDS

    assert set(NAMES) - set(tw.__all__) <= {*COMMANDS, "tilewright", "tw"}


def test_options_on_the_page_are_those_of_the_commands():
    from write_commands import COMMANDS, options_of

    for command, option in re.findall(r"`(\w+) (--?[a-z-]+)", PAGE):
        assert option in [flag for one in options_of(COMMANDS[command]) for flag in one.flags], option
