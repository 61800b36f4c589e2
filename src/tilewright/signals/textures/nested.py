"""Texture tiles with corner colors: corner patches under edge patches under center patches.

The method of Ng et al. 2005 (as told in Lagae & Dutré 2006, section 5.1) covers the seams between four
corner patches with one patch per tile, inside the inscribed circle. Here, three things are stronger:
the seam between two corner patches is cut once for each pair of colors and shared by all tiles with that
edge; each pair of colors gets an edge patch of its own; and the patch of a tile may reach all of the
tile but its border. Corner content then recurs with probability 1/C, edge content with 1/C^2 and the rest
with 1/C^4.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures.corners import choose_corners, choose_meeting_corners
from tilewright.signals.textures.frame import Frame, shared_border
from tilewright.signals.textures.patchwork import FORCED_NEW, FORCED_OLD, OPEN, Patchwork
from tilewright.signals.textures.plan import Edge, Plan
from tilewright.signals.textures.search import (
    FURTHER_CANDIDATES,
    Opening,
    PatchSearch,
    Place,
)

# What was seen when a number was changed: three sets of `corner_tiles(2)` of 32 pixels from a picture of
# smooth noise, told by two figures of `analyze`. As the numbers stand, color steps across cuts are 1.36 times
# those elsewhere (``cut_line_ratio``), and 0.18 is shared by two cells (``same_place_share``).
OVERLAP = 0.11
"""Half the width in which two corner patches are cut, in tiles. At 0.06 and 0.20 steps are 1.33 and 1.34
times: no difference in noise. Wide ones have room to go around things, and take more of the photograph."""
WIDE_OVERLAP = 0.2
"""The same where no patch covers that cut."""
EDGE_CORE = (0.22, 0.12)
"""Half-length and half-width of the part an edge patch must fill, in tiles. At half of both steps are 1.32
times, and 0.20 is shared; at (0.35, 0.20) they are 1.43 times, and 0.16 is."""
MIXED_CORE = 0.5
"""The cores shrink to this share where two sources meet, so that the cut decides where one ends."""


def lay_nested(search: PatchSearch, plan: Plan, rng: np.random.Generator, variants: int = 1) -> Patchwork:
    """All variants of all tiles of a plan, stacked: coordinates of shape (T variants, size, size)."""
    frame = Frame(search.size)
    choose = choose_meeting_corners if search.manner.jointly else choose_corners
    corners = choose(search, plan, overlap_of(search), rng)
    edges: list[Patchwork | None] = []
    edge_places: list[list[Place]] = []
    needed = search.kept.edges_to_lay(plan) if search.kept else range(len(plan.edges))
    for number, edge in enumerate(plan.edges):
        if number not in needed:
            edges.append(None)
            edge_places.append(keep_edge(search, frame, edge))
            continue
        seen = [
            p
            for e, ps in zip(plan.edges[: len(edge_places)], edge_places, strict=True)
            if e.axis == edge.axis
            for p in ps
        ]
        canvas, places = lay_edge(search, frame, plan, edge, corners, seen)
        edges.append(canvas)
        edge_places.append(places)

    def opening_of(tile: int) -> Opening:
        canvas = join_edges(frame, [edge for e in plan.tile_edges[tile] if (edge := edges[e])])
        shown = shown_in_tile(frame, plan, tile, corners, edge_places)
        return center_opening(search, frame, canvas, plan.sources_of_tile(tile), shown)

    return lay_centers(search, opening_of, len(plan.tile_edges), variants, plan)


def overlap_of(search: PatchSearch) -> int:
    """Half the width in which two corner patches are cut, in pixels."""
    return round((WIDE_OVERLAP if search.manner.plain_edges else OVERLAP) * search.size)


def corner_reach(search: PatchSearch) -> int:
    """Pixels of the photograph that a corner patch needs around its lattice point."""
    return search.size // 2 + overlap_of(search)


def lay_centers(
    search: PatchSearch,
    opening_of: Callable[[int], Opening],
    count: int,
    variants: int,
    plan: Plan | None = None,
) -> Patchwork:
    """Give each tile as many patches of its own as there are variants, over what it shares with others.

    The first variants of all tiles come first, so that they are the pictures of a set without variants; the
    result is in order of tiles. Openings are made when they are needed, for memory.
    """
    centers: list[Place] = []
    rows, columns = np.empty((2, count, variants, search.size, search.size), np.int32)
    for variant in range(variants):
        for tile in range(count):
            name = f"center:{tile}:{variant}" if variant else f"center:{tile}"
            if search.kept and search.kept.stays(name, tile, plan):
                canvas, place = search.kept.picture(tile, variant), search.ledger.picked[name]
                search.record(name, place, search.kept.shown(tile, variant, place))
                rows[tile, variant], columns[tile, variant] = canvas.rows, canvas.columns
                centers.append(place)
                continue
            waiting = replace(opening_of(tile), earlier=centers)
            if variant:
                # What all of them bar is then no larger a part of the exemplar than without variants.
                waiting = replace(waiting, candidates=FURTHER_CANDIDATES, spacing=variants**-0.5)
            canvas, place = search.lay(name, waiting)
            rows[tile, variant], columns[tile, variant] = canvas.rows, canvas.columns
            centers.append(place)
    return Patchwork(*(part.reshape(-1, search.size, search.size) for part in (rows, columns)))


def keep_edge(search: PatchSearch, frame: Frame, edge: Edge) -> list[Place]:
    """The place of an edge's own patch, if it has one, where no tile with that edge is laid anew."""
    if search.manner.plain_edges:
        return []
    place = search.ledger.picked[edge.name]
    search.record(edge.name, place, edge_core(frame, edge, 1))
    return [place]


def lay_edge(
    search: PatchSearch,
    frame: Frame,
    plan: Plan,
    edge: Edge,
    corners: list[Place],
    earlier: list[Place],
) -> tuple[Patchwork, list[Place]]:
    """The canvas of an edge, and the place of its own patch, if it has one."""
    along, across = frame.along_across(edge.axis)
    # The center patches cover what is far from the edge, so seams matter less there.
    distance = np.abs(across) / frame.size
    weight = np.clip(1 - 0.95 * distance / 0.3, 0.05, 1).astype(np.float32)
    # Step 1: cut the two corner patches where they overlap.
    canvas = cut_ends(search, frame, edge, corners, weight)
    if search.manner.plain_edges:
        return canvas, []
    # Step 2: lay the edge's own patch over the middle of the seam.
    sources = plan.sources_of_edge(edge)
    shrink = MIXED_CORE if len(sources) > 1 else 1
    core = edge_core(frame, edge, shrink)
    # The corners of tiles are left to the corner patches, and the cut has a pixel to the diamond's border.
    limit = np.abs(frame.u) + np.abs(frame.v) < frame.half - 1
    limit &= np.abs(along) < frame.half - shared_border(frame.size)
    ends = end_places(frame, edge, corners)
    manner = search.manner
    opening = Opening(
        canvas,
        frame.ring(core, limit),
        weight,
        sources,
        ends,
        earlier,
        manner.plainness[1],
        manner.recurrence,
        lines=(frame.half, 0) if edge.axis == 0 else (0, frame.half),
        barred=search.bars.lone_in_edge(edge.axis),
    )
    canvas, place = search.lay(edge.name, opening)
    return canvas, [place]


def edge_core(frame: Frame, edge: Edge, shrink: float) -> NDArray[np.bool_]:
    """The part of an edge's canvas that its own patch must fill."""
    along, across = frame.along_across(edge.axis)
    length, width = (c * frame.size * shrink for c in EDGE_CORE)
    return (np.abs(along) < length) & (np.abs(across) < width)


def cut_ends(
    search: PatchSearch, frame: Frame, edge: Edge, corners: list[Place], weight: NDArray[np.float32]
) -> Patchwork:
    """The canvas of an edge with its two corner patches, cut where they overlap."""
    along, _ = frame.along_across(edge.axis)
    first, second = end_places(frame, edge, corners)
    state = np.where(along < 0, FORCED_OLD, FORCED_NEW).astype(np.uint8)
    state[frame.diamond & (np.abs(along) < overlap_of(search))] = OPEN
    canvas = Patchwork.of_patch(frame.size, frame.size, first)
    return canvas.with_patch(second, search.cut(Opening(canvas, state, weight, ()), second))


def end_places(frame: Frame, edge: Edge, corners: list[Place]) -> tuple[Place, Place]:
    """Where the corner patches of an edge lie, in the canvas of the edge."""
    (ay, ax), (by, bx) = corners[edge.first], corners[edge.second]
    if edge.axis == 0:
        return (ay - frame.half, ax), (by - frame.half, bx - frame.size)
    return (ay, ax - frame.half), (by - frame.size, bx - frame.half)


def join_edges(frame: Frame, edges: list[Patchwork]) -> Patchwork:
    """A tile's canvas: the triangle each of its edges N, E, S, W decides."""
    rows = np.empty((frame.size, frame.size), np.int32)
    columns = np.empty_like(rows)
    for side, ((y, x), edge) in enumerate(zip(frame.triangle_pixels, edges, strict=True)):
        dy, dx = frame.edge_offset(side)
        rows[y, x] = edge.rows[y + dy, x + dx]
        columns[y, x] = edge.columns[y + dy, x + dx]
    return Patchwork(rows, columns)


def shown_in_tile(
    frame: Frame, plan: Plan, tile: int, corners: list[Place], edge_places: list[list[Place]]
) -> list[Place]:
    """Places of the patches a tile already shows, in the canvas of the tile."""
    shown = []
    for corner, number in enumerate(plan.tile_corners[tile]):
        dy, dx = frame.corner_offset(corner)
        shown.append((corners[number][0] - dy, corners[number][1] - dx))
    for side, edge in enumerate(plan.tile_edges[tile]):
        dy, dx = frame.edge_offset(side)
        shown += [(y + dy, x + dx) for y, x in edge_places[edge]]
    return shown


def center_opening(
    search: PatchSearch, frame: Frame, canvas: Patchwork, sources: Sequence[int], shown: list[Place]
) -> Opening:
    """What waits for a tile's own patch: everything but the border."""
    core = frame.superellipse(search.manner.core * (MIXED_CORE if len(sources) > 1 else 1))
    state = frame.ring(core, inside_border(frame))
    manner = search.manner
    return Opening(
        canvas,
        state,
        even(frame),
        sources,
        shown,
        plainness=manner.plainness[2],
        recurrence=manner.recurrence,
        barred=None if manner.lone is None else search.bars.spent,
    )


def inside_border(frame: Frame) -> NDArray[np.bool_]:
    """Pixels of a tile that its neighbors need not share."""
    reach = frame.half - shared_border(frame.size)
    return (np.abs(frame.u) < reach) & (np.abs(frame.v) < reach)


def even(frame: Frame) -> NDArray[np.float32]:
    """Seams count the same everywhere."""
    return np.ones((frame.size, frame.size), np.float32)
