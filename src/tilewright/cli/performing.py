"""How a command does its job: progress and notes on stderr, one line or one JSON object on stdout."""

import json
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from math import isfinite
from typing import Any

from tilewright.errors import Progress
from tilewright.kernels.compiling import Compiling

_BETWEEN = 10.0
"""Seconds from line to line where progress goes to a file or another program."""


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

    ``options`` are a command's parameters; ``json`` says how to print, ``quiet`` whether anything but errors
    goes to stderr, and ``dry_run`` that the job is only foretold.
    """
    from dataclasses import fields

    from tilewright import jobs

    kind = getattr(jobs, name)
    known = {field.name for field in fields(kind)}
    job = kind(**{option: value for option, value in options.items() if option in known})
    if options["quiet"]:
        silence()
    if options["dry_run"]:
        done = job.foresee()
    else:
        with progress_shown(options["quiet"]) as progress:
            done = job.run(progress)
    print(json.dumps(_finite(done.figures)) if options["json"] else visible(done.sentence))


def say(message: str) -> None:
    """Print a line of this program on stderr, where there is one."""
    if sys.stderr is not None:
        print(f"tilewright: {visible(' '.join(message.split()))}", file=sys.stderr, flush=True)


def visible(text: str) -> str:
    """A text in which nothing steers a terminal, as names of files may; lines stay."""
    return "".join(c if c.isprintable() or c == "\n" else repr(c)[1:-1] for c in text)


def silence() -> None:
    """Show no notes."""
    import warnings

    warnings.showwarning = lambda *given, **rest: None


def _finite(figures: dict[str, Any]) -> dict[str, Any]:
    """Figures as JSON holds them, which knows no infinity."""
    return {n: None if isinstance(v, float) and not isfinite(v) else v for n, v in figures.items()}


@contextmanager
def progress_shown(quiet: bool) -> Iterator[Progress]:
    """Progress on stderr: a bar on a terminal, a line now and then elsewhere; that kernels are compiled."""
    if quiet or sys.stderr is None:
        yield Ending.check
        return
    compiled, Compiling.announce = Compiling.seconds, _announce
    try:
        if sys.stderr.isatty():
            with _bar() as progress:
                yield progress
        else:
            yield _lines()
    finally:
        Compiling.announce = None
    if Compiling.seconds > compiled + 0.5:
        say(f"compiled in {Compiling.seconds - compiled:.1f} s, which is not counted below")


def _announce() -> None:
    say("compiling, once for this version")


class Pace:
    """How long a piece of work will still take, by how long it took so far."""

    def __init__(self) -> None:
        self._began, self._first, self._last, self._total = time.monotonic(), 0, 0, -1

    def left(self, done: int, total: int) -> str:
        """Tell in words what is left; nothing while that cannot be told.

        Work comes in parts of different pace; where another total or less that is done shows that one begins,
        it is measured anew.
        """
        now = time.monotonic()
        if total != self._total or done < self._last:
            self._began, self._first, self._total = now, done, total
        self._last = done
        spent, gained = now - self._began, done - self._first
        if spent < 2 or gained < max(1, 0.03 * total):
            return ""
        seconds = spent / gained * (total - done)
        return f"about {seconds:.0f} s left" if seconds < 90 else f"about {seconds / 60:.0f} minutes left"


def _lines() -> Progress:
    """Progress as lines, ten seconds apart."""
    pace, last = Pace(), time.monotonic()

    def update(done: int, total: int, what: str) -> None:
        nonlocal last
        Ending.check(done, total, what)
        left = pace.left(done, total)
        if time.monotonic() - last >= _BETWEEN:
            last = time.monotonic()
            say(", ".join(filter(None, (f"{what}: {done / total:.0%}" if total else what, left))))

    return update


@contextmanager
def _bar() -> Iterator[Progress]:
    """Progress as a bar on a terminal."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress as Bar, TaskProgressColumn, TextColumn

    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TaskProgressColumn(),
        TextColumn("{task.fields[left]}"),
    )
    with Bar(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=None, left="")
        pace = Pace()

        def update(done: int, total: int, what: str) -> None:
            Ending.check(done, total, what)
            bar.update(task, completed=done, total=total, description=what, left=pace.left(done, total))

        yield update
