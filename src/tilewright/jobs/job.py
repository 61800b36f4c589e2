"""What every job has: options that are checked once, by one table of clashes, and what it gives back."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, ClassVar, Generic, TypeVar

from tilewright.errors import Progress, TilewrightValueError

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
        defaults = {field.name: field.default for field in fields(self)}  # type: ignore[arg-type]
        return any(getattr(self, name) != defaults[name] for name in names)

    @abstractmethod
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
