"""The one family of errors this library raises.

Every message names the argument, the value that came, what is allowed and what to do.
"""

from collections.abc import Callable

Progress = Callable[[int, int, str], None]
"""Called as ``progress(done, total, what)`` during long work; raise `Cancelled` from it to stop."""


class TilewrightError(Exception):
    """Base of every error raised on purpose by tilewright, so that one ``except`` catches them all."""


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
