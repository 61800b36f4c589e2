"""How well a point set samples: the zone plate test (Lagae 2007, section 6.2.3)."""

from dataclasses import dataclass
from functools import cache
from itertools import product
from math import ceil

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.points.checks import check_set
from tilewright.errors import TilewrightValueError
from tilewright.samplers.point_set import PointSet
from tilewright.showing import describe_record

PIXELS = 512
DOMAIN = 48.0
_REACH = 2
"""Pixels from its center to the end of the filter."""
_LEAST_WEIGHT = 0.05
_FEWEST = PIXELS**2 // 4
_NYQUIST = np.pi * PIXELS / DOMAIN / 2
"""Distance from the origin at which the function, with distance / pi periods, has two pixels for each."""


@dataclass(frozen=True, eq=False)
class ZonePlate:
    """What a point set makes of the zone plate.

    Attributes
    ----------
    picture : float64 array, shape (512, 512)
        The reconstructed function, 0 to 1, in this library's orientation: the function's origin is at the
        corner of pixel [0, 0], y grows with the row. The thesis shows it with the origin at the lower left.
    error : float
        Root of the mean square difference to `zone_plate_reference`, over all pixels, of values as shown
        (0 to 1).
    error_near : float
        The same where the pixels are fine enough for the function, less than 16.76 from the origin: there
        a sampling pattern should show nothing but the function.
    rate : float
        Samples for each pixel; 1 in the thesis.
    holes : int
        Pixels with no samples near enough to say anything, which show the function's mean, 1/2.
    """

    picture: NDArray[np.float64]
    error: float
    error_near: float
    rate: float
    holes: int

    __repr__ = describe_record


def zone_plate(points: PointSet) -> ZonePlate:
    """Sample f(x, y) = (1 + sin(x^2 + y^2)) / 2 over [0, 48[^2 and reconstruct it with 512 x 512 pixels.

    Each pixel is the weighted mean of the samples less than two pixels away in x and in y, with the weights
    of a Mitchell-Netravali filter of 4 x 4 pixels (B = C = 1/3). The set is scaled so that its box becomes
    the domain; of a box that is no square, the square at its origin is used. Where the box is a torus, its
    points go on beyond the border, where the function is sampled too, so that border pixels have all their
    samples; on a plain box they have those inside only. Sums are made in the order of the points.
    Lagae 2007, section 6.2.3.

    Parameters
    ----------
    points : PointSet
        In a plane; about 262,144 points, one for each pixel. Compare sets of about the same number only.

    Returns
    -------
    ZonePlate
        The picture, and its error against the function.

    Raises
    ------
    TilewrightTypeError
        Something else than a `PointSet`.
    TilewrightValueError
        Fewer than 65,536 points in the square, one for four pixels, or a set that is not in a plane.
    """
    given = check_set(points)
    x, y = _spread(given)
    inside = int(((x >= 0) & (x < PIXELS) & (y >= 0) & (y < PIXELS)).sum())
    if inside < _FEWEST:
        raise TilewrightValueError(
            f"has {inside} points in the square; at least {_FEWEST} are needed, and {PIXELS**2}, one "
            "for each pixel, are usual",
            argument="points",
            value=inside,
        )
    from tilewright.kernels.zone_plate import splat_samples

    sums, weights = np.zeros((PIXELS, PIXELS)), np.zeros((PIXELS, PIXELS))
    splat_samples(x, y, _function(x, y), sums, weights)
    known = weights >= _LEAST_WEIGHT
    picture = np.divide(sums, weights, where=known, out=np.full_like(sums, 0.5)).clip(0, 1)
    off = (picture - zone_plate_reference().clip(0, 1)) ** 2
    center = (np.arange(PIXELS) + 0.5) * (DOMAIN / PIXELS)
    near = np.hypot(center, center[:, np.newaxis]) < _NYQUIST
    error, error_near = float(np.sqrt(off.mean())), float(np.sqrt(off[near].mean()))
    return ZonePlate(picture, error, error_near, inside / PIXELS**2, int((~known).sum()))


@cache
def zone_plate_reference() -> NDArray[np.float64]:
    """The zone plate seen through the same filter without sampling, shape (512, 512); made in milliseconds.

    The limit of ever more samples for each pixel (the thesis takes a million). It is exact to rounding,
    since filter and function fall apart into factors of x and of y, sin(x^2 + y^2) = sin x^2 cos y^2 +
    cos x^2 sin y^2, and one-dimensional integrals are left.
    """
    # Gauss-Legendre on the four smooth pieces of the filter.
    nodes, node_weights = np.polynomial.legendre.leggauss(32)
    offsets = np.concatenate([piece + (nodes + 1) / 2 for piece in range(-_REACH, _REACH)])
    filtered = np.tile(node_weights / 2, 2 * _REACH) * _mitchell(offsets)
    squares = ((np.arange(PIXELS)[:, None] + 0.5 + offsets) * (DOMAIN / PIXELS)) ** 2
    sines, cosines = np.sin(squares) @ filtered, np.cos(squares) @ filtered
    picture = (1 + np.outer(sines, cosines) + np.outer(cosines, sines)) / 2
    picture.flags.writeable = False
    return picture


def _function(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    """Eq. 6.7 at places in pixels."""
    scale = DOMAIN / PIXELS
    return (1 + np.sin((x * scale) ** 2 + (y * scale) ** 2)) / 2


def _mitchell(t: NDArray[np.float64]) -> NDArray[np.float64]:
    """The filter of Mitchell & Netravali 1988, B = C = 1/3, which has the integral 1."""
    t = np.abs(t)
    near = (7 * t**3 - 12 * t**2 + 16 / 3) / 6
    far = (-7 / 3 * t**3 + 12 * t**2 - 20 * t + 32 / 3) / 6
    return np.where(t < 1, near, np.where(t < 2, far, 0))


def _spread(points: PointSet) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The points in pixels, and on a torus their copies as far around the picture as the filter reaches."""
    side = min(points.box.extent)
    places = points.points * (PIXELS / side)
    if points.box.torus:
        periods = np.array(points.box.extent) * (PIXELS / side)
        copies = range(-1, ceil((PIXELS + _REACH) / PIXELS))
        places = np.concatenate([places + np.array(shift) * periods for shift in product(copies, copies)])
    near = ((places > -_REACH) & (places < PIXELS + _REACH)).all(axis=1)
    x, y = np.ascontiguousarray(places[near].T)
    return x, y
