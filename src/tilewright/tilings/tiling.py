"""Which tile goes where: what every tiling answers, and tilings that are stored."""

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_flag
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.showing import Shown, describe
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tiles.variants import Variants, check_variants
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, MixerHash
from tilewright.tilings.placements import Placements, draw_rows

_MOST_TILES = 2**31


class Tiling(Shown, ABC):
    """A tile for every cell of a domain: what every tiling answers.

    Attributes
    ----------
    tiles : TileSet
        The tiles it is made of.
    domain : Domain
        The cells that have a tile.
    chance : LatticeHash
        Where variants of tiles and the tone over them are drawn from: the tiling's own hash where it is
        `direct`, that of seed 0 elsewhere.
    """

    tiles: TileSet
    domain: Domain
    chance: LatticeHash = MixerHash(0)

    def __repr__(self) -> str:
        return describe(self, repr(self.tiles), str(self.domain))

    def indices(self, *window: int, out: NDArray[np.int32] | None = None) -> NDArray[np.int32]:
        """Give the tile indices of a window of cells, equal to the same cells of any other window.

        Parameters
        ----------
        *window : int
            ``x, y, width, height`` for square tiles; ``x, width`` for dominoes; ``x, y, z, width, height,
            depth`` for cubes. Cells are within +-2^61; a window has 2^31 of them at most.
        out : int32 array, shape (height, width), optional
            Filled and returned; by default a new array.

        Returns
        -------
        int32 array, shape (height, width)
            Indices into ``tiles``; the shape is (width,) for dominoes and (depth, height, width) for cubes.

        Raises
        ------
        TilewrightTypeError
            A wrong number of arguments, one that is not an integer, or an ``out`` that is not an array.
        TilewrightValueError
            The window is too large or not in the domain, ``out`` is of another shape or type, or the set has
            more than 2^31 tiles.
        """
        dimension = self.tiles.shape.dimension
        if len(window) != 2 * dimension:
            raise TilewrightTypeError(
                f"indices() of {self.tiles.shape.name} tiles takes {2 * dimension} numbers: "
                f"{', '.join('xyz'[:dimension])} and {', '.join(('width', 'height', 'depth')[:dimension])}"
            )
        start, extent = window[:dimension], window[dimension:]
        self.domain.check_window(start, extent)
        shape = tuple(int(e) for e in reversed(extent))
        if len(self.tiles) > _MOST_TILES:
            raise TilewrightValueError(
                f"the {self.tiles.name} set has {len(self.tiles)} tiles; tile indices are int32, at most 2^31"
            )
        if out is None:
            out = np.empty(shape, np.int32)
        elif not isinstance(out, np.ndarray):
            raise TilewrightTypeError(
                f"must be an int32 array, not {type(out).__name__}",
                argument="out",
                value=out,
                allowed="an int32 array",
            )
        elif out.shape != shape or out.dtype != np.int32 or not out.flags.writeable:
            kind = out.dtype if out.flags.writeable else f"read-only {out.dtype}"
            raise TilewrightValueError(
                f"is {kind} {out.shape}; expected int32 {shape}", argument="out", allowed=f"int32 {shape}"
            )
        self._fill(tuple(int(s) for s in start), out)
        return out

    def placements(self, *window: int, variants: Variants | None = None) -> Placements:
        """Give tile, variant and quarter turn of each cell of a window; no tiling turns tiles yet.

        Parameters
        ----------
        *window : int
            As in `Tiling.indices`.
        variants : Variants, optional
            How many variants each tile has, and their weights; one of each by default. A variant is drawn by
            a hash at its cell (folded into the tiling's period): the tiling's own where it is `direct`, that
            of seed 0 elsewhere.

        Returns
        -------
        Placements
            Three arrays of the window's shape.

        Raises
        ------
        TilewrightTypeError
            Variants of another type, or a window as `Tiling.indices` refuses it.
        TilewrightValueError
            Variants of another number of tiles, or a window as `Tiling.indices` refuses it.
        """
        indices = self.indices(*window)
        chosen = np.zeros_like(indices)
        if variants is not None:
            chosen = (self.rows(*window, variants=variants) - variants.starts[indices]).astype(np.int32)
        return Placements(indices, chosen, np.zeros(indices.shape, np.int8))

    def rows(self, *window: int, variants: Variants) -> NDArray[np.int32]:
        """Give `Tiling.placements` as one number a cell: the row of a signal that it shows.

        Parameters
        ----------
        *window : int
            As in `Tiling.indices`.
        variants : Variants
            Those of the signal, as in its attribute ``variants``.

        Returns
        -------
        int32 array, shape (height, width)
            Rows of the signal; where every tile has one variant, the tiles.

        Raises
        ------
        TilewrightTypeError
            Variants of another type, or a window as `Tiling.indices` refuses it.
        TilewrightValueError
            Variants of another number of tiles, or a window as `Tiling.indices` refuses it.
        """
        check_variants(variants, self.tiles)
        indices = self.indices(*window)
        if len(variants) == len(self.tiles):
            return indices
        start = tuple(int(s) for s in window[: self.tiles.shape.dimension])
        return draw_rows(indices, variants, self.chance, self.domain, start)

    @abstractmethod
    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        """Write the tiles of the window that starts at cell ``start`` into ``out``."""


class ArrayTiling(Tiling):
    """A stored tiling: a rectangle of cells from (0, 0) on, or a torus of them.

    Parameters
    ----------
    tiles : TileSet
        The tiles.
    indices : array-like of int, shape (height, width)
        The tile of each cell; shape (width,) for dominoes, (depth, height, width) for cubes.
    torus : bool, optional
        Whether the tiling goes on periodically in every direction; default False.

    Attributes
    ----------
    cells : int32 array
        The tile of each cell, read-only.

    Raises
    ------
    TilewrightTypeError
        The indices are not integers.
    TilewrightValueError
        An index is out of range, the array has a wrong number of axes, or two neighboring tiles do not match;
        the message names the first.
    """

    def __init__(self, tiles: TileSet, indices: ArrayLike, *, torus: bool = False) -> None:
        cells = as_integers("indices", indices)
        if cells.ndim != tiles.shape.dimension or cells.size == 0:
            raise TilewrightValueError(
                f"has shape {cells.shape}; {tiles.shape.name} tiles need {tiles.shape.dimension} axes, "
                "none of them empty",
                argument="indices",
                value=cells.shape,
            )
        if cells.min() < 0 or cells.max() >= len(tiles):
            raise TilewrightValueError(
                f"runs from {cells.min()} to {cells.max()}; the set has tiles 0 to {len(tiles) - 1}",
                argument="indices",
            )
        self.tiles = tiles
        self.cells = cells.astype(np.int32)
        self.cells.setflags(write=False)
        extent = tuple(reversed(cells.shape))
        none = (None,) * cells.ndim
        check_flag("torus", torus)
        self.domain = Domain(extent, none) if torus else Domain(none, tuple((0, n) for n in extent))
        fault = first_mismatch(tiles, self.cells, torus=torus)
        if fault is not None:
            raise TilewrightValueError(fault)

    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        axes = [
            self.domain.wrap(a, first, n)
            for a, (first, n) in enumerate(zip(start, reversed(out.shape), strict=True))
        ]
        out[...] = self.cells[np.ix_(*reversed(axes))]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.cells, dtype, copy=copy)


def first_mismatch(tiles: TileSet, cells: NDArray[Any], *, torus: bool) -> str | None:
    """Tell what is wrong at the first cell that does not match a neighbor.

    Parameters
    ----------
    tiles : TileSet
        The tiles.
    cells : int array, shape (height, width)
        The tile of each cell; shape (width,) for dominoes, (depth, height, width) for cubes.
    torus : bool
        Whether opposite sides meet.

    Returns
    -------
    str or None
        A sentence about the first such cell, in the order of the array; None where all match.
    """
    slots = tiles.slots_of(cells)
    faults = []
    for number, joint in enumerate(tiles.shape.joints):
        step = tiles.shape.steps[number][::-1]
        for far, near in joint:
            ours = slots[..., far]
            theirs = np.roll(slots[..., near], [-way for way in step], range(cells.ndim))
            wrong = ours != theirs
            if not torus:
                _leave_out_borders(wrong, step)
            if wrong.any():
                at = np.unravel_index(int(np.argmax(wrong)), wrong.shape)
                names = f"{tiles.shape.slots[far]} is {ours[at]}, {tiles.shape.slots[near]} is {theirs[at]}"
                faults.append((at, number, names))
    if not faults:
        return None
    at, number, names = min(faults)
    cell = ", ".join(f"{'xyz'[n]}={c}" for n, c in enumerate(reversed(at)))
    step = tiles.shape.steps[number]
    to = f"along {'xyz'[step.index(1)]}" if np.abs(step).sum() == sum(step) == 1 else f"{step} away"
    return f"the tiles at cell {cell} and its neighbor {to} do not match: {names}"


def _leave_out_borders(wrong: NDArray[np.bool_], step: tuple[int, ...]) -> None:
    """No fault where a step, in the array's order of axes, leads out of the array."""
    for axis, way in enumerate(step):
        if way:
            beyond = slice(-way, None) if way > 0 else slice(0, -way)
            wrong[(slice(None),) * axis + (beyond,)] = False


def array_tiling(tiles: TileSet, indices: ArrayLike, *, torus: bool = False) -> ArrayTiling:
    """Make a tiling from a given array of tile indices, checked.

    Parameters
    ----------
    tiles : TileSet
        The tiles.
    indices : array-like of int, shape (height, width)
        The tile of each cell; shape (width,) for dominoes, (depth, height, width) for cubes.
    torus : bool, optional
        Whether the tiling goes on periodically in every direction; default False.

    Returns
    -------
    ArrayTiling
        The tiling, from cell (0, 0) on.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set, or indices that are not integers.
    TilewrightValueError
        An index is out of range, the array has a wrong number of axes, or two neighboring tiles do not match;
        the message names the first.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiling = tw.array_tiling(tw.wang_tiles(2), [[0, 1], [4, 4]])  # doctest: +ELLIPSIS
    Traceback (most recent call last):
        ...
    tilewright.errors.TilewrightValueError: the tiles at cell x=0, y=0 ... do not match: E is 0, W is 1
    >>> tw.array_tiling(tw.wang_tiles(2), [[0, 0], [0, 0]], torus=True).indices(-1, 5, 2, 1)
    array([[0, 0]], dtype=int32)
    """
    return ArrayTiling(check_tiles("tiles", tiles), indices, torus=torus)
