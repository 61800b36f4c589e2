"""Progressive point tiles that subdivide into tiles of their own set.

Kopf, Cohen-Or, Deussen & Lischinski 2006, "Recursive Wang tiles for real-time blue noise".
"""

from dataclasses import dataclass, replace
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import Progress, TilewrightValueError
from tilewright.samplers.relaxation import relaxation_darts
from tilewright.seeds import Seed, make_key
from tilewright.signals.points.merging import merge
from tilewright.signals.points.point_tiles import PointTiles
from tilewright.signals.points.promise import find_closeness
from tilewright.signals.points.recursion import find_children
from tilewright.tiles import TileSet, compact_wang_tiles

_MOST_POINTS = 4096
_FEWEST_EACH = 16
"""Points of a tile that those of its smaller tiles make up."""
_SEAM = (2, 6)
"""In mean spacings, between which depths the seam of a tile and its frame runs."""
_FRAME_SEAM = (6, 10)
"""In mean spacings, how far from the lattice point the seam of an edge runs."""
_WIDEST = 0.022
"""Tile lengths that count as a spacing at most, so that seams have room in tiles of few points."""
_MARGIN = 3
"""In mean spacings, how much farther points are known than seams can run."""
_WEIGHT = 16
"""How much the squared distances of a tile's first points count in matching, over those of the others."""
_ROUNDS = 2
"""How often tiles are matched with their smaller ones, which have moved by then."""
_EXACT = 60
"""Steps after which the fixed point is as exact as numbers are."""


def kopf_tiles(
    points: int = 2048,
    colors: int = 2,
    subdivision: int = 4,
    *,
    seed: Seed = 0,
    progress: Progress | None = None,
) -> PointTiles:
    """Point tiles of any density, by ranks and by recursion; see `recursive_points`.

    Every tile is made of subdivision x subdivision smaller tiles of the set, and its points are those of the
    smaller tiles: the first points / subdivision^2 of each. A tile's own first points are of the same number.
    So a tiling can be subdivided for ever, and every point stays. Within a tile points are ranked so that the
    first n of them are well spread for every n.

    Points come from relaxation dart throwing: one toroidal set for the corners, one for each color of an edge
    and one for each tile, merged along seams. Then each of the tile's points is matched with a nearby one of
    the smaller tiles, which decides on all positions.

    The paper was at hand in parts only; departs from it, or may, in the costs of the seam, in the single set
    around the corners, and in how points are matched: the pairs of least total distance.

    Parameters
    ----------
    points : int
        In each tile; a multiple of the square of ``subdivision``, at least 16 times as many, up to 4,096. The
        authors' tiles have about 2,048.
    colors : int
        Of the edges, 2 or 3; the compact set of Wang tiles has 2 colors^2 of them, for 2 Cohen's 8.
    subdivision : int
        2 to 5; with 3 colors 3 to 5.
    seed : int or numpy Generator
    progress : callable, optional

    Returns
    -------
    PointTiles
        Its distance is the least one found, over all admissible neighborhoods. It is short: seams, and the
        matching, leave a relative radius of 0.18 to 0.36 with all points and 0.12 to 0.44 with fewer (Lagae
        2007, section 6.14, found 0.44 to less than 0.001 in the authors' tiles). Figures: ``children``, the
        smaller tiles of each, y first; ``moved``, how far the matching moved points, root mean square, in
        mean spacings.

    Raises
    ------
    TilewrightValueError
        A number of points that does not divide, or colors and a subdivision for which there is no rule.
    """
    n = check_int("subdivision", subdivision, 2, 5)
    count = check_int("points", points, _FEWEST_EACH * n * n, _MOST_POINTS)
    if count % (n * n):
        raise TilewrightValueError(
            f"is {count}; it must be a multiple of {n * n}, as {count // n**2 * n**2}",
            argument="points",
            value=count,
            allowed=f"a multiple of {n * n}, as {count // n**2 * n**2}",
        )
    tiles = compact_wang_tiles(check_int("colors", colors, 2, 3))
    key = make_key(seed)
    rng = np.random.default_rng(int(key))
    children = find_children(tiles, n, rng)
    steps = len(tiles) * (_ROUNDS + 1)

    def tell(done: int) -> None:
        if progress is not None:
            progress(done, steps, "merging and matching tiles")

    # Step 1: progressive tiles, from sources merged along seams.
    sources = Sources.of(tiles, count, rng)
    wanted = []
    for tile in range(len(tiles)):
        tell(tile)
        wanted.append(sources.merged(tile)[:count])
    # Step 2: the first points of a tile go to where points of its smaller tiles are, and take these along.
    each = count // (n * n)
    first = np.stack([w[:each] for w in wanted])
    for done in range(_ROUNDS):
        matches = []
        for tile in range(len(tiles)):
            tell((done + 1) * len(tiles) + tile)
            matches.append(_match(wanted[tile], _parts(first, children[tile]), each))
        first = _fixed_point(children, np.stack([m[:each] for m in matches]), first)
    # Step 3: all points of the smaller tiles, in the order of those that they are matched with.
    rows, moved = [], []
    for tile, match in enumerate(matches):
        parts = _parts(first, children[tile])
        left = np.setdiff1d(np.arange(count), match)
        rows.append(parts[np.concatenate([match, left])])
        moved.append(((parts[match] - wanted[tile]) ** 2).sum(axis=1).mean() * count)
    recipe = {"points": count, "colors": colors, "subdivision": n, "seed": int(key)}
    made = PointTiles.of(tiles, rows, method="kopf", recipe=recipe)
    figures = {"children": children.tolist(), "moved": sqrt(float(np.mean(moved)))}
    return replace(made, distance=find_closeness(made).distance, figures=figures)


@dataclass(frozen=True, eq=False)
class Sources:
    """Progressive points of unit tori, float64, shape (count, 3) each: x, y and rank.

    Attributes
    ----------
    tiles : TileSet
    rows, columns : list of array
        Around the edges N and S of each color, and around E and W, merged with ``corner`` at their ends: the
        points near an edge from (0, 0) to (1, 0) or (0, 1), with their ranks as a third column.
    insides : list of array
        For each tile, with ranks.
    spacing : float
        What widths of seams are counted in.
    """

    tiles: TileSet
    rows: list[NDArray[np.float64]]
    columns: list[NDArray[np.float64]]
    insides: list[NDArray[np.float64]]
    spacing: float

    @classmethod
    def of(cls, tiles: TileSet, count: int, rng: np.random.Generator) -> "Sources":
        """Draw all sources and merge those of the edges."""
        spacing = min(1 / sqrt(count), _WIDEST)

        def draw() -> NDArray[np.float64]:
            ranks = np.arange(count) / count
            return np.column_stack([relaxation_darts(count, seed=rng).points, ranks])

        corner = draw()
        rows = [_merge_edge(corner, draw(), 0, spacing) for _ in range(tiles.colors[0])]
        columns = [_merge_edge(corner, draw(), 1, spacing) for _ in range(tiles.colors[1])]
        return cls(tiles, rows, columns, [draw() for _ in range(len(tiles))], spacing)

    def merged(self, tile: int) -> NDArray[np.float64]:
        """The points of a tile in the order of their ranks, shape (n, 2)."""
        north, east, south, west = self.tiles.slots[tile].tolist()
        sides = [
            self.rows[north],
            self.rows[south] + (0, 1, 0),
            self.columns[west],
            self.columns[east] + (1, 0, 0),
        ]
        # Step 1: the frame, where every point comes from the nearest edge.
        parts = []
        for k, side in enumerate(sides):
            gaps = np.abs(np.stack([side[:, 1], side[:, 1] - 1, side[:, 0], side[:, 0] - 1]))
            parts.append(side[gaps.argmin(axis=0) == k])
        frame, inside = np.concatenate(parts), self.insides[tile]
        # Step 2: the seam around the inside.
        low, high = _SEAM[0] * self.spacing, _SEAM[1] * self.spacing
        outer, inner = ((_depth(p) - low) / (high - low) for p in (frame, inside))
        stay, stay_inside = merge(frame, inside, outer, inner, 1 / sqrt(len(inside)))
        merged = np.concatenate([frame[stay], inside[stay_inside]])
        merged = merged[_depth(merged) >= 0]
        return merged[np.argsort(merged[:, 2], kind="stable"), :2]


def _depth(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """How far points lie inside of their tile."""
    depth: NDArray[np.float64] = np.minimum(points[:, :2], 1 - points[:, :2]).min(axis=1)
    return depth


def _merge_edge(
    corner: NDArray[np.float64], edge: NDArray[np.float64], axis: int, spacing: float
) -> NDArray[np.float64]:
    """The points near an edge: those of ``edge``, with those of ``corner`` around both ends."""
    reach = (_SEAM[1] + _MARGIN) * spacing
    low, high = _FRAME_SEAM[0] * spacing, _FRAME_SEAM[1] * spacing
    sets, depths = [], []
    for points in (corner, edge):
        # The torus around the edge, unrolled.
        laps = np.array([(x, y, 0) for x in (-1, 0, 1) for y in (-1, 0)], np.float64)
        if axis:
            laps = laps[:, [1, 0, 2]]
        around = (points[None] + laps[:, None]).reshape(-1, 3)
        along, across = around[:, axis], around[:, 1 - axis]
        near = (np.abs(across) < reach) & (np.abs(along - 0.5) < 0.5 + reach)
        sets.append(around[near])
        depths.append((np.minimum(along, 1 - along)[near] - low) / (high - low))
    stay, stay_edge = merge(sets[0], sets[1], depths[0], depths[1], 1 / sqrt(len(corner)))
    return np.concatenate([sets[0][stay], sets[1][stay_edge]])


def _parts(first: NDArray[np.float64], arrangement: NDArray[np.int32]) -> NDArray[np.float64]:
    """The first points of the smaller tiles in an arrangement, in the larger tile, shape (n n each, 2)."""
    n = len(arrangement)
    corners = np.stack(np.divmod(np.arange(n * n), n)[::-1], axis=1)
    return ((first[arrangement.ravel()] + corners[:, None]) / n).reshape(-1, 2)


def _match(wanted: NDArray[np.float64], parts: NDArray[np.float64], first: int) -> NDArray[np.int64]:
    """For every point that is wanted, the part that takes its place.

    Least squares, with more weight on the ``first`` ones, whose places are those of whole tiles.
    """
    from scipy.optimize import linear_sum_assignment
    from scipy.spatial.distance import cdist

    cost = cdist(wanted, parts, "sqeuclidean")
    cost[:first] *= _WEIGHT
    match: NDArray[np.int64] = linear_sum_assignment(cost)[1]
    return match


def _fixed_point(
    children: NDArray[np.int32], match: NDArray[np.int64], first: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The places at which the first points of every tile are points of its smaller tiles.

    A smaller tile's points move subdivision times less than they do in it, so that moving all points there
    again and again comes to an end.
    """
    for _ in range(_EXACT):
        first = np.stack([_parts(first, c)[m] for c, m in zip(children, match, strict=True)])
    return first
