"""Poisson disk tiles of n corners, made when first asked for (Li et al. 2010, section III)."""

from dataclasses import dataclass, field
from threading import Lock

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int, check_real, range_error, shape_error
from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius
from tilewright.seeds import Seed, make_key
from tilewright.showing import describe, many
from tilewright.signals.points.dual.frames import Frames
from tilewright.signals.points.dual.places import to_cone, to_sectors
from tilewright.tiles.dual import canonical_slots

_TILE = 3
_FEWEST, _MOST = 12, 64
_LARGEST_RHO = 0.75
_MOST_COLORS = 16

_Tile = tuple[NDArray[np.uint8], NDArray[np.float32]]


@dataclass(frozen=True, eq=False)
class DualRows:
    """The points of several tiles, one after another.

    Attributes
    ----------
    starts : int64 array, shape (k + 1,)
        Where those of each tile start and end.
    sectors : uint8 array, shape (P,)
        The sector of its tile that each point lies in.
    points : float32 array, shape (P, 2)
        Where in the sector: its base from (0, 0) to (1, 0), its apex at (.5, .5). Those of a tile lie in the
        order in which they stay when points are left out.
    """

    starts: NDArray[np.int64]
    sectors: NDArray[np.uint8]
    points: NDArray[np.float32]

    def __repr__(self) -> str:
        return describe(self, many(len(self.starts) - 1, "tile"), many(len(self.points), "point"))


@dataclass(frozen=True, eq=False)
class DualPointTiles:
    """Points in tiles of any number of corners, which keep their distance wherever tiles fit.

    Attributes
    ----------
    colors : int
        Colors of a corner.
    points : int
        Points in a tile of four corners; one of n has n / 4 of that.
    rho : float
        Relative radius of the points in the plane.
    seed : int
        What they are drawn from.
    distance : float
        The least distance of points, in sides of a tile.

    See Also
    --------
    dual_point_tiles
    """

    colors: int
    points: int
    rho: float
    seed: int
    distance: float
    _frames: Frames = field(init=False)
    _made: dict[tuple[int, ...], _Tile] = field(init=False, default_factory=dict)
    _lock: Lock = field(init=False, default_factory=Lock)

    def __post_init__(self) -> None:
        frames = Frames(self.colors, self.points, self.distance, make_key(self.seed))
        object.__setattr__(self, "_frames", frames)

    def __repr__(self) -> str:
        said = f"{self.colors} colors, {self.points} points to four corners, rho {self.rho:g}"
        return describe(self, said)

    def rows(self, words: ArrayLike) -> DualRows:
        """Give the points of tiles of one number of corners.

        Parameters
        ----------
        words : array_like of int, shape (k, n)
            The slots of the corners of k tiles, each the least of its turns; see `canonical_slots`.

        Returns
        -------
        DualRows
            Their points, the same whatever was asked for before.

        Raises
        ------
        TilewrightTypeError
            Something else than integers.
        TilewrightValueError
            Slots out of range, or not the least of their turns.
        """
        given = as_integers("words", words)
        if given.ndim != 2 or given.shape[1] == 0:
            raise shape_error("words", given.shape, "(k, n), with n at least 1")
        if given.size and (given.min() < 0 or given.max() >= 4 * self.colors):
            raise range_error("words", given, f"0 to {4 * self.colors - 1}")
        if (canonical_slots(given)[1] != 0).any():
            raise TilewrightValueError("must be the least of their turns", argument="words")
        with self._lock:
            tiles = [self._tile(tuple(word)) for word in given.tolist()]
        starts = np.concatenate([[0], np.cumsum([len(sectors) for sectors, _ in tiles], dtype=np.int64)])
        if not tiles:
            return DualRows(starts, np.zeros(0, np.uint8), np.zeros((0, 2), np.float32))
        return DualRows(starts, *map(np.concatenate, zip(*tiles, strict=True)))

    def _tile(self, word: tuple[int, ...]) -> _Tile:
        if word not in self._made:
            self._made[word] = self._make(word)
        return self._made[word]

    def _make(self, word: tuple[int, ...]) -> _Tile:
        """One tile: frame, interior, ranks."""
        from tilewright.kernels.cones import rank_cone

        corners, frames = len(word), self._frames
        # Step 1: the frame, of which some lies in the tile and some around it.
        inside, around = [], []
        for i, slot in enumerate(word):
            there = word[(i + 1) % corners]
            for points, is_ours in (
                (frames.turned_corner(slot), _in_quadrant),
                (frames.edge(slot, there - there % 4 + (there - 1) % 4), _in_half),
            ):
                mine, cone = is_ours(points), to_cone(points, i, corners)
                inside.append(cone[mine])
                around.append(cone[~mine])
        ours, others = np.concatenate(inside), np.concatenate(around)
        # Step 2: the interior, for as many points as a tile of its size has.
        count = max(self.points * corners // 4 - len(ours), 0)
        shape = (0.0, 0.0, frames.corner_half, frames.strip_half)
        fixed = np.concatenate([ours, others])
        places = frames.fill(corners, shape, fixed, count, False, _TILE, *word)
        # Step 3: in which order points may be left out.
        held = np.concatenate([ours, places[len(fixed) :]])
        order = np.empty(len(held), np.int64)
        rank_cone(corners * np.pi / 2, len(held), len(others), np.concatenate([held, others]), order)
        sectors, points = to_sectors(held[order], corners)
        return sectors.astype(np.uint8), points.astype(np.float32)


def dual_point_tiles(
    colors: int = 2, points: int = 32, rho: float = 0.7, *, seed: Seed = 0
) -> DualPointTiles:
    """Make Poisson disk tiles that may be turned and have any number of corners.

    No tile is made before it is asked for.

    Parameters
    ----------
    colors : int, optional
        Colors of a corner, 1 to 16; default 2.
    points : int, optional
        Points in a tile of four corners, 12 to 64; default 32.
    rho : float, optional
        Relative radius, 0.05 to 0.75; default 0.7. The least distance is 2 rho r_max, with
        r_max = (2 sqrt(3) N)^(-1/2) sides of a tile.
    seed : int or numpy Generator, optional
        The same seed gives the same points; default 0.

    Returns
    -------
    DualPointTiles
        The set, from which tiles are asked for by their slots.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        Numbers of another type or out of range.

    Notes
    -----
    Li et al. 2010, section III; departs from it in that tiles of any number of corners are filled on the cone
    of as many quarter turns, the first of the two ways of section III.C, which keeps distances exact.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiles = tw.dual_point_tiles(colors=1, points=16, rho=0.6)
    >>> tiles.rows([(0, 0, 1)]).starts.tolist()
    [0, 12]
    """
    check_int("colors", colors, 1, _MOST_COLORS)
    check_int("points", points, _FEWEST, _MOST)
    check_real("rho", rho, 0.05, _LARGEST_RHO)
    distance = 2 * rho * max_radius(points, Box())
    return DualPointTiles(colors, points, rho, int(make_key(seed)), distance)


def _in_quadrant(points: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which points about a corner lie in the tile between the side along x and the one along y."""
    return (points[:, 0] > 0) & (points[:, 1] >= 0)


def _in_half(points: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which points of a strip lie on the side of the tile."""
    return points[:, 1] >= 0
