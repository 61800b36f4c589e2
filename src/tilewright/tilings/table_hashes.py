"""Hash functions that look up tables: those of Lagae 2007, section 3.4; and any hash by its name."""

from math import lcm

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_int, type_error
from tilewright.errors import TilewrightValueError
from tilewright.seeds import check_seed
from tilewright.tilings.hashes import LatticeHash, MixerHash, check_point


class PermutationHash(LatticeHash):
    """A permutation table looked up once for each coordinate.

    Parameters
    ----------
    seed : int, optional
        Shuffles the table, 0 to 2^64 - 1, by the order of the mixer's words; default 0. Every stream has a
        table of its own.
    size : int, optional
        Entries of the table, 2 to 65,536: the period along every axis, and the range; default 256.
    nested : bool, optional
        True, the default: one table, looked up with what the coordinates before gave (eq. 3.3 and 3.4).
        False: a table for each axis and the sum of what they give (eq. 3.2), in which a row differs from the
        next only by a constant.

    Raises
    ------
    TilewrightTypeError
        A number is not an integer.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Lagae 2007, section 3.4.1, eq. 3.1 to 3.4. Departs in that a table is the order of hashed words, not a
    chain of exchanges, so that it is alike on every machine.
    """

    name = "permutation"

    def __init__(self, seed: int = 0, size: int = 256, *, nested: bool = True) -> None:
        self.seed = check_seed(seed)
        self.size = check_int("size", size, 2, 65536)
        self.nested = nested
        self._tables: dict[tuple[int, int], NDArray[np.int64]] = {}

    @property
    def range(self) -> int:
        """Number of values that `words` takes: the table's size."""
        return self.size

    @property
    def period(self) -> int:  # type: ignore[override]
        """The table's size."""
        return self.size

    def table(self, stream: int, axis: int = 0) -> NDArray[np.int64]:
        """Give the permutation of a stream.

        Parameters
        ----------
        stream : int
            Which of the independent hashes, 0 to 2^32 - 1.
        axis : int, optional
            0 for x, the default, 1 for y, 2 for z, where each axis has a table of its own.

        Returns
        -------
        int64 array, shape (size,)
            The numbers 0 up to ``size``, in another order.
        """
        if (stream, axis) not in self._tables:
            words = MixerHash(self.seed).words(stream, np.arange(self.size), self.size, axis)
            self._tables[stream, axis] = np.argsort(words, kind="stable")
        return self._tables[stream, axis]

    def words(
        self, stream: int, x: ArrayLike, y: ArrayLike | None = None, z: ArrayLike | None = None
    ) -> NDArray[np.int64]:
        """Hash lattice points, from 0 up to the size of the table; see `LatticeHash.words`."""
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
    """The sum of several permutation-table hashes, which repeats late.

    Parameters
    ----------
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.
    sizes : tuple of int, optional
        Table sizes, all different, 2 to 65,536 each; the period is their least common multiple. Default (17,
        19, 23, 24, 29, 31, 37).
    range : int, optional
        The final divisor N_j, one of the sizes; default 24.

    Attributes
    ----------
    parts : tuple of PermutationHash
        The hashes that are added.

    Raises
    ------
    TilewrightTypeError
        A number is not an integer.
    TilewrightValueError
        There are no sizes, one comes twice or is out of range, or the range is none of them.

    Notes
    -----
    Lagae 2007, section 3.4.2, eq. 3.5 to 3.7.
    """

    name = "long-period"

    def __init__(
        self, seed: int = 0, sizes: tuple[int, ...] = (17, 19, 23, 24, 29, 31, 37), range: int = 24
    ) -> None:
        if not sizes:
            raise TilewrightValueError(
                "is empty; a long-period hash needs at least one table", argument="sizes"
            )
        if len(set(sizes)) < len(sizes):
            raise TilewrightValueError(
                f"is {tuple(sizes)}; a size given twice does not lengthen the period",
                argument="sizes",
                value=sizes,
            )
        if range not in sizes:
            raise TilewrightValueError(
                f"is {range}; it must be one of the sizes {tuple(sizes)}",
                argument="range",
                value=range,
                allowed=f"one of the sizes {tuple(sizes)}",
            )
        self.seed = check_seed(seed)
        self.parts = tuple(PermutationHash(seed, size) for size in sizes)
        self._range = range

    @classmethod
    def for_tilings(cls, seed: int = 0) -> "LongPeriodHash":
        """Make the hash that the thesis designs for 2, 3, 4, 6 or 8 colors.

        Parameters
        ----------
        seed : int, optional
            Where chance begins, 0 to 2^64 - 1; default 0.

        Returns
        -------
        LongPeriodHash
            Its period is 5,930,659,848, its range 24.

        Notes
        -----
        Lagae 2007, section 3.4.3.
        """
        return cls(seed)

    @classmethod
    def for_noise(cls, seed: int = 0) -> "LongPeriodHash":
        """Make the hash that the thesis designs for Perlin noise.

        Parameters
        ----------
        seed : int, optional
            Where chance begins, 0 to 2^64 - 1; default 0.

        Returns
        -------
        LongPeriodHash
            Its period is 739,024, its range 16.

        Notes
        -----
        Lagae 2007, section 3.4.4.
        """
        return cls(seed, (11, 13, 16, 17, 19), 16)

    @property
    def range(self) -> int:
        """Number of values that `words` takes: the final divisor."""
        return self._range

    @property
    def period(self) -> int:  # type: ignore[override]
        """Least common multiple of the table sizes."""
        return lcm(*(part.size for part in self.parts))

    def words(
        self, stream: int, x: ArrayLike, y: ArrayLike | None = None, z: ArrayLike | None = None
    ) -> NDArray[np.int64]:
        """Hash lattice points, from 0 up to `range`; see `LatticeHash.words`."""
        words = [part.words(stream, x, y, z) for part in self.parts]
        return sum(words[1:], words[0]) % self._range


def make_hash(given: LatticeHash | str, seed: int) -> LatticeHash:
    """A hash by name (``"mixer"``, ``"permutation"``, ``"long-period"``), or one given as it is."""
    if isinstance(given, LatticeHash):
        return given
    kinds = {"mixer": MixerHash, "permutation": PermutationHash, "long-period": LongPeriodHash}
    if not isinstance(given, str):
        raise type_error("hash", given, "a name or a LatticeHash")
    if given not in kinds:
        raise TilewrightValueError(
            f"is {given!r}; allowed are {', '.join(kinds)}",
            argument="hash",
            value=given,
            allowed=", ".join(kinds),
        )
    return kinds[given](seed)  # type: ignore[no-any-return]
