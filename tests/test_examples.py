"""The examples run, and the commands that each of them names make the same files."""

import re
import runpy
import shlex
import shutil
import sys
from pathlib import Path

import pytest

from tilewright.analysis.points import comparison
from tilewright.cli.main import run

EXAMPLES = sorted((Path(__file__).parents[1] / "examples").glob("[0-9]*.py"))
INPUTS = ("photo.png", "maps")
# What an example leaves for its commands to begin with.
TIMED = {"comparison.md", "comparison.json"}
# Figures in them are times.


@pytest.mark.usefixtures("small_photographs")
@pytest.mark.pages
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_and_its_commands_make_the_same(path, tmp_path, monkeypatch):
    monkeypatch.setattr(comparison, "SPECTRUM_POINTS", 1024)
    monkeypatch.setattr(comparison, "PLATE_POINTS", 65536 + 4096)
    by_call, by_command = tmp_path / "call", tmp_path / "command"
    monkeypatch.setattr(sys, "argv", [str(path), "--output", str(by_call)])
    runpy.run_path(str(path), run_name="__main__")
    begin(by_call, by_command)
    monkeypatch.chdir(by_command)
    for command in commands(path):
        with pytest.raises(SystemExit) as ended:
            run(command)
        assert ended.value.code == 0
    made = contents(by_call)
    assert made.keys() == contents(by_command).keys()
    assert made.keys() - INPUTS
    differing = {name for name, data in contents(by_command).items() if data != made[name]}
    assert {Path(name).name for name in differing} <= TIMED


def test_they_are_numbered_without_gaps():
    assert [int(path.name[:2]) for path in EXAMPLES] == list(range(1, len(EXAMPLES) + 1))


def begin(by_call, by_command):
    by_command.mkdir()
    for name in INPUTS:
        if (by_call / name).is_dir():
            shutil.copytree(by_call / name, by_command / name)
        elif (by_call / name).exists():
            shutil.copy(by_call / name, by_command / name)


def commands(path):
    """The words of each command in the docstring, without the program's name."""
    found = re.findall(r"^    tilewright (.+)$", path.read_text().split('"""')[1], re.MULTILINE)
    assert found
    return [shlex.split(line) for line in found]


def contents(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
