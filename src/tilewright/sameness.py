"""Whether two results hold the same, however they came about."""

from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np


class Alike:
    """A dataclass that equals another of its kind where both hold the same."""

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return _same_fields(self, other)

    def __hash__(self) -> int:
        # Content is too much to hash and may change; equal things have equal hashes, and that is enough.
        return hash(type(self))


def same(one: Any, other: Any) -> bool:
    """Tell whether two values hold the same: arrays to the last bit and with their types, and all in them.

    Parameters
    ----------
    one, other : any
        Arrays, dicts, lists, tuples, dataclasses of such, or plain values.

    Returns
    -------
    bool
        Whether they do; a NaN is the same as a NaN in an array.
    """
    if one is other:
        return True
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return _same_arrays(one, other)
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return list(one) == list(other) and all(same(one[key], other[key]) for key in one)
    if is_dataclass(one) and type(one) is type(other):
        return _same_fields(one, other)
    if isinstance(one, Sequence) and isinstance(other, Sequence) and not isinstance(one, str | bytes):
        return len(one) == len(other) and all(map(same, one, other))
    return bool(one == other)


def _same_fields(one: Any, other: Any) -> bool:
    return all(same(getattr(one, f.name), getattr(other, f.name)) for f in fields(one))


def _same_arrays(one: Any, other: Any) -> bool:
    if not (isinstance(one, np.ndarray) and isinstance(other, np.ndarray)):
        return False
    return one.dtype == other.dtype and np.array_equal(one, other, equal_nan=one.dtype.kind == "f")
