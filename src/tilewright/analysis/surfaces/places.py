"""Places all over a surface, at which it is looked at, and walks from them."""

import numpy as np
from numpy.typing import NDArray

from tilewright.domains.spots import Spots
from tilewright.domains.surface import Surface

_ACROSS = np.array([0.7548776662466927, 0.5698402909980532])
"""Steps of the plane's most even sequence: 1/p and 1/p^2, where p^3 = p + 1 (Roberts 2018, R2)."""
_CROSSINGS = 64
"""Most edges that a walk crosses; the rest of a longer one is left out."""


def spread_places(surface: Surface, count: int) -> Spots:
    """Places that are even in area, one for each of ``count`` slices of the area.

    Triangles take their slices one after another, and those of one triangle lie as a sequence that fills it
    evenly, so that neither many small triangles nor a few large ones leave gaps. No chance is in it.
    """
    sums = np.cumsum(surface.areas)
    slices = (np.arange(count) + 0.5) * (sums[-1] / count)
    triangles = np.minimum(np.searchsorted(sums, slices, side="right"), len(sums) - 1).astype(np.int32)
    across = (0.5 + np.arange(count)[:, np.newaxis] * _ACROSS) % 1
    outside = across.sum(axis=1) > 1
    across[outside] = 1 - across[outside]
    return Spots(triangles, np.column_stack([1 - across.sum(axis=1), across]))


def walk(surface: Surface, places: Spots, steps: NDArray[np.float64]) -> Spots:
    """Go straight along the surface, as far and where ``steps``, float64 (n, 3), points.

    What points out of a triangle's plane is left out, and whoever comes to the border stays there.
    """
    triangles, weights = places.triangles.copy(), places.weights.copy()
    ahead = steps - _along(steps, surface.normals[triangles])
    going = np.arange(len(triangles))
    for _ in range(_CROSSINGS):
        here, rates = triangles[going], _rates(surface, triangles[going], ahead[going])
        with np.errstate(divide="ignore", invalid="ignore"):
            times = np.where(rates < 0, -weights[going] / rates, np.inf)
        corner = times.argmin(axis=1)
        part = np.clip(times[np.arange(len(going)), corner], 0, 1)
        weights[going] = np.maximum(weights[going] + part[:, np.newaxis] * rates, 0)
        ahead[going] *= (1 - part)[:, np.newaxis]
        edge = (corner + 1) % 3
        across = surface.twins[here, edge]
        goes = (part < 1) & (across >= 0)
        going, here, edge, across = going[goes], here[goes], edge[goes], across[goes]
        if not len(going):
            break
        ahead[going] = _turned(surface, ahead[going], here, edge, across // 3)
        crossed = np.zeros((len(going), 3))
        # The twin runs from its other end.
        rows = np.arange(len(going))
        crossed[rows, across % 3] = weights[going, (edge + 1) % 3]
        crossed[rows, (across % 3 + 1) % 3] = weights[going, edge]
        triangles[going], weights[going] = across // 3, crossed
    return Spots(triangles, weights / weights.sum(axis=1, keepdims=True))


def _along(steps: NDArray[np.float64], units: NDArray[np.float64]) -> NDArray[np.float64]:
    """The part of steps that goes along unit vectors."""
    return np.einsum("nd,nd->n", steps, units)[:, np.newaxis] * units


def _rates(surface: Surface, triangles: NDArray[np.int32], ahead: NDArray[np.float64]) -> NDArray[np.float64]:
    """How much the weights change over a step in the triangle's plane."""
    corners = surface.vertices[surface.triangles[triangles]]
    opposite = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    inward = np.cross(surface.normals[triangles][:, np.newaxis], opposite)
    return np.einsum("nkd,nd->nk", inward, ahead) / (2 * surface.areas[triangles])[:, np.newaxis]


def _turned(
    surface: Surface,
    ahead: NDArray[np.float64],
    here: NDArray[np.int32],
    edge: NDArray[np.int64],
    there: NDArray[np.int32],
) -> NDArray[np.float64]:
    """Steps turned about the edge that is crossed, into the plane of the triangle beyond."""
    ends = surface.triangles[here]
    rows = np.arange(len(here))
    line = surface.vertices[ends[rows, (edge + 1) % 3]] - surface.vertices[ends[rows, edge]]
    line /= np.linalg.norm(line, axis=1, keepdims=True)
    out_of, into = np.cross(line, surface.normals[here]), np.cross(line, surface.normals[there])
    forth = np.einsum("nd,nd->n", ahead, out_of)[:, np.newaxis]
    return _along(ahead, line) + forth * into
