"""A random tiling of any set: direct where that is known, by scanline where it is not."""

from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.algorithms import recognize
from tilewright.tilings.direct_tiling import direct
from tilewright.tilings.scanline_tiling import scanline
from tilewright.tilings.tiling import Tiling


def stochastic(tiles: TileSet, width: int, height: int = 1, seed: int = 0) -> Tiling:
    """Make a random tiling of any set: direct and endless where that is known, by scanline elsewhere.

    Parameters
    ----------
    tiles : TileSet
        Square tiles or dominoes.
    width : int
        Cells along x, from 0 on, that a scanline tiling must cover, 1 to 65,536.
    height : int, optional
        Cells along y, from 0 on, that a scanline tiling must cover, 1 to 65,536; default 1.
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.

    Returns
    -------
    Tiling
        What `direct` makes of the set, or `scanline`.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        What `scanline` refuses.

    Notes
    -----
    Lagae 2007, section 3.2.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.stochastic(tw.corner_tiles(2), 8, 8).domain.kind
    'plane'
    >>> tw.stochastic(tw.compact_wang_tiles(3), 8, 8).domain.kind
    'rectangle'
    """
    known = recognize(check_tiles("tiles", tiles)) is not None
    return direct(tiles, seed) if known else scanline(tiles, width, height, seed)
