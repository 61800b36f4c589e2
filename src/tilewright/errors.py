"""The one family of errors this library raises, and the checks that raise them.

Every message names the argument, the value that came, what is allowed and what to do.
"""

import operator
from collections.abc import Callable
from typing import Any

Progress = Callable[[int, int, str], None]
"""Called as ``progress(done, total, what)`` during long work; raise `Cancelled` from it to stop."""


class TilewrightError(Exception):
    """Base of every error raised on purpose by tilewright."""


class TilewrightValueError(TilewrightError, ValueError):
    """An argument of the right type has a value that cannot be used."""


class TilewrightTypeError(TilewrightError, TypeError):
    """An argument has a type that cannot be used."""


class TilewrightFileError(TilewrightError, OSError):
    """A file or folder cannot be read or written, or does not hold what it should."""


class GpuError(TilewrightError, RuntimeError):
    """There is no GPU to draw with, it refused a program, or a material does not fit on it."""


class TilewrightWarning(UserWarning):
    """Something will work but is likely not what was wanted."""


class Cancelled(TilewrightError):
    """Raise this from a progress callback to stop long work; nothing half-made is left behind."""


def check_int(name: str, value: Any, low: int, high: int, advice: str = "") -> int:
    """``value`` as an int between ``low`` and ``high``, both included."""
    # Arrays of one number count as integers to Python, but not to what they are passed on to.
    if isinstance(value, bool) or (hasattr(value, "__array__") and hasattr(value, "__setitem__")):
        raise TilewrightTypeError(f"{name} must be an integer, not {brief(value)}")
    try:
        number = operator.index(value)
    except TypeError:
        raise TilewrightTypeError(f"{name} must be an integer, not {brief(value)}") from None
    if not low <= number <= high:
        hint = f"; {advice}" if advice else ""
        raise TilewrightValueError(f"{name} is {number}; allowed are {low} to {high}{hint}")
    return number


def check_real(name: str, value: Any, low: float, high: float) -> float:
    """``value`` as a finite float between ``low`` and ``high``, both included."""
    if isinstance(value, (bool, str, bytes)) or str(getattr(value, "dtype", "")) == "bool":
        raise TilewrightTypeError(f"{name} must be a number, not {brief(value)}")
    try:
        number = float(value)
    except OverflowError:
        raise TilewrightValueError(f"{name} is too large; allowed are {low} to {high}") from None
    except (TypeError, ValueError):
        raise TilewrightTypeError(f"{name} must be a number, not {brief(value)}") from None
    if not low <= number <= high:  # also catches NaN
        raise TilewrightValueError(f"{name} is {number}; allowed are {low} to {high}")
    return number


def check_progress(progress: Any) -> None:
    """Refuse what cannot be called, before the work begins."""
    if progress is not None and not callable(progress):
        raise TilewrightTypeError(f"progress must be a function or None, not {brief(progress)}")


def check_seed(value: Any) -> int:
    """A seed of 64 bits."""
    return check_int("seed", value, 0, 2**64 - 1)


def brief(value: Any) -> str:
    """A value as one short line."""
    words = " ".join(repr(value).split())
    return words if len(words) <= 80 else f"{words[:77]}..."


def check_choice(name: str, value: Any, choices: tuple[str, ...]) -> str:
    """``value`` if it is one of the words in ``choices``."""
    if not isinstance(value, str) or value not in choices:
        raise TilewrightValueError(f"{name} is {brief(value)}; allowed are {', '.join(choices)}")
    return str(value)
