"""Cube sets: complete and compact, given by a rule because most are too large to list.

Conventions: x east, y south, z down. The faces of a Wang cube are N, E, S, W, U (the upper face, at the
cell's own z) and D; the corners of a corner cube are NE, SE, SW, NW of the upper face, then of the lower.
"""

from collections.abc import Callable
from math import prod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tiles.shape import CORNER_CUBE, WANG_CUBE, Shape
from tilewright.tiles.tileset import TileSet, as_slots, check_colors, decode, encode

_MOST_LISTED = 2**24
_NWU, _SED = CORNER_CUBE.slot("NWU"), CORNER_CUBE.slot("SED")

Rule = Callable[[NDArray[Any], int], NDArray[Any]]


class RuledTileSet(TileSet):
    """A tile set whose tiles follow from their index, so that it need not be listed.

    The index is a mixed-radix number; a rule turns its digits into the slots' colors and another turns
    colors back. ``slots`` lists up to 2^24 tiles on first use.
    """

    def __init__(
        self, shape: Shape, colors: int, name: str, radices: tuple[int, ...], to_slots: Rule, to_digits: Rule
    ) -> None:
        self.shape = shape
        self.name = name
        self.colors = (colors,) * len(shape.slots)
        self._radices = radices
        self._to_slots, self._to_digits = to_slots, to_digits
        self._listed: NDArray[np.uint8] | None = None

    @property
    def slots(self) -> NDArray[np.uint8]:
        """Colors of every tile, shape (T, S), read-only; listed on first use."""
        if self._listed is None:
            if len(self) > _MOST_LISTED:
                raise TilewrightValueError(
                    f"the {self.name} set of {len(self)} {self.shape.name} tiles is too large to list",
                    advice="slots_of() and find() work without a list",
                )
            self._listed = self.slots_of(np.arange(len(self)))
            self._listed.setflags(write=False)
        return self._listed

    def __len__(self) -> int:
        return prod(self._radices)

    def slots_of(self, index: ArrayLike) -> NDArray[np.uint8]:
        """Colors of the tiles with the given indices, along a new last axis."""
        digits = decode(self._check_index(index), self._radices)
        return self._to_slots(digits.astype(np.int64), self.colors[0]).astype(np.uint8)

    def find(self, slots: ArrayLike) -> NDArray[np.int64]:
        """Indices of the tiles with the given colors, shape (..., S); -1 where the set has no such tile."""
        asked = as_slots(slots, len(self.colors)).astype(np.int64)
        digits = self._to_digits(asked, self.colors[0])
        valid = (digits >= 0) & (digits < np.array(self._radices))
        index = encode(np.where(valid, digits, 0), self._radices)
        return np.where(valid.all(axis=-1) & (self.slots_of(index) == asked).all(axis=-1), index, -1)


def corner_cubes(colors: int = 2) -> TileSet:
    """Make the complete set of corner cubes.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 to 16; default 2.

    Returns
    -------
    TileSet
        C^8 cubes, slots NEU, SEU, SWU, NWU, NED, SED, SWD, NWD. Where there are more than 2^24 of them the
        set does not list its ``slots``; `TileSet.find` and `TileSet.slots_of` compute them.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is out of range.

    Notes
    -----
    Lagae 2007, section 2.10.
    """
    return _complete(CORNER_CUBE, check_colors(colors))


def wang_cubes(colors: int = 2) -> TileSet:
    """Make the complete set of Wang cubes.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 to 16; default 2.

    Returns
    -------
    TileSet
        C^6 cubes; slots are the faces N, E, S, W, U, D.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is out of range.

    Notes
    -----
    Lagae 2007, section 2.10.
    """
    return _complete(WANG_CUBE, check_colors(colors))


def compact_corner_cubes(colors: int = 2) -> TileSet:
    """Make a compact set of corner cubes: two for each way the other seven corners can be, SED last.

    (SED - 2 NWU) mod C is 0 or 1: chains along the space diagonal, which have a direct tiling.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 to 16; default 2.

    Returns
    -------
    TileSet
        2 C^7 cubes; for C up to 2 the complete set.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is out of range.

    Notes
    -----
    This set is not from a paper; the documentation page on compact sets derives it.
    """
    c = check_colors(colors)
    if c <= 2:
        return _complete(CORNER_CUBE, c)
    radices = (c,) * _SED + (2,) + (c,) * (7 - _SED)
    return RuledTileSet(CORNER_CUBE, c, "compact-2", radices, _step_to_sed, _sed_to_step)


def compact_wang_cubes(colors: int = 2) -> TileSet:
    """Make a compact set of Wang cubes: two for each way the N, W and U faces can be.

    They are S = 2 N + b, E = 2 W + b and D = 2 U + b modulo C, for b = 0 and 1. Only in this order is there
    always a choice: for even C most ways the S, E and D faces could be do not occur. Where C is a power of
    two the set has a direct tiling from one bit for each cube.

    Parameters
    ----------
    colors : int, optional
        Number of colors C, 1 to 16; default 2.

    Returns
    -------
    TileSet
        2 C^3 cubes, slots N, E, S, W, U, D.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is out of range.

    Notes
    -----
    After Cohen et al. 2003, section 5, which speaks of 32 cubes over two colors; 16 of them suffice to fill
    space without a period.
    """
    c = check_colors(colors)
    return RuledTileSet(WANG_CUBE, c, "compact", (c, c, c, min(c, 2)), _bit_to_faces, _faces_to_bit)


def _complete(shape: Shape, c: int) -> TileSet:
    return RuledTileSet(shape, c, "complete", (c,) * len(shape.slots), _same, _same)


def _same(digits: NDArray[Any], colors: int) -> NDArray[Any]:
    return digits


def _step_to_sed(digits: NDArray[Any], c: int) -> NDArray[Any]:
    slots = digits.copy()
    slots[..., _SED] = (2 * digits[..., _NWU] + digits[..., _SED]) % c
    return slots


def _sed_to_step(slots: NDArray[Any], c: int) -> NDArray[Any]:
    digits = slots.copy()
    digits[..., _SED] = (slots[..., _SED] - 2 * slots[..., _NWU]) % c
    return digits


def _bit_to_faces(digits: NDArray[Any], c: int) -> NDArray[Any]:
    n, w, u, b = np.moveaxis(digits, -1, 0)
    return np.stack([n, (2 * w + b) % c, (2 * n + b) % c, w, u, (2 * u + b) % c], axis=-1)


def _faces_to_bit(slots: NDArray[Any], c: int) -> NDArray[Any]:
    n, _, s, w, u, _ = np.moveaxis(slots, -1, 0)
    return np.stack([n, w, u, (s - 2 * n) % c], axis=-1)
