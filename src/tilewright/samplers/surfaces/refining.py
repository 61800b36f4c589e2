"""Points of a surface spread more evenly: to the middles of their cells, into holes, and apart.

Each step reads where points were and writes where they come to be, so that the number of threads makes no
difference.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.domains import Spots, Surface
from tilewright.errors import Progress
from tilewright.samplers.surfaces.ground import Ground, Lists, Walkers
from tilewright.samplers.surfaces.recipes import Recipe

_CELL_REACH, _CELL_ROOM = 4.2, 24
_WALL_REACH, _WALL_ROOM = 3.2, 12
_SKIN, _PUSH_ROOM = 0.45, 20
"""How far beyond the distance lists reach, in r_max: they hold until a point has drifted by half of it."""
_HOLES_APART = 1.5
"""How far apart holes are that are filled at once, in r_max."""

Scale = Callable[[Spots], NDArray[np.float64]]


@dataclass(frozen=True, eq=False)
class Refined:
    """Points that were spread more evenly.

    Attributes
    ----------
    spots : Spots
        Where they are now, in the same order.
    moved : bool array, shape (n,)
        Which were put elsewhere, into holes.
    pairs_left : int
        Pairs that are still closer than was asked.
    sweeps : int
        Rounds of pushing that were needed.
    rho : float
        Half of the least distance over the radius of the densest packing, where ``scale`` is 1.
    distance : float
        No two points are closer in a straight line.
    """

    spots: Spots
    moved: NDArray[np.bool_]
    pairs_left: int
    sweeps: int
    rho: float
    distance: float


class _Crowd:
    """Points on their way: where they are, and how far apart they are to be."""

    def __init__(self, surface: Surface, spots: Spots, scale: Scale | None) -> None:
        self.ground = Ground.of(surface)
        self.walkers = Walkers.of(spots, surface)
        self.scale = scale
        self.radius = float(np.sqrt(surface.area / (2 * np.sqrt(3) * len(spots))))
        """Radius of the densest packing of as many disks in the plane."""

    @property
    def spacing(self) -> NDArray[np.float64]:
        """The radius at each point."""
        if self.scale is None:
            return np.full(len(self.walkers.places), self.radius)
        return self.radius * self.scale(self.walkers.spots)

    @property
    def normals(self) -> NDArray[np.float64]:
        return self.ground.surface.normals[self.walkers.triangles]

    def move(self, moves: NDArray[np.float64]) -> None:
        self.ground.walk(self.walkers, np.arange(len(moves), dtype=np.int32), moves)


def refine_spots(
    surface: Surface,
    spots: Spots,
    recipe: Recipe,
    *,
    scale: Scale | None = None,
    progress: Progress | None = None,
) -> Refined:
    """Spread points of a surface more evenly.

    Parameters
    ----------
    surface : Surface
        What they lie on.
    spots : Spots
        Where they begin, n of them.
    recipe : Recipe
        Steps and settings.
    scale : callable, optional
        How far apart points are to be at spots, over the mean; evaluated again where lists are renewed.
    progress : callable, optional
        Called as ``progress(done, total, what)``.

    Returns
    -------
    Refined
        Where the points are now, and what was reached.
    """
    crowd = _Crowd(surface, spots, scale)
    moved = np.zeros(len(spots), bool)
    steps = recipe.lloyd + recipe.fill + 1
    # Step 1: towards the middles of cells.
    for step in range(recipe.lloyd):
        _say(progress, step, steps)
        crowd.move(_measure_cells(crowd, recipe.omega if step < recipe.lloyd - 1 else 1.0)[0])
    # Step 2: apart, and the most crowded points into holes, until there are none.
    sweeps = 0
    for round in range(recipe.fill + 1):
        _say(progress, recipe.lloyd + round, steps)
        if round > 0:
            filled = _fill_holes(crowd, recipe.hole)
            moved |= filled
            if not filled.any():
                break
        sweeps += _push(crowd, recipe)
    return _tell(crowd, recipe, moved, sweeps)


def _say(progress: Progress | None, done: int, total: int) -> None:
    if progress is not None:
        progress(done, total, "moving points")


def _measure_cells(
    crowd: _Crowd, omega: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """The way from each point to the middle of its cell and to its farthest corner, and how far that is."""
    from tilewright.kernels.surface_steps import center_cells

    places, spacing = crowd.walkers.places, crowd.spacing
    lists = Lists.of(places, places, _CELL_REACH * spacing, _CELL_ROOM)
    begins, ends = crowd.ground.walls(float(spacing.min()))
    walls = Lists.of(places, (begins + ends) / 2, _WALL_REACH * spacing, _WALL_ROOM)
    moves, far, reach = np.empty_like(places), np.empty_like(places), np.empty(len(places))
    center_cells(
        len(places),
        (places, crowd.normals),
        lists.numbers,
        lists.counts,
        (begins, ends),
        walls.numbers,
        walls.counts,
        spacing,
        omega,
        (moves, far, reach),
    )
    return moves, far, reach


def _fill_holes(crowd: _Crowd, hole: float) -> NDArray[np.bool_]:
    """Move the most crowded points into holes; which ones."""
    from scipy.spatial import KDTree

    walkers, spacing = crowd.walkers, crowd.spacing
    count = len(spacing)
    moved = np.zeros(count, bool)
    if count < 3:
        return moved
    # Step 1: candidates are far corners of cells, walked to, and vertices of the surface, where it bends.
    _, far, reach = _measure_cells(crowd, 1.0)
    probes = _walk_far(crowd, far, np.flatnonzero(reach > hole * spacing))
    tree = KDTree(walkers.places)
    apart, nearest = tree.query(probes.places)
    reaches = spacing[nearest]
    order = np.lexsort((np.arange(len(apart)), -apart / reaches))
    order = order[apart[order] > hole * reaches[order]]
    if not len(order):
        return moved
    # Step 2: the widest first, apart from each other.
    holes: list[int] = []
    near = KDTree(probes.places[order]).query_ball_point(probes.places[order], _HOLES_APART * reaches[order])
    taken = np.zeros(len(order), bool)
    for k in range(len(order)):
        if not taken[k]:
            holes.append(int(order[k]))
            taken[near[k]] = True
    # Step 3: the most crowded points go there, no two of which are neighbors.
    least, neighbors = tree.query(walkers.places, 2)
    crowded = np.lexsort((np.arange(count), least[:, 1] / spacing))
    kept = np.zeros(count, bool)
    victims: list[int] = []
    for i in crowded.tolist():
        if len(victims) == len(holes):
            break
        if not kept[i]:
            victims.append(i)
            kept[[i, neighbors[i, 1]]] = True
    into = np.array(holes[: len(victims)], np.intp)
    walkers.triangles[victims], walkers.weights[victims] = probes.triangles[into], probes.weights[into]
    walkers.places[victims] = probes.places[into]
    moved[victims] = True
    return moved


def _walk_far(crowd: _Crowd, far: NDArray[np.float64], which: NDArray[np.intp]) -> Walkers:
    """The far corners of some cells, and all vertices of the surface."""
    walkers, surface = crowd.walkers, crowd.ground.surface
    corners, firsts = np.unique(surface.triangles, return_index=True)
    one = np.eye(3)[firsts % 3]
    probes = Walkers(
        np.concatenate([walkers.triangles[which], (firsts // 3).astype(np.int32)]),
        np.concatenate([walkers.weights[which], one]),
        np.concatenate([walkers.places[which], surface.vertices[corners]]),
    )
    crowd.ground.walk(probes, np.arange(len(which), dtype=np.int32), far[which])
    return probes


def _push(crowd: _Crowd, recipe: Recipe) -> int:
    """Push pairs apart until none is too close, or for so many sweeps; how many it took."""
    from tilewright.kernels.surface_steps import push_apart

    walkers = crowd.walkers
    count = len(walkers.places)
    moves, close = np.zeros((count, 3)), np.zeros(count, np.int32)
    sweeps, active, renewed = 0, np.arange(count, dtype=np.int32), False
    lists, wanted = _list_close(crowd, recipe.rho)
    begun = walkers.places.copy()
    while True:
        normals = crowd.normals
        push_apart(
            len(active), active, walkers.places, normals, lists.numbers, lists.counts, wanted, moves, close
        )
        moving = active[close[active] > 0]
        if len(moving) == 0 or sweeps == recipe.sweeps:
            if renewed or sweeps == recipe.sweeps:
                break
            # None is left that these lists know: look once more with new ones.
            lists, wanted = _list_close(crowd, recipe.rho)
            begun, active, renewed = walkers.places.copy(), np.arange(count, dtype=np.int32), True
            continue
        crowd.ground.walk(walkers, moving, moves)
        sweeps, renewed = sweeps + 1, False
        drift = np.linalg.norm(walkers.places[moving] - begun[moving], axis=1)
        if (2 * drift > _SKIN * crowd.radius).any():
            lists, wanted = _list_close(crowd, recipe.rho)
            begun = walkers.places.copy()
        stirred = np.zeros(count, bool)
        stirred[moving] = True
        there = np.arange(lists.numbers.shape[1]) < lists.counts[moving, np.newaxis]
        stirred[lists.numbers[moving][there]] = True
        active = np.flatnonzero(stirred).astype(np.int32)
    return sweeps


def _list_close(crowd: _Crowd, rho: float) -> tuple[Lists, NDArray[np.float64]]:
    """Who may come too close to whom, and half of the distance that each is to keep."""
    spacing = crowd.spacing
    wanted = rho * spacing
    reach = wanted + rho * float(spacing.max()) + _SKIN * crowd.radius
    return Lists.of(crowd.walkers.places, crowd.walkers.places, reach, _PUSH_ROOM), wanted


def _tell(crowd: _Crowd, recipe: Recipe, moved: NDArray[np.bool_], sweeps: int) -> Refined:
    """What was reached, measured anew."""
    lists, wanted = _list_close(crowd, recipe.rho)
    there = np.arange(lists.numbers.shape[1]) < lists.counts[:, np.newaxis]
    one, other = np.nonzero(there)[0], lists.numbers[there]
    apart = np.linalg.norm(crowd.walkers.places[one] - crowd.walkers.places[other], axis=1)
    share = apart / (wanted[one] + wanted[other])
    # Points that are on no list are farther apart than was asked.
    rho = recipe.rho * (float(share.min()) if len(share) else 1.0)
    distance = float(apart.min(initial=2 * float(wanted.min())))
    pairs = int((share < 1 - 1e-9).sum()) // 2
    return Refined(crowd.walkers.spots, moved, pairs, sweeps, rho, distance)
