"""Recursive packings: the packing over C - 1 colors is the north-west part of the one over C.

Lagae & Dutré found one for 4 colors of corner tiles by backtracking (2006, section 6.2 and figure 9; Lagae
2007, figure 5.11), on a cluster. Here colors are redrawn by chance, a piece of a row or column at a time,
until no tile is missing.
"""

import time

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, check_progress, check_real, check_type
from tilewright.errors import Progress, TilewrightValueError
from tilewright.tiles import CORNER, WANG, TileSet, corner_tiles
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.clauses import Undecided
from tilewright.tilings.packings.closed_form import packing
from tilewright.tilings.packings.search import nest_slots
from tilewright.tilings.tiling import ArrayTiling, Tiling

Colors = NDArray[np.int64]

_NESTED = """
    0001021220031331 0010010220331313 1011122021111121 0111001120331313
    0001020200323201 2121210222033323 0011121110303013 2021222202223300
    0221212010303313 0001021220032022 3232323323023131 0221112202330103
    2333232303230313 2121013121200102 3231312130333331 3230330313100132
"""
"""Lattice points of a packing over 4 colors, row by row, that holds those over 3, 2 and 1 color."""
_MOST_NESTED = 4

_LONGEST = 10
"""Colors that are redrawn at once."""
_STRETCHES = 400
"""Between two of them the chance grows less tolerant and the callback is asked."""
_STRENGTHS = {2: (2.0, 5.0), 3: (2.5, 5.0)}
_LINES = {2: 40_000, 3: 2_000_000}
"""How the redrawing cools: from where to where, and in how many lines; for more colors, the last numbers."""
_COLD, _MANY = (3.4, 4.6), 800_000_000


def recursive_packing(tiles: TileSet) -> Tiling:
    """Pack a complete set so that the north-west part is the packing over a color less, and so on down.

    Parameters
    ----------
    tiles : TileSet
        A complete set of Wang tiles, or of corner tiles over up to 4 colors.

    Returns
    -------
    Tiling
        A torus of C_v^2 x C_h^2 cells; corner tiles have C_v = C_h.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set.
    TilewrightValueError
        The set is another one. Over 5 colors and more no recursive packing of corner tiles is known.

    Notes
    -----
    Wang tiles in closed form, because Wei's trains nest (Lagae 2007, section 5.5.2). Corner tiles from a
    table of our own; Lagae 2007, section 5.5.3 and figure 5.11, has another one.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.recursive_packing(tw.corner_tiles(3)).domain.periods
    (9, 9)
    """
    if check_tiles("tiles", tiles).is_complete and tiles.shape is WANG:
        return packing(tiles)
    if not tiles.is_complete or tiles.shape is not CORNER:
        raise TilewrightValueError(
            "recursive packings are for complete sets of corner tiles and Wang tiles, "
            f"not for the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles"
        )
    count = tiles.colors[0]
    if count > _MOST_NESTED:
        raise TilewrightValueError(
            f"the set has {count} colors; recursive packings of corner tiles are known for up to "
            f"{_MOST_NESTED}. Use packing(), which is not recursive"
        )
    rows = [[int(color) for color in row] for row in _NESTED.split()]
    return _tiling(tiles, np.array(rows)[: count**2, : count**2])


def extend_packing(
    smaller: Tiling, *, seed: int = 0, seconds: float | None = None, progress: Progress | None = None
) -> ArrayTiling:
    """Search for a packing of corner tiles over one color more, with a given one in its north-west corner.

    Every color of the new part is drawn anew, many times, in pieces of rows and columns: a heat bath in which
    missing tiles cost more and more, begun again until none is missing. It takes seconds from 2 colors to 3,
    many minutes from 3 to 4; beyond that no packing has been found.

    Parameters
    ----------
    smaller : Tiling
        A packing of the complete set of corner tiles over 1 to 15 colors.
    seed : int, optional
        0 to 2^63 - 1; default 0. Other seeds give other packings.
    seconds : float, optional
        After about this time, in seconds, give up, 0 to 10^9; by default never.
    progress : callable, optional
        Called as ``progress(done, total, what)`` between stretches; its last argument tells how many tiles
        are missing. Raise `Cancelled` from it to stop.

    Returns
    -------
    ArrayTiling
        A torus of (C + 1)^2 x (C + 1)^2 cells, where ``smaller`` has C colors.

    Raises
    ------
    TilewrightTypeError
        ``smaller`` is not a tiling, or another argument is of a wrong type.
    TilewrightValueError
        ``smaller`` is not a packing of corner tiles, or a number is out of range.
    Undecided
        The time was up.

    Notes
    -----
    Lagae 2007, section 5.5.3, and Lagae & Dutré 2006, section 6.2, found theirs by backtracking on a cluster.
    """
    check_type("smaller", smaller, Tiling, "a packing")
    if smaller.tiles.shape is not CORNER:
        raise TilewrightValueError(
            f"is of {smaller.tiles.shape.name} tiles; corner tiles are extended. For Wang tiles use "
            "recursive_packing()",
            argument="smaller",
        )
    check_progress(progress)
    if seconds is not None:
        check_real("seconds", seconds, 0, 1e9)
    rng = np.random.default_rng(check_int("seed", seed, 0, 2**63 - 1))
    tiles = corner_tiles(smaller.tiles.colors[0] + 1)
    given = _given(smaller, tiles)
    end = time.monotonic() + (np.inf if seconds is None else seconds)
    while True:
        colors = _anneal(given, tiles.colors[0], rng, end, progress)
        if colors is not None:
            return _tiling(tiles, colors)


def _given(smaller: Tiling, tiles: TileSet) -> Colors:
    """Lattice points that the smaller packing fixes; -1 elsewhere."""
    slots = nest_slots(smaller, tiles, "smaller")
    size, inner = tiles.colors[0] ** 2, len(slots)
    given = np.full((size, size), -1, np.int64)
    for slot, name in enumerate(CORNER.slots):
        south, east = "S" in name, "E" in name
        given[south : inner + south, east : inner + east] = slots[..., slot]
    return given


def _anneal(
    given: Colors, count: int, rng: np.random.Generator, end: float, progress: Progress | None
) -> Colors | None:
    """One run of the heat bath from chance colors to cold; None where tiles are missing at its end."""
    from tilewright.kernels.packing_search import redraw_lines

    free = given < 0
    colors = np.where(free, rng.integers(0, count, given.shape), given)
    used = np.bincount(_windows(colors, count).ravel(), minlength=count**4)
    state = np.array([(used == 0).sum(), 0])
    key = np.uint64(rng.integers(2**63))
    longest = min(_LONGEST, len(colors) - 1)
    lines = _LINES.get(count, _MANY) // _STRETCHES
    for strength in np.linspace(*_STRENGTHS.get(count, _COLD), _STRETCHES):
        redraw_lines(colors, ~free, np.flatnonzero(free), count, strength, lines, longest, key, used, state)
        if progress is not None:
            progress(count**4 - int(state[0]), count**4, f"{state[0]} tiles missing")
        if state[0] == 0:
            return colors
        if time.monotonic() > end:
            raise Undecided(f"no packing was found in time; {state[0]} tiles of {count**4} are missing")
    return None


def _windows(colors: Colors, count: int) -> Colors:
    """Number of the tile at each cell of a torus, its corners read as NW, NE, SW, SE."""
    upper = colors * count + np.roll(colors, -1, 1)
    return np.asarray(upper * count**2 + np.roll(upper, -1, 0))


def _tiling(tiles: TileSet, colors: Colors) -> ArrayTiling:
    """The torus of corner tiles whose lattice points have the given colors."""
    around = {name: np.roll(colors, (-("S" in name), -("E" in name)), (0, 1)) for name in tiles.shape.slots}
    return ArrayTiling(tiles, tiles.find(np.stack(list(around.values()), axis=-1)), torus=True)
