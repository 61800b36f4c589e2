"""Run a tutorial from its first block to its last, and make the pictures that it shows.

`python tools/run_tutorials.py [NAME ...]` runs docs/tutorials/NAME.md, in an empty folder each, and puts what
the page shows of it under docs/images/tutorials/NAME. Blocks of Python share their names; lines of `sh` are
run by the program in this process; a block of `text` holds lines that the block before it prints, and `...`
in it stands for any others.
"""

import io
import os
import re
import shlex
import shutil
import sys
import tempfile
from contextlib import chdir, redirect_stdout
from pathlib import Path
from typing import Any

from tilewright.cli.main import run

DOCS = Path(__file__).parents[1] / "docs"
PAGES = {path.stem: path for path in sorted((DOCS / "tutorials").glob("*.md"))}
_NUMBER = re.compile(r"(?<![\w.])-?\d[\d,]*(?:\.\d+)?(?:e-?\d+)?(?![\w.])")
_SECONDS = re.compile(r"[\d.]+ s\b|seconds [\d.]+")
_CLOSE = 0.05
"""How far a number may be off that a page shows: figures may differ a little from system to system."""


def run_page(page: Path, folder: Path) -> None:
    """Run all blocks of a page in a folder."""
    names: dict[str, Any] = {"__name__": "page"}
    printed = ""
    with chdir(folder):
        for kind, block in re.findall(r"```(python|sh|text)\n(.*?)```", page.read_text("utf-8"), re.DOTALL):
            if kind == "text":
                check_lines(block, printed)
                continue
            said = io.StringIO()
            with redirect_stdout(said):
                if kind == "python":
                    exec(compile(block, page.name, "exec"), names)
                else:
                    run_lines(block)
            printed = said.getvalue()


def run_lines(block: str) -> None:
    """Run the commands of a block of shell, but for those that install."""
    for line in block.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if not words or words[:2] == ["pip", "install"]:
            continue
        if words[0] != "tilewright":
            raise ValueError(f"{line!r} is no command of tilewright")
        try:
            run(words[1:])
        except SystemExit as ended:
            if ended.code:
                raise RuntimeError(f"{line!r} ended with {ended.code}") from None


def check_lines(shown: str, printed: str) -> None:
    """Hold the lines that a page shows to those that were printed, in their order."""
    left = printed.splitlines()
    for line in shown.splitlines():
        if line != "...":
            while left and not agree(line, left[0]):
                left.pop(0)
            if not left:
                raise AssertionError(f"the page shows {line!r}; printed was:\n{printed}")
            left.pop(0)


def agree(shown: str, printed: str) -> bool:
    """Whether two lines have the same words, and numbers that are close; seconds may be any."""
    sides = [_SECONDS.sub("seconds", " ".join(line.split())) for line in (shown, printed)]
    words = [_NUMBER.sub("#", side) for side in sides]
    numbers = [[float(n.replace(",", "")) for n in _NUMBER.findall(side)] for side in sides]
    return words[0] == words[1] and all(
        abs(one - other) <= max(_CLOSE * abs(other), 0.02) for one, other in zip(*numbers, strict=True)
    )


def pictures(page: Path) -> list[Path]:
    """The pictures that a page shows of what it makes."""
    targets = re.findall(rf"\]\((\.\./images/tutorials/{page.stem}/[^)]+)\)", page.read_text("utf-8"))
    return [(page.parent / target).resolve() for target in targets]


def main(names: list[str]) -> None:
    """Run tutorials and keep their pictures."""
    for name in names or PAGES:
        with tempfile.TemporaryDirectory() as made:
            began = os.times()
            run_page(PAGES[name], Path(made))
            ended = os.times()
            for picture in pictures(PAGES[name]):
                picture.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(Path(made, picture.name), picture)
                print(f"{picture}: {picture.stat().st_size / 1000:.0f} KB")
        print(f"{name}: {ended.user + ended.system - began.user - began.system:.1f} s of processor time")


if __name__ == "__main__":
    main(sys.argv[1:])
