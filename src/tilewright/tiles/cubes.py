"""Cube sets: complete and compact, given by a rule because most are too large to list.

Conventions: x east, y south, z down. The faces of a Wang cube are N, E, S, W, U (the upper face, at the
cell's own z) and D; the corners of a corner cube are NE, SE, SW, NW of the upper face, then of the lower.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.tiles.ruled import RuledTileSet
from tilewright.tiles.shape import CORNER_CUBE, WANG_CUBE, Shape
from tilewright.tiles.tileset import Family, TileSet, check_colors

_NWU, _SED = CORNER_CUBE.slot("NWU"), CORNER_CUBE.slot("SED")


def corner_cubes(colors: int = 2) -> TileSet:
    """The complete set of corner cubes, C^8 (Lagae 2007, section 2.10), C from 1 to 16.

    Slots: NEU, SEU, SWU, NWU, NED, SED, SWD, NWD. Sets of more than 2^24 cubes are not listed; `TileSet.find`
    and `TileSet.slots_of` compute.
    """
    return _complete(CORNER_CUBE, check_colors(colors))


def wang_cubes(colors: int = 2) -> TileSet:
    """The complete set of Wang cubes, C^6 (Lagae 2007, section 2.10), C from 1 to 16.

    Slots are the faces N, E, S, W, U, D.
    """
    return _complete(WANG_CUBE, check_colors(colors))


def compact_corner_cubes(colors: int = 2) -> TileSet:
    """2 C^7 corner cubes: two for each way the other seven corners can be, SED last.

    (SED - 2 NWU) mod C is 0 or 1: chains along the space diagonal, which have a direct tiling. For C up to
    2 this is the complete set.
    """
    c = check_colors(colors)
    if c <= 2:
        return _complete(CORNER_CUBE, c)
    radices = (c,) * _SED + (2,) + (c,) * (7 - _SED)
    family = Family("compact-corner-cube", {"colors": c, "choices": 2})
    return RuledTileSet(CORNER_CUBE, c, "compact-2", family, radices, _step_to_sed, _sed_to_step)


def compact_wang_cubes(colors: int = 2) -> TileSet:
    """2 C^3 Wang cubes: two for each way the N, W and U faces can be.

    S = 2 N + b, E = 2 W + b and D = 2 U + b modulo C for b = 0 and 1. Only in this order is there always a
    choice: for even C most ways the S, E and D faces could be do not occur. Over two colors 16 cubes thus
    suffice to fill space non-periodically, where Cohen et al. 2003, section 5, speak of 32. Where C is a
    power of two the set has a direct tiling from one bit per cube.
    """
    c = check_colors(colors)
    family = Family("compact-wang-cube" if c > 1 else "wang-cube", {"colors": c})
    return RuledTileSet(WANG_CUBE, c, "compact", family, (c, c, c, min(c, 2)), _bit_to_faces, _faces_to_bit)


def _complete(shape: Shape, c: int) -> TileSet:
    family = Family(shape.name, {"colors": c})
    return RuledTileSet(shape, c, "complete", family, (c,) * len(shape.slots), _same, _same)


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
