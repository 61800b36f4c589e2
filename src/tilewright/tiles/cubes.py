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
    family = Family("compact-corner-cube", {"colors": c, "choices": 2})
    return RuledTileSet(CORNER_CUBE, c, "compact-2", family, radices, _step_to_sed, _sed_to_step)


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
