"""What may meet: a finite set of tiles with colored slots."""

from math import prod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.showing import Shown
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


class TileSet(Shown):
    """A finite set of tiles of one shape.

    Parameters
    ----------
    shape : Shape
        The kind of tile, for example `WANG` or `CORNER`.
    slots : array-like of int, shape (T, S)
        The colors of each tile, one column per slot of ``shape``.
    colors : sequence of int, optional
        Number of colors of each slot; by default one more than the largest color that the slots
        which can meet carry.
    name : str
        How messages and files call the set.

    Raises
    ------
    TilewrightValueError
        Empty set, wrong number of slots, a color out of range, or a tile given twice.

    Notes
    -----
    The index of a tile is its row in ``slots``. The *code* of a tile is the mixed-radix number of its
    colors (Lagae 2007, eq. 2.1-2.7); in a complete set code and index are the same.
    """

    def __init__(
        self, shape: Shape, slots: ArrayLike, colors: tuple[int, ...] | None = None, name: str = "custom"
    ) -> None:
        if not isinstance(shape, Shape):
            raise TilewrightTypeError(f"shape must be a Shape such as WANG, not {type(shape).__name__}")
        table = as_integers("slots", slots)
        if table.ndim != 2 or table.shape[1] != len(shape.slots) or not len(table):
            raise TilewrightValueError(
                f"slots has shape {table.shape}; {shape.name} tiles need (tiles, {len(shape.slots)}) "
                f"with columns {', '.join(shape.slots)} and at least one tile"
            )
        if table.min() < 0 or table.max() >= MOST_COLORS:
            raise TilewrightValueError(
                f"slots holds colors {table.min()} to {table.max()}; allowed are 0 to {MOST_COLORS - 1}"
            )
        self.shape = shape
        self.name = name
        self.colors = check_palette(_radices(shape, table) if colors is None else colors)
        self._slots: Slots = table.astype(slot_type(self.colors))
        self._slots.setflags(write=False)
        self._check_colors()
        codes = self.codes
        if len(np.unique(codes)) != len(codes):
            raise TilewrightValueError(f"the {name} set holds a tile twice")

    def _check_colors(self) -> None:
        if len(self.colors) != len(self.shape.slots):
            raise TilewrightValueError(
                f"colors has {len(self.colors)} entries; {self.shape.name} tiles have {len(self.shape.slots)}"
            )
        for far, near in (pair for joint in self.shape.joints for pair in joint):
            if self.colors[far] != self.colors[near]:
                raise TilewrightValueError(
                    f"colors is {self.colors}; {self.shape.slots[far]} and {self.shape.slots[near]} meet, so "
                    "they need equally many"
                )
        over = (self.slots >= np.array(self.colors)).nonzero()
        if len(over[0]):
            tile, slot = int(over[0][0]), int(over[1][0])
            raise TilewrightValueError(
                f"tile {tile} has color {self.slots[tile, slot]} at {self.shape.slots[slot]}; "
                f"that slot has {self.colors[slot]} colors"
            )

    @property
    def slots(self) -> Slots:
        """Colors of every tile, shape (T, S), read-only; uint8, or uint16 for more than 256 colors."""
        return self._slots

    def __len__(self) -> int:
        return len(self._slots)

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

    def slots_of(self, index: ArrayLike) -> Slots:
        """Colors of the tiles with the given indices, along a new last axis."""
        return self.slots[self._check_index(index)]

    def find(self, slots: ArrayLike) -> NDArray[np.int64]:
        """Indices of the tiles with the given colors, shape (..., S); -1 where the set has no such tile."""
        asked = as_slots(slots, len(self.colors))
        codes = self.codes
        order = np.argsort(codes)
        valid = (asked >= 0) & (asked < np.array(self.colors))
        wanted = encode(np.where(valid, asked, 0), self.colors)
        place = order[np.searchsorted(codes, wanted, sorter=order).clip(max=len(self) - 1)]
        return np.where(valid.all(axis=-1) & (codes[place] == wanted), place, -1)

    def _check_index(self, index: ArrayLike) -> NDArray[np.int64]:
        asked = as_integers("index", index)
        if asked.size and (asked.min() < 0 or asked.max() >= len(self)):
            raise TilewrightValueError(
                f"index holds {asked.min()} to {asked.max()}; the set has tiles 0 to {len(self) - 1}"
            )
        return asked.astype(np.int64)

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


def _radices(shape: Shape, table: NDArray[Any]) -> tuple[int, ...]:
    """Colors per slot: slots that meet across an axis share one palette."""
    most = table.max(axis=0).astype(int) + 1
    for _ in shape.slots:  # palettes spread along joints; this many rounds reach every slot
        for joint in shape.joints:
            for far, near in joint:
                most[far] = most[near] = max(most[far], most[near])
    return tuple(int(m) for m in most)


def check_tiles(name: str, given: Any) -> "TileSet":
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
