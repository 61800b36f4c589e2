"""All figures of points on a surface (Li et al. 2010, section V.B)."""

from dataclasses import dataclass
from math import inf, sqrt

import numpy as np

from tilewright.analysis.surfaces.geodesics import Ways
from tilewright.analysis.surfaces.holes import Holes, count_evenness, look_around
from tilewright.analysis.surfaces.neighbors import share_of_six
from tilewright.analysis.surfaces.verdict import judge_surface
from tilewright.checks import check_type, shape_error
from tilewright.domains.spots import Spots
from tilewright.domains.surface import Surface
from tilewright.errors import TilewrightValueError
from tilewright.showing import describe_record

FEWEST = 4
"""Fewer points have no spacing worth the name."""
_SAME = 1e-9
"""Points nearer than this, in r_max, count as one."""
_OFF = 1e-9
"""How far weights may be from adding up to 1, and below 0."""

_MEANING = {
    "count": ("points", "on the surface"),
    "rho_space": ("2 r_max", "least distance of two points, straight through space"),
    "rho_surface": ("2 r_max", "the same along the surface; r_max: densest packing of as many disks"),
    "mean": ("2 r_max", "mean distance to the nearest point, along the surface"),
    "coverage": ("r_max", "largest distance of a place of the surface from its nearest point"),
    "chi2": ("x chance", "how counts in 64 cells of equal area vary; 1 for random points"),
    "six_neighbors": ("0 to 1", "part of the points that have six natural neighbors; 1 for hexagons"),
    "duplicates": ("points", "that lie where another does"),
    "off_surface": ("points", "with weights below 0, or that do not add up to 1"),
}


@dataclass(frozen=True, eq=False)
class SurfaceReport:
    """What was measured of points on a surface.

    Attributes
    ----------
    count : int
        How many points.
    r_max : float
        Radius of as many disks in the densest packing of a plane of the same area, (2 sqrt(3) count /
        area)^-1/2, in the units of the vertices (Li et al. 2010, section V.B).
    rho_space : float
        Half of the least distance of two points in space, over r_max.
    rho_surface : float
        Half of their least distance along the surface, over r_max: 0.65 to 0.90 is good. Infinite where no
        two points lie on one connected part.
    certain : bool
        Whether every distance along the surface is exact. Where the search for some was given up, theirs are
        distances in space, and ``rho_surface`` and ``mean`` are lower bounds.
    mean : float
        Mean over the points of half of the distance along the surface to the nearest other one, over r_max.
        Points alone on their part do not count.
    coverage : float
        The greatest distance of a place of the surface from its nearest point, over r_max: in space, but
        along the surface where that point is on the other side of a thin part.
    chi2 : float
        Mean of (points - expected)^2 / expected over 64 cells of about equal area, fewer for fewer than 320
        points. About 1 for random points.
    six_neighbors : float
        Which part of the points have six natural neighbors in their tangent plane; those beside a border do
        not count. NaN where none is left.
    duplicates : int
        How many points lie where another does.
    off_surface : int
        How many have weights below 0, or that do not add up to 1.
    """

    count: int
    r_max: float
    rho_space: float
    rho_surface: float
    certain: bool
    mean: float
    coverage: float
    chi2: float
    six_neighbors: float
    duplicates: int
    off_surface: int

    __repr__ = describe_record

    @property
    def figures(self) -> dict[str, float]:
        """Every figure by name; ``str(report)`` lists them, each with its meaning."""
        return {name: float(getattr(self, name)) for name in _MEANING}

    @property
    def verdict(self) -> list[str]:
        """One to three sentences: whether points are evenly spread, what to object to, what to change."""
        return judge_surface(self.figures)

    @property
    def notes(self) -> tuple[str, ...]:
        """What the figures lack, in sentences; nothing where all are exact."""
        if self.certain:
            return ()
        return ("Some distances along the surface were not found: rho_surface and mean are lower bounds.",)

    def __str__(self) -> str:
        lines = []
        for name, value in self.figures.items():
            shown = f"{value:10.0f}" if abs(value) >= 1000 else f"{value:10.4g}"
            unit, meaning = _MEANING[name]
            lines.append(f"{name:<14} {shown} {unit:<8} {meaning}")
        return "\n".join([*lines, *self.verdict, *self.notes])


def analyze_surface(surface: Surface, spots: Spots) -> SurfaceReport:
    """Measure how evenly points lie on a surface (Li et al. 2010, section V.B).

    Parameters
    ----------
    surface : Surface
        Triangles that know their neighbors.
    spots : Spots
        The points, 4 or more.

    Returns
    -------
    SurfaceReport
        The figures, and a verdict in words.

    Raises
    ------
    TilewrightTypeError
        Something else than a surface and spots.
    TilewrightValueError
        Too few points, weights that are not finite, triangles that the surface does not have.
    """
    from scipy.spatial import cKDTree

    check_spots(surface, spots, FEWEST)
    points = spots.positions(surface)
    tree = cKDTree(points)
    r_max = 1 / sqrt(2 * sqrt(3) * len(spots) / surface.area)
    straight = tree.query(points, 2)[0][:, 1]
    ways = Ways(surface, spots)
    along, certain = ways.between_spots(straight)
    reached = along[np.isfinite(along)]
    places = look_around(surface, len(spots))
    return SurfaceReport(
        count=len(spots),
        r_max=r_max,
        rho_space=float(straight.min()) / 2 / r_max,
        rho_surface=float(along.min()) / 2 / r_max,
        certain=bool(certain.all()),
        mean=float(reached.mean()) / 2 / r_max if len(reached) else inf,
        coverage=Holes(surface, spots, tree, ways).widest(places) / r_max,
        chi2=count_evenness(places.positions(surface), points),
        six_neighbors=share_of_six(tree, points, spots.normals(surface)),
        duplicates=int((straight <= _SAME * r_max).sum()),
        off_surface=_count_off(spots),
    )


def _count_off(spots: Spots) -> int:
    total = np.abs(spots.weights.sum(axis=1) - 1)
    return int(((spots.weights < -_OFF).any(axis=1) | (total > _OFF)).sum())


def check_spots(surface: Surface, spots: Spots, fewest: int) -> None:
    """Refuse what is no surface, and spots that are too few or nowhere on it."""
    check_type("surface", surface, Surface, "a Surface")
    check_type("spots", spots, Spots, "Spots")
    if spots.weights.shape != (len(spots.triangles), 3):
        raise shape_error("spots.weights", spots.weights.shape, (len(spots.triangles), 3))
    if len(spots) < fewest:
        raise TilewrightValueError(
            f"are {len(spots)}; at least {fewest} are needed",
            argument="spots",
            value=len(spots),
            allowed=f"{fewest} or more",
        )
    bad = ~np.isfinite(spots.weights).all(axis=1)
    if bad.any():
        spot = int(np.argmax(bad))
        raise TilewrightValueError(
            f"is {spots.weights[spot].tolist()}; all weights must be finite",
            argument=f"spots.weights[{spot}]",
            allowed="finite numbers",
        )
    wrong = (spots.triangles < 0) | (spots.triangles >= len(surface.triangles))
    if wrong.any():
        spot = int(np.argmax(wrong))
        raise TilewrightValueError(
            f"is {spots.triangles[spot]}; there are {len(surface.triangles)} triangles, numbered from 0",
            argument=f"spots.triangles[{spot}]",
            value=int(spots.triangles[spot]),
            allowed=f"0 to {len(surface.triangles) - 1}",
        )
