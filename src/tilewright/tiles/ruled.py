"""Tile sets that are given by a rule, so that they need not be listed."""

from collections.abc import Callable
from functools import cached_property
from math import prod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tiles.shape import Shape
from tilewright.tiles.tileset import Family, Slots, TileSet, as_slots, decode, encode, slot_type

_MOST_LISTED = 2**24

Rule = Callable[[NDArray[Any], int], NDArray[Any]]


class RuledTileSet(TileSet):
    """A tile set whose tiles follow from their index.

    The index is a mixed-radix number; a rule turns its digits into the slots' colors and another turns
    colors back. ``slots`` lists up to 2^24 tiles on first use.

    Parameters
    ----------
    shape : Shape
    colors : int
        Number of colors of every slot.
    name : str
    family : Family
    radices : tuple of int
        How many values each digit of an index has.
    to_slots, to_digits : callable
        From digits, shape (..., D), and the number of colors to the colors of slots, and back; what is not
        the digits of a tile may come out of range or anything else.
    """

    def __init__(
        self,
        shape: Shape,
        colors: int,
        name: str,
        family: Family,
        radices: tuple[int, ...],
        to_slots: Rule,
        to_digits: Rule,
    ) -> None:
        self.shape = shape
        self.name = name
        self.colors = (colors,) * len(shape.slots)
        self._stated = family
        self._radices = radices
        self._to_slots, self._to_digits = to_slots, to_digits

    @property
    def _family(self) -> Family:
        return self._stated

    @property
    def slots(self) -> Slots:
        """Colors of every tile, shape (T, S), read-only; listed on first use."""
        return self._listed

    @cached_property
    def _listed(self) -> Slots:
        if len(self) > _MOST_LISTED:
            raise TilewrightValueError(
                f"the {self.name} set of {len(self)} {self.shape.name} tiles is too large to list",
                advice="slots_of() and find() work without a list",
            )
        listed = self.slots_of(np.arange(len(self)))
        listed.setflags(write=False)
        return listed

    def __len__(self) -> int:
        return prod(self._radices)

    def slots_of(self, index: ArrayLike) -> Slots:
        """Colors of the tiles with the given indices, along a new last axis."""
        digits = decode(self._check_index(index), self._radices)
        return self._to_slots(digits.astype(np.int64), self.colors[0]).astype(slot_type(self.colors))

    def find(self, slots: ArrayLike) -> NDArray[np.int64]:
        """Indices of the tiles with the given colors, shape (..., S); -1 where the set has no such tile."""
        asked = as_slots(slots, len(self.colors)).astype(np.int64)
        digits = self._to_digits(asked, self.colors[0])
        valid = (digits >= 0) & (digits < np.array(self._radices))
        index = encode(np.where(valid, digits, 0), self._radices)
        return np.where(valid.all(axis=-1) & (self.slots_of(index) == asked).all(axis=-1), index, -1)
