"""Tilings of surfaces: a color and a turn at every corner of a medial domain, and what tiles they make."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.domains.medial import MedialDomain, mix
from tilewright.seeds import Seed, derive_key, make_key


@dataclass(frozen=True, eq=False)
class SurfaceTiling:
    """Stochastic tiling of a medial domain: corners are hashed, so any tile can be told without the others.

    Attributes
    ----------
    domain : MedialDomain
        Where the tiles are.
    colors : int
        How many colors a corner may have.
    seed : int or numpy Generator
        What the corners are drawn from.

    Notes
    -----
    Li et al. 2010, section IV.A; departs from it in that tiles of all numbers of corners are made as needed,
    so none has to be laid first.
    """

    domain: MedialDomain
    colors: int
    seed: Seed

    @cached_property
    def slots(self) -> NDArray[np.int64]:
        """What every corner of every tile shows, as `MedialDomain.tile_starts` tells, 0 to 4 colors - 1.

        A corner of color c turned by o shows 4 c + (o - q) mod 4 to the tile in its quadrant q: 0 left of its
        leading half-edge, 1 where that begins, 2 right of it, 3 where it ends.
        """
        domain, here = self.domain, self.domain.half_edges
        values = self._draw(domain.edge_names)
        faces = _see(values, np.where(domain.leads, 0, 2))
        made = np.empty(int(domain.tile_starts[-1]), np.int64)
        made[: len(here)] = faces
        # Corners of a vertex: its half-edges in turn, then on the boundary the one before the last, and none.
        rings = domain.rings
        firsts = domain.tile_starts[len(domain.bases) : -1]
        made[firsts[here.origins] + rings.places] = _see(values, np.where(domain.leads, 1, 3))
        ends = np.flatnonzero(rings.open)
        before = here.prevs[rings.lasts[ends]]
        at = firsts[ends] + rings.counts[ends]
        made[at] = _see(values[before], np.where(domain.leads[before], 3, 1))
        made[at + 1] = self._draw(domain.names[ends])
        return made

    def _draw(self, names: NDArray[np.uint64]) -> NDArray[np.int64]:
        check_int("colors", self.colors, 1, 64)
        key = derive_key(make_key(self.seed), 17)
        drawn: NDArray[np.int64] = (mix(names ^ key) % np.uint64(4 * self.colors)).astype(np.int64)
        return drawn


def _see(values: NDArray[np.int64], quadrants: NDArray[np.int64]) -> NDArray[np.int64]:
    """What corners show to the tiles in their quadrants."""
    return values - values % 4 + (values - quadrants) % 4
