"""What every job has: options, checked once by one table of clashes, an output, and what it gives back."""

import os
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, ClassVar, Generic, TypeVar

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

    Attributes
    ----------
    output : Path, optional
        What is written; by default a name that is `usual`, with a number where it is there already.
    force : bool, optional
        Whether what is there already under the output's name may be replaced; default False.

    Raises
    ------
    TilewrightError
        Options that clash, when the job is made; by `run`, what cannot be used, read or written.
    """

    output: Path | None = None
    force: bool = False

    RULES: ClassVar[tuple[Rule[Any], ...]] = ()

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
        defaults = {field.name: field.default for field in fields(self)}  # type: ignore[arg-type]
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
        if self.output is None and self.usual is not None and not self.force:
            return replace(self, output=find_free(self.usual))._run(progress)
        if self.output is not None and not self.force:
            self._keep(self.output)
        return self._run(progress)

    def _keep(self, output: Path) -> None:
        """Refuse to replace what is there, before any work."""
        if os.path.lexists(output):
            check_outside(output, output.resolve())
            raise is_there(output)

    @abstractmethod
    def _run(self, progress: Progress | None) -> Done:
        """Do the work, and write ``target``."""
