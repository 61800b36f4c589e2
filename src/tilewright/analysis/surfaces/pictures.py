"""Pictures of surfaces and of points on them, made without any package for three dimensions."""

from collections.abc import Callable
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.analysis.surfaces.camera import Camera, aim
from tilewright.analysis.surfaces.creases import corner_normals
from tilewright.analysis.surfaces.report import check_spots
from tilewright.checks import (
    as_array,
    check_choice,
    check_int,
    check_real,
    check_type,
    shape_error,
    type_error,
)
from tilewright.domains.spots import Spots
from tilewright.domains.surface import Surface
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.pixels import read_hex
from tilewright.signals.textures.kinds import to_encoded, to_linear

Painter = Callable[[NDArray[np.int32], NDArray[np.float64]], ArrayLike]
"""Called as ``colors(triangles, weights)`` with n places; gives their colors, (n, 3)."""

_FINE = 2
"""Samples along a side of a pixel."""
_BAND = 1 << 20
"""Samples that are drawn at once."""
_GROUNDS = {"white": (1.0, 1.0, 1.0), "dark": (0.09, 0.09, 0.11)}
_PLAIN = {"white": (0.86, 0.85, 0.82), "dark": (0.80, 0.79, 0.76)}
_INK = {"white": (0.09, 0.11, 0.16), "dark": (0.10, 0.16, 0.30)}
_KEY, _FILL = np.array([-0.42, 0.62, 0.66]), np.array([0.70, -0.15, 0.70])
"""Where light comes from: to the right, up, towards the eye."""
_AMBIENT, _KEYED, _FILLED = 0.24, 0.74, 0.14
_BACK = 0.45
"""How light the inner side of an open surface is, of the outer one."""
_LEAST_DOT = 0.75
"""Least radius of a dot, in pixels."""
_SAME_SIDE = -0.2
"""Cosine of two normals from which on a dot is on the side that is seen; it may reach around an edge."""
_AROUND = 8
"""Nearest points that are looked at where the nearest is on another side."""


def draw_surface(
    surface: Surface,
    spots: Spots | None = None,
    *,
    width: int = 800,
    height: int = 800,
    view: tuple[float, float] = (30.0, 20.0),
    up: str = "y",
    colors: ArrayLike | str | Painter | None = None,
    dots: float = 0.35,
    dot_colors: ArrayLike | str | None = None,
    shading: str = "smooth",
    ground: str = "white",
) -> NDArray[np.uint8]:
    """Draw a surface, and points on it as disks, by parallel rays from afar.

    Parameters
    ----------
    surface : Surface
        What is drawn; the inner side of open ones is darker.
    spots : Spots, optional
        Points on it.
    width, height : int, optional
        Pixels, 1 to 8,192; default 800. The surface fills the picture up to a margin of 5 %.
    view : (float, float), optional
        Azimuth and elevation of the eye in degrees; default (30, 20). At (0, 0) x runs to the right, and at
        azimuth 90 the eye is where x is greatest.
    up : {"y", "z"}, optional
        The axis that points upwards; default "y", as in most OBJ files.
    colors : array_like, str or callable, optional
        One color, one for every triangle, (T, 3), or for every vertex, (V, 3), in between which they are
        mixed; where there are as many of both, of the vertices. Or a function that is called with n places,
        ``colors(triangles, weights)``, int32 (n,) and float64 (n, 3), and gives (n, 3). Colors are sRGB:
        floats 0 to 1, integers 0 to 255, or one as "#rrggbb". By default a light gray.
    dots : float, optional
        Radius of the disks over r_max of so many points, 0 to 10; default 0.35. At least 0.75 pixels are
        drawn.
    dot_colors : array_like or str, optional
        One color or one for every point, (n, 3); by default nearly black.
    shading : {"smooth", "flat"}, optional
        Whether triangles that meet at an angle of less than 60 degrees look round; default "smooth".
    ground : {"white", "dark"}, optional
        What is behind; default "white".

    Returns
    -------
    uint8 array, shape (height, width, 3)
        sRGB, y downwards, the mean light of 2 x 2 samples for each pixel.

    Raises
    ------
    TilewrightTypeError
        Something else than a surface, spots, numbers and colors.
    TilewrightValueError
        Something out of range, or colors of another shape.
    """
    check_type("surface", surface, Surface, "a Surface")
    rows, columns = check_int("height", height, 1, 8192), check_int("width", width, 1, 8192)
    check_choice("ground", ground, tuple(_GROUNDS))
    flat = check_choice("shading", shading, ("smooth", "flat")) == "flat"
    camera = aim(
        surface, _FINE * columns, _FINE * rows, _check_view(view), check_choice("up", up, ("y", "z"))
    )
    paint = _painter(surface, colors, _PLAIN[ground])
    disks = None
    if spots is not None:
        check_spots(surface, spots, fewest=1)
        radius = check_real("dots", dots, 0, 10) / sqrt(2 * sqrt(3) * len(spots) / surface.area)
        ink = _as_colors("dot_colors", _INK[ground] if dot_colors is None else dot_colors, (len(spots),))
        disks = _Disks(surface, spots, max(radius, _LEAST_DOT * _FINE / camera.scale), ink, camera.scale)
    normals = corner_normals(surface, flat)
    placed = camera.project(surface.vertices, _FINE * columns, _FINE * rows)[surface.triangles]
    back = to_linear(np.array(_GROUNDS[ground]))
    picture = np.empty((rows, columns, 3), np.uint8)
    band = max(1, _BAND // (_FINE**2 * columns))
    for first in range(0, rows, band):
        last = min(rows, first + band)
        numbers, weights = _see(placed - (0, _FINE * first, 0), _FINE * (last - first), _FINE * columns)
        light = np.broadcast_to(back, weights.shape).astype(np.float64)
        covered = numbers >= 0
        if covered.any():
            places = Spots(numbers[covered], weights[covered])
            light[covered] = _light(surface, camera, normals, paint, disks, places)
        light = light.reshape(last - first, _FINE, columns, _FINE, 3).mean(axis=(1, 3))
        picture[first:last] = np.rint(255 * np.clip(to_encoded(light), 0, 1))
    return picture


class _Disks:
    """Disks on a surface, each around its point on the point's own side."""

    def __init__(
        self, surface: Surface, spots: Spots, radius: float, ink: NDArray[np.float64], scale: float
    ) -> None:
        from scipy.spatial import cKDTree

        self._tree = cKDTree(spots.positions(surface))
        self._normals = spots.normals(surface)
        self._radius, self._scale = radius, scale
        self._ink = to_linear(np.broadcast_to(ink, (len(spots), 3)))

    def cover(
        self, light: NDArray[np.float64], places: NDArray[np.float64], normals: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """The colors of places, where no disk is ``light``; over a sample at the rim they change."""
        reach = self._radius + 0.5 / self._scale
        distances, nearest = self._tree.query(places, distance_upper_bound=reach)
        inside = np.flatnonzero(np.isfinite(distances))
        distances, nearest = distances[inside], nearest[inside]
        facing = np.einsum("nd,nd->n", self._normals[nearest], normals[inside])
        other = np.flatnonzero(facing < _SAME_SIDE)
        distances[other], nearest[other] = self._on_side(places[inside[other]], normals[inside[other]], reach)
        part = np.clip((self._radius - distances) * self._scale + 0.5, 0, 1)[:, np.newaxis]
        covered = light.copy()
        covered[inside] += part * (self._ink[nearest] - covered[inside])
        return covered

    def _on_side(
        self, places: NDArray[np.float64], normals: NDArray[np.float64], reach: float
    ) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
        """The nearest point whose normal agrees, infinitely far where there is none."""
        count = min(_AROUND, len(self._normals))
        distances, nearest = self._tree.query(places, np.arange(1, count + 1), distance_upper_bound=reach)
        known = np.isfinite(distances)
        nearest = np.where(known, nearest, 0)
        facing = np.einsum("nkd,nd->nk", self._normals[nearest], normals)
        distances = np.where(known & (facing >= _SAME_SIDE), distances, np.inf)
        best = distances.argmin(axis=1)[:, np.newaxis]
        return np.take_along_axis(distances, best, 1)[:, 0], np.take_along_axis(nearest, best, 1)[:, 0]


def _see(
    corners: NDArray[np.float64], rows: int, columns: int
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Which triangle is seen at every sample, -1 where there is none, and where in it."""
    from tilewright.kernels.rasterizing import rasterize

    depths, numbers = np.full((rows, columns), -np.inf), np.full((rows, columns), -1, np.int32)
    weights = np.zeros((rows, columns, 3))
    rasterize(rows, np.ascontiguousarray(corners), depths, numbers, weights)
    return numbers, weights


def _light(
    surface: Surface,
    camera: Camera,
    normals: NDArray[np.float64],
    paint: Painter,
    disks: _Disks | None,
    places: Spots,
) -> NDArray[np.float64]:
    """Linear light that comes from places of the surface."""
    triangles, weights = places.triangles, places.weights
    painted = to_linear(_as_colors("colors", paint(triangles, weights), (len(triangles),)))
    color = np.broadcast_to(painted, (len(triangles), 3)).astype(np.float64)
    if disks is not None:
        color = disks.cover(color, places.positions(surface), surface.normals[triangles])
    turned = np.einsum("nk,nkd->nd", weights, normals[triangles]) @ camera.frame.T
    turned /= np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-12)
    behind = surface.normals[triangles] @ camera.frame[2] < 0
    turned[behind] *= -1
    key, fill = (np.maximum(turned @ (d / np.linalg.norm(d)), 0) for d in (_KEY, _FILL))
    shade = _AMBIENT * (1 + 0.4 * turned[:, 1]) + _KEYED * key + _FILLED * fill
    shade[behind] *= _BACK
    return color * shade[:, np.newaxis]


def _painter(
    surface: Surface, colors: ArrayLike | str | Painter | None, plain: tuple[float, float, float]
) -> Painter:
    """A function of triangles and weights for whatever colors are given as."""
    if callable(colors):
        return colors
    triangles, vertices = len(surface.triangles), len(surface.vertices)
    known = _as_colors("colors", plain if colors is None else colors, (vertices, triangles))
    if known.ndim == 1:
        return lambda where, weights: known
    if len(known) == vertices:
        linear = to_linear(known)
        return lambda where, weights: to_encoded(
            np.einsum("nk,nkd->nd", weights, linear[surface.triangles[where]])
        )
    return lambda where, weights: known[where]


def _as_colors(name: str, given: ArrayLike | str, counts: tuple[int, ...]) -> NDArray[np.float64]:
    """One color, (3,), or one for each of some count of things, as floats 0 to 1."""
    values = np.array(read_hex(given), np.uint8) if isinstance(given, str) else as_array(name, given)
    shapes = [(3,), *((count, 3) for count in counts)]
    if values.shape not in shapes:
        raise shape_error(name, values.shape, " or ".join(map(str, shapes)))
    if values.dtype.kind not in "iuf":
        raise TilewrightTypeError(
            "must hold numbers", argument=name, value=values.dtype, allowed="floats 0 to 1, integers 0 to 255"
        )
    shares: NDArray[np.float64] = values.astype(np.float64) / (255 if values.dtype.kind in "iu" else 1)
    if not ((shares >= 0) & (shares <= 1)).all():
        allowed = "floats 0 to 1, integers 0 to 255"
        raise TilewrightValueError(
            f"holds what is no color; allowed are {allowed}", argument=name, allowed=allowed
        )
    return shares


def _check_view(view: tuple[float, float]) -> tuple[float, float]:
    if not isinstance(view, (tuple, list)) or len(view) != 2:
        raise type_error("view", view, "two numbers, azimuth and elevation in degrees")
    return check_real("azimuth", view[0], -360, 360), check_real("elevation", view[1], -90, 90)
