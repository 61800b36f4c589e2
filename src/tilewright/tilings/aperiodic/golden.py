"""Jeandel-Rao's and Ammann's tiles: rotations of a torus by the golden ratio, found by Labbé.

A cell is a point of a torus, a step east or north moves the point by a fixed vector, and the tile is the part
of the torus that the point lies in. Real numbers are integers of 2^-384.

Rounding decides nothing. The point starts at (a / p, b / p), with a prime p that divides neither a nor b.
Each border between parts is on a line u x + v y = w, with u, v and w in Z[phi], such that p does not divide
u a + v b. So the point stays off all borders; and within +-2^61 cells it stays off by more than 2^-140, since
p times the distance is in Z[phi] without being 0, so that its norm is at least 1.
"""

from math import isqrt

from tilewright.tiles import TileSet
from tilewright.tiles.aperiodic import aperiodic_tiles
from tilewright.tilings.aperiodic.rotations import BITS, TURN, RotationTiling, Row

_POINT = 384
ONE = 1 << _POINT
PHI = (ONE + isqrt(5 << (2 * _POINT))) >> 1
_INVERSE = PHI - ONE
_ROUNDING = 1 << 100
_PRIME = 2**31 - 1


def _times(a: int, b: int) -> int:
    return (a * b) >> _POINT


def _turns(part: int) -> int:
    """A part of the circle, 0 up to ONE, in the units of a `Row`."""
    return (part >> (_POINT - BITS)) % TURN


class _TorusTiling(RotationTiling):
    """A tiling that starts at a point of the torus that goes with the seed."""

    def __init__(self, tiles: TileSet, seed: int) -> None:
        super().__init__(tiles, seed)
        self._x, self._y = ((1 + self.drawn(axis, _PRIME - 1)) * ONE // _PRIME for axis in (0, 1))


# --- Jeandel and Rao ----------------------------------------------------------------------------------

_ABSCISSAS = (0, 2 * ONE - PHI, PHI - ONE, ONE, PHI)
_ORDINATES = (0, ONE, 2 * ONE, PHI + ONE, PHI + 2 * ONE, PHI + 3 * ONE)
# The partition P_0 of Labbé 2021, figure 5: for each tile polygons of vertices, as digits that count into the
# abscissas and ordinates above.
_POLYGONS = (
    "00 20 21, 20 30 31, 30 40 41",
    "00 01 21, 20 21 31, 30 31 41",
    "02 03 24",
    "31 32 44 42",
    "02 24 34, 24 34 35",
    "03 04 24, 04 14 15, 14 24 35",
    "04 05 15, 14 15 35, 34 35 45",
    "33 34 44, 34 44 45, 01 02 34",
    "21 22 44",
    "01 21 22, 21 31 32, 31 41 42",
    "01 33 34",
)


def _polygon_edges() -> list[tuple[int, list[tuple[int, int, int, int, int]]]]:
    """Each polygon's tile and its edges that are not level: lower y, upper y, an end's x and y, dx / dy."""
    polygons = []
    for tile, listed in enumerate(_POLYGONS):
        for polygon in listed.split(", "):
            ends = [(_ABSCISSAS[int(v[0])], _ORDINATES[int(v[1])]) for v in polygon.split()]
            edges = []
            for (x0, y0), (x1, y1) in zip(ends, ends[1:] + ends[:1], strict=True):
                if y0 != y1:
                    edges.append((min(y0, y1), max(y0, y1), x0, y0, ((x1 - x0) << _POINT) // (y1 - y0)))
            polygons.append((tile, edges))
    return polygons


class JeandelRaoTiling(_TorusTiling):
    """A tiling by the 11 tiles of Jeandel and Rao, in its form with 5 or with 4 colors.

    The torus is R^2 / <(phi, 0), (1, phi + 3)>, a step east adds (1, 0), a step north (0, 1) (Labbé 2021,
    Annales Henri Lebesgue 4:283-324, theorem 1; arXiv:1903.06137). These are the tilings of Labbé's minimal
    subshift X_0.
    """

    def __init__(self, tiles: TileSet, seed: int) -> None:
        super().__init__(tiles, seed)
        # Color 4 and color 0 are told apart by the rest of the tile.
        alike = {tuple(color % 4 for color in slots): tile for slots, tile in self.index_of.items()}
        order = [alike[tuple(slots)] for slots in aperiodic_tiles("jeandel-rao-11-4").slots.tolist()]
        self._polygons = [(order[tile], edges) for tile, edges in _polygon_edges()]

    def row(self, y: int) -> Row:
        """Row y: a level cut through the torus."""
        turns, height = divmod(self._y - y * ONE, PHI + 3 * ONE)
        cuts = []
        for tile, edges in self._polygons:
            ends = [
                x + _times(height - y0, slope) for low, high, x, y0, slope in edges if low <= height < high
            ]
            if ends:
                cuts.append((_turns(_times(max(min(ends), 0), _INVERSE)), tile))
        borders, tiles = zip(*sorted(cuts), strict=True)
        start = _turns(_times(self._x - turns * ONE, _INVERSE))
        return Row(start, _turns(_INVERSE), (0, *borders[1:]), tiles)


# --- Ammann -------------------------------------------------------------------------------------------

_LABELS = {(0, 0, 0): 0, (0, 0, 1): 1, (0, 1, 1): 2, (0, 1, 2): 3, (1, 1, 1): 4, (1, 1, 2): 5}


def _label(x: int, y: int) -> int:
    """Color of the east edge of the tile at (x, y) (Labbé 2025, theorem C)."""
    rest = y + ONE - _INVERSE
    sums = (rest, _times(x, _INVERSE) + rest, _times(x, PHI) + rest)
    return _LABELS[tuple(s >> _POINT for s in sums)]  # type: ignore[index]


class AmmannTiling(_TorusTiling):
    """A tiling by Ammann's 16 Wang tiles.

    The torus is R^2 / Z^2, a step east adds (1 / phi, 0), a step north (0, 1 / phi); a tile's colors are
    floors of x and y and their multiples by phi and 1 / phi (Labbé 2025, "Metallic mean Wang tiles II",
    theorem C with n = 1; arXiv:2403.03197).
    """

    def row(self, y: int) -> Row:
        """Row y: a level cut through the torus."""
        height = (self._y - y * _INVERSE) % ONE
        below = (height - _INVERSE) % ONE
        borders = _ammann_borders(height, below)
        middles = [(a + b) >> 1 for a, b in zip(borders, [*borders[1:], ONE], strict=True)]
        slots = [
            (
                _label(height, x),
                _label(x, height),
                _label(below, x),
                _label((x - _INVERSE) % ONE, height),
            )
            for x in middles
        ]
        tiles = tuple(self.index_of[tile] for tile in slots)
        return Row(_turns(self._x), _turns(_INVERSE), tuple(map(_turns, borders)), tiles)


def _ammann_borders(height: int, below: int) -> list[int]:
    """Where on a level cut a color can change."""
    # Of the east edge: x / phi + y - 1 / phi or phi x + y - 1 / phi is an integer k.
    east = [_times(_INVERSE - height, PHI)] + [
        _times(k * ONE + _INVERSE - height, _INVERSE) for k in range(3)
    ]
    east = [0, *(x for x in east if 0 < x < ONE)]
    west = [(x + _INVERSE) % ONE for x in east]
    # Of north and south edges: the same with x and y exchanged.
    level = [_INVERSE - _times(y, factor) for y in (height, below) for factor in (_INVERSE, PHI)]
    found = sorted([*east, *west, _INVERSE, *(x % ONE for x in level)])
    # Some of them are the same number, but for rounding.
    return [b for a, b in zip([-ONE, *found], found, strict=False) if b - a > _ROUNDING]
