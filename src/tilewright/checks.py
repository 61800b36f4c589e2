"""Checks of what callers give; each raises one clear line that names the argument."""

import inspect
import operator
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.errors import TilewrightTypeError, TilewrightValueError, brief, brief_text

T = TypeVar("T")

_INT64 = "-2^63 to 2^63 - 1"


def check_type(name: str, value: Any, kind: type[T] | tuple[type[T], ...], noun: str, advice: str = "") -> T:
    """``value`` if it is of a ``kind``, which ``noun`` calls by its name, with its article."""
    if not isinstance(value, kind):
        raise TilewrightTypeError(
            f"must be {noun}, not {type(value).__name__}",
            argument=name,
            value=value,
            allowed=noun,
            advice=advice,
        )
    return value


def check_flag(name: str, value: Any) -> None:
    """Refuse what is neither True nor False."""
    if not isinstance(value, (bool, np.bool_)):
        raise type_error(name, value, "True or False")


def check_int(name: str, value: Any, low: int, high: int, advice: str = "") -> int:
    """``value`` as an int between ``low`` and ``high``, both included."""
    # Arrays of one number count as integers to Python, but not to what they are passed on to.
    if isinstance(value, bool) or (hasattr(value, "__array__") and hasattr(value, "__setitem__")):
        raise type_error(name, value, "an integer")
    try:
        number = operator.index(value)
    except TypeError:
        raise type_error(name, value, "an integer") from None
    if not low <= number <= high:
        raise TilewrightValueError(argument=name, value=number, allowed=f"{low} to {high}", advice=advice)
    return number


def check_real(name: str, value: Any, low: float, high: float) -> float:
    """``value`` as a finite float between ``low`` and ``high``, both included."""
    if isinstance(value, (bool, str, bytes)) or str(getattr(value, "dtype", "")) == "bool":
        raise type_error(name, value, "a number")
    allowed = f"{low} to {high}"
    try:
        number = float(value)
    except OverflowError:
        raise TilewrightValueError(
            f"is too large; allowed are {allowed}", argument=name, value=value, allowed=allowed
        ) from None
    except (TypeError, ValueError):
        raise type_error(name, value, "a number") from None
    if not low <= number <= high:  # also catches NaN
        raise TilewrightValueError(argument=name, value=number, allowed=allowed)
    return number


def check_progress(progress: Any) -> None:
    """Refuse what cannot be called, before the work begins."""
    if progress is not None and not callable(progress):
        raise type_error("progress", progress, "a function or None")


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
            f"must be a function of two arrays, x and y; this one takes {brief_text(str(signature))}",
            argument=name,
            value=given,
            allowed="a function of two arrays, x and y",
        ) from None


def check_choice(name: str, value: Any, choices: tuple[str, ...]) -> str:
    """``value`` if it is one of the words in ``choices``."""
    if not isinstance(value, str) or value not in choices:
        raise TilewrightValueError(argument=name, value=value, allowed=", ".join(choices))
    return str(value)


def type_error(name: str, value: Any, allowed: str, advice: str = "") -> TilewrightTypeError:
    """The error of a value that is of another kind than ``allowed``."""
    return TilewrightTypeError(
        f"must be {allowed}, not {brief(value)}", argument=name, value=value, allowed=allowed, advice=advice
    )


def shape_error(name: str, shape: tuple[int, ...], expected: object) -> TilewrightValueError:
    """The error of an array of another shape than ``expected``, a tuple or words."""
    return TilewrightValueError(
        f"has shape {shape}; expected {expected}", argument=name, value=shape, allowed=str(expected)
    )


def range_error(name: str, values: NDArray[Any], allowed: str) -> TilewrightValueError:
    """The error of an array some of whose values are not ``allowed``."""
    low, high = values.min(), values.max()
    return TilewrightValueError(
        f"holds {low} to {high}; allowed are {allowed}", argument=name, value=(low, high), allowed=allowed
    )


def as_array(name: str, given: ArrayLike) -> NDArray[Any]:
    """An array, or one clear line where rows differ in length."""
    try:
        return np.asarray(given)
    except ValueError:
        raise TilewrightValueError("is not a table of equally long rows", argument=name) from None


def as_integers(name: str, given: ArrayLike) -> NDArray[Any]:
    """An array of integers that fit into int64, or one clear line."""
    values = as_array(name, given)
    if values.size == 0 and values.dtype == np.float64:  # an empty list has no type of its own
        values = values.astype(np.int64)
    if values.dtype == object and all(isinstance(v, int) for v in values.flat):
        try:
            return values.astype(np.int64)
        except OverflowError:
            raise TilewrightValueError(
                f"holds integers beyond 64 bits; allowed are {_INT64}", argument=name, allowed=_INT64
            ) from None
    if values.dtype.kind not in "iu":
        raise TilewrightTypeError(
            f"must hold integers, not {values.dtype}", argument=name, value=values.dtype, allowed="integers"
        )
    if values.dtype == np.uint64 and values.size and (most := values.max()) >= 2**63:
        raise TilewrightValueError(
            f"holds {most}; allowed are {_INT64}", argument=name, value=int(most), allowed=_INT64
        )
    return values


def as_cells(given: ArrayLike) -> NDArray[Any]:
    """The integers of cells in rows and columns, at least one of each."""
    cells = as_integers("cells", given)
    if cells.ndim != 2 or cells.size == 0:
        allowed = "(height, width), neither 0"
        raise TilewrightValueError(
            f"have shape {cells.shape}; expected {allowed}",
            argument="cells",
            value=cells.shape,
            allowed=allowed,
        )
    return cells


def check_out(out: Any, fits: Callable[[NDArray[Any]], bool], expected: str) -> NDArray[Any]:
    """``out`` if it ``fits``, lies in one piece and can be written to."""
    if type(out) is not np.ndarray:
        raise TilewrightTypeError(
            f"must be an array, not {type(out).__name__}", argument="out", value=out, allowed="an array"
        )
    if not (fits(out) and out.flags.c_contiguous and out.flags.writeable):
        raise TilewrightValueError(
            f"is {out.dtype} {out.shape}, C-contiguous: {out.flags.c_contiguous}, writable: "
            f"{out.flags.writeable}; expected {expected}, C-contiguous and writable",
            argument="out",
            allowed=f"{expected}, C-contiguous and writable",
        )
    return out
