"""Conditions as rules on single cells: what solvers are given.

Every strip of cells that is one too long must hold a tile outside the condition's tiles. Where some cells are
settled, a strip with such a tile among them asks nothing more; of the others only the open cells matter.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.tilings.clauses import Clauses, Literals
from tilewright.tilings.dappled.conditions import Conditions, Integers


def open_strips(
    tiling: NDArray[Any], open_: NDArray[np.bool_], conditions: Conditions, *, cyclic: bool
) -> Iterator[tuple[tuple[int, ...], Integers]]:
    """Strips that must hold, in an open cell, a tile outside the given ones.

    Yields the tiles and the flat numbers of the open cells, shape (strips, cells); a strip that has no open
    cell left to mend it is a row of no cells. tiling : (h, w), tiles of the cells that are not open.
    """
    shape = (tiling.shape[0], tiling.shape[1])
    flat, is_open = tiling.ravel(), open_.ravel()
    for limit, strips in conditions.windows(shape, cyclic=cyclic):
        inside = np.isin(flat, limit.tiles)
        strips = strips[(is_open | inside)[strips].all(axis=1)]
        counts = is_open[strips].sum(axis=1)
        for count in np.unique(counts):
            ours = strips[counts == count]
            yield limit.tiles, ours[is_open[ours]].reshape(len(ours), count)


@dataclass
class Formula:
    """The SAT form of a dappled tiling (Kaji et al. 2016, section 6 (8)).

    Attributes
    ----------
    clauses : Clauses
    variables : int32 array, shape (open cells, T)
        The variable that says that a cell holds a tile. With two tiles the one of tile 0 is the negative of
        that of tile 1.
    """

    clauses: Clauses
    variables: Literals
    open: NDArray[np.bool_]

    def tiles_of(self, values: NDArray[np.bool_]) -> NDArray[np.int64]:
        """The tile of each open cell in a solution."""
        true = values[np.abs(self.variables)] == (self.variables > 0)
        return np.argmax(true, axis=1)

    def literals(self, tiling: NDArray[Any]) -> Literals:
        """For each open cell the literal that says that it holds its tile of ``tiling``."""
        return self.variables[np.arange(len(self.variables)), tiling[self.open]]


def write_formula(
    tiling: NDArray[Any], open_: NDArray[np.bool_], conditions: Conditions, *, cyclic: bool
) -> Formula:
    """Clauses whose solutions are the dappled tilings that agree with ``tiling`` where it is not open."""
    clauses = Clauses()
    count = int(open_.sum())
    if conditions.tiles == 2:
        is_one = clauses.variables(count)
        variables = np.stack([-is_one, is_one], axis=1)
    else:
        variables = clauses.variables(count, conditions.tiles)
        clauses.exactly_one(variables)
    place = np.full(tiling.size, -1)
    place[open_.ravel()] = np.arange(count)
    for tiles, strips in open_strips(tiling, open_, conditions, cyclic=cyclic):
        others = [t for t in range(conditions.tiles) if t not in tiles]
        if not strips.shape[1] or not others:
            contradiction = clauses.variables(1)
            clauses.add([[contradiction[0]], [-contradiction[0]]])
            continue
        clauses.add(variables[place[strips]][:, :, others].reshape(len(strips), -1))
    return Formula(clauses, variables, open_)
