"""A random tiling of any set: direct where that is known, by scanline where it is not."""

from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.algorithms import recognize
from tilewright.tilings.direct_tiling import direct
from tilewright.tilings.scanline_tiling import scanline
from tilewright.tilings.tiling import Tiling


def stochastic(tiles: TileSet, width: int, height: int = 1, seed: int = 0) -> Tiling:
    """The `direct` tiling of a set that has one, which is endless; else a `scanline` tiling.

    Parameters
    ----------
    tiles : TileSet
        Square tiles or dominoes.
    width, height : int
        Cells from (0, 0) on that a scanline tiling must cover.
    seed : int
        0 to 2^64 - 1.

    Raises
    ------
    TilewrightValueError
        As `scanline` does.
    """
    known = recognize(check_tiles("tiles", tiles)) is not None
    return direct(tiles, seed) if known else scanline(tiles, width, height, seed)
