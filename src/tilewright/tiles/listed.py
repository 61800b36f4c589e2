"""Tile sets that are given as a table of their tiles."""

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_type
from tilewright.errors import TilewrightValueError
from tilewright.tiles.recognition import tell_family
from tilewright.tiles.shape import Shape
from tilewright.tiles.tileset import (
    MOST_COLORS,
    Family,
    Slots,
    TileSet,
    as_slots,
    check_palette,
    encode,
    slot_type,
)


class ListedTileSet(TileSet):
    """A tile set from a table of the colors of its tiles.

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
    family : Family, optional
        Where the maker knows what the tiles do not tell.

    Raises
    ------
    TilewrightValueError
        Empty set, wrong number of slots, a color out of range, or a tile given twice.

    Notes
    -----
    The index of a tile is its row in ``slots``.
    """

    def __init__(
        self,
        shape: Shape,
        slots: ArrayLike,
        colors: tuple[int, ...] | None = None,
        name: str = "custom",
        *,
        family: Family | None = None,
    ) -> None:
        check_type("shape", shape, Shape, "a Shape such as WANG")
        table = as_integers("slots", slots)
        if table.ndim != 2 or table.shape[1] != len(shape.slots) or not len(table):
            raise TilewrightValueError(
                f"has shape {table.shape}; {shape.name} tiles need (tiles, {len(shape.slots)}) with "
                f"columns {', '.join(shape.slots)} and at least one tile",
                argument="slots",
                value=table.shape,
            )
        if table.min() < 0 or table.max() >= MOST_COLORS:
            raise TilewrightValueError(
                f"holds colors {table.min()} to {table.max()}; allowed are 0 to {MOST_COLORS - 1}",
                argument="slots",
                allowed=f"0 to {MOST_COLORS - 1}",
            )
        self.shape = shape
        self.name = name
        self._stated = family
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
                f"has {len(self.colors)} entries; {self.shape.name} tiles have {len(self.shape.slots)}",
                argument="colors",
                value=len(self.colors),
            )
        for far, near in (pair for joint in self.shape.joints for pair in joint):
            if self.colors[far] != self.colors[near]:
                raise TilewrightValueError(
                    f"is {self.colors}; {self.shape.slots[far]} and {self.shape.slots[near]} meet, so "
                    "they need equally many",
                    argument="colors",
                    value=self.colors,
                )
        over = (self.slots >= np.array(self.colors)).nonzero()
        if len(over[0]):
            tile, slot = int(over[0][0]), int(over[1][0])
            raise TilewrightValueError(
                f"has color {self.slots[tile, slot]} at {self.shape.slots[slot]}; that slot has "
                f"{self.colors[slot]} colors",
                argument=f"tile {tile}",
            )

    @property
    def slots(self) -> Slots:
        """Colors of every tile, shape (T, S), read-only; uint8, or uint16 for more than 256 colors."""
        return self._slots

    def __len__(self) -> int:
        return len(self._slots)

    @cached_property
    def _family(self) -> Family:  # type: ignore[override]
        return self._stated or tell_family(self.shape, self.colors, self._slots)

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


def _radices(shape: Shape, table: NDArray[Any]) -> tuple[int, ...]:
    """Colors per slot: slots that meet across an axis share one palette."""
    most = table.max(axis=0).astype(int) + 1
    for _ in shape.slots:  # palettes spread along joints; this many rounds reach every slot
        for joint in shape.joints:
            for far, near in joint:
                most[far] = most[near] = max(most[far], most[near])
    return tuple(int(m) for m in most)
