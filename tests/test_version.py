"""The version stands in one place, src/tilewright/__init__.py."""

import re
import tomllib
from pathlib import Path

import pytest

import tilewright as tw
from tilewright.cli.main import run

ROOT = Path(__file__).parents[1]


def test_builds_read_the_version_that_the_package_says():
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text())
    assert "version" not in settings["project"]
    assert settings["project"]["dynamic"] == ["version"]
    home = ROOT / settings["tool"]["hatch"]["version"]["path"]
    assert re.findall(r'^__version__ = "(.+)"$', home.read_text(), re.MULTILINE) == [tw.__version__]
    assert "\nversion:" not in (ROOT / "CITATION.cff").read_text()


def test_the_program_says_it_too(capsys):
    with pytest.raises(SystemExit) as ended:
        run(["--version"])
    assert ended.value.code == 0
    assert capsys.readouterr().out == f"tilewright {tw.__version__}\n"
