"""Direct stochastic tiling: the tile of any cell, without the cells before it."""

from abc import abstractmethod
from functools import cached_property
from math import prod

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice
from tilewright.errors import TilewrightValueError
from tilewright.seeds import Seed, check_seed
from tilewright.tiles import CORNER, WANG, TileSet
from tilewright.tiles.classes import are_by_class
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.algorithms import (
    CLASSED,
    CORNERS,
    EDGES,
    TWO_HASHES,
    Algorithm,
    Lattice,
    Slots,
    column_classes,
    recognize,
    row_classes,
)
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, MixerHash, split_row
from tilewright.tilings.table_hashes import make_hash
from tilewright.tilings.tiling import Tiling

_LARGEST_TABLE = 2**20


class SlotTiling(Tiling):
    """A tiling that is known by the colors of its slots."""

    def __init__(self, tiles: TileSet, domain: Domain) -> None:
        self.tiles = tiles
        self.domain = domain
        self._index_of_code: NDArray[np.int32] | None = None
        if not tiles.is_complete and prod(tiles.colors) <= _LARGEST_TABLE:
            self._index_of_code = np.full(prod(tiles.colors), -1, np.int32)
            self._index_of_code[tiles.codes] = np.arange(len(tiles))

    @abstractmethod
    def slots(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
        """Give the colors of every slot of a window of tiles.

        Parameters
        ----------
        start : tuple of int
            The first cell, x first.
        extent : tuple of int
            Number of cells along each axis, x first.

        Returns
        -------
        tuple of uint8 or uint16 array
            An array like the window, its last axis along x, for each slot.
        """

    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        slots = self.slots(start, tuple(reversed(out.shape)))
        if not self.tiles.is_complete and self._index_of_code is None:
            out[...] = self.tiles.find(np.stack(slots, axis=-1))
            return
        # Eq. 2.2 and 2.5 of Lagae 2007, for any number of slots.
        np.copyto(out, slots[0])
        for slot, radix in zip(slots[1:], self.tiles.colors[1:], strict=True):
            out *= radix
            out += slot
        if self._index_of_code is not None:
            out[...] = self._index_of_code[out]


class DirectTiling(SlotTiling):
    """A tiling evaluated cell by cell from a hash; made by `direct`.

    Parameters
    ----------
    tiles : TileSet
        The tiles.
    hash : LatticeHash
        Where chance comes from.
    domain : Domain
        The plane, a cylinder or a torus.
    algorithm : Algorithm
        The algorithm that goes with the tiles, found by their family.

    Notes
    -----
    Lagae 2007, section 3.3; Lagae & Dutré 2006, section 4.2.
    """

    def __init__(self, tiles: TileSet, hash: LatticeHash, domain: Domain, algorithm: Algorithm) -> None:
        super().__init__(tiles, domain)
        self.hash = self.chance = hash
        self.algorithm = algorithm

    def slots(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
        """Give the colors of every slot of a window of tiles, one array like the window for each slot."""
        return self.algorithm.slots(self._lattice(start, extent))

    @cached_property
    def _in_order(self) -> bool:
        """Whether tiles are numbered by class first, as their maker numbers them."""
        return are_by_class(self.tiles)

    def _lattice(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Lattice:
        return Lattice(self.tiles, self.hash, self.domain.periods, start, extent)

    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        bytes_do = max(self.tiles.colors) <= 256  # for a color, as kernels keep it
        if isinstance(self.hash, MixerHash) and self.tiles.shape in (CORNER, WANG) and bytes_do:
            at = self._lattice(start, tuple(reversed(out.shape)))
            if self.algorithm is CORNERS:
                return _fill_corners(self.hash, at, out)
            if self.algorithm is EDGES:
                return _fill_edges(self.hash, at, out)
            if self.algorithm is CLASSED and self._in_order:
                return _fill_classed(self.hash, at, out)
        return super()._fill(start, out)


def _fill_corners(hash: MixerHash, at: Lattice, out: NDArray[np.int32]) -> None:
    """`corners` and the tiles' indices in one pass."""
    from tilewright.kernels.lattice import fill_corner_ids

    columns, count = split_row(at.points(0)), np.uint32(at.tiles.colors[0])
    fill_corner_ids(len(out), *columns, at.points(1), hash.seed, count, out)


def _fill_classed(hash: MixerHash, at: Lattice, out: NDArray[np.int32]) -> None:
    """`classed` and the tiles' indices in one pass."""
    from tilewright.kernels.lattice import fill_classed_ids

    columns, rows = (c[:-1].astype(np.int32) for c in (column_classes(at), row_classes(at)))
    count, classes = np.uint32(at.tiles.parameters["colors"]), at.tiles.parameters["classes"]
    points = split_row(at.points(0))
    given = (hash.seed, count, columns, rows, np.int32(classes))
    fill_classed_ids(len(out), *points, at.points(1), *given, out)


def _fill_edges(hash: MixerHash, at: Lattice, out: NDArray[np.int32]) -> None:
    """`edges` and the tiles' indices in one pass."""
    from tilewright.kernels.lattice import fill_wang_ids

    c_h, c_v = (np.uint32(c) for c in at.tiles.colors[:2])
    between, lines = split_row(2 * at.cells(0) + 1), split_row(2 * at.points(0))
    rows = (2 * at.points(1), 2 * at.cells(1) + 1)
    fill_wang_ids(len(out), *between, *lines, *rows, hash.seed, c_h, c_v, out)


def direct(
    tiles: TileSet,
    seed: Seed = 0,
    *,
    hash: LatticeHash | str = "mixer",
    period: tuple[int | None, ...] | None = None,
    wang: str = "edge-hash",
) -> DirectTiling:
    """Make a random tiling of the endless plane, evaluated anywhere.

    Parameters
    ----------
    tiles : TileSet
        Complete sets: corner tiles, Wang tiles, dominoes, corner cubes, Wang cubes, corner-coded sets,
        `free_tiles`.
        Compact sets: `corner_tiles` with ``choices``, `column_corner_tiles`, `summed_wang_tiles`,
        `shifted_wang_tiles`, `compact_corner_cubes`, `compact_wang_cubes` where C is a power of two,
        corner-coded sets over any of these Wang sets, Cohen's 8 tiles among them, and `crossed_wang_tiles`.
        `scanline` takes other sets.
    seed : int or numpy.random.Generator, optional
        0 to 2^64 - 1; default 0. The tile of a cell depends on the cell and the seed only.
    hash : str or LatticeHash, optional
        ``"mixer"``, the default, which has no period; ``"permutation"``; ``"long-period"``; or a hash object,
        which has its own seed.
    period : tuple of (int or None), optional
        Cells after which the tiling repeats along each axis, x first, 1 to 2^31, for cylinders and tori; by
        default it does not. Sums of corner colors (``"two-hashes"``, `summed_wang_tiles`) are bound by the
        ring they close, see ``docs/tilings.md``.
    wang : str, optional
        For complete Wang sets: ``"edge-hash"``, the default (one hash at the edges; Lagae 2007, section
        3.3.2.3), or ``"two-hashes"`` (sums of corner colors; section 3.3.2.1).

    Returns
    -------
    DirectTiling
        The tiling of the plane, a cylinder or a torus.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        No direct algorithm goes with the set, a period closes the chains of a compact corner set after too
        few steps, there is no such hash, or a number is out of range.

    Notes
    -----
    Lagae & Dutré 2006, section 4.2; Lagae 2007, section 3.3. Both let y grow up; here it grows south. Compact
    corner sets are our own answer to the question of section 3.5, see ``docs/compact-direct.md``.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiling = tw.direct(tw.corner_tiles(2), seed=7)
    >>> window = tiling.indices(-1, 10**15, 4, 2)
    >>> window.shape, window.dtype
    ((2, 4), dtype('int32'))
    >>> (tiling.indices(0, 10**15, 1, 1) == window[0, 1]).item()
    True
    """
    check_tiles("tiles", tiles)
    seed = check_seed(seed)
    check_choice("wang", wang, ("edge-hash", "two-hashes"))
    algorithm = recognize(tiles)
    if algorithm is None:
        raise TilewrightValueError(
            f"no direct tiling is known for the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles",
            advice="scanline() tiles a rectangle with it, array_tiling() takes a tiling of your own",
        )
    if wang == "two-hashes":
        if tiles.family != "wang":
            raise TilewrightValueError(
                f"is 'two-hashes', which is for complete Wang sets, not for the {tiles.name} set of "
                f"{len(tiles)} {tiles.shape.name} tiles",
                argument="wang",
            )
        algorithm = TWO_HASHES
    d = tiles.shape.dimension
    tiling = DirectTiling(tiles, make_hash(hash, seed), Domain.plane(period, d), algorithm)
    if period is not None:
        tiling.slots((0,) * d, (1,) * d)  # refuses periods that close chains too soon or too late
    return tiling
