"""The house as it is built: names, rooms, and what an import costs."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

import tilewright
from tilewright.files.texts import write_text

SOURCE = Path(tilewright.__file__).parent
STUBS = sorted(SOURCE.rglob("__init__.pyi"))
MOST_ARGUMENTS = 12
"""Of a kernel: what belongs together is handed over in a NamedTuple."""


def exported(stub: Path) -> list[str]:
    """The names that a stub lists."""
    tree = ast.parse(stub.read_text())
    return [alias.name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) for alias in node.names]


def room(stub: Path) -> str:
    """The package a stub belongs to."""
    return ".".join(stub.parent.relative_to(SOURCE.parent).parts)


@pytest.mark.parametrize("stub", STUBS, ids=room)
def test_every_listed_name_loads(stub):
    module = __import__(room(stub), fromlist=["_"])
    missing = [name for name in exported(stub) if not hasattr(module, name)]
    assert not missing


@pytest.mark.parametrize("stub", STUBS, ids=room)
def test_no_module_is_hidden_by_a_name_of_its_package(stub):
    modules = {path.stem for path in stub.parent.iterdir() if path.suffix == ".py" or path.is_dir()}
    assert not modules & set(exported(stub))


def test_import_loads_neither_numba_nor_scipy():
    code = "import sys, tilewright; print(sorted({m.partition('.')[0] for m in sys.modules}))"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert "tilewright" in loaded
    assert not {"'numba'", "'scipy'", "'numpy'"} & set(loaded.strip("[]\n").split(", "))


def test_no_source_file_is_longer_than_400_lines():
    long = [p.name for p in SOURCE.rglob("*.py") if len(p.read_text().splitlines()) > 400]
    assert not long


def test_no_kernel_takes_more_than_12_arguments_besides_its_part_of_a_range():
    many = {
        f"{path.name} {node.name}"
        for path in (SOURCE / "kernels").glob("*.py")
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.FunctionDef)
        and len({argument.arg for argument in node.args.args} - {"first", "last"}) > MOST_ARGUMENTS
    }
    assert not many


def test_text_is_written_by_one_function(tmp_path):
    """So that its bytes are the same on every system."""
    ways = re.compile(r"\.write_text\(|linesep|open\([^)\n]*\"[wx]t?\"(?![^)\n]*newline)")
    found = [p.name for p in SOURCE.rglob("*.py") if p.name != "texts.py" and ways.search(p.read_text())]
    assert found == []
    write_text(tmp_path / "a", "\u00e9\n")
    assert (tmp_path / "a").read_bytes() == b"\xc3\xa9\n"
