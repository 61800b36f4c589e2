"""What every job has: options, checked once by one table of clashes, an output, and what it gives back."""

import os
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, ClassVar, Generic, Self, TypeVar

from tilewright.errors import Progress, TilewrightValueError
from tilewright.files.atomic import check_outside
from tilewright.jobs.outputs import find_free

J = TypeVar("J", bound="Job")


@dataclass(frozen=True)
class Done:
    """What a job has made.

    Attributes
    ----------
    files : tuple of Path
        Files and folders written.
    figures : dict
        What was measured or counted; plain numbers, texts, lists and dicts.
    sentence : str
        The same in words, for a person; a table where that says more.
    """

    files: tuple[Path, ...]
    figures: dict[str, Any]
    sentence: str


class Clash(TilewrightValueError):
    """Options that contradict each other, or one that would do nothing.

    The text names options in braces, so that each face can call them as its users do.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        super().__init__(text.format_map(_Named(str)))

    def told(self, name_of: Callable[[str], str] = str) -> str:
        """The message, with every option called ``name_of(option)``."""
        return self.text.format_map(_Named(name_of))

    def __reduce__(self) -> tuple[type["Clash"], tuple[str]]:
        return Clash, (self.text,)


def is_there(path: Path) -> Clash:
    """The refusal to replace what is there."""
    shown = str(path).replace("{", "{{").replace("}", "}}")
    return Clash(f"{shown} is there already; name another {{output}}, or give {{force}} to replace it")


class _Named(dict[str, str]):
    """Any name in braces, as a face calls it."""

    def __init__(self, name_of: Callable[[str], str]) -> None:
        super().__init__()
        self._name_of = name_of

    def __missing__(self, name: str) -> str:
        return self._name_of(name)


@dataclass(frozen=True)
class Rule(Generic[J]):
    """A row of a job's table of clashes: when it is broken, and what is then said."""

    broken: Callable[[J], Any]
    text: str


def useless(when: Callable[[J], Any], reason: str, *names: str) -> tuple[Rule[J], ...]:
    """A rule for each option that would do nothing in some case; ``reason`` says which."""

    def rule(name: str) -> Rule[J]:
        text = f"{{{name}}} has no use with {reason}; leave one of them out"
        return Rule(lambda job: when(job) and job.given(name), text)

    return tuple(rule(name) for name in names)


@dataclass(frozen=True, kw_only=True)
class Job(ABC):
    """A whole job: a frozen dataclass of options, checked when it is made, and `run`.

    Options that were not given are None, False or the default that is written at them.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    RULES: ClassVar[tuple[Rule[Any], ...]] = ()

    def __post_init__(self) -> None:
        for rule in self.RULES:
            if rule.broken(self):
                raise Clash(rule.text)

    def given(self, *names: str) -> bool:
        """Tell whether any of these options differs from its default.

        Parameters
        ----------
        *names : str
            Names of options.

        Returns
        -------
        bool
            Whether one of them was given.
        """
        defaults = {field.name: field.default for field in fields(self)}
        return any(getattr(self, name) != defaults[name] for name in names)

    def run(self, progress: Progress | None = None) -> Done:
        """Do the work.

        Parameters
        ----------
        progress : callable, optional
            ``progress(done, total, what)`` is called as the work goes on; raise `Cancelled` in it to stop.

        Returns
        -------
        Done
            Files, figures and a sentence.
        """
        return self._settled()._run(progress)

    def foresee(self) -> Done:
        """Say what `run` would write, and what that would cost, where this can be known; do nothing.

        Returns
        -------
        Done
            No files; figures and a sentence.

        Raises
        ------
        TilewrightError
            What is there already and may not be replaced.
        """
        return self._settled()._foresee()

    def _settled(self) -> Self:
        """Decide what is decided before any work."""
        return self

    @abstractmethod
    def _run(self, progress: Progress | None) -> Done:
        """Do the work."""

    def _foresee(self) -> Done:
        figures = self._costs()
        words = (f"{name.replace('_', ' ')} {value}" for name, value in figures.items())
        return Done((), figures, ", ".join(words) or "nothing would be written")

    def _costs(self) -> dict[str, Any]:
        """What is known of the job before it is done: the output, counts, sizes, seconds."""
        return {}


@dataclass(frozen=True, kw_only=True)
class WritingJob(Job):
    """A job with an output, which takes the place of nothing else but by ``force``.

    Attributes
    ----------
    output : Path, optional
        What is written; by default what `usual` says, with a number where that is there already.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    output: Path | None = None
    force: bool = False

    @property
    def usual(self) -> str | None:
        """The name of the output where none is given; None where nothing is written then."""
        return None

    @property
    def target(self) -> Path:
        """What is written.

        Raises
        ------
        TilewrightValueError
            Nothing is.
        """
        name = self.output or self.usual
        if name is None:
            raise TilewrightValueError("is missing; this job writes nothing without", argument="output")
        return Path(name)

    def _settled(self) -> Self:
        """Find a name for the output that may be written to."""
        if self.force:
            return self
        if self.output is not None:
            self._keep(self.output)
            return self
        return self if self.usual is None else replace(self, output=find_free(self.usual))

    def _keep(self, output: Path) -> None:
        """Refuse to replace what is there, before any work."""
        if os.path.lexists(output):
            check_outside(output, output.resolve())
            raise is_there(output)

    def _costs(self) -> dict[str, Any]:
        output = self.output or self.usual
        return {} if output is None else {"output": str(output)}
