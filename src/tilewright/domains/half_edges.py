"""Half-edges: the sides of faces, each with the one that runs the other way along the same edge."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class HalfEdges:
    """The sides of the faces of a mesh, numbered as its corners: half-edge h begins at corner h.

    Attributes
    ----------
    origins : int64 array, shape (H,)
        The vertex where each begins.
    starts : int64 array, shape (F + 1,)
        Where the half-edges of each face start and end.
    twins : int64 array, shape (H,)
        The half-edge that runs the other way along the same edge; -1 on the boundary.
    """

    origins: NDArray[np.int64]
    starts: NDArray[np.int64]
    twins: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.origins)

    @cached_property
    def faces(self) -> NDArray[np.int64]:
        """The face that each half-edge is a side of, int64, shape (H,)."""
        return np.repeat(np.arange(len(self.starts) - 1), np.diff(self.starts))

    @cached_property
    def nexts(self) -> NDArray[np.int64]:
        """The half-edge after each, counter-clockwise around its face, int64, shape (H,)."""
        return next_corners(self.starts)

    @cached_property
    def prevs(self) -> NDArray[np.int64]:
        """The half-edge before each, int64, shape (H,)."""
        before = np.empty_like(self.nexts)
        before[self.nexts] = np.arange(len(self))
        return before

    @cached_property
    def edges(self) -> NDArray[np.int64]:
        """The edge that each lies on, numbered from 0 on in the order of their first half-edges, (H,)."""
        first = (self.twins < 0) | (np.arange(len(self)) < self.twins)
        numbers = np.cumsum(first) - 1
        return np.where(first, numbers, numbers[self.twins])

    @cached_property
    def around(self) -> NDArray[np.int64]:
        """The next half-edge counter-clockwise about the same origin, -1 where the surface ends, (H,)."""
        return self.twins[self.prevs]


def next_corners(starts: NDArray[np.int64]) -> NDArray[np.int64]:
    """The corner after each corner of the faces that start at ``starts``."""
    after = np.arange(1, starts[-1] + 1)
    after[starts[1:] - 1] = starts[:-1]
    return after


def pair(origins: NDArray[np.int64], targets: NDArray[np.int64]) -> NDArray[np.int64]:
    """The twin of each half-edge where exactly one runs each way along its edge, else -1."""
    low, high = np.minimum(origins, targets), np.maximum(origins, targets)
    key = low * (int(high.max()) + 1) + high
    order = np.argsort(key, kind="stable")
    firsts = np.flatnonzero(np.diff(key[order], prepend=-1))
    alone = np.diff(firsts, append=len(key)) == 2
    one, other = order[firsts[alone]], order[firsts[alone] + 1]
    opposed = origins[one] == targets[other]
    twins = np.full(len(origins), -1)
    twins[one[opposed]], twins[other[opposed]] = other[opposed], one[opposed]
    return twins
