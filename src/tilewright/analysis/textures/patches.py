"""Which patch shows where on a piece of the plane, by the names that `pick` and `reject` take."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, label

from tilewright.analysis.textures.sample import Sample
from tilewright.signals.textures import TextureTiles

SMALLEST = 0.015
"""Share of a tile below which a piece of a patch has no room for a name."""
SHARPEST = 512
"""Pixels along the side of what is searched for pieces: enough to place a name."""


class NamedPiece(NamedTuple):
    """A piece of the plane that shows one patch.

    Attributes
    ----------
    name : str
        The patch, as in the material's recipe.
    y, x : float
        A pixel well inside.
    """

    name: str
    y: float
    x: float


def named_pieces(sample: Sample, cells: int) -> list[NamedPiece]:
    """The patches that the first cells of a sample show, all but the smallest pieces.

    Empty where the recipe does not tell the places of patches.
    """
    rows = sample.cells[:cells, :cells]
    places = _places(sample.material)
    known = {row: _names_in(sample.material, places, int(row)) for row in np.unique(rows)}
    names = sorted({name for _, found in known.values() for name in found})
    numbers = {
        row: np.array([names.index(n) + 1 for n in found] + [0])[patch]
        for row, (patch, found) in known.items()
    }
    step = max(1, cells * sample.size // SHARPEST)
    shown = np.block([[numbers[row] for row in line] for line in rows])[::step, ::step]
    pieces = []
    for number, name in enumerate(names, start=1):
        parts, count = label(shown == number)
        for part in range(1, count + 1):
            inside = parts == part
            if inside.sum() < SMALLEST * (sample.size / step) ** 2:
                continue
            depth = distance_transform_edt(np.pad(inside, 1))[1:-1, 1:-1]
            y, x = np.unravel_index(depth.argmax(), depth.shape)
            pieces.append(NamedPiece(name, float(y * step), float(x * step)))
    return pieces


Places = dict[tuple[int, ...], list[str]]


def _names_in(material: TextureTiles, places: Places, row: int) -> tuple[NDArray[np.int64], list[str]]:
    """For each pixel of a picture the patch it shows, an index of the names beside it; -1 where unknown.

    A patch shows the photograph moved by one amount, and lies half a tile or a whole one off where its canvas
    is that of an edge or a corner.
    """
    size = material.tile_size
    source, y, x = np.moveaxis(material.origins[row].astype(np.int64), -1, 0)
    moved = np.stack([source, y - np.arange(size)[:, np.newaxis], x - np.arange(size)], axis=-1)
    keys = moved @ (1 << 40, 1 << 20, 1)
    _, first, which = np.unique(keys, return_index=True, return_inverse=True)
    moves = moved.reshape(-1, 3)[first]
    tile = int(material.variants.tiles[row])
    variant = row - int(material.variants.starts[tile])
    own = f"center:{tile}:{variant}" if variant else f"center:{tile}"
    found = [_choose(places.get(tuple(int(v) for v in move), []), own) for move in moves]
    names = sorted({name for name in found if name})
    index = np.array([names.index(name) if name else -1 for name in found])
    return index[which.reshape(size, size)], names


def _places(material: TextureTiles) -> Places:
    """The names of the patches that show the photograph moved so."""
    size = material.tile_size
    places: Places = {}
    for name, (source, y, x) in material.recipe.get("patches", {}).items():
        for dy in range(-size, size + 1, size // 2):
            for dx in range(-size, size + 1, size // 2):
                places.setdefault((source, y + dy, x + dx), []).append(name)
    return places


def _choose(names: list[str], own: str) -> str:
    """The tile's own patch, or else one that is shared by several tiles."""
    return own if own in names else next((name for name in names if not name.startswith("center")), "")
