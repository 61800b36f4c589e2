"""Seeds: what chance is made from, always passed in."""

from typing import Any

import numpy as np

from tilewright.checks import check_int, type_error

Seed = int | np.random.Generator


def check_seed(value: Any) -> int:
    """A seed of 64 bits; of a generator its next one."""
    if isinstance(value, np.random.Generator):
        return int(value.integers(0, 2**64, dtype=np.uint64))
    if value is None:
        raise type_error("seed", value, "a whole number or a numpy Generator", "chance is always passed in")
    return check_int("seed", value, 0, 2**64 - 1)


def make_key(seed: Seed) -> np.uint64:
    """The key of a kernel's counter-based numbers, from a seed 0 to 2^64 - 1 or a generator."""
    return np.uint64(check_seed(seed))


def derive_key(key: np.uint64, *path: int) -> np.uint64:
    """A key for one piece of work, as told by its numbers; different paths give unrelated keys."""
    state = int(key)
    for number in path:
        state = _mix(state ^ _mix(number + 1))
    return np.uint64(state)


def _mix(word: int) -> int:
    """SplitMix64's output function (Steele, Lea & Flood 2014) of the next state."""
    word = (word + 0x9E3779B97F4A7C15) % 2**64
    word = (word ^ word >> 30) * 0xBF58476D1CE4E5B9 % 2**64
    word = (word ^ word >> 27) * 0x94D049BB133111EB % 2**64
    return word ^ word >> 31
