"""Which family a set is of, told by its tiles alone: also when it comes from a file, in another order.

Each family is a closed form: a condition that a tile must meet, and how many tiles meet it. No tile is there
twice, so a set whose tiles all meet the condition, and which has so many, is the family's.
"""

from collections.abc import Callable
from math import isqrt, prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.tiles.shape import (
    CORNER,
    CORNER_CODED,
    CORNER_CUBE,
    DOMINO,
    FREE,
    WANG,
    WANG_CUBE,
    Shape,
)
from tilewright.tiles.tileset import CUSTOM, MOST_FAMILY_COLORS, Family, Slots, decode, encode

Column = NDArray[np.int32]
_COMPLETE = (DOMINO, WANG, CORNER, WANG_CUBE, CORNER_CUBE, FREE)
_LARGEST_TABLE = 2**20


def tell_family(shape: Shape, colors: tuple[int, ...], slots: Slots) -> Family:
    """The family of a listed set, `CUSTOM` where none is known."""
    if shape is CORNER_CODED:
        return _tell_coded(colors, slots)
    if shape in _COMPLETE and len(slots) == prod(colors):
        return Family(shape.name, _name_colors(shape, colors))
    tell = _INCOMPLETE.get(shape)
    # Classes multiply the colors of corners.
    most = MOST_FAMILY_COLORS ** (2 if shape is CORNER else 1)
    if tell is None or not all(c <= most for c in colors):
        return CUSTOM
    return tell(colors, [column.astype(np.int32) for column in slots.T]) or CUSTOM


def _name_colors(shape: Shape, colors: tuple[int, ...]) -> dict[str, Any]:
    if shape is FREE:
        return {"count": colors[0]}
    if shape is WANG:
        return {"colors": colors[0], "vertical_colors": colors[1]}
    return {"colors": colors[0] if len(set(colors)) == 1 else colors}


def _tell_corner(colors: tuple[int, ...], slots: list[Column]) -> Family | None:
    """`classed_corner_tiles`, `corner_tiles` with choices, and `column_corner_tiles`."""
    ne, se, sw, nw = slots
    c, count = colors[0], len(ne)
    if classed := _tell_classed(c, slots):
        return classed
    if c > MOST_FAMILY_COLORS:
        return None
    d, root = count // c**3, isqrt(count)
    if 2 <= d < c and count == d * c**3 and _all_below(d, se - d * nw, c):
        return Family("compact-corner", {"colors": c, "choices": d})
    d = root // c
    if 2 <= d < c and count == (d * c) ** 2 and _all_below(d, sw - d * nw, c):
        return Family("columns", {"colors": c, "choices": d}) if _all_below(d, se - d * ne, c) else None
    return None


def _tell_classed(total: int, slots: list[Column]) -> Family | None:
    """Whether corners go through classes from west to east by ones and from north to south by steps."""
    count = len(slots[0])
    for c in range(1, total // 2 + 1):
        k = total // c
        if k * c != total or k * c**4 != count or max(c, k) > MOST_FAMILY_COLORS:
            continue
        step = class_step(k)
        ne, se, sw, nw = (column // c for column in slots)
        found = all(not ((there - nw - by) % k).any() for there, by in ((ne, 1), (sw, step), (se, 1 + step)))
        return Family("classed", {"colors": c, "classes": k, "step": step}) if found else None
    return None


def class_step(classes: int) -> int:
    """The step a for which like points, (x + a y) mod k, lie farthest apart; the smallest of several."""
    reach = range(-classes, classes + 1)

    def nearest(step: int) -> int:
        return min(x * x + y * y for x in reach for y in reach if (x or y) and (x + step * y) % classes == 0)

    return max(range(1, classes), key=nearest, default=1)


def _tell_wang(colors: tuple[int, ...], slots: list[Column]) -> Family | None:
    """`summed_wang_tiles`, `shifted_wang_tiles`, `compact_wang_tiles` and `brick_tiles`."""
    n, e, s, w = slots
    (c, d), count = colors[:2], len(n)
    if c == d and count == c**3 and not ((n + s - e - w) % c).any():
        return Family("summed", {"colors": c})
    if c == d and count == 2 * c**2 and _all_bits(c, s - 2 * n, e - 2 * w):
        return Family("shifted", {"colors": c})
    if count == 2 * c * d and _is_compact(n, e, s, w, c, d):
        return Family("compact-wang", {"colors": c, "vertical_colors": d})
    if c == d and count == 2 * c**2 * (c - 1) and ((n == s) != (e == w)).all():
        return Family("bricks", {"positions": c})
    return None


def _is_compact(n: Column, e: Column, s: Column, w: Column, c: int, d: int) -> bool:
    """Whether b = 0 or 1 has S = N + b + 2 W and E = W + b + 2 S."""
    across, down = (e - w - 2 * s) % d, (s - n - 2 * w) % c
    bits = [(down == b % c) & (across == b % d) for b in (0, 1)]
    return bool((bits[0] | bits[1]).all())


def _tell_wang_cube(colors: tuple[int, ...], slots: list[Column]) -> Family | None:
    """`compact_wang_cubes`."""
    n, e, s, w, u, d = slots
    c = colors[0]
    if len(set(colors)) == 1 and len(n) == 2 * c**3 and _all_bits(c, s - 2 * n, e - 2 * w, d - 2 * u):
        return Family("compact-wang-cube", {"colors": c})
    return None


def _tell_corner_cube(colors: tuple[int, ...], slots: list[Column]) -> Family | None:
    """`compact_corner_cubes`."""
    c = colors[0]
    sed, nwu = slots[CORNER_CUBE.slot("SED")], slots[CORNER_CUBE.slot("NWU")]
    if len(sed) == 2 * c**7 and _all_below(2, sed - 2 * nwu, c):
        return Family("compact-corner-cube", {"colors": c, "choices": 2})
    return None


_INCOMPLETE: dict[Shape, Callable[[tuple[int, ...], list[Column]], Family | None]] = {
    CORNER: _tell_corner,
    WANG: _tell_wang,
    WANG_CUBE: _tell_wang_cube,
    CORNER_CUBE: _tell_corner_cube,
}


def _tell_coded(colors: tuple[int, ...], slots: Slots) -> Family:
    """`crossed_wang_tiles`, and Wang sets in all combinations of marks."""
    c, marks = colors[0], set(colors[4:])
    if c <= 2 and colors == (c,) * 4 + (c**4,) * 4 and len(slots) == c**12 and _is_crossed(slots, c):
        return Family("crossed", {"colors": c})
    if len(marks) > 1:
        return CUSTOM
    if len(slots) == prod(colors):
        family = Family(WANG.name, _name_colors(WANG, colors))
    else:
        base = _distinct(slots[:, :4], colors[:4])
        if len(slots) != len(base) * prod(colors[4:]):
            return CUSTOM
        family = tell_family(WANG, colors[:4], base)
    return Family("corner-coded", {"base": family.name, **family.parameters, "marks": colors[4]})


def _is_crossed(slots: Slots, c: int) -> bool:
    """Whether corners are told by the edges around them, ((north c + east) c + south) c + west."""
    n, e, s, w, ne, se, sw, nw = (column.astype(np.int32) for column in slots.T)
    west, south, east, north = c**0, c**1, c**2, c**3
    known = [
        (n, ne, west), (e, ne, south), (e, se, north), (s, se, west),
        (s, sw, east), (w, sw, north), (w, nw, south), (n, nw, east),
    ]  # fmt: skip
    return all(bool((code // place % c == edge).all()) for edge, code, place in known)


def _distinct(slots: Slots, colors: tuple[int, ...]) -> Slots:
    """Tiles, each once."""
    codes, most = encode(slots, colors), prod(colors)
    if most > _LARGEST_TABLE:
        return decode(np.unique(codes), colors)
    there = np.zeros(most, bool)
    there[codes] = True
    return decode(there.nonzero()[0], colors)


def _all_below(most: int, values: Column, c: int) -> bool:
    """Whether all values are below ``most`` modulo c."""
    return bool((values % c < most).all())


def _all_bits(c: int, first: Column, *others: Column) -> bool:
    """Whether values are one and the same bit, modulo c."""
    bits = first % c
    return bool((bits < 2).all()) and all(not ((other - bits) % c).any() for other in others)
