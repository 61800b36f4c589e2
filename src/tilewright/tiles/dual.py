"""Dual tiles: tiles of any number of corners that may be turned, and how many of them there are.

A corner has one of C colors and is turned by o quarters. In the tile that lies in its quadrant q it shows
slot 4 c + (o - q) mod 4. Tiles that are turns of each other are one: the one whose slots are least is listed.
"""

from math import gcd

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int, shape_error
from tilewright.errors import TilewrightValueError

_MOST_CORNERS, _MOST_COLORS = 64, 64
_MOST_LISTED = 1_000_000


def count_dual_tiles(corners: int, colors: int) -> int:
    """Count the tiles of so many corners that are not turns of each other.

    Parameters
    ----------
    corners : int
        Corners of a tile n, 1 to 64.
    colors : int
        Colors of a corner C, 1 to 64.

    Returns
    -------
    int
        The number of orbits of (4 C)^n words under rotation.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        Numbers that are no integers or out of range.

    Notes
    -----
    Li et al. 2010, section III.D and table I; by the lemma of Cauchy and Frobenius.

    Examples
    --------
    >>> import tilewright as tw
    >>> [tw.count_dual_tiles(n, colors=2) for n in (3, 4, 5)]
    [176, 1044, 6560]
    """
    n = check_int("corners", corners, 1, _MOST_CORNERS)
    slots = 4 * check_int("colors", colors, 1, _MOST_COLORS)
    return sum(slots ** gcd(turn, n) for turn in range(n)) // n


def list_dual_tiles(corners: int, colors: int) -> NDArray[np.int64]:
    """List the tiles of so many corners that are not turns of each other.

    Parameters
    ----------
    corners : int
        Corners of a tile n, 1 to 64.
    colors : int
        Colors of a corner C, 1 to 64.

    Returns
    -------
    int64 array, shape (k, n)
        Their slots, each the least of its turns, in rising order.

    Raises
    ------
    TilewrightTypeError
        Numbers that are no integers.
    TilewrightValueError
        Numbers out of range, or more than a million tiles.
    """
    count = count_dual_tiles(corners, colors)
    if count > _MOST_LISTED:
        raise TilewrightValueError(
            f"is {corners}; that makes {count:,} tiles, of at most {_MOST_LISTED:,}",
            argument="corners",
            value=corners,
        )
    # Step 1: words in rising order, a slot longer each time, of which only beginnings of least words stay.
    words = np.arange(4 * colors)[:, np.newaxis]
    for length in range(2, corners + 1):
        words = np.concatenate(
            [
                np.repeat(words, 4 * colors, axis=0),
                np.tile(np.arange(4 * colors), len(words))[:, np.newaxis],
            ],
            axis=1,
        )
        words = words[_may_begin(words, length)]
    # Step 2: of these the words that no turn makes less.
    return words[canonical_slots(words)[1] == 0]


def _may_begin(words: NDArray[np.int64], length: int) -> NDArray[np.bool_]:
    """Which words may be the beginning of one that is the least of its turns: no later part is less."""
    good = np.ones(len(words), bool)
    for turn in range(1, length):
        part = words[:, turn:] - words[:, : length - turn]
        good &= ~_begins_below(part)
    return good


def _begins_below(part: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Whether the first number of each row that is not 0 is below 0."""
    first = np.argmax(part != 0, axis=1)
    below: NDArray[np.bool_] = part[np.arange(len(part)), first] < 0
    return below


def canonical_slots(slots: ArrayLike) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Turn tiles so that their slots are the least of all turns.

    Parameters
    ----------
    slots : array_like of int, shape (m, n)
        Slots of m tiles of n corners, counter-clockwise.

    Returns
    -------
    words : int64 array, shape (m, n)
        The same tiles turned.
    turns : int64 array, shape (m,)
        By how many corners: ``words[i]`` is ``np.roll(slots[i], -turns[i])``; the least such number.

    Raises
    ------
    TilewrightTypeError
        Something else than integers.
    TilewrightValueError
        An array of another shape.
    """
    given = as_integers("slots", slots).astype(np.int64)
    if given.ndim != 2 or given.shape[1] == 0:
        raise shape_error("slots", given.shape, "(m, n), with n at least 1")
    n = given.shape[1]
    turns = np.zeros(len(given), np.int64)
    doubled = np.concatenate([given, given], axis=1)
    rows = np.arange(len(given))[:, np.newaxis]
    steps = np.arange(n)
    words = given
    for turn in range(1, n):
        turned = doubled[:, turn : turn + n]
        less = _begins_below(turned - words)
        turns[less] = turn
        words = np.where(less[:, np.newaxis], turned, words)
    return doubled[rows, turns[:, np.newaxis] + steps], turns
