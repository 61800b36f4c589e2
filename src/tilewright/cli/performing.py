"""How a command does its job: progress on stderr, one line or one JSON object on stdout."""

import json
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from math import isfinite
from typing import Any

from tilewright.errors import Progress


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


def perform(name: str, options: Mapping[str, Any]) -> None:
    """Do the job of that name in `tilewright.jobs`, with a command's options, and print what came of it.

    ``options`` are a command's parameters; ``json`` says how to print. Options that a job does not know, such
    as the seed of construction where nothing is constructed, do nothing.
    """
    from dataclasses import fields

    from tilewright import jobs

    kind = getattr(jobs, name)
    known = {field.name for field in fields(kind)}
    job = kind(**{option: value for option, value in options.items() if option in known})
    with progress_bar() as progress:
        done = job.run(progress)
    print(json.dumps(_finite(done.figures)) if options["json"] else done.sentence)


def _finite(figures: dict[str, Any]) -> dict[str, Any]:
    """Figures as JSON holds them, which knows no infinity."""
    return {n: None if isinstance(v, float) and not isfinite(v) else v for n, v in figures.items()}


@contextmanager
def progress_bar() -> Iterator[Progress]:
    """A progress bar on stderr; nothing where stderr is no terminal, or where there is none."""
    if sys.stderr is None or not sys.stderr.isatty():
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
