"""Tile packings: every tile of a complete set once, on a torus, neighbors matching.

A packing of corner tiles is a de Bruijn torus with windows of 2 x 2: C^2 x C^2 colors in which every
window occurs once. It is evaluated in closed form both ways, from place to tile and from tile to place;
``docs/packing.md`` has the construction and its proof.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.tiles import (
    CORNER,
    CORNER_CODED,
    CORNER_CUBE,
    DOMINO,
    WANG,
    WANG_CUBE,
    Shape,
    TileSet,
    encode,
)
from tilewright.tiles.tileset import check_tiles, slot_type
from tilewright.tilings.algorithms import Slots, corner_slots
from tilewright.tilings.direct_tiling import SlotTiling
from tilewright.tilings.domain import Domain, fold
from tilewright.tilings.hashes import as_grid

Integers = NDArray[np.int64]

# Colors of the packing over two colors, the only one up to symmetry.
_BASE = np.array([[0, 0, 0, 1], [0, 0, 1, 0], [1, 0, 1, 1], [0, 1, 1, 1]])
_BASE_PLACE = np.zeros((16, 2), np.int64)
for _y in range(4):
    for _x in range(4):
        _window = (_BASE[_y, _x], _BASE[_y, _x - 3], _BASE[_y - 3, _x], _BASE[_y - 3, _x - 3])
        _BASE_PLACE[encode(_window, (2,) * 4)] = _y, _x


class Packing(SlotTiling):
    """A packing of a complete set; made by `packing`.

    As a tiling it is a torus of C^2 x C^2 cells for corner tiles, C_v^2 x C_h^2 for Wang tiles, C^2 for
    dominoes, C^2 x C^2 x C^4 for corner cubes and C^2 x C^2 x C^2 for Wang cubes.

    Parameters
    ----------
    tiles : TileSet
        The complete set.

    Attributes
    ----------
    size : tuple of int
        Cells along x, y (and z).

    Notes
    -----
    Lagae 2007, section 5.5; ``docs/packing.md`` has the construction of corner packings and its proof.
    """

    def __init__(self, tiles: TileSet) -> None:
        c = tiles.colors
        size = {
            DOMINO: (c[0] ** 2,),
            WANG: (c[-1] ** 2, c[0] ** 2),
            CORNER: (c[0] ** 2,) * 2,
            CORNER_CUBE: (c[0] ** 2, c[0] ** 2, c[0] ** 4),
            WANG_CUBE: (c[0] ** 2,) * 3,
        }[tiles.shape]
        super().__init__(tiles, Domain(size, (None,) * len(size)))
        self.size: tuple[int, ...] = size
        """Cells along x, y (and z)."""
        colors: dict[Shape, Callable[..., Integers]] = {CORNER: torus_color, CORNER_CUBE: cube_color}
        self._color = colors.get(tiles.shape)

    def slots(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
        """Give the colors of every slot of a window of tiles, one array like the window for each slot."""
        if self._color is None:
            cells = as_grid(tuple(fold(*span) for span in zip(start, extent, self.size, strict=True)))
            return tuple(slot.astype(slot_type(self.tiles.colors)) for slot in self._edges(cells))
        ends = (fold(s, n + 1, p) for s, n, p in zip(start, extent, self.size, strict=True))
        colors = self._color(*as_grid(tuple(ends)), self.tiles.colors[0])
        return corner_slots(colors.astype(slot_type(self.tiles.colors)))

    def tile(self, *cell: ArrayLike) -> Integers:
        """Give the tiles of cells.

        Parameters
        ----------
        *cell : array-like of int
            Coordinates x (, y, z) of any cells of the endless torus; they are broadcast.

        Returns
        -------
        int64 array, shape of the coordinates
            Tile indices.

        Raises
        ------
        TilewrightTypeError
            Another number of coordinates than the torus has axes, or something that is not an integer.
        """
        if len(cell) != len(self.size):
            raise TilewrightTypeError(f"tile() takes {len(self.size)} coordinates, not {len(cell)}")
        given = zip("xyz", cell, self.size, strict=False)
        at = [as_integers(name, v).astype(np.int64) % n for name, v, n in given]
        if self._color is None:
            slots = self._edges(tuple(at))
        else:
            around = (
                [v + (far in name) for v, far in zip(at, "ESD", strict=False)]
                for name in self.tiles.shape.slots
            )
            slots = [self._color(*point, self.tiles.colors[0]) for point in around]
        return encode(np.stack(np.broadcast_arrays(*slots), axis=-1), self.tiles.colors)

    def _edges(self, cells: tuple[Integers, ...]) -> list[Integers]:
        """Colors of the edges (faces): a train along each axis."""
        slots: list[Integers] = [np.zeros(1, np.int64)] * len(self.tiles.colors)
        for at, ((far, near),) in zip(cells, self.tiles.shape.joints, strict=True):
            slots[near] = train(at, self.tiles.colors[near])
            slots[far] = train(at + 1, self.tiles.colors[far])
        return slots

    def place(self, tile: ArrayLike) -> tuple[Integers, ...]:
        """Give the cells of tiles: the inverse of `tile`.

        Parameters
        ----------
        tile : array-like of int, any shape
            Tile indices.

        Returns
        -------
        tuple of int64 array
            Coordinates x (, y, z), arrays of the shape of ``tile``.

        Raises
        ------
        TilewrightTypeError
            The indices are not integers.
        TilewrightValueError
            An index is out of range.
        """
        slots = list(np.moveaxis(self.tiles.slots_of(tile).astype(np.int64), -1, 0))
        if self._color is None:
            return tuple(
                train_position(slots[near], slots[far]) for ((far, near),) in self.tiles.shape.joints
            )
        if self.tiles.shape is CORNER:
            return torus_place(slots, self.tiles.colors[0])
        return cube_place(slots[:4], slots[4:], self.tiles.colors[0])


def packing(tiles: TileSet) -> Packing:
    """Pack a complete set: every tile once, on a torus, neighbors matching; in closed form.

    Parameters
    ----------
    tiles : TileSet
        A complete set of corner tiles, Wang tiles, dominoes, corner cubes or Wang cubes.

    Returns
    -------
    Packing
        A torus, which tells the tile of a cell and the cell of a tile.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tile set.
    TilewrightValueError
        The set is not complete, or its tiles are corner-coded.

    Notes
    -----
    The packing of Wang tiles and cubes is the outer product of Wei's Eulerian trains (Lagae 2007, sections
    5.5.1 and 5.5.2); its north-west part is the packing over one color less. The corner packing solves for
    every number of colors what Lagae 2007, section 5.5.3, and Lagae & Dutré 2006, section 6.2, search for.

    Examples
    --------
    >>> import tilewright as tw
    >>> packed = tw.packing(tw.corner_tiles(3))
    >>> packed.size
    (9, 9)
    >>> [int(n) for n in packed.place(packed.tile(4, 7))]
    [4, 7]
    """
    if not check_tiles("tiles", tiles).is_complete or tiles.shape is CORNER_CODED:
        raise TilewrightValueError(
            f"packings are for complete sets of corner tiles, Wang tiles, dominoes and cubes, "
            f"not for the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles"
        )
    return Packing(tiles)


def train(position: ArrayLike, colors: int) -> Integers:
    """Color at positions of Wei's Eulerian train of length C^2: every ordered pair of colors once.

    The pairs whose larger color is k fill positions k^2 to (k + 1)^2: 0 k 1 k ... k k.
    """
    t = np.asarray(position, np.int64) % colors**2
    k = np.sqrt(t).astype(np.int64)
    rest = t - k * k
    return np.where((rest % 2 == 0) & (rest < 2 * k), rest // 2, k)


def train_position(first: ArrayLike, second: ArrayLike) -> Integers:
    """Where a pair of colors occurs in Wei's train (Wei 2004, as in Lagae 2007, section 5.5.1)."""
    a, b = np.asarray(first, np.int64), np.asarray(second, np.int64)
    return np.select(
        [b > a, (a == b) & (a > 0), (a > b) & (b > 0), a > b],
        [b * b + 2 * a, (a + 1) ** 2 - 2, a * a + 2 * b - 1, (a + 1) ** 2 - 1],
        0,
    )


def torus_color(x: ArrayLike, y: ArrayLike, colors: int) -> Integers:
    """Color of the corner packing at lattice points."""
    n = colors**2
    j, i = np.asarray(x, np.int64) % n, np.asarray(y, np.int64) % n
    if colors % 2:
        # Column j is the train moved by 0 + 1 + ... + (j - 1): neighbors differ by every shift once.
        return train(i + j * (j - 1) // 2, colors)
    q = colors // 2
    return q * _BASE[i % 4, j % 4] + _residue_train(i + _shift(j), q)


def torus_place(corners: list[Integers], colors: int) -> tuple[Integers, Integers]:
    """Cell (x, y) of the corner packing whose corners NE, SE, SW, NW have the given colors."""
    ne, se, sw, nw = corners
    n = colors**2
    if colors % 2:
        here, next_ = train_position(nw, sw), train_position(ne, se)
        j = (next_ - here) % n
        return j, (here - j * (j - 1) // 2) % n
    q = colors // 2
    y, x = np.moveaxis(_BASE_PLACE[encode(np.stack([v // q for v in (nw, ne, sw, se)], -1), (2,) * 4)], -1, 0)
    here = _residue_position(y, nw % q, sw % q, q)
    next_ = _residue_position(y, ne % q, se % q, q)
    j = 4 * (((next_ - here) % n) // 4) + x
    return j, (here - _shift(j)) % n


def _shift(j: Integers) -> Integers:
    """How far column j of an even packing is moved: neighbors differ by 4 floor(j / 4)."""
    k, c = j // 4, j % 4
    return 4 * (2 * k * (k - 1) + c * k)


def _residue_train(position: Integers, q: int) -> Integers:
    """A sequence of q colors, length 4 q^2, whose pairs at each residue modulo 4 are all different."""
    t = position % (4 * q * q)
    k = t // 4
    return np.where(t % 2 == 0, k // q, k % q)


def _residue_position(residue: Integers, first: Integers, second: Integers, q: int) -> Integers:
    """Where a pair occurs in that sequence, among positions of one residue modulo 4."""
    before = np.where(first < q - 1, second, (second - 1) % q)
    k = np.where(
        residue == 1, q * second + first, np.where(residue == 3, q * before + first, q * first + second)
    )
    return 4 * k + residue


def _layer_shift(layer: Integers, n: int) -> tuple[Integers, Integers]:
    """How far layer l of the cube packing is moved along x and y: layer m + 1 by (m mod n, m div n) more."""
    q, r = layer // n, layer % n
    return (q * (n * (n - 1) // 2) + r * (r - 1) // 2) % n, (n * (q * (q - 1) // 2) + q * r) % n


def cube_color(x: ArrayLike, y: ArrayLike, z: ArrayLike, colors: int) -> Integers:
    """Color of the corner cube packing at lattice points: layers of the corner packing, moved apart."""
    n = colors**2
    dx, dy = _layer_shift(np.asarray(z, np.int64) % (n * n), n)
    return torus_color(np.asarray(x, np.int64) + dx, np.asarray(y, np.int64) + dy, colors)


def cube_place(
    upper: list[Integers], lower: list[Integers], colors: int
) -> tuple[Integers, Integers, Integers]:
    """Cell (x, y, z) of the cube whose upper and lower faces have the given corners NE, SE, SW, NW."""
    n = colors**2
    (ux, uy), (lx, ly) = torus_place(upper, colors), torus_place(lower, colors)
    layer = ((ly - uy) % n) * n + (lx - ux) % n
    dx, dy = _layer_shift(layer, n)
    return (ux - dx) % n, (uy - dy) % n, layer
