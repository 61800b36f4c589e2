"""Corner tiles of a lattice whose points have classes."""

import numpy as np

from tilewright.checks import check_int
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.recognition import class_step
from tilewright.tiles.shape import CORNER
from tilewright.tiles.tileset import MOST_FAMILY_COLORS, TileSet, check_colors, decode


def classed_corner_tiles(colors: int = 2, classes: int = 5) -> TileSet:
    """Make the corner tiles of a lattice whose points have classes, so that equal tiles never meet.

    The lattice point (x, y) is of the class (x + a y) mod k, and each class has C colors of its own. A tile
    is told by the class of its NW corner and the four colors; it comes again only where that class does, and
    k classes make a corner's content as rare as k times as many colors would. The step a is the one that
    keeps lattice points of one class farthest apart: 2 of 5 classes, whose points lie a knight's move from
    each other.

    Parameters
    ----------
    colors : int, optional
        Number of colors C of each class, 1 to 16; default 2.
    classes : int, optional
        Number of classes k, 2 to 16; default 5. With 2 they make a checkerboard.

    Returns
    -------
    TileSet
        k C^4 tiles, slots NE, SE, SW, NW; color c of class q is q C + c.

    Raises
    ------
    TilewrightTypeError
        A number is not an integer.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    This set is not from a paper. Tiles are numbered by class first, in each class like complete sets.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiles = tw.classed_corner_tiles(2)
    >>> tiles
    <TileSet classed-5: 80 corner tiles, colors (10, 10, 10, 10)>
    >>> tiles.slots[16]
    array([4, 8, 6, 2], dtype=uint8)
    """
    c, k = check_colors(colors), check_int("classes", classes, 2, MOST_FAMILY_COLORS)
    step = class_step(k)
    own = decode(np.arange(c**4), (c,) * 4).astype(np.int64)
    # Classes of NE, SE, SW, NW in tiles of class q.
    ahead = (np.arange(k)[:, np.newaxis] + (1, 1 + step, step, 0)) % k
    slots = own + ahead[:, np.newaxis] * c
    return ListedTileSet(CORNER, slots.reshape(-1, 4), (k * c,) * 4, f"classed-{k}")


def are_by_class(tiles: TileSet) -> bool:
    """Whether tiles of a classed set are numbered as `classed_corner_tiles` numbers them."""
    made = classed_corner_tiles(tiles.parameters["colors"], tiles.parameters["classes"])
    return bool((tiles.slots == made.slots).all())
