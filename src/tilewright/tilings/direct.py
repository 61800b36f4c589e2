"""Direct stochastic tiling: the tile of any cell, without the cells before it.

Hash functions color the integer lattice; a tile follows from the colors around its cell. Each algorithm
below fills the slots of a window of tiles; `direct` finds the one that goes with a set.
"""

from collections.abc import Callable
from math import gcd

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, check_choice, check_int
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
    corner_tiles,
    encode,
    shifted_wang_tiles,
    summed_wang_tiles,
)
from tilewright.tilings.chains import Chains
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, make_hash
from tilewright.tilings.tiling import Tiling

Colors = NDArray[np.uint8]
Slots = tuple[Colors, ...]
Place = Callable[[NDArray[np.int64], NDArray[np.int64]], tuple[NDArray[np.int64], NDArray[np.int64]]]
_FIRST, _SECOND, _MARKS, _BITS = 0, 1, 4, 5
"""Streams of the hash; 2 and 3 belong to chains."""


class DirectTiling(Tiling):
    """A tiling evaluated cell by cell from a hash; made by `direct`."""

    def __init__(self, tiles: TileSet, hash: LatticeHash, domain: Domain, algorithm: str) -> None:
        self.tiles = tiles
        self.hash = hash
        self.domain = domain
        self.algorithm = algorithm
        self._index = None if tiles.is_complete else _index_by_code(tiles)

    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        extent = tuple(reversed(out.shape))
        if type(self) is DirectTiling and self.algorithm in ("corners", "edges") and out.ndim == 2:
            self._fill_complete(start, extent, out)
            return
        codes = encode(np.stack(self.slots(start, extent), axis=-1), self.tiles.colors)
        out[...] = codes if self._index is None else self._index(codes)

    def slots(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
        """Colors of every slot of a window of tiles, one array like the window for each slot."""
        return ALGORITHMS[self.algorithm](self, start, extent)

    def _fill_complete(self, start: tuple[int, ...], extent: tuple[int, ...], out: NDArray[np.int32]) -> None:
        """The two common cases, without an array for each slot."""
        from tilewright.kernels.lattice import fill_corner_ids, fill_wang_ids

        if self.algorithm == "corners":
            fill_corner_ids(corner_colors(self, start, extent), self.tiles.colors[0], out)
        else:
            horizontal, vertical = edge_colors(self, start, extent)
            fill_wang_ids(horizontal, vertical, self.tiles.colors[0], self.tiles.colors[1], out)


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
        Complete sets: corner tiles (Lagae & Dutré 2006, section 4.2), Wang tiles, dominoes, corner cubes,
        Wang cubes, complete corner-coded sets. Compact sets: `corner_tiles` with ``choices``,
        `column_corner_tiles`, `summed_wang_tiles` (Lagae 2007, section 3.3.2.2), `shifted_wang_tiles`,
        `compact_corner_cubes`, and corner-coded sets over Cohen's 8 tiles.
    seed : int
        0 to 2^64 - 1; the tile of a cell depends on the cell and the seed only.
    hash : str or LatticeHash
        ``"mixer"`` (no period), ``"permutation"``, ``"long-period"``, or a hash object, which has its own
        seed.
    period : tuple of (int or None), x first, optional
        Cells after which the tiling repeats along each axis, for cylinders and tori.
    wang : str
        For complete Wang sets: ``"edge-hash"`` (one hash at the edges; Lagae 2007, section 3.3.2.3) or
        ``"two-hashes"`` (sums of corner colors; section 3.3.2.1).

    Returns
    -------
    DirectTiling

    Raises
    ------
    TilewrightValueError
        No direct algorithm goes with the set (`scanline` tiles a rectangle with it), or a period is too
        short for it.
    """
    check_int("seed", seed, 0, 2**64 - 1)
    check_choice("wang", wang, ("edge-hash", "two-hashes"))
    algorithm = recognize(tiles)
    if algorithm is None:
        raise TilewrightValueError(
            f"no direct tiling is known for the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles; "
            "scanline() tiles a rectangle with it, array_tiling() takes a tiling of your own"
        )
    if algorithm == "edges" and wang == "two-hashes":
        algorithm = "two-hashes"
    tiling = DirectTiling(
        tiles, make_hash(hash, seed), Domain.plane(period, tiles.shape.dimension), algorithm
    )
    if algorithm in ("diagonals", "columns", "space-diagonals"):
        _chains(tiling)  # refuses periods that are too short
    return tiling


def recognize(tiles: TileSet) -> str | None:
    """Name of the algorithm that goes with a set, told by its slots; None where there is none."""
    if tiles.is_complete and tiles.shape in (CORNER, CORNER_CUBE):
        return "corners"
    if tiles.is_complete and tiles.shape in (WANG, WANG_CUBE):
        return "edges"
    if tiles.is_complete and tiles.shape is DOMINO:
        return "ends"
    c = tiles.colors[0]
    if len(set(tiles.colors)) == 1 and 2 <= c <= 16:
        if tiles.shape is CORNER:
            choices = len(tiles) // c**3
            if 2 <= choices < c and _same(tiles, corner_tiles(c, choices)):
                return "diagonals"
            root = round(len(tiles) ** 0.5)
            if root % c == 0 and 2 <= root // c < c and _same(tiles, column_corner_tiles(c, root // c)):
                return "columns"
        if tiles.shape is WANG:
            if _same(tiles, summed_wang_tiles(c)):
                return "sums"
            if c & (c - 1) == 0 and _same(tiles, shifted_wang_tiles(c)):
                return "bits"
        if tiles.shape is CORNER_CUBE and c <= 4 and _same(tiles, compact_corner_cubes(c)):
            return "space-diagonals"
    if tiles.shape is CORNER_CODED:
        return _recognize_coded(tiles)
    return None


def _recognize_coded(tiles: TileSet) -> str | None:
    """Corner-coded sets: all marks on a complete set, or on the C^3 set."""
    if tiles.is_complete:
        return "marked-edges"
    c = tiles.colors[0]
    base = TileSet(WANG, np.unique(tiles.slots[:, :4], axis=0), tiles.colors[:4])
    whole = len(tiles) == 16 * len(base) and set(tiles.colors[4:]) == {2}
    if whole and len(set(tiles.colors[:4])) == 1 and _same(base, summed_wang_tiles(c)):
        return "marked-sums"
    return None


def _same(a: TileSet, b: TileSet) -> bool:
    return len(a) == len(b) and a.colors == b.colors and np.array_equal(np.sort(a.codes), np.sort(b.codes))


def _index_by_code(tiles: TileSet) -> Callable[[NDArray[np.int64]], NDArray[np.int64]]:
    codes = tiles.codes
    order = np.argsort(codes)
    ranked = codes[order]
    return lambda asked: order[np.searchsorted(ranked, asked)]


# --- The algorithms: from a window of cells to the colors of each slot ---------------------------------


def corner_colors(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Colors:
    """Colors of the lattice points around a window, one more than cells along each axis."""
    axes = [tiling.domain.wrap(a, s, n + 1) for a, (s, n) in enumerate(zip(start, extent, strict=True))]
    count = tiling.tiles.colors[-1] if tiling.tiles.shape is CORNER_CODED else tiling.tiles.colors[0]
    stream = _MARKS if tiling.tiles.shape is CORNER_CODED else _FIRST
    if len(axes) == 3:
        x, y, z = axes
        return np.stack([tiling.hash.grid(count, stream, x, y, int(layer)) for layer in z])
    return tiling.hash.grid(count, stream, axes[0], axes[1])


def _corners_to_slots(c: Colors) -> Slots:
    """NE, SE, SW, NW of square tiles; the same of the upper and the lower face of cubes."""
    if c.ndim == 3:
        return tuple(slot for face in (c[:-1], c[1:]) for slot in _face(face))
    return _face(c)


def _face(c: Colors) -> Slots:
    return c[..., :-1, 1:], c[..., 1:, 1:], c[..., 1:, :-1], c[..., :-1, :-1]


def corners(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Complete corner sets: a hash at the lattice points (Lagae 2007, section 3.3.1)."""
    return _corners_to_slots(corner_colors(tiling, start, extent))


def edge_colors(
    tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]
) -> tuple[Colors, Colors]:
    """Colors of the horizontal and the vertical edges around a window of square tiles.

    One hash on a lattice twice as dense: edges lie where exactly one coordinate is odd (Lagae 2007,
    section 3.3.2.3, with y south).
    """
    (x, y), (w, h) = start, extent
    c_h, c_v = tiling.tiles.colors[:2]
    columns, rows = 2 * tiling.domain.wrap(0, x, w + 1), 2 * tiling.domain.wrap(1, y, h + 1)
    return (
        tiling.hash.grid(c_h, _FIRST, columns[:-1] + 1, rows),
        tiling.hash.grid(c_v, _FIRST, columns, rows[:-1] + 1),
    )


def edges(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Complete Wang sets with one hash at the edges; Wang cubes with one at the faces."""
    if len(start) == 3:
        return _faces(tiling, start, extent)
    horizontal, vertical = edge_colors(tiling, start, extent)
    return horizontal[:-1], vertical[:, 1:], horizontal[1:], vertical[:, :-1]


def _faces(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Faces of cubes lie on the doubled lattice where exactly one coordinate is even."""
    x, y, z = (
        2 * tiling.domain.wrap(a, s, n + 1) for a, (s, n) in enumerate(zip(start, extent, strict=True))
    )
    colors = tiling.tiles.colors

    def grid(slot: int, xs: NDArray[np.int64], ys: NDArray[np.int64], zs: NDArray[np.int64]) -> Colors:
        return np.stack([tiling.hash.grid(colors[slot], _FIRST, xs, ys, int(layer)) for layer in zs])

    north = grid(0, x[:-1] + 1, y, z[:-1] + 1)
    west = grid(3, x, y[:-1] + 1, z[:-1] + 1)
    upper = grid(4, x[:-1] + 1, y[:-1] + 1, z)
    return north[:, :-1], west[:, :, 1:], north[:, 1:], west[:, :, :-1], upper[:-1], upper[1:]


def two_hashes(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Complete Wang sets from sums of two corner colorings (Lagae 2007, section 3.3.2.1)."""
    axes = [tiling.domain.wrap(a, s, n + 1) for a, (s, n) in enumerate(zip(start, extent, strict=True))]
    c_h, c_v = tiling.tiles.colors[:2]
    h, v = tiling.hash.grid(c_h, _FIRST, axes[0], axes[1]), tiling.hash.grid(c_v, _SECOND, axes[0], axes[1])
    horizontal = (h[:, :-1] + h[:, 1:]) % c_h
    vertical = (v[:-1] + v[1:]) % c_v
    return horizontal[:-1], vertical[:, 1:], horizontal[1:], vertical[:, :-1]


def sums(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """The C^3 Wang set from one corner coloring (Lagae 2007, section 3.3.2.2)."""
    axes = [tiling.domain.wrap(a, s, n + 1) for a, (s, n) in enumerate(zip(start, extent, strict=True))]
    count = tiling.tiles.colors[0]
    c = tiling.hash.grid(count, _FIRST, axes[0], axes[1])
    horizontal, vertical = (c[:, :-1] + c[:, 1:]) % count, (c[:-1] + c[1:]) % count
    return horizontal[:-1], vertical[:, 1:], horizontal[1:], vertical[:, :-1]


def bits(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """`shifted_wang_tiles`: an edge's color is the bits of the m tiles before it, C = 2^m."""
    (x, y), (w, h) = start, extent
    m = tiling.tiles.colors[0].bit_length() - 1
    beta = tiling.hash.grid(
        2, _BITS, tiling.domain.wrap(0, x - m, w + m), tiling.domain.wrap(1, y - m, h + m)
    )
    north = _history(beta[:, m:], m, h)
    west = _history(beta[m:].T, m, w).T
    return north[:-1], west[:, 1:], north[1:], west[:, :-1]


def _history(beta: Colors, m: int, count: int) -> Colors:
    """Number made of the m bits before each of ``count + 1`` rows, the latest lowest."""
    total = np.zeros((count + 1, beta.shape[1]), np.uint8)
    for back in range(1, m + 1):
        total += beta[m - back : m - back + count + 1] << np.uint8(back - 1)
    return total


def ends(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Dominoes: a hash at the integers."""
    x = tiling.domain.wrap(0, start[0], extent[0] + 1)
    c = tiling.hash.grid(tiling.tiles.colors[0], _FIRST, x, np.zeros(1, np.int64))[0]
    return c[1:], c[:-1]


def _chains(
    tiling: DirectTiling,
) -> tuple[Chains, Place]:
    """The chains of a compact corner set, and where (chain, position) a lattice point lies on them."""
    c = tiling.tiles.colors[0]
    px, py = (*tiling.domain.periods, None)[:2]
    if tiling.algorithm == "columns":
        digits = round(len(tiling.tiles) ** 0.5) // c
        return Chains(tiling.hash, c, digits, py), lambda x, y: (x + 0 * y, y + 0 * x)
    if tiling.algorithm == "space-diagonals":
        if any(tiling.domain.periods):
            raise TilewrightValueError("periods are not offered for compact corner cubes")
        return Chains(tiling.hash, c, 2), lambda x, y: (x, y)
    digits = len(tiling.tiles) // c**3
    if px is None and py is None:
        return Chains(tiling.hash, c, digits), lambda x, y: (x - y, y + 0 * x)
    if py is None:
        return Chains(tiling.hash, c, digits), lambda x, y: ((x - y) % px, y + 0 * x)
    if px is None:
        return Chains(tiling.hash, c, digits), lambda x, y: ((x - y) % py, x + 0 * y)
    # On a torus the diagonals close after lcm(px, py) steps; there are gcd(px, py) of them.
    g = gcd(px, py)
    inverse = pow(py // g, -1, px // g)

    def place(x: NDArray[np.int64], y: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        chain = (x - y) % g
        turns = ((x - chain - y) // g) % (px // g) * inverse % (px // g)
        return chain, y + py * turns

    return Chains(tiling.hash, c, digits, px * py // g), place


def diagonals(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Compact corner sets: every north-west to south-east diagonal is a chain."""
    chains, place = _chains(tiling)
    # Where only one axis repeats, positions run along the other, unwrapped.
    x, y = (
        _unwrapped_or_wrapped(tiling, a, s, n + 1) for a, (s, n) in enumerate(zip(start, extent, strict=True))
    )
    return _corners_to_slots(chains.color(*place(x[np.newaxis, :], y[:, np.newaxis])))


def _unwrapped_or_wrapped(tiling: DirectTiling, axis: int, first: int, count: int) -> NDArray[np.int64]:
    if all(tiling.domain.periods) or tiling.algorithm == "columns":
        return tiling.domain.wrap(axis, first, count)
    return np.arange(first, first + count, dtype=np.int64)


def space_diagonals(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Compact corner cubes: every diagonal along (1, 1, 1) is a chain, numbered by two differences."""
    chains, _ = _chains(tiling)
    x, y, z = (np.arange(s, s + n + 1, dtype=np.int64) for s, n in zip(start, extent, strict=True))
    # One number for both differences, mixed so that chains do not collide in a window.
    a, b = x[None, None, :] - z[:, None, None], y[None, :, None] - z[:, None, None]
    words = tiling.hash.words(6, a, b).astype(np.int64)
    chain = words * 2**30 + tiling.hash.words(7, a, b)
    return _corners_to_slots(chains.color(chain, z[:, None, None] + 0 * chain))


def marked_edges(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Corner-coded complete Wang sets: edges and marks are hashed apart."""
    return edges(tiling, start, extent) + corners(tiling, start, extent)


def marked_sums(tiling: DirectTiling, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
    """Corner-coded C^3 Wang sets, Cohen's 128 tiles among them."""
    return sums(tiling, start, extent) + corners(tiling, start, extent)


ALGORITHMS: dict[str, Callable[[DirectTiling, tuple[int, ...], tuple[int, ...]], Slots]] = {
    "corners": corners,
    "edges": edges,
    "two-hashes": two_hashes,
    "sums": sums,
    "bits": bits,
    "ends": ends,
    "diagonals": diagonals,
    "columns": diagonals,
    "space-diagonals": space_diagonals,
    "marked-edges": marked_edges,
    "marked-sums": marked_sums,
}
