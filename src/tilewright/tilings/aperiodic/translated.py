"""Tilings by corner sets made from Wang sets: the constructions of Lagae 2007, section 8.3, of whole tilings.

Every one of them colors the corners' lattice by what the Wang tiling has there. So a tiling of the endless
plane becomes another, and any window of it is as near as before.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_choice, check_type
from tilewright.errors import TilewrightValueError
from tilewright.tiles import TileSet, as_wang_tiles
from tilewright.tiles.translations import CONSTRUCTIONS, as_corner_tiles
from tilewright.tilings.algorithms import Slots, corner_slots
from tilewright.tilings.direct_tiling import SlotTiling
from tilewright.tilings.domain import Domain
from tilewright.tilings.tiling import Tiling

Integers = NDArray[np.int64]
_BLOCK, _TURNED_BLOCK = 4096, 512
"""Lattice points along the sides of what is laid at once; less of a long window turned by 45 degrees."""


class TranslatedTiling(SlotTiling):
    """A corner tiling made from a Wang tiling of the endless plane; see `translated_tiling`.

    Parameters
    ----------
    tiles : TileSet
        Corner tiles, as the construction makes them.
    wang : Tiling
        The Wang tiling, of the endless plane or periodic.
    construction : str
        ``"diagonal"``, ``"horizontal"``, ``"vertical"``, ``"rotation"`` or ``"subdivision"``.
    names : array-like of int, shape (C,), optional
        What each color of the construction is in ``tiles``, where colors have become one or changed names; by
        default the same.
    mirrored : bool, optional
        Whether east and west are exchanged; default False.

    Notes
    -----
    Lagae 2007, section 8.3.
    """

    def __init__(
        self,
        tiles: TileSet,
        wang: Tiling,
        construction: str,
        names: ArrayLike | None = None,
        *,
        mirrored: bool = False,
    ) -> None:
        super().__init__(tiles, Domain())
        self._wang = wang
        self._construction = construction
        self._colors = _colors(wang.tiles, construction)
        if names is not None:
            self._colors = np.asarray(names)[self._colors]
        self._mirrored = mirrored

    def slots(self, start: tuple[int, ...], extent: tuple[int, ...]) -> Slots:
        """Give the colors of every slot of a window of tiles, one array like the window for each slot."""
        x, y = (s + np.arange(n + 1) for s, n in zip(start, extent, strict=True))
        points = np.empty((len(y), len(x)), self.tiles.slots.dtype)
        block = _TURNED_BLOCK if self._construction == "rotation" else _BLOCK
        for top in range(0, len(y), block):
            for left in range(0, len(x), block):
                rows, columns = slice(top, top + block), slice(left, left + block)
                points[rows, columns] = self._color(-x[columns] if self._mirrored else x[columns], y[rows])
        return corner_slots(points)

    def _color(self, x: Integers, y: Integers) -> NDArray[np.int64]:
        """Colors of the lattice points in columns x and rows y."""
        kind, i, j = _cells(self._construction, x[np.newaxis, :], y[:, np.newaxis])
        west, north = int(i.min()), int(j.min())
        tiles = np.empty((int(j.max()) - north + 1, int(i.max()) - west + 1), np.int32)
        self._wang._fill((west, north), tiles)
        return self._colors[kind, tiles[j - north, i - west]]


def _cells(construction: str, x: Integers, y: Integers) -> tuple[Integers, Integers, Integers]:
    """What of which Wang tile each corner lies on: the row of `_colors`, and the cell."""
    if construction == "rotation":
        # White tiles are those with x + y even: their corner NW is the middle of a W edge.
        kind = (x + y) % 2
        return kind, (x + y - kind) >> 1, (y - x + kind) >> 1
    if construction == "subdivision":
        return 2 * (y % 2) + x % 2, x >> 1, y >> 1
    return np.int64(0), x, y  # type: ignore[return-value]


def _colors(wang: TileSet, construction: str) -> Integers:
    """For everything of a Wang tile that can lie at a corner its color by tile, shape (kinds, T)."""
    n, _, _, w = wang.slots.astype(np.int64).T
    if construction == "diagonal":
        return np.arange(len(wang))[np.newaxis]
    if construction in ("horizontal", "vertical"):
        return (n if construction == "horizontal" else w)[np.newaxis]
    if construction == "rotation":
        level, upright = np.unique(wang.slots[:, [0, 2]]), np.unique(wang.slots[:, [1, 3]])
        return np.stack([len(level) + np.searchsorted(upright, w), np.searchsorted(level, n)])
    edges = max(wang.colors)
    star, center = np.full(len(wang), edges + len(wang)), edges + np.arange(len(wang))
    return np.stack([star, n, w, center])


class _WangTiling(Tiling):
    """A corner tiling with the tiles of the equivalent Wang set, which have the same numbers."""

    def __init__(self, corners: Tiling) -> None:
        self.tiles = as_wang_tiles(corners.tiles)
        self.domain = corners.domain
        self._corners = corners

    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        self._corners._fill(start, out)


def translated_tiling(tiling: Tiling, construction: str) -> Tiling:
    """Make a tiling by the set that a construction makes from another set, from a tiling by that other one.

    Parameters
    ----------
    tiling : Tiling
        By Wang tiles, of the endless plane or periodic; or, for ``"wang"``, by corner tiles.
    construction : str
        ``"diagonal"``, ``"horizontal"``, ``"vertical"``, ``"rotation"``, ``"subdivision"`` (see
        `as_corner_tiles`); ``"wang"`` is the way back (`as_wang_tiles`). They can follow one another.

    Returns
    -------
    Tiling
        Of the endless plane. Around the cell (0, 0) it shows what ``tiling`` shows around (0, 0), turned by
        45 degrees for ``"rotation"``, twice as large for ``"subdivision"``.

    Raises
    ------
    TilewrightTypeError
        Something that is not a tiling.
    TilewrightValueError
        There is no such construction, it fails for the set, or the tiling is of a rectangle.

    Notes
    -----
    Lagae 2007, section 8.3, and 8.4 for the way back; the thesis translates sets, not tilings.
    """
    check_type("tiling", tiling, Tiling, "a Tiling")
    check_choice("construction", construction, (*CONSTRUCTIONS, "wang"))
    if construction == "wang":
        return _WangTiling(tiling)
    tiles = as_corner_tiles(tiling.tiles, construction)
    if tiling.domain.kind == "rectangle":
        raise TilewrightValueError(
            "is of a rectangle; a translated tiling needs one of the whole plane", argument="tiling"
        )
    return TranslatedTiling(tiles, tiling, construction)
