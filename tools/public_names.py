"""The public face: the names that the stubs (``__init__.pyi``) list, and the members of classes."""

import ast
import inspect
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import tilewright

SOURCE = Path(tilewright.__file__).parent


def public_objects() -> Iterator[tuple[str, Any]]:
    """Every function and class that a stub lists, once, and the public members of the classes."""
    seen = set()
    for stub in sorted(SOURCE.rglob("__init__.pyi")):
        package = import_module(".".join(stub.parent.relative_to(SOURCE.parent).parts))
        for name in listed_names(stub):
            thing = getattr(package, name)
            if not (inspect.isclass(thing) or inspect.isfunction(thing)) or thing in seen:
                continue
            seen.add(thing)
            yield f"{thing.__module__}.{name}", thing
            if inspect.isclass(thing):
                yield from members(thing)


def listed_names(stub: Path) -> list[str]:
    """The names that a stub lists."""
    tree = ast.parse(stub.read_text())
    return [alias.name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) for alias in node.names]


def members(owner: type) -> Iterator[tuple[str, Any]]:
    """The methods and properties that a class defines itself."""
    for name, member in vars(owner).items():
        thing = member.__func__ if isinstance(member, classmethod | staticmethod) else member
        if not name.startswith("_") and (inspect.isfunction(thing) or isinstance(thing, property)):
            yield f"{owner.__module__}.{owner.__name__}.{name}", thing
