"""Texture tiles with corner colors as the papers make them.

Four square patches, with or without a patch over the seam (Lagae & Dutré 2006, figure 6c and 6d).
"""

import numpy as np

from tilewright.signals.textures.corners import choose_corners, random_corners
from tilewright.signals.textures.frame import Frame
from tilewright.signals.textures.nested import (
    OVERLAP,
    cut_ends,
    end_places,
    even,
    join_edges,
    lay_centers,
    shown_in_tile,
)
from tilewright.signals.textures.patchwork import Patchwork, stack
from tilewright.signals.textures.plan import Plan
from tilewright.signals.textures.search import Opening, PatchSearch


def lay_squares(search: PatchSearch, plan: Plan, rng: np.random.Generator) -> Patchwork:
    """Figure 6c: the patches of the four corners, cut where they overlap along the tile's cross.

    The cut between two corner patches is made once for each edge, so that tiles with that edge agree.
    """
    frame = Frame(search.size)
    # Step 1: a square patch for each corner color (Lagae & Dutré 2006, section 5.1).
    corners = choose_corners(search, plan, round(OVERLAP * search.size), rng)
    # Step 2: for each edge, the cut between the patches at its ends.
    edges = [cut_ends(search, frame, edge, corners, even(frame)) for edge in plan.edges]
    # Step 3: each tile is the four corner patches, parted by the cuts of its four edges.
    return stack([join_edges(frame, [edges[e] for e in sides]) for sides in plan.tile_edges])


def lay_ng(search: PatchSearch, plan: Plan, rng: np.random.Generator, variants: int = 1) -> Patchwork:
    """Figure 6d, Ng et al. 2005: random square patches side by side; the seam is covered by one patch.

    The patch must cover the cross-shaped seam and lies in the circle inscribed in the tile, so the last
    pixels of the seam, at the middles of the edges, stay bare. Where the paper takes a random patch,
    the best of a search is taken.
    """
    frame = Frame(search.size)
    # Step 1: a square patch at random for each corner color (Lagae & Dutré 2006, section 5.1).
    corners = random_corners(search, plan, rng)
    # Step 2: where the patch over the seam must lie, and where it may: in the circle inscribed in the tile.
    radius = np.hypot(frame.u, frame.v)
    circle = radius < frame.half - 1
    core = (np.minimum(np.abs(frame.u), np.abs(frame.v)) < 2) & (radius < 0.8 * frame.half)
    state = frame.ring(core, circle)
    # Step 3: the patches at the ends of each edge side by side, with a bare seam in the middle.
    edges = []
    for edge in plan.edges:
        first, second = end_places(frame, edge, corners)
        along, _ = frame.along_across(edge.axis)
        edges.append(Patchwork.of_patch(frame.size, frame.size, first).with_patch(second, along > 0))
    openings = []
    for tile, sides in enumerate(plan.tile_edges):
        # Step 4: the four patches of a tile leave a cross-shaped seam,
        canvas = join_edges(frame, [edges[e] for e in sides])
        shown = shown_in_tile(frame, plan, tile, corners, [[] for _ in edges])
        # Step 5: which an irregular patch covers, found and cut by graph cut (Kwatra et al. 2003).
        openings.append(Opening(canvas, state, even(frame), plan.sources_of_tile(tile), shown))
    return lay_centers(search, openings.__getitem__, len(openings), variants)
