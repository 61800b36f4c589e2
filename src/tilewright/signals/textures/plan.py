"""Who shares what: which corner patches and edge patches each tile of a set is made of."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tiles import TileSet


@dataclass(frozen=True)
class Edge:
    """A kind of tile edge.

    ``axis`` 0 runs from west to east, 1 from north to south; ``first`` and ``second`` are the corner
    patches at its two ends; ``color`` is the color of the edge itself where the set has one.
    """

    axis: int
    first: int
    second: int
    color: int

    @property
    def name(self) -> str:
        """Name of the edge patch, as in recipes: ``edge-h:0-1`` or ``edge-v:0-1:2``."""
        color = f":{self.color}" if self.color >= 0 else ""
        return f"edge-{'hv'[self.axis]}:{self.first}-{self.second}{color}"


@dataclass(frozen=True, eq=False)
class Plan:
    """What the patches of a tile set are.

    Attributes
    ----------
    corner_sources : tuple of int
        The source each corner patch is taken from.
    edges : tuple of Edge
    tile_corners : int array, shape (T, 4)
        Corner patches at NE, SE, SW, NW of each tile.
    tile_edges : int array, shape (T, 4)
        Edges N, E, S, W of each tile, as positions in ``edges``.
    """

    corner_sources: tuple[int, ...]
    edges: tuple[Edge, ...]
    tile_corners: NDArray[np.int64]
    tile_edges: NDArray[np.int64]

    def sources_of_edge(self, edge: Edge) -> tuple[int, ...]:
        """The sources met along an edge."""
        return tuple(sorted({self.corner_sources[edge.first], self.corner_sources[edge.second]}))

    def sources_of_tile(self, tile: int) -> tuple[int, ...]:
        """The sources met at the corners of a tile."""
        return tuple(sorted({self.corner_sources[c] for c in self.tile_corners[tile]}))


# End corners of the edges N, E, S, W, as positions in NE, SE, SW, NW.
_ENDS = ((3, 0), (0, 1), (2, 1), (3, 2))


def make_plan(tiles: TileSet, sources: int) -> Plan:
    """The patches of a set whose corners are colored, from one source or two.

    With two sources the upper half of the corner colors, the *marked* ones, come from the second
    (Cohen et al. 2003, section 3.5).
    """
    if "NE" not in tiles.shape.slots:
        raise TilewrightValueError(
            f"nested patches need corner colors and {tiles.shape.name} tiles have none",
            advice="use method 'diamonds'",
        )
    names = tiles.shape.slots
    corners = tiles.slots[:, [names.index(c) for c in ("NE", "SE", "SW", "NW")]].astype(np.int64)
    count = int(max(tiles.colors[names.index(c)] for c in ("NE", "SE", "SW", "NW")))
    colors = tiles.slots[:, :4].astype(np.int64) if "N" in names else np.full_like(corners, -1)
    edges: dict[Edge, int] = {}
    tile_edges = np.empty_like(corners)
    for t in range(len(tiles)):
        for side, (first, second) in enumerate(_ENDS):
            ends = (int(corners[t, first]), int(corners[t, second]))
            edge = Edge(side % 2, *ends, int(colors[t, side]))
            tile_edges[t, side] = edges.setdefault(edge, len(edges))
    # Each class has plain and marked colors of its own.
    classes = tiles.parameters["classes"] if tiles.family == "classed" else 1
    return Plan(classes * corner_sources(count // classes, sources), tuple(edges), corners, tile_edges)


def corner_sources(colors: int, sources: int) -> tuple[int, ...]:
    """The source of each corner color: with two sources the upper half is marked."""
    if sources > 2:
        raise TilewrightValueError(f"{sources} sources were given; texture tiles mix at most 2")
    if sources == 2 and colors < 2:
        raise TilewrightValueError("two sources need a tile set with at least 2 corner colors")
    return tuple(int(sources == 2 and color >= (colors + 1) // 2) for color in range(colors))
