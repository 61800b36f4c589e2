"""The algorithms of direct tilings: from a window of cells to the colors of each slot.

Hashes color the integer lattice; slots follow from the colors around a cell. Windows are given by a
`Lattice`; colors are arrays ``[y, x]`` (``[x]`` for dominoes, ``[z, y, x]`` for cubes).
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import gcd, lcm

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import slot_type
from tilewright.tilings.chains import Chains, Span, closed_walks, meet, open_walks
from tilewright.tilings.domain import fold
from tilewright.tilings.hashes import Colors, LatticeHash, as_grid
from tilewright.tilings.streams import BITS, COLORS, MARKS, SECOND

Slots = tuple[Colors, ...]


@dataclass(frozen=True)
class Lattice:
    """A window of cells, and what colors its lattice; x comes first in every tuple."""

    tiles: TileSet
    hash: LatticeHash
    periods: tuple[int | None, ...]
    start: tuple[int, ...]
    extent: tuple[int, ...]

    def points(self, axis: int, before: int = 0) -> NDArray[np.int64]:
        """Lattice coordinates around the window, one more than cells, and ``before`` more in front."""
        return fold(self.start[axis] - before, self.extent[axis] + 1 + before, self.periods[axis])

    def cells(self, axis: int, before: int = 0) -> NDArray[np.int64]:
        """Cell coordinates of the window, and ``before`` more in front."""
        return fold(self.start[axis] - before, self.extent[axis] + before, self.periods[axis])

    def span(self, axis: int) -> Span:
        """The lattice coordinates around the window, not folded."""
        return Span(self.start[axis], self.extent[axis] + 1, self.periods[axis])

    @property
    def axes(self) -> range:
        """Numbers of the axes, x first."""
        return range(len(self.start))


# --- Corners ------------------------------------------------------------------------------------------


def corners(at: Lattice) -> Colors:
    """Complete corner sets: a hash at the lattice points (Lagae 2007, section 3.3.1, with y mirrored)."""
    return at.hash.grid(at.tiles.colors[0], COLORS, *(at.points(a) for a in at.axes))


def classed(at: Lattice) -> Colors:
    """`classed_corner_tiles`: a hash at the lattice points chooses among the colors of their classes."""
    count, rows = at.tiles.parameters["colors"], row_classes(at)
    classes = (column_classes(at) + rows[:, np.newaxis]) % at.tiles.parameters["classes"]
    hashed = at.hash.grid(count, COLORS, at.points(0), at.points(1))
    return (classes * count + hashed).astype(slot_type(at.tiles.colors))


def column_classes(at: Lattice) -> NDArray[np.int64]:
    """Class of each lattice point of row 0; a period that classes do not go into is refused."""
    classes, step = at.tiles.parameters["classes"], at.tiles.parameters["step"]
    for axis, factor in enumerate((1, step)):
        period, unit = at.periods[axis], classes // gcd(classes, factor)
        if period is not None and period % unit:
            below = max(unit, period - period % unit)
            raise TilewrightValueError(
                f"is {period} along {'xy'[axis]}; {classes} classes of lattice points repeat after {unit}",
                argument="period",
                value=period,
                allowed=f"multiples of {unit} along {'xy'[axis]}",
                advice=f"take {below} or {below + unit}",
            )
    return at.points(0) % classes


def row_classes(at: Lattice) -> NDArray[np.int64]:
    """What the class of each row's lattice points is ahead of that in row 0."""
    classes, step = at.tiles.parameters["classes"], at.tiles.parameters["step"]
    # Coordinates first, so that no product is too large.
    return at.points(1) % classes * step % classes


def marks(at: Lattice) -> Colors:
    """Corner-coded sets: the marks are hashed apart from the edges."""
    return at.hash.grid(at.tiles.colors[-1], MARKS, *(at.points(a) for a in at.axes))


def columns(at: Lattice) -> Colors:
    """`column_corner_tiles`: every column of lattice points is a chain."""
    chains = Chains(at.hash, at.tiles.colors[0], at.tiles.parameters["choices"])
    height = at.periods[1]
    if height is None:
        return open_walks(chains, at.span(1), (at.span(0),), slope=0)
    chains.check_length(height)
    x, y = at.points(0)[np.newaxis, :], at.points(1)[:, np.newaxis]
    return closed_walks(chains, (x,), y, height)


def diagonals(at: Lattice) -> Colors:
    """Compact corner sets and cubes: every diagonal from the corner NW (and U) on is a chain."""
    chains = Chains(at.hash, at.tiles.colors[0], at.tiles.parameters["choices"])
    endless = [a for a in at.axes if at.periods[a] is None]
    if endless:
        # Positions run along an endless axis: there the chains never close.
        along = endless[-1]
        across = tuple(at.span(a) for a in at.axes if a != along)
        colors = open_walks(chains, at.span(along), across, slope=1)
        return np.moveaxis(colors, 0, len(at.axes) - 1 - along)
    sizes = [p for p in at.periods if p is not None]
    chains.check_length(lcm(*sizes))
    position, *others = as_grid(tuple(at.points(a) for a in at.axes))
    names, length = [], sizes[0]
    for other, size in zip(others, sizes[1:], strict=True):
        name, position, length = meet(position, length, other, size)
        names.append(name)
    return closed_walks(chains, tuple(names), position, length)


def corner_slots(c: Colors) -> Slots:
    """Slots of the cells between colored lattice points: NE, SE, SW, NW; of cubes, of either face."""
    if c.ndim == 3:
        return tuple(slot for face in (c[:-1], c[1:]) for slot in _face(face))
    return _face(c)


def _face(c: Colors) -> Slots:
    return c[..., :-1, 1:], c[..., 1:, 1:], c[..., 1:, :-1], c[..., :-1, :-1]


def free(at: Lattice) -> Slots:
    """`free_tiles`: a hash at the cells."""
    return (at.hash.grid(at.tiles.colors[0], COLORS, *(at.cells(a) for a in at.axes)),)


# --- Edges and faces ----------------------------------------------------------------------------------


def ends(at: Lattice) -> Slots:
    """Dominoes: a hash at the integers; slots E, W."""
    c = at.hash.grid(at.tiles.colors[0], COLORS, at.points(0))
    return c[1:], c[:-1]


def edges(at: Lattice) -> Slots:
    """Complete Wang sets: one hash on a lattice twice as dense (Lagae 2007, section 3.3.2.3).

    An edge lies where exactly one coordinate is even; so does a face of a cube.
    """
    planes = []
    for axis in at.axes:
        grid = (2 * at.points(a) if a == axis else 2 * at.cells(a) + 1 for a in at.axes)
        planes.append(at.hash.grid(_edge_colors(at.tiles, axis), COLORS, *grid))
    return _edge_slots(planes)


def crossings(at: Lattice) -> Slots:
    """`crossed_wang_tiles`: the edges of a complete Wang set, and at every corner those that meet there."""
    c = at.tiles.colors[0]
    columns = at.hash.grid(c, COLORS, 2 * at.points(0), 2 * at.points(1, 1) + 1)
    rows = at.hash.grid(c, COLORS, 2 * at.points(0, 1) + 1, 2 * at.points(1))
    codes = ((columns[:-1] * c + rows[:, 1:]) * c + columns[1:]) * c + rows[:, :-1]
    n, e, s, w = rows[:-1, 1:-1], columns[1:-1, 1:], rows[1:, 1:-1], columns[1:-1, :-1]
    return (n, e, s, w, *corner_slots(codes))


def two_hashes(at: Lattice) -> Slots:
    """Complete Wang sets from sums of two corner colorings (Lagae 2007, section 3.3.2.1)."""
    c_h, c_v = at.tiles.colors[:2]
    h = at.hash.grid(c_h, COLORS, at.points(0), at.points(1))
    v = at.hash.grid(c_v, SECOND, at.points(0), at.points(1))
    # Sums of two colors may not fit the type of one.
    h, v = h.astype(np.uint32), v.astype(np.uint32)
    return _edge_slots([(v[:-1] + v[1:]) % c_v, (h[:, :-1] + h[:, 1:]) % c_h])


def sums(at: Lattice) -> Slots:
    """`summed_wang_tiles` from one corner coloring (Lagae 2007, section 3.3.2.2)."""
    count = at.tiles.colors[0]
    c = at.hash.grid(count, COLORS, at.points(0), at.points(1))
    return _edge_slots([(c[:-1] + c[1:]) % count, (c[:, :-1] + c[:, 1:]) % count])


def bits(at: Lattice) -> Slots:
    """`shifted_wang_tiles` and `compact_wang_cubes`, C = 2^m: a color is the bits of the m tiles before."""
    m = at.tiles.colors[0].bit_length() - 1
    beta = at.hash.grid(2, BITS, *(at.cells(a, before=m) for a in at.axes))
    planes = []
    for axis in at.axes:
        inside = tuple(slice(0 if a == axis else m, None) for a in reversed(at.axes))
        planes.append(_history(beta[inside], beta.ndim - 1 - axis, m))
    return _edge_slots(planes)


def _history(beta: Colors, array_axis: int, m: int) -> Colors:
    """Number made of the m bits before each plane along an axis, the latest lowest."""
    beta = np.moveaxis(beta, array_axis, 0)
    count = len(beta) - m
    total = np.zeros((count + 1, *beta.shape[1:]), np.uint8)
    for back in range(1, m + 1):
        total += beta[m - back : m - back + count + 1] << np.uint8(back - 1)
    return np.moveaxis(total, 0, array_axis)


def _edge_colors(tiles: TileSet, axis: int) -> int:
    """How many colors the edges (faces) across an axis have."""
    return tiles.colors[tiles.shape.slot("WNU"[axis])]


def _edge_slots(planes: list[Colors]) -> Slots:
    """N, E, S, W (, U, D) of the cells between colored edges across x, y (, z)."""
    slots = []
    for axis, plane in enumerate(planes):
        moved = np.moveaxis(plane, plane.ndim - 1 - axis, 0)
        slots.append([np.moveaxis(half, 0, plane.ndim - 1 - axis) for half in (moved[:-1], moved[1:])])
    (west, east), (north, south), *upper_lower = slots
    return (north, east, south, west, *(face for pair in upper_lower for face in pair))


# --- Algorithms ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Algorithm:
    """How a direct tiling finds the colors of every slot of a window; it travels between processes.

    Attributes
    ----------
    name : str
    slots : callable
        From a `Lattice` to one array like the window for each slot.
    base : Algorithm or None
        Of corner-coded sets, what finds the edges.
    """

    name: str
    slots: Callable[[Lattice], Slots]
    base: "Algorithm | None" = None

    def __repr__(self) -> str:
        return f"<Algorithm {self.name}>"


def _of_corners(name: str, colors: Callable[[Lattice], Colors]) -> Algorithm:
    return Algorithm(name, partial(_slots_of_corners, colors))


def _slots_of_corners(colors: Callable[[Lattice], Colors], at: Lattice) -> Slots:
    return corner_slots(colors(at))


def _marked(base: Algorithm) -> Algorithm:
    """Edges by another algorithm, and marks at the corners."""
    return Algorithm(f"marked-{base.name}", partial(_slots_with_marks, base), base)


def _slots_with_marks(base: Algorithm, at: Lattice) -> Slots:
    return base.slots(at) + corner_slots(marks(at))


CORNERS = _of_corners("corners", corners)
CLASSED = _of_corners("classed", classed)
EDGES = Algorithm("edges", edges)
TWO_HASHES = Algorithm("two-hashes", two_hashes)
_DIAGONALS = _of_corners("diagonals", diagonals)
_BITS = Algorithm("bits", bits)
_OF_FAMILY = {
    "domino": Algorithm("ends", ends),
    "corner": CORNERS,
    "corner-cube": CORNERS,
    "classed": CLASSED,
    "wang": EDGES,
    "wang-cube": EDGES,
    "compact-corner": _DIAGONALS,
    "compact-corner-cube": _DIAGONALS,
    "columns": _of_corners("columns", columns),
    "summed": Algorithm("sums", sums),
    "shifted": _BITS,
    "compact-wang-cube": _BITS,
    "crossed": Algorithm("crossings", crossings),
    "free": Algorithm("free", free),
}
_MARKED = {family: _marked(algorithm) for family, algorithm in _OF_FAMILY.items()}


def recognize(tiles: TileSet) -> Algorithm | None:
    """The algorithm that goes with a set, by its family; None where there is none."""
    parameters = tiles.parameters
    algorithms, family = _OF_FAMILY, tiles.family
    if family == "corner-coded":
        algorithms, family = _MARKED, parameters["base"]
    algorithm = algorithms.get(family)
    needs_bits = algorithm is not None and (algorithm.base or algorithm) is _BITS
    return None if needs_bits and not _is_power_of_two(parameters["colors"]) else algorithm


def _is_power_of_two(number: int) -> bool:
    return number & (number - 1) == 0
