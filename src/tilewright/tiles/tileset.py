"""What may meet: a finite set of tiles with colored slots."""

from abc import ABC, abstractmethod
from math import prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int, check_type, type_error
from tilewright.errors import TilewrightValueError
from tilewright.showing import Shown
from tilewright.tiles.shape import Shape

MOST_COLORS = 2**15
"""Colors that a slot of any set can have: the codes of four such slots are below 2^62."""
MOST_FAMILY_COLORS = 16
"""What the named families offer."""

Slots = NDArray[Any]
"""Colors of slots: uint8, or uint16 where there are more than 256 colors."""


def check_colors(value: int, low: int = 1, name: str = "colors") -> int:
    """Number of colors of a named family."""
    return check_int(name, value, low, MOST_FAMILY_COLORS)


class Family(NamedTuple):
    """What a set is an instance of: the maker's kind of set, and what it was asked for."""

    name: str
    parameters: dict[str, Any]


CUSTOM = Family("custom", {})
"""The family of sets of which nothing more is known."""


class TileSet(Shown, ABC):
    """A finite set of tiles of one shape: what may meet.

    How many tiles there are, the slots of each, and the tiles that fit slots are all that anything asks of a
    set. `ListedTileSet` has them in a table, `RuledTileSet` computes them.

    Attributes
    ----------
    shape : Shape
        The kind of tile.
    colors : tuple of int
        Number of colors of each slot.
    name : str
        What messages and files call the set.

    Notes
    -----
    The *code* of a tile is the mixed-radix number of its colors (Lagae 2007, section 2.7, eq. 2.1 to 2.7);
    in a complete set code and index are the same.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiles = tw.tile_set([[0, 0, 0, 0], [0, 1, 0, 1], [1, 0, 1, 0]], "corner", name="mine")
    >>> tiles
    <TileSet mine: 3 corner tiles, colors (2, 2, 2, 2)>
    >>> tiles.fitting(NE=0, SE=1)
    array([1])
    """

    shape: Shape
    name: str
    colors: tuple[int, ...]

    @abstractmethod
    def __len__(self) -> int: ...

    def __eq__(self, other: object) -> bool:
        """Tell whether the same tiles may meet, in the same order, whatever the sets are called."""
        if not isinstance(other, TileSet):
            return NotImplemented
        if self is other:
            return True
        if (self.shape.name, self.colors, len(self)) != (other.shape.name, other.colors, len(other)):
            return False
        return np.array_equal(self.slots, other.slots)

    def __hash__(self) -> int:
        return hash((self.shape.name, self.colors, len(self)))

    @abstractmethod
    def slots_of(self, index: ArrayLike) -> Slots:
        """Look up the colors of tiles.

        Parameters
        ----------
        index : array-like of int, any shape
            Indices of tiles, 0 to T - 1.

        Returns
        -------
        uint8 or uint16 array, shape (..., S)
            Their colors, along a new last axis.

        Raises
        ------
        TilewrightTypeError
            The indices are not integers.
        TilewrightValueError
            An index is out of range.
        """

    @abstractmethod
    def find(self, slots: ArrayLike) -> NDArray[np.int64]:
        """Look up tiles by their colors.

        Parameters
        ----------
        slots : array-like of int, shape (..., S)
            Colors of all slots of a tile along the last axis, in the order of the shape.

        Returns
        -------
        int64 array, shape (...)
            Indices of the tiles with these colors; -1 where the set has no such tile.

        Raises
        ------
        TilewrightTypeError
            The colors are not integers.
        TilewrightValueError
            The last axis is not as long as a tile has slots.
        """

    @property
    @abstractmethod
    def slots(self) -> Slots:
        """Colors of every tile: shape (T, S), read-only; uint8, or uint16 for more than 256 colors."""

    @property
    def family(self) -> str:
        """Which kind of set it is: ``"corner"``, ``"compact-corner"``, ``"summed"`` ...; else ``"custom"``.

        Listed sets are told by their tiles, in whatever order and from whatever file they come.
        """
        return self._family.name

    @property
    def parameters(self) -> dict[str, Any]:
        """What makes a set of this family this one, such as ``{"colors": 4, "choices": 2}``."""
        return dict(self._family.parameters)

    @property
    def _family(self) -> Family:
        return CUSTOM

    def __repr__(self) -> str:
        return f"<TileSet {self.name}: {len(self)} {self.shape.name} tiles, colors {self.colors}>"

    @property
    def codes(self) -> NDArray[np.int64]:
        """Mixed-radix number of each tile's colors: int64, shape (T,)."""
        return encode(self.slots, self.colors)

    @property
    def is_complete(self) -> bool:
        """Whether every combination of colors is there."""
        return len(self) == prod(self.colors)

    def fitting(self, **known: int) -> NDArray[np.int64]:
        """List the tiles of which some slots carry given colors.

        Parameters
        ----------
        **known : int
            A color for each slot that is known, as in ``fitting(N=0, W=1)``.

        Returns
        -------
        int64 array, shape (n,)
            Indices of all tiles with these colors, in ascending order.

        Raises
        ------
        TilewrightTypeError
            A color is not an integer.
        TilewrightValueError
            The tiles have no such slot, or a color is out of its range.
        """
        slots = self.slots
        keep = np.ones(len(slots), bool)
        for slot, color in known.items():
            if slot not in self.shape.slots:
                raise TilewrightValueError(
                    f"{self.shape.name} tiles have no slot {slot!r}; they have {', '.join(self.shape.slots)}"
                )
            number = self.shape.slot(slot)
            keep &= slots[:, number] == check_int(slot, color, 0, self.colors[number] - 1)
        return keep.nonzero()[0]

    def _check_index(self, index: ArrayLike) -> NDArray[np.int64]:
        asked = as_integers("index", index)
        if asked.size and (asked.min() < 0 or asked.max() >= len(self)):
            raise TilewrightValueError(
                f"holds {asked.min()} to {asked.max()}; the set has tiles 0 to {len(self) - 1}",
                argument="index",
            )
        return asked.astype(np.int64)


def check_tiles(name: str, given: Any) -> TileSet:
    """``given`` if it is a tile set."""
    check_type(name, given, TileSet, "a TileSet, such as corner_tiles(2)")
    return given


def as_slots(given: ArrayLike, count: int) -> NDArray[Any]:
    """Colors of ``count`` slots along the last axis."""
    table = as_integers("slots", given)
    if table.ndim == 0 or table.shape[-1] != count:
        raise TilewrightValueError(
            f"has shape {table.shape}; its last axis must be {count} long",
            argument="slots",
            value=table.shape,
        )
    return table


def check_palette(colors: Any) -> tuple[int, ...]:
    """Numbers of colors, one for each slot."""
    if isinstance(colors, str) or np.ndim(colors) != 1 or not np.size(colors):
        raise type_error("colors", colors, "a tuple with a number for each slot")
    found = tuple(check_int("colors", c, 1, MOST_COLORS) for c in colors)
    if prod(found) > 2**62:
        raise TilewrightValueError(
            f"is {found}; their product may be up to 2^62", argument="colors", value=found
        )
    return found


def slot_type(colors: tuple[int, ...]) -> type[np.unsignedinteger[Any]]:
    """The integers that hold a set's colors."""
    return np.uint8 if max(colors) <= 256 else np.uint16


def encode(slots: ArrayLike, colors: tuple[int, ...]) -> NDArray[np.int64]:
    """Number the colors of tiles: the mixed-radix number along the last axis.

    Parameters
    ----------
    slots : array-like of int, shape (..., S)
        Colors of each slot, the most significant first.
    colors : tuple of int
        Number of colors of each slot, S of them, 1 to 2^15; their product is at most 2^62.

    Returns
    -------
    int64 array, shape (...)
        Codes, from 0 to the product of ``colors`` less one.

    Raises
    ------
    TilewrightTypeError
        The colors are not integers, or ``colors`` is not a tuple of integers.
    TilewrightValueError
        A color is out of range, or the last axis is not S long.

    Notes
    -----
    Lagae 2007, section 2.7, eq. 2.2 and 2.5.
    """
    colors = check_palette(colors)
    table = as_slots(slots, len(colors))
    if ((table < 0) | (table >= np.array(colors))).any():
        raise TilewrightValueError(f"holds colors outside 0 up to {tuple(colors)}", argument="slots")
    code = np.zeros(table.shape[:-1], np.int64)
    for slot, radix in enumerate(colors):
        code = code * radix + table[..., slot]
    return code


def decode(codes: ArrayLike, colors: tuple[int, ...]) -> Slots:
    """Give the colors of tiles from their codes: the inverse of `encode`.

    Parameters
    ----------
    codes : array-like of int, any shape
        Codes, from 0 to the product of ``colors`` less one.
    colors : tuple of int
        Number of colors of each slot, S of them, 1 to 2^15; their product is at most 2^62.

    Returns
    -------
    uint8 or uint16 array, shape (..., S)
        Colors of each slot along a new last axis; uint16 where a slot has more than 256 colors.

    Raises
    ------
    TilewrightTypeError
        The codes are not integers, or ``colors`` is not a tuple of integers.
    TilewrightValueError
        A code is out of range.

    Notes
    -----
    Lagae 2007, section 2.7, eq. 2.4 and 2.7.
    """
    rest = as_integers("codes", codes)
    colors = check_palette(colors)
    most = prod(int(c) for c in colors)
    if rest.size and (rest.min() < 0 or rest.max() >= most):
        raise TilewrightValueError(
            f"runs from {rest.min()} to {rest.max()}; allowed are 0 to {most - 1}",
            argument="codes",
            allowed=f"0 to {most - 1}",
        )
    rest = rest.astype(np.int64)
    slots = np.empty((*rest.shape, len(colors)), slot_type(colors))
    for slot in range(len(colors) - 1, -1, -1):
        slots[..., slot] = rest % colors[slot]
        rest = rest // colors[slot]
    return slots
