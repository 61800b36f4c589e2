"""Walls of bricks of one size, to compare with: running and Flemish bond, herringbone, basket weave."""

from collections.abc import Callable
from dataclasses import dataclass
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, type_error
from tilewright.errors import TilewrightValueError
from tilewright.fields.bricks.patterns import SIZE, BrickPattern, Range, check_size
from tilewright.tilings import Domain

_LONGEST_PERIOD = 2**24
Units = NDArray[np.int64]
Found = tuple[Units, Units, Units, Units]


class BondBricks(BrickPattern):
    """Bricks of one size, laid as bricklayers do.

    Parameters
    ----------
    bond : str
        ``"running-bond"``: courses shifted by half a brick. ``"flemish-bond"``: bricks and half bricks in
        turn. ``"herringbone"``: bricks at right angles, in zigzags. ``"basket-weave"``: as many bricks as
        make a square, turned from square to square. Names of `ALIASES` will do too, such as
        ``"stretcher-bond"`` or ``"subway"``.
    size : (int, int), optional
        Width and height of a brick in pixels, with half the mortar around it; default (144, 48). The width is
        a multiple of 2 (running) or 4 (flemish), or of the height (herringbone, basket weave).
    period : (int or None, int or None), optional
        Multiples of that width and height after which the wall repeats, for walls that close; by default the
        wall does not repeat along either axis.

    Raises
    ------
    TilewrightTypeError
        A size or period that is not two numbers.
    TilewrightValueError
        An unknown bond, a width that does not go with it, or a period after which it does not close.

    Notes
    -----
    The id of a brick is the north-western of the units that it is made of.

    Examples
    --------
    >>> import tilewright as tw
    >>> wall = tw.BondBricks("running-bond", size=(24, 8))
    >>> wall.bricks(0, 0, 48, 32).sides.shape
    (10, 4)
    """

    def __init__(
        self, bond: str, size: tuple[int, int] = SIZE, period: tuple[int | None, int | None] = (None, None)
    ) -> None:
        bond = check_bond("bond", bond)
        self._bond = BONDS[bond]
        width, self.course = check_size("size", size)
        parts = self._bond.parts
        if width % (parts or self.course):
            rule = f"{parts}" if parts else f"its height, {self.course}"
            raise TilewrightValueError(
                f"is {width} x {self.course}; for {bond} the width must be a multiple of {rule}",
                argument="size",
            )
        self.length = parts or width // self.course
        self.unit = (width // self.length, self.course)
        self.thinnest = min(self.course, width // self._bond.shortest)
        self.domain = Domain.plane(self._close(bond, period))

    def _close(self, bond: str, period: Any) -> tuple[int | None, ...]:
        """The period in units, checked."""
        if not isinstance(period, (tuple, list)) or len(period) != 2:
            raise type_error("period", period, "a tuple of 2 numbers or None")
        units: list[int | None] = []
        for axis, count in enumerate(period):
            each, repeat = (self.length, 1)[axis], self._repeat[axis]
            least = lcm(each, repeat) // each
            if count is not None and check_int("period", count, 1, _LONGEST_PERIOD) % least:
                raise TilewrightValueError(
                    f"is {count} along {'xy'[axis]}; {bond} closes after multiples of {least}",
                    argument="period",
                    value=count,
                )
            units.append(None if count is None else count * each)
        return tuple(units)

    @property
    def _repeat(self) -> tuple[int, int]:
        """Units along x and y after which the bond repeats."""
        return self._bond.repeat or (2 * self.length, 2 * self.length)

    def _around(self, across: Range, down: Range) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        first = (across[0], down[0])
        phase = np.array([n % every for n, every in zip(first, self._repeat, strict=True)])
        x, y = np.meshgrid(phase[0] + np.arange(across[1]), phase[1] + np.arange(down[1]))
        found = np.stack(self._bond.find(x.ravel(), y.ravel(), self.length), axis=1)
        found = np.unique(found, axis=0)
        offset = found[:, :2] - phase
        ids = [_fold(n + offset[:, axis], self.domain.periods[axis]) for axis, n in enumerate(first)]
        sides = np.concatenate([offset, offset + found[:, 2:]], axis=1) * np.tile(self.unit, 2)
        return sides, np.stack(ids, axis=1)


@dataclass(frozen=True)
class Bond:
    """How bricks of one size are laid, in units that they are made of.

    Attributes
    ----------
    parts : units along a brick, or None where they are as long as a brick is high.
    repeat : units after which the bond repeats along x and y, or None for two bricks.
    shortest : the shortest brick is this part of a whole one.
    find : from units x, y and the units along a brick, the brick that holds each: its first unit x, y, and
        how many units it is wide and high.
    """

    parts: int | None
    repeat: tuple[int, int] | None
    shortest: int
    find: Callable[[Units, Units, int], Found]


def _running(x: Units, y: Units, length: int) -> Found:
    return x - (x + y) % 2, y, np.full_like(x, 2), np.ones_like(x)


def _flemish(x: Units, y: Units, length: int) -> Found:
    at = (x + 3 * (y % 2)) % 6
    half = at >= 4
    return x - at + 4 * half, y, np.where(half, 2, 4), np.ones_like(x)


def _herringbone(x: Units, y: Units, length: int) -> Found:
    """The bond repeats along (1, 1), so x - y tells the place in a brick that lies, or in one that stands."""
    at = (x - y) % (2 * length)
    lies = at < length
    left = np.where(lies, x - at, x)
    top = np.where(lies, y, y - (2 * length - 1 - at))
    return left, top, np.where(lies, length, 1), np.where(lies, 1, length)


def _basket(x: Units, y: Units, length: int) -> Found:
    lies = (x // length + y // length) % 2 == 0
    left, top = np.where(lies, x - x % length, x), np.where(lies, y, y - y % length)
    return left, top, np.where(lies, length, 1), np.where(lies, 1, length)


BONDS = {
    "running-bond": Bond(2, (2, 2), 1, _running),
    "flemish-bond": Bond(4, (6, 2), 2, _flemish),
    "herringbone": Bond(None, None, 1, _herringbone),
    "basket-weave": Bond(None, None, 1, _basket),
}
ALIASES = {
    "running": "running-bond",
    "stretcher": "running-bond",
    "stretcher-bond": "running-bond",
    "half-bond": "running-bond",
    "subway": "running-bond",
    "flemish": "flemish-bond",
    "herringbone-90": "herringbone",
    "basketweave": "basket-weave",
    "basket": "basket-weave",
}
"""Other names that bricklayers and tilers use; a herringbone is laid along the sides, not at 45 degrees."""


def check_bond(name: str, value: str, *others: str) -> str:
    """The name of a bond by which `BONDS` knows it; ``others`` are allowed beside them."""
    known = ALIASES.get(value, value) if isinstance(value, str) else value
    if known not in BONDS and known not in others:
        allowed = ", ".join((*others, *BONDS))
        raise TilewrightValueError(
            argument=name, value=value, allowed=allowed, advice=f"or by another name: {', '.join(ALIASES)}"
        )
    return known


def _fold(units: Units, period: int | None) -> Units:
    return units if period is None else units % period
