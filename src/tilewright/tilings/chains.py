"""Random walks that can be evaluated anywhere: the direct tiling of compact sets.

A chain is a sequence of colors in which each follows from the last and one random digit,
c' = (d c + digit) mod C. Walks are pinned to hashed anchor colors at regular positions, and the digits
between two anchors are a random number among those that lead from one to the other. See
``docs/compact-direct.md``.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tilings.hashes import LatticeHash

_ANCHORS, _DIGITS = 2, 3


@dataclass(frozen=True)
class Chains:
    """Colors along chains numbered by integers.

    Attributes
    ----------
    hash : LatticeHash
    colors : C.
    digits : d, how many colors may follow each.
    length : steps after which a chain closes on itself, or None.
    """

    hash: LatticeHash
    colors: int
    digits: int
    length: int | None = None

    def __post_init__(self) -> None:
        if self.length is not None and self.digits**self.length < self.colors:
            raise TilewrightValueError(
                f"the period closes chains after {self.length} steps, too few to return to any of "
                f"{self.colors} colors; take a period with at least {self._fewest} steps"
            )

    @property
    def _fewest(self) -> int:
        """Steps that can lead from any color to any other."""
        steps = 1
        while self.digits**steps < self.colors:
            steps += 1
        return steps

    @property
    def block(self) -> int:
        """Steps between anchors: enough that every color is reached about equally often."""
        steps = 1
        while self.digits**steps < 2**20:
            steps += 1
        return steps

    def color(self, chain: NDArray[np.int64], position: NDArray[np.int64]) -> NDArray[np.uint8]:
        """Color at positions of chains; the arguments are broadcast."""
        # Step 1: the block of the position, its first position and its length.
        block, first, steps = self._blocks(position)
        step = position - first
        # Step 2: the colors at both of its ends.
        following = block + 1 if self.length is None else (block + 1) % max(1, self.length // self.block)
        start = self.hash.colors(self.colors, _ANCHORS, chain, block).astype(np.int64)
        end = self.hash.colors(self.colors, _ANCHORS, chain, following).astype(np.int64)
        # Step 3: a random number whose digits lead from one to the other.
        powers = self.digits ** np.arange(2 * self.block + 1, dtype=np.int64)
        whole = powers[steps]
        rest = (end - whole * start) % self.colors
        choices = (whole - 1 - rest) // self.colors + 1
        number = rest + self.colors * ((self.hash.numbers(_DIGITS, chain, block) * choices) >> 24)
        # Step 4: follow its first digits.
        return ((powers[step] * start + number // powers[steps - step]) % self.colors).astype(np.uint8)

    def _blocks(
        self, position: NDArray[np.int64]
    ) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
        """Number, first position and length of the block each position is in.

        A chain that closes after L steps has L // block of them; the last one takes what remains.
        """
        block = position // self.block
        if self.length is None:
            return block, block * self.block, np.full_like(block, self.block)
        count = max(1, self.length // self.block)
        block = np.minimum(block, count - 1)
        first = block * self.block
        return block, first, np.where(block == count - 1, self.length - first, self.block)
