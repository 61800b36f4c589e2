"""Tools see the public names and their types, though the names load lazily."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FACE = "tests/typing/public_face.py"


def run_tool(name, *arguments):
    if importlib.util.find_spec(name) is None:
        pytest.skip(f"{name} is not installed")
    command = [sys.executable, "-m", name, *arguments]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=300)


def test_mypy_agrees():
    found = run_tool("mypy", FACE)
    assert found.returncode == 0, found.stdout + found.stderr


def test_pyright_agrees():
    if run_tool("pyright", "--version").returncode != 0:
        pytest.skip("pyright could not fetch its program")
    found = run_tool("pyright", "--pythonpath", sys.executable)
    assert found.returncode == 0, found.stdout + found.stderr
