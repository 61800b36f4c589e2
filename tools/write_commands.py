"""Write a page for each command, docs/commands/NAME.md, and the table of them, from the commands themselves.

`python tools/write_commands.py` writes, `python tools/write_commands.py --check` says which page is old.
"""

import inspect
import re
import sys
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path
from types import UnionType
from typing import Any, NamedTuple, Union, get_args, get_origin

from tilewright import jobs
from tilewright.cli.main import COMMANDS

DOCS = Path(__file__).parents[1] / "docs"
OVERVIEW = DOCS / "command-line.md"
BEGIN, END = "<!-- the commands, by tools/write_commands.py -->", "<!-- end of the commands -->"
COMMON = ("--output", "--force", "--dry-run", "--quiet", "--json")
"""Options that most commands have, the last ones of each page."""
PAIRS = {"--y": "--x", "--height": "--width"}
"""Options that stand below another one, even where no example has them."""
TAKES = {Path: "path", int: "whole number", float: "number", str: "text"}
CHAPTERS = {
    "texture": ("textures", "materials", "tileset-folder", "tutorials/textures"),
    "render": ("tilings", "textures", "tutorials/textures"),
    "view": ("viewer", "gallery", "tutorials/textures"),
    "points": ("points", "samplers", "tutorials/sampling"),
    "surface": ("surfaces", "point-analysis"),
    "analyze": ("analysis", "point-analysis"),
    "compare": ("comparison", "point-analysis"),
    "pack": ("packing", "tutorials/makers"),
    "dapple": ("dappled", "tutorials/makers"),
    "bricks": ("bricks", "tutorials/makers"),
    "flow": ("flow", "dappled"),
    "aperiodic": ("aperiodic", "tutorials/makers"),
    "export": ("engines", "gpu", "tutorials/game-engine"),
    "info": ("tileset-folder", "jobs"),
    "warm": ("jobs",),
}
"""The pages that tell more of each command."""
_CODE = re.compile(
    r"(?<![\w-])--[a-z][a-z-]*"  # an option
    r"|\b[A-Z]+=[A-Z]+(?:,[A-Z])*\b|\b[HV]\d(?:\+\d)?=(?:\d|inf)\b"  # a pair of a name and what it gets
    r"|\b[A-Z]+\.[a-z]\w+|(?<![\w.])\.[a-z]\w+"  # a file, or the end of its name
    r"|# tilewright \{\.\.\.\}"
)


class Option(NamedTuple):
    """An option or an argument as a page shows it."""

    flags: tuple[str, ...]
    takes: str
    help: str
    positional: bool
    needed: bool

    @property
    def long(self) -> str:
        """The name it is known by."""
        return max(self.flags[0].split("/")[0], self.flags[-1].split("/")[0], key=len)

    def row(self) -> str:
        """A row of a table."""
        flags = ", ".join(f"`{flag}`" for flag in self.flags).replace("/", "` / `")
        return f"| {flags} | {cell(self.takes)} | {cell(self.help)} |"


def cell(text: str) -> str:
    """Text as a cell of a table: bars escaped; options and names and ends of files as code."""
    text = re.sub(_CODE, lambda found: f"`{found[0]}`", text)
    return text.replace("|", r"\|")


def options_of(command: Callable[..., None]) -> list[Option]:
    """What a command takes, as its annotations say, without what is hidden."""
    found = []
    for name, parameter in inspect.signature(command).parameters.items():
        kind, told = get_args(parameter.annotation)[:2]
        if getattr(told, "hidden", False):
            continue
        positional = type(told).__name__ == "ArgumentInfo"
        # The first positional of a typer.Option is its default, or in an annotation its first flag.
        named = (getattr(told, "default", None), *(getattr(told, "param_decls", None) or ()))
        flags = tuple(flag for flag in named if isinstance(flag, str))
        if positional:
            flags = (name.upper(),)
        elif not flags:
            long = f"--{name.replace('_', '-')}"
            flags = (f"{long}/--no-{long[2:]}" if kind is bool else long,)
        needed = parameter.default is inspect.Parameter.empty
        found.append(Option(flags, takes(kind, told.metavar), told.help, positional, needed))
    return found


def takes(kind: Any, metavar: str | None) -> str:
    """What stands after a flag, in words."""
    if get_origin(kind) in (Union, UnionType):
        (kind,) = (one for one in get_args(kind) if one is not type(None))
    if kind is bool:
        return "nothing"
    if get_origin(kind) is tuple:
        return metavar or f"two {TAKES[get_args(kind)[0]]}s"
    if get_origin(kind) is list:
        return f"{metavar or TAKES[get_args(kind)[0]]} (repeatable)"
    return metavar or TAKES[kind]


class Told(NamedTuple):
    """A command's docstring in parts."""

    sentence: str
    more: list[str]
    examples: list[str]
    calls: str


def told(command: Callable[..., None]) -> Told:
    """The parts of a command's docstring."""
    paragraphs = [" ".join(part.split()) for part in (inspect.getdoc(command) or "").split("\n\n")]
    examples = [part.removeprefix("Example: ") for part in paragraphs if part.startswith("Example: ")]
    (calls,) = (part for part in paragraphs if part.startswith("Calls "))
    more = [part for part in paragraphs[1:] if not part.startswith(("Example: ", "Calls "))]
    return Told(paragraphs[0], more, examples, calls)


def as_code(text: str) -> str:
    """A sentence with its calls, such as ``tw.direct(tiles, f(x))``, as code."""
    return "".join(f"`{part}`" if is_call else cell(part) for part, is_call in _parts(text))


def _parts(text: str) -> Iterator[tuple[str, bool]]:
    while found := re.search(r"[\w.]*\w\(", text):
        end, depth = found.end(), 1
        while depth:
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
            if not depth and (further := re.match(r"\.\w+\(", text[end:])):
                end, depth = end + further.end(), 1
        yield text[: found.start()], False
        yield text[found.start() : end], True
        text = text[end:]
    yield text, False


def functions(calls: str) -> list[str]:
    """Links to the reference of what a command calls, the job first."""
    import tilewright as tw

    names = dict.fromkeys(re.findall(r"\b(\w+)\b", calls))
    return [
        f"[`{name}`][tilewright.{'jobs.' if hasattr(jobs, name) and name.endswith('Job') else ''}{name}]"
        for name in names
        if (name.endswith("Job") and hasattr(jobs, name)) or name in tw.__all__
    ]


def page(name: str) -> str:
    """The page of a command."""
    command = COMMANDS[name]
    parts, options = told(command), options_of(command)
    words = " ".join(parts.examples).split()
    own = [one for one in options if not one.positional and one.long not in COMMON]
    shown = [one for one in own if {*one.flags, PAIRS.get(one.long)} & set(words)]
    ordered = [one for one in options if one.positional]
    ordered += [*shown, *(one for one in own if one not in shown)]
    common = [one for one in options if not one.positional and one.long in COMMON]
    usage = [one.flags[0] if one.needed else f"[{one.flags[0]}]" for one in options if one.positional]
    lines = [
        f"# tilewright {name}",
        f"*{parts.sentence}*",
        f"```sh\n{' '.join(['tilewright', name, *usage, '[OPTIONS]'])}\n```",
        *(wrap(cell(part)) for part in parts.more),
        "## Examples",
        "\n".join(["```sh", *parts.examples, "```"]),
        "## Options",
    ]
    if ordered:
        lines.append(table("option", ordered))
        lines.append("[Of most commands](../command-line.md):")
    else:
        lines.append("It has only those [of most commands](../command-line.md).")
    lines += [
        table("option", common),
        "## From Python",
        wrap(as_code(parts.calls)),
        wrap(f"In the reference: {', '.join(functions(parts.calls))}."),
        "[Whole jobs](../jobs.md) tells how a job is run.",
        "## More",
        "\n".join(f"- [{title(chapter)}](../{chapter}.md)" for chapter in CHAPTERS[name]),
    ]
    return "\n\n".join(lines) + "\n"


def wrap(text: str) -> str:
    """A paragraph in lines."""
    return textwrap.fill(text, 118, break_long_words=False, break_on_hyphens=False)


def table(head: str, options: list[Option]) -> str:
    """Options as a table."""
    return "\n".join([f"| {head} | takes | |", "|---|---|---|", *(option.row() for option in options)])


def title(chapter: str) -> str:
    """The heading of a page."""
    return (DOCS / f"{chapter}.md").read_text("utf-8").partition("\n")[0].removeprefix("# ")


def overview() -> str:
    """The overview, with the table of commands as they are."""
    before, begin, rest = OVERVIEW.read_text("utf-8").partition(BEGIN)
    _, end, after = rest.partition(END)
    if not (begin and end):
        sys.exit(f"{OVERVIEW} lacks the lines {BEGIN} and {END}")
    rows = [
        f"| [`tilewright {name}`](commands/{name}.md) | {cell(told(command).sentence)} |"
        for name, command in COMMANDS.items()
    ]
    return f"{before}{begin}\n\n" + "\n".join(["| command | |", "|---|---|", *rows]) + f"\n\n{end}{after}"


def pages() -> dict[Path, str]:
    """Every page that this tool makes, and the overview, with what they should hold."""
    return {DOCS / "commands" / f"{name}.md": page(name) for name in COMMANDS} | {OVERVIEW: overview()}


def old() -> list[str]:
    """The pages that are not as the commands are, and those without a command."""
    wanted = pages()
    held = {path: path.read_text("utf-8") for path in wanted if path.exists()}
    differing = [path for path, text in wanted.items() if held.get(path) != text]
    stray = [path for path in (DOCS / "commands").glob("*.md") if path not in wanted]
    return [path.relative_to(DOCS.parent).as_posix() for path in (*differing, *stray)]


if __name__ == "__main__":
    if "--check" in sys.argv:
        sys.exit(f"{', '.join(old())}: old; run tools/write_commands.py" if old() else 0)
    (DOCS / "commands").mkdir(exist_ok=True)
    for path, text in pages().items():
        path.write_text(text, "utf-8", newline="\n")
