"""Brick Wang tiles: how the corners of four bricks meet (Kaji et al. 2016, section 4).

The lines between bricks cross the edges of a tile at one of n positions. A tile is traversed by one line:
it has E = W and N != S and is traversed along the row (class H), or N = S and E != W and is traversed along
the column (class V). The other line breaks where it meets it, so four bricks never meet in a cross. Every
lattice point, where four tiles meet, lies in one brick.
"""

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.shape import WANG
from tilewright.tiles.tileset import MOST_FAMILY_COLORS, TileSet, check_tiles, decode


def brick_tiles(positions: int = 4) -> TileSet:
    """Make the brick Wang tiles over n positions: how the corners of four bricks meet.

    The lines between bricks cross the edges of a tile at one of n positions. A tile has E = W and N != S, or
    N = S and E != W, so that one line goes through and the other one breaks.

    Parameters
    ----------
    positions : int, optional
        Number of positions n, 2 to 16; default 4. Position k stands for the place (k + 1) / (n + 1) along an
        edge, unless what draws the tiles says otherwise: from west to east on N and S edges, from north to
        south on E and W edges.

    Returns
    -------
    TileSet
        2 n^2 (n - 1) tiles, slots N, E, S, W; the (c1, c2, c3, c4) of the paper are W, N, E, S.

    Raises
    ------
    TilewrightTypeError
        The number is not an integer.
    TilewrightValueError
        It is out of range.

    Notes
    -----
    Kaji et al. 2016, section 4, the set W.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.brick_tiles(4)
    <TileSet bricks-4: 96 wang tiles, colors (4, 4, 4, 4)>
    """
    return _brick_tiles(check_positions(positions))


@cache
def _brick_tiles(n: int) -> TileSet:
    slots = decode(np.arange(n**4), (n,) * 4)
    north, east, south, west = slots.T
    return ListedTileSet(WANG, slots[(north == south) != (east == west)], (n,) * 4, f"bricks-{n}")


def check_positions(value: int) -> int:
    """A number of positions."""
    return check_int("positions", value, 2, MOST_FAMILY_COLORS)


def check_bricks(name: str, given: Any) -> TileSet:
    """``given`` if it is one of the sets of `brick_tiles`; n is the number of colors of its slots."""
    tiles = check_tiles(name, given)
    n = tiles.colors[0]
    if not 2 <= n <= MOST_FAMILY_COLORS or not np.array_equal(tiles.slots, brick_tiles(n).slots):
        raise TilewrightValueError(
            f"is the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles",
            argument=name,
            advice="take brick_tiles(n)",
        )
    return tiles


def number_bricks(
    positions: int, north: NDArray[Any], east: NDArray[Any], south: NDArray[Any], west: NDArray[Any]
) -> NDArray[np.int32]:
    """Indices of brick tiles from their edges, which must make a tile of the set.

    There are 2 (n - 1) tiles with the same N and E: one for each S other than N, with W = E, and where
    S = N one for each W other than E.
    """
    n = positions
    n_, e, s, w = (np.asarray(edge, np.int32) for edge in (north, east, south, west))
    rest = np.where(n_ == s, n_ + w - (w > e), np.where(s > n_, s + n - 2, s))
    return ((n_ * n + e) * (2 * n - 2) + rest).astype(np.int32)
