"""Packings by search: all of them for sets of few tiles, one of very many for larger sets.

Lagae & Dutré look for packings by backtracking (Lagae 2007, section 5.5.3). So does this search, with
their two suggestions: it sets the colors of corners and edges one by one, not tiles ("pegs"), and of
packings that are translations of each other it finds one, the one with tile 0 at cell (0, 0).
"""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, check_progress, check_type
from tilewright.errors import Progress, TilewrightValueError
from tilewright.showing import describe
from tilewright.tiles import CORNER, WANG, TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tilings.tiling import ArrayTiling, Tiling

Cells = NDArray[np.int32]

_STRETCH = 2_000_000
"""Trials between two looks at the callback: about a tenth of a second."""
_BLOCK = 4096
"""Solutions fetched at once."""
_MOST_COUNTED = 16
"""Tiles of the largest set whose packings are counted."""
_MOST_FOUND = 3
"""Colors up to which a packing is found in seconds."""
_PATIENCE = 30_000_000
"""Trials after which another order of the colors is better."""
_SEEDS = 2**63 - 1


class PackingSearch:
    """A search through the packings of a complete set, stopped and resumed at will.

    Parameters
    ----------
    tiles : TileSet
        A complete set of corner tiles, or of Wang tiles with C_h and C_v colors. Packings are tori of
        C^2 x C^2 and C_v^2 x C_h^2 cells.
    seed : int, optional
        The order in which colors are tried, 0 to 2^63 - 1; default 0. Every seed leads to the same packings,
        but to others first.
    nest : Tiling, optional
        A packing of the same kind of tiles over one color less. Only packings are found whose north-west
        part it is; by default all are.
    checkpoint : mapping, optional
        What `checkpoint` gave for the same search: it goes on from there.

    Attributes
    ----------
    size : tuple of (int, int)
        Cells of a packing along x and y.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A set of another kind, a nest that is not a packing over one color less, the checkpoint of
        another search, or a seed out of range.

    Notes
    -----
    Lagae 2007, section 5.5.3. Corner tiles over 3 colors take about a second for the first packing, Wang
    tiles a tenth; over 4 colors neither is found in days (for corner tiles see `extend_packing`).
    """

    def __repr__(self) -> str:
        return describe(
            self, repr(self.tiles), f"torus {' x '.join(map(str, self.size))}", f"seed {self.seed}"
        )

    def __init__(
        self,
        tiles: TileSet,
        *,
        seed: int = 0,
        nest: Tiling | None = None,
        checkpoint: Mapping[str, Any] | None = None,
    ) -> None:
        self.tiles = check_kind(tiles)
        self.seed = check_int("seed", seed, 0, _SEEDS)
        self.size = torus_size(tiles)
        """Cells along x and y."""
        self._windows = _number_slots(tiles, self.size)
        radices = np.zeros(self._windows.max() + 1, np.int64)
        radices[self._windows] = tiles.colors
        last = self._windows.max(axis=1)
        self._closing = np.argsort(last, kind="stable")
        self._starts = np.searchsorted(last[self._closing], np.arange(len(radices) + 1))
        self._places = np.array([np.prod(tiles.colors[slot + 1 :]) for slot in range(4)], np.int64)
        self._numbers, self._choices = radices, _shuffled(radices, self.seed)
        self._fix(nest)
        self._tried = np.zeros(len(radices), np.int64)
        self._colors = np.full(len(radices), -1, np.int64)
        self._used = np.zeros(len(tiles), bool)
        self._progress = np.zeros(3, np.int64)
        if checkpoint is not None:
            self._resume(checkpoint)

    def _fix(self, nest: Tiling | None) -> None:
        """Give the colors that are known from the start a single choice."""
        known, slots = self._windows[:1], self.tiles.slots[:1]
        if nest is not None:
            slots = nest_slots(nest, self.tiles)
            height, width = slots.shape[:2]
            known = self._windows.reshape(*reversed(self.size), 4)[:height, :width]
        self._numbers[known] = 1
        self._choices[known, 0] = slots

    @property
    def trials(self) -> int:
        """Number of colors tried so far."""
        return int(self._progress[1])

    @property
    def is_over(self) -> bool:
        """Whether everything was searched."""
        return bool(self._progress[0] < 0)

    @property
    def explored(self) -> float:
        """Part of the search that lies behind, 0 to 1, as if all branches were equally long."""
        if self.is_over:
            return 1.0
        behind = np.maximum(self._tried - 1, 0)
        return float((behind / np.cumprod(self._numbers.astype(float))).sum())

    def find(self, most: int | None = 1, progress: Progress | None = None) -> Cells:
        """Search for the next packings.

        Parameters
        ----------
        most : int, optional
            Number of packings, 1 to 2^31; default 1. None asks for all that are left.
        progress : callable, optional
            Called as ``progress(done, total, what)`` about ten times a second; raise `Cancelled` from it to
            stop. The search can go on.

        Returns
        -------
        int32 array, shape (P, height, width)
            Tile indices; fewer than ``most`` packings, or none, where the search is over.

        Raises
        ------
        TilewrightTypeError
            An argument of a wrong type.
        TilewrightValueError
            ``most`` is out of range.
        """
        wanted = 2**62 if most is None else check_int("most", most, 1, 2**31)
        check_progress(progress)
        blocks = []
        while wanted > 0 and not self.is_over:
            found = self._search(min(wanted, _BLOCK))
            blocks.append(found)
            wanted -= len(found)
            if progress is not None:
                progress(int(self.explored * 1e9), 10**9, "searching for packings")
        width, height = self.size
        return np.concatenate([np.empty((0, height, width), np.int32), *blocks])

    def _search(self, most: int) -> Cells:
        """A stretch of the search, and what it found."""
        from tilewright.kernels.packing_search import search_packings

        found = np.empty((most, len(self._numbers)), np.int64)
        count = search_packings(
            self._windows,
            self._places,
            self._closing,
            self._starts,
            self._choices,
            self._numbers,
            self._tried,
            self._colors,
            self._used,
            self._progress,
            found,
            _STRETCH,
        )
        cells = (found[:count, self._windows] * self._places).sum(axis=-1)
        return cells.reshape(count, *reversed(self.size)).astype(np.int32)

    def __iter__(self) -> Iterator[ArrayTiling]:
        """The packings that are left, as tori."""
        while len(found := self.find()):
            yield ArrayTiling(self.tiles, found[0], torus=True)

    def checkpoint(self) -> dict[str, NDArray[Any]]:
        """Tell where the search stands, so that it can be resumed.

        Returns
        -------
        dict of str to array
            A few small arrays, for ``numpy.savez`` and for ``checkpoint`` of a new search.
        """
        return {name: array.copy() for name, array in (self._order() | self._state()).items()}

    def _order(self) -> dict[str, NDArray[np.int64]]:
        """What makes one search differ from another: what each color may be, in the order it is tried."""
        return {"choices": self._choices, "numbers": self._numbers}

    def _state(self) -> dict[str, NDArray[Any]]:
        return {
            "tried": self._tried,
            "colors": self._colors,
            "used": self._used,
            "progress": self._progress,
        }

    def _resume(self, checkpoint: Mapping[str, Any]) -> None:
        check_type("checkpoint", checkpoint, Mapping, "what checkpoint() gave")
        order, state = self._order(), self._state()
        try:
            given = {name: np.asarray(checkpoint[name]) for name in checkpoint}
        except ValueError:  # rows of several lengths
            given = {}
        same = given.keys() == {*order, *state} and all(
            np.array_equal(given[name], array) for name, array in order.items()
        )
        if not same or any(given[n].shape != a.shape or given[n].dtype != a.dtype for n, a in state.items()):
            raise TilewrightValueError(
                "is of another search",
                argument="checkpoint",
                advice="resume it with the tiles, seed and nest it was made with",
            )
        for name, array in state.items():
            array[...] = given[name]


def count_packings(tiles: TileSet, progress: Progress | None = None) -> int:
    """Count the packings of a complete set, translations counted.

    Every tile lies once in a packing, so the packings with tile 0 at cell (0, 0) are counted and multiplied
    by the number of cells. Corner tiles over 2 colors have 32, Wang tiles 203,520.

    Parameters
    ----------
    tiles : TileSet
        A complete set of corner tiles or Wang tiles, 16 tiles at most.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    int
        The number of packings.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The set is of another kind, or has more than 16 tiles: counting would not end.

    Notes
    -----
    Lagae 2007, section 5.5.3.
    """
    if len(check_kind(tiles)) > _MOST_COUNTED:
        raise TilewrightValueError(
            f"the set has {len(tiles)} tiles; packings are counted for up to {_MOST_COUNTED}, such as those "
            "of 2 colors: with more the count would not end in a lifetime"
        )
    return len(PackingSearch(tiles).find(None, progress)) * len(tiles)


def random_packing(
    tiles: TileSet, *, seed: int = 0, nest: Tiling | None = None, progress: Progress | None = None
) -> ArrayTiling:
    """Find a packing by search, as a torus; other seeds give others.

    It is irregular, so better for a puzzle than `packing`. Some orders of the colors lead to long searches,
    so that one which takes long is begun anew in another order. See `PackingSearch`, which can be stopped and
    resumed.

    Parameters
    ----------
    tiles : TileSet
        A complete set of corner tiles or Wang tiles over up to 3 colors, which take seconds at most.
    seed : int, optional
        Where chance begins, 0 to 2^63 - 1; default 0.
    nest : Tiling, optional
        A packing over one color less that is to be the north-west part; by default any part will do.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Returns
    -------
    ArrayTiling
        A torus of C_v^2 x C_h^2 cells.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        Another kind of set, more than 3 colors, a nest that no packing holds, or a seed out of range.

    Notes
    -----
    Lagae 2007, section 5.5.3.
    """
    if max(check_kind(tiles).colors) > _MOST_FOUND:
        raise TilewrightValueError(
            f"the set has {max(tiles.colors)} colors; packings are found by search for up to {_MOST_FOUND}. "
            "Use packing() or recursive_packing()"
        )
    check_progress(progress)
    orders = np.random.default_rng(check_int("seed", seed, 0, _SEEDS))
    while True:
        search = PackingSearch(tiles, seed=int(orders.integers(_SEEDS)), nest=nest)
        while not search.is_over and search.trials < _PATIENCE:
            found = search._search(1)
            if len(found):
                return ArrayTiling(tiles, found[0], torus=True)
            if progress is not None:
                progress(int(search.explored * 1e9), 10**9, "searching for a packing")
        if search.is_over:
            raise TilewrightValueError("is in the corner of no packing over one color more", argument="nest")


def hold_every_tile(tiles: TileSet, cells: NDArray[Any]) -> NDArray[np.bool_]:
    """Which of several arrays of tiles, (packings, height, width), hold each tile once."""
    ordered: NDArray[Any] = np.sort(cells.reshape(len(cells), -1), axis=1)
    return np.asarray((ordered == np.arange(len(tiles))).all(axis=1))


def nest_slots(nest: Tiling, tiles: TileSet, name: str = "nest") -> NDArray[np.uint8]:
    """Colors of the cells of a packing that is to lie in one of ``tiles``, shape (height, width, 4)."""
    check_type(name, nest, Tiling, "a packing")
    small = nest.tiles
    fits = small.shape is tiles.shape and small.colors == tuple(c - 1 for c in tiles.colors)
    if fits and small.is_complete and nest.domain.periods == torus_size(small):
        cells = nest.indices(0, 0, *torus_size(small))
        if hold_every_tile(small, cells[None]).all():
            return small.slots_of(cells)
    raise TilewrightValueError(
        f"must be a packing of {tiles.shape.name} tiles over {tuple(c - 1 for c in tiles.colors)} "
        "colors, one less than the tiles it is to lie in have",
        argument=name,
        advice="packing() makes such",
    )


def check_kind(tiles: TileSet) -> TileSet:
    """A complete set of corner tiles or Wang tiles."""
    if not check_tiles("tiles", tiles).is_complete or tiles.shape not in (CORNER, WANG):
        raise TilewrightValueError(
            f"packings are searched for complete sets of corner tiles and Wang tiles, "
            f"not for the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles"
        )
    return tiles


def torus_size(tiles: TileSet) -> tuple[int, int]:
    """Cells along x and y: C^2 x C^2; C_v^2 x C_h^2 for Wang tiles."""
    return tiles.colors[3] ** 2, tiles.colors[0] ** 2


def _number_slots(tiles: TileSet, size: tuple[int, int]) -> NDArray[np.int64]:
    """Number of the corner or edge at each slot of each cell, shape (cells, 4), row by row.

    Numbered in the order of the search: so that every new color ends as many tiles as it can.
    """
    width, height = size
    y, x = np.divmod(np.arange(width * height), width)
    east, south = (x + 1) % width, (y + 1) % height
    if tiles.shape is CORNER:
        points = np.stack([y * width + east, south * width + east, south * width + x, y * width + x], axis=1)
        order = [3, 0, 2, 1]
    else:
        points = 2 * np.stack([y * width + x, y * width + east, south * width + x, y * width + x], axis=1)
        points += [0, 1, 0, 1]
        order = [0, 3, 1, 2]
    _, first, names = np.unique(points[:, order], return_index=True, return_inverse=True)
    numbered = np.argsort(np.argsort(first))[names.reshape(-1, 4)]
    return np.ascontiguousarray(numbered[:, np.argsort(order)])


def _shuffled(radices: NDArray[np.int64], seed: int) -> NDArray[np.int64]:
    """The colors of each slot in the order in which they are tried."""
    rng = np.random.default_rng(seed)
    choices = np.zeros((len(radices), radices.max()), np.int64)
    for row, radix in zip(choices, radices, strict=True):
        row[:radix] = rng.permutation(radix)
    return choices
