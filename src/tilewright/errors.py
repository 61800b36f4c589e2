"""The one family of errors this library raises.

Every message names the argument, the value that came, what is allowed and what to do. An error also holds
these as attributes, so that a face of the library can name the argument in its own way.
"""

import pickle
from collections.abc import Callable
from typing import Any

Progress = Callable[[int, int, str], None]
"""Called as ``progress(done, total, what)`` during long work; raise `Cancelled` from it to stop."""


class TilewrightError(Exception):
    """Base of every error raised on purpose by tilewright.

    Parameters
    ----------
    problem : str
        What is wrong, without the argument's name and without advice: "is 7; it must be even". Where it is
        left out and ``allowed`` is given, it is made from ``value`` and ``allowed``.
    argument : str
        The argument as the library calls it, or a part of one, as ``points[3]`` and ``map 'albedo'``; empty
        where the trouble is with no single argument.
    value : object
        What came, or what the message says of it.
    allowed : str
        What can be used instead.
    advice : str
        What to do.
    """

    def __init__(
        self, problem: str = "", *, argument: str = "", value: Any = None, allowed: str = "", advice: str = ""
    ) -> None:
        if not problem and allowed:
            problem = f"is {brief(value)}; allowed are {allowed}"
        self.problem = problem
        self.argument = argument
        self.value = value
        self.allowed = allowed
        self.advice = advice
        super().__init__(self.told())

    def told(self, name_of: Callable[[str], str] = str) -> str:
        """Tell what is wrong, with the argument as a face of the library calls it.

        Parameters
        ----------
        name_of : callable, optional
            From the argument's name in the library to its name there; by default it stays.

        Returns
        -------
        str
            One line.
        """
        name = name_of(self.argument) if self.argument else ""
        hint = f"; {self.advice}" if self.advice else ""
        return " ".join(filter(None, (name, self.problem))) + hint

    def __reduce__(self) -> tuple[Any, ...]:
        """Travel between processes, in words where the value itself cannot."""
        state = dict(self.__dict__)
        try:
            pickle.dumps(self.value)
        except Exception:  # whatever a value's own pickling raises
            state["value"] = brief(self.value)
        return type(self), (str(self),), state


class TilewrightValueError(TilewrightError, ValueError):
    """An argument of the right type has a value that cannot be used."""


class TilewrightTypeError(TilewrightError, TypeError):
    """An argument has a type that cannot be used."""


class TilewrightFileError(TilewrightError, OSError):
    """A file or folder cannot be read or written, or does not hold what it should."""


class GpuError(TilewrightError, RuntimeError):
    """There is no GPU to draw with, it refused a program, or a material does not fit on it."""


class TilewrightWarning(UserWarning):
    """Something will work but is likely not what was wanted; shown by Python's ``warnings``."""


class Cancelled(TilewrightError):
    """Raise this from a progress callback to stop long work; nothing half-made is left behind."""


def brief(value: Any) -> str:
    """A value as one short line."""
    return brief_text(repr(value))


def brief_text(text: str) -> str:
    """A text as one short line."""
    words = " ".join(text.split())
    return words if len(words) <= 80 else f"{words[:77]}..."
