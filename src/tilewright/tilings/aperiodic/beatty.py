"""Kari's and Culik's tiles: every row writes a real number, and its tiles multiply it by a rational one.

A row stands for a number r. The edges on its one side carry the differences of floor(n r) along n, those on
the other side the differences of floor(n q r), with q = 2 or 2/3 (Kari 1996), 3 or 1/2 (Culik 1996); the
edges between its tiles carry q floor(n r) - floor(n q r), which takes few values. So the next row stands for
q r, and r runs through the orbit of a map of an interval onto itself, which has no period since no power of 2
is one of 3.

On a logarithmic scale that map is a rotation of the circle. So r is known for any row without those between,
to 2^-300. What is left to chance is that n r comes so close to an integer, 2^-180, that this does not tell on
which side: that is expected of one in 2^180 cells.
"""

from abc import abstractmethod
from dataclasses import dataclass
from decimal import Context, Decimal
from fractions import Fraction

from tilewright.tiles import TileSet
from tilewright.tilings.aperiodic.rotations import BITS, RotationTiling, Row
from tilewright.tilings.domain import LARGEST_CELL

_POINT = 320
_ONE = 1 << _POINT
_DIGITS = Context(prec=120)

Arcs = list[tuple[int, int, int, int]]
"""For each arc of a circle: difference on the side of r, on that of q r, color before the tile, behind it."""


@dataclass(frozen=True)
class Factor:
    """A number q that tiles multiply by.

    Attributes
    ----------
    numerator, denominator : int
    carries : dict
        Color of each value of q floor(n r) - floor(n q r), times the denominator.
    """

    numerator: int
    denominator: int
    carries: dict[int, int]

    def arcs(self, r: int) -> tuple[list[int], Arcs]:
        """Colors by n r modulo the denominator, in units of 2^-320: where each arc begins, and they."""
        p, q = self.numerator, self.denominator
        around = q * _ONE
        # The floors of n r and n q r change here; those of (n + 1) r and (n + 1) q r are one r before.
        changes = [k * _ONE for k in range(q)] + [k * around // p for k in range(p)]
        borders = sorted({*changes, *((c - r) % around for c in changes)})
        arcs = []
        for begin, end in zip(borders, [*borders[1:], around], strict=True):
            before = (begin + end) >> 1
            behind = before + r
            n, m = before >> _POINT, behind >> _POINT
            multiple_n, multiple_m = (p * v // q >> _POINT for v in (before, behind))
            carry_n, carry_m = p * n - q * multiple_n, p * m - q * multiple_m
            arcs.append((m - n, multiple_m - multiple_n, self.carries[carry_n], self.carries[carry_m]))
        return borders, arcs


class BeattyTiling(RotationTiling):
    """A tiling whose rows multiply by one factor below some number, by another from there on.

    Attributes
    ----------
    lowest, split, highest : Fraction
        The map's interval goes from ``lowest`` up to, not including, ``highest``; from ``split`` on the
        second factor holds.
    factors : (Factor, Factor)
    """

    lowest: Fraction
    split: Fraction
    highest: Fraction
    factors: tuple[Factor, Factor]

    def __init__(self, tiles: TileSet, seed: int) -> None:
        super().__init__(tiles, seed)
        self._turn = _logarithm(self.highest / self.lowest)
        part = _DIGITS.divide(self.drawn(0, _ONE), _ONE)
        self._start = _DIGITS.multiply(part, self._turn)
        self._step = _logarithm(Fraction(self.factors[0].numerator, self.factors[0].denominator))
        self._bottom = _logarithm(self.lowest)
        # Multiples on both sides of n = 0 mirror each other: they are kept out of the cells' reach.
        self._first = 2 * LARGEST_CELL + self.drawn(1, LARGEST_CELL)

    def number(self, times: int) -> int:
        """What the start becomes when the map is applied this number of times, in units of 2^-320."""
        way = _DIGITS.remainder(_DIGITS.add(self._start, _DIGITS.multiply(times, self._step)), self._turn)
        if way < 0:
            way = _DIGITS.add(way, self._turn)
        return int(_DIGITS.multiply(_DIGITS.exp(_DIGITS.add(self._bottom, way)), _ONE))

    def divides(self, r: int) -> bool:
        """Whether the second factor is applied to r."""
        return r * self.split.denominator >= self.split.numerator * _ONE

    def lay(self, r: int) -> Row:
        """The row of r."""
        factor = self.factors[self.divides(r)]
        borders, arcs = factor.arcs(r)

        def turns(v: int) -> int:
            return v // factor.denominator >> (_POINT - BITS)

        tiles = tuple(self.index_of[tile] for tile in self.slots(r, arcs))
        return Row(turns(self._first * r), turns(r), tuple(map(turns, borders)), tiles)

    @abstractmethod
    def slots(self, r: int, arcs: Arcs) -> list[tuple[int, int, int, int]]:
        """Colors N, E, S, W for each arc of the row of r."""


class KariTiling(BeattyTiling):
    """A tiling by Kari's 14 Wang tiles: rows go south along the orbit of r.

    Of r between 2/3 and 1 a row makes 2 r, of r between 1 and 2 it makes 2/3 r (Kari 1996, "A small aperiodic
    set of Wang tiles", Discrete Mathematics 160:259-264).
    """

    lowest, split, highest = Fraction(2, 3), Fraction(1), Fraction(2)
    factors = Factor(2, 1, {-1: 0, 0: 1}), Factor(2, 3, {0: 2, -1: 3, 1: 4, 2: 5})

    def row(self, y: int) -> Row:
        """Row y, which writes r above and q r below."""
        return self.lay(self.number(y))

    def slots(self, r: int, arcs: Arcs) -> list[tuple[int, int, int, int]]:
        """Colors N, E, S, W for each arc: N and S edges carry the differences themselves."""
        return [(here, behind, there, before) for here, there, before, behind in arcs]


class CulikTiling(BeattyTiling):
    """A tiling by Culik's 13 Wang tiles: rows go north along the orbit of r.

    Of r between 1/3 and 2/3 a row makes 3 r, of r between 2/3 and 2 it makes r / 2 (Culik 1996, "An aperiodic
    set of 13 Wang tiles", Discrete Mathematics 160:245-251; Eigen, Navarro & Prasad 2007). A difference of 0
    has two colors, one for each factor that the row of that number is multiplied by, which ties the rows to
    their factors.
    """

    lowest, split, highest = Fraction(1, 3), Fraction(2, 3), Fraction(2)
    factors = Factor(3, 1, {-2: 0, -1: 3, 0: 4}), Factor(1, 2, {0: 1, 1: 2})

    def row(self, y: int) -> Row:
        """Row y, which writes r below and q r above."""
        return self.lay(self.number(-y))

    def slots(self, r: int, arcs: Arcs) -> list[tuple[int, int, int, int]]:
        """Colors N, E, S, W for each arc: differences 0, 1, 2 are colors 0 or 1, 3 and 4."""
        factor = self.factors[self.divides(r)]
        above = r * factor.numerator // factor.denominator
        south, north = ((int(self.divides(number)), 3, 4) for number in (r, above))
        return [(north[there], behind, south[here], before) for here, there, before, behind in arcs]


def _logarithm(number: Fraction) -> Decimal:
    return _DIGITS.subtract(_DIGITS.ln(number.numerator), _DIGITS.ln(number.denominator))
