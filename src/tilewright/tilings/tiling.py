"""Which tile goes where: what every tiling answers, and tilings that are stored."""

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tiles.variants import Variants, check_variants
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, MixerHash
from tilewright.tilings.placements import Placements, draw_rows

_MOST_TILES = 2**31


class Tiling(ABC):
    """A tile for every cell of a domain.

    Attributes
    ----------
    tiles : TileSet
    domain : Domain
    """

    tiles: TileSet
    domain: Domain
    _variant_hash: LatticeHash = MixerHash(0)

    def indices(self, *window: int, out: NDArray[np.int32] | None = None) -> NDArray[np.int32]:
        """Tile indices of a window of cells, equal to the same cells of any other window.

        Parameters
        ----------
        *window : int
            ``x, y, width, height`` for square tiles; ``x, width`` for dominoes; ``x, y, z, width, height,
            depth`` for cubes. Cells are within +-2^61.
        out : int32 array, shape (height, width), optional
            Filled and returned.

        Returns
        -------
        int32 array, shape (height, width); (width,) for dominoes, (depth, height, width) for cubes.
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
            raise TilewrightTypeError(f"out must be an int32 array, not {type(out).__name__}")
        elif out.shape != shape or out.dtype != np.int32 or not out.flags.writeable:
            kind = out.dtype if out.flags.writeable else f"read-only {out.dtype}"
            raise TilewrightValueError(f"out is {kind} {out.shape}; expected int32 {shape}")
        self._fill(tuple(int(s) for s in start), out)
        return out

    def placements(self, *window: int, variants: Variants | None = None) -> Placements:
        """Tile, variant and quarter turn of each cell of a window; no tiling turns tiles yet.

        Parameters
        ----------
        *window : int
            As in `indices`.
        variants : Variants, optional
            How many variants each tile has, and their weights; one of each by default. A variant is drawn by
            a hash at its cell (folded into the tiling's period): the tiling's own where it is `direct`, that
            of seed 0 elsewhere.

        Returns
        -------
        Placements
            Three arrays of the window's shape.
        """
        indices = self.indices(*window)
        chosen = np.zeros_like(indices)
        if variants is not None:
            chosen = (self.rows(*window, variants=variants) - variants.starts[indices]).astype(np.int32)
        return Placements(indices, chosen, np.zeros(indices.shape, np.int8))

    def rows(self, *window: int, variants: Variants) -> NDArray[np.int32]:
        """`placements` as one number a cell: the row that it shows of a signal with ``variants``."""
        check_variants(variants, self.tiles)
        indices = self.indices(*window)
        if len(variants) == len(self.tiles):
            return indices
        start = tuple(int(s) for s in window[: self.tiles.shape.dimension])
        return draw_rows(indices, variants, self._variant_hash, self.domain, start)

    @abstractmethod
    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        """Write the tiles of the window that starts at cell ``start`` into ``out``."""


class ArrayTiling(Tiling):
    """A stored tiling: a rectangle of cells from (0, 0) on, or a torus of them.

    Parameters
    ----------
    tiles : TileSet
    indices : array-like of int, shape (height, width); (width,) or (depth, height, width)
    torus : bool
        Whether the tiling goes on periodically in every direction.

    Raises
    ------
    TilewrightValueError
        An index out of range, or two neighboring tiles that do not match; the message names the first.
    """

    def __init__(self, tiles: TileSet, indices: ArrayLike, *, torus: bool = False) -> None:
        cells = as_integers("indices", indices)
        if cells.ndim != tiles.shape.dimension or cells.size == 0:
            raise TilewrightValueError(
                f"indices has shape {cells.shape}; {tiles.shape.name} tiles need "
                f"{tiles.shape.dimension} axes, none of them empty"
            )
        if cells.min() < 0 or cells.max() >= len(tiles):
            raise TilewrightValueError(
                f"indices runs from {cells.min()} to {cells.max()}; the set has tiles 0 to {len(tiles) - 1}"
            )
        self.tiles = tiles
        self.cells = cells.astype(np.int32)
        self.cells.setflags(write=False)
        extent = tuple(reversed(cells.shape))
        none = (None,) * cells.ndim
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


def first_mismatch(tiles: TileSet, cells: NDArray[Any], *, torus: bool) -> str | None:
    """What is wrong at the first cell, in the order of the array, that does not match a neighbor, or None."""
    slots = tiles.slots_of(cells)
    faults = []
    for axis, joint in enumerate(tiles.shape.joints):
        array_axis = cells.ndim - 1 - axis
        for far, near in joint:
            ours, theirs = slots[..., far], np.roll(slots[..., near], -1, array_axis)
            wrong = ours != theirs
            if not torus:
                wrong[(slice(None),) * array_axis + (-1,)] = False
            if wrong.any():
                at = np.unravel_index(int(np.argmax(wrong)), wrong.shape)
                names = f"{tiles.shape.slots[far]} is {ours[at]}, {tiles.shape.slots[near]} is {theirs[at]}"
                faults.append((at, axis, names))
    if not faults:
        return None
    at, axis, names = min(faults)
    cell = ", ".join(f"{'xyz'[n]}={c}" for n, c in enumerate(reversed(at)))
    return f"the tiles at cell {cell} and its neighbor along {'xyz'[axis]} do not match: {names}"


def array_tiling(tiles: TileSet, indices: ArrayLike, *, torus: bool = False) -> ArrayTiling:
    """A tiling from a given array of tile indices, checked; see `ArrayTiling`."""
    return ArrayTiling(check_tiles("tiles", tiles), indices, torus=torus)
