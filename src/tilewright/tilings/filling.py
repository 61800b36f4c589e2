"""Tile a rectangle or a torus with any set that can, by a SAT solver; or prove that it cannot."""

from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_int, check_progress, shape_error
from tilewright.errors import Progress, TilewrightValueError
from tilewright.seeds import check_seed
from tilewright.tiles import Shape, TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.clauses import Clauses, Literals, Truth, need_solver
from tilewright.tilings.tiling import ArrayTiling

Integers = NDArray[np.int64]
_MOST_VARIABLES = 2**25
_LONGEST = 4096


def filled_tiling(
    tiles: TileSet,
    width: int,
    height: int,
    *,
    torus: bool = False,
    fixed: ArrayLike | None = None,
    seed: int = 0,
    seconds: float | None = None,
    progress: Progress | None = None,
) -> ArrayTiling:
    """Tile a rectangle or a torus with any set of square tiles, by a SAT solver; or prove that it cannot.

    Unlike `scanline` this goes back where tiles placed before leave no tile for a cell. It is made for sets
    that can hardly tile, among them aperiodic ones; `aperiodic_tiling` has endless tilings by those known.

    Parameters
    ----------
    tiles : TileSet
        Wang tiles, corner tiles or corner-coded ones.
    width : int
        Cells along x, 1 to 4096; width, height and the number of tiles multiply to 2^25 at most.
    height : int
        Cells along y, 1 to 4096.
    torus : bool, optional
        Whether opposite sides must match too; default False.
    fixed : array-like of int, shape (height, width), optional
        Tiles that are given, -1 where a cell is free; by default all are free.
    seed : int, optional
        0 to 2^64 - 1; default 0. Different seeds find different tilings.
    seconds : float, optional
        After about this time, in seconds, give up, 0 to 10^9; by default never.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    ArrayTiling
        The rectangle, from cell (0, 0) on, or the torus.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        It is proven that there is no such tiling; or the tiles are not square, or a number is out of range.
    Undecided
        The time was up.

    Notes
    -----
    Our own, not from the papers; Lagae 2007, section 2.4, introduces the question.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiling = tw.filled_tiling(tw.aperiodic_tiles("jeandel-rao-11-5"), 8, 8, seed=1)
    >>> tiling.indices(0, 0, 8, 8).shape
    (8, 8)
    """
    check_square(tiles)
    seed = check_seed(seed)
    check_progress(progress)
    shape = (check_int("height", height, 1, _LONGEST), check_int("width", width, 1, _LONGEST))
    if width * height * len(tiles) > _MOST_VARIABLES:
        raise TilewrightValueError(
            f"{width} x {height} cells with {len(tiles)} tiles are too many for a solver; allowed are 2^25 "
            "choices of a tile for a cell"
        )
    given = None if fixed is None else _check_fixed(fixed, shape, len(tiles))
    need_solver()
    formula = Clauses()
    chosen = add_tiling(formula, tiles, shape, torus=torus)
    if given is not None:
        formula.add(chosen[given >= 0, given[given >= 0]][:, np.newaxis])
    values = formula.solve(seconds=seconds, seed=seed, progress=progress)
    if values is None:
        around = "torus" if torus else "rectangle"
        rest = "" if given is None else f" that keeps the {(given >= 0).sum()} fixed tiles"
        raise TilewrightValueError(
            f"the {tiles.name} set of {len(tiles)} tiles has no tiling of a {around} of {width} x {height} "
            f"cells{rest}; this is proven"
        )
    return ArrayTiling(tiles, read_tiling(values, chosen), torus=torus)


def check_square(tiles: TileSet) -> None:
    """Raise unless ``tiles`` is a set of square tiles."""
    if check_tiles("tiles", tiles).shape.dimension != 2:
        raise TilewrightValueError(
            f"must be square, not {tiles.shape.name} tiles",
            argument="tiles",
            value=tiles.shape.name,
            allowed="square",
        )


def _check_fixed(fixed: ArrayLike, shape: tuple[int, int], count: int) -> Integers:
    given = as_integers("fixed", fixed)
    if given.shape != shape:
        raise shape_error("fixed", given.shape, f"(height, width), {shape}")
    if given.min() < -1 or given.max() >= count:
        raise TilewrightValueError(
            f"runs from {given.min()} to {given.max()}; allowed are tiles 0 to {count - 1}, and -1",
            argument="fixed",
            allowed=f"tiles 0 to {count - 1}, and -1",
        )
    return given.astype(np.int64)


def add_tiling(formula: Clauses, tiles: TileSet, shape: tuple[int, int], *, torus: bool) -> Literals:
    """Add to a formula that the cells of a rectangle or torus, shape (height, width), are tiled.

    Returns
    -------
    int32 array, shape (height, width, T)
        The variables that say whether a cell has a tile; one of each cell is true.
    """
    places = _places(tiles.shape, shape, torus=torus)
    most = max(tiles.colors)
    chosen = formula.variables(*shape, len(tiles))
    color = formula.variables(int(places.max()) + 1, most)
    formula.add(chosen)
    formula.at_most_one(color)
    for slot, colors in enumerate(tiles.slots.T):
        here = color[places[..., slot]]
        # A tile has its colors. Tiles differ in some, so a cell has no two.
        formula.add(np.stack([-chosen, here[..., colors]], axis=-1).reshape(-1, 2))
        # Where a color is, one of the tiles that have it is. This follows, but the solver sees it sooner.
        for c in range(most):
            able = chosen[..., colors == c]
            formula.add(np.concatenate([-here[..., c, np.newaxis], able], axis=-1))
    return chosen


def read_tiling(values: Truth, chosen: Literals) -> Integers:
    """The tile of each cell, from the values of the variables of `add_tiling`."""
    return np.argmax(values[chosen], axis=-1)


def _places(shape: Shape, extent: tuple[int, int], *, torus: bool) -> Integers:
    """Numbers of the edges and corners that the slots of each cell lie on, shape (height, width, S)."""
    label = np.arange(extent[0] * extent[1] * len(shape.slots)).reshape(*extent, len(shape.slots))
    while True:
        before = label.copy()
        for (across, down), joint in zip(shape.steps, shape.joints, strict=True):
            rows, columns = _meeting(down, extent[0], torus=torus), _meeting(across, extent[1], torus=torus)
            for (y, to_y), (x, to_x), (far, near) in product(rows, columns, joint):
                a, b = label[y, x], label[to_y, to_x]
                a[..., far] = b[..., near] = np.minimum(a[..., far], b[..., near])
        if np.array_equal(label, before):
            return np.unique(label, return_inverse=True)[1].reshape(label.shape)


def _meeting(way: int, size: int, *, torus: bool) -> list[tuple[slice, slice]]:
    """Ranges of cells along an axis, and those that lie ``way`` cells on."""
    if not torus:
        return [(slice(max(0, -way), size - max(0, way)), slice(max(0, way), size - max(0, -way)))]
    way %= size
    return [(slice(0, size - way), slice(way, size)), (slice(size - way, size), slice(0, way))]
