"""Hold every public name to its docstring: `python tools/check_docstrings.py`.

numpydoc compares parameters with the signature; this file adds what it does not know: that the fields of a
dataclass may stand under Attributes, and that a function which refuses something says so under Raises.
"""

import ast
import builtins
import inspect
import sys
import textwrap
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from numpydoc.docscrape import get_doc_object
from numpydoc.validate import Validator, validate

from public_names import SOURCE, public_objects

# The validator's codes that are not about taste: those of a summary, then parameters, returns and yields.
SUMMARY = {"GL01", "GL02", "GL03", "GL05", "GL06", "GL07", "GL08", "GL10", "SS01", "SS03", "SS06"}
SECTIONS = {"PR01", "PR02", "PR03", "PR04", "PR05", "PR07", "PR09", "RT01", "RT02", "RT03", "RT05", "YD01"}


class Docstring(Validator):
    """A docstring whose Attributes may document the fields of a dataclass."""

    def __init__(self, obj_name: Any) -> None:
        super().__init__(get_doc_object(obj_name))

    @property
    def doc_all_parameters(self) -> dict[str, Any]:
        """Parameters, and of a record its attributes but for computed ones."""
        named = super().doc_all_parameters
        if is_dataclass(self.obj):
            own = {field.name for field in fields(self.obj)}
            attributes = {n: d for n, d in self._doc_parameters(["Attributes"]).items() if n in own}
            # Parameters come first: numpydoc adds attributes by itself, without a word about them.
            named = named | {name: told for name, told in attributes.items() if name not in named}
        return named


def find_faults(thing: Any) -> Iterator[str]:
    """What is wrong with the docstring of a function, class or property; an override needs but a summary."""
    whole = not isinstance(thing, property) and not overrides(thing)
    codes = SUMMARY | SECTIONS if whole else SUMMARY
    yield from (f"{code}: {text}" for code, text in validate(thing, Docstring)["errors"] if code in codes)
    if whole:
        refused, told = raised_names(thing), {entry.type for entry in get_doc_object(thing)["Raises"]}
        if refused and not told:
            yield "no Raises section, though the body refuses something"
        elif unknown := {name for name in refused if name and not told & {name, "TilewrightError"}}:
            yield f"Raises does not name {', '.join(sorted(unknown))}"


def overrides(thing: Any) -> bool:
    """Whether a method, or how an error is made, is documented at a class that its own is derived from."""
    if inspect.isclass(thing):
        return issubclass(thing, Exception) and "__init__" not in vars(thing)
    owner = vars(sys.modules[thing.__module__]).get(thing.__qualname__.rpartition(".")[0])
    return inspect.isclass(owner) and any(hasattr(base, thing.__name__) for base in owner.__bases__)


def raised_names(thing: Any) -> set[str]:
    """The errors of this library that a body raises by name; "" stands for a call of a check."""
    bodies = [getattr(thing, "__init__", None), getattr(thing, "__post_init__", None)]
    names = set()
    for body in bodies if inspect.isclass(thing) else [thing]:
        if inspect.isfunction(body) and body.__code__.co_filename.startswith(str(SOURCE)):
            for node in ast.walk(ast.parse(textwrap.dedent(inspect.getsource(body)))):
                if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
                    name = ast.unparse(node.exc.func)
                    names |= set() if hasattr(builtins, name) else {name if name[0].isupper() else ""}
                elif isinstance(node, ast.Call) and ast.unparse(node.func).startswith("check_"):
                    names.add("")
    return names


def main() -> int:
    """Print one line for each fault; 1 where there are any."""
    faults = 0
    for name, thing in public_objects():
        place = inspect.getsourcefile(thing.fget if isinstance(thing, property) else thing)
        for fault in find_faults(thing):
            faults += 1
            print(f"{Path(str(place)).relative_to(SOURCE.parent.parent)}:{name}: {' '.join(fault.split())}")
    return int(faults > 0)


if __name__ == "__main__":
    sys.exit(main())
