"""Numbers as people write them, 1e6, 1,000, 4k or 144x48, before they are parsed as options."""

import inspect
import re
from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal
from typing import Any, NamedTuple, get_args

from tilewright.errors import TilewrightValueError

_NUMBER = re.compile(r"([+-]?)(\d[\d,_]*\.?\d*|\.\d+)(e[+-]?\d{1,2})?([kKmMgG]?)")
_GROUPED = re.compile(r"\d{1,3}([,_]\d{3})+(\.\d*)?")
_PAIR = re.compile(r"(\d+)[x,](\d+)")
_POWERS = {"": 0, "k": 1, "m": 2, "g": 3}


class _Numeric(NamedTuple):
    """What an option takes: how many numbers, whole ones or not, and what a thousand is."""

    pair: bool
    whole: bool
    thousand: int


def spell_numbers(arguments: Sequence[str], command: Callable[..., None]) -> Iterator[str]:
    """The arguments of a command with its numbers as a parser takes them.

    In pixels 4k is 4,096, as artists mean it; else k is a thousand.

    Raises
    ------
    TilewrightValueError
        What is no number, in its place.
    """
    known = _numeric_options(command)
    before, waiting = "", None
    for argument in arguments:
        flag, equals, value = argument.partition("=")
        if waiting is not None:
            yield from _spell(before, argument, waiting)
            waiting = None
        elif equals and flag in known and not known[flag].pair:
            yield f"{flag}={next(_spell(flag, value, known[flag]))}"
        else:
            yield argument
            before, waiting = argument, known.get(argument)


def _spell(option: str, text: str, kind: _Numeric) -> Iterator[str]:
    """One number, or the two of a pair."""
    if kind.pair and (pair := _PAIR.fullmatch(text)):
        yield from pair.groups()
        return
    found = _NUMBER.fullmatch(text)
    if found is None or (set(",_") & set(found[2]) and not _GROUPED.fullmatch(found[2])):
        yield _refuse_words(option, text, kind)
        return
    sign, digits, exponent, unit = found.groups()
    value = Decimal(f"{sign}{digits.replace(',', '').replace('_', '')}{exponent or ''}")
    value *= kind.thousand ** _POWERS[unit.lower()]
    if value == value.to_integral_value():
        yield f"{int(value)}"
    else:
        yield f"{value:f}" if not kind.whole else _refuse_words(option, text, kind)


def _refuse_words(option: str, text: str, kind: _Numeric) -> str:
    """The next option, and infinity, as they are; what is no number is refused."""
    if text.startswith("--") or (not kind.whole and text.lower().lstrip("+-") in ("inf", "nan")):
        return text
    what = "a whole number, as 4000, 1e6 or 4k" if kind.whole else "a number, as 0.5, 1e6 or 4k"
    what = "two whole numbers, as 144x48" if kind.pair else what
    raise TilewrightValueError(f"{option} is {text!r}; expected {what}")


def _numeric_options(command: Callable[..., None]) -> dict[str, _Numeric]:
    """The options of a command that take numbers, by their flags."""
    found: dict[str, _Numeric] = {}
    for name, parameter in inspect.signature(command).parameters.items():
        annotation, *rest = get_args(parameter.annotation) or (parameter.annotation,)
        annotation = next((kind for kind in get_args(annotation) if _is_pair(kind)), annotation)
        kinds = {k for k in (get_args(annotation) or (annotation,)) if k in (int, float)}
        if not kinds or list in (getattr(annotation, "__origin__", None),):
            continue
        told = rest[0] if rest else None
        pixels = "pixel" in (getattr(told, "help", None) or "")
        numeric = _Numeric(_is_pair(annotation), float not in kinds, 1024 if pixels else 1000)
        # The first positional of a typer.Option is its default, or in an annotation its first flag.
        named = (getattr(told, "default", None), *(getattr(told, "param_decls", None) or ()))
        flags = [flag for flag in named if isinstance(flag, str)] or [f"--{name.replace('_', '-')}"]
        found |= dict.fromkeys(flags, numeric)
    return found


def _is_pair(annotation: Any) -> bool:
    return getattr(annotation, "__origin__", None) is tuple
