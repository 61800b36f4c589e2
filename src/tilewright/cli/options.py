"""What several commands share: options, progress on stderr, one JSON object on stdout."""

import json
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from math import inf, isfinite
from pathlib import Path
from typing import Annotated, Any

import typer

from tilewright.errors import Progress, TilewrightValueError

Folder = Annotated[
    Path, typer.Argument(help="A tile-set folder made by `tilewright texture`.", show_default=False)
]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON object of the figures on stdout.")]
Seed = Annotated[int, typer.Option("--seed", help="Seed of construction.")]
LatticeSeed = Annotated[int, typer.Option("--lattice-seed", help="Seed of the direct tiling.")]
Map = Annotated[str | None, typer.Option("--map", help="Which map; the main one by default.")]


def report(figures: dict[str, Any], as_json: bool, text: str) -> None:
    """Print what a command did: figures for programs, or a line for people."""
    finite = {n: None if isinstance(v, float) and not isfinite(v) else v for n, v in figures.items()}
    print(json.dumps(finite) if as_json else text)


class Ending:
    """Whether a signal asked the program to end.

    The exception a signal raises is lost when it meets a callback of a C library, so long work asks here.
    """

    asked = False

    @classmethod
    def ask(cls, number: int, frame: object) -> None:
        """Handle a signal: end as an interrupt does, so that what is half-written is removed."""
        if cls.asked:
            return  # it is ending already
        cls.asked = True
        raise KeyboardInterrupt

    @classmethod
    def check(cls, done: int, total: int, what: str) -> None:
        """Progress that shows nothing and ends where that was asked for."""
        if cls.asked:
            raise KeyboardInterrupt


@contextmanager
def progress_bar() -> Iterator[Progress]:
    """A progress bar on stderr; nothing where stderr is not a terminal."""
    if not sys.stderr.isatty():
        yield Ending.check
        return
    from rich.console import Console
    from rich.progress import Progress as Bar

    with Bar(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=None)

        def update(done: int, total: int, what: str) -> None:
            Ending.check(done, total, what)
            bar.update(task, completed=done, total=total, description=what)

        yield update


def parse_limits(given: list[str]) -> dict[str, int | float]:
    """``--limit NAME=NUMBER`` as limits of runs; the number may be inf."""
    limits: dict[str, int | float] = {}
    for name, most in parse_pairs("--limit", given).items():
        if most != "inf" and not (most.isascii() and most.isdigit() and len(most) < 10):
            raise TilewrightValueError(f"--limit {name} is {most!r}; allowed are 0, 1, 2, ... and inf")
        limits[name] = inf if most == "inf" else int(most)
    return limits


def parse_pairs(option: str, given: list[str]) -> dict[str, str]:
    """``NAME=VALUE`` pairs as a dict."""
    pairs = {}
    for item in given:
        name, equals, value = item.partition("=")
        if not (name and equals and value):
            raise TilewrightValueError(f"{option} is {item!r}; expected NAME=VALUE")
        if name in pairs:
            raise TilewrightValueError(f"{option} names {name!r} twice")
        pairs[name] = value
    return pairs
