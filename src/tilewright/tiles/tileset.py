"""What may meet: a finite set of tiles with colored slots."""

from abc import ABC, abstractmethod
from math import prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tiles.shape import Shape

MOST_COLORS = 2**15
"""What a slot of any set can hold: four slots of so many colors have codes below 2^62."""
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


class TileSet(ABC):
    """A finite set of tiles of one shape: what may meet.

    How many tiles there are, the slots of each, and the tiles that fit slots are all that anything asks of a
    set. `ListedTileSet` has them in a table, `RuledTileSet` computes them.

    Attributes
    ----------
    shape : Shape
        The kind of tile.
    name : str
        How messages and files call the set.
    colors : tuple of int
        Number of colors of each slot.

    Notes
    -----
    The *code* of a tile is the mixed-radix number of its colors (Lagae 2007, eq. 2.1-2.7); in a complete set
    code and index are the same.
    """

    shape: Shape
    name: str
    colors: tuple[int, ...]

    @abstractmethod
    def __len__(self) -> int: ...

    @abstractmethod
    def slots_of(self, index: ArrayLike) -> Slots:
        """Colors of the tiles with the given indices, along a new last axis."""

    @abstractmethod
    def find(self, slots: ArrayLike) -> NDArray[np.int64]:
        """Indices of the tiles with the given colors, shape (..., S); -1 where the set has no such tile."""

    @property
    @abstractmethod
    def slots(self) -> Slots:
        """Colors of every tile, shape (T, S), read-only; uint8, or uint16 for more than 256 colors."""

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
        """Mixed-radix number of each tile's colors, shape (T,)."""
        return encode(self.slots, self.colors)

    @property
    def is_complete(self) -> bool:
        """Whether every combination of colors is there."""
        return len(self) == prod(self.colors)

    def fitting(self, **known: int) -> NDArray[np.int64]:
        """Indices of the tiles whose slots carry the given colors, as in ``fitting(N=0, W=1)``."""
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
                f"index holds {asked.min()} to {asked.max()}; the set has tiles 0 to {len(self) - 1}"
            )
        return asked.astype(np.int64)


def check_tiles(name: str, given: Any) -> TileSet:
    """``given`` if it is a tile set."""
    if not isinstance(given, TileSet):
        raise TilewrightTypeError(
            f"{name} must be a TileSet, such as corner_tiles(2), not {type(given).__name__}"
        )
    return given


def as_slots(given: ArrayLike, count: int) -> NDArray[Any]:
    """Colors of ``count`` slots along the last axis."""
    table = as_integers("slots", given)
    if table.ndim == 0 or table.shape[-1] != count:
        raise TilewrightValueError(f"slots has shape {table.shape}; its last axis must be {count} long")
    return table


def check_palette(colors: Any) -> tuple[int, ...]:
    """Numbers of colors, one for each slot."""
    if isinstance(colors, str) or np.ndim(colors) != 1 or not np.size(colors):
        raise TilewrightTypeError(f"colors must be a tuple with a number for each slot, not {colors!r}")
    found = tuple(check_int("colors", c, 1, MOST_COLORS) for c in colors)
    if prod(found) > 2**62:
        raise TilewrightValueError(f"colors is {found}; their product may be up to 2^62")
    return found


def slot_type(colors: tuple[int, ...]) -> type[np.unsignedinteger[Any]]:
    """The integers that hold a set's colors."""
    return np.uint8 if max(colors) <= 256 else np.uint16


def encode(slots: ArrayLike, colors: tuple[int, ...]) -> NDArray[np.int64]:
    """Mixed-radix number of the colors along the last axis (Lagae 2007, eq. 2.2 and 2.5)."""
    colors = check_palette(colors)
    table = as_slots(slots, len(colors))
    if ((table < 0) | (table >= np.array(colors))).any():
        raise TilewrightValueError(f"slots holds colors outside 0 up to {tuple(colors)}")
    code = np.zeros(table.shape[:-1], np.int64)
    for slot, radix in enumerate(colors):
        code = code * radix + table[..., slot]
    return code


def decode(codes: ArrayLike, colors: tuple[int, ...]) -> Slots:
    """Colors of each slot along a new last axis (Lagae 2007, eq. 2.4 and 2.7)."""
    rest = as_integers("codes", codes)
    colors = check_palette(colors)
    most = prod(int(c) for c in colors)
    if rest.size and (rest.min() < 0 or rest.max() >= most):
        raise TilewrightValueError(
            f"codes runs from {rest.min()} to {rest.max()}; allowed are 0 to {most - 1}"
        )
    rest = rest.astype(np.int64)
    slots = np.empty((*rest.shape, len(colors)), slot_type(colors))
    for slot in range(len(colors) - 1, -1, -1):
        slots[..., slot] = rest % colors[slot]
        rest = rest // colors[slot]
    return slots
