"""Checks of what callers give; each raises one clear line that names the argument."""

import inspect
import operator
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.errors import TilewrightTypeError, TilewrightValueError


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


def check_function_of_place(name: str, given: Any) -> None:
    """Refuse a function that cannot be called with x and y, before the work begins."""
    try:
        signature = inspect.signature(given)
    except (TypeError, ValueError):  # some compiled functions do not tell
        return
    try:
        signature.bind("x", "y")
    except TypeError:
        raise TilewrightTypeError(
            f"{name} must be a function of two arrays, x and y; this one takes {brief_text(str(signature))}"
        ) from None


def brief(value: Any) -> str:
    """A value as one short line."""
    return brief_text(repr(value))


def brief_text(text: str) -> str:
    """A text as one short line."""
    words = " ".join(text.split())
    return words if len(words) <= 80 else f"{words[:77]}..."


def check_choice(name: str, value: Any, choices: tuple[str, ...]) -> str:
    """``value`` if it is one of the words in ``choices``."""
    if not isinstance(value, str) or value not in choices:
        raise TilewrightValueError(f"{name} is {brief(value)}; allowed are {', '.join(choices)}")
    return str(value)


def as_integers(name: str, given: ArrayLike) -> NDArray[Any]:
    """An array of integers that fit into int64, or one clear line."""
    try:
        values = np.asarray(given)
    except ValueError:
        raise TilewrightValueError(f"{name} is not a table of equally long rows") from None
    if values.size == 0 and values.dtype == np.float64:  # an empty list has no type of its own
        values = values.astype(np.int64)
    if values.dtype == object and all(isinstance(v, int) for v in values.flat):
        try:
            return values.astype(np.int64)
        except OverflowError:
            raise TilewrightValueError(
                f"{name} holds integers beyond 64 bits; allowed are -2^63 to 2^63 - 1"
            ) from None
    if values.dtype.kind not in "iu":
        raise TilewrightTypeError(f"{name} must hold integers, not {values.dtype}")
    if values.dtype == np.uint64 and values.size and values.max() >= 2**63:
        raise TilewrightValueError(f"{name} holds {values.max()}; allowed are -2^63 to 2^63 - 1")
    return values
