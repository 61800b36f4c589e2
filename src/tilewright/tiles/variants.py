"""Several fillings for one tile: how many each tile of a set has, and how often each is drawn."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import ceil, isfinite
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int, shape_error, type_error
from tilewright.errors import TilewrightValueError, brief
from tilewright.showing import describe
from tilewright.tiles.tileset import TileSet, check_tiles

NUMBER_BITS = 24
"""Bits of the numbers by which variants are drawn, as lattice hashes give them."""
MOST_SHADED = 256
"""Variants of a tile that shaders can draw: the product of such a number and theirs fits in 32 bits."""
_ALL = 2**NUMBER_BITS
_MOST_ROWS = 2**31


@dataclass(frozen=True, eq=False, repr=False)
class Variants:
    """Interchangeable fillings of the tiles of a set, and the shares in which they are drawn.

    A signal holds a row for each variant of each tile, the variants of a tile one after another. A variant is
    drawn by a number of 24 bits, compared with integers, so that the same bytes come everywhere.

    Attributes
    ----------
    starts : int64 array, shape (T + 1,)
        Rows ``starts[t]`` up to ``starts[t + 1]`` are the variants of tile t, at least one.
    thresholds : int64 array, shape (rows,)
        A row is drawn by the numbers from its threshold on, up to that of the next row of its tile or to
        2^24. The first row of a tile has 0; a row that is never drawn has the threshold of the next.

    Raises
    ------
    TilewrightTypeError
        Arrays of something else than integers.
    TilewrightValueError
        Starts or thresholds that do not rise as they must, or more than 2^31 rows.

    See Also
    --------
    Tiling.placements, Tiling.rows, TextureTiles, PointTiles

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.Variants.uniform(tw.corner_tiles(2), 3)
    <Variants: 3 of each of 16 tiles>
    >>> rare = tw.Variants.weighted([[9, 1]] * 16)
    >>> rare
    <Variants: 32 of 16 tiles, weighted>
    >>> rare.shares[:2]
    array([15099495,  1677721])
    """

    starts: NDArray[np.int64]
    thresholds: NDArray[np.int64]

    def __post_init__(self) -> None:
        for name in ("starts", "thresholds"):
            values = as_integers(name, getattr(self, name)).astype(np.int64)
            if values.ndim != 1:
                raise shape_error(name, values.shape, "one axis")
            values.setflags(write=False)
            object.__setattr__(self, name, values)
        starts, thresholds = self.starts, self.thresholds
        if len(starts) < 2 or starts[0] != 0 or (np.diff(starts) < 1).any():
            raise TilewrightValueError(
                "must rise from 0, by at least one row for each tile",
                argument="starts",
                allowed="rising from 0, by at least one row for each tile",
            )
        if starts[-1] != len(thresholds) or len(thresholds) > _MOST_ROWS:
            raise TilewrightValueError(
                f"ends at {starts[-1]} and there are {len(thresholds)} thresholds; expected as many, at most "
                f"{_MOST_ROWS}",
                argument="starts",
                value=int(starts[-1]),
            )
        falls = np.diff(thresholds, prepend=0) < 0
        falls[starts[:-1]] = thresholds[starts[:-1]] != 0
        if falls.any() or thresholds.max() > _ALL:
            row = int(np.argmax(falls | (thresholds > _ALL)))
            raise TilewrightValueError(
                f"must rise from 0 within each tile, up to {_ALL} at most; they do not at row {row}",
                argument="thresholds",
                value=int(thresholds[row]),
                allowed=f"rising from 0 within each tile, up to {_ALL}",
            )

    @classmethod
    def uniform(cls, tiles: TileSet, count: int = 1) -> "Variants":
        """Make as many variants of every tile, all drawn alike: number n gives variant ``n * count >> 24``.

        Parameters
        ----------
        tiles : TileSet
            The tiles.
        count : int, optional
            Variants of every tile, at most 2^31 rows in all; default 1.

        Returns
        -------
        Variants
            The rows of each tile, ``count`` of them.

        Raises
        ------
        TilewrightTypeError
            Something that is not a tile set, or a count that is not an integer.
        TilewrightValueError
            The count is out of range.
        """
        check_tiles("tiles", tiles)
        count = check_int("count", count, 1, max(1, _MOST_ROWS // len(tiles)))
        starts = np.arange(len(tiles) + 1, dtype=np.int64) * count
        return cls(starts, np.tile(_even_thresholds(count), len(tiles)))

    @classmethod
    def weighted(cls, weights: Sequence[ArrayLike]) -> "Variants":
        """Make variants that are drawn in proportion to weights; tiles may have any numbers of them.

        Parameters
        ----------
        weights : sequence of array-like, one for each tile
            A number, 0 or more, for each variant of the tile; not all of them 0. A variant's threshold is the
            share of those before it in 2^24, rounded up, worked out exactly.

        Returns
        -------
        Variants
            A row for each weight.

        Raises
        ------
        TilewrightValueError
            A tile without a variant or with nothing but zeros, a weight below 0 or not finite.
        TilewrightTypeError
            Weights that are not numbers.
        """
        found = [_exact(tile, given) for tile, given in enumerate(weights)]
        if not found:
            raise TilewrightValueError(
                "is empty", argument="weights", advice="give the weights of the variants of every tile"
            )
        starts = np.cumsum([0, *(len(row) for row in found)])
        return cls(starts, np.concatenate([_thresholds(row) for row in found]))

    def __len__(self) -> int:
        """Rows: variants of all tiles together."""
        return len(self.thresholds)

    def __repr__(self) -> str:
        count = len(self.starts) - 1
        if self.even:
            return describe(self, f"{self.even} of each of {count} tiles")
        return describe(self, f"{len(self)} of {count} tiles", "weighted")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Variants):
            return NotImplemented
        return np.array_equal(self.starts, other.starts) and np.array_equal(self.thresholds, other.thresholds)

    def __hash__(self) -> int:
        return hash((self.starts.tobytes(), self.thresholds.tobytes()))

    @cached_property
    def counts(self) -> NDArray[np.int64]:
        """Number of variants of each tile, int64, shape (T,)."""
        return np.diff(self.starts)

    @cached_property
    def even(self) -> int:
        """How many variants every tile has, where all have as many and all are drawn alike; otherwise 0."""
        count = int(self.counts[0])
        if (self.counts != count).any():
            return 0
        same = self.thresholds.reshape(-1, count) == _even_thresholds(count)
        return count if same.all() else 0

    @property
    def tiles(self) -> NDArray[np.int64]:
        """The tile of each row, int64, shape (rows,)."""
        return np.repeat(np.arange(len(self.counts)), self.counts)

    @property
    def shares(self) -> NDArray[np.int64]:
        """How many of the 2^24 numbers draw each row, int64, shape (rows,)."""
        ends = np.append(self.thresholds[1:], _ALL)
        ends[self.starts[1:] - 1] = _ALL
        return ends - self.thresholds

    def row(self, tile: int, variant: int = 0) -> int:
        """Tell the row of a variant of a tile.

        Parameters
        ----------
        tile : int
            Index of the tile.
        variant : int, optional
            Which of its variants, counted from 0; default 0.

        Returns
        -------
        int
            The row of a signal that has these variants.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer.
        TilewrightValueError
            There is no such tile or variant.
        """
        tile = check_int("tile", tile, 0, len(self.counts) - 1)
        return int(self.starts[tile]) + check_int("variant", variant, 0, int(self.counts[tile]) - 1)

    def rows(self, indices: NDArray[Any], numbers: NDArray[Any]) -> NDArray[np.int64]:
        """Draw a row for each of many tiles.

        Parameters
        ----------
        indices : int array
            Tiles.
        numbers : int array
            What is drawn by, from 0 up to 2^24; both arrays broadcast.

        Returns
        -------
        int64 array
            The row that each tile shows.
        """
        tiles = np.asarray(indices, np.int64)
        if self.even:
            return tiles * self.even + (np.asarray(numbers, np.int64) * self.even >> NUMBER_BITS)
        # One sorted list for all tiles: a tile's thresholds lie 2^24 above those of the tile before.
        ladder = (self.tiles << NUMBER_BITS) + self.thresholds
        return np.searchsorted(ladder, (tiles << NUMBER_BITS) + numbers, side="right") - 1


def name_variants(variants: Variants) -> list[str]:
    """What a signal says of its variants in its line: nothing where every tile has one."""
    if variants.even:
        return [f"{variants.even} variants"] if variants.even > 1 else []
    return [f"{len(variants)} variants in all, weighted"]


def check_variants(variants: Any, tiles: TileSet) -> Variants:
    """Raise unless ``variants`` are those of a tile set."""
    if not isinstance(variants, Variants):
        raise type_error("variants", variants, "Variants")
    if len(variants.counts) != len(tiles):
        raise TilewrightValueError(
            f"are of {len(variants.counts)} tiles; the set has {len(tiles)}",
            argument="variants",
            value=variants,
            allowed=f"those of {len(tiles)} tiles",
        )
    return variants


def _even_thresholds(count: int) -> NDArray[np.int64]:
    """ceil(v 2^24 / count) for each variant v: the first number n of which ``n * count >> 24`` is v."""
    return -(-(np.arange(count, dtype=np.int64) << NUMBER_BITS) // count)


def _exact(tile: int, given: ArrayLike) -> list[Fraction]:
    """The weights of a tile's variants as exact numbers."""
    values = np.asarray(given)
    if values.dtype.kind not in "iuf":
        raise type_error(f"weights of tile {tile}", given, "numbers")
    row: list[float] = values.ravel().tolist()
    if not all(isfinite(weight) and weight >= 0 for weight in row) or not any(row):
        raise TilewrightValueError(
            f"are {brief(row)}; expected numbers from 0 on, not all of them 0",
            argument=f"weights of tile {tile}",
            value=row,
            allowed="numbers from 0 on, not all of them 0",
        )
    return [Fraction(weight) for weight in row]


def _thresholds(weights: list[Fraction]) -> NDArray[np.int64]:
    total, before = sum(weights), Fraction(0)
    found = []
    for weight in weights:
        found.append(ceil(before * _ALL / total))
        before += weight
    return np.array(found, np.int64)
