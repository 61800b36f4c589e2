"""Random walks that can be evaluated anywhere: the direct tiling of compact sets.

A chain is a sequence of colors in which each follows from the last and one random digit,
c' = (d c + digit) mod C. Walks are pinned to hashed anchor colors at regular positions, and the digits
between two anchors are a random number among those that lead from one to the other. See
``docs/compact-direct.md``.
"""

from dataclasses import dataclass
from math import gcd

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tilings.domain import fold
from tilewright.tilings.hashes import LatticeHash, as_grid
from tilewright.tilings.streams import ANCHORS, DIGITS

Integers = NDArray[np.int64]
_LONGEST = 2**62


@dataclass(frozen=True)
class Chains:
    """Colors along chains, each named by one or two integers.

    Attributes
    ----------
    hash : LatticeHash
    colors : C.
    digits : d, how many colors may follow each.
    """

    hash: LatticeHash
    colors: int
    digits: int

    @property
    def block(self) -> int:
        """Steps between anchors: enough that every color is reached about equally often."""
        return _steps_to(2**20, self.digits)

    def check_length(self, length: int) -> None:
        """Raise unless chains may close after ``length`` steps."""
        fewest = _steps_to(self.colors, self.digits)
        if length < fewest:
            raise TilewrightValueError(
                f"the period closes chains after {length} steps, too few to return to any of "
                f"{self.colors} colors",
                advice=f"take a period with at least {fewest} steps",
            )
        if length > _LONGEST:
            raise TilewrightValueError(
                f"the period closes chains after {length} steps; at most 2^62 are allowed"
            )

    def bridge(
        self, chain: tuple[ArrayLike, ...], block: ArrayLike, following: ArrayLike, steps: ArrayLike
    ) -> tuple[Integers, Integers]:
        """The color a block starts with, and the number whose digits lead from there to the next anchor."""
        start = self.hash.colors(self.colors, ANCHORS, *chain, block).astype(np.int64)
        end = self.hash.colors(self.colors, ANCHORS, *chain, following).astype(np.int64)
        whole = self._power(steps)
        rest = (end - whole * start) % self.colors
        choices = (whole - 1 - rest) // self.colors + 1
        number = (self.hash.numbers(DIGITS, *chain, block) * choices) >> 24
        return start, rest + self.colors * number

    def walk(self, start: Integers, number: Integers, step: ArrayLike, steps: ArrayLike) -> NDArray[np.uint8]:
        """Colors after some of a block's steps: the first digits of the number have been taken."""
        left = np.asarray(steps) - np.asarray(step)
        colors = (self._power(step) * start + number // self._power(left)) % self.colors
        return colors.astype(np.uint8)

    def _power(self, exponent: ArrayLike) -> Integers:
        powers = self.digits ** np.arange(self.block + 1, dtype=np.int64)
        return np.asarray(powers[np.asarray(exponent)])


@dataclass(frozen=True)
class Span:
    """``count`` coordinates from ``first`` on, along an axis that may repeat."""

    first: int
    count: int
    period: int | None = None


def open_walks(chains: Chains, along: Span, across: tuple[Span, ...], slope: int) -> NDArray[np.uint8]:
    """Colors of a window, for chains that never close.

    Chains advance ``slope`` along each axis of ``across`` for every step along the first axis. The result
    has the axis ``along`` first and then those of ``across``, in reversed order.
    """
    out = np.empty((along.count, *(a.count for a in reversed(across))), np.uint8)
    steps, end = chains.block, along.first + along.count
    for block in range(along.first // steps, (end - 1) // steps + 1):
        top, bottom = max(along.first, block * steps), min(end, (block + 1) * steps)
        # Step 1: every chain that crosses these positions, from the one that is last to reach the window.
        most = slope * (bottom - 1 - top)
        names = tuple(fold(a.first - slope * (bottom - 1), a.count + most, a.period) for a in across)
        start, number = chains.bridge(as_grid(names), block, block + 1, steps)
        # Step 2: at each position, one chain for each place across.
        for position in range(top, bottom):
            shift = slope * (bottom - 1 - position)
            here = tuple(slice(shift, shift + a.count) for a in reversed(across))
            out[position - along.first] = chains.walk(
                start[here], number[here], position - block * steps, steps
            )
    return out


def closed_walks(
    chains: Chains, chain: tuple[Integers, ...], position: Integers, length: int
) -> NDArray[np.uint8]:
    """Colors at positions of chains that close after ``length`` steps; the arguments are broadcast.

    A chain is cut into the fewest blocks that are not longer than `Chains.block`, as equal as can be.
    """
    count = -(-length // chains.block)
    short, longer = divmod(length, count)
    turn = longer * (short + 1)  # the blocks before this position are a step longer
    after = position >= turn
    steps = np.where(after, short, short + 1)
    block = np.where(after, longer + (position - turn) // short, position // (short + 1))
    first = np.where(after, turn + (block - longer) * short, block * (short + 1))
    start, number = chains.bridge(chain, block, (block + 1) % count, steps)
    return chains.walk(start, number, position - first, steps)


def meet(a: Integers, p: int, b: Integers, q: int) -> tuple[Integers, Integers, int]:
    """On a torus of p x q points: which diagonal a point (a, b) is on, where on it, and its length.

    There are gcd(p, q) diagonals, each closed after lcm(p, q) steps. The position is a modulo p, and the
    position less the diagonal's number is b modulo q.
    """
    g = gcd(p, q)
    chain = (a - b) % g
    turns = ((b + chain - a) // g) % (q // g) * pow(p // g, -1, q // g) % (q // g)
    return chain, a + p * turns, p * (q // g)


def _steps_to(reach: int, digits: int) -> int:
    """The fewest steps with ``reach`` outcomes."""
    steps = 1
    while digits**steps < reach:
        steps += 1
    return steps
