"""What stands in one place stays in one place: the version, and the lowest versions of dependencies."""

import re
import runpy
import sys
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


def test_every_dependency_has_a_lower_bound(capsys, monkeypatch):
    path = ROOT / "tools" / "lowest.py"
    monkeypatch.setattr(sys, "argv", [str(path), "--list"])
    runpy.run_path(str(path), run_name="__main__")
    named = [line.partition("==")[0] for line in capsys.readouterr().out.split()]
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    users = [one for extra in ("points", "plots", "solve", "gpu", "video", "meshes") for one in extras[extra]]
    assert extras["all"] == ["tilewright[points,plots,solve,gpu,video,meshes]"]
    assert extras["test"][0] == "tilewright[all]"
    wanted = {*project["dependencies"], *users, *extras["test"][1:]}
    assert named == sorted({requirement.partition(">=")[0] for requirement in wanted})
