"""Points on a Penrose tiling, numbered in the Fibonacci system and moved by tabulated vectors.

Ostromoukhov, Donohue & Jodoin 2004; Lagae 2007, section 6.8.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import log, pi, sqrt
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress, TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key

PHI = (1 + sqrt(5)) / 2
TURNS = np.exp(1j * pi / 10 * np.arange(20))
"""The directions that tiles can have, x + i y."""
INDICES = 21
"""Importance indices: steps in which the density grows by PHI^2."""
STRUCTURES = 21
"""Structural indices: the values of 6 digits of the Fibonacci system."""

# A tile has a reference point, a direction and a type: A and B are sampling points, C and D skinny and
# E and F fat halves of rhombs. Vertices as seen from the reference point, in a frame of direction 0 whose
# unit is the tile's scale.
A, B, C, D, E, F = range(6)
_SKINNY = (0, 1, PHI * TURNS[4])
_FAT = (0, PHI**2, PHI * TURNS[2])
_VERTICES = ((0,), (0,), _SKINNY, _SKINNY, _FAT, _FAT)

# What a tile is made of one level below, where the scale is shorter by PHI: each part's type, the vertex
# that its reference point is at, of the tile (-1) or of an earlier part, its turn in steps of pi / 10, and
# the two digits that it adds to the code.
_00, _10, _01 = 0b00, 0b01, 0b10
_PARTS: tuple[tuple[tuple[int, int, int, int, int], ...], ...] = (
    ((B, -1, 0, 0, _00),),
    ((A, -1, 0, 10, _00),),
    ((F, -1, 2, 14, _00), (C, -1, 1, 6, _10), (A, 0, 2, 1, _10)),
    ((E, -1, 1, 6, _00), (D, 0, 2, 14, _10)),
    ((C, -1, 2, 12, _10), (E, -1, 1, 8, _01), (F, -1, 0, 0, _00), (A, 0, 1, 7, _10)),
    ((F, -1, 2, 12, _01), (E, 0, 2, 0, _00), (D, 1, 2, 8, _10), (A, 0, 2, 15, _01)),
)

_ROOM = 16
"""How many times larger than needed the first tile is, so that seeds find different windows in it."""
_BORDER = 3
"""In scales: how far around the box points are kept that may be moved into it."""
_TRIES = 20
_AREA = abs(_FAT[1] * _FAT[2].imag) / 2
_INRADIUS = 2 * _AREA / (PHI**2 + 2 * PHI)
VECTORS = Path(__file__).with_name("penrose_vectors.npy")


def penrose_points(
    count: int, *, seed: Seed = 0, box: Box | None = None, progress: Progress | None = None
) -> PointSet:
    """Take about ``count`` vertices of a Penrose tiling, moved by tabulated vectors.

    The tiling is subdivided again and again; each vertex has a code that says at which density it appears.
    The vertices with codes up to a threshold are kept. They move by vectors that depend on the last digits
    of the code and on the threshold. The relative radius is then 0.75 to 0.82, at every density; without the
    vectors it is 0.50 to 0.81. The spectrum shows the tiling: stars of high peaks with tenfold symmetry.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1; it comes to within a few of it, often exactly.
    seed : int or numpy.random.Generator, optional
        Which window of the tiling the box shows: 0 to 2^64 - 1, or a generator; default 0. The tiling is
        always the same and is not turned.
    box : Box, optional
        A plain rectangle; by default the unit square. The points do not go around a torus.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    PointSet
        In the order of their codes; no distance is promised. ``figures["importance"]`` is the threshold,
        ``figures["level"]`` the number of subdivisions.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The box is a torus or not a plane, or a number is out of range.

    Notes
    -----
    Ostromoukhov, Donohue & Jodoin 2004; Lagae 2007, section 6.8. Departs from the paper in how the vectors
    are made (their own table, see ``tools/penrose_relaxation.py``) and in the threshold, which is found from
    the number of points instead of given by a density. Unlike the authors' program it leaves no holes (Lagae
    2007, figure 6.16): all tiles in the box are subdivided.
    """
    domain = Box(torus=False) if box is None else check_box(box, plane="the Penrose method")
    if domain.torus:
        raise TilewrightValueError(
            "is a torus; Penrose points do not go around one",
            argument="box",
            advice=f"give Box({domain.extent}, torus=False)",
        )
    n = check_count(count, 400)
    window = Window.choose(domain, seed)
    vectors = load_vectors()
    points, importance, level = find_importance(
        n, window, lambda samples, v: keep_inside(samples.moved(v, vectors), domain), progress
    )
    figures = {"importance": importance, "level": level}
    return PointSet(points, domain, "penrose", 0.0, figures)


@dataclass(frozen=True)
class Window:
    """Which part of the tiling is looked at.

    Attributes
    ----------
    extent : tuple of float
        Width and height.
    corner : complex
        Where the box's corner (0, 0) is, from the reference point of the first tile, which is of type F.
    scale : float
        The scale of the first tile.
    """

    extent: tuple[float, ...]
    corner: complex
    scale: float

    @classmethod
    def choose(cls, box: Box, seed: Seed, room: float = _ROOM) -> "Window":
        """A window by chance, all of it inside of the first tile."""
        half = complex(*box.extent) / 2
        reach = 1.5 * abs(half)
        scale = room * reach / _INRADIUS
        triangle = scale * np.array(_FAT)
        sides = np.abs(np.roll(triangle, -1) - np.roll(triangle, 1))
        middle = (sides * triangle).sum() / sides.sum()
        # Centers at least ``reach`` from the sides fill a smaller triangle around the same middle.
        inner = middle + (1 - 1 / room) * (triangle - middle)
        a, b = np.sort(np.random.default_rng(int(make_key(seed))).random(2))
        # Summed by hand: what a library for matrices gives depends on the processor in its last digit.
        center = inner[0] * a + inner[1] * (b - a) + inner[2] * (1 - b)
        return cls(box.extent, complex(center - half), scale)

    @property
    def importance_each(self) -> float:
        """How much the threshold rises for each point: every second number below it is a code of a point."""
        return 2 * _AREA * self.scale**2 / (self.extent[0] * self.extent[1])


@dataclass(frozen=True, eq=False)
class Samples:
    """Sampling points of one level in and around a window.

    Attributes
    ----------
    points : complex128 array, shape (n,)
        x + i y, as seen from the box's corner.
    directions : int64 array, shape (n,)
        0 to 19, indices of `TURNS`.
    structures : int64 array, shape (n,)
        Structural indices.
    values : int64 array, shape (n,)
        The codes as numbers, rising; no two are the same.
    scale : float
        Of the tiles.
    """

    points: NDArray[np.complex128]
    directions: NDArray[np.int64]
    structures: NDArray[np.int64]
    values: NDArray[np.int64]
    scale: float

    def kept(self, importance: int) -> int:
        """How many points have codes up to a threshold; they come first."""
        return int(np.searchsorted(self.values, importance, side="right"))

    def moved(self, importance: int, vectors: NDArray[np.complex128]) -> NDArray[np.complex128]:
        """The points up to a threshold, moved."""
        first = slice(0, self.kept(importance))
        own = vectors[importance_index(importance), self.structures[first]]
        return self.points[first] + own * TURNS[self.directions[first]] * self.scale


def find_samples(window: Window, level: int) -> Samples:
    """Subdivide the first tile ``level`` times, leaving out what does not reach the window."""
    half = np.array(window.extent) / 2
    center = window.corner + complex(*half)
    types, points = np.array([F]), np.array([-center])
    directions, codes = np.zeros(1, np.int64), np.zeros(1, np.int64)
    scale = window.scale
    for _ in range(level):
        types, points, directions, codes = _subdivide(types, points, directions, codes, scale)
        scale /= PHI
        reach = half + scale * (_BORDER + PHI**2)
        near = (np.abs(points.real) < reach[0]) & (np.abs(points.imag) < reach[1])
        types, points, directions, codes = types[near], points[near], directions[near], codes[near]
    points, directions, codes = (a[types <= B] for a in (points, directions, codes))
    values = code_values(codes, 2 * level)
    order = np.argsort(values)
    structures = code_values(codes & 63, 6)
    return Samples(
        points[order] + half[0] + 1j * half[1], directions[order], structures[order], values[order], scale
    )


def _subdivide(
    types: NDArray[np.int64],
    points: NDArray[np.complex128],
    directions: NDArray[np.int64],
    codes: NDArray[np.int64],
    scale: float,
) -> tuple[NDArray[np.int64], NDArray[np.complex128], NDArray[np.int64], NDArray[np.int64]]:
    """Replace every tile by its parts."""
    made = []
    for tile in range(6):
        own = types == tile
        p, d, c = points[own], directions[own], codes[own]
        for part, at, turn, digits in _PLACED[tile]:
            place = p + at * scale * TURNS[d]
            made.append((np.full(len(p), part), place, (d + turn) % 20, 4 * c + digits))
    t, p, d, c = (np.concatenate(column) for column in zip(*made, strict=True))
    return t, p, d, c


def _place_parts(tile: int) -> list[tuple[int, complex, int, int]]:
    """The parts of a tile with their reference points in its frame."""
    placed: list[tuple[int, complex, int, int]] = []
    for part, owner, vertex, turn, digits in _PARTS[tile]:
        if owner < 0:
            at = complex(_VERTICES[tile][vertex])
        else:
            kind, start, facing, _ = placed[owner]
            at = start + TURNS[facing] * _VERTICES[kind][vertex] / PHI
        placed.append((part, at, turn, digits))
    return placed


_PLACED = tuple(_place_parts(tile) for tile in range(6))


def fibonacci(n: int) -> int:
    """F_n, with F_1 = F_2 = 1."""
    before, this = 1, 0
    for _ in range(n):
        before, this = this, before + this
    return this


def code_values(codes: NDArray[np.int64], digits: int) -> NDArray[np.int64]:
    """Codes as numbers of the Fibonacci system: the digits, from the highest bit on, count F_2, F_3 ..."""
    values = np.zeros(len(codes), np.int64)
    for i in range(digits):
        values += (codes >> (digits - 1 - i) & 1) * fibonacci(i + 2)
    return values


def importance_level(importance: int) -> int:
    """How often to subdivide: until there are codes up to the threshold, which are below F_(2 level + 2)."""
    level = 1
    while fibonacci(2 * level + 2) <= importance:
        level += 1
    return level


def importance_index(importance: int) -> int:
    """floor(21 (log(1 + sqrt 5 importance) / log PHI^2 mod 1))."""
    return int(INDICES * (log(1 + sqrt(5) * importance) / log(PHI**2) % 1))


Take = Callable[[Samples, int], NDArray[np.float64]]
"""``take(samples, importance)``: the points that a threshold leaves in the box."""


def find_importance(
    count: int, window: Window, take: Take, progress: Progress | None = None
) -> tuple[NDArray[np.float64], int, int]:
    """The points of the threshold that leaves about ``count`` of them; the threshold, and its level."""
    each = window.importance_each
    importance = max(1, round(count * each))
    known: dict[int, Samples] = {}
    best: tuple[int, NDArray[np.float64], int, int] | None = None
    for done in range(_TRIES):
        if progress is not None:
            progress(done, _TRIES, "thresholding")
        level = importance_level(importance)
        if level not in known:
            known[level] = find_samples(window, level)
        points = take(known[level], importance)
        missing = count - len(points)
        if best is None or abs(missing) < best[0]:
            best = abs(missing), points, importance, level
        if missing == 0:
            break
        importance = max(1, importance + round(missing * each))
    assert best is not None
    return best[1:]


def keep_inside(points: NDArray[np.complex128], box: Box) -> NDArray[np.float64]:
    """The points that lie in the box, as float64, shape (n, 2)."""
    width, height = box.extent
    inside = (points.real >= 0) & (points.real < width) & (points.imag >= 0) & (points.imag < height)
    return np.ascontiguousarray(np.stack([points.real, points.imag], axis=1)[inside])


def load_vectors() -> NDArray[np.complex128]:
    """The tabulated vectors, shape (importance indices, structural indices), in scales, x + i y."""
    pairs: NDArray[np.float64] = np.load(VECTORS).astype(np.float64)
    return pairs[..., 0] + 1j * pairs[..., 1]
