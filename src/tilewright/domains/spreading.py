"""Spots all over a surface, at which it is looked at."""

import numpy as np

from tilewright.domains.spots import Spots
from tilewright.domains.surface import Surface

_ACROSS = np.array([0.7548776662466927, 0.5698402909980532])
"""Steps of the plane's most even sequence: 1/p and 1/p^2, where p^3 = p + 1 (Roberts 2018, R2)."""


def spread_spots(surface: Surface, count: int) -> Spots:
    """Spots that are even in area, one for each of ``count`` slices of the area.

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
