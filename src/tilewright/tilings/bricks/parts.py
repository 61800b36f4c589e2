"""Which boundaries of a region a brick wall can meet, and a wall that does, in linear time.

Cells are nodes and the edges between them that are not given are links; a part is a connected component.
At a cell exactly one of N = S and E = W holds.

*Trees.* Let a part be a tree, and pass from its leaves to a root what the edge to each parent may carry.
If the edge opposite may carry a set O, then O may be carried on where the other two edges can differ, and
all but one color, or all, where they can be equal. One of both is always so. So these sets are never empty;
each is all colors, one color, or all but one, which is closed under this rule; and the tree has a wall if
and only if its root has a tile (the constraints "any", "equals c" and "differs from c" of Derouet-Jourdan,
Kaji & Mizoguchi 2019).

*Two positions.* For each cell N + E + S + W is odd. Summed over a part, links count twice, so the given
edges must add up to the number of cells, modulo 2, unless an edge of the boundary is free. That suffices:
colors of all links but those of a spanning tree can be chosen at will, the cells but the root then each
determine the edge to their parent, and the root's sum is right because all the others are.

*Three and more positions.* A part with a cycle always has a wall. Give any colors to the links that are
neither on the cycle nor in the trees that hang on it; the trees leave one color or more for each edge from
the cycle, of which take one. So a cell on the cycle has two edges on it, called in and out, and two with a
color. Where the cycle goes straight on, out is asked to equal in, or to differ from it. Where it turns, in
has an opposite color e and out an opposite color s, and exactly one of in = e and out = s must hold. On the
stretch from one turn to the next, let x be 1 if the color out of the first is its s, and y be 1 if the color
into the second is its e. If nothing on the stretch differs and s = e, (x, y) is (0, 0) or (1, 1). If
nothing does and s is not e, or one cell does and s = e, it can be (0, 0), (0, 1) and (1, 0), as there is a
third color. Otherwise it can be anything. At a turn, the x of the next stretch must be 1 - y. So the first
kind of stretch leads from x to 1 - x, the others from x to x and from 0 to 1. A cycle in the plane has an
even number of turns. If an even number of stretches is of the first kind, let the others keep x: it returns
to itself. If an odd number is, there is another, which may lead from 0 to 1, and the rest leads back to 0.
A wall is found by trying all colors of one link of a cycle: once the links outside a spanning tree have
colors, the part is a tree.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError

Cells = NDArray[np.bool_]
Choices = NDArray[np.uint32]
_NORTH, _EAST, _SOUTH, _WEST = range(4)


@dataclass(frozen=True)
class Links:
    """Whether there is a link from each cell to the next one east, and south; bool arrays (h, w)."""

    east: Cells
    south: Cells


@dataclass(frozen=True)
class Parts:
    """The parts of a region as a spanning forest.

    Attributes
    ----------
    order : int64 array, shape (cells,): the numbers y w + x of cells, parents before children.
    parent : uint8 array, shape (h, w): at which side the parent is, in the order N, E, S, W; 4 at roots.
    part : int32 array, shape (h, w): the part of each cell, -1 outside.
    count : how many parts there are.
    """

    order: NDArray[np.int64]
    parent: NDArray[np.uint8]
    part: NDArray[np.int32]
    count: int


def find_links(inside: Cells, across: NDArray[np.int8], upright: NDArray[np.int8]) -> Links:
    """The edges between two cells of a region that are not given."""
    links = Links(np.zeros_like(inside), np.zeros_like(inside))
    links.east[:, :-1] = inside[:, :-1] & inside[:, 1:] & (upright[:, 1:-1] < 0)
    links.south[:-1] = inside[:-1] & inside[1:] & (across[1:-1] < 0)
    return links


def find_parts(inside: Cells, links: Links) -> Parts:
    """A spanning forest of the links."""
    from tilewright.kernels.brick_regions import order_cells

    order = np.empty(np.count_nonzero(inside), np.int64)
    parent, part = np.full(inside.shape, 255, np.uint8), np.full(inside.shape, -1, np.int32)
    return Parts(order, parent, part, order_cells(inside, links.east, links.south, order, parent, part))


def lay_parts(
    parts: Parts,
    links: Links,
    across: NDArray[np.int8],
    upright: NDArray[np.int8],
    n: int,
    rng: np.random.Generator,
) -> None:
    """Fill in positions wherever they are -1 and the edge has a cell; or raise, with the reason."""
    from tilewright.kernels.brick_regions import settle_cells

    wide, tall = _as_choices(across, n), _as_choices(upright, n)
    failed = gather_parts(parts, links, wide, tall, n, rng)
    if failed.any():
        raise TilewrightValueError(_explain(parts, failed, across, upright, n))
    settle_cells(parts.order, wide, tall, rng.integers(0, 2**32, parts.part.shape, np.uint32))
    for positions, choices in ((across, wide), (upright, tall)):
        single = choices & (choices - 1) == 0
        positions[single] = np.log2(choices[single]).astype(np.int8)


def gather_parts(
    parts: Parts, links: Links, wide: Choices, tall: Choices, n: int, rng: np.random.Generator
) -> NDArray[np.bool_]:
    """Pass to the roots what each edge may carry, a bit for each position; which parts have no wall.

    Links outside the forest get random colors. One of them in each part takes on other colors in turn, as
    long as the part fails.
    """
    from tilewright.kernels.brick_regions import gather_choices

    # Step 1: the links outside the forest, and one of them in each part that has any.
    spare = _find_spare(parts, links)
    spares = ((tall[:, 1:], spare.east), (wide[1:], spare.south))
    chosen = np.full((2, parts.count), -1, np.int64)
    for first, (choices, cells) in zip(chosen, spares, strict=True):
        choices[cells] = 1 << rng.integers(0, n, np.count_nonzero(cells))
        at = np.flatnonzero(cells)
        first[parts.part.ravel()[at]] = at
    chosen[1, chosen[0] >= 0] = -1
    # Step 2: the colors of those, one after another.
    full = np.uint32((1 << n) - 1)
    failed = np.zeros(parts.count, bool)
    for turn in range(n):
        gather_choices(parts.order, parts.parent, parts.part, wide, tall, full, failed)
        again = chosen[:, failed]
        if turn == n - 1 or (again < 0).all():
            break
        for (choices, _), at in zip(spares, again, strict=True):
            y, x = np.divmod(at[at >= 0], parts.part.shape[1])
            following = choices[y, x] << np.uint32(1)
            choices[y, x] = np.where(following > full, np.uint32(1), following)
    return failed


def _as_choices(positions: NDArray[np.int8], n: int) -> Choices:
    """What each edge may carry, a bit for each position."""
    given = np.uint32(1) << positions.clip(0).astype(np.uint32)
    return np.where(positions < 0, np.uint32((1 << n) - 1), given)


def _find_spare(parts: Parts, links: Links) -> Links:
    """The links that are not in the forest."""
    east, south = parts.parent == _EAST, parts.parent == _SOUTH
    east[:, :-1] |= parts.parent[:, 1:] == _WEST
    south[:-1] |= parts.parent[1:] == _NORTH
    return Links(links.east & ~east, links.south & ~south)


def _explain(
    parts: Parts, failed: NDArray[np.bool_], across: NDArray[np.int8], upright: NDArray[np.int8], n: int
) -> str:
    """Why the first part that failed has no wall."""
    cells = parts.part == np.argmax(failed)
    count, (y, x) = np.count_nonzero(cells), np.argwhere(cells)[0]
    what = f"the {count} cells around" if count > 1 else "the cell at"
    others = np.count_nonzero(failed) - 1
    more = f" (nor {others} other parts of the region)" if others else ""
    start = f"{what} x={x}, y={y}{more} cannot be tiled with the given positions: "
    if n > 2:
        return start + (
            "there is no ring of cells among them, and what is given leaves some cell without a tile; "
            "change a position or leave one free (-1)"
        )
    sides = (across[:-1], across[1:], upright[:, :-1], upright[:, 1:])
    total = sum(int(side[cells & (side >= 0)].sum()) for side in sides)
    return start + (
        f"those at its boundary add up to {total}, which with 2 positions must be "
        f"{'odd' if count % 2 else 'even'} as the number of cells is; change one or leave one free (-1)"
    )
