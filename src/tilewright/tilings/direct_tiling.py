"""Direct stochastic tiling: the tile of any cell, without the cells before it."""

from abc import abstractmethod
from math import prod

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice
from tilewright.errors import TilewrightValueError
from tilewright.seeds import check_seed
from tilewright.tiles import (
    CORNER,
    CORNER_CODED,
    CORNER_CUBE,
    DOMINO,
    WANG,
    WANG_CUBE,
    TileSet,
    column_corner_tiles,
    compact_corner_cubes,
    compact_wang_cubes,
    corner_tiles,
    crossed_wang_tiles,
    shifted_wang_tiles,
    summed_wang_tiles,
)
from tilewright.tiles.cubes import RuledTileSet
from tilewright.tiles.tileset import MOST_FAMILY_COLORS, check_tiles
from tilewright.tilings.algorithms import Lattice, Slots, evaluate
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, MixerHash, make_hash, split_row
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
        """Colors of every slot of a window of tiles, one array like the window for each slot."""

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
    """A tiling evaluated cell by cell from a hash; made by `direct`."""

    def __init__(self, tiles: TileSet, hash: LatticeHash, domain: Domain, algorithm: str) -> None:
        super().__init__(tiles, domain)
        self.hash = self._variant_hash = hash
        self.algorithm = algorithm

    def slots(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
        """Colors of every slot of a window of tiles, one array like the window for each slot."""
        return evaluate(self.algorithm, self._lattice(start, extent))

    def _lattice(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Lattice:
        return Lattice(self.tiles, self.hash, self.domain.periods, start, extent)

    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        bytes_do = max(self.tiles.colors) <= 256  # for a color, as kernels keep it
        if isinstance(self.hash, MixerHash) and self.tiles.shape in (CORNER, WANG) and bytes_do:
            at = self._lattice(start, tuple(reversed(out.shape)))
            if self.algorithm == "corners":
                return _fill_corners(self.hash, at, out)
            if self.algorithm == "edges":
                return _fill_edges(self.hash, at, out)
        return super()._fill(start, out)


def _fill_corners(hash: MixerHash, at: Lattice, out: NDArray[np.int32]) -> None:
    """`corners` and the tiles' indices in one pass."""
    from tilewright.kernels.lattice import fill_corner_ids

    fill_corner_ids(*split_row(at.points(0)), at.points(1), hash.seed, np.uint32(at.tiles.colors[0]), out)


def _fill_edges(hash: MixerHash, at: Lattice, out: NDArray[np.int32]) -> None:
    """`edges` and the tiles' indices in one pass."""
    from tilewright.kernels.lattice import fill_wang_ids

    c_h, c_v = (np.uint32(c) for c in at.tiles.colors[:2])
    between, lines = split_row(2 * at.cells(0) + 1), split_row(2 * at.points(0))
    fill_wang_ids(*between, *lines, 2 * at.points(1), 2 * at.cells(1) + 1, hash.seed, c_h, c_v, out)


def direct(
    tiles: TileSet,
    seed: int = 0,
    *,
    hash: LatticeHash | str = "mixer",
    period: tuple[int | None, ...] | None = None,
    wang: str = "edge-hash",
) -> DirectTiling:
    """A random tiling of the endless plane, evaluated anywhere.

    Parameters
    ----------
    tiles : TileSet
        Complete sets: corner tiles (Lagae & Dutré 2006, section 4.2, with y mirrored), Wang tiles, dominoes,
        corner cubes, Wang cubes, corner-coded sets. Compact sets: `corner_tiles` with ``choices``,
        `column_corner_tiles`, `summed_wang_tiles` (Lagae 2007, section 3.3.2.2), `shifted_wang_tiles`,
        `compact_corner_cubes`, `compact_wang_cubes` where C is a power of two, corner-coded sets over any of
        these Wang sets, Cohen's 8 tiles among them, and `crossed_wang_tiles`. Other sets have `scanline`.
    seed : int
        0 to 2^64 - 1; the tile of a cell depends on the cell and the seed only.
    hash : str or LatticeHash
        ``"mixer"`` (no period), ``"permutation"``, ``"long-period"``, or a hash object, which has its own
        seed.
    period : tuple of (int or None), x first, optional
        Cells after which the tiling repeats along each axis, 1 to 2^31, for cylinders and tori. Sums of
        corner colors (``"two-hashes"``, `summed_wang_tiles`) are bound by the ring they close, see
        ``docs/tilings.md``.
    wang : str
        For complete Wang sets: ``"edge-hash"`` (one hash at the edges; Lagae 2007, section 3.3.2.3) or
        ``"two-hashes"`` (sums of corner colors; section 3.3.2.1).

    Returns
    -------
    DirectTiling

    Raises
    ------
    TilewrightValueError
        No direct algorithm goes with the set, or a period closes the chains of a compact corner set after
        too few steps.
    """
    check_tiles("tiles", tiles)
    check_seed(seed)
    check_choice("wang", wang, ("edge-hash", "two-hashes"))
    algorithm = recognize(tiles)
    if algorithm is None:
        raise TilewrightValueError(
            f"no direct tiling is known for the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles; "
            "scanline() tiles a rectangle with it, array_tiling() takes a tiling of your own"
        )
    if wang == "two-hashes":
        if algorithm != "edges" or tiles.shape is not WANG:
            raise TilewrightValueError(
                f"wang is 'two-hashes', which is for complete Wang sets, not for the {tiles.name} set of "
                f"{len(tiles)} {tiles.shape.name} tiles"
            )
        algorithm = "two-hashes"
    d = tiles.shape.dimension
    tiling = DirectTiling(tiles, make_hash(hash, seed), Domain.plane(period, d), algorithm)
    if period is not None:
        tiling.slots((0,) * d, (1,) * d)  # refuses periods that close chains too soon or too late
    return tiling


def recognize(tiles: TileSet) -> str | None:
    """Name of the algorithm that goes with a set, told by its slots; None where there is none."""
    if tiles.shape is CORNER_CODED:
        return _recognize_coded(tiles)
    if tiles.is_complete:
        return {DOMINO: "ends", CORNER: "corners", CORNER_CUBE: "corners"}.get(tiles.shape, "edges")
    c = tiles.colors[0]
    if len(set(tiles.colors)) > 1 or not 2 <= c <= MOST_FAMILY_COLORS:
        return None
    if tiles.shape is CORNER:
        return _recognize_corners(tiles, c)
    power_of_two = c & (c - 1) == 0
    if tiles.shape is WANG and _same(tiles, summed_wang_tiles(c)):
        return "sums"
    if tiles.shape is WANG and power_of_two and _same(tiles, shifted_wang_tiles(c)):
        return "bits"
    if tiles.shape is WANG_CUBE and power_of_two and _same(tiles, compact_wang_cubes(c)):
        return "bits"
    if tiles.shape is CORNER_CUBE and _same(tiles, compact_corner_cubes(c)):
        return "diagonals"
    return None


def _recognize_corners(tiles: TileSet, c: int) -> str | None:
    choices, root = len(tiles) // c**3, round(len(tiles) ** 0.5)
    if 2 <= choices < c and _same(tiles, corner_tiles(c, choices)):
        return "diagonals"
    if root % c == 0 and 2 <= root // c < c and _same(tiles, column_corner_tiles(c, root // c)):
        return "columns"
    return None


def _recognize_coded(tiles: TileSet) -> str | None:
    """`crossed_wang_tiles`, and Wang sets with a direct algorithm in all combinations of marks."""
    if tiles.colors[0] <= 2 and _same(tiles, crossed_wang_tiles(tiles.colors[0])):
        return "crossings"
    base = TileSet(WANG, np.unique(tiles.slots[:, :4], axis=0), tiles.colors[:4])
    marks = set(tiles.colors[4:])
    if len(marks) > 1 or len(tiles) != len(base) * marks.pop() ** 4:
        return None
    algorithm = recognize(base)
    return f"marked-{algorithm}" if algorithm else None


def _same(a: TileSet, b: TileSet) -> bool:
    if len(a) != len(b) or a.colors != b.colors:
        return False
    if isinstance(a, RuledTileSet) and isinstance(b, RuledTileSet):
        return a.name == b.name
    return np.array_equal(np.sort(a.codes), np.sort(b.codes))
