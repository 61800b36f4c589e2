"""Packings up to symmetry: translations, mirrors, turns and other names of the colors."""

from collections.abc import Iterator
from itertools import permutations, product
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers
from tilewright.errors import TilewrightValueError
from tilewright.tiles import CORNER, TileSet, encode
from tilewright.tilings.packings.search import Cells, check_kind, hold_every_tile, torus_size


def classify_packings(tiles: TileSet, packings: ArrayLike) -> tuple[Cells, NDArray[np.int64]]:
    """Sort packings into classes up to symmetry.

    The symmetries are translation, reflection, rotation and permutation of the colors. The colors of the
    horizontal and vertical edges of Wang tiles are permuted separately; rotations by a quarter need equally
    many of both.

    Parameters
    ----------
    tiles : TileSet
        A complete set of corner tiles or Wang tiles.
    packings : array-like of int, shape (P, height, width)
        Tile indices of each packing.

    Returns
    -------
    classes : int32 array, shape (K, height, width)
        One packing of each class, with tile 0 at cell (0, 0), the first of its class in the order of its
        tiles.
    members : int64 array, shape (P,)
        The class of each packing.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The set is of another kind, or an array has another shape or does not hold every tile once.

    Notes
    -----
    Lagae 2007, section 5.5.3.
    """
    cells = as_integers("packings", packings)
    width, height = torus_size(check_kind(tiles))
    if cells.shape[1:] != (height, width) or not hold_every_tile(tiles, cells).all():
        raise TilewrightValueError(
            f"must have shape (packings, {height}, {width}) and hold each of {len(tiles)} tiles once",
            argument="packings",
            allowed=f"shape (packings, {height}, {width}) and hold each of {len(tiles)} tiles once",
        )
    first = np.full(cells.shape, len(tiles), np.int64)
    for image in _images(tiles, cells):
        differs = (image != first).reshape(len(cells), -1)
        at = differs.argmax(axis=1)[:, None]
        now, before = (np.take_along_axis(a.reshape(len(cells), -1), at, 1)[:, 0] for a in (image, first))
        first[now < before] = image[now < before]
    classes, members = np.unique(first, axis=0, return_inverse=True)
    return classes.astype(np.int32), members.reshape(-1)


def _images(tiles: TileSet, cells: NDArray[Any]) -> Iterator[NDArray[np.int64]]:
    """Packings under every symmetry, moved so that tile 0 is at cell (0, 0)."""
    palettes = ((0, 1, 2, 3),) if tiles.shape is CORNER else ((0, 2), (1, 3))
    orders = [list(permutations(range(tiles.colors[slots[0]]))) for slots in palettes]
    diagonal = ("", "diagonal") if len(set(tiles.colors)) == 1 else ("",)
    for moves in product(("", "EW"), ("", "NS"), diagonal):
        turned, slots = cells, tiles.slots
        for move in filter(None, moves):
            turned, slots = _mirrored(turned, move), slots[:, _mirrored_slots(tiles.shape.slots, move)]
        for order in product(*orders):
            recolored = slots.copy()
            for places, colors in zip(palettes, order, strict=True):
                recolored[:, places] = np.array(colors, np.uint8)[slots[:, places]]
            yield _anchored(encode(recolored, tiles.colors)[turned])


def _mirrored(cells: NDArray[Any], move: str) -> NDArray[Any]:
    """Tilings with east and west, north and south, or x and y exchanged."""
    if move == "diagonal":
        return cells.swapaxes(-1, -2)
    return cells[..., ::-1] if move == "EW" else cells[..., ::-1, :]


def _mirrored_slots(names: tuple[str, ...], move: str) -> list[int]:
    """Which slot comes to lie at each slot when tiles are mirrored."""
    exchange = str.maketrans(*{"EW": ("EW", "WE"), "NS": ("NS", "SN"), "diagonal": ("NESW", "WSEN")}[move])
    return [[set(n) for n in names].index(set(name.translate(exchange))) for name in names]


def _anchored(cells: NDArray[np.int64]) -> NDArray[np.int64]:
    """Each torus moved so that tile 0 is at cell (0, 0)."""
    _, height, width = cells.shape
    row, column = np.divmod(cells.reshape(len(cells), -1).argmin(axis=1)[:, None], width)
    rows, columns = (row + np.arange(height)) % height, (column + np.arange(width)) % width
    return cells[np.arange(len(cells))[:, None, None], rows[:, :, None], columns[:, None, :]]
