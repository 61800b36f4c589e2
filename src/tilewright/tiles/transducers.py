"""A tile set as a transducer: a machine that reads a row of colors and writes the row below it.

Its states are the colors between neighbors, its transitions the tiles, west to east; rows below one another
are transducers composed (Kari 1996; Jeandel & Rao 2015, who read from south to north; the package slabbe uses
the same words). A row without end is a path without end, so what lies on no such path can go.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.showing import describe_record
from tilewright.tiles.shape import CORNER
from tilewright.tiles.tileset import TileSet, check_tiles
from tilewright.tiles.translations import as_wang_tiles, count_pairs, join, wang_slots

_MOST_TRANSITIONS = 4_000_000
_MOST_ROWS = 64

Numbers = NDArray[np.int64]


@dataclass(frozen=True)
class Transducer:
    """Columns of tiles, one or more rows high, as transitions between states; `strip` makes them.

    A rectangle as high as the columns is a path: each column's ``target`` is the ``source`` of the next. It
    fits below another rectangle where that one writes what it reads.

    Attributes
    ----------
    columns : int32 array, shape (M, rows)
        Tiles of each transition, north to south.
    source : int64 array, shape (M,)
        States at the W side, numbered from 0 on.
    target : int64 array, shape (M,)
        States at the E side.
    read : int64 array, shape (M,)
        Color of the north edge of the first tile.
    write : int64 array, shape (M,)
        Color of the south edge of the last tile.

    Notes
    -----
    Kari 1996 and Jeandel & Rao 2015, who read from south to north.
    """

    columns: NDArray[np.int32]
    source: Numbers
    target: Numbers
    read: Numbers
    write: Numbers

    __repr__ = describe_record

    def __len__(self) -> int:
        return len(self.columns)

    @property
    def states(self) -> int:
        """Number of states."""
        return int(max(self.source.max(initial=-1), self.target.max(initial=-1))) + 1

    def compose(self, below: "Transducer") -> "Transducer":
        """Put the rows of another transducer below these rows.

        Parameters
        ----------
        below : Transducer
            It reads what this one writes.

        Returns
        -------
        Transducer
            As many rows as both have together.

        Raises
        ------
        TilewrightValueError
            There would be more than 4 million transitions.
        """
        pairs = count_pairs(self.write, below.read)
        if pairs > _MOST_TRANSITIONS:
            raise TilewrightValueError(
                f"{pairs} columns are that many rows high; allowed are {_MOST_TRANSITIONS}, with fewer rows"
            )
        up, down = join(self.write, below.read)
        return _numbered(
            np.concatenate([self.columns[up], below.columns[down]], axis=1),
            self.source[up] * below.states + below.source[down],
            self.target[up] * below.states + below.target[down],
            self.read[up],
            below.write[down],
        )

    def trim(self) -> "Transducer":
        """Leave out transitions that lie on no path that is endless both ways.

        Returns
        -------
        Transducer
            The rest, its states numbered anew.
        """
        kept = self
        while True:
            endless = np.isin(kept.source, kept.target) & np.isin(kept.target, kept.source)
            if endless.all():
                return kept
            kept = kept.only(endless)

    def strong(self) -> "Transducer":
        """Leave out transitions that lie on no cycle.

        It leaves fewer than `trim`. If the set tiles the plane it does so with these alone: far enough to the
        east every strip of rows stays in one strongly connected part.

        Returns
        -------
        Transducer
            The rest, its states numbered anew.

        Notes
        -----
        Jeandel & Rao 2015 do the same.
        """
        from scipy.sparse.csgraph import connected_components

        part = connected_components(self._graph(), connection="strong")[1]
        return self.only(part[self.source] == part[self.target])

    def only(self, kept: NDArray[Any]) -> "Transducer":
        """Keep some of the transitions.

        Parameters
        ----------
        kept : bool array, shape (M,), or int array
            A mask, or indices.

        Returns
        -------
        Transducer
            These transitions, their states numbered anew.
        """
        return _numbered(
            self.columns[kept], self.source[kept], self.target[kept], self.read[kept], self.write[kept]
        )

    def cycle(self) -> NDArray[np.int32] | None:
        """Find columns that follow each other in a ring.

        Returns
        -------
        int32 array, shape (rows, width), or None
            The columns of the shortest ring through one of the states; None where there are no rings.
        """
        from scipy.sparse.csgraph import breadth_first_order

        ringed = self.strong()
        if not len(ringed):
            return None
        start = int(ringed.source[0])
        order, before = breadth_first_order(ringed._graph(), start)
        reached = np.full(ringed.states, ringed.states)
        reached[order] = np.arange(len(order))
        last = ringed.source[ringed.target == start]
        path = [start, int(last[np.argmin(reached[last])])]
        while path[-1] != start:
            path.append(int(before[path[-1]]))
        steps = [_first(ringed, a, b) for b, a in pairwise(path)]
        steps.reverse()
        return ringed.columns[steps].T

    def _graph(self) -> Any:
        from scipy.sparse import coo_array

        ones = np.ones(len(self), np.int32)
        return coo_array((ones, (self.source, self.target)), (self.states, self.states)).tocsr()


def strip(tiles: TileSet, rows: int = 1) -> Transducer:
    """List all columns of tiles that lie in strips without end, as a transducer.

    Parameters
    ----------
    tiles : TileSet
        Wang tiles, or corner tiles, taken as the Wang tiles with the same indices (`as_wang_tiles`).
    rows : int, optional
        Height of a strip in tiles, 1 to 64; default 1.

    Returns
    -------
    Transducer
        It has no states where no strip is endless.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set, or a height that is not an integer.
    TilewrightValueError
        There would be more than 4 million transitions, the height is out of range, or the tiles are of
        another shape.

    Notes
    -----
    Kari 1996; Jeandel & Rao 2015.
    """
    if check_tiles("tiles", tiles).shape is CORNER:
        tiles = as_wang_tiles(tiles)
    n, e, s, w = wang_slots(tiles).T
    check_int("rows", rows, 1, _MOST_ROWS)
    row = _numbered(np.arange(len(tiles), dtype=np.int32)[:, None], w, e, n, s).trim()
    made = row
    for _ in range(rows - 1):
        made = made.compose(row).trim()
    return made


def find_period(tiles: TileSet, rows: int) -> NDArray[np.int32] | None:
    """Find a tiling that repeats after a number of rows, or prove that there is none.

    Parameters
    ----------
    tiles : TileSet
        Wang tiles or corner tiles.
    rows : int
        Rows after which the tiling repeats, 1 to 64.

    Returns
    -------
    int32 array, shape (rows, columns), or None
        Tile indices for ``array_tiling(tiles, ..., torus=True)``. None proves that no tiling repeats after
        this number of rows.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set, or a number that is not an integer.
    TilewrightValueError
        There are more than 4 million columns to look at, the number of rows is out of range, or the tiles are
        of another shape.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.find_period(tw.aperiodic_tiles("lagae-44"), 3).shape
    (3, 2)
    >>> tw.find_period(tw.aperiodic_tiles("jeandel-rao-11-5"), 3) is None
    True
    """
    high = strip(tiles, rows)
    return high.only(high.read == high.write).cycle()


def _numbered(
    columns: NDArray[np.int32], source: Numbers, target: Numbers, read: Numbers, write: Numbers
) -> Transducer:
    """A transducer whose states are numbered from 0 on, in ascending order of the numbers given."""
    states = np.unique([source, target], return_inverse=True)[1].reshape(2, -1)
    return Transducer(columns, states[0], states[1], read, write)


def _first(transducer: Transducer, source: int, target: int) -> int:
    """The first transition between two states."""
    return int(np.argmax((transducer.source == source) & (transducer.target == target)))
