"""How many dappled tilings there are, exactly, by transfer from cell to cell."""

from collections import Counter
from collections.abc import Mapping

import numpy as np

from tilewright.checks import check_flag, check_int, check_progress
from tilewright.errors import Progress, TilewrightValueError
from tilewright.tilings.dappled.conditions import NEVER, Conditions, Most, as_mapping

_MOST_STATES = 200_000
_MOST_STEPS = 50_000_000
"""Tiles laid on states: some minutes' work."""
_MOST_SIDE = 10_000

Track = tuple[int, int]
"""What a line remembers for one condition: the run it began with, and the run that ends here.

The first is -1 while the line has held nothing but the condition's tiles; it stays 0 where lines end.
"""


def count_dappled(
    width: int,
    height: int,
    limits: Mapping[str, Most] | Conditions,
    *,
    cyclic: bool = False,
    tiles: int | None = None,
    totals: Mapping[int, int] | None = None,
    progress: Progress | None = None,
) -> int:
    """Count the dappled tilings of a rectangle or torus, exactly; translations are counted apart.

    Parameters
    ----------
    width : int
        Cells along x, 1 to 10,000. The work grows with the number of states of the shorter side: about 3^12
        for 12 cells and limits of 2.
    height : int
        Cells along y, 1 to 10,000.
    limits : mapping of str to longest run, or Conditions
        Such as ``{"H0": 2, "V1": 2}``; see `Conditions`. Limits must be constant.
    cyclic : bool, optional
        Whether rows and columns close to rings, so that the tiling can be repeated; default False.
    tiles : int, optional
        Number of tiles, 2 to 256; by default one more than the largest that is named.
    totals : mapping of int to int, optional
        Count only tilings in which this number of cells holds a tile; by default all.
    progress : callable, optional
        Called as ``progress(done, total, what)`` after every row; raise `Cancelled` from it to stop.

    Returns
    -------
    int
        The number of tilings, of any size.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        Limits that vary, more than 200,000 states, or work for more than some minutes.

    Notes
    -----
    For {H_0^2, V_1^2} these are the numbers that remark 1.4 of Kaji et al. 2016 points to (OEIS A206994). The
    totals are of section 6 (6). The method, a transfer from cell to cell, is ours.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.count_dappled(3, 3, {"H0": 2, "V1": 2})
    174
    """
    check_progress(progress)
    check_int("width", width, 1, _MOST_SIDE)
    check_int("height", height, 1, _MOST_SIDE)
    check_flag("cyclic", cyclic)
    conditions = Conditions(limits, tiles)
    wanted = dict(sorted(as_mapping("totals", totals).items()))
    for tile, count in wanted.items():
        check_int("a tile of totals", tile, 0, conditions.tiles - 1)
        check_int("a count of totals", count, 0, width * height)
    transfer = _Transfer(conditions, cyclic, tuple(wanted))
    if width > height:  # the states remember a row: let it be the shorter side
        transfer.along, transfer.down = transfer.down, transfer.along
        width, height = height, width
    states: Counter[tuple] = Counter({((transfer.fresh(transfer.down),) * width, (0,) * len(wanted)): 1})
    for y in range(height):
        if len(states) * width * conditions.tiles * (height - y) > _MOST_STEPS:
            raise TilewrightValueError(
                f"counting on from row {y} of {height} takes {len(states):,} states",
                advice="ask for fewer cells",
            )
        states = transfer.row(states, width)
        if progress is not None:
            progress(y + 1, height, "counting rows")
    asked = tuple(wanted.values())
    return sum(
        number
        for (columns, seen), number in states.items()
        if seen == asked and all(transfer.closes(transfer.down, column) for column in columns)
    )


class _Transfer:
    """From the states before a row to those after it. A state is what every column remembers."""

    def __init__(self, conditions: Conditions, cyclic: bool, counted: tuple[int, ...]) -> None:
        self.tiles, self.cyclic, self.counted = conditions.tiles, cyclic, counted
        self.along, self.down = (self._limits(conditions, axis) for axis in (0, 1))

    def _limits(self, conditions: Conditions, axis: int) -> list[tuple[frozenset[int], int]]:
        found = []
        for limit in conditions.limits:
            if callable(limit.most) or np.unique(limit.most).size > 1:
                raise TilewrightValueError(
                    f"the limit of {limit} varies over cells; counting needs constant ones"
                )
            if limit.axis == axis and limit.most.flat[0] < NEVER:
                found.append((frozenset(limit.tiles), int(limit.most.flat[0])))
        return found

    def fresh(self, limits: list[tuple[frozenset[int], int]]) -> tuple[Track, ...]:
        """What an empty line remembers."""
        return ((-1 if self.cyclic else 0, 0),) * len(limits)

    def step(
        self, limits: list[tuple[frozenset[int], int]], line: tuple[Track, ...], tile: int
    ) -> tuple[Track, ...] | None:
        """The line with one more tile; None where a run gets too long."""
        after = []
        for (inside, most), (lead, run) in zip(limits, line, strict=True):
            if tile in inside:
                if run == most:
                    return None
                after.append((lead, run + 1))
            else:
                after.append((run if lead < 0 else lead, 0))
        return tuple(after)

    def closes(self, limits: list[tuple[frozenset[int], int]], line: tuple[Track, ...]) -> bool:
        """Whether a finished line is dappled: as a ring, its last run goes on in its first."""
        if not self.cyclic:
            return True
        return all(
            lead >= 0 and lead + run <= most for (_, most), (lead, run) in zip(limits, line, strict=True)
        )

    def row(self, states: Counter[tuple], width: int) -> Counter[tuple]:
        """Lay one row, cell by cell."""
        start = self.fresh(self.along)
        partial: Counter[tuple] = Counter({(*state, start): number for state, number in states.items()})
        for x in range(width):
            after: Counter[tuple] = Counter()
            for (columns, seen, line), number in partial.items():
                for tile in range(self.tiles):
                    along = self.step(self.along, line, tile)
                    down = self.step(self.down, columns[x], tile)
                    if along is not None and down is not None:
                        counts = tuple(n + (tile == t) for n, t in zip(seen, self.counted, strict=True))
                        after[(*columns[:x], down, *columns[x + 1 :]), counts, along] += number
            if len(after) > _MOST_STATES:
                raise TilewrightValueError(
                    f"counting takes more than {_MOST_STATES} states for rows of {width} cells",
                    advice="ask for fewer cells along the shorter side",
                )
            partial = after
        done: Counter[tuple] = Counter()
        for (columns, seen, line), number in partial.items():
            if self.closes(self.along, line):
                done[columns, seen] += number
        return done
