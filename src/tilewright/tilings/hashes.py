"""Hash functions on the integer lattice: a color for every lattice point, without storing any."""

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int
from tilewright.seeds import check_seed
from tilewright.showing import describe
from tilewright.tiles.tileset import MOST_COLORS, slot_type
from tilewright.tilings.streams import COLORS, digits_of

Coordinates = NDArray[np.int64]
Colors = NDArray[np.unsignedinteger[Any]]

MULTIPLIERS = (0x21F0AAAD, 0xD35A2D97)
"""What the mixer multiplies by; shaders are filled from here, kernels repeat it."""
_START = (0x243F6A88, 0x85A308D3)
_WORD = 2**32


class LatticeHash(ABC):
    """Colors of lattice points of 1 to 3 dimensions, without storing any.

    A hash has any number of independent *streams*: two hash functions of one tiling are two streams.

    Attributes
    ----------
    name : str
        How messages and files call this kind of hash.
    period : int or None
        Lattice points along each axis after which it repeats; None where it does not.

    Notes
    -----
    Lagae 2007, section 3.4.
    """

    name: str
    period: int | None
    """Period along every axis, or None where there is none within 64-bit coordinates."""
    seed: Any

    def __repr__(self) -> str:
        return describe(self, f"seed {int(self.seed) % 2**64}")

    @abstractmethod
    def words(
        self, stream: int, x: ArrayLike, y: ArrayLike | None = None, z: ArrayLike | None = None
    ) -> NDArray[np.int64]:
        """Hash lattice points.

        Parameters
        ----------
        stream : int
            Which of the independent hashes, 0 to 2^32 - 1.
        x : array-like of int
            Coordinates, within 64 bits; all that are given are broadcast.
        y : array-like of int, optional
            Coordinates; by default 0.
        z : array-like of int, optional
            Coordinates; by default 0.

        Returns
        -------
        int64 array, shape of the coordinates
            Hash values, from 0 up to `range`.
        """

    @property
    @abstractmethod
    def range(self) -> int:
        """Number of values that `words` takes."""

    def colors(self, count: int, stream: int, *point: ArrayLike) -> Colors:
        """Give the colors of lattice points.

        Parameters
        ----------
        count : int
            Number of colors, 1 to 2^15.
        stream : int
            Which of the independent hashes, 0 to 2^32 - 1.
        *point : array-like of int
            Coordinates x (, y, z), within 64 bits; they are broadcast.

        Returns
        -------
        uint8 or uint16 array, shape of the coordinates
            Colors, from 0 up to ``count``; uint16 for more than 256.

        Notes
        -----
        The word modulo ``count`` where that divides `range` (Lagae 2007, section 3.4.2.4), else a number from
        several words, so that all colors are equally likely.
        """
        if self.range % count_colors(count) == 0:
            return (self.words(stream, *point) % count).astype(slot_type((count,)))
        return ((self.numbers(stream, *point) * count) >> 24).astype(slot_type((count,)))

    def grid(self, count: int, stream: int, *axes: Coordinates) -> Colors:
        """Give the colors of a grid of lattice points.

        Parameters
        ----------
        count : int
            Number of colors, 1 to 2^15.
        stream : int
            Which of the independent hashes, 0 to 2^32 - 1.
        *axes : int64 array
            Columns x (, rows y, layers z), one array for each axis.

        Returns
        -------
        uint8 or uint16 array, shape (len(x),), (len(y), len(x)) or (len(z), len(y), len(x))
            Colors, from 0 up to ``count``.
        """
        return self.colors(count, stream, *as_grid(axes))

    def numbers(self, stream: int, *point: ArrayLike) -> NDArray[np.int64]:
        """Give numbers of 24 bits at lattice points: several values in one where a hash has few.

        Parameters
        ----------
        stream : int
            Which of the independent hashes, 0 to 2^32 - 1.
        *point : array-like of int
            Coordinates x (, y, z), within 64 bits; they are broadcast.

        Returns
        -------
        int64 array, shape of the coordinates
            Numbers, from 0 up to 2^24.
        """
        digits = 1
        while self.range**digits < 2**24:
            digits += 1
        total: NDArray[np.int64] = np.zeros((), np.int64)
        for digit in digits_of(stream, digits):
            total = total * self.range + self.words(digit, *point)
        return total * 2**24 // self.range**digits


class MixerHash(LatticeHash):
    """The default hash: a mixer without tables, made of 32-bit operations, alike in Python, GLSL and WGSL.

    It has no period: every cell within 64-bit coordinates and every 64-bit seed is hashed on its own.

    Parameters
    ----------
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.

    Raises
    ------
    TilewrightTypeError
        The seed is not an integer.
    TilewrightValueError
        It is out of range.

    Notes
    -----
    Our own, not from the papers; ``docs/hashes.md`` defines it.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.MixerHash(7).colors(4, 0, [-1, 0, 1], 10**12).tolist()
    [0, 1, 1]
    """

    name = "mixer"
    period = None

    def __init__(self, seed: int = 0) -> None:
        self.seed = np.uint64(check_seed(seed)).astype(np.int64)

    @property
    def range(self) -> int:
        """Number of values that `words` takes: 2^32."""
        return 2**32

    def start(self, x_high: int, y_high: int, stream: int = COLORS) -> tuple[int, int]:
        """Give the state that shaders start with: after everything but the low words of y and x, at z = 0.

        Parameters
        ----------
        x_high : int
            High word of x, modulo 2^32.
        y_high : int
            High word of y, modulo 2^32.
        stream : int, optional
            Which of the independent hashes, 0 to 2^32 - 1; default 0.

        Returns
        -------
        tuple of (int, int)
            The state (a, b), two words of 32 bits.
        """
        a, b = _START
        seed = int(self.seed)
        for word in (stream, seed % _WORD, (seed >> 32) % _WORD, 0, 0, x_high % _WORD, y_high % _WORD):
            a = _mix(a ^ word)
            b = _mix(((b ^ a) + word) % _WORD)
        return a, b

    def words(
        self, stream: int, x: ArrayLike, y: ArrayLike | None = None, z: ArrayLike | None = None
    ) -> NDArray[np.int64]:
        """Hash lattice points, from 0 up to 2^32; see `LatticeHash.words`."""
        from tilewright.kernels.lattice import fill_words

        points = np.broadcast_arrays(*check_point(stream, x, y, z))
        out = np.empty(points[0].size, np.uint32)
        fill_words(out.size, *(np.array(p).ravel() for p in points), stream, self.seed, out)
        return out.astype(np.int64).reshape(points[0].shape)

    def colors(self, count: int, stream: int, *point: ArrayLike) -> Colors:
        """Give the colors of lattice points, by the upper 24 bits of words; see `LatticeHash.colors`."""
        numbers = self.words(stream, *point) >> 8
        return ((numbers * count_colors(count)) >> 24).astype(slot_type((count,)))

    def grid(self, count: int, stream: int, *axes: Coordinates) -> Colors:
        """Give the colors of a grid of lattice points, in compiled loops; see `LatticeHash.grid`."""
        from tilewright.kernels.lattice import fill_colors

        if count > 256:  # the kernel counts in bytes
            return super().grid(count, stream, *axes)

        zero = np.zeros(1, np.int64)
        x, y, z = (*axes, zero, zero)[:3]
        out = np.empty((len(z), len(y), len(x)), np.uint8)
        for layer, at in zip(out, z, strict=True):
            fill_colors(len(y), *split_row(x), y, at, stream, self.seed, np.uint32(count), layer)
        return out.reshape(tuple(len(axis) for axis in reversed(axes)))

    def numbers(self, stream: int, *point: ArrayLike) -> NDArray[np.int64]:
        """Give the upper 24 bits of the words of lattice points; see `LatticeHash.numbers`."""
        return self.words(stream, *point) >> 8


def _mix(h: int) -> int:
    h ^= h >> 16
    h = h * MULTIPLIERS[0] % _WORD
    h ^= h >> 15
    h = h * MULTIPLIERS[1] % _WORD
    return h ^ h >> 15


def count_colors(count: int) -> int:
    """A number of colors a hash can give."""
    return check_int("count", count, 1, MOST_COLORS)


def check_point(
    stream: int, x: ArrayLike, y: ArrayLike | None, z: ArrayLike | None
) -> tuple[Coordinates, Coordinates, Coordinates]:
    """Coordinates of lattice points as int64; those not given are 0."""
    check_int("stream", stream, 0, 2**32 - 1)
    named = zip("xyz", (x, y, z), strict=True)
    found = [as_integers(name, 0 if c is None else c).astype(np.int64) for name, c in named]
    return found[0], found[1], found[2]


def split_row(x: Coordinates) -> tuple[NDArray[np.uint32], NDArray[np.int64], NDArray[np.int64]]:
    """Low words of a row of coordinates, where runs of one high word start and end, and those words."""
    high = x >> 32
    starts = np.concatenate([[0], np.flatnonzero(np.diff(high)) + 1])
    return x.astype(np.uint32), np.append(starts, len(x)), high[starts]


def as_grid(axes: tuple[Coordinates, ...]) -> tuple[Coordinates, ...]:
    """Coordinates along x (, y, z), shaped so that they broadcast to an array (z, y, x)."""
    return tuple(np.expand_dims(axis, tuple(range(1, n + 1))) for n, axis in enumerate(axes))
