"""Points over any mesh: dual tiles laid on it, then refined (Li et al. 2010)."""

from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_array, check_choice, check_int, check_real, shape_error, type_error
from tilewright.domains import Mesh, Spots, Surface
from tilewright.domains.medial import MedialDomain
from tilewright.domains.nearest import nearest_spots
from tilewright.domains.repair import SoundMesh, make_sound
from tilewright.errors import Progress, TilewrightValueError
from tilewright.fields.surfaces.density import Density, Weighting
from tilewright.fields.surfaces.laying import Laid, fit_domain, lay
from tilewright.fields.surfaces.points import SurfacePoints
from tilewright.samplers.surfaces import RECIPES, Refined, refine_spots
from tilewright.seeds import Seed, make_key
from tilewright.showing import many
from tilewright.signals.points.dual import DualPointTiles, dual_point_tiles
from tilewright.tilings.surface_tiling import SurfaceTiling

KINDS = ("even", "poisson", "tiles")
_RHO = {"even": 0.765, "poisson": 0.765, "tiles": 0.7}
_LARGEST_RHO = {"even": 0.85, "poisson": 0.78, "tiles": 0.75}
_MOST = 50_000_000
_COLORS = {"even": 1, "poisson": 1, "tiles": 2}
"""Colors of corners: where points are moved afterwards no repetition is left that more tiles would spare."""
_SET_RHO = 0.7
"""Relative radius of the tiles that are refined: the largest at which they need no second try."""


def surface_points(
    mesh: Any,
    count: int | None = None,
    *,
    radius: float | None = None,
    density: Density | None = None,
    kind: str = "even",
    rho: float | None = None,
    seed: Seed = 0,
    progress: Progress | None = None,
) -> SurfacePoints:
    """Spread points over a mesh, exactly as many as asked, evenly and by chance.

    Parameters
    ----------
    mesh : Mesh, str, path, (vertices, faces) or object with ``vertices`` and ``faces``
        Triangles, quads, any faces; open or closed. What cannot be tiled is mended, and said in ``notes``.
    count : int, optional
        How many points, 1 to 50 million.
    radius : float, optional
        In place of a count: half of the least distance, in the mesh's units.
    density : array or function, optional
        Where points are to lie closer: a weight for every vertex (V,) or face (F,) of the mesh, a picture
        (h, w) over its texture coordinates, or a function of places (n, 3). Only ratios count; by default all
        are the same.
    kind : str, optional
        ``"even"`` (default): by Lloyd's method, holes filled, pushed apart. ``"poisson"``: holes filled and
        points pushed apart only, which leaves more chance. ``"tiles"``: the points of the tiles as they are,
        at once.
    rho : float, optional
        Relative radius: half of the least distance over that of the densest packing of as many disks; by
        default 0.765, of ``"tiles"`` 0.7.
    seed : int or numpy Generator, optional
        The same seed gives the same points; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    SurfacePoints
        Positions, faces, weights, normals, identities and what was reached.

    Raises
    ------
    TilewrightTypeError, TilewrightValueError
        Not a mesh, no area, numbers out of range, both or none of count and radius, a density that is
        negative, 0 everywhere or of another length.

    Notes
    -----
    Li, Xiao, Wang & Fu 2010, sections II to V.A. Departs from it: any polygons, not quads alone; corners are
    drawn independently, since tiles of all numbers of corners can be made; points are thinned by ranks to the
    density of their place before they are refined, which makes their number exact; refined by pushing pairs
    apart rather than by Lloyd's method alone.

    Examples
    --------
    >>> import tilewright as tw
    >>> cube = tw.Mesh.of(
    ...     [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
    ...     [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)],
    ... )
    >>> points = tw.surface_points(cube, 500, seed=1)
    >>> points.positions.shape
    (500, 3)
    """
    plan, key = _Plan.of(mesh, density, kind, rho), make_key(seed)
    total = plan.count(count, radius)
    # Step 1: tiles on the mesh, as many as it takes, and the points of smallest rank.
    if progress is not None:
        progress(0, 2, "laying tiles")
    domain, points = fit_domain(MedialDomain.of(plan.sound), total, plan.weighting)
    tiles = _find_tiles(kind, points, plan.rho)
    laid = lay(SurfaceTiling(domain, tiles.colors, int(key)), tiles, total, plan.weighting).keep(total)
    figures = {"method": f"dual tiles, {kind}", "seed": int(key), "level": domain.level}
    # Step 2: what the surface's shape did to them is mended.
    if kind == "tiles":
        return plan.finish(laid.spots, laid, None, figures)
    if progress is not None:
        progress(1, 2, "moving points apart")
    return plan.finish(laid.spots, laid, plan.refine(laid.spots, progress), figures)


def refine_points(
    mesh: Any,
    points: ArrayLike,
    *,
    density: Density | None = None,
    kind: str = "even",
    rho: float | None = None,
    progress: Progress | None = None,
) -> SurfacePoints:
    """Spread points that lie on a mesh more evenly: fill holes and push those apart that are too close.

    Parameters
    ----------
    mesh : Mesh, str, path, (vertices, faces) or object with ``vertices`` and ``faces``
        What they lie on; see `surface_points`.
    points : array_like of float, shape (n, 3), or SurfacePoints
        Where they are; each begins at the nearest spot of the mesh.
    density : array or function, optional
        Where points are to lie closer; see `surface_points`.
    kind : str, optional
        ``"even"`` (default) or ``"poisson"``.
    rho : float, optional
        Relative radius; default 0.765.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    SurfacePoints
        The points in their order, without places of tiles; ``notes`` say how far off the mesh they were.

    Raises
    ------
    TilewrightTypeError
        Something else than numbers.
    TilewrightValueError
        Points of another shape, NaN, none; what `surface_points` refuses of a mesh.

    See Also
    --------
    surface_points

    Examples
    --------
    >>> import numpy as np, tilewright as tw
    >>> square = tw.Mesh.of([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
    >>> scattered = np.random.default_rng(1).random((200, 3)) * (1, 1, 0)
    >>> round(tw.refine_points(square, scattered).figures["rho"], 2)
    0.77
    """
    check_choice("kind", kind, tuple(RECIPES))
    plan = _Plan.of(mesh, density, kind, rho)
    places = _as_places(points)
    # Step 1: onto the surface.
    spots, off = nearest_spots(plan.surface, places)
    far = float(off.max())
    notes = (
        ()
        if far <= 1e-9 * plan.size
        else (f"points were brought onto the mesh, from up to {far:.3g} off it",)
    )
    # Step 2: apart.
    made = plan.refine(spots, progress)
    return plan.finish(spots, None, made, {"method": f"refined, {kind}"}, notes)


@lru_cache(maxsize=32)
def _find_tiles(kind: str, points: int, rho: float) -> DualPointTiles:
    """The set of tiles of a kind; what was made of the last ones stays."""
    return dual_point_tiles(_COLORS[kind], points, rho if kind == "tiles" else _SET_RHO, seed=0)


def as_mesh(given: Any) -> Mesh:
    """A mesh from what people have: a file, arrays, an object of another library."""
    if isinstance(given, Mesh):
        return given
    if isinstance(given, str | Path):
        from tilewright.files import read_mesh

        return read_mesh(given)
    if hasattr(given, "vertices") and hasattr(given, "faces"):
        return Mesh.of(np.asarray(given.vertices), np.asarray(given.faces))
    if isinstance(given, tuple | list) and len(given) == 2:
        return Mesh.of(*given)
    raise type_error("mesh", given, "a Mesh, the path of one, (vertices, faces), or an object that has them")


def _as_places(points: Any) -> NDArray[np.float64]:
    values = as_array("points", points)
    if values.dtype.kind not in "iuf":
        raise type_error("points", points, "numbers")
    if values.ndim != 2 or values.shape[1] != 3 or len(values) == 0:
        raise shape_error("points", values.shape, "(n, 3), with n at least 1")
    if not np.isfinite(values).all():
        raise TilewrightValueError("must be finite", argument="points", allowed="finite numbers")
    return values.astype(np.float64)


@dataclass(frozen=True, eq=False)
class _Plan:
    """What is to be done, on what: the arguments, checked."""

    mesh: Mesh
    sound: SoundMesh
    weighting: Weighting | None
    kind: str
    rho: float

    @classmethod
    def of(cls, mesh: Any, density: Any, kind: str, rho: Any) -> "_Plan":
        check_choice("kind", kind, KINDS)
        asked = _RHO[kind] if rho is None else check_real("rho", rho, 0.05, _LARGEST_RHO[kind])
        mesh = as_mesh(mesh)
        sound = make_sound(mesh)
        weighting = None if density is None else Weighting.of(mesh, sound, density)
        return cls(mesh, sound, weighting, kind, asked)

    @property
    def surface(self) -> Surface:
        return self.sound.cut.surface

    @property
    def size(self) -> float:
        """The longest side of the box around the mesh."""
        return float(np.ptp(self.surface.vertices, axis=0).max())

    def count(self, count: Any, radius: Any) -> int:
        """How many points, from a count or from half of their least distance."""
        if (count is None) == (radius is None):
            raise TilewrightValueError("give count, or radius, and not both", argument="count", value=count)
        if count is not None:
            return check_int("count", count, 1, _MOST)
        reach = check_real("radius", radius, 0.0, float("inf"))
        area = self.surface.area
        made = area * self.rho**2 / (2 * np.sqrt(3) * reach**2) if reach > 0 else np.inf
        if not 1 <= made <= _MOST:
            raise TilewrightValueError(
                f"is {reach:g}; on an area of {area:g} that would be {made:.3g} points, of 1 to {_MOST:,}",
                argument="radius",
                value=reach,
            )
        return int(made)

    def refine(self, spots: Spots, progress: Progress | None) -> Refined:
        """Points pushed apart and moved into holes."""
        scale = None if self.weighting is None else self.weighting.spacing
        recipe = replace(RECIPES[self.kind], rho=self.rho)
        return refine_spots(self.surface, spots, recipe, scale=scale, progress=progress)

    def finish(
        self,
        spots: Spots,
        laid: Laid | None,
        made: Refined | None,
        figures: dict[str, Any],
        notes: tuple[str, ...] = (),
    ) -> SurfacePoints:
        """The points, who they are, and what was reached."""
        count, distance, moved = len(spots), 0.0, np.zeros(len(spots), bool)
        notes = (*self.sound.notes, *notes)
        figures = {**figures, "count": count, "kind": self.kind}
        if made is not None:
            spots, distance, moved = made.spots, made.distance, made.moved
            figures |= {"rho": made.rho, "pairs_left": made.pairs_left, "sweeps": made.sweeps}
            if made.pairs_left:
                notes = (*notes, self._short(made))
        none = np.full(count, -1)
        return SurfacePoints(
            self.mesh,
            self.surface,
            spots,
            self.sound.face_numbers[self.sound.cut.faces[spots.triangles]],
            none if laid is None else laid.tiles,
            none if laid is None else laid.numbers.astype(np.int64),
            ((np.arange(count) + 0.5) / count).astype(np.float32),
            moved,
            distance,
            figures,
            notes,
        )

    def _short(self, made: Refined) -> str:
        """What to say where pairs of points are left that are closer than asked."""
        said = (
            f"{many(made.pairs_left, 'pair')} of points could not be moved as far apart as asked: "
            f"relative radius {made.rho:.3f} was reached, not {self.rho:g}"
        )
        return f"{said}; parts of the mesh are thinner than the distance, or folded"
