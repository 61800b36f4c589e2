"""Hash functions on the integer lattice: a color for every lattice point, without storing any."""

from abc import ABC, abstractmethod
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.seeds import check_seed
from tilewright.showing import describe
from tilewright.tiles.tileset import MOST_COLORS, slot_type

Coordinates = NDArray[np.int64]
Colors = NDArray[np.unsignedinteger[Any]]

MULTIPLIERS = (0x21F0AAAD, 0xD35A2D97)
"""What the mixer multiplies by; shaders are filled from here, kernels repeat it."""
_START = (0x243F6A88, 0x85A308D3)
_WORD = 2**32


class LatticeHash(ABC):
    """Colors of lattice points of 1 to 3 dimensions.

    A hash has any number of independent *streams*: two hash functions of one tiling are two streams.
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
        """Hash values at lattice points, 0 up to `range`; the coordinates given are broadcast."""

    @property
    @abstractmethod
    def range(self) -> int:
        """How many values `words` takes."""

    def colors(self, count: int, stream: int, *point: ArrayLike) -> Colors:
        """Colors 0 up to ``count`` at lattice points x (, y, z); the coordinates are broadcast.

        They are uint8, or uint16 for more than 256 colors: the word modulo ``count`` where that divides
        `range` (Lagae 2007, section 3.4.2.4), else a number from several words, so that all colors are alike.
        """
        if self.range % count_colors(count) == 0:
            return (self.words(stream, *point) % count).astype(slot_type((count,)))
        return ((self.numbers(stream, *point) * count) >> 24).astype(slot_type((count,)))

    def grid(self, count: int, stream: int, *axes: Coordinates) -> Colors:
        """Colors of the grid of columns x (, rows y, layers z), shape (len(x),) to (z, y, x)."""
        return self.colors(count, stream, *as_grid(axes))

    def numbers(self, stream: int, *point: ArrayLike) -> NDArray[np.int64]:
        """Numbers 0 up to 2^24 at lattice points: several values in one where a hash has few."""
        digits = 1
        while self.range**digits < 2**24:
            digits += 1
        total: NDArray[np.int64] = np.zeros((), np.int64)
        for digit in range(digits):
            total = total * self.range + self.words(stream + 16 * digit, *point)
        return total * 2**24 // self.range**digits


class MixerHash(LatticeHash):
    """The default: a table-free mixer made of 32-bit operations, alike in Python, GLSL and WGSL.

    It has no period: every cell within 64-bit coordinates and every 64-bit seed is hashed on its own.
    Its definition is in ``docs/hashes.md``.
    """

    name = "mixer"
    period = None

    def __init__(self, seed: int = 0) -> None:
        self.seed = np.uint64(check_seed(seed)).astype(np.int64)

    @property
    def range(self) -> int:
        return 2**32

    def start(self, x_high: int, y_high: int, stream: int = 0) -> tuple[int, int]:
        """The state (a, b) after everything but the low words of y and x, at z = 0: what shaders start with.

        ``x_high`` and ``y_high`` are the high words of the coordinates, modulo 2^32.
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
        from tilewright.kernels.lattice import fill_words

        points = np.broadcast_arrays(*check_point(stream, x, y, z))
        out = np.empty(points[0].size, np.uint32)
        fill_words(*(np.array(p).ravel() for p in points), stream, self.seed, out)
        return out.astype(np.int64).reshape(points[0].shape)

    def colors(self, count: int, stream: int, *point: ArrayLike) -> Colors:
        numbers = self.words(stream, *point) >> 8
        return ((numbers * count_colors(count)) >> 24).astype(slot_type((count,)))

    def grid(self, count: int, stream: int, *axes: Coordinates) -> Colors:
        from tilewright.kernels.lattice import fill_colors

        if count > 256:  # the kernel counts in bytes
            return super().grid(count, stream, *axes)

        zero = np.zeros(1, np.int64)
        x, y, z = (*axes, zero, zero)[:3]
        out = np.empty((len(z), len(y), len(x)), np.uint8)
        for layer, at in zip(out, z, strict=True):
            fill_colors(*split_row(x), y, at, stream, self.seed, np.uint32(count), layer)
        return out.reshape(tuple(len(axis) for axis in reversed(axes)))

    def numbers(self, stream: int, *point: ArrayLike) -> NDArray[np.int64]:
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


class PermutationHash(LatticeHash):
    """A permutation table looked up once for each coordinate (Lagae 2007, eq. 3.1 to 3.4).

    Parameters
    ----------
    seed : int
        Shuffles the table, by the order of the mixer's words: alike on every machine. Every stream has a
        table of its own.
    size : int
        Entries of the table, 2 to 65,536: the period along every axis, and the range.
    nested : bool
        One table, looked up with what the coordinates before gave (eq. 3.3 and 3.4), as is usual; or a
        table for each axis and the sum of what they give (eq. 3.2), in which a row differs from the next
        only by a constant.
    """

    name = "permutation"

    def __init__(self, seed: int = 0, size: int = 256, *, nested: bool = True) -> None:
        self.seed = check_seed(seed)
        self.size = check_int("size", size, 2, 65536)
        self.nested = nested
        self._tables: dict[tuple[int, int], NDArray[np.int64]] = {}

    @property
    def range(self) -> int:
        return self.size

    @property
    def period(self) -> int:  # type: ignore[override]
        """The table's size."""
        return self.size

    def table(self, stream: int, axis: int = 0) -> NDArray[np.int64]:
        """The permutation of a stream; of an axis, 0 for x, where each has its own."""
        if (stream, axis) not in self._tables:
            words = MixerHash(self.seed).words(stream, np.arange(self.size), self.size, axis)
            self._tables[stream, axis] = np.argsort(words, kind="stable")
        return self._tables[stream, axis]

    def words(
        self, stream: int, x: ArrayLike, y: ArrayLike | None = None, z: ArrayLike | None = None
    ) -> NDArray[np.int64]:
        first, *others = check_point(stream, x, y, z)[: 1 + (y is not None) + (z is not None)]
        table, n = self.table(stream), self.size
        value = table[first % n]
        for axis, coordinate in enumerate(others, 1):
            if self.nested:
                value = table[(value + coordinate % n) % n]
            else:
                value = (value + self.table(stream, axis)[coordinate % n]) % n
        return value


class LongPeriodHash(LatticeHash):
    """The sum of several permutation-table hashes (Lagae 2007, eq. 3.5 to 3.7).

    Parameters
    ----------
    seed : int
    sizes : sequence of int
        Table sizes, all different; the period is their least common multiple.
    range : int
        The final divisor N_j, one of the sizes.
    """

    name = "long-period"

    def __init__(
        self, seed: int = 0, sizes: tuple[int, ...] = (17, 19, 23, 24, 29, 31, 37), range: int = 24
    ) -> None:
        if not sizes:
            raise TilewrightValueError("sizes is empty; a long-period hash needs at least one table")
        if len(set(sizes)) < len(sizes):
            raise TilewrightValueError(
                f"sizes is {tuple(sizes)}; a size given twice does not lengthen the period"
            )
        if range not in sizes:
            raise TilewrightValueError(f"range is {range}; it must be one of the sizes {tuple(sizes)}")
        self.seed = check_seed(seed)
        self.parts = tuple(PermutationHash(seed, size) for size in sizes)
        self._range = range

    @classmethod
    def for_tilings(cls, seed: int = 0) -> "LongPeriodHash":
        """The thesis's design for 2, 3, 4, 6 or 8 colors: period 5,930,659,848 (section 3.4.3)."""
        return cls(seed)

    @classmethod
    def for_noise(cls, seed: int = 0) -> "LongPeriodHash":
        """The thesis's design for Perlin noise: range 16, period 739,024 (section 3.4.4)."""
        return cls(seed, (11, 13, 16, 17, 19), 16)

    @property
    def range(self) -> int:
        return self._range

    @property
    def period(self) -> int:  # type: ignore[override]
        """Least common multiple of the table sizes."""
        return lcm(*(part.size for part in self.parts))

    def words(
        self, stream: int, x: ArrayLike, y: ArrayLike | None = None, z: ArrayLike | None = None
    ) -> NDArray[np.int64]:
        words = [part.words(stream, x, y, z) for part in self.parts]
        return sum(words[1:], words[0]) % self._range


def make_hash(given: LatticeHash | str, seed: int) -> LatticeHash:
    """A hash by name (``"mixer"``, ``"permutation"``, ``"long-period"``), or one given as it is."""
    if isinstance(given, LatticeHash):
        return given
    kinds = {"mixer": MixerHash, "permutation": PermutationHash, "long-period": LongPeriodHash}
    if not isinstance(given, str):
        raise TilewrightTypeError(f"hash must be a name or a LatticeHash, not {given!r}")
    if given not in kinds:
        raise TilewrightValueError(f"hash is {given!r}; allowed are {', '.join(kinds)}")
    return kinds[given](seed)  # type: ignore[no-any-return]
