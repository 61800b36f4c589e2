"""Lloyd's relaxation over all that can surround the tiles of a set (Hiller, Deussen & Keller 2001)."""

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import Progress, TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.radius import max_radius
from tilewright.seeds import Seed, make_key
from tilewright.signals.points.neighborhood import (
    EAST,
    NORTH,
    NORTH_EAST,
    NORTH_WEST,
    OFFSETS,
    SOUTH,
    SOUTH_EAST,
    SOUTH_WEST,
    WEST,
    Neighbors,
)
from tilewright.signals.points.point_tiles import PointTiles
from tilewright.signals.points.promise import find_closeness
from tilewright.tiles import TileSet, cohen_tiles

_MIDDLE = 0.5
"""Side of the square in the middle of each tile where points begin."""
_MOST_POINTS = 4096
_MOST_TILES = 4096

# The tiles around one: four across its edges, in turn, and between each two of them one across a corner. A
# corner tile lies in the first given direction of the first of the two, and in the second of the second.
_RING = (NORTH, EAST, SOUTH, WEST)
_CORNERS = (
    (NORTH_EAST, EAST, NORTH),
    (SOUTH_EAST, SOUTH, EAST),
    (SOUTH_WEST, WEST, SOUTH),
    (NORTH_WEST, NORTH, WEST),
)


def hiller_tiles(
    tiles: TileSet | None = None,
    points: int = 32,
    iterations: int = 30,
    *,
    configurations: int = 128,
    seed: Seed = 0,
    progress: Progress | None = None,
) -> PointTiles:
    """Point tiles by Lloyd's relaxation (Hiller, Deussen & Keller 2001; Lagae 2007, section 6.7).

    Points begin by chance in the middle of their tile. Each tile is surrounded by the configurations of eight
    tiles that fit around it; every point moves by the mean of its ways to the centroids of its Voronoi cells
    in all of them, and stays in its tile. Points of one tile come far apart, to a relative radius of 0.7 to
    0.8. Points of two tiles come less far, to 0.55 to 0.7 (0.4 and less in the authors' own data, as the
    thesis found): what is right beside one neighbor is wrong beside another, and the ways average each other
    out. No points come to lie near corners.

    Parameters
    ----------
    tiles : TileSet, optional
        Square tiles; Cohen's 8 Wang tiles by default.
    points : int
        In each tile.
    iterations : int
    configurations : int
        How many configurations of each tile are taken, drawn by chance once and for all, where there are
        more: 4,096 of each of Cohen's 8 tiles.
    seed : int or numpy Generator
    progress : callable, optional

    Returns
    -------
    PointTiles
        Its distance is the least one found over all admissible neighborhoods. Figures: ``intra`` and
        ``inter``, the relative radius of points of one tile and of any tiling, for each iteration, the first
        before any (Lagae 2007, figures 6.11 and 6.12); ``configurations``, how many there are of each tile.
        Ranks are by chance.

    Raises
    ------
    TilewrightValueError
        A tile with no neighborhood, or tiles that are not square.
    """
    given = cohen_tiles(8) if tiles is None else tiles
    neighbors = Neighbors.of(given)
    check_int("tiles", len(given), 1, _MOST_TILES, "relaxation looks at each tile's neighborhoods")
    n = check_int("points", points, 1, _MOST_POINTS)
    rounds = check_int("iterations", iterations, 0, 10**6)
    most = check_int("configurations", configurations, 1, 2**20)
    from tilewright.kernels.wang_points import average_moves

    key = make_key(seed)
    rng = np.random.default_rng(int(key))
    around = [Surroundings.of(neighbors, t) for t in range(len(given))]
    # As many configurations of each tile as the kernel takes; those of tiles with fewer are repeated.
    taken = min(most, max(a.count for a in around))
    neighborhoods = np.stack([a.draw(taken, rng) for a in around])
    placed = (rng.random((len(given), n, 2)) - 0.5) * _MIDDLE + 0.5
    moves = np.empty_like(placed)
    recipe = {"points": n, "iterations": rounds, "configurations": most, "seed": int(key)}
    radii = []
    for done in range(rounds + 1):
        if progress is not None:
            progress(done, rounds, "relaxing tiles")
        made = PointTiles.of(given, list(placed), method="hiller", recipe=recipe)
        close = find_closeness(made)
        radii.append((close.within, close.across))
        if done < rounds:
            average_moves(placed.shape[0] * placed.shape[1], placed, OFFSETS, neighborhoods, moves)
            placed = np.clip(placed + moves, 0, np.nextafter(1, 0))
    intra, inter = np.minimum(np.array(radii) / 2 / max_radius(n, Box()), 1).T
    return PointTiles(
        made.tiles,
        made.points,
        made.starts,
        made.ranks,
        distance=close.distance,
        method="hiller",
        recipe=recipe,
        figures={
            "intra": intra.tolist(),
            "inter": np.minimum(intra, inter).tolist(),
            "configurations": [a.count for a in around],
        },
    )


class Surroundings:
    """All configurations of eight tiles around one tile, numbered.

    Attributes
    ----------
    count : int
        How many there are.
    """

    def __init__(self, neighbors: Neighbors, ring: list[NDArray[np.int64]]) -> None:
        self.fits = neighbors.fits.astype(np.int64)
        self.ring = ring
        # links[k][i, j]: corner tiles that fit between the i-th tile of one side and the j-th of the next.
        self.links = [
            self.fits[first][ring[k]] @ self.fits[second][ring[(k + 1) % 4]].T
            for k, (_, first, second) in enumerate(_CORNERS)
        ]
        # rest[k][j, i]: ways on from the j-th tile of side k around to the i-th of the first side.
        self.rest = [np.eye(len(ring[0]), dtype=np.int64)]
        for link in reversed(self.links):
            self.rest.insert(0, link @ self.rest[0])
        self.count = int(np.trace(self.rest[0]))

    @classmethod
    def of(cls, neighbors: Neighbors, tile: int) -> "Surroundings":
        """Of one tile of a set."""
        found = cls(neighbors, [np.flatnonzero(neighbors.fits[d, tile]) for d in _RING])
        if not found.count:
            raise TilewrightValueError(
                f"tiles: nothing fits all around tile {tile}", advice="leave it out of the set"
            )
        return found

    def draw(self, count: int, rng: np.random.Generator) -> NDArray[np.int32]:
        """``count`` configurations, shape (count, 8), by chance, or all in turn where they are fewer."""
        if count >= self.count:
            return self.find(np.arange(count) % self.count)
        return self.find(np.sort(rng.choice(self.count, count, replace=False)))

    def find(self, numbers: NDArray[np.int64]) -> NDArray[np.int32]:
        """The configurations of the given numbers, 0 to count - 1; tiles in the order of `OFFSETS`."""
        left = numbers.astype(np.int64)
        # Step 1: the four tiles across edges, each by how many configurations go with it.
        sides = [_choose(np.broadcast_to(np.diag(self.rest[0]), (len(left), len(self.ring[0]))), left)]
        ways = np.ones(len(left), np.int64)
        for k in range(3):
            ways_there = self.links[k][sides[k]] * ways[:, None]
            sides.append(_choose(ways_there * self.rest[k + 1][:, sides[0]].T, left))
            ways *= self.links[k][sides[k], sides[k + 1]]
        ways *= self.links[3][sides[3], sides[0]]
        # Step 2: the tiles across corners, in the same manner.
        out = np.empty((len(left), 8), np.int32)
        for k, (corner, first, second) in enumerate(_CORNERS):
            here, there = self.ring[k][sides[k]], self.ring[(k + 1) % 4][sides[(k + 1) % 4]]
            ways //= self.links[k][sides[k], sides[(k + 1) % 4]]
            fitting = self.fits[first][here] * self.fits[second][there]
            out[:, corner] = _choose(fitting * ways[:, None], left)
            out[:, _RING[k]] = here
        return out


def _choose(weights: NDArray[np.int64], left: NDArray[np.int64]) -> NDArray[np.int64]:
    """In each row the entry that a number falls into, counted by weights; the number becomes what is left."""
    ends = np.cumsum(weights, axis=1)
    chosen = (ends <= left[:, None]).sum(axis=1)
    rows = np.arange(len(left))
    left -= ends[rows, chosen] - weights[rows, chosen]
    return chosen
